//! OBJ, Wavefront's text format: positions (`v`) and faces (`f`, or `fo` of old), nothing else.
//!
//! This reader is our own. Of the kept crates, `obj` has binary32 positions, `wavefront_obj` triangulates, and `tobj`
//! renumbers: it drops vertices that no face uses and splits shared ones where a new object or group begins, so that a
//! closed mesh gets a boundary that its file does not have. Here vertex i of the record is the i-th `v` of the file.

use super::{FlatMesh, MeshRecord, Precision, Problem, excerpt};
use std::io::{BufRead, Write};

/// Reads positions as the nearest binary64 and faces as they are, polygons included.
///
/// An index may be relative (negative); a positive one is kept even where there is no such vertex. Normals, texture
/// coordinates, colours, lines, points, groups and materials are passed over.
///
/// Errors, each naming its line: a number that is none; fewer than three coordinates; a weight w ≠ 1; an index that is
/// 0, reaches back before the first vertex, or is above 2³²; a free-form curve or surface.
pub fn read(reader: impl BufRead) -> Result<MeshRecord, Problem> {
    read_flat(reader).map(MeshRecord::from)
}

/// [`read`] into flat arrays.
pub fn read_flat(mut reader: impl BufRead) -> Result<FlatMesh, Problem> {
    let mut mesh = FlatMesh::new(Precision::Binary64);
    let mut text = Vec::new();
    let mut number = 0;
    loop {
        text.clear();
        let mut physical = 0;
        // A backslash at its end continues a line.
        while reader.read_until(b'\n', &mut text)? > 0 {
            physical += 1;
            match text.trim_ascii_end() {
                [kept @ .., b'\\'] => {
                    let length = kept.len();
                    text.truncate(length);
                    text.push(b' ');
                }
                _ => break,
            }
        }
        if physical == 0 {
            return Ok(mesh);
        }
        let line = Line { text: &text, number: number + 1 };
        number += physical;
        let mut words = line.words();
        match words.next() {
            Some(b"v") => mesh.vertices.push(line.position(words)?),
            Some(b"f" | b"fo") => {
                let known = mesh.vertices.len();
                for word in words {
                    mesh.corners.push(line.index(word, known)?);
                }
                mesh.end_face()?;
            }
            Some(b"curv" | b"curv2" | b"surf") => return Err(line.invalid("polygons only, no free-form geometry")),
            _ => {}
        }
    }
}

/// Writes the shortest decimals that read back as the same binary64, and 1-based indices.
pub fn write(mut writer: impl Write, mesh: &MeshRecord) -> Result<(), Problem> {
    for [x, y, z] in &mesh.vertices {
        writeln!(writer, "v {x:?} {y:?} {z:?}")?;
    }
    for face in &mesh.faces {
        write!(writer, "f")?;
        for &index in face {
            write!(writer, " {}", u64::from(index) + 1)?;
        }
        writeln!(writer)?;
    }
    Ok(writer.flush()?)
}

struct Line<'a> {
    text: &'a [u8],
    number: usize,
}

impl<'a> Line<'a> {
    /// The words before a comment.
    fn words(&self) -> impl Iterator<Item = &'a [u8]> + use<'a> {
        let text = self.text.split(|&byte| byte == b'#').next().unwrap_or_default();
        text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
    }

    fn invalid(&self, expected: &'static str) -> Problem {
        Problem::Invalid { field: format!("line {}", self.number), expected, found: excerpt(self.text) }
    }

    /// x y z, then nothing, or the weight 1, or a colour.
    fn position<'b>(&self, words: impl Iterator<Item = &'b [u8]>) -> Result<[f64; 3], Problem> {
        let number = |word| std::str::from_utf8(word).ok()?.parse().ok();
        let not_these = || self.invalid("three coordinates, and perhaps a colour");
        let mut numbers = [0.0; 7];
        let mut count = 0;
        for word in words {
            *numbers.get_mut(count).ok_or_else(not_these)? = number(word).ok_or_else(not_these)?;
            count += 1;
        }
        match numbers[..count] {
            [x, y, z] | [x, y, z, _, _, _] | [x, y, z, _, _, _, _] => Ok([x, y, z]),
            [x, y, z, 1.0] => Ok([x, y, z]),
            [_, _, _, _] => Err(self.invalid("the weight 1")),
            _ => Err(not_these()),
        }
    }

    /// The 0-based index of `17`, `17/4`, `17//5`, `-1/-1/-1`, …
    fn index(&self, word: &[u8], known: usize) -> Result<u32, Problem> {
        let first = word.split(|&byte| byte == b'/').next().unwrap_or_default();
        let stated: Option<i64> = std::str::from_utf8(first).ok().and_then(|text| text.parse().ok());
        let index = match stated {
            Some(1..) => stated.and_then(|index| index.checked_sub(1)),
            Some(..0) => stated.and_then(|index| index.checked_add_unsigned(known as u64)),
            Some(0) | None => None,
        };
        let index = index.and_then(|index| u32::try_from(index).ok());
        index.ok_or_else(|| self.invalid("vertex indices: from 1 on, or back from the last vertex"))
    }
}

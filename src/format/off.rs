//! OFF, the object file format of Geomview: ascii, three coordinates, polygons.
//!
//! The header's keyword is `OFF` with the prefixes `ST`, `C` and `N` in any combination, or is left out: texture coordinates,
//! colours and normals are passed over. Four or n coordinates (`4OFF`, `nOFF`) and the binary kind are refused.

use super::{FlatMesh, MeshRecord, Precision, Problem, excerpt};
use std::io::{BufRead, Write};
use std::str::FromStr;

/// Reads positions as the nearest binary64 and faces as they are.
///
/// The header's counts of vertices and faces must be those of the file; that of edges may be anything, or left out.
/// A `#` begins a comment; a face's numbers after its indices are its colour.
///
/// Errors, each naming its line: another kind of OFF; a count that is none; a line that ends early; fewer or more lines
/// than the counts say; an index that is no whole number in 0 … 2³² − 1.
pub fn read(reader: impl BufRead) -> Result<MeshRecord, Problem> {
    read_flat(reader).map(MeshRecord::from)
}

/// [`read`] into flat arrays. Nothing is allocated for a count before there are lines for it.
pub fn read_flat(reader: impl BufRead) -> Result<FlatMesh, Problem> {
    let mut lines = Lines { reader, text: Vec::new(), number: 0 };
    let [vertices, faces] = lines.header()?;
    let mut mesh = FlatMesh::new(Precision::Binary64);
    for found in 0..vertices {
        let line = lines.next()?.ok_or_else(|| truncated("vertices", vertices, found))?;
        let mut words = line.words();
        let mut position = [0.0; 3];
        for coordinate in &mut position {
            *coordinate = line.number(words.next(), "three coordinates")?;
        }
        // A normal, a colour, texture coordinates: numbers, whatever they mean.
        line.are_numbers(words)?;
        mesh.vertices.push(position);
    }
    for found in 0..faces {
        let line = lines.next()?.ok_or_else(|| truncated("faces", faces, found))?;
        let mut words = line.words();
        let corners: u64 = line.number(words.next(), "the number of the face's corners")?;
        for _ in 0..corners {
            mesh.corners
                .push(line.number(words.next(), "as many vertex indices, from 0 on, as the first number says")?);
        }
        // A colour: up to four numbers, or the name of one.
        if words.count() > 4 {
            return Err(line.invalid("the vertex indices, then at most four numbers of a colour"));
        }
        mesh.end_face()?;
    }
    match lines.next()? {
        None => Ok(mesh),
        Some(_) => {
            Err(Problem::Overlong { field: "data".to_owned(), unit: "vertices and faces", expected: vertices + faces })
        }
    }
}

/// Writes the shortest decimals that read back as the same binary64; the header's count of edges is 0, which is allowed.
pub fn write(mut writer: impl Write, mesh: &MeshRecord) -> Result<(), Problem> {
    writeln!(writer, "OFF\n{} {} 0", mesh.vertices.len(), mesh.faces.len())?;
    for [x, y, z] in &mesh.vertices {
        writeln!(writer, "{x:?} {y:?} {z:?}")?;
    }
    for face in &mesh.faces {
        write!(writer, "{}", face.len())?;
        for index in face {
            write!(writer, " {index}")?;
        }
        writeln!(writer)?;
    }
    Ok(writer.flush()?)
}

fn truncated(field: &str, expected: u64, found: u64) -> Problem {
    Problem::Truncated { field: field.to_owned(), unit: "lines", expected, found }
}

struct Lines<R> {
    reader: R,
    text: Vec<u8>,
    number: usize,
}

impl<R: BufRead> Lines<R> {
    /// The next line that is neither blank nor a comment.
    fn next(&mut self) -> Result<Option<Line<'_>>, Problem> {
        loop {
            self.text.clear();
            if self.reader.read_until(b'\n', &mut self.text)? == 0 {
                return Ok(None);
            }
            self.number += 1;
            if words(&self.text).next().is_some() {
                return Ok(Some(Line { text: &self.text, number: self.number }));
            }
        }
    }

    /// The counts of vertices and faces, which stand beside the keyword or on the next line.
    fn header(&mut self) -> Result<[u64; 2], Problem> {
        let first = self.next()?.ok_or_else(|| Problem::Magic { format: "OFF", found: String::new() })?;
        if let Some(counts) = first.header()? {
            return Ok(counts);
        }
        let line = self.next()?.ok_or(Problem::Missing { field: "counts of vertices and faces" })?;
        line.counts(line.words())
    }
}

/// What the first word of a file says.
enum Kind {
    Keyword,
    Counts,
    Refused(&'static str),
    Other,
}

fn kind(word: &[u8]) -> Kind {
    if word.iter().all(u8::is_ascii_digit) {
        return Kind::Counts;
    }
    let Some(prefixes) = word.strip_suffix(b"OFF") else { return Kind::Other };
    let rest = prefixes.strip_prefix(b"ST").unwrap_or(prefixes);
    let rest = rest.strip_prefix(b"C").unwrap_or(rest);
    match rest.strip_prefix(b"N").unwrap_or(rest) {
        b"" => Kind::Keyword,
        b"4" | b"n" | b"4n" => Kind::Refused("three coordinates a vertex"),
        _ => Kind::Other,
    }
}

/// The words before a comment.
fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    let text = text.split(|&byte| byte == b'#').next().unwrap_or_default();
    text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

struct Line<'a> {
    text: &'a [u8],
    number: usize,
}

impl<'a> Line<'a> {
    fn words(&self) -> impl Iterator<Item = &'a [u8]> + use<'a> {
        words(self.text)
    }

    fn invalid(&self, expected: &'static str) -> Problem {
        Problem::Invalid { field: format!("line {}", self.number), expected, found: excerpt(self.text) }
    }

    /// The counts, where this first line of a file has them.
    fn header(&self) -> Result<Option<[u64; 2]>, Problem> {
        let invalid = |expected| Problem::Invalid { field: "header".to_owned(), expected, found: excerpt(self.text) };
        let mut words = self.words().peekable();
        match words.peek().map_or(Kind::Other, |word| kind(word)) {
            Kind::Counts => return self.counts(words).map(Some),
            Kind::Keyword => drop(words.next()),
            Kind::Refused(expected) => return Err(invalid(expected)),
            Kind::Other => return Err(Problem::Magic { format: "OFF", found: excerpt(self.text) }),
        }
        match words.peek() {
            None => Ok(None),
            Some(word) if **word == b"BINARY"[..] => Err(invalid("the ascii kind of OFF")),
            Some(_) => self.counts(words).map(Some),
        }
    }

    fn number<T: FromStr>(&self, word: Option<&[u8]>, expected: &'static str) -> Result<T, Problem> {
        let number = word.and_then(|word| std::str::from_utf8(word).ok()?.parse().ok());
        number.ok_or_else(|| self.invalid(expected))
    }

    fn are_numbers<'b>(&self, mut words: impl Iterator<Item = &'b [u8]>) -> Result<(), Problem> {
        words.try_for_each(|word| self.number::<f64>(Some(word), "numbers").map(drop))
    }

    /// The counts of vertices, of faces, and perhaps of edges.
    fn counts<'b>(&self, mut words: impl Iterator<Item = &'b [u8]>) -> Result<[u64; 2], Problem> {
        let expected = "the counts of vertices, faces and, perhaps, edges";
        let counts = [self.number(words.next(), expected)?, self.number(words.next(), expected)?];
        if let Some(edges) = words.next() {
            self.number::<u64>(Some(edges), expected)?;
        }
        if words.next().is_some() { Err(self.invalid(expected)) } else { Ok(counts) }
    }
}

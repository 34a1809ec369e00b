//! STL, triangles without shared vertices; binary through `stl_io`.
//!
//! Only the positions are read: normals and attributes are passed over. Nothing is welded.

use super::{FaceProblem, FlatMesh, MeshRecord, Precision, Problem, excerpt};
use std::io::{Cursor, Read, Write};
use stl_io::{Normal, Triangle};

/// Reads either kind of STL. Face i has the vertices 3i, 3i+1, 3i+2, in the order of the file.
///
/// A file is binary if its length is what its count of triangles says, whatever its first word; otherwise it is ascii
/// if that word is `solid`. The solids of an ascii file follow one another in the result. Decimals are read as the
/// nearest binary32, which is what an STL holds.
///
/// Errors: neither kind; a file that ends early or goes on; in ascii, another word than the grammar has there.
pub fn read(reader: impl Read) -> Result<MeshRecord, Problem> {
    read_flat(reader).map(MeshRecord::from)
}

/// [`read`] into flat arrays.
pub fn read_flat(mut reader: impl Read) -> Result<FlatMesh, Problem> {
    let mut bytes = Vec::new();
    reader.read_to_end(&mut bytes)?;
    let binary_length = bytes.get(80..HEADER).map(|count| {
        let count = u32::from_le_bytes(count.try_into().expect("four bytes"));
        HEADER as u64 + TRIANGLE * u64::from(count)
    });
    let is_ascii = bytes.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    let length = bytes.len() as u64;
    match binary_length {
        Some(expected) if expected == length => binary(bytes),
        _ if is_ascii => ascii(&bytes),
        Some(expected) if expected < length => {
            Err(Problem::Overlong { field: "triangles".to_owned(), unit: "bytes", expected })
        }
        Some(expected) => {
            Err(Problem::Truncated { field: "triangles".to_owned(), unit: "bytes", expected, found: length })
        }
        None => Err(Problem::Magic { format: "STL", found: excerpt(&bytes) }),
    }
}

/// Writes a binary STL: each coordinate rounded to the nearest binary32, each normal 0, so that the reader finds its own.
///
/// Errors: a face that is no triangle, or whose vertex is not there.
pub fn write(mut writer: impl Write, mesh: &MeshRecord) -> Result<(), Problem> {
    let mut triangles = Vec::with_capacity(mesh.faces.len());
    for (face, indices) in mesh.faces.iter().enumerate() {
        let corner = |index: u32| match mesh.vertices.get(index as usize) {
            Some(position) => Ok(stl_io::Vertex::new(position.map(|coordinate| coordinate as f32))),
            None => Err(Problem::Face { face, problem: FaceProblem::IndexOutOfRange(index) }),
        };
        let [a, b, c] = indices[..] else {
            return Err(Problem::Face { face, problem: FaceProblem::NotATriangle(indices.len()) });
        };
        triangles.push(Triangle { normal: Normal::default(), vertices: [corner(a)?, corner(b)?, corner(c)?] });
    }
    if u32::try_from(triangles.len()).is_err() {
        let (field, expected) = ("triangles".to_owned(), "fewer than 2³²");
        return Err(Problem::Invalid { field, expected, found: triangles.len().to_string() });
    }
    Ok(stl_io::write_stl(&mut writer, triangles.iter())?)
}

const HEADER: usize = 84;
const TRIANGLE: u64 = 50;

fn binary(mut bytes: Vec<u8>) -> Result<FlatMesh, Problem> {
    // The library takes a file that begins with "solid " for ascii; the comment may say anything.
    bytes[..80].fill(0);
    let mut soup = Soup::new();
    for triangle in stl_io::create_stl_reader(&mut Cursor::new(bytes))? {
        soup.push(triangle?.vertices.map(|vertex| vertex.0))?;
    }
    Ok(soup.0)
}

// The library's ascii reader stops without a word after the first solid of a file, and refuses a file for a normal
// that is NaN, which is what many writers put beside a degenerate triangle, or for a solid without a name.
fn ascii(bytes: &[u8]) -> Result<FlatMesh, Problem> {
    let mut soup = Soup::new();
    let mut lines = Lines { bytes, line: 0 };
    while let Some(solid) = lines.next() {
        solid.begins_with(&["solid"])?;
        loop {
            let facet = lines.expected("facet or endsolid")?;
            if facet.word(0).eq_ignore_ascii_case(b"endsolid") {
                break;
            }
            facet.begins_with(&["facet"])?;
            lines.expected("outer loop")?.begins_with(&["outer", "loop"])?;
            let mut triangle = [[0.0; 3]; 3];
            for corner in &mut triangle {
                *corner = lines.expected("vertex")?.vertex()?;
            }
            lines.expected("endloop")?.begins_with(&["endloop"])?;
            lines.expected("endfacet")?.begins_with(&["endfacet"])?;
            soup.push(triangle)?;
        }
    }
    Ok(soup.0)
}

/// The lines that are not blank.
struct Lines<'a> {
    bytes: &'a [u8],
    line: usize,
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        loop {
            if self.bytes.is_empty() {
                return None;
            }
            let end = self.bytes.iter().position(|&byte| byte == b'\n').map_or(self.bytes.len(), |end| end + 1);
            let (line, rest) = self.bytes.split_at(end);
            self.bytes = rest;
            self.line += 1;
            let line = Line { text: line.trim_ascii(), number: self.line };
            if !line.text.is_empty() {
                return Some(line);
            }
        }
    }
}

impl<'a> Lines<'a> {
    fn expected(&mut self, what: &'static str) -> Result<Line<'a>, Problem> {
        self.next().ok_or_else(|| Problem::Invalid {
            field: format!("line {}", self.line + 1),
            expected: what,
            found: "the end of the file".to_owned(),
        })
    }
}

struct Line<'a> {
    text: &'a [u8],
    number: usize,
}

impl<'a> Line<'a> {
    fn words(&self) -> impl Iterator<Item = &'a [u8]> + use<'a> {
        self.text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
    }

    fn word(&self, index: usize) -> &'a [u8] {
        self.words().nth(index).unwrap_or_default()
    }

    fn invalid(&self, expected: &'static str) -> Problem {
        Problem::Invalid { field: format!("line {}", self.number), expected, found: excerpt(self.text) }
    }

    fn begins_with(&self, words: &[&'static str]) -> Result<(), Problem> {
        for (index, word) in words.iter().enumerate() {
            if !self.word(index).eq_ignore_ascii_case(word.as_bytes()) {
                return Err(self.invalid(word));
            }
        }
        Ok(())
    }

    fn vertex(&self) -> Result<[f32; 3], Problem> {
        self.begins_with(&["vertex"])?;
        let mut words = self.words().skip(1);
        let mut position = [0.0; 3];
        for coordinate in &mut position {
            let number = words.next().and_then(|word| std::str::from_utf8(word).ok()?.parse().ok());
            *coordinate = number.ok_or_else(|| self.invalid("vertex and three numbers"))?;
        }
        if words.next().is_none() { Ok(position) } else { Err(self.invalid("vertex and three numbers")) }
    }
}

struct Soup(FlatMesh);

impl Soup {
    fn new() -> Soup {
        Soup(FlatMesh { soup: true, ..FlatMesh::new(Precision::Binary32) })
    }

    fn push(&mut self, triangle: [[f32; 3]; 3]) -> Result<(), Problem> {
        let mesh = &mut self.0;
        let first = u32::try_from(mesh.vertices.len()).ok().filter(|&first| first <= u32::MAX - 3);
        let first = first.ok_or_else(|| Problem::Invalid {
            field: "triangles".to_owned(),
            expected: "fewer than 2³² corners",
            found: format!("triangle {}", mesh.ends.len()),
        })?;
        mesh.vertices.extend(triangle.map(|corner| corner.map(f64::from)));
        mesh.corners.extend([first, first + 1, first + 2]);
        mesh.end_face()
    }
}

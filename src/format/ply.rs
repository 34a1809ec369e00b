//! PLY, the polygon file format; headers and writing through `ply-rs-bw`.
//!
//! Read: `x`, `y`, `z` of the element `vertex`, and `vertex_indices` or `vertex_index` of the element `face`;
//! every other element and property is passed over.

use super::ply_binary::Window;
use super::{FlatMesh, MeshRecord, Precision, Problem, excerpt};
use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{
    Addable, ElementDef, Encoding as Stored, Header, Property, PropertyAccess, PropertyAccessResult, PropertyDef,
    PropertyType, ScalarType, Version,
};
use ply_rs_bw::writer::Writer;
use std::collections::BTreeSet;
use std::io::{self, BufRead, Cursor, Write};
use std::str::FromStr;

/// How the numbers are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Binary, little endian.
    Binary,
    /// Shortest decimals that read back as the same number.
    Ascii,
}

/// Reads a polygon mesh; without an element `face` it is a cloud of points.
///
/// Errors: no PLY; something stated twice; no `vertex`, or one without x, y, z; triangle strips; an index that is no
/// whole number in 0 … 2³² − 1; data that ends early or goes on (but for blanks).
pub fn read(reader: impl BufRead) -> Result<MeshRecord, Problem> {
    read_flat(reader).map(MeshRecord::from)
}

/// [`read`] into flat arrays.
pub fn read_flat(mut reader: impl BufRead) -> Result<FlatMesh, Problem> {
    let header = header(&mut reader)?;
    let mut mesh = FlatMesh::new(Precision::Binary64);
    let mut rows = match header.encoding {
        Stored::Ascii => Rows::Ascii(Lines { reader, line: Vec::new(), rows: 0 }),
        Stored::BinaryLittleEndian => Rows::Binary(Window::new(reader, false)),
        Stored::BinaryBigEndian => Rows::Binary(Window::new(reader, true)),
    };
    for element in header.elements.values() {
        match element.name.as_str() {
            "vertex" => {
                mesh.precision = precision(element)?;
                match &mut rows {
                    Rows::Ascii(lines) => lines.each(element, |row: Vertex| {
                        mesh.vertices.push(row.0);
                        Ok(())
                    })?,
                    Rows::Binary(window) => window.vertices(element, &mut mesh)?,
                }
            }
            "face" => {
                let list = the_index_list(element)?;
                match &mut rows {
                    Rows::Ascii(lines) => lines.each(element, |row: Face| {
                        mesh.corners.extend(row.0.map_err(|index| Problem::Invalid {
                            field: format!("face {}, vertex index", mesh.ends.len()),
                            expected: "a whole number from 0",
                            found: index.to_string(),
                        })?);
                        mesh.end_face()
                    })?,
                    Rows::Binary(window) => window.faces(element, list, &mut mesh)?,
                }
            }
            "tristrips" => {
                return Err(Problem::Invalid {
                    field: "element tristrips".to_owned(),
                    expected: "element face",
                    found: "triangle strips".to_owned(),
                });
            }
            _ => match &mut rows {
                Rows::Ascii(lines) => lines.each(element, |_: Other| Ok(()))?,
                Rows::Binary(window) => window.skip(element)?,
            },
        }
    }
    if !header.elements.contains_key("vertex") {
        return Err(Problem::Missing { field: "element vertex" });
    }
    match rows {
        Rows::Ascii(lines) => lines.end()?,
        Rows::Binary(window) => window.end()?,
    }
    Ok(mesh)
}

enum Rows<R> {
    Ascii(Lines<R>),
    Binary(Window<R>),
}

/// Writes coordinates as doubles and indices as `uint`, so that [`read`] gives the same mesh, its precision binary64.
pub fn write(mut writer: impl Write, mesh: &MeshRecord, encoding: Encoding) -> Result<(), Problem> {
    let longest = mesh.faces.iter().map(Vec::len).max().unwrap_or(0);
    let length = if longest < 256 { ScalarType::UChar } else { ScalarType::UInt };
    let indices = ("vertex_indices", PropertyType::List(length, ScalarType::UInt));
    let coordinates = ["x", "y", "z"].map(|axis| (axis, PropertyType::Scalar(ScalarType::Double)));
    let vertex = element("vertex", mesh.vertices.len(), coordinates);
    let face = element("face", mesh.faces.len(), [indices]);
    let mut header = Header::new();
    header.encoding = match encoding {
        Encoding::Binary => Stored::BinaryLittleEndian,
        Encoding::Ascii => Stored::Ascii,
    };
    header.version = Version { major: 1, minor: 0 };
    header.elements.add(vertex.clone());
    header.elements.add(face.clone());
    let (vertices, faces) = (Writer::<Vertex>::new(), Writer::<FaceRow<'_>>::new());
    vertices.write_header(&mut writer, &header)?;
    for &position in &mesh.vertices {
        match encoding {
            Encoding::Binary => vertices.write_little_endian_element(&mut writer, &Vertex(position), &vertex)?,
            Encoding::Ascii => vertices.write_ascii_element(&mut writer, &Vertex(position), &vertex)?,
        };
    }
    for indices in &mesh.faces {
        match encoding {
            Encoding::Binary => faces.write_little_endian_element(&mut writer, &FaceRow(indices), &face)?,
            Encoding::Ascii => faces.write_ascii_element(&mut writer, &FaceRow(indices), &face)?,
        };
    }
    Ok(writer.flush()?)
}

pub(super) fn element<const N: usize>(name: &str, count: usize, properties: [(&str, PropertyType); N]) -> ElementDef {
    let mut element = ElementDef::new(name.to_owned());
    element.count = count;
    for (name, data_type) in properties {
        element.properties.add(PropertyDef::new(name.to_owned(), data_type));
    }
    element
}

const LONGEST_HEADER: usize = 1 << 20;

/// The header, cut out first: the library would read a file without line ends whole, and keeps silently the last of
/// two elements or properties of the same name.
fn header(reader: &mut impl BufRead) -> Result<Header, Problem> {
    let mut bytes = Vec::new();
    let mut names = BTreeSet::new();
    let mut element = String::new();
    loop {
        let start = bytes.len();
        let found = io::Read::take(&mut *reader, (LONGEST_HEADER - start) as u64).read_until(b'\n', &mut bytes)?;
        if start == 0 && bytes.trim_ascii_end() != b"ply" {
            return Err(Problem::Magic { format: "PLY", found: excerpt(&bytes) });
        }
        if found == 0 {
            return Err(Problem::EndlessHeader { bytes: start });
        }
        let line = String::from_utf8_lossy(&bytes[start..]);
        let words: Vec<&str> = line.split_whitespace().collect();
        let name = match words[..] {
            ["end_header"] => break,
            ["element", name, ..] => {
                element = format!("element {name}");
                element.clone()
            }
            ["property", .., name] => format!("{element}, property {name}"),
            _ => continue,
        };
        if !names.insert(name.clone()) {
            return Err(Problem::Repeated { field: name });
        }
    }
    Parser::<Other>::new().read_ply_header(&mut Cursor::new(bytes)).map_err(|error| library("header", error))
}

fn library(field: &'static str, error: impl std::error::Error + Send + Sync + 'static) -> Problem {
    Problem::Library { field, source: Box::new(error) }
}

/// Binary32 if all three coordinates are.
fn precision(vertex: &ElementDef) -> Result<Precision, Problem> {
    let mut precision = Precision::Binary32;
    for (axis, field) in [("x", "vertex property x"), ("y", "vertex property y"), ("z", "vertex property z")] {
        match vertex.properties.get(axis).map(|property| &property.data_type) {
            None => return Err(Problem::Missing { field }),
            Some(PropertyType::Scalar(ScalarType::Float)) => {}
            Some(PropertyType::Scalar(_)) => precision = Precision::Binary64,
            Some(PropertyType::List(..)) => {
                let (field, found) = (field.to_owned(), "a list".to_owned());
                return Err(Problem::Invalid { field, expected: "a number", found });
            }
        }
    }
    Ok(precision)
}

const INDEX_LISTS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// The name of the property that holds the indices.
fn the_index_list(face: &ElementDef) -> Result<&str, Problem> {
    let mut lists = INDEX_LISTS.iter().filter_map(|&name| face.properties.get(name));
    let property = lists.next().ok_or(Problem::Missing { field: "face property vertex_indices" })?;
    let field = format!("face property {}", property.name);
    match (&property.data_type, lists.next()) {
        (_, Some(_)) => Err(Problem::Repeated { field }),
        (PropertyType::List(_, ScalarType::Float | ScalarType::Double) | PropertyType::Scalar(_), None) => {
            let found = format!("{:?}", property.data_type);
            Err(Problem::Invalid { field, expected: "a list of integers", found })
        }
        (PropertyType::List(..), None) => Ok(&property.name),
    }
}

/// The rows of an ascii file, read one at a time: the library's own maps take nine times the memory of the record
/// (1.8 GiB for three million triangles).
struct Lines<R> {
    reader: R,
    line: Vec<u8>,
    rows: u64,
}

impl<R: BufRead> Lines<R> {
    fn each<E: PropertyAccess>(
        &mut self,
        element: &ElementDef,
        mut take: impl FnMut(E) -> Result<(), Problem>,
    ) -> Result<(), Problem> {
        if element.properties.is_empty() {
            return Ok(());
        }
        for row in 0..element.count {
            take(self.row(element).map_err(|error| row_problem(element, row, error))?)?;
            self.rows += 1;
        }
        Ok(())
    }

    /// One line. The library's parser of lines takes no `1.`, `nan` or `inf` and is silent about numbers too many.
    fn row<E: PropertyAccess>(&mut self, element: &ElementDef) -> io::Result<E> {
        self.line.clear();
        if self.reader.read_until(b'\n', &mut self.line)? == 0 {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        let text = std::str::from_utf8(&self.line).map_err(wrong)?;
        let mut words = text.split_ascii_whitespace();
        let mut row = E::new();
        for (name, property) in &element.properties {
            let property = match &property.data_type {
                PropertyType::Scalar(scalar) => ascii_scalar(scalar, words.next().unwrap_or_default())?,
                PropertyType::List(_, scalar) => {
                    let length: usize = words.next().unwrap_or_default().parse().map_err(wrong)?;
                    if length > words.clone().count() {
                        return Err(wrong(format!("property {name}: a list of {length} ends early")));
                    }
                    ascii_list(scalar, words.by_ref().take(length))?
                }
            };
            row.set_property(name, property);
        }
        match words.next() {
            None => Ok(row),
            Some(word) => Err(wrong(format!("{word:?} is one number too many"))),
        }
    }

    /// Only blanks may follow.
    fn end(mut self) -> Result<(), Problem> {
        loop {
            let bytes = self.reader.fill_buf()?;
            if bytes.is_empty() {
                return Ok(());
            }
            if !bytes.trim_ascii().is_empty() {
                return Err(Problem::Overlong { field: "data".to_owned(), unit: "rows", expected: self.rows });
            }
            let length = bytes.len();
            self.reader.consume(length);
        }
    }
}

fn row_problem(element: &ElementDef, row: usize, error: io::Error) -> Problem {
    let field = format!("element {}", element.name);
    match error.kind() {
        io::ErrorKind::UnexpectedEof => {
            Problem::Truncated { field, unit: "rows", expected: element.count as u64, found: row as u64 }
        }
        io::ErrorKind::InvalidData | io::ErrorKind::InvalidInput => {
            let field = format!("{field} {row}");
            Problem::Invalid { field, expected: "its properties", found: error.to_string() }
        }
        _ => Problem::Io(error),
    }
}

fn wrong(error: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, error)
}

fn ascii_scalar(scalar: &ScalarType, word: &str) -> io::Result<Property> {
    Ok(match scalar {
        ScalarType::Char => Property::Char(word.parse().map_err(wrong)?),
        ScalarType::UChar => Property::UChar(word.parse().map_err(wrong)?),
        ScalarType::Short => Property::Short(word.parse().map_err(wrong)?),
        ScalarType::UShort => Property::UShort(word.parse().map_err(wrong)?),
        ScalarType::Int => Property::Int(word.parse().map_err(wrong)?),
        ScalarType::UInt => Property::UInt(word.parse().map_err(wrong)?),
        ScalarType::Float => Property::Float(word.parse().map_err(wrong)?),
        ScalarType::Double => Property::Double(word.parse().map_err(wrong)?),
    })
}

fn ascii_list<'a>(scalar: &ScalarType, words: impl Iterator<Item = &'a str>) -> io::Result<Property> {
    Ok(match scalar {
        ScalarType::Char => Property::ListChar(parsed(words)?),
        ScalarType::UChar => Property::ListUChar(parsed(words)?),
        ScalarType::Short => Property::ListShort(parsed(words)?),
        ScalarType::UShort => Property::ListUShort(parsed(words)?),
        ScalarType::Int => Property::ListInt(parsed(words)?),
        ScalarType::UInt => Property::ListUInt(parsed(words)?),
        ScalarType::Float => Property::ListFloat(parsed(words)?),
        ScalarType::Double => Property::ListDouble(parsed(words)?),
    })
}

fn parsed<'a, T: FromStr>(words: impl Iterator<Item = &'a str>) -> io::Result<Vec<T>>
where
    T::Err: std::error::Error + Send + Sync + 'static,
{
    words.map(|word| word.parse().map_err(wrong)).collect()
}

struct Vertex([f64; 3]);

impl PropertyAccess for Vertex {
    fn new() -> Vertex {
        Vertex([0.0; 3])
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let axis = match name {
            "x" => 0,
            "y" => 1,
            "z" => 2,
            _ => return PropertyAccessResult::Ignored,
        };
        self.0[axis] = match property {
            Property::Char(n) => n.into(),
            Property::UChar(n) => n.into(),
            Property::Short(n) => n.into(),
            Property::UShort(n) => n.into(),
            Property::Int(n) => n.into(),
            Property::UInt(n) => n.into(),
            Property::Float(n) => n.into(),
            Property::Double(n) => n,
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }

    fn get_double(&self, name: &str) -> Option<f64> {
        let [x, y, z] = self.0;
        match name {
            "x" => Some(x),
            "y" => Some(y),
            "z" => Some(z),
            _ => None,
        }
    }
}

/// The indices, or the first one that is negative.
struct Face(Result<Vec<u32>, i64>);

impl PropertyAccess for Face {
    fn new() -> Face {
        Face(Ok(Vec::new()))
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if !INDEX_LISTS.contains(&name) {
            return PropertyAccessResult::Ignored;
        }
        self.0 = match property {
            Property::ListChar(list) => indices(list),
            Property::ListUChar(list) => indices(list),
            Property::ListShort(list) => indices(list),
            Property::ListUShort(list) => indices(list),
            Property::ListInt(list) => indices(list),
            Property::ListUInt(list) => Ok(list),
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

fn indices<T: Copy + TryInto<u32> + Into<i64>>(list: Vec<T>) -> Result<Vec<u32>, i64> {
    list.into_iter().map(|index| index.try_into().map_err(|_| index.into())).collect()
}

/// A face to be written.
pub(super) struct FaceRow<'a>(pub &'a [u32]);

impl PropertyAccess for FaceRow<'_> {
    fn new() -> Self {
        FaceRow(&[])
    }

    fn get_list_uint(&self, _: &str) -> Option<&[u32]> {
        Some(self.0)
    }
}

/// A row that nobody asked for.
struct Other;

impl PropertyAccess for Other {
    fn new() -> Other {
        Other
    }
}

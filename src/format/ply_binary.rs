//! The rows of a binary PLY, straight into flat arrays: ten million triangles in a second.

use super::{FlatMesh, Problem};
use ply_rs_bw::ply::{ElementDef, PropertyType, ScalarType};
use std::io::{self, Read};

/// The bytes that have been read and not yet used.
pub(super) struct Window<R> {
    reader: R,
    bytes: Vec<u8>,
    start: usize,
    big_endian: bool,
    rows: u64,
}

/// So much is read at a time, more only where one row is longer.
const CHUNK: usize = 1 << 20;

/// A row, as far as it is there.
enum Row {
    /// So many bytes.
    Whole(usize),
    /// It goes on beyond the bytes at hand.
    Cut,
    /// What cannot be read.
    Wrong(String),
}

impl<R: Read> Window<R> {
    pub(super) fn new(reader: R, big_endian: bool) -> Window<R> {
        Window { reader, bytes: Vec::new(), start: 0, big_endian, rows: 0 }
    }

    /// The positions of the element `vertex`, whose x, y, z are scalars.
    pub(super) fn vertices(&mut self, element: &ElementDef, mesh: &mut FlatMesh) -> Result<(), Problem> {
        let is_scalar = |data_type: &PropertyType| matches!(data_type, PropertyType::Scalar(_));
        if !element.properties.values().all(|property| is_scalar(&property.data_type)) {
            return self.vertices_beside_lists(element, mesh);
        }
        let mut size = 0;
        let mut axes = [const { (0, &ScalarType::Float) }; 3];
        for property in element.properties.values() {
            let PropertyType::Scalar(scalar) = &property.data_type else { unreachable!("all are scalars") };
            if let Some(axis) = AXES.iter().position(|axis| *axis == property.name) {
                axes[axis] = (size, scalar);
            }
            size += width(scalar);
        }
        let big_endian = self.big_endian;
        self.each(element, |bytes| match bytes.get(..size) {
            None => Row::Cut,
            Some(row) => {
                mesh.vertices.push(axes.map(|(place, scalar)| number(scalar, &row[place..], big_endian)));
                Row::Whole(size)
            }
        })
    }

    fn vertices_beside_lists(&mut self, element: &ElementDef, mesh: &mut FlatMesh) -> Result<(), Problem> {
        let big_endian = self.big_endian;
        self.each(element, |bytes| {
            let mut position = [0.0; 3];
            let row = walk(element, bytes, big_endian, |name, scalar, values| {
                if let Some(axis) = AXES.iter().position(|axis| *axis == name) {
                    position[axis] = number(scalar, values, big_endian);
                }
                Ok(())
            });
            if let Row::Whole(_) = row {
                mesh.vertices.push(position);
            }
            row
        })
    }

    /// The faces of an element whose property of this name is a list of integers.
    pub(super) fn faces(&mut self, element: &ElementDef, list: &str, mesh: &mut FlatMesh) -> Result<(), Problem> {
        let big_endian = self.big_endian;
        let mut outcome = Ok(());
        self.each(element, |bytes| {
            let known = mesh.corners.len();
            let row = walk(element, bytes, big_endian, |name, scalar, values| {
                if name == list {
                    for value in values.chunks_exact(width(scalar)) {
                        mesh.corners.push(index(scalar, value, big_endian)?);
                    }
                }
                Ok(())
            });
            match row {
                Row::Whole(_) => outcome = mesh.end_face(),
                Row::Cut | Row::Wrong(_) => mesh.corners.truncate(known),
            }
            match &outcome {
                Ok(()) => row,
                Err(problem) => Row::Wrong(problem.to_string()),
            }
        })
    }

    /// Passes over an element.
    pub(super) fn skip(&mut self, element: &ElementDef) -> Result<(), Problem> {
        let big_endian = self.big_endian;
        self.each(element, |bytes| walk(element, bytes, big_endian, |_, _, _| Ok(())))
    }

    /// Only blanks may follow.
    pub(super) fn end(mut self) -> Result<(), Problem> {
        loop {
            if !self.bytes[self.start..].trim_ascii().is_empty() {
                return Err(Problem::Overlong { field: "data".to_owned(), unit: "rows", expected: self.rows });
            }
            self.start = self.bytes.len();
            if !self.more()? {
                return Ok(());
            }
        }
    }

    fn each(&mut self, element: &ElementDef, mut row: impl FnMut(&[u8]) -> Row) -> Result<(), Problem> {
        if element.properties.is_empty() {
            // A row without properties takes no byte, and there may be 2⁶⁴ of them.
            return Ok(());
        }
        for number in 0..element.count {
            loop {
                match row(&self.bytes[self.start..]) {
                    Row::Whole(length) => {
                        self.start += length;
                        self.rows += 1;
                        break;
                    }
                    Row::Wrong(found) => {
                        let field = format!("element {} {number}", element.name);
                        return Err(Problem::Invalid { field, expected: "its properties", found });
                    }
                    Row::Cut => {
                        if !self.more()? {
                            let (field, expected) = (format!("element {}", element.name), element.count as u64);
                            return Err(Problem::Truncated { field, unit: "rows", expected, found: number as u64 });
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Reads on; false at the end of the file. As much again as is at hand, so that a long row takes few steps.
    fn more(&mut self) -> io::Result<bool> {
        self.bytes.drain(..self.start);
        self.start = 0;
        let known = self.bytes.len();
        let length = CHUNK.max(known) as u64;
        self.reader.by_ref().take(length).read_to_end(&mut self.bytes)?;
        Ok(self.bytes.len() > known)
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// Each property of a row: its name, its type, the bytes of its value or values.
fn walk(
    element: &ElementDef,
    bytes: &[u8],
    big_endian: bool,
    mut visit: impl FnMut(&str, &ScalarType, &[u8]) -> Result<(), String>,
) -> Row {
    let mut place = 0;
    for property in element.properties.values() {
        let (scalar, count) = match &property.data_type {
            PropertyType::Scalar(scalar) => (scalar, 1),
            PropertyType::List(length, scalar) => {
                let Some(value) = bytes.get(place..place + width(length)) else { return Row::Cut };
                place += width(length);
                match index(length, value, big_endian) {
                    Ok(count) => (scalar, count as usize),
                    Err(found) => return Row::Wrong(format!("property {}: a list of {found}", property.name)),
                }
            }
        };
        let length = count * width(scalar);
        let Some(values) = bytes.get(place..place + length) else { return Row::Cut };
        if let Err(found) = visit(&property.name, scalar, values) {
            return Row::Wrong(format!("property {}: expected a whole number from 0, found {found}", property.name));
        }
        place += length;
    }
    Row::Whole(place)
}

fn width(scalar: &ScalarType) -> usize {
    match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}

/// The first bytes in the order of a machine number.
fn ordered<const N: usize>(bytes: &[u8], big_endian: bool) -> [u8; N] {
    let mut ordered: [u8; N] = bytes[..N].try_into().expect("so many bytes were asked for");
    if big_endian {
        ordered.reverse();
    }
    ordered
}

fn number(scalar: &ScalarType, bytes: &[u8], big_endian: bool) -> f64 {
    match scalar {
        ScalarType::Char => i8::from_le_bytes(ordered(bytes, big_endian)).into(),
        ScalarType::UChar => u8::from_le_bytes(ordered(bytes, big_endian)).into(),
        ScalarType::Short => i16::from_le_bytes(ordered(bytes, big_endian)).into(),
        ScalarType::UShort => u16::from_le_bytes(ordered(bytes, big_endian)).into(),
        ScalarType::Int => i32::from_le_bytes(ordered(bytes, big_endian)).into(),
        ScalarType::UInt => u32::from_le_bytes(ordered(bytes, big_endian)).into(),
        ScalarType::Float => f32::from_le_bytes(ordered(bytes, big_endian)).into(),
        ScalarType::Double => f64::from_le_bytes(ordered(bytes, big_endian)),
    }
}

/// A whole number from 0, or what is there instead.
fn index(scalar: &ScalarType, bytes: &[u8], big_endian: bool) -> Result<u32, String> {
    match scalar {
        ScalarType::Int => {
            let value = i32::from_le_bytes(ordered(bytes, big_endian));
            u32::try_from(value).map_err(|_| value.to_string())
        }
        ScalarType::UInt => Ok(u32::from_le_bytes(ordered(bytes, big_endian))),
        ScalarType::Char | ScalarType::UChar | ScalarType::Short | ScalarType::UShort => {
            let value = number(scalar, bytes, big_endian);
            if value < 0.0 { Err(value.to_string()) } else { Ok(value as u32) }
        }
        ScalarType::Float | ScalarType::Double => Err(number(scalar, bytes, big_endian).to_string()),
    }
}

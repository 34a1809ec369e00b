//! PLY with colours and numbers at the vertices.

use super::ply::{FaceRow, element};
use super::{FormatError, MeshRecord, Problem, at, create};
use ply_rs_bw::ply::{Addable, Encoding, Header, PropertyAccess, PropertyType, ScalarType, Version};
use ply_rs_bw::writer::Writer;
use std::io::Write;
use std::path::Path;

/// What a vertex carries beside its position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Painted {
    /// Red, green, blue.
    pub colour: [u8; 3],
    /// The number that the colour stands for.
    pub number: f64,
}

/// Writes a mesh as binary PLY: `x y z` as doubles, `red green blue` as bytes, and a double of the given name at each vertex.
///
/// # Errors
/// The file cannot be written, or there is not one paint for each vertex.
pub fn write(path: &Path, mesh: &MeshRecord, name: &str, paint: &[Painted]) -> Result<(), FormatError> {
    at(path, || create(path, |out| write_to(out, mesh, name, paint)))
}

/// [`write()`] to any writer.
///
/// # Errors
/// As [`write()`].
pub fn write_to(mut out: impl Write, mesh: &MeshRecord, name: &str, paint: &[Painted]) -> Result<(), Problem> {
    if paint.len() != mesh.vertices.len() {
        return Err(Problem::WrongCount { field: "paint", expected: mesh.vertices.len(), found: paint.len() });
    }
    let longest = mesh.faces.iter().map(Vec::len).max().unwrap_or(0);
    let length = if longest < 256 { ScalarType::UChar } else { ScalarType::UInt };
    let scalar = |name, scalar| (name, PropertyType::Scalar(scalar));
    let [x, y, z] = ["x", "y", "z"].map(|axis| scalar(axis, ScalarType::Double));
    let [red, green, blue] = ["red", "green", "blue"].map(|channel| scalar(channel, ScalarType::UChar));
    let vertex = element("vertex", paint.len(), [x, y, z, red, green, blue, scalar(name, ScalarType::Double)]);
    let indices = ("vertex_indices", PropertyType::List(length, ScalarType::UInt));
    let face = element("face", mesh.faces.len(), [indices]);
    let mut header = Header::new();
    header.encoding = Encoding::BinaryLittleEndian;
    header.version = Version { major: 1, minor: 0 };
    header.elements.add(vertex.clone());
    header.elements.add(face.clone());
    let (vertices, faces) = (Writer::<PaintedVertex>::new(), Writer::<FaceRow<'_>>::new());
    vertices.write_header(&mut out, &header)?;
    for (&position, &paint) in mesh.vertices.iter().zip(paint) {
        vertices.write_little_endian_element(&mut out, &PaintedVertex { position, paint }, &vertex)?;
    }
    for corners in &mesh.faces {
        faces.write_little_endian_element(&mut out, &FaceRow(corners), &face)?;
    }
    Ok(out.flush()?)
}

struct PaintedVertex {
    position: [f64; 3],
    paint: Painted,
}

impl PropertyAccess for PaintedVertex {
    fn new() -> PaintedVertex {
        PaintedVertex { position: [0.0; 3], paint: Painted { colour: [0; 3], number: 0.0 } }
    }

    fn get_double(&self, name: &str) -> Option<f64> {
        let [x, y, z] = self.position;
        match name {
            "x" => Some(x),
            "y" => Some(y),
            "z" => Some(z),
            _ => Some(self.paint.number),
        }
    }

    fn get_uchar(&self, name: &str) -> Option<u8> {
        let [red, green, blue] = self.paint.colour;
        match name {
            "red" => Some(red),
            "green" => Some(green),
            "blue" => Some(blue),
            _ => None,
        }
    }
}

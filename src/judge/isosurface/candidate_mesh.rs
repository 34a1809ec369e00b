//! A candidate's mesh, as it came.

use crate::answer::value::{self, InvalidField, Step};
use crate::format::MeshRecord;
use crate::number::{Rational, binary};
use serde_json::Value;

/// A candidate's mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct CandidateMesh {
    /// Its vertices.
    pub positions: Positions,
    /// Its triangles.
    pub triangles: Vec<[u32; 3]>,
}

/// Vertex positions as they came.
#[derive(Clone, Debug, PartialEq)]
pub enum Positions {
    /// From a message: exact numbers.
    Exact(Vec<[Rational; 3]>),
    /// From a file: binary64 or binary32 numbers, perhaps not finite.
    Floats(Vec<[f64; 3]>),
}

impl Positions {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Positions::Exact(positions) => positions.len(),
            Positions::Floats(positions) => positions.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The exact position of a vertex; `None` if it is not finite.
    pub fn exact(&self, vertex: usize) -> Option<[Rational; 3]> {
        match self {
            Positions::Exact(positions) => Some(positions[vertex].clone()),
            Positions::Floats(positions) => {
                let [x, y, z] = positions[vertex].map(Rational::from_f64);
                Some([x?, y?, z?])
            }
        }
    }

    /// The position of a vertex, rounded.
    pub fn rounded(&self, vertex: usize) -> [f64; 3] {
        match self {
            Positions::Exact(positions) => positions[vertex].each_ref().map(binary::nearest_f64),
            Positions::Floats(positions) => positions[vertex],
        }
    }
}

/// A mesh as a candidate says it: `{"vertices":[[x,y,z],…],"faces":[[0,1,2],…]}`, or `{"file":"m.ply"}`.
pub fn mesh(out: &Value) -> Result<CandidateMesh, InvalidField> {
    let object = value::object(out)?;
    if let Some(path) = value::optional(object, "file", |file| value::string(file).map(str::to_owned))? {
        let record = crate::format::read_mesh(std::path::Path::new(&path))
            .map_err(|error| InvalidField::here(value::Problem::File(Box::new(error))).within(Step::Field("file")))?;
        return from_record(record).map_err(|problem| InvalidField::here(problem).within(Step::Field("file")));
    }
    let positions = value::field(object, "vertices", |list| value::items(list, |v| value::exactly(v, coordinate)))?;
    let triangles = value::field(object, "faces", |list| value::items(list, |face| value::exactly(face, index)))?;
    Ok(CandidateMesh { positions: Positions::Exact(positions), triangles })
}

/// A mesh from a file.
///
/// # Errors
/// A face that is no triangle.
pub fn from_record(record: MeshRecord) -> Result<CandidateMesh, value::Problem> {
    let triangle = |face: &Vec<u32>| <[u32; 3]>::try_from(face.as_slice());
    let triangles = record.faces.iter().map(triangle).collect::<Result<_, _>>();
    let longest = record.faces.iter().map(Vec::len).find(|&n| n != 3).unwrap_or(3);
    let triangles = triangles.map_err(|_| value::Problem::Length { expected: 3, found: longest })?;
    Ok(CandidateMesh { positions: Positions::Floats(record.vertices), triangles })
}

/// A coordinate: a number, or the middle of an enclosure.
fn coordinate(value: &Value) -> Result<Rational, InvalidField> {
    match value.as_object() {
        Some(enclosure) => {
            let lo = value::field(enclosure, "lo", value::number)?;
            let hi = value::field(enclosure, "hi", value::number)?;
            Ok((lo + hi) / 2)
        }
        None => value::number(value),
    }
}

/// A vertex number. One that cannot be one names no vertex, which the verdict will tell.
fn index(value: &Value) -> Result<u32, InvalidField> {
    let number = value::number(value)?;
    Ok(if number.is_integer() { number.numer().to_u32().unwrap_or(u32::MAX) } else { u32::MAX })
}

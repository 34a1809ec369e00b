//! Gluing schemes in files: as text, or as JSON as the protocol has it.

use super::complex;
use super::value::{InvalidField, Object};
use crate::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, SignedEdge};
use crate::complex::zoo::Specimen;
use crate::format::scheme::{self, PairingRecord, PolyhedronRecord, SchemeRecord, SchemeTextError};
use thiserror::Error;

/// Why a file is no scheme.
#[derive(Debug, Error)]
pub enum SchemeFileError {
    /// Text that is none.
    #[error(transparent)]
    Text(#[from] SchemeTextError),
    /// It begins with `{`, but is no JSON.
    #[error("not JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// JSON without the fields of a scheme.
    #[error(transparent)]
    Field(#[from] InvalidField),
}

/// Reads a scheme: JSON if the first character that is no space is `{`, and the text of [`format::scheme`](crate::format::scheme) otherwise.
///
/// # Errors
/// Iff it cannot be read. What can be read is not checked further here.
pub fn read(bytes: &[u8]) -> Result<GluingScheme, SchemeFileError> {
    match bytes.trim_ascii_start().first() {
        Some(b'{') => Ok(complex::scheme(&serde_json::from_slice::<Object>(bytes)?)?),
        Some(_) | None => Ok(GluingScheme::from(scheme::read(bytes)?)),
    }
}

/// Writes a scheme as text that reads back as the same scheme.
pub fn write(scheme: &GluingScheme) -> String {
    scheme::write(&SchemeRecord::from(scheme))
}

/// A specimen of the zoo as text, what is known of it in comments.
pub fn specimen(Specimen { name, space, about, cells: [v, e, f, p], orientable, h1, scheme }: &Specimen) -> String {
    let sides = if *orientable { "orientable" } else { "not orientable" };
    format!("# {name}: {space}\n# {about}\n# {sides}, H₁ = {h1}; V = {v}, E = {e}, F = {f}, P = {p}\n{}", write(scheme))
}

/// The name of a specimen's file in the folder `zoo/`: letters, digits, `+` and `~` stay, runs of others are `-`.
pub fn file_name(specimen: &str) -> String {
    let words = specimen.split(|c: char| !(c.is_ascii_alphanumeric() || "+~".contains(c)));
    format!("{}.txt", words.filter(|word| !word.is_empty()).collect::<Vec<_>>().join("-"))
}

impl From<SchemeRecord> for GluingScheme {
    fn from(record: SchemeRecord) -> GluingScheme {
        let polyhedron = |record| match record {
            PolyhedronRecord::Cycles(cycles) => Polyhedron::of_vertex_cycles(&cycles),
            PolyhedronRecord::Sides { edges, faces } => {
                let sides = |face: Vec<i32>| face.into_iter().map(SignedEdge).collect();
                Polyhedron { edges, faces: faces.into_iter().map(sides).collect() }
            }
        };
        let face = |[polyhedron, face]: [usize; 2]| FaceId { polyhedron, face };
        let pairing = |PairingRecord { a, b, shift, dir }| Pairing { a: face(a), b: face(b), shift, dir };
        GluingScheme {
            polyhedra: record.polyhedra.into_iter().map(polyhedron).collect(),
            pairings: record.pairings.into_iter().map(pairing).collect(),
        }
    }
}

impl From<&GluingScheme> for SchemeRecord {
    /// Polyhedra are written by the cycles of their vertices where these say everything.
    fn from(scheme: &GluingScheme) -> SchemeRecord {
        let polyhedron = |p: &Polyhedron| {
            let faces = p.faces.iter().map(|face| face.iter().map(|side| side.0).collect()).collect();
            let cycle = |face: &Vec<SignedEdge>| face.iter().map(|side| p.ends(*side).map(|[from, _]| from)).collect();
            match p.faces.iter().map(cycle).collect::<Option<Vec<Vec<u32>>>>() {
                Some(cycles) if !cycles.is_empty() && Polyhedron::of_vertex_cycles(&cycles) == *p => {
                    PolyhedronRecord::Cycles(cycles)
                }
                Some(_) | None => PolyhedronRecord::Sides { edges: p.edges.clone(), faces },
            }
        };
        let face = |id: FaceId| [id.polyhedron, id.face];
        let pairing = |p: &Pairing| PairingRecord { a: face(p.a), b: face(p.b), shift: p.shift, dir: p.dir };
        SchemeRecord {
            polyhedra: scheme.polyhedra.iter().map(polyhedron).collect(),
            pairings: scheme.pairings.iter().map(pairing).collect(),
        }
    }
}

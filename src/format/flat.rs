//! A mesh in flat arrays: what every reader makes first.

use super::{MeshRecord, Precision, Problem};

/// A mesh as a file has it, without a list a face: ten million triangles take 280 MB, not 800.
#[derive(Clone, Debug, PartialEq)]
pub struct FlatMesh {
    /// Positions, in the file's order; unused, repeated and non-finite ones are kept.
    pub vertices: Vec<[f64; 3]>,
    /// The 0-based vertex indices of all polygons, one polygon after another.
    pub corners: Vec<u32>,
    /// Where each polygon ends in `corners`.
    pub ends: Vec<u32>,
    /// The width of the stored positions.
    pub precision: Precision,
    /// Whether the format has no shared vertices (STL).
    pub soup: bool,
}

impl FlatMesh {
    /// Nothing yet.
    pub fn new(precision: Precision) -> FlatMesh {
        FlatMesh { vertices: Vec::new(), corners: Vec::new(), ends: Vec::new(), precision, soup: false }
    }

    /// Ends the face whose corners have been pushed.
    ///
    /// # Errors
    /// More corners than 2³² − 1.
    pub(super) fn end_face(&mut self) -> Result<(), Problem> {
        let end = u32::try_from(self.corners.len()).map_err(|_| Problem::Invalid {
            field: format!("face {}", self.ends.len()),
            expected: "fewer than 2³² corners in all",
            found: format!("{} of them", self.corners.len()),
        })?;
        self.ends.push(end);
        Ok(())
    }
}

impl From<FlatMesh> for MeshRecord {
    fn from(flat: FlatMesh) -> MeshRecord {
        let starts = std::iter::once(&0).chain(&flat.ends);
        let faces = starts.zip(&flat.ends).map(|(&start, &end)| flat.corners[start as usize..end as usize].to_vec());
        MeshRecord { faces: faces.collect(), vertices: flat.vertices, precision: flat.precision, soup: flat.soup }
    }
}

//! A mesh in flat arrays: what a large file is read into.

use super::Point;
use crate::linear::Vector;
use crate::mesh::face::Face;
use crate::mesh::vertex_list::VertexList;
use crate::number::Rational;
use thiserror::Error;

/// A mesh of polygons without holes, whose positions are finite binary64 numbers, each taken exactly.
///
/// Nothing else is promised: a loop may be empty, or name a vertex twice, or one that does not exist.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygons {
    vertices: Vec<Point>,
    corners: Vec<u32>,
    ends: Vec<u32>,
}

/// Why three arrays are no [`Polygons`].
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Unsound {
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex}: {axis} is {value}, no number that a point can have")]
    NotFinite {
        /// The vertex.
        vertex: usize,
        /// x, y or z.
        axis: char,
        /// NaN, or an infinity.
        value: f64,
    },
    /// More corners, faces or vertices than 32-bit numbers can tell apart.
    #[error("{found} {what}, but fewer than 2³² can be numbered")]
    TooMany {
        /// Of what there are too many.
        what: &'static str,
        /// How many there are.
        found: usize,
    },
    /// The ends of the faces do not cut the corners into loops.
    #[error("face {face}: its loop ends at corner {end}, which is before its beginning or beyond the last corner")]
    Ends {
        /// The face; the number of faces, where corners are left after the last of them.
        face: usize,
        /// Its end.
        end: u32,
    },
}

impl Polygons {
    /// Loop f is `corners[ends[f − 1]..ends[f]]`, the first one beginning at 0.
    ///
    /// # Errors
    /// `NotFinite`, `TooMany` (2³² or more of anything), `Ends` iff `ends` decreases or its last is not the number of corners.
    pub fn new(vertices: Vec<Point>, corners: Vec<u32>, ends: Vec<u32>) -> Result<Polygons, Unsound> {
        for (what, found) in [("vertices", vertices.len()), ("corners", corners.len()), ("faces", ends.len())] {
            if u32::try_from(found).is_err() {
                return Err(Unsound::TooMany { what, found });
            }
        }
        for (vertex, position) in vertices.iter().enumerate() {
            for (axis, &value) in ['x', 'y', 'z'].into_iter().zip(position) {
                if !value.is_finite() {
                    return Err(Unsound::NotFinite { vertex, axis, value });
                }
            }
        }
        let mut start = 0;
        for (face, &end) in ends.iter().enumerate() {
            if end < start || end as usize > corners.len() {
                return Err(Unsound::Ends { face, end });
            }
            start = end;
        }
        if start as usize != corners.len() {
            return Err(Unsound::Ends { face: ends.len(), end: start });
        }
        Ok(Polygons { vertices, corners, ends })
    }

    /// Positions, by vertex number.
    pub fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// The vertices of all loops, one loop after another.
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// The number of faces.
    pub fn faces(&self) -> usize {
        self.ends.len()
    }

    /// The corners of a face, as a range into [`Polygons::corners`].
    pub fn range(&self, face: usize) -> std::ops::Range<usize> {
        let start = if face == 0 { 0 } else { self.ends[face - 1] };
        start as usize..self.ends[face] as usize
    }

    /// The loop of a face.
    pub fn face(&self, face: usize) -> &[u32] {
        &self.corners[self.range(face)]
    }

    /// The loops of all faces.
    pub fn loops(&self) -> impl Iterator<Item = &[u32]> {
        let mut start = 0;
        self.ends.iter().map(move |&end| {
            let face = &self.corners[start..end as usize];
            start = end as usize;
            face
        })
    }

    /// The number of corners of every face, where it is the same one.
    pub fn uniform(&self) -> Option<u32> {
        let first = *self.ends.first()?;
        let same = |(face, &end): (usize, &u32)| u64::from(end) == u64::from(first) * (face as u64 + 1);
        (first > 0 && self.ends.iter().enumerate().all(same)).then_some(first)
    }

    /// The same mesh with each position's vertices taken for one, the first of them, and the number of vertices that
    /// are left. Vertices that no face uses stay.
    pub fn welded(mut self) -> Polygons {
        let first = super::equal::first_at_position(&self.vertices);
        let mut kept = 0;
        let mut number = vec![0; self.vertices.len()];
        for vertex in 0..self.vertices.len() {
            if first[vertex] as usize == vertex {
                self.vertices[kept] = self.vertices[vertex];
                number[vertex] = kept as u32;
                kept += 1;
            } else {
                number[vertex] = number[first[vertex] as usize];
            }
        }
        self.vertices.truncate(kept);
        for corner in &mut self.corners {
            // One that does not exist stays one.
            *corner = number.get(*corner as usize).copied().unwrap_or(u32::MAX);
        }
        self
    }

    /// The same mesh with rational positions and a list a face, for the plain versions.
    pub fn plain(&self) -> VertexList {
        VertexList { vertices: self.vertices.iter().map(exact).collect(), faces: self.loops().map(Face::new).collect() }
    }
}

/// The exact position.
pub fn exact(point: &Point) -> Vector<Rational, 3> {
    Vector(point.map(|x| Rational::from_f64(x).expect("positions are finite")))
}

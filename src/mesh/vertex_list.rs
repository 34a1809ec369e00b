//! The vertex list: each position once, and polygons by the numbers of their vertices.

use super::face::Face;
use crate::linear::Vector;
use crate::number::Rational;

/// A position in space.
pub type Point = Vector<Rational, 3>;

/// A mesh by its list of vertices and its list of polygons. Nothing is promised but the types.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct VertexList {
    /// Positions, by vertex number.
    pub vertices: Vec<Point>,
    /// Polygons.
    pub faces: Vec<Face>,
}

//! Meshes to try things on.

pub mod laminae;
pub mod solids;
pub mod surfaces;

use super::face::Face;
use super::vertex_list::{Point, VertexList};
use crate::linear::Vector;
use crate::number::Rational;

/// A point with integer coordinates.
pub fn point(at: [i64; 3]) -> Point {
    Vector(at.map(Rational::from))
}

/// The mesh with integer coordinates and faces without holes.
pub fn mesh<V: AsRef<[u32]>>(vertices: &[[i64; 3]], faces: &[V]) -> VertexList {
    VertexList {
        vertices: vertices.iter().copied().map(point).collect(),
        faces: faces.iter().map(|loop_| Face::new(loop_.as_ref())).collect(),
    }
}

/// The cube [0, 1]³: 8 vertices, 12 edges, 6 squares, counterclockwise from outside.
#[doc(alias = "ME-77")]
pub fn cube() -> VertexList {
    mesh(
        &[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
        &[[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
    )
}

/// A tetrahedron: 4 vertices, 6 edges, 4 triangles, counterclockwise from outside.
pub fn tetrahedron() -> VertexList {
    mesh(&[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
}

/// A torus of m × n quadrilaterals, mn vertices and 2mn edges, consistently oriented. The positions (i, j, ij) differ,
/// but are no embedding.
///
/// # Panics
/// Iff m or n is less than 3.
pub fn quad_torus(m: u32, n: u32) -> VertexList {
    assert!(m >= 3 && n >= 3, "less than 3 in a row is no row of quadrilaterals");
    let number = |i: u32, j: u32| i % m * n + j % n;
    let grid = || (0..m).flat_map(|i| (0..n).map(move |j| (i, j)));
    VertexList {
        vertices: grid().map(|(i, j)| point([i, j, i * j].map(i64::from))).collect(),
        faces: grid()
            .map(|(i, j)| Face::from([number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)]))
            .collect(),
    }
}

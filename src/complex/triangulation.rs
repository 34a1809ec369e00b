//! Tetrahedra glued triangle to triangle; several corners of one tetrahedron may be one vertex.

use super::permutation::Perm4;
use crate::partition::Partition;
use thiserror::Error;

/// How a triangle of a tetrahedron is glued: corner i of this tetrahedron to corner `corners`(i) of the other, for the three
/// corners of the triangle; the fourth image is the corner opposite the other triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TriangleGluing {
    /// The other tetrahedron, which may be the same one.
    pub tetrahedron: u32,
    /// Where the corners go.
    pub corners: Perm4,
}

/// A closed triangulation: each triangle of each tetrahedron is glued to one other. Triangle i of a tetrahedron lies opposite
/// its corner i; its edges are numbered 01, 02, 03, 12, 13, 23 ([`EDGES`]).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Triangulation {
    gluings: Vec<[TriangleGluing; 4]>,
}

/// The corners of the edges of a tetrahedron.
pub const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

/// Why gluings make no closed triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum TriangulationError {
    /// A gluing with a tetrahedron that does not exist.
    #[error("triangle {triangle} of tetrahedron {tetrahedron} is glued to a tetrahedron that does not exist")]
    NoSuchTetrahedron {
        /// The tetrahedron.
        tetrahedron: usize,
        /// The triangle.
        triangle: usize,
    },
    /// A gluing that the other side does not know, or a triangle glued to itself.
    #[error("triangle {triangle} of tetrahedron {tetrahedron} is glued one way only")]
    OneWay {
        /// The tetrahedron.
        tetrahedron: usize,
        /// The triangle.
        triangle: usize,
    },
}

/// The cells that the parts of the tetrahedra have become.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skeleton {
    /// The vertex at each corner of each tetrahedron.
    pub vertices: Vec<[u32; 4]>,
    /// The edge of each edge of each tetrahedron.
    pub edges: Vec<[u32; 6]>,
    /// The triangle of each triangle of each tetrahedron.
    pub triangles: Vec<[u32; 4]>,
    /// How many vertices, edges, triangles, tetrahedra there are.
    pub counts: [usize; 4],
}

impl Triangulation {
    /// The triangulation with these gluings, by tetrahedron, then by triangle.
    ///
    /// # Errors
    /// Iff a gluing names a tetrahedron that does not exist, or is not undone by that of the triangle it leads to.
    pub fn new(gluings: Vec<[TriangleGluing; 4]>) -> Result<Triangulation, TriangulationError> {
        for (tetrahedron, triangles) in gluings.iter().enumerate() {
            for (triangle, gluing) in triangles.iter().enumerate() {
                let other_triangle = gluing.corners.image(triangle);
                let Some(other) = gluings.get(gluing.tetrahedron as usize) else {
                    return Err(TriangulationError::NoSuchTetrahedron { tetrahedron, triangle });
                };
                let back = TriangleGluing { tetrahedron: tetrahedron as u32, corners: gluing.corners.inverse() };
                if other[other_triangle] != back
                    || (back.tetrahedron == gluing.tetrahedron && other_triangle == triangle)
                {
                    return Err(TriangulationError::OneWay { tetrahedron, triangle });
                }
            }
        }
        Ok(Triangulation { gluings })
    }

    /// How many tetrahedra there are.
    pub fn len(&self) -> usize {
        self.gluings.len()
    }

    /// Whether there is no tetrahedron.
    pub fn is_empty(&self) -> bool {
        self.gluings.is_empty()
    }

    /// The gluings, by tetrahedron, then by triangle.
    pub fn gluings(&self) -> &[[TriangleGluing; 4]] {
        &self.gluings
    }

    /// Its cells: classes of corners, edges and triangles, numbered by their first members.
    pub fn skeleton(&self) -> Skeleton {
        let n = self.len();
        let (mut corners, mut edges, mut triangles) =
            (Partition::new(4 * n), Partition::new(6 * n), Partition::new(4 * n));
        for (tetrahedron, gluings) in self.gluings.iter().enumerate() {
            for (triangle, gluing) in gluings.iter().enumerate() {
                let other = gluing.tetrahedron as usize;
                triangles.join(4 * tetrahedron + triangle, 4 * other + gluing.corners.image(triangle));
                for i in (0..4).filter(|i| *i != triangle) {
                    corners.join(4 * tetrahedron + i, 4 * other + gluing.corners.image(i));
                }
                for (edge, [i, j]) in EDGES.iter().enumerate().filter(|(_, ends)| !ends.contains(&triangle)) {
                    let image = edge_between(gluing.corners.image(*i), gluing.corners.image(*j));
                    edges.join(6 * tetrahedron + edge, 6 * other + image);
                }
            }
        }
        let (vertices, v) = numbered::<4>(&mut corners, n);
        let (edges, e) = numbered::<6>(&mut edges, n);
        let (triangles, f) = numbered::<4>(&mut triangles, n);
        Skeleton { vertices, edges, triangles, counts: [v, e, f, n] }
    }
}

/// The edge of a tetrahedron between two of its corners, in either order.
pub fn edge_between(i: usize, j: usize) -> usize {
    let ends = [i.min(j), i.max(j)];
    EDGES.iter().position(|edge| *edge == ends).expect("two different corners")
}

fn numbered<const N: usize>(classes: &mut Partition, n: usize) -> (Vec<[u32; N]>, usize) {
    let (numbers, count) = classes.numbered();
    ((0..n).map(|row| std::array::from_fn(|column| numbers[N * row + column])).collect(), count)
}

//! Gauss and Bonnet's theorem for triangle meshes, proved for each mesh, not measured (IS-72, ME-118 … ME-125).
//!
//! An angle β of a triangle with rational corners is the argument of a number of ℚ(√−N): between the sides p and q
//! of the corner, ⟨p,q⟩ + |p×q| i, and |p×q| = √N is twice the triangle's area at all three corners. Angles add as these
//! numbers multiply, so what angles sum up to is decided by exact products.

mod curvature;
mod direction;
mod index;
mod multiple_of_pi;
mod polygon;

pub use curvature::Curvature;
pub use direction::{CornerAngle, half_turns};
pub use multiple_of_pi::multiple_of_pi;
pub use polygon::{PolygonAngle, PolygonAngleMesh, PolygonError};

use super::face::{edge, sides};
use super::triangles::{EdgeKey, Triangle};
use crate::linear::Vector;
use crate::number::{Interval, Rational};
use std::collections::BTreeMap;
use thiserror::Error;

/// A triangle mesh with rational positions and no degenerate triangle. It may intersect itself, and need be no surface.
#[derive(Clone, Debug)]
pub struct AngleMesh {
    positions: Vec<Vector<Rational, 3>>,
    triangles: Vec<Triangle>,
    /// By vertex.
    corners: Vec<Vec<Corner>>,
    /// How many triangles each edge is in.
    edges: BTreeMap<EdgeKey, u32>,
    /// How many edges each vertex has.
    degrees: Vec<u32>,
}

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Corner {
    /// The triangle.
    pub triangle: usize,
    /// Which of its corners, 0, 1 or 2.
    pub place: usize,
}

/// Why a mesh has no angles, or no such theorem.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum AngleError {
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names a vertex that does not exist")]
    IndexOutOfRange {
        /// The triangle.
        triangle: usize,
    },
    /// A triangle names a vertex twice.
    #[error("triangle {triangle} names vertex {vertex} twice")]
    RepeatedVertex {
        /// The triangle.
        triangle: usize,
        /// The vertex.
        vertex: u32,
    },
    /// A triangle without area.
    #[error("triangle {triangle} is degenerate: its corners are on one line")]
    Degenerate {
        /// The triangle.
        triangle: usize,
    },
    /// An edge of another number of triangles than two.
    #[error("the edge from {} to {} is in {triangles} triangles, not in two", .edge[0], .edge[1])]
    NotClosed {
        /// The edge.
        edge: EdgeKey,
        /// How many triangles it is in.
        triangles: u32,
    },
    /// An edge of more than two triangles.
    #[error("the edge from {} to {} is in {triangles} triangles, more than two", .edge[0], .edge[1])]
    NotASurface {
        /// The edge.
        edge: EdgeKey,
        /// How many triangles it is in.
        triangles: u32,
    },
    /// A vertex of more than two edges of the border.
    #[error("vertex {vertex} is on {edges} edges of the border, more than two")]
    PinchedBorder {
        /// The vertex.
        vertex: u32,
        /// How many edges of the border it is on.
        edges: u32,
    },
}

/// ΣK = 2πχ, with what each side is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GaussBonnet {
    /// The sum of the curvatures, as a multiple of π, by the exact sums of the triangles' angles.
    pub half_turns: i64,
    /// χ = #2 − #1 + #0, by counting.
    pub chi: i64,
}

impl AngleMesh {
    /// The mesh.
    ///
    /// # Errors
    /// `IndexOutOfRange`, `RepeatedVertex` or `Degenerate` for the first such triangle.
    pub fn new(positions: Vec<Vector<Rational, 3>>, triangles: Vec<Triangle>) -> Result<AngleMesh, AngleError> {
        let mut corners = vec![Vec::new(); positions.len()];
        for (triangle, vertices) in triangles.iter().enumerate() {
            if vertices.iter().any(|&v| v as usize >= positions.len()) {
                return Err(AngleError::IndexOutOfRange { triangle });
            }
            let [a, b, c] = *vertices;
            if a == b || c == a || b == c {
                return Err(AngleError::RepeatedVertex { triangle, vertex: if b == c { b } else { a } });
            }
            if corner_angle(&positions, vertices, 0).n.is_zero() {
                return Err(AngleError::Degenerate { triangle });
            }
            for (place, v) in vertices.iter().enumerate() {
                corners[*v as usize].push(Corner { triangle, place });
            }
        }
        let (mut edges, mut degrees) = (BTreeMap::new(), vec![0; positions.len()]);
        for side in triangles.iter().flat_map(|triangle| sides(triangle)) {
            *edges.entry(edge(side)).or_default() += 1;
        }
        edges.keys().flatten().for_each(|v| degrees[*v as usize] += 1);
        Ok(AngleMesh { positions, triangles, corners, edges, degrees })
    }

    /// How many vertices it has, those of no triangle too.
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// The corners at a vertex, sorted.
    ///
    /// # Panics
    /// Iff there is no such vertex.
    pub fn corners(&self, vertex: u32) -> &[Corner] {
        &self.corners[vertex as usize]
    }

    fn angle(&self, triangle: usize, place: usize) -> CornerAngle {
        corner_angle(&self.positions, &self.triangles[triangle], place)
    }

    /// The angles of a triangle, in the order of its corners.
    ///
    /// # Panics
    /// Iff there is no such triangle.
    pub fn angles(&self, triangle: usize) -> [CornerAngle; 3] {
        [0, 1, 2].map(|place| self.angle(triangle, place))
    }

    /// The angle deficit 2π − Σβ of a vertex, enclosed with that many bits; it is the vertex' curvature where a surface
    /// goes on around it.
    ///
    /// # Panics
    /// Iff there is no such vertex.
    pub fn deficit(&self, vertex: u32, precision: u32) -> Interval {
        Curvature { half_turns: 2, ..self.curvature(vertex) }.enclosure(precision)
    }

    /// The sum of all angles, as a multiple of π: each triangle's, by exact products.
    fn angle_sum_in_half_turns(&self) -> i64 {
        let of_triangle = |t: usize| half_turns(&self.angles(t)).expect("the angles of a triangle sum up to π");
        (0..self.triangles.len()).map(of_triangle).sum()
    }

    /// Σ (2π − Σβ) over all vertices, as a multiple of π. Where the mesh has a border this is not the total curvature.
    pub fn total_deficit_in_half_turns(&self) -> i64 {
        2 * self.positions.len() as i64 - self.angle_sum_in_half_turns()
    }

    /// χ = #2 − #1 + #0, the vertices of no triangle counted too.
    pub fn euler_characteristic(&self) -> i64 {
        self.triangles.len() as i64 - self.edges.len() as i64 + self.positions.len() as i64
    }

    /// The theorem for a closed mesh, Σ (2π − Σβ) = 2πχ: `half_turns` is 2·`chi`. Needs no embedding, no orientation, and
    /// nothing of vertices. For a sphere it is Descartes' theorem (ME-121).
    ///
    /// # Errors
    /// `NotClosed` for the least edge that is not in exactly two triangles.
    #[doc(alias = "IS-72")]
    #[doc(alias = "ME-121")]
    pub fn gauss_bonnet(&self) -> Result<GaussBonnet, AngleError> {
        match self.edges.iter().find(|(_, triangles)| **triangles != 2) {
            Some((&edge, &triangles)) => Err(AngleError::NotClosed { edge, triangles }),
            None => {
                let half_turns = self.total_deficit_in_half_turns();
                Ok(GaussBonnet { half_turns, chi: self.euler_characteristic() })
            }
        }
    }
}

fn corner_angle(positions: &[Vector<Rational, 3>], triangle: &Triangle, place: usize) -> CornerAngle {
    let at = |k: usize| &positions[triangle[(place + k) % 3] as usize];
    let [p, q] = [1, 2].map(|k| at(k).clone() - at(0));
    CornerAngle { x: p.dot(&q), n: p.cross(&q).norm_squared() }
}

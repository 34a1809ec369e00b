//! Gauss and Bonnet's theorem for closed triangle meshes, proved for each mesh, not measured (IS-72).
//!
//! An angle β of a triangle with rational corners is the argument of a number of ℚ(√−N): between the sides p and q
//! of the corner, ⟨p,q⟩ + |p×q| i, and |p×q| = √N is twice the triangle's area at all three corners. Angles add as these
//! numbers multiply, so what angles sum up to is decided by exact products.

use super::triangles::{EdgeKey, Triangle, edge_uses, sides};
use crate::linear::Vector;
use crate::number::{Interval, Rational, Ring, Sign};
use std::collections::BTreeSet;
use thiserror::Error;

/// The angle of a triangle's corner, in (0, π): that of the direction x + √N i. Not ordered, nor compared: the same
/// angle has many directions.
#[derive(Clone, Debug)]
pub struct CornerAngle {
    /// x = ⟨p,q⟩ for the sides p, q from the corner.
    pub x: Rational,
    /// N = |p×q|² > 0.
    pub n: Rational,
}

impl CornerAngle {
    /// An enclosure of the angle in radians, of that many bits.
    pub fn enclosure(&self, precision: u32) -> Interval {
        let y = Interval::from_rational(&self.n, precision).sqrt().expect("N > 0");
        Interval::argument(&Interval::from_rational(&self.x, precision), &y).expect("√N > 0")
    }
}

/// What the three angles of a triangle sum up to, as a number of half turns π: it is 1, and this proves it for the
/// triangle. `None` iff the angles, not being those of a triangle, sum up to no multiple of π.
///
/// With xᵢ + √N i for the angles, the product is x₀x₁x₂ − N(x₀+x₁+x₂) + (x₀x₁ + x₁x₂ + x₂x₀ − N)√N i. It is real iff
/// the sum is a multiple of π; each angle is in (0, π), so the sum is π if it is negative, 2π if it is positive.
///
/// # Panics
/// Iff the three N are not equal.
pub fn half_turns([a, b, c]: &[CornerAngle; 3]) -> Option<i64> {
    assert!(a.n == b.n && b.n == c.n, "the corners of one triangle have one N");
    let (x0, x1, x2, n) = (&a.x, &b.x, &c.x, &a.n);
    let product = |x: &Rational, y: &Rational| Rational::from(x * y);
    let imaginary = product(x0, x1) + product(x1, x2) + product(x2, x0) - n;
    let real = product(x0, x1) * x2 - (Rational::from(x0 + x1) + x2) * n;
    match (Sign::of(imaginary.cmp0()), Sign::of(real.cmp0())) {
        (Sign::Zero, Sign::Negative) => Some(1),
        (Sign::Zero, Sign::Positive) => Some(2),
        (Sign::Zero, Sign::Zero) => unreachable!("no factor of the product is 0"),
        (Sign::Negative | Sign::Positive, _) => None,
    }
}

/// A triangle mesh with rational positions and no degenerate triangle. It may intersect itself.
#[derive(Clone, Debug)]
pub struct AngleMesh {
    positions: Vec<Vector<Rational, 3>>,
    triangles: Vec<Triangle>,
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
}

/// Σ (2π − Σβ) = 2πχ, with what each side is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GaussBonnet {
    /// The sum of the angle deficits, as a multiple of π, by the exact sums of the triangles' angles.
    pub half_turns: i64,
    /// χ = #2 − #1 + #0, by counting.
    pub chi: i64,
}

impl AngleMesh {
    /// The mesh.
    ///
    /// # Errors
    /// `IndexOutOfRange` or `Degenerate` for the first such triangle.
    pub fn new(positions: Vec<Vector<Rational, 3>>, triangles: Vec<Triangle>) -> Result<AngleMesh, AngleError> {
        let mesh = AngleMesh { positions, triangles };
        for (triangle, corners) in mesh.triangles.iter().enumerate() {
            if corners.iter().any(|&v| v as usize >= mesh.positions.len()) {
                return Err(AngleError::IndexOutOfRange { triangle });
            }
            if mesh.angle(corners, 0).n.is_zero() {
                return Err(AngleError::Degenerate { triangle });
            }
        }
        Ok(mesh)
    }

    fn angle(&self, triangle: &Triangle, corner: usize) -> CornerAngle {
        let at = |k: usize| &self.positions[triangle[(corner + k) % 3] as usize];
        let [p, q] = [1, 2].map(|k| at(k).clone() - at(0));
        CornerAngle { x: p.dot(&q), n: p.cross(&q).norm_squared() }
    }

    /// The angles of a triangle, in the order of its corners.
    ///
    /// # Panics
    /// Iff there is no such triangle.
    pub fn angles(&self, triangle: usize) -> [CornerAngle; 3] {
        [0, 1, 2].map(|corner| self.angle(&self.triangles[triangle], corner))
    }

    /// The angle deficit 2π − Σβ of a vertex, enclosed with that many bits.
    pub fn deficit(&self, vertex: u32, precision: u32) -> Interval {
        let full_turn = Interval::pi(precision) * &Interval::integer(2);
        self.triangles.iter().fold(full_turn, |deficit, triangle| match triangle.iter().position(|v| *v == vertex) {
            Some(corner) => deficit - &self.angle(triangle, corner).enclosure(precision),
            None => deficit,
        })
    }

    /// Σ (2π − Σβ) over all vertices, as a multiple of π: 2·#0 less the half turns of every triangle's three angles, by
    /// exact products. Where the mesh has a border this is not the total curvature.
    pub fn total_deficit_in_half_turns(&self) -> i64 {
        let of_triangle = |t: usize| half_turns(&self.angles(t)).expect("the angles of a triangle sum up to π");
        2 * self.positions.len() as i64 - (0..self.triangles.len()).map(of_triangle).sum::<i64>()
    }

    /// #2 − #1 + #0.
    pub fn euler_characteristic(&self) -> i64 {
        let edges: BTreeSet<EdgeKey> =
            self.triangles.iter().flat_map(|t| sides(*t)).map(|[a, b]| [a.min(b), a.max(b)]).collect();
        self.triangles.len() as i64 - edges.len() as i64 + self.positions.len() as i64
    }

    /// The theorem for this mesh: `half_turns` is 2·`chi`. Needs no embedding, no orientation, and nothing of vertices.
    ///
    /// # Errors
    /// `NotClosed` for the least edge that is not in exactly two triangles.
    #[doc(alias = "IS-72")]
    pub fn gauss_bonnet(&self) -> Result<GaussBonnet, AngleError> {
        let uses = edge_uses(&self.triangles).into_iter().map(|(edge, [up, down])| (edge, up + down));
        match uses.filter(|(_, triangles)| *triangles != 2).min() {
            Some((edge, triangles)) => Err(AngleError::NotClosed { edge, triangles }),
            None => {
                let half_turns = self.total_deficit_in_half_turns();
                Ok(GaussBonnet { half_turns, chi: self.euler_characteristic() })
            }
        }
    }
}

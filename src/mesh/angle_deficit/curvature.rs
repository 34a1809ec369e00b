//! The curvature of a vertex of any triangle complex, and its total.

use super::direction::CornerAngle;
use super::multiple_of_pi::multiple_of_pi;
use super::{AngleError, AngleMesh, GaussBonnet};
use crate::number::decimal::{DecimalEnclosure, Digits};
use crate::number::{Interval, Rational, Ring};

/// The curvature π·half_turns − Σβ of a vertex, in radians.
#[derive(Clone, Debug)]
pub struct Curvature {
    /// 2 − e + t for a vertex of e edges and t triangles: 2 where a surface goes on around it, 1 on the border of a
    /// surface, 2 for a vertex of no triangle.
    pub half_turns: i64,
    /// The angles β of the triangles at the vertex.
    pub angles: Vec<CornerAngle>,
}

impl Curvature {
    /// The curvature divided by π, where that is rational; `None` iff it is irrational.
    pub fn over_pi(&self) -> Option<Rational> {
        multiple_of_pi(&self.angles).map(|sum| Rational::from(self.half_turns) - sum)
    }

    /// An enclosure of the curvature, each step of that many bits.
    pub fn enclosure(&self, precision: u32) -> Interval {
        let half_turns = Interval::pi(precision) * &Interval::integer(self.half_turns);
        self.angles.iter().fold(half_turns, |rest, angle| rest - &angle.enclosure(precision))
    }

    /// Decimal strings around the curvature, as narrow as asked for; around 0 they are both 0.
    pub fn decimals(&self, digits: Digits) -> DecimalEnclosure {
        let over_pi = self.over_pi();
        // Each doubling halves the width at least, so one precision is enough in the end.
        let mut precision = 64 + 4 * digits.count();
        loop {
            let enclosure = match &over_pi {
                Some(multiple) => Interval::pi(precision) * &Interval::from_rational(multiple, precision),
                None => self.enclosure(precision),
            };
            match enclosure.decimals(digits) {
                Some(decimals) => return decimals,
                None => precision *= 2,
            }
        }
    }
}

impl AngleMesh {
    /// The curvature K(v) = π(2 − e + t) − Σβ of a vertex of e edges and t triangles; e is the number of its
    /// neighbours. Inside a surface that is 2π − Σβ, the angle deficit; on its border it is π − Σβ, by which the border
    /// turns there; where n pieces of a surface with a border meet in the vertex alone, it is (2 − n)π − Σβ.
    ///
    /// 2 − e + t is 2 − χ of the vertex' link, and K(v)/2π the mean of [`AngleMesh::index`] over all directions.
    ///
    /// # Panics
    /// Iff there is no such vertex.
    pub fn curvature(&self, vertex: u32) -> Curvature {
        let corners = self.corners(vertex);
        let half_turns = 2 - i64::from(self.degrees[vertex as usize]) + corners.len() as i64;
        Curvature {
            half_turns,
            angles: corners.iter().map(|corner| self.angle(corner.triangle, corner.place)).collect(),
        }
    }

    /// Gauss and Bonnet's theorem for any triangle complex, ΣK(v) = 2πχ: border, loose vertices, edges of three
    /// triangles, pinched vertices, triangles that stand twice, all are allowed. ME-118.
    ///
    /// Σ(2 − e + t) = 2#0 − 2#1 + 3#2, since an edge is at two vertices and a triangle at three; the angles take π
    /// a triangle from that.
    #[doc(alias = "ME-118")]
    pub fn total_curvature(&self) -> GaussBonnet {
        let at_vertex = |v: usize| 2 - i64::from(self.degrees[v]) + self.corners[v].len() as i64;
        let half_turns = (0..self.positions.len()).map(at_vertex).sum::<i64>() - self.angle_sum_in_half_turns();
        GaussBonnet { half_turns, chi: self.euler_characteristic() }
    }

    /// Gauss and Bonnet's theorem for a surface with a border, 2πχ = Σ(2π − Σβ) over the inner vertices + Σ(π − Σβ) over
    /// the vertices of the border; the second sum is what the border turns, its total geodesic curvature. ME-119.
    ///
    /// The vertices of the border are the ends of the edges of one triangle. A vertex of no triangle counts as inner.
    ///
    /// # Errors
    /// `NotASurface` for the least edge of more than two triangles, else `PinchedBorder` for the first vertex of more than
    /// two edges of the border: where the border meets itself, π is not its share.
    #[doc(alias = "ME-119")]
    pub fn gauss_bonnet_with_border(&self) -> Result<GaussBonnet, AngleError> {
        let mut border_edges = vec![0_u32; self.positions.len()];
        for (&edge, &triangles) in &self.edges {
            match triangles {
                1 => edge.iter().for_each(|v| border_edges[*v as usize] += 1),
                2 => {}
                _ => return Err(AngleError::NotASurface { edge, triangles }),
            }
        }
        let mut half_turns = -self.angle_sum_in_half_turns();
        for (vertex, &edges) in border_edges.iter().enumerate() {
            half_turns += match edges {
                0 => 2,
                2 => 1,
                // Each piece of the surface at the vertex has two edges of the border there, or none.
                _ => return Err(AngleError::PinchedBorder { vertex: vertex as u32, edges }),
            };
        }
        Ok(GaussBonnet { half_turns, chi: self.euler_characteristic() })
    }
}

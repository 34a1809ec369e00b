//! Banchoff's index of a vertex as a critical point of a height function.

use super::AngleMesh;
use crate::linear::Vector;
use crate::number::{Rational, Sign};
use std::collections::BTreeSet;

impl AngleMesh {
    /// The index 1 − e₋ + t₋ of a vertex for the height ⟨·, direction⟩: e₋ of its edges go to lower vertices, t₋ of its
    /// triangles have their two others lower. It is 1 at a pit of a surface, 1 at a peak, 0 where the surface passes by,
    /// −1 at a saddle. Over all vertices the indices sum up to χ, for each direction. ME-125.
    ///
    /// `None` iff a neighbour is as high as the vertex.
    ///
    /// # Panics
    /// Iff there is no such vertex.
    #[doc(alias = "ME-125")]
    pub fn index(&self, vertex: u32, direction: &Vector<Rational, 3>) -> Option<i64> {
        let height = |v: u32| self.positions[v as usize].dot(direction);
        let of_vertex = height(vertex);
        let is_lower = |v: u32| match Sign::of(height(v).cmp(&of_vertex)) {
            Sign::Zero => None,
            Sign::Negative => Some(true),
            Sign::Positive => Some(false),
        };
        let (mut lower_neighbours, mut lower_triangles) = (BTreeSet::new(), 0);
        for corner in self.corners(vertex) {
            let others = [1, 2].map(|k| self.triangles[corner.triangle][(corner.place + k) % 3]);
            let lower = [is_lower(others[0])?, is_lower(others[1])?];
            lower_neighbours.extend(others.into_iter().zip(lower).filter(|(_, is)| *is).map(|(v, _)| v));
            lower_triangles += i64::from(lower == [true, true]);
        }
        Some(1 - lower_neighbours.len() as i64 + lower_triangles)
    }
}

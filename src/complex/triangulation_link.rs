//! What stands around vertices and edges of a triangulation.

use super::triangulation::{TriangleGluing, Triangulation};
use super::triangulation_chain::corners_of_triangle;
use crate::mesh::classify::ClosedSurface;
use crate::mesh::gluing::{Gluing, Side};

/// A place of an edge: the edge from one corner of a tetrahedron to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EdgePlace {
    /// The tetrahedron.
    pub tetrahedron: u32,
    /// The corner where the edge begins.
    pub tail: u8,
    /// The corner where it ends.
    pub head: u8,
}

impl Triangulation {
    /// The surface around each vertex of the skeleton, its link (CX-72): a triangle across each corner there, glued as the
    /// tetrahedra are. Closed and connected, for tetrahedra at a vertex are joined across triangles there.
    #[doc(alias = "CX-72")]
    pub fn vertex_links(&self) -> Vec<ClosedSurface> {
        let skeleton = self.skeleton();
        let mut polygons = vec![Vec::new(); skeleton.counts[0]];
        for (tetrahedron, vertices) in skeleton.vertices.iter().enumerate() {
            for (corner, vertex) in vertices.iter().enumerate() {
                polygons[*vertex as usize].push(self.corner_triangle(tetrahedron, corner));
            }
        }
        let surface = |polygons| {
            let surfaces = Gluing::new(polygons).expect("each side is glued to one other").surfaces();
            assert!(surfaces.len() == 1 && surfaces[0].boundary_loops == 0, "a link is closed and connected");
            surfaces[0].closed
        };
        polygons.into_iter().map(surface).collect()
    }

    /// The sides of the small triangle across a corner. The side in triangle j of the tetrahedron goes between the edges to the
    /// two other corners of j; its label is the lesser one of its two places.
    fn corner_triangle(&self, tetrahedron: usize, corner: usize) -> Vec<Side> {
        let [a, b, c] = corners_of_triangle(corner);
        let side = |from: usize, to: usize, across: usize| {
            let TriangleGluing { tetrahedron: other, corners } = self.gluings()[tetrahedron][across];
            let place = |t: usize, i: usize, j: usize| u32::try_from(16 * t + 4 * i + j).expect("below 2²⁸ tetrahedra");
            let here = place(tetrahedron, corner, across);
            let there = place(other as usize, corners.image(corner), corners.image(across));
            match here < there {
                true => Side { edge: here, forward: from < to },
                false => Side { edge: there, forward: corners.image(from) < corners.image(to) },
            }
        };
        vec![side(a, b, c), side(b, c, a), side(c, a, b)]
    }

    /// The places of an edge around it, from this one on (CX-73): out of each tetrahedron through the triangle that the walk did
    /// not come in by, until it is where it began. Each place of the edge stands there once; iff the edge is glued
    /// to itself, tail to head, twice, once each way.
    ///
    /// # Panics
    /// Iff there is no such place.
    #[doc(alias = "CX-73")]
    pub fn edge_ring(&self, place: EdgePlace) -> Vec<EdgePlace> {
        let [i, j] = [place.tail, place.head].map(usize::from);
        let out = (0..4).find(|k| ![i, j].contains(k)).expect("two corners are left");
        let start = (place.tetrahedron, [i, j, out]);
        let (mut at, mut ring) = (start, Vec::new());
        loop {
            let (tetrahedron, [i, j, out]) = at;
            ring.push(EdgePlace { tetrahedron, tail: i as u8, head: j as u8 });
            let TriangleGluing { tetrahedron: next, corners } = self.gluings()[tetrahedron as usize][out];
            // It comes in by the image of that triangle, and goes out by the other one at the edge.
            let [i, j, came] = [i, j, out].map(|corner| corners.image(corner));
            at = (next, [i, j, 6 - i - j - came]);
            if at == start {
                return ring;
            }
        }
    }
}

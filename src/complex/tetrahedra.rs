//! Topological tetrahedra: one for each face-edge pair, the four barycentric tetrahedra around it.

use super::closed_complex::ClosedComplex;
use super::flag::Flag;
use super::permutation::Perm4;
use super::triangulation::{TriangleGluing, Triangulation};

/// The corners of a topological tetrahedron that are ends of its edge e: 0 and 1. The others are the middles of two polyhedra.
pub const PRIMAL: [usize; 2] = [0, 1];

/// The corners that are ends of the dual edge f′ of its face f: 2 and 3.
pub const DUAL: [usize; 2] = [2, 3];

impl ClosedComplex {
    /// The flags (v, e, f, p) of each topological tetrahedron that have corner 0 for v and corner 2 for p: by σ₀ they get
    /// corner 1, by σ₃ corner 3.
    pub fn tetrahedron_flags(&self) -> Vec<Flag> {
        let (tetrahedron_of, count) = self.flags().orbits(&[0, 3]);
        let mut first = vec![None; count];
        for flag in self.flags().all() {
            first[tetrahedron_of[flag.0 as usize] as usize].get_or_insert(flag);
        }
        first.into_iter().map(|flag| flag.expect("each orbit has a flag")).collect()
    }

    /// The topological tetrahedra, glued: corners 0 and 1 are the ends of the edge, 2 and 3 the middles of the polyhedra on the
    /// two sides of the face. Across the triangles that have both ends of the edge lies the next face around the edge, across
    /// the triangles that have both middles lies the next edge around the face.
    pub fn tetrahedra(&self) -> Triangulation {
        let flags = self.flags();
        let (tetrahedron_of, _) = flags.orbits(&[0, 3]);
        let first = self.tetrahedron_flags();
        // Corners of the vertex and the polyhedron of a flag in its tetrahedron.
        let corners_of = |flag: Flag| {
            let base = first[tetrahedron_of[flag.0 as usize] as usize];
            let v = [base, flags.sigma(3, base)].contains(&flag);
            let p = [base, flags.sigma(0, base)].contains(&flag);
            (if v { 0 } else { 1 }, if p { 2 } else { 3 })
        };
        let gluing = |flag: Flag, k: usize| {
            let next = flags.sigma(k, flag);
            let ((v, p), (w, q)) = (corners_of(flag), corners_of(next));
            // The other vertex and the other polyhedron stand at the other corners.
            let mut images = [0; 4];
            (images[v], images[1 - v], images[p], images[5 - p]) = (w as u8, 1 - w as u8, q as u8, 5 - q as u8);
            let corners = Perm4::new(images).expect("two ends and two middles");
            TriangleGluing { tetrahedron: tetrahedron_of[next.0 as usize], corners }
        };
        let gluings = first.iter().map(|base| {
            // Triangle i lies opposite corner i.
            [gluing(flags.sigma(0, *base), 1), gluing(*base, 1), gluing(flags.sigma(3, *base), 2), gluing(*base, 2)]
        });
        Triangulation::new(gluings.collect()).expect("σ₁ and σ₂ are their own inverses")
    }

    /// The barycentric subdivision, glued: a tetrahedron a flag, whose corners 0, 1, 2, 3 are the middles of its vertex, edge,
    /// face and polyhedron.
    pub fn barycentric(&self) -> Triangulation {
        let gluing = |flag, k| TriangleGluing { tetrahedron: self.flags().sigma(k, flag).0, corners: Perm4::IDENTITY };
        let gluings = self.flags().all().map(|flag| [0, 1, 2, 3].map(|k| gluing(flag, k)));
        Triangulation::new(gluings.collect()).expect("each σ is its own inverse")
    }
}

//! Schemes by construction: polyhedra, and families of gluings.

use super::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, SignedEdge};
use std::collections::BTreeMap;

impl Polyhedron {
    /// The polyhedron with these faces, each the cycle of its vertices, all seen from one side. Two vertices have one edge at
    /// most; edges are numbered as the faces come to them.
    pub fn of_vertex_cycles(faces: &[Vec<u32>]) -> Polyhedron {
        let mut numbers: BTreeMap<[u32; 2], i32> = BTreeMap::new();
        let mut edges = Vec::new();
        let mut side = |from: u32, to: u32| {
            // Walked along the same way again it is the same edge too, and the polyhedron has that flaw.
            match (numbers.get(&[from, to]), numbers.get(&[to, from])) {
                (Some(edge), _) => return SignedEdge(*edge),
                (None, Some(edge)) => return SignedEdge(-edge),
                (None, None) => {}
            }
            edges.push([from, to]);
            numbers.insert([from, to], edges.len() as i32);
            SignedEdge(edges.len() as i32)
        };
        let mut polygon = |face: &Vec<u32>| -> Vec<SignedEdge> {
            (0..face.len()).map(|i| side(face[i], face[(i + 1) % face.len()])).collect()
        };
        let faces = faces.iter().map(&mut polygon).collect();
        Polyhedron { edges, faces }
    }

    /// The tetrahedron, faces opposite vertices 0, 1, 2, 3.
    pub fn tetrahedron() -> Polyhedron {
        Polyhedron::of_vertex_cycles(&[vec![1, 2, 3], vec![0, 3, 2], vec![0, 1, 3], vec![0, 2, 1]])
    }

    /// The prism over an n-gon, bottom 0 … n−1, top n … 2n−1: faces bottom, top, then the sides over the edges i, i + 1.
    pub fn prism(n: u32) -> Polyhedron {
        let side = |i: u32| vec![i, (i + 1) % n, n + (i + 1) % n, n + i];
        let bottom = (0..n).rev().collect();
        Polyhedron::of_vertex_cycles(&[vec![bottom, (n..2 * n).collect()], (0..n).map(side).collect()].concat())
    }

    /// The cube: faces bottom, top, then front, right, back, left.
    pub fn cube() -> Polyhedron {
        Polyhedron::prism(4)
    }

    /// A ball with two n-gons, n ≥ 1, for its upper and its lower half.
    pub fn lens(n: u32) -> Polyhedron {
        let upper: Vec<SignedEdge> = (1..=n as i32).map(SignedEdge).collect();
        let lower = upper.iter().rev().map(|side| SignedEdge(-side.0)).collect();
        Polyhedron { edges: (0..n).map(|i| [i, (i + 1) % n]).collect(), faces: vec![upper, lower] }
    }
}

/// Faces of one polyhedron paired: (a, b, shift, dir).
pub fn paired(polyhedron: Polyhedron, pairs: &[(usize, usize, i64, i64)]) -> GluingScheme {
    let face = |face| FaceId { polyhedron: 0, face };
    let pairing =
        |(a, b, shift, dir): &(usize, usize, i64, i64)| Pairing { a: face(*a), b: face(*b), shift: *shift, dir: *dir };
    GluingScheme { polyhedra: vec![polyhedron], pairings: pairs.iter().map(pairing).collect() }
}

/// The 3-torus: a cube with opposite faces glued by translations (000, figure 7).
pub fn three_torus() -> GluingScheme {
    // Bottom (3 2 1 0) to top (4 5 6 7): vertex 3 to 7, 2 to 6. Front (0 1 5 4) to back (2 3 7 6): 0 to 3.
    paired(Polyhedron::cube(), &[(0, 1, 3, -1), (2, 4, 1, -1), (3, 5, 1, -1)])
}

/// The lens space L(p, q): a ball whose upper p-gon is glued to the lower one after q steps around. For p and q not coprime
/// it is a manifold too, another one.
#[doc(alias = "CX-14")]
pub fn lens_space(p: u32, q: u32) -> GluingScheme {
    // Lower corner i is vertex −i: vertex i goes to vertex i + q, which is corner −q − i.
    paired(Polyhedron::lens(p), &[(0, 1, -i64::from(q), -1)])
}

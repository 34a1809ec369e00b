//! The chain complex of a closed triangulation, with a direction for each cell.

use super::triangulation::{EDGES, Skeleton, Triangulation, edge_between};
use crate::mesh::homology::{Chain, ChainComplex};
use crate::partition::Partition;
use thiserror::Error;

/// An edge that is glued to itself, tail to head: it has no direction, and the tetrahedra's parts are no cells of a complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("edge {edge} of the triangulation is glued to itself, tail to head")]
pub struct ReversedEdge {
    /// Its number in the skeleton.
    pub edge: u32,
}

/// The cells of a triangulation, each with a direction: an edge goes as in its first place, from the lower corner to the higher.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DirectedSkeleton {
    /// The cells.
    pub cells: Skeleton,
    /// Whether the edges of each tetrahedron go from the lower corner to the higher.
    pub forward: Vec<[bool; 6]>,
}

impl DirectedSkeleton {
    /// The edge from corner i to corner j of a tetrahedron, and whether it goes that way.
    pub fn edge(&self, tetrahedron: usize, i: usize, j: usize) -> (u32, bool) {
        let edge = edge_between(i, j);
        (self.cells.edges[tetrahedron][edge], self.forward[tetrahedron][edge] == (i < j))
    }
}

/// The corners of triangle i, the one opposite corner i, in order.
pub fn corners_of_triangle(i: usize) -> [usize; 3] {
    [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]][i]
}

impl Triangulation {
    /// The edges that are glued to themselves, tail to head, by their numbers in the skeleton.
    pub fn reversed_edges(&self) -> Vec<u32> {
        let mut directions = self.directions();
        let cells = self.skeleton();
        let places = cells.edges.as_flattened().iter().enumerate();
        let mut reversed: Vec<u32> = places
            .filter(|(i, _)| directions.find(2 * i) == directions.find(2 * i + 1))
            .map(|(_, edge)| *edge)
            .collect();
        reversed.sort_unstable();
        reversed.dedup();
        reversed
    }

    /// Its cells with directions.
    ///
    /// # Errors
    /// Iff an edge is glued to itself, tail to head: the first one.
    pub fn directed_skeleton(&self) -> Result<DirectedSkeleton, ReversedEdge> {
        if let Some(edge) = self.reversed_edges().first() {
            return Err(ReversedEdge { edge: *edge });
        }
        let mut directions = self.directions();
        // The least place stands for a class, so the first way of the first place makes an even number.
        let forward = |t: usize| std::array::from_fn(|edge| directions.find(2 * (6 * t + edge)).is_multiple_of(2));
        Ok(DirectedSkeleton { cells: self.skeleton(), forward: (0..self.len()).map(forward).collect() })
    }

    /// The chain complex C₃ → C₂ → C₁ → C₀ of its cells (CX-65, CX-66): ∂(v₀ … v_k) = Σ (−1)^i (v₀ … v̂_i … v_k) in the order of the
    /// corners, each cell with the direction of its first place. Three edges of a triangle may be one edge.
    ///
    /// # Errors
    /// Iff an edge is glued to itself, tail to head: the first one.
    #[doc(alias = "CX-65")]
    #[doc(alias = "CX-66")]
    pub fn chain_complex(&self) -> Result<ChainComplex, ReversedEdge> {
        let skeleton = self.directed_skeleton()?;
        let [vertices, edges, triangles, tetrahedra] = skeleton.cells.counts;
        let mut boundaries =
            vec![vec![Chain::new(); vertices], vec![Chain::new(); edges], vec![Chain::new(); triangles]];
        boundaries.push(vec![Chain::new(); tetrahedra]);
        let mut add = |k: usize, cell: u32, part: u32, forward: bool| {
            *boundaries[k][cell as usize].entry(part as usize).or_default() += if forward { 1 } else { -1 };
        };
        let mut seen = [vec![false; edges], vec![false; triangles]];
        for t in 0..tetrahedra {
            for [i, j] in EDGES {
                let (edge, forward) = skeleton.edge(t, i, j);
                if !std::mem::replace(&mut seen[0][edge as usize], true) {
                    add(1, edge, skeleton.cells.vertices[t][j], forward);
                    add(1, edge, skeleton.cells.vertices[t][i], !forward);
                }
            }
            for (i, gluing) in self.gluings()[t].iter().enumerate() {
                let triangle = skeleton.cells.triangles[t][i];
                let [a, b, c] = corners_of_triangle(i);
                let first = !std::mem::replace(&mut seen[1][triangle as usize], true);
                if first {
                    for [from, to] in [[b, c], [c, a], [a, b]] {
                        let (edge, forward) = skeleton.edge(t, from, to);
                        add(2, triangle, edge, forward);
                    }
                }
                let [a, b, c] = [a, b, c].map(|corner| gluing.corners.image(corner));
                // An even order of the corners is the direction that they have in the first place.
                let same = first || ((a < b) == (b < c)) == (a < c);
                add(3, t as u32, triangle, same == (i % 2 == 0));
            }
        }
        Ok(ChainComplex::new(boundaries).expect("the boundary of a boundary is nothing"))
    }

    /// The ways along the edges of all tetrahedra, 2(6t + e) from the lower corner to the higher, then back; glued ones united.
    fn directions(&self) -> Partition {
        let mut same = Partition::new(12 * self.len());
        for (tetrahedron, gluings) in self.gluings().iter().enumerate() {
            for (triangle, gluing) in gluings.iter().enumerate() {
                for (edge, [i, j]) in EDGES.iter().enumerate().filter(|(_, ends)| !ends.contains(&triangle)) {
                    let [k, l] = [*i, *j].map(|corner| gluing.corners.image(corner));
                    let (here, there) = (6 * tetrahedron + edge, 6 * gluing.tetrahedron as usize + edge_between(k, l));
                    let turned = usize::from(k > l);
                    same.join(2 * here, 2 * there + turned);
                    same.join(2 * here + 1, 2 * there + 1 - turned);
                }
            }
        }
        same
    }
}

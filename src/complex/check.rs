//! What a closed triangulation is: a manifold or not, orientable or not, a simplicial complex or not.

pub mod fast;

use super::triangulation::{EDGES, Triangulation};
use crate::mesh::classify::{ClosedSurface, SPHERE, Surface};
use crate::partition::Partition;
use std::collections::BTreeSet;
use thiserror::Error;

/// What keeps a closed triangulation from being a 3-manifold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum TriangulationDefect {
    /// An edge that is glued to itself, tail to head: its middle has the cone on a projective plane around it.
    #[error("edge {edge} of tetrahedron {tetrahedron} is glued to itself, tail to head")]
    EdgeReversed {
        /// The first tetrahedron that has it.
        tetrahedron: usize,
        /// The first edge of that tetrahedron that is it.
        edge: usize,
    },
    /// A vertex around which the space is the cone on another surface than the sphere.
    #[error("around vertex {vertex} stands a {}, not a sphere", Surface { closed: *.link, boundary_loops: 0 })]
    VertexLink {
        /// The vertex, by its number in the skeleton.
        vertex: usize,
        /// The surface around it.
        link: ClosedSurface,
    },
}

/// The facts about a closed triangulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facts {
    /// How many vertices, edges, triangles, tetrahedra there are.
    pub counts: [usize; 4],
    /// How many connected components.
    pub components: usize,
    /// Whether the tetrahedra can be turned so that each gluing is one of opposite sides.
    pub orientable: bool,
    /// What keeps it from being a manifold: reversed edges, then vertices, by their numbers in the skeleton.
    pub defects: Vec<TriangulationDefect>,
    /// How its simplices are told apart by their vertices.
    pub vertex_sets: VertexSets,
}

/// How the simplices of a triangulation are told apart by their vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexSets {
    /// How many tetrahedra have a vertex twice.
    pub degenerate_tetrahedra: usize,
    /// How many tetrahedra there are less how many sets of vertices of tetrahedra.
    pub duplicate_tetrahedra: usize,
    /// Whether no tetrahedron has a vertex twice, and edges, triangles, tetrahedra are each determined by their vertices.
    pub simplicial: bool,
}

/// The facts about a triangulation, each by its definition.
///
/// It is a closed 3-manifold iff no edge is reversed and every vertex has a sphere around it (CX-5): a triangle for each corner
/// of a tetrahedron there, an edge for each corner of a triangle, a vertex for each end of an edge.
#[doc(alias = "CX-5")]
pub fn check(triangulation: &Triangulation) -> Facts {
    let mut components = Partition::new(triangulation.len());
    for (tetrahedron, gluings) in triangulation.gluings().iter().enumerate() {
        for gluing in gluings {
            components.join(tetrahedron, gluing.tetrahedron as usize);
        }
    }
    Facts {
        counts: triangulation.skeleton().counts,
        components: (0..triangulation.len()).filter(|i| components.find(*i) == *i).count(),
        orientable: is_orientable(triangulation),
        defects: defects(triangulation),
        vertex_sets: vertex_sets(triangulation),
    }
}

/// Degenerate and duplicate tetrahedra, and whether the triangulation is a simplicial complex. A pair of degenerate tetrahedra in the
/// sense of 000, footnote 4, is two different ones with the same vertices.
#[doc(alias = "CX-64")]
pub fn vertex_sets(triangulation: &Triangulation) -> VertexSets {
    let skeleton = triangulation.skeleton();
    let [_, edge_count, triangle_count, tetrahedra] = skeleton.counts;
    let [mut edges, mut triangles, mut all] = [(); 3].map(|()| BTreeSet::new());
    let mut degenerate_tetrahedra = 0;
    for vertices in &skeleton.vertices {
        let set = |corners: &[usize]| corners.iter().map(|i| vertices[*i]).collect::<BTreeSet<u32>>();
        edges.extend(EDGES.iter().map(|ends| set(ends)));
        triangles.extend((0..4).map(|i| set(&[1, 2, 3].map(|j| (i + j) % 4))));
        degenerate_tetrahedra += usize::from(set(&[0, 1, 2, 3]).len() < 4);
        all.insert(set(&[0, 1, 2, 3]));
    }
    let told_apart = (edges.len(), triangles.len(), all.len()) == (edge_count, triangle_count, tetrahedra);
    VertexSets {
        degenerate_tetrahedra,
        duplicate_tetrahedra: tetrahedra - all.len(),
        simplicial: degenerate_tetrahedra == 0 && told_apart,
    }
}

/// Whether each tetrahedron can have a sign such that gluings by odd permutations keep it and others change it.
fn is_orientable(triangulation: &Triangulation) -> bool {
    let n = triangulation.len();
    // Each tetrahedron twice, once for each sign.
    let mut signed = Partition::new(2 * n);
    for (tetrahedron, gluing) in (0..).zip(triangulation.gluings()).flat_map(|(i, row)| row.iter().map(move |g| (i, g)))
    {
        let turn = usize::from(gluing.corners.is_even());
        let other = 2 * gluing.tetrahedron as usize;
        for sign in 0..2 {
            signed.join(2 * tetrahedron + sign, other + (sign ^ turn));
        }
    }
    (0..n).all(|i| signed.find(2 * i) != signed.find(2 * i + 1))
}

fn defects(triangulation: &Triangulation) -> Vec<TriangulationDefect> {
    let n = triangulation.len();
    let skeleton = triangulation.skeleton();
    // The end at corner i of the edge ij of a tetrahedron, and the triangle at a corner, once for each sign.
    let end = |tetrahedron: usize, i: usize, j: usize| 16 * tetrahedron + 4 * i + j;
    let (mut ends, mut corners) = (Partition::new(16 * n), Partition::new(8 * n));
    for (tetrahedron, gluings) in triangulation.gluings().iter().enumerate() {
        for (triangle, gluing) in gluings.iter().enumerate() {
            let (other, turn) = (gluing.tetrahedron as usize, usize::from(gluing.corners.is_even()));
            let image = |i| gluing.corners.image(i);
            for i in (0..4).filter(|i| *i != triangle) {
                for j in (0..4).filter(|j| *j != triangle && *j != i) {
                    ends.join(end(tetrahedron, i, j), end(other, image(i), image(j)));
                }
                for sign in 0..2 {
                    corners.join(8 * tetrahedron + 2 * i + sign, 8 * other + 2 * image(i) + (sign ^ turn));
                }
            }
        }
    }
    let mut defects = Vec::new();
    let mut seen = BTreeSet::new();
    for (tetrahedron, edges) in skeleton.edges.iter().enumerate() {
        for (edge, [i, j]) in EDGES.iter().enumerate() {
            let reversed = ends.find(end(tetrahedron, *i, *j)) == ends.find(end(tetrahedron, *j, *i));
            if seen.insert(edges[edge]) && reversed {
                defects.push(TriangulationDefect::EdgeReversed { tetrahedron, edge });
            }
        }
    }
    // χ = V − 3F/2 + F of each link, and whether its two signs meet.
    let mut doubled = vec![0_i64; skeleton.counts[0]];
    let mut orientable = vec![true; skeleton.counts[0]];
    for (tetrahedron, vertices) in skeleton.vertices.iter().enumerate() {
        for (i, vertex) in vertices.iter().enumerate() {
            let first = |j: &usize| *j != i && ends.find(end(tetrahedron, i, *j)) == end(tetrahedron, i, *j);
            doubled[*vertex as usize] += 2 * (0..4).filter(first).count() as i64 - 1;
            let corner = 8 * tetrahedron + 2 * i;
            orientable[*vertex as usize] &= corners.find(corner) != corners.find(corner + 1);
        }
    }
    let links = doubled.into_iter().zip(orientable).map(|(doubled, orientable)| surface(doubled / 2, orientable));
    let links = links.enumerate().filter(|(_, link)| *link != SPHERE);
    defects.extend(links.map(|(vertex, link)| TriangulationDefect::VertexLink { vertex, link }));
    defects
}

/// The closed connected surface of that χ ≤ 2.
fn surface(chi: i64, orientable: bool) -> ClosedSurface {
    let missing = usize::try_from(2 - chi).expect("a closed connected surface has χ ≤ 2");
    match orientable {
        true => ClosedSurface::Orientable { genus: missing / 2 },
        false => ClosedSurface::NonOrientable { crosscaps: missing },
    }
}

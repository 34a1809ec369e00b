//! From which order on a refinement is a simplicial complex, read from what is refined.

use crate::complex::check::vertex_sets;
use crate::complex::triangulation::{EDGES, Triangulation, edge_between};
use crate::partition::Partition;
use std::collections::{BTreeMap, BTreeSet};

/// What can keep a refinement from being a simplicial complex (CX-61), as to the tetrahedra that are refined. An angle is a triangle at
/// one of its corners, between two ends of edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Obstruction {
    /// A tetrahedron with a vertex twice, or simplices with the same vertices: of order 1.
    NotSimplicial,
    /// An edge from a vertex to itself: of orders 1 and 2.
    Loop,
    /// Two angles between the same edges, or one between an edge and itself: of order 2.
    AnglesBetweenEdges,
    /// Two tetrahedra with the same edges e and f′: of order 2.
    SamePair,
    /// Two tetrahedra with two triangles in common, or one with a triangle twice: of order 3.
    TwoTriangles,
    /// Two angles between the same ends of edges, or one between an end and itself: of every order.
    AnglesBetweenEnds,
    /// Two corners of tetrahedra between the same three ends of edges, or one with an end twice: of every order. There are degenerate
    /// and duplicate tetrahedra then.
    CornersBetweenEnds,
}

impl Obstruction {
    /// Whether it keeps refinements of that order from being simplicial complexes.
    pub fn matters(self, order: u32) -> bool {
        match self {
            Obstruction::NotSimplicial => order == 1,
            Obstruction::Loop => order <= 2,
            Obstruction::AnglesBetweenEdges | Obstruction::SamePair => order == 2,
            Obstruction::TwoTriangles => order == 3,
            Obstruction::AnglesBetweenEnds | Obstruction::CornersBetweenEnds => true,
        }
    }
}

/// What keeps some refinement from being a simplicial complex: that of order k is one iff nothing of it matters for k. It is one for
/// all k ≥ 4 iff it is for one of them, that is iff the surfaces around the vertices are simplicial complexes.
///
/// Domain: gluings that keep {0, 1} | {2, 3}, as those of topological tetrahedra, and no edge glued to itself, tail to head.
#[doc(alias = "CX-61")]
pub fn obstructions(base: &Triangulation) -> BTreeSet<Obstruction> {
    let skeleton = base.skeleton();
    let mut found = BTreeSet::new();
    let mut note = |is_there: bool, obstruction| {
        if is_there {
            found.insert(obstruction);
        }
    };
    note(!vertex_sets(base).simplicial, Obstruction::NotSimplicial);
    let is_loop = |vertices: &[u32; 4]| EDGES.iter().any(|[i, j]| vertices[*i] == vertices[*j]);
    note(skeleton.vertices.iter().any(is_loop), Obstruction::Loop);
    let edge_of = |tetrahedron: usize, i, j| skeleton.edges[tetrahedron][edge_between(i, j)];
    note(!are_told_apart(angles(base, edge_of)), Obstruction::AnglesBetweenEdges);
    let pairs = skeleton.edges.iter().zip(0..).map(|(edges, tetrahedron)| (edges_pair(edges), tetrahedron));
    note(!are_told_apart(pairs), Obstruction::SamePair);
    let triangles = skeleton
        .triangles
        .iter()
        .zip(0..)
        .flat_map(|(of, tetrahedron)| EDGES.map(|[i, j]| (sorted([of[i], of[j]]), tetrahedron)));
    note(!are_told_apart(triangles), Obstruction::TwoTriangles);
    let ends = edge_ends(base);
    let end_of = |tetrahedron: usize, i: usize, j: usize| ends[tetrahedron][i][j];
    let corners = (0..base.len()).flat_map(|tetrahedron| {
        (0..4).map(move |i| {
            (sorted([1, 2, 3].map(|j| end_of(tetrahedron, i, (i + j) % 4))), (4 * tetrahedron + i) as u32)
        })
    });
    note(!are_told_apart(angles(base, end_of)), Obstruction::AnglesBetweenEnds);
    note(!are_told_apart(corners), Obstruction::CornersBetweenEnds);
    found
}

fn edges_pair(edges: &[u32; 6]) -> [u32; 2] {
    [edges[0], edges[5]]
}

fn sorted<const N: usize>(mut numbers: [u32; N]) -> [u32; N] {
    numbers.sort_unstable();
    numbers
}

/// Each angle with the two things that it is between, as many times as it is a part of a tetrahedron.
fn angles(base: &Triangulation, side: impl Fn(usize, usize, usize) -> u32) -> Vec<([u32; 2], u32)> {
    let number = |tetrahedron: usize, triangle: usize, corner: usize| (16 * tetrahedron + 4 * triangle + corner) as u32;
    let mut angles = Vec::with_capacity(12 * base.len());
    for (tetrahedron, gluings) in base.gluings().iter().enumerate() {
        for (triangle, gluing) in gluings.iter().enumerate() {
            for corner in (0..4).filter(|i| *i != triangle) {
                let [j, k] = others(triangle, corner);
                let image = |i| gluing.corners.image(i);
                let beyond = number(gluing.tetrahedron as usize, image(triangle), image(corner));
                let sides = sorted([side(tetrahedron, corner, j), side(tetrahedron, corner, k)]);
                angles.push((sides, beyond.min(number(tetrahedron, triangle, corner))));
            }
        }
    }
    angles
}

/// The two corners of a tetrahedron that are not these.
fn others(i: usize, j: usize) -> [usize; 2] {
    EDGES[5 - edge_between(i, j)]
}

/// The end at i of the edge from i to j of each tetrahedron, by i, then by j.
fn edge_ends(base: &Triangulation) -> Vec<[[u32; 4]; 4]> {
    let end = |tetrahedron: usize, i: usize, j: usize| 16 * tetrahedron + 4 * i + j;
    let mut ends = Partition::new(16 * base.len());
    for (tetrahedron, gluings) in base.gluings().iter().enumerate() {
        for (triangle, gluing) in gluings.iter().enumerate() {
            for i in (0..4).filter(|i| *i != triangle) {
                for j in others(triangle, i) {
                    let image = |i| gluing.corners.image(i);
                    ends.join(end(tetrahedron, i, j), end(gluing.tetrahedron as usize, image(i), image(j)));
                }
            }
        }
    }
    let mut of = |tetrahedron| [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| ends.find(end(tetrahedron, i, j)) as u32));
    (0..base.len()).map(&mut of).collect()
}

/// Whether each key stands for one thing only, and no key has an element twice.
fn are_told_apart<const N: usize>(things: impl IntoIterator<Item = ([u32; N], u32)>) -> bool {
    let mut thing_of = BTreeMap::new();
    things.into_iter().all(|(key, thing)| {
        key.windows(2).all(|pair| pair[0] != pair[1]) && *thing_of.entry(key).or_insert(thing) == thing
    })
}

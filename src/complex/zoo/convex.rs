//! Convex polytopes by their vertices: facets, faces, edges, all exact.

use super::super::scheme::{FaceId, GluingScheme, Pairing, Polyhedron};
use std::collections::{BTreeMap, BTreeSet};

/// A convex polyhedron around the origin, its points and the cycles of its faces, seen from outside.
#[derive(Clone, Debug)]
pub(super) struct Solid {
    points: Vec<[i64; 3]>,
    faces: Vec<Vec<u32>>,
}

impl Solid {
    /// The convex hull of these points, all of them vertices.
    pub(super) fn new(points: Vec<[i64; 3]>) -> Solid {
        let mut faces = cycles(&facets(&points));
        let corners: Vec<Vec<i64>> = faces[0][..3].iter().map(|v| points[*v as usize].to_vec()).collect();
        if determinant(&corners) < 0 {
            faces.iter_mut().for_each(|face| face.reverse());
        }
        Solid { points, faces }
    }

    /// Each face glued to the opposite one: vᵢ to −vᵢ₊ₖ, i counted counterclockwise as seen from outside, k by the number n of
    /// sides. That is the shift across together with a turn by π + 2πk/n.
    pub(super) fn opposite_faces_glued(&self, k: impl Fn(usize) -> usize) -> GluingScheme {
        let opposite = |v: u32| {
            let negative = self.points[v as usize].map(|x| -x);
            self.points.iter().position(|p| *p == negative).expect("the vertices are symmetric about the origin") as u32
        };
        let glued = self.faces.iter().enumerate().filter_map(|(number, face)| {
            let n = face.len();
            let images: Vec<u32> = (0..n).map(|i| opposite(face[(i + k(n)) % n])).collect();
            let other = self.faces.iter().position(|face| images.iter().all(|v| face.contains(v)))?;
            (number < other).then(|| by_corners([0, number], [0, other], &self.faces[other], &images))
        });
        let pairings = glued.collect();
        GluingScheme { polyhedra: vec![Polyhedron::of_vertex_cycles(&self.faces)], pairings }
    }
}

/// The boundary of the convex hull of points in four dimensions, around the origin, all of them vertices: its facets, glued where
/// they meet.
pub(super) fn boundary(points: &[[i64; 4]]) -> GluingScheme {
    let facets = facets(points);
    // Two facets meet in a polygon, or in less.
    let ridges = |facet: &BTreeSet<u32>| -> Vec<BTreeSet<u32>> {
        let others = facets.iter().filter(|other| *other != facet);
        others.map(|other| facet & other).filter(|common| common.len() > 2).collect()
    };
    let polyhedra: Vec<Vec<Vec<u32>>> = facets.iter().map(|facet| cycles(&ridges(facet))).collect();
    let mut first: BTreeMap<BTreeSet<u32>, [usize; 2]> = BTreeMap::new();
    let mut pairings = Vec::new();
    for (polyhedron, faces) in polyhedra.iter().enumerate() {
        for (number, face) in faces.iter().enumerate() {
            let set = face.iter().copied().collect();
            match first.get(&set) {
                None => drop(first.insert(set, [polyhedron, number])),
                Some(there) => {
                    pairings.push(by_corners([polyhedron, number], *there, &polyhedra[there[0]][there[1]], face))
                }
            }
        }
    }
    GluingScheme { polyhedra: polyhedra.iter().map(|faces| Polyhedron::of_vertex_cycles(faces)).collect(), pairings }
}

/// The pairing of face a with face b, whose cycle is given, that takes the corners of a to these vertices of b.
pub(super) fn by_corners(a: [usize; 2], b: [usize; 2], cycle: &[u32], images: &[u32]) -> Pairing {
    let [a, b] = [a, b].map(|[polyhedron, face]| FaceId { polyhedron, face });
    let at = |v: u32| cycle.iter().position(|w| *w == v).expect("an image is a corner of b");
    let (shift, next) = (at(images[0]), at(images[1]));
    let dir = if next == (shift + 1) % cycle.len() { 1 } else { -1 };
    Pairing { a, b, shift: shift as i64, dir }
}

/// The sets of vertices of the facets of a convex hull around the origin: N of them span a hyperplane with all points on the
/// origin's side of it.
fn facets<const N: usize>(points: &[[i64; N]]) -> Vec<BTreeSet<u32>> {
    let mut found = BTreeSet::new();
    let mut chosen: Vec<usize> = (0..N).collect();
    loop {
        // The normal of the hyperplane through the chosen points, by cofactors.
        let first = points[chosen[0]];
        let rows: Vec<Vec<i64>> =
            chosen[1..].iter().map(|i| (0..N).map(|j| points[*i][j] - first[j]).collect()).collect();
        let normal: [i64; N] = std::array::from_fn(|j| cofactor(&rows, j));
        let along = |x: &[i64; N]| (0..N).map(|j| normal[j] * (x[j] - first[j])).sum::<i64>();
        let inside = along(&[0; N]).signum();
        let sides: Vec<i64> = points.iter().map(|x| along(x).signum() * inside).collect();
        if inside != 0 && sides.iter().all(|side| *side >= 0) {
            found.insert((0..).zip(&sides).filter(|(_, side)| **side == 0).map(|(i, _)| i).collect());
        }
        // The next choice of N points.
        let Some(i) = (0..N).rev().find(|i| chosen[*i] + N - i < points.len()) else { break };
        let start = chosen[i] + 1;
        (i..N).for_each(|j| chosen[j] = start + j - i);
    }
    found.into_iter().collect()
}

/// (−1)^j times the determinant of the rows without column j.
fn cofactor(rows: &[Vec<i64>], j: usize) -> i64 {
    let minor: Vec<Vec<i64>> = rows.iter().map(|row| [&row[..j], &row[j + 1..]].concat()).collect();
    if j.is_multiple_of(2) { determinant(&minor) } else { -determinant(&minor) }
}

/// By the first row.
fn determinant(rows: &[Vec<i64>]) -> i64 {
    match rows {
        [] => 1,
        [first, rest @ ..] => (0..first.len()).map(|j| first[j] * cofactor(rest, j)).sum(),
    }
}

/// The faces of a convex polyhedron as cycles, all seen from one side: two that have two vertices in common meet in an edge, and walk
/// along it opposite ways.
fn cycles(faces: &[BTreeSet<u32>]) -> Vec<Vec<u32>> {
    let edges = |face: &BTreeSet<u32>| -> Vec<[u32; 2]> {
        let common = faces.iter().filter(|other| *other != face).map(|other| face & other);
        common.filter_map(|both| <[u32; 2]>::try_from(both.into_iter().collect::<Vec<_>>()).ok()).collect()
    };
    let walk = |face: &BTreeSet<u32>| {
        let edges = edges(face);
        let mut cycle = edges[0].to_vec();
        while cycle.len() < face.len() {
            let [.., before, last] = cycle[..] else { unreachable!("it has two vertices") };
            let next =
                edges.iter().filter(|edge| edge.contains(&last)).flatten().find(|v| **v != last && **v != before);
            cycle.push(*next.expect("two edges of a face meet at a vertex"));
        }
        cycle
    };
    let mut cycles: Vec<Vec<u32>> = faces.iter().map(walk).collect();
    let sides = |cycle: &[u32]| -> Vec<[u32; 2]> {
        (0..cycle.len()).map(|i| [cycle[i], cycle[(i + 1) % cycle.len()]]).collect()
    };
    let mut turned = BTreeSet::from([0]);
    let mut pending = vec![0];
    while let Some(face) = pending.pop() {
        for [from, to] in sides(&cycles[face]) {
            let meets = |other: &usize| *other != face && faces[*other].contains(&from) && faces[*other].contains(&to);
            let other = (0..faces.len()).find(meets).expect("two faces at an edge");
            if turned.insert(other) {
                if sides(&cycles[other]).contains(&[from, to]) {
                    cycles[other].reverse();
                }
                pending.push(other);
            }
        }
    }
    cycles
}

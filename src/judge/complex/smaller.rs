//! Smaller questions of a row: a smaller example, a lower order, fewer pairings and polyhedra, plainer names.

use super::bases::{self, TETRAHEDRA};
use super::questions::{Question, Row};
use super::reasons;
use crate::complex::examples::{lens_space, three_torus};
use crate::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, Reason};
use std::collections::{BTreeMap, BTreeSet};

/// How large a question is: polyhedra, sides, pairings, order, then edges, names of vertices, and shifts.
pub fn size(question: &Question) -> (usize, usize, usize, u32, u64) {
    let GluingScheme { polyhedra, pairings } = &question.scheme;
    let sides = polyhedra.iter().flat_map(|p| &p.faces).map(|face| face.len() + 1).sum();
    let names = polyhedra.iter().flat_map(|p| p.edges.iter().flatten()).map(|v| u64::from(*v) + 1);
    let numbers = polyhedra.iter().flat_map(|p| p.faces.iter().flatten()).map(|side| u64::from(side.0.unsigned_abs()));
    let shifts = pairings.iter().map(|p| 2 * p.shift.unsigned_abs() + u64::from(p.shift < 0));
    let rest = names.chain(numbers).chain(shifts).sum();
    (polyhedra.len(), sides, pairings.len(), question.order.unwrap_or(0), rest)
}

/// Smaller questions of the same row, that are no manifold for no other reason than the question: so that one defect is not
/// shown by a heap of others.
pub fn smaller(question: &Question) -> impl Iterator<Item = Question> {
    let (known, most, row) = (reasons(&question.scheme), size(question), question.row);
    let with = |scheme: GluingScheme| Question { scheme, ..question.clone() };
    let schemes: Vec<GluingScheme> = [
        parts(&question.scheme),
        if known.iter().all(|r| OF_THE_GLUED.contains(r)) { examples() } else { Vec::new() },
        polyhedra_off(&question.scheme),
        pairings_off(&question.scheme),
        replaced(&question.scheme),
        vec![plain(&question.scheme)],
        shifts_reduced(&question.scheme),
    ]
    .concat();
    let lower = question.order.into_iter().flat_map(|order| 1..order);
    let lower: Vec<Question> = lower.map(|order| Question { order: Some(order), ..question.clone() }).collect();
    let schemes: Vec<Question> = schemes.into_iter().map(with).collect();
    lower.into_iter().chain(schemes).filter(move |smaller| {
        size(smaller) < most && {
            let found = reasons(&smaller.scheme);
            match row {
                Row::Invalid(reason) => found.contains(&reason) && found.is_subset(&known),
                _ => found.is_subset(&known) && found.is_empty() == known.is_empty(),
            }
        }
    })
}

/// Reasons that show only when the faces are glued.
const OF_THE_GLUED: [Reason; 2] = [Reason::EdgeReversed, Reason::VertexLink];

/// Schemes that people know, the smallest first.
fn examples() -> Vec<GluingScheme> {
    let lenses = |p: u32| (0..p).map(move |q| lens_space(p, q));
    let small = (1..4).flat_map(lenses);
    let tetrahedra = (0..TETRAHEDRA).map(bases::tetrahedron);
    let large = (4..8).flat_map(lenses);
    let twisted = (0..3).map(|twist| bases::twisted_prism(4, twist));
    small.chain(tetrahedra).chain(large).chain([three_torus()]).chain(twisted).collect()
}

/// Each component by itself, if there are several.
fn parts(scheme: &GluingScheme) -> Vec<GluingScheme> {
    let mut part_of = crate::partition::Partition::new(scheme.polyhedra.len());
    for Pairing { a, b, .. } in &scheme.pairings {
        if a.polyhedron.max(b.polyhedron) < scheme.polyhedra.len() {
            part_of.join(a.polyhedron, b.polyhedron);
        }
    }
    let part: Vec<usize> = (0..scheme.polyhedra.len()).map(|i| part_of.find(i)).collect();
    let firsts: BTreeSet<usize> = part.iter().copied().collect();
    match firsts.len() {
        0 | 1 => Vec::new(),
        _ => firsts.into_iter().map(|first| kept(scheme, |i| part[i] == first)).collect(),
    }
}

/// The polyhedra that are kept, with the pairings that lead to no other.
fn kept(scheme: &GluingScheme, keeps: impl Fn(usize) -> bool) -> GluingScheme {
    let numbers: BTreeMap<usize, usize> = (0..scheme.polyhedra.len()).filter(|i| keeps(*i)).zip(0..).collect();
    let polyhedra = numbers.keys().map(|i| scheme.polyhedra[*i].clone()).collect();
    // One that does not exist goes on not existing.
    let moved = |id: FaceId| match numbers.get(&id.polyhedron) {
        Some(polyhedron) => Some(FaceId { polyhedron: *polyhedron, ..id }),
        None if id.polyhedron < scheme.polyhedra.len() => None,
        None => Some(FaceId { polyhedron: id.polyhedron - scheme.polyhedra.len() + numbers.len(), ..id }),
    };
    let pairings = scheme.pairings.iter().filter_map(|p| Some(Pairing { a: moved(p.a)?, b: moved(p.b)?, ..*p }));
    GluingScheme { polyhedra, pairings: pairings.collect() }
}

/// Without one polyhedron; faces that were glued to it are glued to each other, where their sizes allow it.
fn polyhedra_off(scheme: &GluingScheme) -> Vec<GluingScheme> {
    let without = |gone: usize| {
        let mut smaller = kept(scheme, |i| i != gone);
        let used: BTreeSet<FaceId> = smaller.pairings.iter().flat_map(|p| [p.a, p.b]).collect();
        let mut free: Vec<FaceId> = smaller.faces().filter(|face| !used.contains(face)).collect();
        free.sort_by_key(|face| smaller.face(*face).map_or(0, <[_]>::len));
        for pair in free.chunks(2) {
            if let [a, b] = *pair {
                smaller.pairings.push(Pairing { a, b, shift: 0, dir: -1 });
            }
        }
        smaller
    };
    (0..scheme.polyhedra.len()).filter(|_| scheme.polyhedra.len() > 1).map(without).collect()
}

/// Without one pairing.
fn pairings_off(scheme: &GluingScheme) -> Vec<GluingScheme> {
    let without = |gone: usize| {
        let mut smaller = scheme.clone();
        smaller.pairings.remove(gone);
        smaller
    };
    (0..scheme.pairings.len()).map(without).collect()
}

/// With a polyhedron, none of whose faces is glued to another one, replaced by a ball of two monogons, bigons or triangles.
fn replaced(scheme: &GluingScheme) -> Vec<GluingScheme> {
    let mut all = Vec::new();
    for number in 0..scheme.polyhedra.len() {
        let own = |p: &Pairing| [p.a, p.b].map(|id| id.polyhedron == number);
        if scheme.pairings.iter().any(|p| own(p)[0] != own(p)[1]) {
            continue;
        }
        let face = |face| FaceId { polyhedron: number, face };
        let turned = |n: i64| (0..n).flat_map(|shift| [-1, 1].map(|dir| (shift, dir)));
        for n in 1..4 {
            let gluings = turned(n).map(|(shift, dir)| Some(Pairing { a: face(0), b: face(1), shift, dir }));
            for pairing in gluings.chain([None]) {
                let mut smaller = scheme.clone();
                smaller.polyhedra[number] = Polyhedron::lens(n as u32);
                smaller.pairings.retain(|p| own(p) == [false, false]);
                smaller.pairings.extend(pairing);
                all.push(smaller);
            }
        }
    }
    all
}

/// With vertices and edges numbered as the faces come to them, edges in the direction in which they are first walked along. The
/// scheme itself if a side is no edge.
fn plain(scheme: &GluingScheme) -> GluingScheme {
    let polyhedra = scheme.polyhedra.iter().map(|p| plain_polyhedron(p).unwrap_or_else(|| p.clone())).collect();
    GluingScheme { polyhedra, pairings: scheme.pairings.clone() }
}

fn plain_polyhedron(polyhedron: &Polyhedron) -> Option<Polyhedron> {
    let (mut vertices, mut edges) = (BTreeMap::new(), BTreeMap::new());
    let mut ends_of = Vec::new();
    let mut faces = polyhedron.faces.clone();
    for side in faces.iter_mut().flatten() {
        let ends = polyhedron.ends(*side)?;
        let count = edges.len() as i32 + 1;
        let (number, forward) = *edges.entry(side.index()?).or_insert((count, side.is_forward()));
        if number == count {
            let ends = ends.map(|v| {
                let next = vertices.len() as u32;
                *vertices.entry(v).or_insert(next)
            });
            ends_of.push(ends);
        }
        side.0 = if side.is_forward() == forward { number } else { -number };
    }
    // An edge of no face is a flaw, and stays.
    let unused = (0..polyhedron.edges.len()).filter(|i| !edges.contains_key(i));
    ends_of.extend(unused.map(|_| [0, 0]));
    Some(Polyhedron { edges: ends_of, faces })
}

/// With shifts 0 … n − 1.
fn shifts_reduced(scheme: &GluingScheme) -> Vec<GluingScheme> {
    let mut smaller = scheme.clone();
    for p in &mut smaller.pairings {
        if let Some(n @ 1..) = scheme.face(p.a).map(|face| face.len() as i64) {
            p.shift = p.shift.rem_euclid(n);
        }
    }
    vec![smaller]
}

//! All small boundaries: those that operators reach, and those that permutations and partitions make.

use super::canonical::code;
use super::words::Words;
use isoracle::mesh::euler_operators::{Boundary, Corner, HalfEdge, LoopId, Operator, Span};
use std::collections::{BTreeMap, BTreeSet};

/// Whether the long form of a test is asked for: the environment has `ISORACLE_LONG=1`.
pub fn is_long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

/// Boundaries up to isomorphism, by their codes.
pub type States = BTreeMap<Vec<Vec<u32>>, Boundary>;

/// How great boundaries are: E + H and C. Taking one apart never makes either greater.
#[derive(Clone, Copy)]
pub struct Limit {
    pub edges_and_rings: i64,
    pub shells: i64,
}

impl Limit {
    fn allows(self, b: &Boundary) -> bool {
        let counts = b.counted();
        counts.e + counts.h <= self.edges_and_rings && counts.c <= self.shells
    }
}

pub fn corners(b: &Boundary) -> Vec<Corner> {
    let lone = b.loops().filter_map(|l| b.alone(l)).map(Corner::Alone);
    b.half_edges().map(Corner::Before).chain(lone).collect()
}

fn spans(b: &Boundary) -> Vec<Span> {
    let between = b.half_edges().flat_map(|a| b.half_edges().map(move |c| Span::Between(a, c)));
    let nothing = corners(b).into_iter().map(Span::NothingAt);
    between.chain(nothing).chain(b.half_edges().map(Span::AllFrom)).collect()
}

/// Every set of at most two of the rings.
fn few_rings(b: &Boundary) -> Vec<BTreeSet<LoopId>> {
    let rings: Vec<LoopId> = b.faces().flat_map(|f| b.rings(f)).collect();
    let pairs = rings.iter().flat_map(|r| rings.iter().map(move |s| BTreeSet::from([*r, *s])));
    BTreeSet::from_iter(pairs.chain([BTreeSet::new()])).into_iter().collect()
}

/// Every operator of one kind, by number, with unused names for what it makes, allowed or not.
pub fn operators_of(b: &Boundary, kind: usize) -> Vec<Operator> {
    let (vertex, half_edge, ring) = (b.unused_vertex(), b.unused_half_edge(), b.unused_loop());
    let (face, shell, outer) = (b.unused_face(), b.unused_shell(), b.unused_loop());
    let face_pairs = || b.faces().flat_map(|face| b.faces().map(move |into| (face, into)));
    match kind {
        0 => vec![Operator::Mvfs { shell, face, outer, vertex }],
        1 => b.shells().map(|shell| Operator::Kvfs { shell }).collect(),
        2 => spans(b).into_iter().map(|span| Operator::Mev { span, half_edge, vertex }).collect(),
        3 => b.half_edges().map(|half_edge| Operator::Kev { half_edge }).collect(),
        4 => {
            let mef =
                |span| few_rings(b).into_iter().map(move |rings| Operator::Mef { span, half_edge, outer, face, rings });
            spans(b).into_iter().flat_map(mef).collect()
        }
        5 => b.half_edges().map(|half_edge| Operator::Kef { half_edge }).collect(),
        6 => b.half_edges().map(|half_edge| Operator::Kemr { half_edge, ring }).collect(),
        7 => {
            let to = |from| corners(b).into_iter().map(move |to| Operator::Mekr { from, to, half_edge });
            corners(b).into_iter().flat_map(to).collect()
        }
        8 => face_pairs().map(|(face, into)| Operator::Kfmrh { face, into }).collect(),
        9 => b.loops().map(|ring| Operator::Mfkrh { ring, face }).collect(),
        10 => face_pairs().map(|(face, into)| Operator::Ksfmr { face, into }).collect(),
        11 => b.loops().map(|ring| Operator::Msfkr { ring, face, shell }).collect(),
        _ => unreachable!("there are twelve kinds"),
    }
}

pub const KINDS: usize = 12;

/// The boundaries within the limit that operators reach from a start, without leaving the limit.
pub fn reached(start: Boundary, limit: Limit, may: impl Fn(&Operator) -> bool) -> States {
    let mut states = States::from([(code(&Words::of(&start)), start.clone())]);
    let mut pending = vec![start];
    while let Some(b) = pending.pop() {
        for operator in (0..KINDS).flat_map(|kind| operators_of(&b, kind)).filter(&may) {
            let mut after = b.clone();
            if after.apply(&operator).is_ok() && limit.allows(&after) {
                states.entry(code(&Words::of(&after))).or_insert_with(|| {
                    pending.push(after.clone());
                    after
                });
            }
        }
    }
    states
}

/// Every order of 0 … n − 1.
pub fn permutations(n: usize) -> Vec<Vec<usize>> {
    let Some(less) = n.checked_sub(1) else { return vec![vec![]] };
    let with_last = |p: Vec<usize>| (0..n).map(move |i| [&p[..i], &[less], &p[i..]].concat());
    permutations(less).into_iter().flat_map(with_last).collect()
}

/// The cycles of a permutation of half-edges.
pub fn cycles(permutation: &[usize]) -> Vec<Vec<u32>> {
    let mut seen = BTreeSet::new();
    let mut cycles = Vec::new();
    for start in 0..permutation.len() {
        let mut cycle = Vec::new();
        let mut h = start;
        while seen.insert(h) {
            cycle.push(h as u32);
            h = permutation[h];
        }
        cycles.extend((!cycle.is_empty()).then_some(cycle));
    }
    cycles
}

/// Every way to make faces of loops, with an outer loop for each, and at most so many rings.
fn faces_of(loops: &[Vec<u32>], rings: usize) -> Vec<Vec<Vec<Vec<u32>>>> {
    let Some((last, rest)) = loops.split_last() else { return vec![vec![]] };
    let mut ways = Vec::new();
    for faces in faces_of(rest, rings) {
        ways.push([&faces[..], &[vec![last.clone()]]].concat());
        let used: usize = faces.iter().map(|loops| loops.len() - 1).sum();
        for i in (0..faces.len()).filter(|_| used < rings) {
            for is_outer in [false, true] {
                let mut with = faces.clone();
                let at = if is_outer { 0 } else { with[i].len() };
                with[i].insert(at, last.clone());
                ways.push(with);
            }
        }
    }
    ways
}

/// The codes of all boundaries within the limit, each permutation of the half-edges being the one that goes along loops.
pub fn enumerated(limit: Limit) -> BTreeSet<Vec<Vec<u32>>> {
    let mut all = BTreeSet::new();
    let mut skeletons: BTreeSet<Vec<Vec<u32>>> = BTreeSet::new();
    for e in 0..=limit.edges_and_rings as usize {
        let rings = limit.edges_and_rings as usize - e;
        for permutation in permutations(2 * e) {
            // Permutations that differ in the numbering alone make the same.
            let faces: Vec<Vec<Vec<u32>>> = cycles(&permutation).into_iter().map(|word| vec![word]).collect();
            if e > 2 && !skeletons.insert(code(&Words(faces))) {
                continue;
            }
            // A lone vertex is a ring, or the outer loop of a face of rings that are lone vertices: a shell.
            for lone in 0..=rings + limit.shells as usize {
                let loops = [cycles(&permutation), vec![vec![]; lone]].concat();
                for faces in faces_of(&loops, rings) {
                    let words = Words(faces);
                    if words.counts().c <= limit.shells {
                        all.insert(code(&words));
                    }
                }
            }
        }
    }
    all
}

/// A boundary with these faces.
pub fn boundary(faces: &[Vec<Vec<u32>>]) -> Boundary {
    let half_edges = |word: &Vec<u32>| word.iter().map(|h| HalfEdge(*h)).collect();
    let faces: Vec<Vec<Vec<HalfEdge>>> = faces.iter().map(|loops| loops.iter().map(half_edges).collect()).collect();
    Boundary::from_loops(&faces).expect("each half-edge stands once, with its mate")
}

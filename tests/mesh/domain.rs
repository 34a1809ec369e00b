//! The gluings and complexes that surfaces are compared on.

use isoracle::mesh::face::Face;
use isoracle::mesh::gluing::{Gluing, Side};
use isoracle::mesh::simplicial::{Simplex, SimplicialComplex};
use proptest::prelude::*;
use std::collections::BTreeSet;

/// Whether the long form of a test is asked for: the environment has `ISORACLE_LONG=1`.
pub fn long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

/// Calls with every way to glue the sides of polygons of these sizes in pairs, each pair both ways; with free sides, too,
/// where that is asked for.
pub fn every_gluing(sizes: &[usize], free: bool, mut f: impl FnMut(Gluing)) {
    let n = sizes.iter().sum();
    let mut sides = vec![None; n];
    pair(&mut sides, 0, free, &mut |sides| f(polygons(sizes, sides)));
}

/// The gluing of polygons of these sizes with these sides, one polygon after the other.
fn polygons(sizes: &[usize], sides: &[Option<Side>]) -> Gluing {
    let mut rest = sides.iter().map(|side| side.expect("every side has its label"));
    let polygons = sizes.iter().map(|n| rest.by_ref().take(*n).collect()).collect();
    Gluing::new(polygons).expect("each label stands once or twice")
}

fn pair(sides: &mut Vec<Option<Side>>, edge: u32, free: bool, f: &mut impl FnMut(&[Option<Side>])) {
    let Some(first) = sides.iter().position(Option::is_none) else { return f(sides) };
    sides[first] = Some(Side { edge, forward: true });
    if free {
        pair(sides, edge + 1, free, f);
    }
    for second in first + 1..sides.len() {
        if sides[second].is_none() {
            for forward in [true, false] {
                sides[second] = Some(Side { edge, forward });
                pair(sides, edge + 1, free, f);
            }
            sides[second] = None;
        }
    }
    sides[first] = None;
}

/// A random gluing: up to six polygons of one to six sides.
pub fn gluing() -> impl Strategy<Value = Gluing> {
    gluing_of(6, 6)
}

/// A random gluing whose triangulation has at most 72 triangles.
pub fn small_gluing() -> impl Strategy<Value = Gluing> {
    gluing_of(2, 4)
}

/// Sides paired at random, all or two thirds of the pairs the orientable way, with up to three free sides.
fn gluing_of(polygons_up_to: usize, sides_up_to: usize) -> impl Strategy<Value = Gluing> {
    let sizes = prop::collection::vec(1..=sides_up_to, 1..=polygons_up_to);
    (sizes, any::<bool>(), 0usize..4, any::<u64>()).prop_map(|(sizes, orientable, free, seed)| {
        let n: usize = sizes.iter().sum();
        let mut state = seed | 1;
        let mut random = |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % below
        };
        let mut order: Vec<usize> = (0..n).collect();
        (1..n).for_each(|i| order.swap(i, random(i + 1)));
        let mut sides = vec![None; n];
        let free = free.min(n) + (n - free.min(n)) % 2;
        for (edge, place) in order[..free].iter().enumerate() {
            sides[*place] = Some(Side { edge: edge as u32, forward: true });
        }
        for (pair, edge) in order[free..].chunks(2).zip(free as u32..) {
            sides[pair[0]] = Some(Side { edge, forward: true });
            sides[pair[1]] = Some(Side { edge, forward: !orientable && random(3) == 0 });
        }
        polygons(&sizes, &sides)
    })
}

/// The complex of these simplices and their faces.
pub fn complex<S: AsRef<[u32]>>(simplices: &[S]) -> SimplicialComplex {
    SimplicialComplex::from_vertices(simplices).expect("simplices")
}

/// The triangles of a complex, as faces.
pub fn triangles(complex: &SimplicialComplex) -> Vec<Face> {
    complex.of_dimension(2).map(|t| Face::new(t.vertices())).collect()
}

/// The complexes of d-simplices on n vertices that turning the vertices by one keeps: every choice of orbits.
pub fn cyclic_complexes(n: u32, d: usize) -> Vec<SimplicialComplex> {
    let all: BTreeSet<BTreeSet<u32>> = (0u32..1 << n)
        .filter(|set| set.count_ones() as usize == d + 1)
        .map(|set| (0..n).filter(|v| set >> v & 1 == 1).collect())
        .collect();
    let turned = |s: &BTreeSet<u32>, by: u32| s.iter().map(|v| (v + by) % n).collect::<BTreeSet<u32>>();
    let orbits: BTreeSet<BTreeSet<BTreeSet<u32>>> =
        all.iter().map(|s| (0..n).map(|by| turned(s, by)).collect()).collect();
    let orbits: Vec<_> = orbits.into_iter().collect();
    (1u32..1 << orbits.len())
        .map(|chosen| {
            let chosen = (0..orbits.len()).filter(|i| chosen >> i & 1 == 1).flat_map(|i| orbits[i].iter());
            SimplicialComplex::new(
                chosen.map(|s| Simplex::new(&s.iter().copied().collect::<Vec<_>>()).expect("different vertices")),
            )
        })
        .collect()
}

/// Meshes side by side, vertices renumbered.
pub fn disjoint(meshes: &[&[Face]]) -> Vec<Face> {
    let mut first = 0;
    let mut all = Vec::new();
    for faces in meshes {
        let moved = |l: &[u32]| l.iter().map(|v| v + first).collect::<Vec<u32>>();
        all.extend(
            faces.iter().map(|f| Face { outer: moved(&f.outer), holes: f.holes.iter().map(|h| moved(h)).collect() }),
        );
        first += faces.iter().flat_map(Face::vertices).max().map_or(0, |v| v + 1);
    }
    all
}

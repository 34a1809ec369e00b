//! The triangles of a cell.

use crate::domain::*;
use isoracle::isosurface::cases::Case;
use isoracle::isosurface::cell::{Decisions, Obstacle, Topology, assemble, decide};
use isoracle::isosurface::classes::{classes, tunnels};
use isoracle::isosurface::cube::{Corner, Edge, Face};
use isoracle::isosurface::patch::{Patch, PatchVertex, patch, share_a_face};
use isoracle::mesh::triangles::{Triangle, defects};
use proptest::prelude::*;
use rayon::prelude::*;
use std::collections::{BTreeSet, HashMap};

/// A vertex of cells side by side: twice the midpoint of its grid edge, or an inner vertex by its cell and number.
type Key = ([i32; 3], Option<(usize, u8)>);

/// Patches of cells side by side as one mesh; a cell lies at an offset, and crossings of one grid edge are one vertex.
pub fn glued(patches: &[([i32; 3], &Patch)]) -> (usize, Vec<Triangle>) {
    let mut numbers: HashMap<Key, u32> = HashMap::new();
    let mut triangles = Vec::new();
    for (cell, (offset, patch)) in patches.iter().enumerate() {
        for triangle in &patch.triangles {
            triangles.push(triangle.map(|vertex| {
                let key = match vertex {
                    PatchVertex::Inner(i) => ([0; 3], Some((cell, i))),
                    PatchVertex::Crossing(edge) => {
                        let [a, b] = edge.corners().map(Corner::position);
                        ([0, 1, 2].map(|i| 2 * offset[i] + i32::from(a[i] + b[i])), None)
                    }
                };
                let next = numbers.len() as u32;
                *numbers.entry(key).or_insert(next)
            }));
        }
    }
    (numbers.len(), triangles)
}

/// Whether both crossings lie in one face of the cell, by the geometry of a cell of the class.
fn lies_in_a_face(a: Edge, b: Edge) -> bool {
    let fixed = |e: Edge| {
        let [p, q] = e.corners().map(Corner::position);
        (0..3).filter(move |&i| p[i] == q[i]).map(move |i| (i, p[i]))
    };
    fixed(a).any(|plane| fixed(b).any(|other| plane == other))
}

mod is_90 {
    use super::*;

    /// Whether the polygon has a triangulation without a chord in a face, by trying each.
    fn has_triangulation(rim: &[Edge]) -> bool {
        let n = rim.len();
        n == 3
            || (0..n).any(|i| {
                (i + 2..n).filter(|j| i > 0 || *j < n - 1).any(|j| {
                    let cut = [rim[i..=j].to_vec(), [&rim[j..], &rim[..=i]].concat()];
                    // A smallest ear first: one part is a triangle.
                    cut.iter().any(|part| part.len() == 3)
                        && !lies_in_a_face(rim[i], rim[j])
                        && cut.iter().all(|part| has_triangulation(part))
                })
            })
    }

    #[test]
    fn the_discs_of_four_cases_need_an_inner_vertex_and_no_others_do() {
        let mut need: BTreeSet<(&str, usize)> = BTreeSet::new();
        let mut need_not: BTreeSet<(&str, usize)> = BTreeSet::new();
        for class in classes() {
            let cell = assemble(class);
            for component in cell.components.iter().filter(|c| c.chi == 1) {
                let rim = &cell.loops[component.loops[0]];
                let set = if has_triangulation(rim) { &mut need_not } else { &mut need };
                set.insert((cell.case.name(), rim.len()));
            }
            let discs_alone = cell.components.iter().all(|c| c.chi == 1);
            if discs_alone {
                let in_need = cell.components.iter().filter(|c| !has_triangulation(&cell.loops[c.loops[0]])).count();
                assert_eq!(patch(&cell).inner.len(), in_need, "{class:?}");
            }
        }
        assert_eq!(need, BTreeSet::from([("7.3", 9), ("10.2", 8), ("13.3", 9), ("13.4", 12)]));
        assert!(need.is_disjoint(&need_not));
    }
}

/// The patch of each class, with its topology.
pub fn patches() -> Vec<(Decisions, Topology, Patch)> {
    classes()
        .into_iter()
        .map(|class| {
            let cell = assemble(class);
            let patch = patch(&cell);
            (class, cell, patch)
        })
        .collect()
}

mod is_91 {
    use super::*;

    #[test]
    fn no_inner_edge_of_a_patch_lies_in_a_face_of_the_cell() {
        for (class, cell, patch) in patches() {
            let mut arcs: BTreeSet<[Edge; 2]> = BTreeSet::new();
            for cycle in &cell.loops {
                for (i, &a) in cycle.iter().enumerate() {
                    let b = cycle[(i + 1) % cycle.len()];
                    arcs.extend([[a, b], [b, a]]);
                }
            }
            for [a, b, c] in &patch.triangles {
                for pair in [[a, b], [b, c], [c, a]] {
                    if let [PatchVertex::Crossing(a), PatchVertex::Crossing(b)] = pair.map(|v| *v) {
                        assert_eq!(share_a_face(a, b), lies_in_a_face(a, b));
                        assert!(arcs.contains(&[a, b]) || !lies_in_a_face(a, b), "{class:?}");
                    }
                }
            }
        }
    }

    /// The triangulation of the polygon by its chords from one vertex.
    fn fan(rim: &[Edge], from: usize) -> Patch {
        let at = |i: usize| PatchVertex::Crossing(rim[(from + i) % rim.len()]);
        Patch { inner: Vec::new(), triangles: (1..rim.len() - 1).map(|i| [at(0), at(i), at(i + 1)]).collect() }
    }

    /// All ways to triangulate an annulus by rungs between its rims, which no inner vertex ends.
    fn annuli(first: &[Edge], second: &[Edge]) -> Vec<Patch> {
        let (n, m) = (first.len(), second.len());
        let mut found = Vec::new();
        for start in 0..m {
            for steps in (0u32..1 << (n + m)).filter(|steps| steps.count_ones() as usize == n) {
                let (mut i, mut j) = (0, 0);
                let mut triangles = Vec::new();
                for k in 0..n + m {
                    // Along the first rim, and, as both are boundary, against the second.
                    let [a, b] = [first[i % n], second[(start + m * 2 - j) % m]];
                    let next = if steps >> k & 1 == 1 {
                        i += 1;
                        first[i % n]
                    } else {
                        j += 1;
                        second[(start + m * 2 - j) % m]
                    };
                    triangles.push([a, next, b].map(PatchVertex::Crossing));
                }
                found.push(Patch { inner: Vec::new(), triangles });
            }
        }
        found
    }

    /// The patch of the mirror image of the cell across a face.
    fn mirrored(patch: &Patch, axis: usize) -> Patch {
        let image = |v: PatchVertex| match v {
            PatchVertex::Inner(i) => PatchVertex::Inner(i),
            PatchVertex::Crossing(e) => {
                let [a, b] = e.corners().map(|c| c.across(axis));
                PatchVertex::Crossing(Edge::between(a, b).expect("a symmetry keeps edges"))
            }
        };
        let triangles = patch.triangles.iter().map(|[a, b, c]| [image(*a), image(*c), image(*b)]).collect();
        Patch { inner: patch.inner.clone(), triangles }
    }

    /// Edges with more than two triangles where a cell and its mirror image across a face have the same patch, each being
    /// sound alone.
    fn overused(patch: &Patch, face: Face) -> usize {
        let mut offset = [0; 3];
        offset[face.axis()] = if face.side() == 0 { -1 } else { 1 };
        let (vertices, triangles) = glued(&[([0; 3], patch)]);
        assert_eq!(defects(vertices, &triangles), [], "sound alone");
        let (vertices, triangles) = glued(&[([0; 3], patch), (offset, &mirrored(patch, face.axis()))]);
        defects(vertices, &triangles).iter().filter(|d| d.name() == "edge_used_gt2").count()
    }

    #[test]
    fn a_chord_in_a_face_may_meet_the_same_chord_of_the_neighbour() {
        // Smallest: face z = 0 is (−2, 1, 1, −1), the least that is ambiguous and not degenerate; all other samples are 1.
        let values = [-2, 1, 1, -1, 1, 1, 1, 1];
        let cell = assemble(decide(&words(&values)).expect("not degenerate"));
        assert_eq!(cell.case, Case::C3_2);
        let [rim] = &cell.loops[..] else { panic!("one loop") };
        let face = Face::new(2, 0);
        let counts: Vec<usize> = (0..rim.len()).map(|from| overused(&fan(rim, from), face)).collect();
        assert!(counts.iter().any(|n| *n > 0), "{counts:?}");
        // The patch by the rule does not.
        assert_eq!(overused(&patch(&cell), face), 0);
        let least = all::<4>(&[-2, -1, 1, 2])
            .filter(|g| g[0] * g[3] > 0 && g[1] * g[2] > 0 && g[0] * g[1] < 0 && g[0] * g[3] != g[1] * g[2])
            .map(|g| g.map(i64::abs).iter().sum::<i64>())
            .min();
        assert_eq!(least, Some(5));
    }

    #[test]
    fn so_may_the_rungs_of_two_neighbouring_tunnels() {
        let values = [-3, -2, 1, 3, 4, 1, -2, -2];
        let cell = assemble(decide(&words(&values)).expect("not degenerate"));
        assert_eq!(cell.case, Case::C10_1_2);
        let face = Face::ALL.into_iter().find(|f| cell.decisions.faces[f.index()] != 0).expect("an ambiguous face");
        let [first, second] = &cell.loops[..] else { panic!("two loops") };
        let sound = annuli(first, second).into_iter().filter(|patch| {
            let (vertices, triangles) = glued(&[([0; 3], patch)]);
            defects(vertices, &triangles).is_empty()
        });
        let counts: Vec<usize> = sound.map(|patch| overused(&patch, face)).collect();
        assert!(counts.iter().any(|n| *n > 0), "{counts:?}");
        assert_eq!(overused(&patch(&cell), face), 0);
    }
}

mod is_92 {
    use super::*;

    #[test]
    fn every_tunnel_has_two_rungs_that_do_not_cross() {
        let mut seen = 0;
        for (class, cell, patch) in patches().into_iter().filter(|(class, ..)| class.tunnel.is_some()) {
            seen += 1;
            let annulus = cell.components.iter().find(|c| c.chi == 0).expect("a tunnel");
            let [first, second] = [0, 1].map(|i| &cell.loops[annulus.loops[i]]);
            let allowed = |a: &Edge, b: &Edge| !lies_in_a_face(*a, *b);
            // Two rungs with four different ends never cross: the strip goes one way round between them.
            let rungs: Vec<[Edge; 2]> =
                first.iter().flat_map(|a| second.iter().filter(|b| allowed(a, b)).map(|b| [*a, *b])).collect();
            let two = rungs.iter().any(|[a, b]| rungs.iter().any(|[c, d]| a != c && b != d));
            assert!(two, "{class:?}");
            // The patch has them.
            let used: BTreeSet<[Edge; 2]> = patch
                .triangles
                .iter()
                .flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]])
                .filter_map(|pair| match pair {
                    [PatchVertex::Crossing(a), PatchVertex::Crossing(b)] => Some([a, b]),
                    [_, _] => None,
                })
                .filter(|[a, b]| first.contains(a) && second.contains(b))
                .collect();
            assert!(used.len() >= 2, "{class:?}");
        }
        assert_eq!(seen, 148);
    }
}

mod is_93 {
    use super::*;

    /// Where a critical point inside is all that is degenerate, there is a tunnel just beside the level on one side.
    fn check(values: &[i64; 8]) -> bool {
        if decide(&integers(values)) != Err(Obstacle::Interior) {
            return false;
        }
        let beside = [-1, 1].map(|side| {
            let near: [i64; 8] = values.map(|v| (v << 40) + side);
            decide(&integers(&near)).expect("no critical value so near")
        });
        let [without, with] = beside.map(|d| Decisions { tunnel: None, ..d });
        assert_eq!(without, with, "{values:?}");
        assert_eq!(beside.iter().filter(|d| d.tunnel.is_some()).count(), 1, "{values:?}");
        assert!(!tunnels(&without).is_empty(), "{values:?}");
        true
    }

    #[test]
    fn a_critical_point_inside_needs_a_class_with_a_tunnel() {
        let mut sets = SETS.to_vec();
        sets.push([-3, -1, 1, 3]);
        let seen: usize = sets.iter().map(|set| all::<8>(set).filter(check).count()).sum();
        assert!(seen > 20, "{seen}");
    }

    proptest! {
        #[test]
        fn planted_ones_too(values in critical()) {
            check(&values);
        }
    }
}

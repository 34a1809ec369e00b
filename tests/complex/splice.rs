//! The three operators, against an exchange in the flags.

use super::facet_edge_samples::*;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::facet_edge::FacetEdgeStructure;
use isoracle::complex::flag::{Flag, Flags};
use isoracle::complex::handle::{Handle, Space};
use isoracle::complex::splice::{Splice, SpliceError};
use proptest::prelude::*;
use std::collections::BTreeSet;

fn structure_of(scheme: isoracle::complex::scheme::GluingScheme) -> FacetEdgeStructure {
    FacetEdgeStructure::of(&ClosedComplex::new(scheme).expect("a closed complex"))
}

fn isolated(n: usize) -> FacetEdgeStructure {
    let mut structure = FacetEdgeStructure::default();
    (0..n).for_each(|_| {
        structure.make_facet_edge();
    });
    structure
}

/// Small structures: isolated pairs, rings of several sizes, a torus, one that is not orientable.
fn small() -> Vec<FacetEdgeStructure> {
    let mut structures = vec![isolated(1), isolated(2), isolated(3)];
    structures.extend([(2, 1), (3, 1), (5, 2)].map(|(p, q)| structure_of(lens_space(p, q))));
    structures.extend([2, 3].map(|n| structure_of(ring_of_lenses(n))));
    structures.extend([three_torus(), mirrored_torus()].map(structure_of));
    structures
}

/// The rings of faces of all versions of all pairs in a space, each as a set of handles.
fn rings(structure: &FacetEdgeStructure, space: Space) -> BTreeSet<BTreeSet<Handle>> {
    structure.handles(space).into_iter().map(|a| structure.facet_ring(a).into_iter().collect()).collect()
}

/// What the exchange of a Fnext and b Fnext makes of the flags, for primal handles: σ₂ exchanges its values at a and b, and at
/// what σ₀ makes of them. `None` if it cannot, because the two want different things of one flag.
fn exchanged(structure: &FacetEdgeStructure, a: Handle, b: Handle) -> Option<Flags> {
    let flags = structure.to_flags();
    let mut sigma = [0, 1, 2, 3].map(|k| flags.all().map(|flag| flags.sigma(k, flag).0).collect::<Vec<u32>>());
    let [x, y] = [flag_of(a), flag_of(b)];
    let after = |k: usize, flag: Flag| flags.sigma(k, flag);
    let [x2, y2] = [after(2, x), after(2, y)];
    let mut wanted = std::collections::BTreeMap::new();
    let mut fits = true;
    for (one, other) in [(x, y2), (y, x2), (after(0, x), after(0, y2)), (after(0, y), after(0, x2))] {
        for (one, other) in [(one, other), (other, one)] {
            fits &= *wanted.entry(one).or_insert(other) == other;
        }
    }
    wanted.iter().for_each(|(one, other)| sigma[2][one.0 as usize] = other.0);
    fits.then(|| Flags::new(sigma).ok()).flatten()
}

/// What splice_facets has to say by the flags alone, for primal handles.
fn expected(structure: &FacetEdgeStructure, a: Handle, b: Handle) -> Option<(Splice, FacetEdgeStructure)> {
    if a == b {
        return Some((Splice::Unchanged, structure.clone()));
    }
    let flags = exchanged(structure, a, b)?;
    let after = FacetEdgeStructure::of_flags(&flags).ok()?;
    let edges = [structure.to_flags(), flags].map(|flags| flags.orbits(&[0, 2, 3]).1);
    match edges {
        [before, after_it] if after_it + 1 == before => Some((Splice::Joined, after)),
        [before, after_it] if after_it == before + 1 => Some((Splice::Split, after)),
        // A part of the ring was turned over: neither.
        _ => None,
    }
}

/// All that is promised of splice_facets (a, b) on a sound structure.
fn assert_contract(before: &FacetEdgeStructure, a: Handle, b: Handle) -> Result<Splice, SpliceError> {
    let mut after = before.clone();
    let effect = after.splice_facets(a, b);
    assert_eq!(after.defects(), []);
    match effect {
        Err(_) => assert_eq!(&after, before, "nothing is half done"),
        Ok(effect) => {
            assert_eq!([after.fnext(a), after.fnext(b)], [before.fnext(b), before.fnext(a)]);
            assert_eq!(rings(&after, a.space().other()), rings(before, a.space().other()), "the other rings");
            let touched = [before.facet_ring(a), before.facet_ring(b)].concat();
            let pairs: BTreeSet<u32> = touched.iter().map(|h| h.pair()).collect();
            let mut untouched = rings(before, a.space());
            untouched.retain(|ring| ring.iter().all(|h| !pairs.contains(&h.pair())));
            assert!(untouched.is_subset(&rings(&after, a.space())), "rings of faces of other edges");
            let [ring_a, ring_b]: [BTreeSet<Handle>; 2] = [a, b].map(|h| after.facet_ring(h).into_iter().collect());
            match effect {
                Splice::Joined => {
                    assert!(ring_a == ring_b && touched.iter().copied().collect::<BTreeSet<_>>() == ring_a)
                }
                Splice::Split => {
                    assert!(ring_a.is_disjoint(&ring_b));
                    let both: BTreeSet<Handle> = ring_a.union(&ring_b).copied().collect();
                    assert_eq!(both, touched.into_iter().collect());
                }
                Splice::Unchanged => assert_eq!(&after, before),
            }
            let mut back = after.clone();
            back.splice_facets(a, b).expect("its own inverse");
            assert_eq!(&back, before);
        }
    }
    effect
}

mod cx_24 {
    use super::*;

    #[test]
    fn an_isolated_pair_is_the_sphere_with_one_cell_of_each_dimension() {
        let mut structure = FacetEdgeStructure::default();
        assert!(structure.is_empty());
        let a = structure.make_facet_edge();
        assert_laws(&structure);
        assert_eq!([structure.enext(a), structure.fnext(a)], [a; 2]);
        assert_eq!(structure.counts(), [1, 1, 1, 1]);
        assert_eq!(structure, structure.dual());
        let sphere = ClosedComplex::new(lens_space(1, 0)).expect("a closed complex");
        assert!(structure.isomorphism(&FacetEdgeStructure::of(&sphere)).is_some());
        let homology = sphere.chain_complex().homology();
        assert_eq!(homology.betti, [1, 0, 0, 1]);
        assert!(homology.torsion.iter().all(Vec::is_empty) && sphere.is_orientable());
    }

    #[test]
    fn nothing_else_is_touched() {
        let mut structure = structure_of(three_torus());
        let before = structure.clone();
        let a = structure.make_facet_edge();
        assert_eq!(a, Handle::base(12));
        assert!(all_handles(&before).into_iter().all(|h| structure.fnext(h) == before.fnext(h)));
        assert_eq!(structure.components().len(), 2);
    }
}

mod cx_25 {
    use super::*;

    #[test]
    fn every_pair_of_handles_is_spliced_or_refused_as_the_flags_say() {
        for structure in small() {
            let handles = structure.handles(Space::Primal);
            let some = if structure.len() > 6 { 16 } else { handles.len() };
            for a in &handles[..some] {
                for b in &handles {
                    let effect = assert_contract(&structure, *a, *b);
                    let mut after = structure.clone();
                    let _ = after.splice_facets(*a, *b);
                    match expected(&structure, *a, *b) {
                        None => assert!(effect.is_err(), "({a}), ({b})"),
                        Some((as_expected, by_flags)) => {
                            assert_eq!(effect, Ok(as_expected), "({a}), ({b})");
                            assert_eq!(after.to_flags(), by_flags.to_flags());
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn one_ring_is_broken_only_where_both_walk_it_the_same_way() {
        let structure = structure_of(three_torus());
        let a = Handle::base(0);
        let ring = structure.facet_ring(a);
        assert_eq!(ring.len(), 4);
        for (k, b) in ring.iter().enumerate() {
            let mut spliced = structure.clone();
            // F_a ≡ F_b; as printed, two rings.
            assert_eq!(spliced.splice_facets(a, *b), Ok(if k == 0 { Splice::Unchanged } else { Splice::Split }));
            // Behind a stands what was behind b.
            assert_eq!(spliced.facet_ring(a).len(), 4 - k);
            assert_eq!(spliced.facet_ring(*b).len(), if k == 0 { 4 } else { k });
        }
        let refusals = ring.iter().flat_map(|b| [b.clock(), b.spin(), b.flip()]).map(|b| {
            let mut spliced = structure.clone();
            spliced.splice_facets(a, b).expect_err("another sense")
        });
        let refusals: Vec<SpliceError> = refusals.collect();
        assert!(matches!(
            refusals[3..6],
            [SpliceError::Clockwise(..), SpliceError::Spins(..), SpliceError::Directions(..)]
        ));
        assert_eq!(refusals.len(), 12);
    }

    #[test]
    fn in_one_ring_walked_two_ways_the_exchange_breaks_nothing() {
        // a and a Fnext² Clock: the member in between is turned over; the ring stays one of four.
        let structure = structure_of(three_torus());
        let a = Handle::base(0);
        let b = structure.facet_ring(a)[2].clock();
        let flags = exchanged(&structure, a, b).expect("an exchange");
        let turned = FacetEdgeStructure::of_flags(&flags).expect("sound");
        assert_eq!(turned.counts()[1], structure.counts()[1]);
        assert_eq!(turned.facet_ring(a).len(), 4);
        // a and a Fnext Clock: nothing is in between, and the edge would end in its middle.
        let b = structure.facet_ring(a)[1].clock();
        assert!(exchanged(&structure, a, b).is_none_or(|flags| FacetEdgeStructure::of_flags(&flags).is_err()));
        // Opposite directions: the edge is turned on itself, wherever b stands.
        for b in structure.facet_ring(a) {
            let torn = exchanged(&structure, a, b.flip());
            assert!(torn.is_none_or(|flags| FacetEdgeStructure::of_flags(&flags).is_err()));
        }
    }

    #[test]
    fn handles_of_no_pair_or_of_two_spaces_are_refused() {
        let mut structure = isolated(2);
        let (a, stray) = (Handle::base(0), Handle::base(2).clock());
        assert_eq!(structure.splice_facets(a, stray), Err(SpliceError::NoSuchPair(stray)));
        assert_eq!(structure.splice_facets(stray, a), Err(SpliceError::NoSuchPair(stray)));
        let b = Handle::base(1).sdual();
        assert_eq!(structure.splice_facets(a, b), Err(SpliceError::Spaces(a, b)));
        assert_eq!(structure, isolated(2));
    }
}

mod cx_26 {
    use super::*;

    /// Where the second handle of a splice is taken from.
    #[derive(Clone, Copy, Debug)]
    enum Second {
        Any(usize),
        /// A member of the first one's ring, in one of four versions.
        Ring(usize, usize),
        /// A version of the first one, in either space.
        Version(usize),
    }

    fn second() -> impl Strategy<Value = Second> {
        prop_oneof![
            3 => any::<usize>().prop_map(Second::Any),
            3 => (any::<usize>(), 0..4_usize).prop_map(|(i, version)| Second::Ring(i, version)),
            1 => (0..8_usize).prop_map(Second::Version),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if crate::is_long() { 2_000 } else { 60 }))]

        #[test]
        fn every_operation_keeps_the_structure_sound(
            start in 0..4_usize,
            operations in proptest::collection::vec((any::<usize>(), second(), any::<bool>()), 1..24),
        ) {
            let mut structure = match start {
                0 => isolated(9),
                1 => structure_of(three_torus()),
                2 => structure_of(mirrored_torus()),
                _ => structure_of(lens_space(7, 2)),
            };
            for (first, second, edges) in operations {
                let handles = all_handles(&structure);
                let a = handles[first % handles.len()];
                let b = match second {
                    Second::Any(i) => handles[i % handles.len()],
                    Second::Ring(i, version) => {
                        let ring = structure.facet_ring(a);
                        let b = ring[i % ring.len()];
                        [b, b.clock(), b.spin(), b.flip()][version]
                    }
                    Second::Version(i) => Handle::versions(a.pair())[i],
                };
                let effect = assert_contract(&structure, a, b);
                if a.space() == Space::Primal && b.space() == Space::Primal {
                    let as_expected = expected(&structure, a, b).map(|(effect, _)| effect);
                    prop_assert_eq!(effect.ok(), as_expected);
                }
                let done = match edges {
                    true => structure.splice_edges(a.sdual(), b.sdual()),
                    false => structure.splice_facets(a, b),
                };
                prop_assert_eq!(done, effect);
                assert_laws(&structure);
            }
        }
    }
}

mod cx_27 {
    use super::*;

    #[test]
    fn splice_edges_is_splice_facets_of_the_dual() {
        for structure in small() {
            let handles = structure.handles(Space::Primal);
            // What is primal here is dual there.
            let there = |h: Handle| {
                let place = Handle::versions(h.pair()).iter().position(|v| *v == h.sdual()).expect("a version");
                let same_bits = Handle::versions(h.pair())[place - 4];
                // Sdual exchanges the bits: direction and spin stand in the other places.
                if same_bits.is_reversed() == same_bits.is_counter() { same_bits } else { same_bits.clock() }
            };
            for a in handles.iter().take(12) {
                for b in &handles {
                    let (mut edges, mut facets) = (structure.clone(), structure.dual());
                    let effect = edges.splice_edges(*a, *b);
                    assert_eq!(effect.is_ok(), facets.splice_facets(there(*a), there(*b)).is_ok());
                    assert_eq!(edges.dual(), facets, "({a}), ({b})");
                    if effect.is_ok() {
                        assert_eq!([edges.enext(*a), edges.enext(*b)], [structure.enext(*b), structure.enext(*a)]);
                    }
                    assert_eq!(rings(&edges, Space::Primal), rings(&structure, Space::Primal), "rings of faces stay");
                }
            }
        }
    }

    #[test]
    fn one_ring_of_edges_is_broken_and_joined_again() {
        let structure = structure_of(lens_space(5, 2));
        let a = Handle::base(0);
        let b = structure.edge_ring(a)[2];
        let mut spliced = structure.clone();
        assert_eq!(spliced.splice_edges(a, b), Ok(Splice::Split));
        assert_eq!([spliced.edge_ring(a).len(), spliced.edge_ring(b).len()], [3, 2]);
        assert_eq!(spliced.counts()[2], structure.counts()[2] + 1);
        assert_eq!(spliced.splice_edges(a, b), Ok(Splice::Joined));
        assert_eq!(spliced, structure);
        assert!(matches!(spliced.splice_edges(a, b.clock()), Err(SpliceError::Clockwise(..))));
    }
}

mod cx_28 {
    use super::*;

    /// The structure made again from isolated pairs: rings of faces, then rings of edges, member by member.
    fn made(structure: &FacetEdgeStructure) -> FacetEdgeStructure {
        let mut made = isolated(structure.len());
        for space in [Space::Primal, Space::Dual] {
            let mut done = BTreeSet::new();
            for a in structure.handles(space) {
                if !done.contains(&a.pair()) {
                    let ring = structure.facet_ring(a);
                    for ends in ring.windows(2) {
                        assert_eq!(made.splice_facets(ends[0], ends[1]), Ok(Splice::Joined));
                    }
                    done.extend(ring.iter().map(|h| h.pair()));
                }
            }
        }
        made
    }

    #[test]
    fn the_three_operators_make_every_structure() {
        let gluings = closed(tetrahedron_gluings()).into_iter().chain(closed(cube_gluings()));
        for complex in gluings.chain(examples().into_iter().map(|(_, complex)| complex)) {
            let structure = FacetEdgeStructure::of(&complex);
            assert_eq!(made(&structure), structure);
        }
    }

    /// χ of the surfaces that bound the polyhedra, maps 0, 1, 2, or stand around the vertices, maps 1, 2, 3.
    fn surfaces(structure: &FacetEdgeStructure, [i, j, k]: [usize; 3]) -> Vec<i64> {
        let flags = structure.to_flags();
        let (surface_of, surfaces) = flags.orbits(&[i, j, k]);
        let mut chi = vec![0; surfaces];
        for (maps, sign) in [([j, k], 1), ([i, k], -1), ([i, j], 1)] {
            let (orbit_of, _) = flags.orbits(&maps);
            let mut seen = BTreeSet::new();
            for flag in flags.all().filter(|flag| seen.insert(orbit_of[flag.0 as usize])) {
                chi[surface_of[flag.0 as usize] as usize] += sign;
            }
        }
        chi
    }

    #[test]
    fn a_splice_may_leave_the_manifolds() {
        let (polyhedra, vertices) = ([0, 1, 2], [1, 2, 3]);
        let torus = structure_of(three_torus());
        let a = Handle::base(0);
        for b in &torus.facet_ring(a)[1..] {
            let mut split = torus.clone();
            assert_eq!(split.splice_facets(a, *b), Ok(Splice::Split));
            assert_eq!(split.counts(), [1, 4, 3, 1]);
            assert_eq!([surfaces(&split, polyhedra), surfaces(&split, vertices)], [vec![0], vec![2]]);
            assert_eq!(split.defects(), []);
        }
        let mut lens = structure_of(lens_space(3, 1));
        let b = lens.edge_ring(a)[1];
        assert_eq!(lens.splice_edges(a, b), Ok(Splice::Split));
        assert_eq!(lens.counts(), [1, 1, 2, 1]);
        assert_eq!([surfaces(&lens, polyhedra), surfaces(&lens, vertices)], [vec![2], vec![0]]);
    }
}

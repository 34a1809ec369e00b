//! Isomorphisms and parts of facet-edge structures.

use super::facet_edge_samples::*;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::lens_space;
use isoracle::complex::facet_edge::FacetEdgeStructure;
use isoracle::complex::handle::{Handle, Space};
use proptest::prelude::*;

mod cx_43 {
    use super::*;

    /// A handle that has the turns of one against its base, done to another one.
    fn turned(one: Handle, other: Handle) -> Handle {
        let mut turned = other;
        if one.is_reversed() {
            turned = turned.flip();
        }
        if one.is_counter() {
            turned = turned.spin();
        }
        turned
    }

    /// That a list of images of bases is an isomorphism.
    fn assert_isomorphism(one: &FacetEdgeStructure, other: &FacetEdgeStructure, images: &[Handle]) {
        let image = |h: Handle| turned(h, images[h.pair() as usize]);
        for a in one.handles(Space::Primal) {
            assert_eq!(image(one.fnext(a)), other.fnext(image(a)));
            assert_eq!(image(one.enext(a)), other.enext(image(a)));
        }
        let mut pairs: Vec<u32> = images.iter().map(|h| h.pair()).collect();
        pairs.sort();
        assert_eq!(pairs, (0..other.len() as u32).collect::<Vec<_>>());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]

        #[test]
        fn renumbered_pairs_in_other_versions_are_found_again(
            example in 0..15_usize,
            numbers in proptest::collection::vec(any::<u32>(), 64),
        ) {
            let (_, complex) = examples().swap_remove(example);
            let structure = FacetEdgeStructure::of(&complex);
            // The bases of pairs are the first flags of their orbits: other flags, other numbers and bases.
            let mut order: Vec<usize> = (0..complex.flags().len()).collect();
            order.sort_by_key(|i| (numbers[i % 64] >> (i / 64 % 8), *i));
            let mut place = vec![0; order.len()];
            order.iter().enumerate().for_each(|(new, old)| place[*old] = new as u32);
            let sigma = |k| order.iter().map(|old| place[complex.flags().sigma(k, isoracle::complex::flag::Flag(*old as u32)).0 as usize]).collect();
            let flags = isoracle::complex::flag::Flags::new([sigma(0), sigma(1), sigma(2), sigma(3)]).expect("flags");
            let other = FacetEdgeStructure::of_flags(&flags).expect("sound");
            let images = structure.isomorphism(&other).expect("the same complex");
            assert_isomorphism(&structure, &other, &images);
        }
    }

    #[test]
    fn different_complexes_are_told_apart() {
        let structures: Vec<(String, FacetEdgeStructure)> =
            examples().into_iter().map(|(name, complex)| (name, FacetEdgeStructure::of(&complex))).collect();
        for (i, (one_name, one)) in structures.iter().enumerate() {
            for (j, (other_name, other)) in structures.iter().enumerate() {
                // L(1, 0) is the ring of one, its own dual, and L(4, 2) no other one of the list.
                let same = i == j
                    || [one_name, other_name].iter().all(|name| ["L(1, 0)", "ring of 1"].contains(&name.as_str()));
                let found = one.isomorphism(other);
                assert_eq!(found.is_some(), same, "{one_name}, {other_name}");
                found.iter().for_each(|images| assert_isomorphism(one, other, images));
            }
        }
        let lens = |p, q| FacetEdgeStructure::of(&ClosedComplex::new(lens_space(p, q)).expect("closed"));
        // As complexes L(7, q) and L(7, r) are the same iff r = ±q: the polyhedron has no other way to be laid on itself.
        for q in 0..7 {
            for r in 0..7 {
                assert_eq!(lens(7, q).isomorphism(&lens(7, r)).is_some(), q == r || q + r == 7, "{q}, {r}");
            }
        }
    }

    #[test]
    fn a_wrong_start_is_no_reason_to_give_up() {
        // Two components of one size: the first one of the other structure is not the first one's.
        let mut one = FacetEdgeStructure::default();
        let mut other = FacetEdgeStructure::default();
        for (structure, order) in [(&mut one, [0, 1]), (&mut other, [1, 0])] {
            for joined in order {
                let (a, b) = (structure.make_facet_edge(), structure.make_facet_edge());
                let done = if joined == 1 { structure.splice_facets(a, b) } else { structure.splice_edges(a, b) };
                done.expect("isolated pairs");
            }
        }
        assert_eq!(one.components(), [[0, 1], [2, 3]]);
        let images = one.isomorphism(&other).expect("the same components");
        assert_isomorphism(&one, &other, &images);
        // A component twice is not two different ones.
        let twice = one.part(&[0, 1]).expect("a component");
        let mut doubled = twice.clone();
        let (a, b) = (doubled.make_facet_edge(), doubled.make_facet_edge());
        doubled.splice_edges(a, b).expect("isolated pairs");
        assert!(doubled.isomorphism(&one).is_none() && one.isomorphism(&doubled).is_none());
    }

    #[test]
    fn a_covering_is_no_isomorphism() {
        // Two pairs in one ring of faces cover an isolated pair twice.
        let mut isolated = FacetEdgeStructure::default();
        let (a, b) = (isolated.make_facet_edge(), isolated.make_facet_edge());
        let mut joined = isolated.clone();
        joined.splice_facets(a, b).expect("isolated pairs");
        assert!(joined.isomorphism(&isolated).is_none() && isolated.isomorphism(&joined).is_none());
    }

    #[test]
    fn a_part_is_made_of_whole_rings() {
        let structure = FacetEdgeStructure::of(&ClosedComplex::new(torus_beside_lens()).expect("closed"));
        let components = structure.components();
        let sizes: Vec<usize> = components.iter().map(Vec::len).collect();
        assert_eq!(sizes, [12, 3]);
        for component in &components {
            let part = structure.part(component).expect("a component");
            assert_laws(&part);
            assert_eq!(part.components().len(), 1);
            assert_eq!(structure.part(&component[1..]), None, "a ring leads out");
            assert_eq!(structure.part(&[&component[..], &component[..1]].concat()), None, "twice");
        }
        assert_eq!(structure.part(&[15]), None);
        assert_eq!(structure.part(&[]), Some(FacetEdgeStructure::default()));
    }
}

//! Algorithm 1, as printed and in readings that fail, against complexes glued from flags.

use super::facet_edge_samples::*;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::facet_edge::FacetEdgeStructure;
use isoracle::complex::glue_tetra::{AssemblyError, GlueError, SeparateTetrahedra, corners};
use isoracle::complex::handle::{Handle, Space};
use isoracle::complex::polyhedron::PolyhedronFlaw;
use isoracle::complex::scheme::{Polyhedron, SchemeDefect, SignedEdge};
use isoracle::complex::splice::SpliceError;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use std::collections::BTreeSet;

/// Ways to read the lines of the algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reading {
    AsPrinted,
    /// Line 2:2 belongs to the `if`, as its part 2:1:2.
    TakenOutOnlyIfJoined,
    /// Line 2:2 is left out.
    NeverTakenOut,
    /// Without the `if`: line 2:1:1 always.
    AlwaysJoined,
    /// F_a and F_b are rings of the complex C, where b = a Fnext: line 2:1:1 never.
    NeverJoined,
}

/// The lines of the algorithm in a reading; refusals of splices are left where they are.
fn glue(structure: &mut FacetEdgeStructure, a: Handle, b: Handle, reading: Reading) {
    let (mut a, mut b) = (a, b);
    let first_a = a;
    loop {
        let distinct = !structure.facet_ring(a).contains(&b);
        if (distinct && reading != Reading::NeverJoined) || reading == Reading::AlwaysJoined {
            let _ = structure.splice_facets(a, structure.fprev(b));
        }
        let take_out = match reading {
            Reading::AsPrinted | Reading::AlwaysJoined | Reading::NeverJoined => true,
            Reading::TakenOutOnlyIfJoined => distinct,
            Reading::NeverTakenOut => false,
        };
        if take_out {
            let _ = structure.splice_facets(a, structure.fprev(a));
        }
        (a, b) = (structure.enext(a), structure.enext(b));
        if a == first_a {
            return;
        }
    }
}

/// The tetrahedra of a complex glued in a reading, without components of three pairs, which are triangles by themselves.
fn glued_in(complex: &ClosedComplex, reading: Reading) -> FacetEdgeStructure {
    let pairs = FacetEdgeStructure::of(complex);
    let separate = SeparateTetrahedra::of(&pairs);
    let mut structure = separate.structure().clone();
    for a in pairs.gluings() {
        glue(&mut structure, separate.ahead(a), separate.ahead(pairs.fnext(a).spin()).spin(), reading);
    }
    let kept: Vec<u32> = structure.components().into_iter().filter(|pairs| pairs.len() > 3).flatten().collect();
    structure.part(&kept).expect("whole components")
}

/// The complex of the topological tetrahedra, glued as a scheme of tetrahedra.
fn tetrahedra_of(complex: &ClosedComplex) -> FacetEdgeStructure {
    let scheme = scheme_of(&complex.tetrahedra());
    FacetEdgeStructure::of(&ClosedComplex::new(scheme).expect("no edge of a tetrahedron is turned"))
}

fn complexes() -> Vec<(String, ClosedComplex)> {
    let tetrahedra = closed(tetrahedron_gluings()).into_iter().step_by(if crate::is_long() { 1 } else { 4 });
    let cubes = closed(cube_gluings()).into_iter().step_by(if crate::is_long() { 5 } else { 40 });
    let gluings = tetrahedra.chain(cubes).enumerate().map(|(i, complex)| (format!("gluing {i}"), complex));
    examples().into_iter().chain(gluings).collect()
}

mod cx_30 {
    use super::*;

    #[test]
    fn as_printed_the_algorithm_glues_the_tetrahedra_of_every_complex() {
        for (name, complex) in complexes() {
            let expected = tetrahedra_of(&complex);
            assert_eq!(expected.len(), 6 * complex.facet_edge_pairs(), "{name}");
            let printed = glued_in(&complex, Reading::AsPrinted);
            assert!(printed.isomorphism(&expected).is_some(), "{name}");
            assert_eq!(printed.defects(), []);
            let ours = complex.glued_tetrahedra();
            assert!(ours.isomorphism(&expected).is_some(), "{name}");
        }
    }

    #[test]
    fn a_triangle_has_to_be_taken_out_where_the_rings_are_one_already() {
        // The last triangle to be glued at an edge finds the ring closed but for it.
        let torus = ClosedComplex::new(three_torus()).expect("closed");
        let expected = tetrahedra_of(&torus);
        for reading in [Reading::TakenOutOnlyIfJoined, Reading::NeverTakenOut] {
            let glued = glued_in(&torus, reading);
            assert!(glued.isomorphism(&expected).is_none(), "{reading:?}");
            assert!(glued.len() > expected.len(), "{reading:?}");
        }
        // With one tetrahedron, glued to itself, too.
        let sphere = ClosedComplex::new(lens_space(1, 0)).expect("closed");
        assert!(glued_in(&sphere, Reading::AsPrinted).isomorphism(&tetrahedra_of(&sphere)).is_some());
        assert!(glued_in(&sphere, Reading::TakenOutOnlyIfJoined).isomorphism(&tetrahedra_of(&sphere)).is_none());
    }

    #[test]
    fn the_gluings_may_come_in_any_order() {
        let complex = ClosedComplex::new(mirrored_torus()).expect("closed");
        let (pairs, expected) = (FacetEdgeStructure::of(&complex), tetrahedra_of(&complex));
        let mut runner = proptest::test_runner::TestRunner::deterministic();
        let cases = if crate::is_long() { 60 } else { 6 };
        for _ in 0..cases {
            let order = Just(pairs.gluings()).prop_shuffle().new_tree(&mut runner).expect("a shuffle").current();
            let versions =
                proptest::collection::vec(0..4_usize, order.len()).new_tree(&mut runner).expect("numbers").current();
            let mut separate = SeparateTetrahedra::of(&pairs);
            for (a, version) in order.into_iter().zip(versions) {
                // Each gluing has four names.
                let b = pairs.fnext(a);
                let a = [a, a.flip(), b.clock(), b.spin()][version];
                separate.glue(a, pairs.fnext(a)).expect("each triangle is free");
                assert_eq!(separate.structure().defects(), []);
            }
            assert!(separate.without_left_over().isomorphism(&expected).is_some());
        }
    }
}

mod cx_31 {
    use super::*;

    /// Rings that are one already have a and b next to each other: in every gluing of every complex.
    #[test]
    fn where_the_rings_are_one_b_is_next_to_a() {
        let (mut distinct, mut one) = (0, 0);
        for (name, complex) in complexes() {
            let pairs = FacetEdgeStructure::of(&complex);
            let mut separate = SeparateTetrahedra::of(&pairs);
            for h in pairs.gluings() {
                let (a, b) = (separate.ahead(h), separate.ahead(pairs.fnext(h).spin()).spin());
                let mut trial = separate.structure().clone();
                let sides = trial.edge_ring(a).into_iter().zip(trial.edge_ring(b)).collect::<Vec<_>>();
                for (a, b) in sides {
                    match trial.facet_ring(a).contains(&b) {
                        true => {
                            assert_eq!(trial.fnext(a), b, "{name}");
                            one += 1;
                        }
                        false => distinct += 1,
                    }
                    let _ = trial.splice_facets(a, trial.fprev(b));
                    let _ = trial.splice_facets(a, trial.fprev(a));
                }
                separate.glue(h, pairs.fnext(h)).expect("free triangles");
            }
        }
        assert!(distinct > 100 && one > 100);
    }

    #[test]
    fn the_test_may_be_left_out_but_not_asked_in_the_complex() {
        for (name, complex) in examples() {
            let expected = tetrahedra_of(&complex);
            let always = glued_in(&complex, Reading::AlwaysJoined);
            assert!(always.isomorphism(&expected).is_some(), "{name}: SpliceFacets (a, a) does nothing");
            // In C a and b = a Fnext are in one ring.
            let structure = FacetEdgeStructure::of(&complex);
            assert!(all_handles(&structure).iter().all(|a| structure.facet_ring(*a).contains(&structure.fnext(*a))));
            assert!(glued_in(&complex, Reading::NeverJoined).isomorphism(&expected).is_none(), "{name}");
        }
    }

    #[test]
    fn sides_of_one_edge_with_something_between_are_refused() {
        // Two opposite faces at an edge where four tetrahedra meet.
        let torus = ClosedComplex::new(three_torus()).expect("closed");
        let mut glued = torus.glued_tetrahedra();
        let a =
            glued.handles(Space::Primal).into_iter().find(|a| glued.facet_ring(*a).len() == 4).expect("a ring of four");
        let b = glued.facet_ring(a)[2];
        let before = glued.clone();
        assert_eq!(glued.glue_tetra(a, b), Err(GlueError::NotNext(a, b)));
        assert_eq!(glued, before);
    }
}

mod cx_32 {
    use super::*;

    #[test]
    fn the_loop_ends_after_three_sides_and_leaves_a_lone_triangle() {
        for (name, complex) in complexes() {
            let pairs = FacetEdgeStructure::of(&complex);
            let mut separate = SeparateTetrahedra::of(&pairs);
            for (done, h) in (1..).zip(pairs.gluings()) {
                let a = separate.ahead(h);
                let pairs_of_a: Vec<u32> = separate.structure().edge_ring(a).iter().map(|h| h.pair()).collect();
                separate.glue(h, pairs.fnext(h)).expect("free triangles");
                assert_eq!(pairs_of_a.len(), 3, "{name}");
                assert_eq!(separate.left_over().len(), 3 * done);
                let lone = separate.structure().part(&pairs_of_a).expect("a component");
                assert_eq!(lone.counts(), [3, 3, 1, 1], "{name}");
            }
            assert_eq!(separate.structure().components().len(), 2 * pairs.len() + pairs.components().len(), "{name}");
        }
    }

    #[test]
    fn a_handle_is_taken_out_of_a_ring_of_any_size() {
        for n in 1..7 {
            // A Fnext-ring of n: the dual of a ring of n edges.
            let complex = ClosedComplex::new(lens_space(n, 0)).expect("closed");
            let mut structure = FacetEdgeStructure::of(&complex).dual();
            let a = structure.handles(Space::Primal)[0];
            let before = structure.fprev(a);
            assert_eq!(structure.facet_ring(a).len(), n as usize);
            structure.splice_facets(a, before).expect("members of one ring");
            assert_eq!(structure.facet_ring(a), [a]);
            assert_eq!(structure.facet_ring(before).len(), n.max(2) as usize - 1);
        }
    }

    #[test]
    fn half_of_the_pairs_of_the_torus_are_left_over() {
        let pairs = FacetEdgeStructure::of(&ClosedComplex::new(three_torus()).expect("closed"));
        let mut separate = SeparateTetrahedra::of(&pairs);
        pairs.gluings().into_iter().for_each(|a| separate.glue(a, pairs.fnext(a)).expect("free triangles"));
        let left = separate.without_left_over();
        assert_eq!([separate.structure().len(), separate.left_over().len(), left.len()], [144, 72, 72]);
    }

    #[test]
    fn a_gluing_that_is_refused_at_a_later_side_is_undone() {
        let mut refused = 0;
        for scheme in tetrahedron_gluings() {
            let mut structure = FacetEdgeStructure::default();
            let faces = structure.add_polyhedron(&scheme.polyhedra[0]).expect("a ball");
            for pairing in &scheme.pairings {
                let [a, b] = [pairing.a, pairing.b].map(|id| &faces[id.face]);
                let b = match pairing.dir {
                    1 => b[pairing.shift as usize].spin(),
                    _ => b[(pairing.shift as usize + 2) % 3].clock(),
                };
                let before = structure.clone();
                if let Err(reason) = structure.glue_tetra(a[0], b) {
                    assert!(matches!(reason, GlueError::Splice(SpliceError::Directions(..))));
                    assert_eq!(structure, before);
                    refused += 1;
                }
                assert_eq!(structure.defects(), []);
            }
        }
        assert!(refused >= 108 - 39);
    }

    #[test]
    fn faces_that_do_not_match_are_refused_whole() {
        let mut structure = FacetEdgeStructure::default();
        let cube = structure.add_polyhedron(&Polyhedron::cube()).expect("a ball");
        let prism = structure.add_polyhedron(&Polyhedron::prism(3)).expect("a ball");
        let before = structure.clone();
        let (a, b) = (cube[0][0], prism[0][0].clock());
        assert_eq!(structure.glue_tetra(a, b), Err(GlueError::Sizes { a: 4, b: 3 }));
        let c = structure.enext(a).clock();
        assert_eq!(structure.glue_tetra(a, c), Err(GlueError::SameFace(a, c)));
        assert_eq!(structure.glue_tetra(a, a), Err(GlueError::SameFace(a, a)));
        assert_eq!(structure.glue_tetra(a, b.sdual()), Err(GlueError::Splice(SpliceError::Spaces(a, b.sdual()))));
        let stray = Handle::base(99);
        assert_eq!(structure.glue_tetra(stray, a), Err(GlueError::NoSuchPair(stray)));
        assert_eq!(structure, before);
    }
}

mod cx_33 {
    use super::*;

    #[test]
    fn polyhedra_made_by_splices_have_their_faces_and_edges() {
        let prisms = (1..7).map(Polyhedron::lens).chain((3..7).map(Polyhedron::prism));
        for polyhedron in prisms.chain([Polyhedron::tetrahedron(), Polyhedron::cube()]) {
            let mut structure = FacetEdgeStructure::default();
            let faces = structure.add_polyhedron(&polyhedron).expect("a ball");
            assert_laws(&structure);
            let vertices: BTreeSet<u32> = polyhedron.edges.iter().flatten().copied().collect();
            assert_eq!(structure.counts(), [vertices.len(), polyhedron.edges.len(), polyhedron.faces.len(), 2]);
            assert!(structure.is_orientable());
            // All sides of the handles are outside: one polyhedron, and the other one behind them.
            let (inside_or_outside, _) = structure.cells(3);
            let ahead: BTreeSet<u32> = faces.iter().flatten().map(|a| inside_or_outside[structure.index(*a)]).collect();
            assert_eq!(ahead.len(), 1);
            for face in &faces {
                assert_eq!(structure.edge_ring(face[0]), *face);
                assert!(face.iter().all(|a| structure.facet_ring(*a).len() == 2));
            }
        }
    }

    #[test]
    fn schemes_glued_by_splices_are_those_glued_by_flags_and_refused_alike() {
        let mut refused = 0;
        let named = [three_torus(), mirrored_torus(), simplex_boundary(), torus_beside_lens(), ring_of_lenses(3)];
        let lenses = (1..8).flat_map(|p| (0..p).map(move |q| lens_space(p, q)));
        let gluings = tetrahedron_gluings().into_iter().chain(cube_gluings());
        for scheme in gluings.chain(named).chain(lenses) {
            let by_splices = FacetEdgeStructure::glued(&scheme);
            match ClosedComplex::new(scheme) {
                Ok(complex) => {
                    let by_splices = by_splices.expect("a closed complex");
                    assert!(by_splices.isomorphism(&FacetEdgeStructure::of(&complex)).is_some());
                    assert_eq!(by_splices.counts(), complex.counts());
                    assert_eq!(by_splices.is_orientable(), complex.is_orientable());
                }
                Err(defects) => {
                    assert!(defects.iter().all(|defect| matches!(defect, SchemeDefect::EdgeReversed { .. })));
                    assert!(matches!(by_splices, Err(AssemblyError::Pairing { reason: GlueError::Splice(_), .. })));
                    refused += 1;
                }
            }
        }
        assert!(refused > 50);
    }

    #[test]
    fn what_is_no_ball_or_no_scheme_is_refused() {
        let mut structure = FacetEdgeStructure::default();
        let half = Polyhedron { edges: vec![[0, 0]], faces: vec![vec![SignedEdge(1)]] };
        assert!(structure.add_polyhedron(&half).is_err());
        assert_eq!(structure.add_polyhedron(&Polyhedron::default()), Err(PolyhedronFlaw::NoFace));
        assert!(structure.is_empty());
        let mut scheme = three_torus();
        scheme.pairings.pop();
        assert!(
            matches!(FacetEdgeStructure::glued(&scheme), Err(AssemblyError::Scheme(defects)) if defects.len() == 2)
        );
    }
}

mod cx_34 {
    use super::*;

    #[test]
    fn t_gluings_in_each_space_glue_each_triangle_once() {
        for (name, complex) in complexes() {
            let pairs = FacetEdgeStructure::of(&complex);
            let gluings = pairs.gluings();
            let t = pairs.len();
            let primal = gluings.iter().filter(|a| a.space() == Space::Primal).count();
            assert_eq!([primal, gluings.len() - primal], [t, t], "{name}");
            // One sense for each ring gives the same number: each pair once.
            let triangles =
                gluings.iter().flat_map(|a| [*a, pairs.fnext(*a).spin()]).map(|h| (h.pair(), corners(h)[3]));
            let triangles: Vec<(u32, usize)> = triangles.collect();
            assert_eq!(triangles.iter().collect::<BTreeSet<_>>().len(), 4 * t, "{name}");
            assert_eq!(triangles.len(), 4 * t);
        }
    }

    #[test]
    fn one_sense_for_each_ring_is_enough_and_one_space_is_not() {
        for (name, complex) in examples() {
            let pairs = FacetEdgeStructure::of(&complex);
            let mut separate = SeparateTetrahedra::of(&pairs);
            for space in [Space::Primal, Space::Dual] {
                let mut done = BTreeSet::new();
                for a in pairs.handles(space) {
                    if !done.contains(&a.pair()) {
                        for a in pairs.facet_ring(a) {
                            separate.glue(a, pairs.fnext(a)).expect("each pair once");
                            done.insert(a.pair());
                        }
                    }
                }
                let is_whole = separate.without_left_over().isomorphism(&tetrahedra_of(&complex)).is_some();
                assert_eq!(is_whole, space == Space::Dual, "{name}");
            }
        }
    }

    #[test]
    fn a_gluing_in_another_version_is_refused_as_done() {
        for (name, complex) in examples() {
            let pairs = FacetEdgeStructure::of(&complex);
            let mut separate = SeparateTetrahedra::of(&pairs);
            for a in pairs.gluings() {
                let b = pairs.fnext(a);
                separate.glue(a, b).expect("free triangles");
                let before = separate.clone();
                for again in [a, a.flip(), b.clock(), b.spin()] {
                    assert_eq!(separate.glue(again, pairs.fnext(again)), Err(GlueError::AlreadyGlued(again)), "{name}");
                }
                assert_eq!(separate, before);
            }
            // All versions of all pairs, as the words have it, are eight for each pair, four times too many.
            assert_eq!(all_handles(&pairs).len(), 4 * pairs.gluings().len());
        }
    }

    #[test]
    fn corners_are_those_of_the_topological_tetrahedra() {
        for (name, complex) in examples() {
            let (pairs, tetrahedra) = (FacetEdgeStructure::of(&complex), complex.tetrahedra());
            for a in all_handles(&pairs) {
                let b = pairs.fnext(a);
                let [tail, head, ahead, behind] = corners(a);
                let gluing = tetrahedra.gluings()[a.pair() as usize][behind];
                let [to_tail, to_head, to_ahead, to_behind] = corners(b);
                assert_eq!(gluing.tetrahedron, b.pair(), "{name}: {a}");
                let images = [tail, head, ahead, behind].map(|corner| gluing.corners.image(corner));
                assert_eq!(images, [to_tail, to_head, to_behind, to_ahead], "{name}: {a}");
            }
        }
    }
}

mod cx_35 {
    use super::*;

    /// The pairs whose tetrahedra have two of their own triangles glued.
    fn glued_to_themselves(complex: &ClosedComplex) -> BTreeSet<u32> {
        let tetrahedra = complex.tetrahedra();
        let own = |i: &u32| tetrahedra.gluings()[*i as usize].iter().any(|gluing| gluing.tetrahedron == *i);
        (0..tetrahedra.len() as u32).filter(own).collect()
    }

    #[test]
    fn a_tetrahedron_is_glued_to_itself_iff_a_pair_is_its_own_next_in_one_of_the_spaces() {
        let all = closed(tetrahedron_gluings()).into_iter().chain(closed(cube_gluings()));
        for complex in all.chain(examples().into_iter().map(|(_, complex)| complex)) {
            let structure = FacetEdgeStructure::of(&complex);
            let own = |space| {
                let bases = (0..structure.len() as u32).map(Handle::base);
                let bases = bases.map(|a| if space == Space::Primal { a } else { a.sdual() });
                bases.filter(|a| structure.fnext(*a) == *a).map(|a| a.pair()).collect::<BTreeSet<u32>>()
            };
            let both: BTreeSet<u32> = own(Space::Primal).union(&own(Space::Dual)).copied().collect();
            assert_eq!(both, glued_to_themselves(&complex));
        }
    }

    #[test]
    fn in_the_primal_space_alone_a_face_with_one_side_is_missed() {
        let complex = ClosedComplex::new(ring_of_lenses(3)).expect("closed");
        let structure = FacetEdgeStructure::of(&complex);
        assert_eq!(glued_to_themselves(&complex), BTreeSet::from([0, 1, 2]));
        assert!(
            structure.handles(Space::Primal).iter().all(|a| structure.fnext(*a) != *a && structure.enext(*a) == *a)
        );
    }

    #[test]
    fn the_algorithm_glues_a_tetrahedron_to_itself() {
        for p in 1..6 {
            let complex = ClosedComplex::new(lens_space(p, 0)).expect("closed");
            let pairs = FacetEdgeStructure::of(&complex);
            let a = Handle::base(0);
            assert_eq!(pairs.fnext(a), a);
            let mut separate = SeparateTetrahedra::of(&pairs);
            separate.glue(a, a).expect("two triangles of one tetrahedron");
            let edge = separate.ahead(a.spin()).spin();
            assert_eq!(separate.structure().facet_ring(edge), [edge], "one triangle around the edge is left");
        }
    }
}

mod cx_41 {
    use super::*;

    #[test]
    fn the_torus_is_glued_from_twelve_tetrahedra_by_24_pairs_of_triangles() {
        let torus = ClosedComplex::new(three_torus()).expect("closed");
        let glued = torus.glued_tetrahedra();
        assert_eq!(glued.counts(), [2, 14, 24, 12]);
        assert_eq!(glued.counts(), torus.tetrahedra().skeleton().counts);
        assert_eq!(FacetEdgeStructure::of(&torus).gluings().len(), 24);
    }
}

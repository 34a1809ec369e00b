//! The algebra of face-edge pairs, against the flags of the same complex.

use super::facet_edge_samples::*;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::facet_edge::{FacetEdgeDefect, FacetEdgeStructure};
use isoracle::complex::flag::{Flag, Flags};
use isoracle::complex::handle::{Handle, Space};
use std::collections::BTreeSet;

fn torus() -> ClosedComplex {
    ClosedComplex::new(three_torus()).expect("a closed complex")
}

/// All examples, all closed gluings of the tetrahedron, and closed gluings of the cube.
fn complexes() -> Vec<ClosedComplex> {
    let examples = examples().into_iter().map(|(_, complex)| complex);
    examples.chain(closed(tetrahedron_gluings())).chain(closed(cube_gluings())).collect()
}

mod cx_15 {
    use super::*;

    #[test]
    fn a_pair_has_eight_versions_and_the_flags_of_a_tetrahedron_are_the_primal_ones() {
        for (name, complex) in examples() {
            let structure = FacetEdgeStructure::of(&complex);
            let versions: BTreeSet<Handle> = (0..structure.len() as u32).flat_map(Handle::versions).collect();
            assert_eq!(versions.len(), 8 * structure.len(), "{name}");
            let handles = handles_of_flags(&complex);
            assert_eq!(handles.iter().collect::<BTreeSet<_>>().len(), complex.flags().len(), "{name}");
            assert_eq!(structure.handles(Space::Primal).len(), complex.flags().len());
        }
    }

    #[test]
    fn a_face_and_an_edge_do_not_name_a_pair() {
        // Each edge of the torus is twice in each of two faces.
        let complex = torus();
        let mut pairs = std::collections::BTreeMap::new();
        for flag in complex.flags().all() {
            *pairs.entry((complex.cell(2, flag), complex.cell(1, flag))).or_insert(0) += 1;
        }
        assert!(pairs.len() == 6 && pairs.values().all(|flags| *flags == 2 * 4));
        assert_eq!(FacetEdgeStructure::of(&complex).len(), 12);
    }

    #[test]
    fn the_names_of_versions_tell_them_apart() {
        let names: Vec<String> = Handle::versions(7).iter().map(Handle::to_string).collect();
        let primal = ["7", "7 Spin", "7 Clock", "7 Clock Spin"];
        assert_eq!(names[..4], primal);
        assert_eq!(names[4..], primal.map(|name| format!("{name} Sdual")));
    }
}

mod cx_16 {
    use super::*;

    #[test]
    fn rings_of_faces_and_of_edges_both_have_t_members() {
        for complex in complexes() {
            let structure = FacetEdgeStructure::of(&complex);
            let t = structure.len();
            assert_eq!(t, complex.facet_edge_pairs());
            // One ring for each edge and each face: each has four versions.
            for (k, sizes) in [(1, complex.edge_ring_sizes()), (2, complex.face_degrees())] {
                let mut expected = vec![0; sizes.len()];
                for (flag, h) in complex.flags().all().zip(handles_of_flags(&complex)) {
                    let ring = if k == 1 { structure.facet_ring(h) } else { structure.edge_ring(h) };
                    expected[complex.cell(k, flag) as usize] = ring.len();
                    let pairs: BTreeSet<u32> = ring.iter().map(|h| h.pair()).collect();
                    assert_eq!(pairs.len(), ring.len(), "no pair is twice in a ring");
                }
                assert_eq!(sizes, expected);
                assert_eq!(sizes.iter().sum::<usize>(), t);
            }
        }
    }

    #[test]
    fn without_multiplicity_the_sum_may_be_less() {
        let distinct = |complex: &ClosedComplex| FacetEdgeStructure::of(complex).incidences();
        assert_eq!((distinct(&torus()), torus().facet_edge_pairs()), (6, 12));
        let simplex = ClosedComplex::new(simplex_boundary()).expect("a closed complex");
        assert_eq!((distinct(&simplex), simplex.facet_edge_pairs()), (30, 30));
        let lens = ClosedComplex::new(lens_space(5, 2)).expect("a closed complex");
        assert_eq!((distinct(&lens), lens.facet_edge_pairs()), (1, 5));
    }
}

mod cx_17 {
    use super::*;

    #[test]
    fn the_laws_hold_at_every_handle() {
        for complex in complexes() {
            assert_laws(&FacetEdgeStructure::of(&complex));
        }
    }

    #[test]
    fn enext_and_fnext_are_walks_of_flags() {
        for complex in complexes() {
            let (structure, handles) = (FacetEdgeStructure::of(&complex), handles_of_flags(&complex));
            let flags = complex.flags();
            let at = |flag: Flag, maps: &[usize]| handles[flags.walk(flag, maps).0 as usize];
            for flag in flags.all() {
                let a = at(flag, &[]);
                assert_eq!(structure.enext(a), at(flag, &[0, 1]));
                assert_eq!(structure.fnext(a), at(flag, &[2, 3]));
                assert_eq!(structure.eprev(a), at(flag, &[1, 0]));
                assert_eq!(structure.fprev(a), at(flag, &[3, 2]));
                assert_eq!(a.spin(), at(flag, &[3]));
                assert_eq!(a.clock(), at(flag, &[0, 3]));
                assert_eq!(a.flip(), at(flag, &[0]));
            }
        }
    }
}

mod cx_18 {
    use super::*;

    #[test]
    fn fnext_keeps_the_edge_and_goes_through_one_polyhedron() {
        for (name, complex) in examples() {
            let structure = FacetEdgeStructure::of(&complex);
            let handles = handles_of_flags(&complex);
            let flag_at = |h: Handle| Flag(handles.iter().position(|g| *g == h).expect("a flag") as u32);
            for flag in complex.flags().all() {
                let next = flag_at(structure.fnext(handles[flag.0 as usize]));
                let same = |k| complex.cell(k, flag) == complex.cell(k, next);
                assert!(same(0) && same(1), "{name}: tail and edge");
                // The polyhedron ahead lies behind the next face.
                assert_eq!(complex.cell(3, flag), complex.cell(3, complex.flags().sigma(3, next)), "{name}");
                let ring = structure.facet_ring(handles[flag.0 as usize]).len();
                assert_eq!(ring, complex.edge_ring_sizes()[complex.cell(1, flag) as usize], "{name}");
            }
        }
    }
}

mod cx_19 {
    use super::*;

    #[test]
    fn clock_walks_both_rings_backwards() {
        for (name, complex) in examples() {
            let structure = FacetEdgeStructure::of(&complex);
            for a in all_handles(&structure) {
                let back = |mut ring: Vec<Handle>| {
                    ring[1..].reverse();
                    ring.iter().map(|h| h.clock()).collect::<Vec<_>>()
                };
                assert_eq!(structure.facet_ring(a.clock()), back(structure.facet_ring(a)), "{name}: {a}");
                assert_eq!(structure.edge_ring(a.clock()), back(structure.edge_ring(a)), "{name}: {a}");
            }
        }
    }
}

mod cx_20 {
    use super::*;

    #[test]
    fn spin_walks_the_faces_backwards_and_the_edges_on() {
        for (name, complex) in examples() {
            let structure = FacetEdgeStructure::of(&complex);
            for a in all_handles(&structure) {
                let spun = |ring: Vec<Handle>| ring.iter().map(|h| h.spin()).collect::<Vec<_>>();
                let mut faces = spun(structure.facet_ring(a));
                faces[1..].reverse();
                assert_eq!(structure.facet_ring(a.spin()), faces, "{name}: {a}");
                assert_eq!(structure.edge_ring(a.spin()), spun(structure.edge_ring(a)), "{name}: {a}");
            }
        }
    }
}

mod cx_21 {
    use super::*;

    /// The dual handle of a flag that is read (p, f, e, v): its tail is the polyhedron, its spin turns to the vertex.
    fn read_backwards(h: Handle) -> Handle {
        h.clock().sdual()
    }

    #[test]
    fn the_dual_handles_are_the_flags_read_backwards() {
        for complex in complexes() {
            let (structure, handles) = (FacetEdgeStructure::of(&complex), handles_of_flags(&complex));
            let flags = complex.flags();
            // In the dual complex σ₃₋ₖ does what σₖ does in the complex.
            let at = |flag: Flag, maps: &[usize]| {
                let dual: Vec<usize> = maps.iter().map(|k| 3 - k).collect();
                read_backwards(handles[flags.walk(flag, &dual).0 as usize])
            };
            for flag in flags.all() {
                let a = at(flag, &[]);
                assert_eq!(structure.enext(a), at(flag, &[0, 1]));
                assert_eq!(structure.fnext(a), at(flag, &[2, 3]));
                assert_eq!([a.spin(), a.clock()], [at(flag, &[3]), at(flag, &[0, 3])]);
            }
        }
    }

    #[test]
    fn a_dual_that_reads_the_flag_backwards_exchanges_no_rings() {
        let structure = FacetEdgeStructure::of(&torus());
        for a in structure.handles(Space::Primal) {
            let enext = structure.enext(read_backwards(a));
            assert_eq!(read_backwards(enext), structure.fprev(a));
            assert_ne!(read_backwards(enext), structure.fnext(a));
            assert_eq!(structure.enext(a.sdual()).sdual(), structure.fnext(a));
        }
    }
}

mod cx_22 {
    use super::*;

    #[test]
    fn spin_clock_and_sdual_make_a_group_of_eight() {
        let mut reached = BTreeSet::from([Handle::base(3)]);
        let mut pending = vec![Handle::base(3)];
        while let Some(a) = pending.pop() {
            pending.extend([a.spin(), a.clock(), a.sdual()].into_iter().filter(|b| reached.insert(*b)));
        }
        assert_eq!(reached, BTreeSet::from(Handle::versions(3)));
        // Sdual Spin has order 4, so that the group is that of the square: five of its elements are of order 2.
        let mut a = Handle::base(3);
        let orders = (1..=4).map(|_| {
            a = a.sdual().spin();
            a == Handle::base(3)
        });
        assert_eq!(orders.collect::<Vec<_>>(), [false, false, false, true]);
        assert_eq!(Handle::base(3).sdual().spin().sdual().spin(), Handle::base(3).clock());
    }
}

mod cx_23 {
    use super::*;

    #[test]
    fn enext_fnext_and_clock_have_two_orbits_iff_the_complex_is_orientable() {
        let mut seen = BTreeSet::new();
        for complex in closed(cube_gluings()).into_iter().chain(closed(tetrahedron_gluings())) {
            let structure = FacetEdgeStructure::of(&complex);
            let orientable = complex.is_orientable();
            assert_eq!(structure.is_orientable(), orientable);
            assert_eq!(structure.sense_orbits().1, if orientable { 2 } else { 1 });
            seen.insert(orientable);
        }
        assert_eq!(seen.len(), 2);
    }

    #[test]
    fn components_are_oriented_each_by_itself() {
        let both = ClosedComplex::new(torus_beside_lens()).expect("a closed complex");
        let structure = FacetEdgeStructure::of(&both);
        assert_eq!((structure.sense_orbits().1, structure.components().len()), (4, 2));
        let mirrored = ClosedComplex::new(mirrored_torus()).expect("a closed complex");
        let mut mirrored = FacetEdgeStructure::of(&mirrored);
        assert!(!mirrored.is_orientable());
        // Beside a sphere it is still not orientable.
        mirrored.make_facet_edge();
        assert_eq!((mirrored.sense_orbits().1, mirrored.components().len()), (3, 2));
        assert!(!mirrored.is_orientable());
        assert_eq!(mirrored.anticlockwise(&[]), None);
    }
}

mod cx_29 {
    use super::*;

    #[test]
    fn a_complex_and_its_structure_have_the_same_flags() {
        for complex in complexes() {
            let (structure, handles) = (FacetEdgeStructure::of(&complex), handles_of_flags(&complex));
            let flags = structure.to_flags();
            for flag in complex.flags().all() {
                for k in 0..4 {
                    let there = handles[complex.flags().sigma(k, flag).0 as usize];
                    assert_eq!(flags.sigma(k, flag_of(handles[flag.0 as usize])), flag_of(there));
                }
            }
            assert_eq!(structure.counts(), complex.counts());
            let back = FacetEdgeStructure::of_flags(&flags).expect("sound");
            assert_eq!(back, structure, "the first flags of the pairs are their bases");
        }
    }

    fn base_fields(n: u32) -> Vec<[Handle; 4]> {
        (0..n).map(Handle::base).map(|a| [a, a.clock(), a.sdual(), a.clock().sdual()]).collect()
    }

    #[test]
    fn each_defect_is_told() {
        let a = Handle::base(0);
        let with = |fields: &[(usize, Handle)]| {
            let mut next = base_fields(2);
            fields.iter().for_each(|(field, h)| next[field / 4][field % 4] = *h);
            FacetEdgeStructure::new(next).expect_err("defects")
        };
        assert_eq!(with(&[(0, Handle::base(2))]), [FacetEdgeDefect::OutOfRange(a)]);
        assert_eq!(with(&[(0, a.sdual())]), [FacetEdgeDefect::OtherSpace(a)]);
        assert_eq!(with(&[(0, Handle::base(1))]).first(), Some(&FacetEdgeDefect::OneWay(a)));
        assert_eq!(with(&[(0, a.spin()), (1, a.flip())]), [FacetEdgeDefect::Folded(a)]);
        assert_eq!(with(&[(0, a.clock()), (1, a)]), [FacetEdgeDefect::Turned(a)]);
        assert_eq!(with(&[(0, a.flip()), (1, a.spin())]), [FacetEdgeDefect::Turned(a)]);
        let d = a.sdual();
        assert_eq!(with(&[(2, d.flip()), (3, d.spin())]), [FacetEdgeDefect::Turned(d)]);
    }

    #[test]
    fn flags_with_a_turned_edge_or_face_make_no_structure() {
        // σ₀ = σ₃ on both flags of a pair; and all of σ₀ … σ₃ one map.
        let swap = vec![1, 0];
        let flags = Flags::new([(); 4].map(|()| swap.clone())).expect("flags");
        assert_eq!(FacetEdgeStructure::of_flags(&flags), Err(vec![FacetEdgeDefect::PairTurned(Flag(0))]));
    }

    #[test]
    fn flags_make_a_structure_iff_no_cell_is_turned_on_itself() {
        // All flags of one pair: σ₀ and σ₃ fixed, σ₁ and σ₂ all that commute as they have to.
        let matchings = [[1, 0, 3, 2], [2, 3, 0, 1], [3, 2, 1, 0]].map(|m| m.to_vec());
        let mut sound = 0;
        for one in &matchings {
            for two in &matchings {
                let sigma = [matchings[0].clone(), one.clone(), two.clone(), matchings[1].clone()];
                let Ok(flags) = Flags::new(sigma) else { continue };
                // An edge is turned iff its two ends are one, a face iff its two sides are one.
                let [ends, edges] = [&[2, 3][..], &[0, 2, 3]].map(|maps| flags.orbits(maps).1);
                let [sides, faces] = [&[0, 1][..], &[0, 1, 3]].map(|maps| flags.orbits(maps).1);
                let whole = ends == 2 * edges && sides == 2 * faces;
                assert_eq!(FacetEdgeStructure::of_flags(&flags).is_ok(), whole);
                sound += usize::from(whole);
            }
        }
        assert_eq!(sound, 1);
    }
}

mod cx_39 {
    use super::*;

    #[test]
    fn the_torus_has_six_incidences_and_twelve_pairs() {
        let structure = FacetEdgeStructure::of(&torus());
        assert_eq!(structure.incidences(), 6, "printed, right without multiplicity");
        assert_eq!(structure.len(), 12, "printed 6");
        // By the formula of section 5.1, and by the cube: 24 places where a face meets an edge, two polyhedra sides each.
        assert_eq!(torus().edge_ring_sizes().iter().sum::<usize>(), 12);
        assert_eq!(torus().scheme().polyhedra[0].faces.iter().map(Vec::len).sum::<usize>(), 2 * 12);
        assert_eq!(torus().tetrahedra().len(), 12);
    }
}

mod cx_40 {
    use super::*;

    #[test]
    fn the_torus_has_one_vertex_three_edges_three_faces_one_polyhedron() {
        let structure = FacetEdgeStructure::of(&torus());
        assert_eq!(structure.counts(), [1, 3, 3, 1]);
        let rings: BTreeSet<usize> =
            structure.handles(Space::Primal).iter().map(|a| structure.facet_ring(*a).len()).collect();
        assert_eq!(rings, BTreeSet::from([4]));
    }
}

mod cx_42 {
    use super::*;

    #[test]
    fn the_dual_has_the_counts_backwards_and_the_rings_exchanged() {
        for complex in complexes() {
            let structure = FacetEdgeStructure::of(&complex);
            let dual = structure.dual();
            let [v, e, f, p] = structure.counts();
            assert_eq!(dual.counts(), [p, f, e, v]);
            assert_eq!(dual.dual(), structure);
            assert_laws(&dual);
            // Against the flags with their maps in reverse order.
            let flags = structure.to_flags();
            let maps = [3, 2, 1, 0].map(|k| flags.all().map(|flag| flags.sigma(k, flag).0).collect());
            let read_backwards = FacetEdgeStructure::of_flags(&Flags::new(maps).expect("flags")).expect("sound");
            assert!(dual.isomorphism(&read_backwards).is_some());
        }
    }

    #[test]
    fn lens_spaces_l_n_0_and_rings_of_lenses_are_dual() {
        for n in 1..5 {
            let lens = FacetEdgeStructure::of(&ClosedComplex::new(lens_space(n, 0)).expect("closed"));
            let ring = FacetEdgeStructure::of(&ClosedComplex::new(ring_of_lenses(n as usize)).expect("closed"));
            assert!(lens.dual().isomorphism(&ring).is_some());
            assert_eq!(lens.isomorphism(&ring).is_some(), n == 1);
        }
    }
}

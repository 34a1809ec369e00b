//! Refinement of order k: the small tetrahedra, their numbers, and the fast twin.

use super::gluings::{
    all_complexes, all_gluings, all_gluings_of_one, all_schemes, doubled, examples, scheme_of, zipped_bigon,
};
use isoracle::complex::check::{self, check};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::permutation::Perm4;
use isoracle::complex::refine::counts::{counts, most_vertices_and_polyhedra, printed_counts, printed_edges_hold};
use isoracle::complex::refine::{
    LatticePoint, RefineError, fast, lattice_points, points_of_order, rank, refine, small_tetrahedra,
};
use isoracle::complex::scheme::Polyhedron;
use isoracle::complex::triangulation::{TriangleGluing, Triangulation};
use std::collections::{BTreeMap, BTreeSet};

fn base(scheme: isoracle::complex::scheme::GluingScheme) -> Triangulation {
    ClosedComplex::new(scheme).expect("a closed complex").tetrahedra()
}

/// Without order: tetrahedra as sets of points.
fn as_sets(tetrahedra: &[[LatticePoint; 4]]) -> BTreeSet<BTreeSet<LatticePoint>> {
    tetrahedra.iter().map(|corners| BTreeSet::from(*corners)).collect()
}

fn renamed(tetrahedra: &[[LatticePoint; 4]], order: Perm4) -> Vec<[LatticePoint; 4]> {
    tetrahedra.iter().map(|corners| corners.map(|p| [0, 1, 2, 3].map(|i| p[order.image(i)]))).collect()
}

mod cx_53 {
    use super::*;

    /// Kuhn's subdivision: with x₁ ≥ x₂ ≥ x₃ the sums of the coordinates from the second, third, fourth corner of the order 0, 2, 1, 3 on,
    /// the simplices of the walks along the three axes of the cubic lattice.
    fn kuhn(k: u32) -> Vec<[LatticePoint; 4]> {
        const ORDER: [usize; 4] = [0, 2, 1, 3];
        let mut all = Vec::new();
        let inside = |[x, y, z]: [u32; 3]| k >= x && x >= y && y >= z;
        for (x, y, z) in (0..k).flat_map(|x| (0..k).flat_map(move |y| (0..k).map(move |z| (x, y, z)))) {
            for axes in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
                let mut at = [x, y, z];
                let mut walk = vec![at];
                for axis in axes {
                    at[axis] += 1;
                    walk.push(at);
                }
                if walk.iter().all(|p| inside(*p)) {
                    let point = |[x, y, z]: [u32; 3]| {
                        let mut point = [0; 4];
                        [k - x, x - y, y - z, z].iter().zip(ORDER).for_each(|(n, corner)| point[corner] = *n);
                        point
                    };
                    all.push([0, 1, 2, 3].map(|i| point(walk[i])));
                }
            }
        }
        all
    }

    #[test]
    fn they_are_those_of_the_walks_in_the_cubic_lattice() {
        for k in 1..=9 {
            let small = small_tetrahedra(k);
            assert_eq!((small.len(), as_sets(&small).len()), (k.pow(3) as usize, k.pow(3) as usize));
            assert_eq!(as_sets(&small), as_sets(&kuhn(k)), "k = {k}");
        }
    }

    #[test]
    fn each_has_the_same_volume_and_lies_inside() {
        for k in 1..=8 {
            for corners in small_tetrahedra(k) {
                assert!(corners.iter().all(|p| p.iter().sum::<u32>() == k));
                let [a, b, c] =
                    [1, 2, 3].map(|i| [1, 2, 3].map(|j| i64::from(corners[i][j]) - i64::from(corners[0][j])));
                let volume = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                    + a[2] * (b[0] * c[1] - b[1] * c[0]);
                assert_eq!(volume.abs(), 1, "1/k³ of the whole");
            }
        }
    }

    #[test]
    fn points_have_their_ranks() {
        for k in 0..12 {
            let points = lattice_points(k);
            assert_eq!(points.len(), points_of_order(k));
            assert!(points.iter().enumerate().all(|(i, p)| rank(*p) == i && p.iter().sum::<u32>() == k));
        }
    }
}

mod cx_54 {
    use super::*;

    #[test]
    fn of_order_two_they_are_eight_around_the_middles_of_both_edges() {
        let small = small_tetrahedra(2);
        let diagonal = [[1, 1, 0, 0], [0, 0, 1, 1]];
        let around = small.iter().filter(|corners| diagonal.iter().all(|p| corners.contains(p)));
        let at_corners = small.iter().filter(|corners| corners.iter().any(|p| p.contains(&2)));
        assert_eq!((small.len(), around.count(), at_corners.count()), (8, 4, 4));
    }

    #[test]
    fn the_symmetries_that_keep_them_are_those_that_keep_the_two_edges() {
        for k in 1..=6 {
            let small = small_tetrahedra(k);
            let keeps = |order: &Perm4| as_sets(&renamed(&small, *order)) == as_sets(&small);
            let pairs = |order: &Perm4| (order.image(0) / 2 == order.image(1) / 2) || k == 1;
            assert!(Perm4::all().all(|order| keeps(&order) == pairs(&order)), "k = {k}");
        }
    }
}

mod cx_55 {
    use super::*;

    #[test]
    fn there_are_k_cubed_and_twice_as_many_triangles() {
        for (name, complex) in examples().into_iter().filter(|(_, c)| c.facet_edge_pairs() < 40) {
            for k in 1..=4 {
                let counted = complex.refined(k).expect("small").triangulation().skeleton().counts.map(|n| n as u128);
                let [_, f, t] = printed_counts(complex.facet_edge_pairs() as u64, k.into());
                assert_eq!(counted[2..], [f, t], "{name}, k = {k}");
            }
        }
    }
}

mod cx_56 {
    use super::*;
    use proptest::prelude::*;

    /// Vertices by lattice points are vertices by gluings, and both ways give the same.
    fn is_consistent(base: &Triangulation, k: u32) {
        let [plain, quick] = [refine(base, k), fast::refine(base, k)].map(|r| r.expect("small"));
        assert_eq!(plain.triangulation(), quick.triangulation());
        assert_eq!(plain.vertex_count(), quick.vertex_count());
        let skeleton = plain.triangulation().skeleton();
        assert_eq!(plain.vertex_count(), skeleton.counts[0]);
        let mut names: BTreeMap<u32, [u32; 2]> = BTreeMap::new();
        let mut taken: [BTreeSet<u32>; 2] = Default::default();
        for ((glued, a), b) in skeleton.vertices.iter().zip(plain.vertices()).zip(quick.vertices()) {
            for i in 0..4 {
                assert_eq!(*names.entry(glued[i]).or_insert([a[i], b[i]]), [a[i], b[i]]);
            }
        }
        names.values().for_each(|pair| (0..2).for_each(|way| assert!(taken[way].insert(pair[way]))));
        assert!(taken.iter().all(|numbers| numbers.last() == Some(&(numbers.len() as u32 - 1))), "numbers from 0 on");
        // The table of lattice points says the same as the corners.
        let small = small_tetrahedra(k);
        for refined in [&plain, &quick] {
            let by_table =
                |i: usize| small[i % small.len()].map(|p| refined.vertex(i / small.len(), p).expect("a point"));
            assert!((0..refined.vertices().len()).all(|i| refined.vertices()[i] == by_table(i)));
        }
    }

    #[test]
    fn every_gluing_can_be_refined() {
        let paired = (1..=2).flat_map(all_gluings).chain(all_gluings(3).step_by(101));
        let gluings: Vec<Triangulation> = all_gluings_of_one().into_iter().chain(paired).collect();
        for (i, base) in gluings.iter().enumerate() {
            is_consistent(base, 1 + i as u32 % 7);
            is_consistent(base, 2 + i as u32 % 3);
        }
        for (_, complex) in examples().into_iter().filter(|(_, c)| c.facet_edge_pairs() < 40) {
            (1..=5).for_each(|k| is_consistent(&complex.tetrahedra(), k));
        }
    }

    #[test]
    fn the_space_is_the_same() {
        for base in (1..=2).flat_map(all_gluings).step_by(2).filter(super::super::gluings::has_edges) {
            let homology = |t: &Triangulation| {
                ClosedComplex::new(scheme_of(t)).expect("edges are edges").chain_complex().homology()
            };
            let before = check(&base);
            for k in 2..=3 {
                let refined = refine(&base, k).expect("small");
                let after = check(refined.triangulation());
                assert_eq!((before.components, before.orientable), (after.components, after.orientable));
                assert_eq!(before.defects.len(), after.defects.len());
                assert_eq!(homology(&base), homology(refined.triangulation()));
            }
        }
    }

    #[test]
    fn orders_that_are_none_are_refused() {
        let base = base(lens_space(1, 0));
        for way in [refine, fast::refine] {
            assert_eq!(way(&base, 0).err(), Some(RefineError::OrderZero));
            assert_eq!(way(&base, 646).err(), Some(RefineError::TooLarge { tetrahedra: 1, order: 646 }));
            assert_eq!(way(&base, u32::MAX).err(), Some(RefineError::TooLarge { tetrahedra: 1, order: u32::MAX }));
        }
        let refined = refine(&base, 2).expect("small");
        assert_eq!(refined.vertex(0, [1, 1, 1, 0]), None);
        assert_eq!(refined.vertex(1, [1, 1, 0, 0]), None);
        assert_eq!(refined.vertex(0, [u32::MAX; 4]), None);
        assert_eq!(refined.vertex(usize::MAX, [1, 1, 0, 0]), None);
        assert!(refined.vertex(0, [0, 0, 0, 2]).is_some());
        assert_eq!(refined.order(), 2);
    }

    /// n tetrahedra, triangles in twos at random, any corner on any; tetrahedra glued to themselves among them.
    fn any_gluing() -> impl Strategy<Value = Triangulation> {
        let triangles = (1_usize..5).prop_flat_map(|n| {
            let order = Just((0..4 * n).collect::<Vec<_>>()).prop_shuffle();
            (Just(n), order, proptest::collection::vec(0_usize..6, 2 * n))
        });
        triangles.prop_map(|(n, order, turns)| {
            let mut gluings = vec![[TriangleGluing { tetrahedron: 0, corners: Perm4::IDENTITY }; 4]; n];
            for (pair, turn) in order.chunks(2).zip(turns) {
                let [(s, i), (u, j)] = [pair[0], pair[1]].map(|n| (n / 4, n % 4));
                let corners = Perm4::all().filter(|p| p.image(i) == j).nth(turn).expect("six of them");
                gluings[s][i] = TriangleGluing { tetrahedron: u as u32, corners };
                gluings[u][j] = TriangleGluing { tetrahedron: s as u32, corners: corners.inverse() };
            }
            Triangulation::new(gluings).expect("glued in twos")
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

        #[test]
        fn random_gluings_can_be_refined(base in any_gluing(), k in 1_u32..6) {
            is_consistent(&base, k);
            let refined = refine(&base, k).expect("small");
            prop_assert_eq!(check(refined.triangulation()), check::fast::check(refined.triangulation()));
            prop_assert_eq!(check(&base), check::fast::check(&base));
        }
    }
}

mod cx_57 {
    use super::*;

    #[test]
    fn vertices_and_edges_are_as_many_as_are_counted() {
        let not_manifolds = all_complexes(&Polyhedron::cube()).step_by(211);
        let mut characteristics = BTreeSet::new();
        for complex in examples().into_iter().map(|(_, c)| c).filter(|c| c.facet_edge_pairs() < 40).chain(not_manifolds)
        {
            let [v, _, _, p] = complex.counts();
            let chi = complex.euler_characteristic();
            characteristics.insert(chi);
            for k in 1..=8 {
                let expected = counts((v + p) as u64, complex.facet_edge_pairs() as u64, chi, k);
                if complex.facet_edge_pairs() as u64 * k.pow(3) < 3000 {
                    let refined = fast::refine(&complex.tetrahedra(), k as u32).expect("small");
                    assert_eq!(
                        check::fast::check(refined.triangulation()).counts.map(|n| n as i128),
                        expected,
                        "k = {k}"
                    );
                }
                // By cells: k − 1 points inside an edge, (k−1 over 2) inside a triangle, (k−1 over 3) inside a tetrahedron.
                let [v, e, f, t] = complex.tetrahedra().skeleton().counts.map(|n| n as i128);
                let m = i128::from(k) - 1;
                assert_eq!(expected[0], v + e * m + f * (m * (m - 1) / 2) + t * (m * (m - 1) * (m - 2) / 6));
                assert_eq!(expected[0] - expected[1] + expected[2] - expected[3], i128::from(chi));
            }
        }
        assert!(characteristics.len() > 2, "{characteristics:?}");
    }
}

mod cx_58 {
    use super::*;

    #[test]
    fn the_three_torus_has_fewer_edges_than_printed() {
        let base = base(three_torus());
        let counted = [1, 2, 3].map(|k| refine(&base, k).expect("small").triangulation().skeleton().counts[1]);
        assert_eq!(counted, [14, 112, 378]);
        assert_eq!([1, 2, 3].map(|k| counts(2, 12, 0, k)[1]), [14, 112, 378]);
        assert_eq!([1, 2, 3].map(|k| printed_counts(12, k)[0]), [36, 156, 444]);
    }

    #[test]
    fn with_large_order_it_has_more() {
        assert_eq!((counts(2, 12, 0, 6)[1], printed_counts(12, 6)[0]), (3024, 3036));
        assert_eq!((counts(2, 12, 0, 7)[1], printed_counts(12, 7)[0]), (4802, 4716));
    }
}

mod cx_59 {
    use super::*;

    #[test]
    fn printed_edges_are_right_where_the_condition_says() {
        for (x, t, k) in (2..80).flat_map(|x| (1..60).flat_map(move |t| (1..40).map(move |k| (x, t, k)))) {
            let [printed, ..] = printed_counts(t, k);
            assert_eq!(
                counts(x, t, 0, k)[1] == printed as i128,
                printed_edges_hold(x, t, k),
                "V + P = {x}, t = {t}, k = {k}"
            );
        }
    }

    /// (V + P, t) of a complex.
    fn numbers(complex: &ClosedComplex) -> (u64, u64) {
        let [v, _, _, p] = complex.counts();
        ((v + p) as u64, complex.facet_edge_pairs() as u64)
    }

    fn orders(complex: &ClosedComplex) -> Vec<u64> {
        let (x, t) = numbers(complex);
        (1..12).filter(|k| printed_edges_hold(x, t, *k)).collect()
    }

    #[test]
    fn it_is_right_for_some_lens_spaces() {
        let mut found = Vec::new();
        for p in 1..=36 {
            for q in 0..p {
                let complex = ClosedComplex::new(lens_space(p, q)).expect("a closed complex");
                found.extend(orders(&complex).into_iter().map(|k| (p, q, k)));
            }
        }
        assert_eq!(found, [(1, 0, 1), (1, 0, 2), (1, 0, 3), (5, 0, 5), (6, 1, 6), (6, 5, 6), (12, 3, 6), (12, 9, 6)]);
        for (p, q, k) in found {
            let counted =
                refine(&base(lens_space(p, q)), k as u32).expect("small").triangulation().skeleton().counts[1];
            assert_eq!(counted as u128, printed_counts(p.into(), k)[0]);
        }
    }

    #[test]
    fn it_is_right_for_two_zipped_bigons() {
        let complex = ClosedComplex::new(doubled(zipped_bigon())).expect("a closed complex");
        assert_eq!((numbers(&complex), orders(&complex)), ((4, 2), vec![1, 2, 3]));
        for k in 1..=3 {
            let counted = complex.refined(k).expect("small").triangulation().skeleton().counts[1];
            assert_eq!(counted as u128, printed_counts(2, k.into())[0]);
        }
        // Beside L(2, 0), as a complex of two components, for k = 4.
        let (x, t) = numbers(&ClosedComplex::new(lens_space(2, 0)).expect("a closed complex"));
        assert!(printed_edges_hold(4 + x, 2 + t, 4));
    }

    #[test]
    fn of_the_cubes_it_is_right_for_those_with_three_vertices_and_order_six() {
        let mut found: BTreeMap<u64, usize> = BTreeMap::new();
        let step = if crate::is_long() { 1 } else { 3 };
        for manifold in all_schemes(&Polyhedron::cube()).step_by(step).filter_map(|scheme| Manifold3::new(scheme).ok())
        {
            assert_eq!(orders(&manifold), if manifold.counts()[0] == 3 { vec![6] } else { vec![] });
            *found.entry(numbers(&manifold).0).or_default() += 1;
        }
        let expected: &[(u64, usize)] = &[(2, 399), (3, 201), (4, 24), (5, 1)];
        match step {
            1 => assert_eq!(found, expected.iter().copied().collect()),
            _ => assert!(found[&4] > 0),
        }
    }
}

mod cx_60 {
    use super::*;

    #[test]
    fn no_connected_manifold_has_more_vertices_and_polyhedra() {
        let mut most: BTreeMap<u64, u64> = BTreeMap::new();
        let longest = if crate::is_long() { 4 } else { 3 };
        for base in (1..=longest).flat_map(all_gluings) {
            let facts = check::fast::check(&base);
            if facts.components == 1 && facts.defects.is_empty() {
                let most = most.entry(base.len() as u64).or_default();
                *most = (*most).max(facts.counts[0] as u64);
            }
        }
        assert!(most.iter().all(|(t, most)| *most == most_vertices_and_polyhedra(*t)), "{most:?}");
        for (name, complex) in examples() {
            let [v, _, _, p] = complex.counts();
            assert!((v + p) as u64 <= most_vertices_and_polyhedra(complex.facet_edge_pairs() as u64), "{name}");
        }
        // L(t, 0) has t + 1.
        for t in 1..=12 {
            let [v, _, _, p] = ClosedComplex::new(lens_space(t, 0)).expect("a closed complex").counts();
            assert_eq!((v, p), (t as usize, 1));
        }
    }
}

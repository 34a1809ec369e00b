//! When a refinement is a simplicial complex, when it has degenerate pairs, and whether the fast check agrees.

use super::gluings::{all_complexes, all_gluings, all_schemes, doubled, examples, has_edges, torus_of_cubes};
use isoracle::complex::check::{self, VertexSets, check, vertex_sets};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, three_torus};
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::refine::fast::refine;
use isoracle::complex::refine::simplicial::{Obstruction, obstructions};
use isoracle::complex::scheme::Polyhedron;
use isoracle::complex::triangulation::Triangulation;
use std::collections::{BTreeMap, BTreeSet};

/// Every gluing of up to three topological tetrahedra with edges that are edges, lens spaces, cubes; some of each where time is short.
fn bases() -> Vec<Triangulation> {
    let (triples, cubes) = if crate::is_long() { (1, 1) } else { (13, 149) };
    let gluings = (1..=2).flat_map(all_gluings).chain(all_gluings(3).step_by(triples)).filter(has_edges);
    let lenses = (1..=13).flat_map(|p| (0..p).map(move |q| (p, q))).step_by(3);
    let lenses = lenses.filter_map(|(p, q)| ClosedComplex::new(lens_space(p, q)).ok());
    let cubes = all_complexes(&Polyhedron::cube()).step_by(cubes);
    let named = examples().into_iter().map(|(_, complex)| complex).filter(|c| c.facet_edge_pairs() < 40);
    gluings.chain(lenses.chain(cubes).chain(named).map(|c| c.tetrahedra())).collect()
}

fn sets(base: &Triangulation, k: u32) -> VertexSets {
    check::fast::check(refine(base, k).expect("small").triangulation()).vertex_sets
}

mod cx_61 {
    use super::*;

    #[test]
    fn refinements_are_simplicial_iff_nothing_obstructs() {
        let mut tally: BTreeMap<(u32, bool), usize> = BTreeMap::new();
        let mut bases = bases();
        bases.extend([2, 3].map(|n| ClosedComplex::new(torus_of_cubes(n)).expect("a closed complex").tetrahedra()));
        for base in &bases {
            let found = obstructions(base);
            for k in 1..=5 {
                if base.len() > 100 && k > 3 {
                    continue;
                }
                let expected = !found.iter().any(|obstruction| obstruction.matters(k));
                assert_eq!(sets(base, k).simplicial, expected, "k = {k}: {found:?}");
                *tally.entry((k, expected)).or_default() += 1;
            }
        }
        assert!((1..=5).all(|k| tally.contains_key(&(k, true)) && tally[&(k, false)] > 20), "{tally:?}");
    }

    /// The largest order that is not simplicial.
    fn last_order(scheme: isoracle::complex::scheme::GluingScheme) -> Option<u32> {
        let base = ClosedComplex::new(scheme).expect("a closed complex").tetrahedra();
        (1..=6).rev().find(|k| !sets(&base, *k).simplicial)
    }

    #[test]
    fn each_order_is_the_first_for_some_complex() {
        assert_eq!(last_order(torus_of_cubes(3)), None);
        assert_eq!(last_order(torus_of_cubes(2)), Some(1));
        assert_eq!(last_order(three_torus()), Some(2));
        assert_eq!(last_order(lens_space(5, 2)), Some(2));
        assert_eq!(last_order(lens_space(4, 1)), Some(3));
        assert_eq!(last_order(lens_space(4, 2)), Some(6), "and for every larger one");
    }

    #[test]
    fn obstructions_of_one_order_leave_the_others_alone() {
        use Obstruction::*;
        let of = |scheme| obstructions(&ClosedComplex::new(scheme).expect("a closed complex").tetrahedra());
        assert_eq!(of(torus_of_cubes(3)), BTreeSet::from([]));
        assert_eq!(of(three_torus()), BTreeSet::from([NotSimplicial, Loop, AnglesBetweenEdges, SamePair]));
        assert_eq!(
            of(lens_space(4, 1)),
            BTreeSet::from([NotSimplicial, Loop, AnglesBetweenEdges, SamePair, TwoTriangles])
        );
        let all =
            [NotSimplicial, Loop, AnglesBetweenEdges, SamePair, TwoTriangles, AnglesBetweenEnds, CornersBetweenEnds];
        let orders = |o: Obstruction| (1..=5).filter(|k| o.matters(*k)).collect::<Vec<_>>();
        assert_eq!(
            all.map(orders),
            [vec![1], vec![1, 2], vec![2], vec![2], vec![3], vec![1, 2, 3, 4, 5], vec![1, 2, 3, 4, 5]]
        );
    }
}

mod cx_62 {
    use super::*;
    use isoracle::complex::refine::moment_point;
    use isoracle::linear::{Matrix, determinant};
    use isoracle::number::{Integer, Rational};

    #[test]
    fn eight_points_of_the_moment_curve_are_in_general_position() {
        let refined = ClosedComplex::new(lens_space(5, 2)).expect("a closed complex").refined(3).expect("small");
        assert!(vertex_sets(refined.triangulation()).simplicial);
        let vertices = refined.vertices();
        let mut seen = 0;
        for (i, a) in vertices.iter().enumerate().step_by(29) {
            for b in vertices.iter().skip(i + 1).step_by(31) {
                let eight: BTreeSet<u32> = a.iter().chain(b).copied().collect();
                let Ok(eight) = <[u32; 8]>::try_from(eight.into_iter().collect::<Vec<_>>()) else { continue };
                let points = eight.map(moment_point);
                let entry = |i: usize, j: usize| if j == 0 { Integer::from(1) } else { points[i][j - 1].clone() };
                assert_ne!(determinant(&Matrix::<Rational, 8, 8>::from_fn(|i, j| Rational::from(entry(i, j)))), 0);
                seen += 1;
            }
        }
        assert!(seen > 3, "{seen}");
    }

    #[test]
    fn tetrahedra_with_two_corners_at_a_vertex_are_not_rectilinear() {
        let base = ClosedComplex::new(three_torus()).expect("a closed complex").tetrahedra();
        assert_eq!([1, 2, 3].map(|k| sets(&base, k).simplicial), [false, false, true]);
        assert_eq!(
            sets(&base, 1).degenerate_tetrahedra,
            12,
            "of order 1 each of the 12 has two different points for corners"
        );
        // Of order 2 two straight edges from the vertex to the middle of a loop have the same ends.
        let skeleton = refine(&base, 2).expect("small").triangulation().skeleton();
        let ends: BTreeSet<[u32; 2]> = skeleton
            .vertices
            .iter()
            .flat_map(|v| isoracle::complex::triangulation::EDGES.map(|[i, j]| [v[i].min(v[j]), v[i].max(v[j])]))
            .collect();
        assert!(ends.len() < skeleton.counts[1], "{} of {}", ends.len(), skeleton.counts[1]);
    }
}

mod cx_63 {
    use super::*;

    #[test]
    fn the_fast_check_says_what_the_plain_one_says() {
        for (i, base) in bases().iter().chain(&(1..=2).flat_map(all_gluings).collect::<Vec<_>>()).enumerate() {
            assert_eq!(check(base), check::fast::check(base));
            let refined = refine(base, 2 + i as u32 % 3).expect("small");
            assert_eq!(check(refined.triangulation()), check::fast::check(refined.triangulation()));
        }
    }
}

mod cx_64 {
    use super::*;

    #[test]
    fn refined_after_gluing_there_are_degenerate_pairs_all_the_same() {
        // Two tetrahedra glued along their surfaces: printed none, counted 6k, for any k.
        let base = ClosedComplex::new(doubled(Polyhedron::tetrahedron())).expect("a sphere").tetrahedra();
        let counted: Vec<usize> = (1..=8).map(|k| sets(&base, k).duplicate_tetrahedra).collect();
        assert_eq!(counted, [6, 12, 18, 24, 30, 36, 42, 48]);
        let torus = ClosedComplex::new(three_torus()).expect("a closed complex").tetrahedra();
        assert_eq!([1, 2, 3].map(|k| sets(&torus, k).duplicate_tetrahedra), [11, 0, 0]);
        let lens = ClosedComplex::new(lens_space(5, 2)).expect("a closed complex").tetrahedra();
        assert_eq!([1, 2, 3].map(|k| sets(&lens, k).duplicate_tetrahedra), [4, 20, 0]);
    }

    #[test]
    fn from_order_three_on_there_are_some_iff_two_corners_are_between_the_same_ends() {
        let mut tally: BTreeMap<bool, usize> = BTreeMap::new();
        for base in bases() {
            let expected = obstructions(&base).contains(&Obstruction::CornersBetweenEnds);
            for k in 3..=5 {
                let VertexSets { degenerate_tetrahedra, duplicate_tetrahedra, .. } = sets(&base, k);
                assert_eq!(duplicate_tetrahedra > 0, expected, "k = {k}");
                assert!(expected || degenerate_tetrahedra == 0);
            }
            *tally.entry(expected).or_default() += 1;
        }
        assert!(tally.len() == 2 && tally.values().all(|n| *n > 20), "{tally:?}");
    }

    #[test]
    fn of_small_manifolds_they_are_those_with_an_edge_of_one_or_two_tetrahedra() {
        let (triples, cubes) = if crate::is_long() { (1, 1) } else { (3, 7) };
        let gluings = (1..=2).flat_map(all_gluings).chain(all_gluings(3).step_by(triples));
        let cubes = all_schemes(&Polyhedron::cube()).step_by(cubes).filter_map(|scheme| Manifold3::new(scheme).ok());
        let mut tally: BTreeMap<bool, usize> = BTreeMap::new();
        for base in
            gluings.filter(|base| check::fast::check(base).defects.is_empty()).chain(cubes.map(|m| m.tetrahedra()))
        {
            let mut around: BTreeMap<u32, usize> = BTreeMap::new();
            base.skeleton().edges.iter().flatten().for_each(|edge| *around.entry(*edge).or_default() += 1);
            let small = around.values().any(|n| *n < 3);
            assert_eq!(obstructions(&base).contains(&Obstruction::CornersBetweenEnds), small);
            *tally.entry(small).or_default() += 1;
        }
        assert!(tally.len() == 2 && tally.values().all(|n| *n > 20), "{tally:?}");
    }
}

//! The strategies and `Arbitrary` implementations that the features expose, used as another crate would.
#![cfg(all(feature = "proptest", feature = "quickcheck"))]

use isoracle::isosurface::cases::Case;
use isoracle::isosurface::cell::{Tie, decisions, topology};
use isoracle::isosurface::cube::Symmetry;
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::isosurface::{fast, mesh, strategy, topology as whole};
use isoracle::mesh::defects::{Category, check};
use isoracle::mesh::face::Face;
use isoracle::mesh::strategy as mesh_strategy;
use isoracle::mesh::vertex_list::VertexList;
use isoracle::number::Rational;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

fn rationals(values: [i32; 8]) -> [Rational; 8] {
    values.map(Rational::from)
}

proptest! {
    #[test]
    fn a_cell_of_a_case_has_that_case_or_its_mirror_image(
        (case, values) in strategy::case().prop_flat_map(|case| (Just(case), strategy::cell_of(case)))
    ) {
        let found = topology(&values, &Rational::new(), Tie::Degenerate).unwrap().case;
        let mirror = match case {
            Case::C11 => Case::C14,
            Case::C14 => Case::C11,
            Case::C12_2 => Case::C12_3,
            Case::C12_3 => Case::C12_2,
            other => other,
        };
        prop_assert!(found == case || found == mirror, "{} for {}", found, case);
    }

    #[test]
    fn breaking_ties_changes_nothing_where_there_is_none(values in strategy::nearly_degenerate_cell()) {
        let (values, zero) = (rationals(values), Rational::new());
        let below = decisions(&values, &zero, Tie::Below).unwrap();
        if let Ok(exact) = decisions(&values, &zero, Tie::Degenerate) {
            prop_assert_eq!(exact, below);
        }
    }

    #[test]
    fn a_small_positive_shift_of_the_values_is_the_tie_below(values in strategy::tied_cell()) {
        // Values are integers of at most 3: the decisions are polynomials of degree 4 with small coefficients, whose
        // smallest roots are far above this ε.
        let (values, epsilon) = (rationals(values), Rational::from((1, 1_000_000_000_000_i64)));
        let below = decisions(&values, &Rational::new(), Tie::Below).unwrap();
        prop_assert_eq!(decisions(&values, &-epsilon, Tie::Degenerate), Ok(below));
    }

    #[test]
    fn fast_and_plain_agree_on_volumes_with_ties(volume in strategy::volume(4), tie in strategy::tie()) {
        let level = Level { volume: &volume, isovalue: Rational::new(), tie };
        prop_assert_eq!(fast::extract(&level), mesh::extract(&level));
        prop_assert_eq!(fast::topology(&level), whole::topology(&level));
    }
}

proptest! {
    #[test]
    fn solids_are_sound_and_so_is_their_inside_out_but_for_that(solid in mesh_strategy::solid()) {
        let report = check(&solid, None);
        prop_assert!(report.defects.is_empty(), "{:?}", report.defects);
        let counts = report.counts.unwrap();
        prop_assert!(counts.manifold && counts.volume.unwrap() > 0);
        let turned = VertexList { faces: solid.faces.iter().map(Face::reversed).collect(), ..solid };
        let found: Vec<Category> = check(&turned, None).defects.iter().map(|(category, _)| category).collect();
        prop_assert_eq!(found, [Category::InsideOut]);
    }

    #[test]
    fn what_is_wrong_with_a_heap_of_faces_does_not_depend_on_where_loops_begin(heap in mesh_strategy::heap(6)) {
        let mut turned = heap.clone();
        for l in turned.faces.iter_mut().flat_map(|face| std::iter::once(&mut face.outer).chain(&mut face.holes)) {
            let by = usize::from(l.len() > 1);
            l.rotate_left(by);
        }
        let of = |mesh: &VertexList| {
            let report = check(mesh, None);
            // The volume of faces that are not plane does depend on it.
            let plane = !report.defects.has(Category::NonplanarFace);
            let kept = |category: Category| plane || !matches!(category, Category::InsideOut | Category::ZeroVolume);
            let found: Vec<_> = report.defects.iter().filter(|(c, _)| kept(*c)).map(|(c, e)| (c, e.clone())).collect();
            (found, report.counts.map(|counts| (counts.chi, counts.genus, counts.orientable)))
        };
        prop_assert_eq!(of(&heap), of(&turned));
    }
}

#[test]
fn heaps_have_most_categories() {
    let mut runner = TestRunner::deterministic();
    let strategy = mesh_strategy::heap(6);
    let mut found = std::collections::BTreeSet::new();
    for _ in 0..2_000 {
        let report = check(&strategy.new_tree(&mut runner).unwrap().current(), None);
        found.extend(report.defects.iter().map(|(category, _)| category));
    }
    assert!(found.len() >= 20, "{found:?}");
}

#[test]
fn the_strategy_of_near_ties_meets_ties_nearly() {
    let mut runner = TestRunner::deterministic();
    let strategy = strategy::nearly_degenerate_cell();
    let mut exact = 0;
    for _ in 0..400 {
        let values = strategy.new_tree(&mut runner).unwrap().current();
        exact += usize::from(decisions(&rationals(values), &Rational::new(), Tie::Degenerate).is_err());
    }
    // Some stay exactly tied, most are moved off the tie.
    assert!((10..390).contains(&exact), "{exact}");
}

quickcheck::quickcheck! {
    fn a_mesh_and_its_other_side_have_the_same_numbers(mesh: VertexList) -> bool {
        let turned = VertexList { faces: mesh.faces.iter().map(Face::reversed).collect(), ..mesh.clone() };
        let of = |mesh: &VertexList| {
            let counts = check(mesh, None).counts.unwrap();
            (counts.chi, counts.closed, counts.orientable, counts.manifold, counts.genus)
        };
        of(&mesh) == of(&turned)
    }

    fn the_topology_of_a_volume_does_not_change_when_it_is_negated_twice(volume: Volume) -> bool {
        volume.negated().negated() == volume
    }

    fn a_symmetry_of_a_cell_keeps_its_topology(symmetry: Symmetry, volume: Volume) -> bool {
        let values = volume.corner_values([0; 3]);
        let of = |values: &[Rational; 8]| {
            let t = topology(values, &Rational::new(), Tie::Below).unwrap();
            let mut lengths: Vec<usize> = t.loops.iter().map(Vec::len).collect();
            lengths.sort();
            (t.chi(), t.negative.parts.len(), t.positive.parts.len(), t.negative.b1, t.positive.b1, lengths)
        };
        of(&values) == of(&symmetry.carry(&values))
    }

    fn the_mesh_has_the_eulers_characteristic_of_the_surface(volume: Volume) -> bool {
        let level = Level { volume: &volume, isovalue: Rational::new(), tie: Tie::Below };
        let mesh = mesh::extract(&level).unwrap();
        let components = isoracle::mesh::triangles::components(mesh.vertices.len(), &mesh.triangles);
        components.iter().map(|c| c.chi).sum::<i64>() == whole::topology(&level).unwrap().chi()
    }
}

//! The whole room on every manifold of the zoo: each fact by its several routes.

use isoracle::complex::abelian::AbelianGroup;
use isoracle::complex::check::{TriangulationDefect, fast as check};
use isoracle::complex::facet_edge::FacetEdgeStructure;
use isoracle::complex::homology_fast::homology;
use isoracle::complex::manifold::Manifold3;
use isoracle::complex::refine::counts::{counts, printed_counts, printed_edges_hold};
use isoracle::complex::refine::fast::refine;
use isoracle::complex::{isosig, isosig_fast, zoo};
use isoracle::mesh::classify::SPHERE;

fn specimens() -> Vec<(&'static str, Manifold3)> {
    let all = zoo::names().into_iter().filter_map(zoo::get);
    let manifold = |scheme| Manifold3::new(scheme).unwrap_or_else(|defects| panic!("{defects:?}"));
    let all: Vec<_> = all.map(|specimen| (specimen.name, manifold(specimen.scheme))).collect();
    assert!(all.len() >= 60);
    all
}

#[test]
fn the_facet_edge_structure_is_sound_and_glued_by_splices_the_same() {
    for (name, manifold) in specimens() {
        let structure = FacetEdgeStructure::of(&manifold);
        assert_eq!(structure.defects(), [], "{name}");
        assert_eq!(structure.counts(), manifold.counts(), "{name}");
        assert_eq!(structure.len(), manifold.facet_edge_pairs(), "{name}");
        assert_eq!(manifold.edge_ring_sizes().iter().sum::<usize>(), structure.len(), "{name}");
        assert_eq!(manifold.face_degrees().iter().sum::<usize>(), structure.len(), "{name}");
        let of_flags = FacetEdgeStructure::of_flags(&structure.to_flags()).expect("its own flags");
        let glued = FacetEdgeStructure::glued(manifold.scheme()).expect("a closed scheme");
        for other in [of_flags, glued] {
            assert!(structure.isomorphism(&other).is_some(), "{name}");
        }
    }
}

/// Algorithm 1 of the text on the separate tetrahedra of each specimen of a few pairs.
#[test]
fn algorithm_1_glues_the_tetrahedra_as_the_complex_has_them() {
    let mut glued = 0;
    for (name, manifold) in specimens().into_iter().filter(|(_, manifold)| manifold.facet_edge_pairs() <= 30) {
        let skeleton = manifold.tetrahedra().skeleton().counts;
        assert_eq!(manifold.glued_tetrahedra().counts(), skeleton, "{name}");
        glued += 1;
    }
    assert!(glued >= 40, "{glued}");
}

#[test]
fn homology_group_and_orientation_agree_by_every_route() {
    for (name, manifold) in specimens() {
        let cells = manifold.chain_complex().homology();
        for triangulation in [manifold.tetrahedra(), manifold.barycentric()] {
            assert_eq!(homology(&triangulation).expect("no edge is reversed"), cells, "{name}");
            assert!(triangulation.vertex_links().iter().all(|link| *link == SPHERE), "{name}");
            let facts = check::check(&triangulation);
            let none: [TriangulationDefect; 0] = [];
            assert_eq!(facts.defects, none, "{name}");
            let routes = [facts.orientable, triangulation.is_orientable(), manifold.polyhedron_signs().is_some()];
            assert_eq!(routes, [manifold.is_orientable(); 3], "{name}");
            assert_eq!(facts.components, manifold.component_count(), "{name}");
        }
        let h1 = AbelianGroup::of_homology(&cells, 1);
        let trivial = AbelianGroup { rank: 0, torsion: Vec::new() };
        let sum = |groups: Vec<AbelianGroup>| groups.iter().fold(trivial.clone(), |sum, group| sum.sum(group));
        let cellular = manifold.fundamental_groups();
        let dual = manifold.dual_fundamental_groups();
        let simplified: Vec<_> = cellular.iter().map(|group| group.simplified()).collect();
        for groups in [cellular, dual, simplified] {
            assert_eq!(sum(groups.iter().map(|group| group.abelianisation()).collect()), h1, "{name}");
        }
        assert_eq!(manifold.euler_characteristic_by_links(), 0, "{name}");
    }
}

/// Orders 1 to 8, each refinement counted.
#[test]
fn refinements_have_the_numbers_of_the_formulas() {
    let mut printed_right = Vec::new();
    for (name, manifold) in specimens() {
        let [v, _, _, p] = manifold.counts().map(|n| n as u64);
        let pairs = manifold.facet_edge_pairs() as u64;
        let tetrahedra = manifold.tetrahedra();
        for order in 1..=8 {
            let refined = refine(&tetrahedra, order).expect("within the limit");
            let counted = check::check(refined.triangulation());
            let order = u64::from(order);
            assert_eq!(counted.counts.map(|n| n as i128), counts(v + p, pairs, 0, order), "{name}, order {order}");
            assert!(counted.defects.is_empty(), "{name}, order {order}");
            let [printed, _, _] = printed_counts(pairs, order);
            let is_right = printed == counted.counts[1] as u128;
            assert_eq!(printed_edges_hold(v + p, pairs, order), is_right, "{name}, order {order}");
            printed_right.extend(Some((name, order)).filter(|_| is_right));
        }
    }
    for known in [("L(1,0)", 1), ("L(1,0)", 2), ("L(1,0)", 3), ("L(5,0)", 5), ("L(6,1)", 6)] {
        assert!(printed_right.contains(&known), "{known:?} of {printed_right:?}");
    }
    assert!(printed_right.iter().all(|(_, order)| *order <= 6), "{printed_right:?}");
}

#[test]
fn signatures_are_read_back() {
    for (name, manifold) in specimens().into_iter().filter(|(_, manifold)| manifold.facet_edge_pairs() <= 60) {
        let triangulation = manifold.tetrahedra();
        let signature = isosig_fast::signature(&triangulation);
        let again = isosig::triangulation(&signature).expect("it was written");
        assert_eq!(isosig_fast::signature(&again), signature, "{name}");
        assert_eq!(again.skeleton().counts, triangulation.skeleton().counts, "{name}");
    }
}

//! Manifold conditions by links, against homology of links, gluings, and Seifert and Threlfall's count.

use crate::domain::{complex, cyclic_complexes, long, small_gluing, triangles};
use isoracle::mesh::classify::{NoSurface, glued_triangles, mesh_surfaces, surfaces};
use isoracle::mesh::examples::surfaces::{
    annulus, ball, cone, double_torus, dunce_hat, icosahedron, klein_bottle, moebius_band, projective_plane, sphere,
    suspension, three_torus,
};
use isoracle::mesh::gluing::Sheets;
use isoracle::mesh::homology::ChainComplex;
use isoracle::mesh::manifold::{Dimension, ManifoldDefect, border, manifold_defects};
use isoracle::mesh::simplicial::{Simplex, SimplicialComplex};
use proptest::prelude::*;
use std::collections::BTreeMap;

fn simplex(vertices: &[u32]) -> Simplex {
    Simplex::new(vertices).expect("different vertices")
}

/// The reduced homology of a sphere of dimension d, or of a point, over ℤ: d is the only dimension it may have any in.
fn has_homology_of_sphere_or_ball(link: &SimplicialComplex, d: usize) -> bool {
    let homology = ChainComplex::of_complex(link).homology();
    let mut reduced = homology.betti.clone();
    reduced.resize(d + 1, 0);
    if reduced[0] == 0 || homology.torsion.iter().any(|t| !t.is_empty()) {
        return false;
    }
    reduced[0] -= 1;
    let top = reduced.pop().expect("not empty");
    reduced.iter().all(|b| *b == 0) && top <= 1
}

/// Whether every simplex has dimension ≤ d, lies in one of dimension d, and its link has the homology of a sphere or a ball:
/// for d ≤ 3 this is a manifold with border.
fn is_homology_manifold(complex: &SimplicialComplex, d: usize) -> bool {
    complex.maximal().iter().all(|s| s.dimension() == d)
        && complex
            .simplices()
            .filter(|s| s.dimension() < d)
            .all(|s| has_homology_of_sphere_or_ball(&complex.link(s), d - s.dimension() - 1))
}

fn assert_manifold_iff(complex: &SimplicialComplex, dimension: Dimension) {
    let defects = manifold_defects(complex, dimension);
    assert_eq!(defects.is_empty(), is_homology_manifold(complex, dimension as usize), "{complex:?}: {defects:?}");
}

/// By its border and the text's conditions for closed curves and surfaces.
fn assert_extends_the_closed_conditions(complex: &SimplicialComplex) {
    for (dimension, is_closed_one) in
        [(Dimension::One, complex.curve_defects().is_empty()), (Dimension::Two, complex.surface_defects().is_empty())]
    {
        let is_closed = border(complex, dimension).simplices().next().is_none();
        assert_eq!(is_closed_one, manifold_defects(complex, dimension).is_empty() && is_closed, "{complex:?}");
    }
}

mod me_127 {
    use super::*;

    #[test]
    fn curves_and_surfaces_with_border_are_met() {
        let path = complex(&[[0, 1], [1, 2]]);
        assert_eq!(manifold_defects(&path, Dimension::One), []);
        let fork = complex(&[[0, 1], [0, 2], [0, 3]]);
        let link = ManifoldDefect::Link { simplex: simplex(&[0]), components: 3, chi: 3 };
        assert_eq!(manifold_defects(&fork, Dimension::One), [link]);
        for surface in
            [sphere(2), icosahedron(), klein_bottle(), projective_plane(), moebius_band(), annulus(), ball(2)]
        {
            assert_eq!(manifold_defects(&surface, Dimension::Two), []);
        }
        let stray = complex(&[&[0u32, 1, 2][..], &[2, 3], &[4]]);
        let isolated = |v: &[u32]| ManifoldDefect::Isolated(simplex(v));
        let link = ManifoldDefect::Link { simplex: simplex(&[2]), components: 2, chi: 2 };
        assert_eq!(manifold_defects(&stray, Dimension::Two), [isolated(&[2, 3]), isolated(&[3]), isolated(&[4]), link]);
        assert!(manifold_defects(&sphere(2), Dimension::One).contains(&ManifoldDefect::TooLarge(simplex(&[0, 1, 2]))));
        assert_eq!(manifold_defects(&SimplicialComplex::default(), Dimension::Two), []);
    }

    // Two circles have the χ of one, and their cones are discs.
    #[test]
    fn two_spheres_at_a_vertex_are_none() {
        let spheres =
            complex(&[[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3], [0, 4, 5], [0, 4, 6], [0, 5, 6], [4, 5, 6]]);
        let link = ManifoldDefect::Link { simplex: simplex(&[0]), components: 2, chi: 0 };
        assert_eq!(manifold_defects(&spheres, Dimension::Two), [link]);
        assert_manifold_iff(&spheres, Dimension::Two);
    }

    #[test]
    fn the_dunce_hat_is_no_surface_at_its_seam() {
        let defects = manifold_defects(&dunce_hat(), Dimension::Two);
        for seam in [[0, 1], [1, 2], [0, 2]] {
            let link = ManifoldDefect::Link { simplex: simplex(&seam), components: 3, chi: 3 };
            assert!(defects.contains(&link));
        }
        assert!(glued_triangles(&dunce_hat()).is_err());
        assert!(surfaces(&dunce_hat()).is_err());
    }

    #[test]
    fn every_cyclic_complex_is_judged_by_homology_and_by_gluing() {
        let sizes = if long() { 5..10 } else { 5..9 };
        for complex in sizes.flat_map(|n| [cyclic_complexes(n, 1), cyclic_complexes(n, 2)]).flatten() {
            assert_manifold_iff(&complex, Dimension::One);
            assert_manifold_iff(&complex, Dimension::Two);
            assert_extends_the_closed_conditions(&complex);
            // Glued along edges, the triangles have as many vertices iff each vertex has one fan.
            let one_fan_each = complex.of_dimension(2).next().is_some()
                && complex.maximal().iter().all(|s| s.dimension() == 2)
                && glued_triangles(&complex).is_ok_and(|g| g.counts()[0] == complex.f_vector()[0]);
            assert_eq!(manifold_defects(&complex, Dimension::Two).is_empty(), one_fan_each);
        }
    }

    #[test]
    fn faces_are_judged_as_the_complex_of_their_triangles() {
        let bowtie = complex(&[[0, 1, 2], [0, 3, 4]]);
        assert_eq!(mesh_surfaces(&triangles(&bowtie)), Err(NoSurface::Pinched(BTreeMap::from([(0, 2)]))));
        let link = ManifoldDefect::Link { simplex: simplex(&[0]), components: 2, chi: 2 };
        assert_eq!(surfaces(&bowtie), Err(vec![link]));
        assert_eq!(Sheets::new(&triangles(&bowtie)).expect("two triangles").gluing.surfaces().len(), 2);
        for surface in [klein_bottle(), double_torus(), annulus(), moebius_band()] {
            assert_eq!(mesh_surfaces(&triangles(&surface)), Ok(surfaces(&surface).expect("a surface")));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if long() { 500 } else { 100 }))]

        // Any triangles on seven vertices; few are a surface.
        #[test]
        fn random_triangles_are_judged_by_homology(sets in prop::collection::btree_set(prop::collection::btree_set(0u32..7, 1..4), 1..12)) {
            let simplices: Vec<Vec<u32>> = sets.into_iter().map(|s| s.into_iter().collect()).collect();
            let complex = complex(&simplices);
            assert_manifold_iff(&complex, Dimension::One);
            assert_manifold_iff(&complex, Dimension::Two);
            assert_extends_the_closed_conditions(&complex);
        }

        // Surfaces, and the same with two vertices made one.
        #[test]
        fn a_surface_with_two_vertices_made_one_is_none(gluing in small_gluing(), pick in any::<[prop::sample::Index; 2]>()) {
            let surface = gluing.triangulated();
            prop_assert_eq!(manifold_defects(&surface, Dimension::Two), []);
            prop_assert_eq!(surfaces(&surface).expect("a surface"), {
                let mut sorted = gluing.surfaces();
                let order = surfaces(&surface).expect("a surface");
                sorted.sort();
                let mut same = order.clone();
                same.sort();
                prop_assert_eq!(sorted, same);
                order
            });
            let vertices: Vec<u32> = surface.of_dimension(0).map(|v| v.vertices()[0]).collect();
            let [a, b] = pick.map(|i| vertices[i.index(vertices.len())]);
            let near = |v: u32| surface.link(&simplex(&[v])).of_dimension(0).cloned().collect::<Vec<_>>();
            prop_assume!(a != b && !near(a).contains(&simplex(&[b])) && near(a).iter().all(|v| !near(b).contains(v)));
            let renamed = |s: &Simplex| simplex(&s.vertices().iter().map(|v| if *v == b { a } else { *v }).collect::<Vec<_>>());
            let pinched = SimplicialComplex::new(surface.maximal().into_iter().map(renamed));
            let defects = manifold_defects(&pinched, Dimension::Two);
            let at_a = |d: &ManifoldDefect| matches!(d, ManifoldDefect::Link { simplex, components: 2, .. } if simplex.vertices() == [a]);
            prop_assert!(defects.len() == 1 && at_a(&defects[0]), "{:?}", defects);
        }
    }
}

mod me_128 {
    use super::*;

    #[test]
    fn spheres_balls_and_tori_of_dimension_three_are_manifolds() {
        for manifold in
            [sphere(3), ball(3), suspension(&sphere(2)), cone(&icosahedron()), cone(&ball(2)), three_torus(3)]
        {
            assert_eq!(manifold_defects(&manifold, Dimension::Three), []);
        }
        assert_eq!(three_torus(3).f_vector(), [27, 189, 324, 162]);
    }

    #[test]
    fn a_cone_over_another_surface_is_none_at_its_tip() {
        // (Surface, its χ, its vertex count): the tip is the next vertex.
        let all =
            [(SimplicialComplex::torus(), 0, 7), (projective_plane(), 1, 6), (klein_bottle(), 0, 8), (annulus(), 0, 6)];
        for (surface, chi, tip) in all {
            let at = |v: u32| ManifoldDefect::Link { simplex: simplex(&[v]), components: 1, chi };
            assert_eq!(manifold_defects(&cone(&surface), Dimension::Three), [at(tip)]);
            assert_eq!(manifold_defects(&suspension(&surface), Dimension::Three), [at(tip), at(tip + 1)]);
        }
        // A torus beside a disc has χ = 1 and a border, and is no disc.
        let both = cone(&SimplicialComplex::torus().disjoint_union(&ball(2)));
        let link = ManifoldDefect::Link { simplex: simplex(&[10]), components: 2, chi: 1 };
        assert_eq!(manifold_defects(&both, Dimension::Three), [link]);
        // The link of the tip has χ = 1 as a disc has, but no border.
        let closed = projective_plane();
        assert_eq!((closed.euler_characteristic(), border(&closed, Dimension::Two)), (1, SimplicialComplex::default()));
    }

    #[test]
    fn two_tetrahedra_with_less_than_a_triangle_in_common_are_none() {
        let defects = |tetrahedra: &[[u32; 4]]| manifold_defects(&complex(tetrahedra), Dimension::Three);
        assert_eq!(defects(&[[0, 1, 2, 3], [0, 1, 2, 4]]), []);
        let link = |v: &[u32], components, chi| ManifoldDefect::Link { simplex: simplex(v), components, chi };
        assert_eq!(defects(&[[0, 1, 2, 3], [0, 4, 5, 6]]), [link(&[0], 2, 2)]);
        let at_edge = [link(&[0], 1, 1), link(&[0, 1], 2, 2), link(&[1], 1, 1)];
        assert_eq!(defects(&[[0, 1, 2, 3], [0, 1, 4, 5]]), at_edge);
        assert!(defects(&[[0, 1, 2, 3], [0, 1, 2, 4], [0, 1, 2, 5]]).contains(&link(&[0, 1, 2], 3, 3)));
    }

    #[test]
    fn every_cyclic_complex_is_judged_by_homology() {
        for complex in (5..8).flat_map(|n| cyclic_complexes(n, 3)) {
            assert_manifold_iff(&complex, Dimension::Three);
        }
        if long() {
            cyclic_complexes(8, 3).iter().for_each(|complex| assert_manifold_iff(complex, Dimension::Three));
        }
    }

    // Seifert and Threlfall: where each triangle has two tetrahedra and each link is a connected closed surface, χ = Σ
    // (1 − χ(link)/2), so that it is a manifold iff χ = 0.
    #[test]
    fn a_closed_complex_of_good_links_is_a_manifold_iff_chi_is_zero() {
        let mut met = [0, 0];
        let known =
            [sphere(3), three_torus(3), suspension(&SimplicialComplex::torus()), suspension(&projective_plane())];
        for complex in known.into_iter().chain((5..9).flat_map(|n| cyclic_complexes(n, 3))) {
            let links: Vec<SimplicialComplex> = complex.of_dimension(0).map(|v| complex.link(v)).collect();
            if links.iter().all(|l| l.surface_defects().is_empty() && l.component_count() == 1) {
                let chi = complex.euler_characteristic();
                assert_eq!(2 * chi, links.iter().map(|l| 2 - l.euler_characteristic()).sum::<i64>());
                assert_eq!(manifold_defects(&complex, Dimension::Three).is_empty(), chi == 0);
                met[usize::from(chi == 0)] += 1;
            }
        }
        assert!(met[0] >= 2 && met[1] >= 4, "{met:?}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if long() { 1000 } else { 64 }))]

        #[test]
        fn random_tetrahedra_are_judged_by_homology(sets in prop::collection::btree_set(prop::collection::btree_set(0u32..6, 4), 1..10)) {
            let simplices: Vec<Vec<u32>> = sets.into_iter().map(|s| s.into_iter().collect()).collect();
            assert_manifold_iff(&complex(&simplices), Dimension::Three);
        }

        // Balls grown a tetrahedron at a time, and what they are after one more whose vertex is an old one.
        #[test]
        fn grown_complexes_are_judged_by_homology(steps in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..7)) {
            let mut tetrahedra = vec![vec![0, 1, 2, 3]];
            let mut next = 4;
            for (at, other) in &steps {
                let ball = complex(&tetrahedra);
                assert_manifold_iff(&ball, Dimension::Three);
                let border: Vec<Simplex> = border(&ball, Dimension::Three).of_dimension(2).cloned().collect();
                // Closed already.
                let Some(free) = border.get(at.index(border.len().max(1))) else { break };
                let free = free.vertices();
                let known = other.index(2 * next as usize) as u32;
                let tip = if known < next && !free.contains(&known) { known } else { next };
                next = next.max(tip + 1);
                tetrahedra.push([free, &[tip]].concat());
            }
            assert_manifold_iff(&complex(&tetrahedra), Dimension::Three);
        }
    }
}

mod me_129 {
    use super::*;

    #[test]
    fn the_border_of_a_manifold_is_a_closed_manifold() {
        assert_eq!(border(&moebius_band(), Dimension::Two).curve_defects(), []);
        assert_eq!(border(&moebius_band(), Dimension::Two).component_count(), 1);
        assert_eq!(border(&annulus(), Dimension::Two).component_count(), 2);
        assert_eq!(border(&ball(3), Dimension::Three), sphere(2));
        assert_eq!(border(&cone(&icosahedron()), Dimension::Three), icosahedron());
        assert_eq!(border(&ball(1), Dimension::One).f_vector(), [2]);
        // An edge of three triangles is not in the border.
        let book = border(&complex(&[[0, 1, 2], [0, 1, 3], [0, 1, 4]]), Dimension::Two);
        assert_eq!((book.of_dimension(1).count(), book.contains(&simplex(&[0, 1]))), (6, false));
        for complex in (5..8).flat_map(|n| [cyclic_complexes(n, 2), cyclic_complexes(n, 3)]).flatten() {
            if manifold_defects(&complex, Dimension::Two).is_empty() {
                assert_eq!(border(&complex, Dimension::Two).curve_defects(), []);
            }
            if manifold_defects(&complex, Dimension::Three).is_empty() {
                assert_eq!(border(&complex, Dimension::Three).surface_defects(), []);
            }
        }
    }

    proptest! {
        #[test]
        fn a_gluing_and_its_triangulation_have_the_same_border(gluing in small_gluing()) {
            let curves = border(&gluing.triangulated(), Dimension::Two);
            prop_assert_eq!(curves.curve_defects(), []);
            prop_assert_eq!(curves.component_count(), gluing.boundary().len());
            // Each free edge falls into three.
            let edges: usize = gluing.boundary().iter().map(Vec::len).sum();
            prop_assert_eq!(curves.of_dimension(1).count(), 3 * edges);
        }
    }
}

//! Orientation: triangles, level sets, one parametrisation, the Möbius band.

use super::q;
use super::surface_samples::{pair, surface};
use isoracle::curvature::angle_surfaces::{moebius_band, moebius_equation};
use isoracle::curvature::chart::RationalPatch;
use isoracle::curvature::parametric_surface::FundamentalForms;
use isoracle::curvature::topology::{OrientationError, orientation_count, oriented};
use isoracle::curvature::trigonometric::{Angle, Trigonometric, circle_point};
use isoracle::linear::Vector;
use isoracle::mesh::classify::{Surface, glued_triangles, surfaces};
use isoracle::mesh::examples::surfaces::{
    annulus, double_torus, klein_bottle, moebius_band as band_of_triangles, projective_plane, sphere,
};
use isoracle::mesh::gluing::Gluing;
use isoracle::mesh::manifold::{Dimension, border};
use isoracle::mesh::simplicial::{Simplex, SimplicialComplex};
use isoracle::number::{Multivariate, Rational, Ring};
use proptest::prelude::*;

fn of_word(word: &str) -> Vec<Surface> {
    Gluing::from_words(&[word]).expect("a word").surfaces()
}

mod cu_226 {
    use super::*;

    #[test]
    fn a_surface_has_two_orientations_for_each_component_or_none() {
        let small =
            [sphere(2), SimplicialComplex::torus(), projective_plane(), klein_bottle(), annulus(), band_of_triangles()];
        let two = sphere(2).disjoint_union(&annulus());
        let both = sphere(2).disjoint_union(&band_of_triangles());
        for complex in small.iter().chain([&two, &both]) {
            let count = orientation_count(complex).expect("few triangles");
            let gluing = glued_triangles(complex).expect("a surface");
            let expected = if gluing.is_orientable() { 1 << complex.component_count() } else { 0 };
            assert_eq!(count, expected);
            assert_eq!(oriented(complex).expect("a surface").is_some(), count > 0);
        }
        assert_eq!(orientation_count(&double_torus()), Err(OrientationError::TooMany(26)));
        // Three triangles at an edge are no surface.
        let book = SimplicialComplex::from_vertices(&[[0, 1, 2], [0, 1, 3], [0, 1, 4]]).expect("different vertices");
        let error = OrientationError::Edge { edge: [0, 1], triangles: 3 };
        assert_eq!((oriented(&book), orientation_count(&book)), (Err(error), Err(error)));
    }

    #[test]
    fn an_orientation_runs_along_each_inner_edge_both_ways() {
        for complex in [sphere(2), SimplicialComplex::torus(), double_torus(), annulus()] {
            let triangles = oriented(&complex).expect("a surface").expect("orientable");
            assert_eq!(triangles.len(), complex.of_dimension(2).count());
            let sides: Vec<[u32; 2]> = triangles.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]).collect();
            let border = border(&complex, Dimension::Two);
            for [a, b] in &sides {
                let edge = Simplex::new(&[*a, *b]).expect("two vertices");
                assert_eq!(sides.contains(&[*b, *a]), !border.contains(&edge));
                assert_eq!(sides.iter().filter(|side| *side == &[*a, *b]).count(), 1);
            }
        }
    }
}

mod cu_227 {
    use super::*;

    fn equation() -> Multivariate<4> {
        let [x, y, z, r] = [0, 1, 2, 3].map(Multivariate::<4>::variable);
        moebius_equation(&[x, y, z], &r)
    }

    #[test]
    fn the_level_set_has_a_one_sided_band_and_a_point_without_normal_on_it() {
        let [x, y, z] = moebius_band();
        let r = Trigonometric::parameter(0);
        assert_eq!(moebius_equation(&[x.clone(), y, z], &r), Trigonometric::integer(0));
        // Its core has the point (−R, 0, 0), where the gradient is 0.
        let core = [q(0, 1), q(1, 1), q(1, 1), q(0, 1), q(2, 1), q(0, 1)];
        assert_eq!(x.evaluate(&core), -2);
        let gradient = |at: [Rational; 4]| [0, 1, 2].map(|axis| equation().derivative(axis).evaluate(&at));
        assert_eq!(gradient([q(-2, 1), q(0, 1), q(0, 1), q(2, 1)]), [0, 0, 0]);
        assert_ne!(gradient([q(2, 1), q(0, 1), q(0, 1), q(2, 1)]), [0, 0, 0]);
    }

    /// On the sphere, ∇f·(σᵤ × σᵥ) keeps its sign over each of two charts that cover it.
    #[test]
    fn a_regular_level_set_is_oriented_by_its_gradient() {
        let mut south = RationalPatch::sphere(&q(1, 1));
        south.numerators[2] = -south.numerators[2].clone();
        let charts = [RationalPatch::sphere(&q(1, 1)), south];
        let signs = charts.map(|chart| {
            let at = (-5..=5).flat_map(|u| (-5..=5).map(move |v| [q(u, 2), q(v, 2)]));
            let signs: Vec<bool> = at
                .map(|at| {
                    let jets = chart.jets(&at).expect("no pole");
                    let gradient = Vector(jets.each_ref().map(|x| Rational::from(&x.value * 2_u32)));
                    let along = gradient.dot(&FundamentalForms::new(&jets).normal_w);
                    assert!(along != 0);
                    along > 0
                })
                .collect();
            assert!(signs.iter().all(|sign| *sign == signs[0]));
            signs[0]
        });
        assert_ne!(signs[0], signs[1]);
    }
}

mod cu_228 {
    use super::*;

    proptest! {
        /// N_z = 1/W > 0 on a graph; and W > 0 in every single parametrisation.
        #[test]
        fn a_graph_s_normal_points_up_everywhere(
            terms in prop::collection::vec((prop::array::uniform2(0..=3_u32), -4..=4_i64), 0..6), at in pair(),
            s in surface(),
        ) {
            let graph = RationalPatch::graph(Multivariate::new(terms.into_iter().map(|(e, c)| (e, q(c, 1)))));
            let forms = FundamentalForms::new(&graph.jets(&at).expect("a polynomial"));
            prop_assert_eq!(&forms.normal_w[2], &q(1, 1));
            prop_assert!(FundamentalForms::new(&s).w_squared() > 0);
        }
    }

    #[test]
    fn a_triangulated_piece_of_the_plane_is_orientable() {
        let number = |i: u32, j: u32| 5 * i + j;
        let triangles = (0..4).flat_map(|i| {
            (0..4).flat_map(move |j| {
                let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i, j + 1), number(i + 1, j + 1)];
                [[a, b, c], [b, c, d]]
            })
        });
        let complex = SimplicialComplex::from_vertices(&triangles.collect::<Vec<_>>()).expect("different vertices");
        assert!(oriented(&complex).expect("a surface").is_some());
        assert_eq!(surfaces(&complex).expect("a disc")[0].to_string(), "disc");
    }
}

mod cu_229 {
    use super::*;

    /// (c, s, t) ↦ (−c, −s, −t).
    fn once_around(f: &Trigonometric<6>) -> Trigonometric<6> {
        let [c, s] = [Trigonometric::cos(Angle::First), Trigonometric::sin(Angle::First)];
        let [d, e] = [Trigonometric::cos(Angle::Second), Trigonometric::sin(Angle::Second)];
        let at = [-c, -s, d, e, Trigonometric::parameter(0), -Trigonometric::parameter(1)];
        f.polynomial().evaluate_in(&at, |x| Trigonometric::constant(x.clone()))
    }

    #[test]
    fn the_normal_comes_back_reversed() {
        let band = moebius_band();
        assert_eq!(band.each_ref().map(once_around), band);
        let along = Vector(band.each_ref().map(|x| x.derivative(Angle::First)));
        let across = Vector(band.each_ref().map(|x| x.derivative_by_parameter(1)));
        let n = along.cross(&across);
        assert_eq!(n.map(once_around), -n.clone());
        // It is not 0 on the core: |n| = 2R there.
        let squared = n.norm_squared();
        for m in -9..=9 {
            let [c, s] = circle_point(&q(m, 4));
            assert_eq!(squared.evaluate(&[c, s, q(1, 1), q(0, 1), q(3, 1), q(0, 1)]), 36);
        }
    }

    #[test]
    fn a_rectangle_with_opposite_corners_glued_is_one_sided() {
        assert_eq!(of_word("abac")[0].to_string(), "Möbius band");
        assert_eq!(of_word("abAc")[0].to_string(), "annulus");
        // Of a strip of triangles the parity of the half twists decides.
        for n in 3..9_u32 {
            for twisted in [false, true] {
                let vertex =
                    |side: u32, i: u32| if i < n { side * n + i } else { (side ^ u32::from(twisted)) * n + i - n };
                let triangles = (0..n).flat_map(|i| {
                    let [a, b, c, d] = [vertex(0, i), vertex(1, i), vertex(0, i + 1), vertex(1, i + 1)];
                    [[a, b, c], [b, c, d]]
                });
                let strip =
                    SimplicialComplex::from_vertices(&triangles.collect::<Vec<_>>()).expect("different vertices");
                assert_eq!(
                    surfaces(&strip).expect("a surface")[0].to_string(),
                    if twisted { "Möbius band" } else { "annulus" }
                );
                assert_eq!(oriented(&strip).expect("a surface").is_none(), twisted);
            }
        }
    }
}

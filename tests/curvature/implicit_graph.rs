//! Level surfaces as graphs: equations (6), (7), (8), e, f, g by determinants, in the polynomial ring and by a second derivation.

use super::level::{any_jet, generic_jet, jet, regular_jet, sphere};
use super::q;
use isoracle::curvature::implicit_graph::{self as graph, Axis, GraphError};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::parametric_surface::FundamentalForms;
use isoracle::curvature::{implicit_printed, implicit_surface};
use isoracle::linear::{Vector, determinant3};
use isoracle::number::{Multivariate, OrderedField, Rational, Ring, Sign, Surd};
use proptest::prelude::*;

/// The quadratic polynomial of a jet at the origin.
fn quadric(jet: &Jet<Rational, 3>) -> Multivariate<3> {
    let x: [Multivariate<3>; 3] = std::array::from_fn(Multivariate::variable);
    let linear = (0..3).map(|i| x[i].clone() * &Multivariate::constant(jet.gradient[i].clone()));
    let half = |i: usize, j: usize| Multivariate::constant(Rational::from(&jet.hessian.0[i][j] / 2_u32));
    let square = (0..9).map(|k| x[k / 3].clone() * &x[k % 3] * &half(k / 3, k % 3));
    linear.chain(square).fold(Multivariate::integer(0), |sum, term| sum + &term)
}

/// The graph's coordinates as jets in x, y.
fn surface(jet: &Jet<Rational, 3>) -> Option<[Jet<Rational, 2>; 3]> {
    let g = graph::graph(jet).ok()?.jet(q(0, 1));
    let [x, y] = Jet::variables(&[q(0, 1), q(0, 1)]);
    Some([x, y, g])
}

mod cu_154 {
    use super::*;

    #[test]
    fn the_slopes_of_a_plane_are_those_of_its_equation() {
        // 2x − 3y + 4z
        let slopes = graph::graph(&jet([2, -3, 4], [0; 6])).expect("f_z ≠ 0");
        assert_eq!(slopes.first, [q(-1, 2), q(3, 4)]);
        assert_eq!(slopes.second, [q(0, 1), q(0, 1), q(0, 1)]);
    }

    #[test]
    fn without_a_slope_along_the_axis_there_is_no_graph() {
        assert_eq!(graph::graph(&jet([1, 0, 0], [0; 6])), Err(GraphError::Vertical));
        assert_eq!(graph::graph(&jet([0, 0, 0], [1; 6])), Err(GraphError::Singular));
        assert_eq!(graph::forms(&jet([1, 0, 0], [0; 6])), Err(GraphError::Vertical));
        assert_eq!(graph::gaussian_by_determinants(&jet([0, 2, 0], [1; 6])), Err(GraphError::Vertical));
        assert_eq!(graph::mean_w_by_determinants(&jet([0, 0, 0], [1; 6])), Err(GraphError::Singular));
    }
}

mod cu_155 {
    use super::*;

    proptest! {
        /// f(x, y, g(x, y)) is constant to the second order, and this makes g's derivatives the only ones.
        #[test]
        fn the_function_is_constant_on_its_graph(jet in any_jet()) {
            let Some(coordinates) = surface(&jet) else {
                prop_assert!(jet.gradient[2].is_zero());
                return Ok(());
            };
            let along = quadric(&jet).evaluate_in(&coordinates, |c| Jet::constant(c.clone()));
            prop_assert_eq!(along, Jet::integer(0));
        }
    }

    #[test]
    fn on_a_sphere_the_height_has_the_derivatives_of_a_root() {
        // g = √(9 − x² − y²) at (1, 2): g_x = −x/g, g_xx = −(g² + x²)/g³, g_xy = −xy/g³
        let jet = Jet::of_polynomial(&sphere(), &[q(1, 1), q(2, 1), q(2, 1)]);
        let derivatives = graph::graph(&jet).expect("f_z = 4");
        assert_eq!(derivatives.first, [q(-1, 2), q(-1, 1)]);
        assert_eq!(derivatives.second, [q(-5, 8), q(-2, 8), q(-8, 8)]);
    }
}

mod cu_156 {
    use super::*;

    proptest! {
        #[test]
        fn e_f_and_g_are_those_of_the_parametrisation_by_x_and_y(jet in any_jet()) {
            let Some(coordinates) = surface(&jet) else { return Ok(()) };
            let forms = graph::forms(&jet).expect("f_z ≠ 0");
            let parametric = FundamentalForms::new(&coordinates);
            prop_assert_eq!(&forms.first, &parametric.first);
            // EG − F² = |∇f|²/f_z²
            prop_assert_eq!(forms.area_squared() * Rational::from(jet.gradient[2].square_ref()), forms.gradient_squared);
        }
    }
}

mod cu_158 {
    use super::*;

    #[test]
    fn below_the_equator_the_printed_normal_is_the_opposite_one() {
        let at = |z: i64| Jet::of_polynomial(&sphere(), &[q(0, 1), q(0, 1), q(z, 1)]);
        let up = Vector([0, 0, 1].map(Surd::integer));
        let [south, north] = [at(-1), at(1)];
        assert_eq!(graph::graph(&south).expect("f_z = −2").upward_normal(), up);
        assert_eq!(implicit_printed::printed_graph_normal(&south).expect("regular"), -up.clone());
        assert_eq!(graph::graph(&north).expect("f_z = 2").upward_normal(), up);
        assert_eq!(implicit_printed::printed_graph_normal(&north).expect("regular"), up);
        assert!(implicit_printed::printed_graph_normal(&jet([0; 3], [1; 6])).is_err());
    }

    proptest! {
        #[test]
        fn the_two_normals_differ_by_the_sign_of_f_z(jet in any_jet()) {
            let Ok(g) = graph::graph(&jet) else { return Ok(()) };
            let printed = implicit_printed::printed_graph_normal(&jet).expect("f_z ≠ 0");
            let upward = g.upward_normal();
            prop_assert_eq!(upward[2].sign(), Sign::Positive);
            prop_assert_eq!(upward.norm_squared(), Surd::integer(1));
            let sign = Surd::integer(i64::from(jet.gradient[2].sign().value()));
            prop_assert_eq!(upward, printed.scaled(&sign));
        }
    }
}

/// −(first f_z² − mixed f_z + f_zz·both), the printed numerators of e, f, g, in the polynomial ring.
fn printed_numerators() -> [Multivariate<9>; 3] {
    let jet = generic_jet();
    let ([fx, fy, fz], [[fxx, fxy, fxz], [_, fyy, fyz], [_, _, fzz]]) = (&jet.gradient.0, &jet.hessian.0);
    let product = |factors: &[&Multivariate<9>]| factors.iter().fold(Multivariate::integer(1), |p, x| p * x);
    let two = &Multivariate::integer(2);
    let e = product(&[fxx, fz, fz]) - &product(&[two, fxz, fx, fz]) + &product(&[fzz, fx, fx]);
    let f = product(&[fxy, fz, fz]) - &product(&[fz, fyz, fx]) - &product(&[fz, fy, fxz]) + &product(&[fy, fzz, fx]);
    let g = product(&[fyy, fz, fz]) - &product(&[two, fyz, fy, fz]) + &product(&[fzz, fy, fy]);
    [-e, -f, -g]
}

/// The entry i of e, f, g: printed sum = determinant as polynomials, and |∇f|e = f_z g_xx.
fn assert_second_form(i: usize) {
    let numerators = graph::second_form_numerators(&generic_jet());
    assert_eq!(numerators[i], printed_numerators()[i]);
    // The determinants do not vanish, so that the equality says something.
    assert!(!numerators[i].is_zero());
}

fn second_form_is_normal_times_second_derivative(jet: &Jet<Rational, 3>, i: usize) -> Result<(), TestCaseError> {
    let Ok(derivatives) = graph::graph(jet) else { return Ok(()) };
    let forms = graph::forms(jet).expect("f_z ≠ 0");
    prop_assert_eq!(&forms.second_w[i], &Rational::from(&derivatives.second[i] * &jet.gradient[2]));
    Ok(())
}

mod cu_159 {
    use super::*;

    #[test]
    fn the_sum_is_the_determinant() {
        assert_second_form(0);
    }

    #[test]
    fn with_the_minus_at_its_first_term_alone_the_sum_is_another() {
        let jet = generic_jet();
        let [printed, ..] = printed_numerators();
        let first = jet.hessian.0[0][0].clone() * &jet.gradient[2] * &jet.gradient[2];
        // −first + rest, where −(first + rest) is meant
        let other = -printed.clone() - &(first * &Multivariate::integer(2));
        assert_ne!(other, printed);
        assert_ne!(other, -printed);
    }

    proptest! {
        #[test]
        fn e_is_the_normal_times_g_xx(jet in any_jet()) {
            second_form_is_normal_times_second_derivative(&jet, 0)?;
        }
    }
}

mod cu_160 {
    use super::*;

    #[test]
    fn the_sum_is_the_determinant() {
        assert_second_form(1);
    }

    proptest! {
        #[test]
        fn f_is_the_normal_times_g_xy(jet in any_jet()) {
            second_form_is_normal_times_second_derivative(&jet, 1)?;
        }
    }
}

mod cu_161 {
    use super::*;

    #[test]
    fn the_sum_is_the_determinant() {
        assert_second_form(2);
    }

    proptest! {
        #[test]
        fn g_is_the_normal_times_g_yy(jet in any_jet()) {
            second_form_is_normal_times_second_derivative(&jet, 2)?;
        }
    }
}

mod cu_162 {
    use super::*;

    #[test]
    fn a_1_and_a_3_are_symmetric_and_a_2_is_not() {
        let [a1, a2, a3] = graph::bordered(&generic_jet());
        assert_eq!(a1, a1.transposed());
        assert_eq!(a3, a3.transposed());
        assert_ne!(a2, a2.transposed());
    }

    #[test]
    fn a_determinant_of_a_determinant_is_the_determinant_of_the_matrix_only_as_a_number() {
        // Bars for the matrix and det for its determinant: at x² + z at the origin det A₁ = −2.
        let [a1, _, _] = graph::bordered(&jet([0, 0, 1], [2, 0, 0, 0, 0, 0]));
        assert_eq!(determinant3(&a1), q(-2, 1));
        // A determinant within bars again, as an absolute value, is 2: a sphere would bend toward its gradient.
        assert_ne!(determinant3(&a1).abs(), q(-2, 1));
    }

    #[test]
    fn exchanging_x_and_y_exchanges_a_1_and_a_3() {
        let jet = generic_jet();
        let swapped = isoracle::curvature::motion::permuted(&jet, [1, 0, 2]);
        let ([a1, a2, a3], [b1, b2, b3]) =
            (graph::second_form_numerators(&jet), graph::second_form_numerators(&swapped));
        assert_eq!((a1, a2, a3), (b3, b2, b1));
    }
}

mod cu_163 {
    use super::*;

    #[test]
    fn at_the_south_pole_the_upward_normal_turns_e_round() {
        let jet = Jet::of_polynomial(&sphere(), &[q(0, 1), q(0, 1), q(-1, 1)]);
        // |∇f| = 2; the pole is the lowest point of its graph: g_xx = 1.
        let upward = graph::upward_second_w(&jet).expect("f_z = −2");
        assert_eq!(upward, [q(2, 1), q(0, 1), q(2, 1)]);
        assert_eq!(graph::forms(&jet).expect("f_z = −2").second_w, [q(-2, 1), q(0, 1), q(-2, 1)]);
    }

    proptest! {
        #[test]
        fn the_upward_second_form_is_that_of_the_parametrisation(jet in any_jet()) {
            let Some(coordinates) = surface(&jet) else { return Ok(()) };
            let upward = graph::upward_second_w(&jet).expect("f_z ≠ 0");
            let parametric = FundamentalForms::new(&coordinates);
            // W = |∇f|/|f_z|
            let scale = Rational::from(jet.gradient[2].abs_ref());
            prop_assert_eq!(&upward, &parametric.second_w.map(|x| x * &scale));
            let sign = i32::from(jet.gradient[2].sign().value());
            let printed = graph::forms(&jet).expect("f_z ≠ 0").second_w;
            prop_assert_eq!(upward, printed.map(|x| x * sign));
        }
    }
}

mod cu_170 {
    use super::*;

    proptest! {
        #[test]
        fn the_three_planes_give_one_k_and_one_h(jet in regular_jet()) {
            let level = implicit_surface::curvature(&jet).expect("regular");
            let mut planes = 0;
            for axis in Axis::ALL {
                match graph::forms_along(&jet, axis) {
                    Err(error) => {
                        prop_assert_eq!(error, GraphError::Vertical);
                        prop_assert!(jet.gradient[axis.index()].is_zero());
                    }
                    Ok(forms) => {
                        planes += 1;
                        prop_assert_eq!(forms.gaussian(), level.gaussian.clone());
                        let mean = forms.mean_w();
                        prop_assert_eq!(mean.sign(), level.mean_sign);
                        prop_assert_eq!(mean.square() / &forms.gradient_squared, level.mean_squared.clone());
                    }
                }
            }
            prop_assert!(planes > 0);
        }

        #[test]
        fn turned_forms_are_those_of_the_turned_parametrisation(jet in regular_jet()) {
            for axis in Axis::ALL {
                let Ok(forms) = graph::forms_along(&jet, axis) else { continue };
                let [u, v] = graph::tangent_basis(&jet, axis).expect("a graph");
                prop_assert_eq!(&forms.first, &[u.norm_squared(), u.dot(&v), v.norm_squared()]);
            }
        }
    }
}

//! K and H of level surfaces: the printed forms, in the polynomial ring and on examples.

use super::level::{generic_jet, jet, point, polynomial, regular_jet, sphere, terms};
use super::q;
use isoracle::curvature::implicit_graph as graph;
use isoracle::curvature::jet::Jet;
use isoracle::curvature::motion::permuted;
use isoracle::curvature::{implicit_curve, implicit_printed, implicit_surface, surface_geometry};
use isoracle::linear::{Matrix, Vector, determinant};
use isoracle::number::{Multivariate, OrderedField, Rational, Ring, Surd};
use proptest::prelude::*;

fn square<const N: usize>(x: &Multivariate<N>) -> Multivariate<N> {
    x.clone() * x
}

mod cu_164 {
    use super::*;

    #[test]
    fn the_determinants_make_the_adjugate_s_form() {
        let jet = generic_jet();
        let [a1, a2, a3] = graph::second_form_numerators(&jet);
        let fz2 = square(&jet.gradient[2]);
        assert_eq!(a1 * &a3 - &square(&a2), implicit_surface::gaussian_numerator(&jet) * &fz2);
    }

    proptest! {
        #[test]
        fn it_is_k_wherever_it_is_defined(jet in regular_jet()) {
            let level = implicit_surface::curvature(&jet).expect("regular");
            match graph::gaussian_by_determinants(&jet) {
                Ok(k) => prop_assert_eq!(k, level.gaussian),
                Err(_) => prop_assert!(jet.gradient[2].is_zero()),
            }
        }
    }
}

mod cu_165 {
    use super::*;

    #[test]
    fn the_sum_is_the_adjugate_s_form_in_every_term() {
        let jet = generic_jet();
        let sum = graph::gaussian_numerator_expanded(&jet);
        assert_eq!(sum, implicit_surface::gaussian_numerator(&jet));
        // Six terms of two or four monomials.
        assert_eq!(sum.terms().count(), 12);
    }

    #[test]
    fn k_of_an_ellipsoid_is_its_support_s_fourth_power() {
        // x²/a² + y²/b² + z²/c²: K = 1/(abc)²/(x²/a⁴ + y²/b⁴ + z²/c⁴)², a, b, c = 1, 2, 3
        let f = Multivariate::new([([2, 0, 0], q(1, 1)), ([0, 2, 0], q(1, 4)), ([0, 0, 2], q(1, 9))]);
        for at in [[q(1, 1), q(0, 1), q(0, 1)], [q(1, 3), q(4, 3), q(2, 1)], [q(0, 1), q(-6, 5), q(12, 5)]] {
            assert_eq!(f.evaluate(&at), 1);
            let jet = Jet::of_polynomial(&f, &at);
            let support =
                [1, 16, 81].iter().zip(&at).fold(q(0, 1), |s, (d, x)| s + Rational::from(x.square_ref()) / *d);
            let expected = q(1, 36) / support.square();
            let w = jet.gradient.norm_squared();
            assert_eq!(graph::gaussian_numerator_expanded(&jet) / w.square(), expected);
        }
    }
}

mod cu_166 {
    use super::*;

    #[test]
    fn the_determinants_make_minus_the_trace_form() {
        let jet = generic_jet();
        let [a1, a2, a3] = graph::second_form_numerators(&jet);
        let [fx, fy, fz] = &jet.gradient.0;
        let sum = a1 * &(square(fz) + &square(fy)) - &(a2 * &(fx.clone() * fy) * &Multivariate::integer(2))
            + &(a3 * &(square(fz) + &square(fx)));
        assert_eq!(sum, -(implicit_surface::mean_numerator(&jet) * &square(fz)));
    }

    proptest! {
        #[test]
        fn it_is_h_wherever_it_is_defined(jet in regular_jet()) {
            let level = implicit_surface::curvature(&jet).expect("regular");
            match graph::mean_w_by_determinants(&jet) {
                Ok(h) => {
                    prop_assert_eq!(h.sign(), level.mean_sign);
                    prop_assert_eq!(h.square() / jet.gradient.norm_squared(), level.mean_squared);
                }
                Err(_) => prop_assert!(jet.gradient[2].is_zero()),
            }
        }
    }
}

mod cu_167 {
    use super::*;

    #[test]
    fn the_two_printed_forms_of_h_are_opposite() {
        let jet = generic_jet();
        let printed = implicit_printed::printed_mean_numerator(&jet);
        assert_eq!(printed, implicit_surface::mean_numerator(&jet));
        assert_eq!(graph::mean_numerator_expanded(&jet), -printed.clone());
        assert!(!printed.is_zero());
    }

    #[test]
    fn on_the_unit_sphere_one_says_1_and_the_other_minus_1() {
        let jet = Jet::of_polynomial(&sphere(), &[q(2, 3), q(1, 3), q(2, 3)]);
        // |∇f| = 2: |∇f|H = ∓2, 2|∇f|³H = ±16
        assert_eq!(graph::mean_w_by_determinants(&jet), Ok(q(-2, 1)));
        assert_eq!(implicit_printed::printed_mean_numerator(&jet), 16);
        assert_eq!(graph::mean_numerator_expanded(&jet), -16);
        let level = implicit_surface::curvature(&jet).expect("regular");
        assert_eq!(level.principal().mean(), Surd::integer(-1));
    }
}

mod cu_168 {
    use super::*;

    const PERMUTATIONS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

    #[test]
    fn all_six_permutations_keep_both_sums() {
        let jet = generic_jet();
        for of in PERMUTATIONS {
            let other = permuted(&jet, of);
            assert_eq!(graph::gaussian_numerator_expanded(&other), graph::gaussian_numerator_expanded(&jet));
            assert_eq!(graph::mean_numerator_expanded(&other), graph::mean_numerator_expanded(&jet));
        }
    }

    proptest! {
        /// The permuted jet is that of the polynomial in permuted variables.
        #[test]
        fn a_permuted_jet_is_that_of_the_permuted_polynomial(f in polynomial(), at in point()) {
            for of in PERMUTATIONS {
                let g = Multivariate::new(f.terms().map(|(n, c)| (of.map(|i| n[i]), c.clone())));
                let there = Jet::of_polynomial(&g, &of.map(|i| at[i].clone()));
                prop_assert_eq!(there, permuted(&Jet::of_polynomial(&f, &at), of));
            }
        }
    }
}

mod cu_169 {
    use super::*;

    #[test]
    fn where_f_z_vanishes_the_sums_still_say_what_the_surface_is() {
        // The cylinder y² + z² = 1 and the sphere, both at (0, 1, 0), where f_z = 0.
        let cylinder = jet([0, 2, 0], [0, 0, 0, 2, 0, 2]);
        let ball = jet([0, 2, 0], [2, 0, 0, 2, 0, 2]);
        for (jet, k, h) in [(cylinder, q(0, 1), q(-1, 2)), (ball, q(1, 1), q(-1, 1))] {
            assert!(graph::gaussian_by_determinants(&jet).is_err() && graph::mean_w_by_determinants(&jet).is_err());
            assert_eq!(graph::gaussian_numerator_expanded(&jet) / 16_u32, k);
            assert_eq!(graph::mean_numerator_expanded(&jet) / 16_u32, h);
        }
    }

    #[test]
    fn f_z_squared_divides_the_determinants_exactly() {
        let jet = generic_jet();
        let [a1, a2, a3] = graph::second_form_numerators(&jet);
        let numerator = a1 * &a3 - &square(&a2);
        // Every monomial has f_z² in it, the variable 2.
        assert!(numerator.terms().all(|(exponents, _)| exponents[2] >= 2));
        let quotient = Multivariate::new(numerator.terms().map(|(mut n, c)| {
            n[2] -= 2;
            (n, c.clone())
        }));
        assert_eq!(quotient, graph::gaussian_numerator_expanded(&jet));
    }
}

mod cu_171 {
    use super::*;

    fn on_the_sphere(u: &Rational, v: &Rational) -> [Jet<Rational, 2>; 3] {
        // The stereographic projection: (2u, 2v, u² + v² − 1)/(u² + v² + 1), N = σᵤ × σᵥ/W inward.
        let [u, v] = Jet::variables(&[u.clone(), v.clone()]);
        let one = Jet::integer(1);
        let squares = u.clone() * &u + &(v.clone() * &v);
        let scale = (squares.clone() + &one).reciprocal().expect("1 + u² + v² > 0");
        let two = Jet::integer(2);
        [u * &two * &scale, v * &two * &scale, (squares - &one) * &scale]
    }

    proptest! {
        #[test]
        fn both_ways_describe_the_sphere(u in super::super::level::small(), v in super::super::level::small()) {
            let surface = on_the_sphere(&u, &v);
            let at = surface.each_ref().map(|x| x.value.clone());
            let parametric = surface_geometry::of_parametrisation(&surface).expect("regular");
            let level = surface_geometry::of_level(&Jet::of_polynomial(&sphere(), &at)).expect("regular");
            let outward = Vector(at.map(Surd::from));
            prop_assert_eq!(&level.normal, &outward);
            prop_assert_eq!(&parametric.normal, &-outward);
            prop_assert_eq!((&level.gaussian, &parametric.gaussian), (&q(1, 1), &q(1, 1)));
            prop_assert_eq!((&level.mean, &parametric.mean), (&Surd::integer(-1), &Surd::integer(1)));
            for t in level.tangents.iter().chain(&parametric.tangents) {
                prop_assert_eq!(t.map(|x| Surd::from(x.clone())).dot(&level.normal), Surd::integer(0));
            }
        }

        #[test]
        fn tangents_of_a_level_surface_are_independent_and_across_its_gradient(jet in regular_jet()) {
            let level = surface_geometry::of_level(&jet).expect("regular");
            let [a, b] = &level.tangents;
            prop_assert!(jet.gradient.dot(a).is_zero() && jet.gradient.dot(b).is_zero());
            prop_assert!(!a.cross(b).norm_squared().is_zero());
        }
    }

    #[test]
    fn where_there_is_no_surface_there_is_an_error() {
        assert!(surface_geometry::of_level(&jet([0; 3], [1; 6])).is_err());
        assert!(surface_geometry::of_parametrisation(&[Jet::integer(0), Jet::integer(1), Jet::integer(2)]).is_err());
    }
}

mod cu_172 {
    use super::*;

    #[test]
    fn the_bordered_hessian_has_minus_the_adjugate_s_form() {
        let jet = generic_jet();
        let bordered = determinant(&graph::bordered_hessian(&jet));
        assert_eq!(-bordered, graph::gaussian_numerator_expanded(&jet));
    }

    #[test]
    fn on_the_unit_sphere_it_is_minus_16() {
        let jet = Jet::of_polynomial(&sphere(), &[q(1, 1), q(0, 1), q(0, 1)]);
        assert_eq!(determinant(&graph::bordered_hessian(&jet)), -16);
    }
}

mod cu_173 {
    use super::*;

    #[test]
    fn a_circle_has_a_negative_determinant() {
        let f = terms(&[([2, 0], 1), ([0, 2], 1)]);
        let jet = Jet::of_polynomial(&f, &[q(3, 5), q(4, 5)]);
        // κ = −1, |∇f| = 2
        assert_eq!(determinant(&graph::bordered_hessian_of_curve(&jet)), -8);
    }

    proptest! {
        #[test]
        fn it_is_kappa_times_the_gradient_s_cube(values in prop::array::uniform5(super::super::level::small())) {
            let [fx, fy, fxx, fxy, fyy] = values;
            let hessian = Matrix([[fxx, fxy.clone()], [fxy, fyy]]);
            let jet = Jet { value: q(0, 1), gradient: Vector([fx, fy]), hessian };
            let bordered = determinant(&graph::bordered_hessian_of_curve(&jet));
            let Ok(curve) = implicit_curve::curvature(&jet) else {
                prop_assert_eq!(bordered, 0);
                return Ok(());
            };
            prop_assert_eq!(bordered.sign(), curve.kappa_sign);
            let w = jet.gradient.norm_squared();
            let cube = Rational::from(w.square_ref()) * &w;
            prop_assert_eq!(bordered.square(), curve.kappa_squared * cube);
        }

        /// A cylinder over a level curve: 2H = κ, K = 0.
        #[test]
        fn a_cylinder_has_its_curve_s_curvature(values in prop::array::uniform5(super::super::level::small())) {
            let [fx, fy, fxx, fxy, fyy] = values;
            let (fx, fy) = if fx.is_zero() && fy.is_zero() { (q(1, 1), fy) } else { (fx, fy) };
            let zero = || q(0, 1);
            let cylinder = super::super::level::jet_of(
                [fx.clone(), fy.clone(), zero()], [fxx.clone(), fxy.clone(), zero(), fyy.clone(), zero(), zero()],
            );
            let hessian = Matrix([[fxx, fxy.clone()], [fxy, fyy]]);
            let curve = implicit_curve::curvature(&Jet { value: zero(), gradient: Vector([fx, fy]), hessian }).expect("regular");
            let level = implicit_surface::curvature(&cylinder).expect("regular");
            prop_assert!(level.gaussian.is_zero());
            prop_assert_eq!(level.mean_sign, curve.kappa_sign);
            prop_assert_eq!(level.mean_squared * 4_u32, curve.kappa_squared);
        }
    }
}

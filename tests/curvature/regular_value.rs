//! Sard's theorem, regular values, and the text's examples of level surfaces.

use super::level::{point, small, sphere, terms};
use super::q;
use isoracle::curvature::gradient::gradient;
use isoracle::curvature::implicit_graph::{self as graph, Axis};
use isoracle::curvature::jet::Jet;
use isoracle::curvature::regular_value::{
    critical_value_of_quadric, ellipsoid, is_critical_point, is_critical_value, paraboloid, squared_distance,
};
use isoracle::curvature::shape_operator::ShapeOperator;
use isoracle::linear::Vector;
use isoracle::number::{Multivariate, Polynomial, Rational, Sign, real_roots};
use proptest::prelude::*;

fn integers(coefficients: &[i64]) -> Polynomial {
    Polynomial::new(coefficients.iter().map(|&c| Rational::from(c)).collect())
}

mod cu_139 {
    use super::*;

    #[test]
    fn the_critical_values_of_x_are_none_and_not_almost_all() {
        let x = integers(&[0, 1]);
        for n in -20..=20 {
            assert!(!is_critical_value(&x, &q(n, 7)));
        }
        // A constant has one, x³ − 3x two, x⁴ − 2x² two for its three critical points.
        let few = |f: &Polynomial| (-40..=40).filter(|&n| is_critical_value(f, &q(n, 2))).collect::<Vec<i64>>();
        assert_eq!(few(&integers(&[3])), [6]);
        assert_eq!(few(&integers(&[0, -3, 0, 1])), [-4, 4]);
        assert_eq!(few(&integers(&[0, 0, -2, 0, 1])), [-2, 0]);
    }

    proptest! {
        #[test]
        fn a_value_is_critical_iff_a_root_of_the_derivative_takes_it(
            f in prop::collection::vec(-4..=4_i64, 0..6), a in small(),
        ) {
            let f = integers(&f);
            let values = f.clone() - &Polynomial::new(vec![a.clone()]);
            match real_roots(&f.derivative()) {
                // f is constant.
                None => prop_assert_eq!(is_critical_value(&f, &a), values.is_zero()),
                Some(points) => {
                    let taken = points.iter().any(|x| x.sign_of(&values) == Sign::Zero);
                    prop_assert_eq!(is_critical_value(&f, &a), taken);
                    prop_assert!(points.len() < f.degree().expect("not constant").max(1));
                }
            }
        }

        /// The value at a planted critical point is critical.
        #[test]
        fn planted_critical_values_are_found(
            points in prop::collection::vec(small(), 1..4), shift in small(),
        ) {
            let derivative = points.iter().fold(integers(&[1]), |p, x| p * &Polynomial::with_root(x));
            let f: Vec<Rational> = std::iter::once(shift)
                .chain(derivative.coefficients().iter().enumerate().map(|(i, c)| c.clone() / (i as u32 + 1)))
                .collect();
            let f = Polynomial::new(f);
            for x in &points {
                prop_assert!(is_critical_value(&f, &f.evaluate(x)));
            }
        }
    }
}

mod cu_140 {
    use super::*;

    #[test]
    fn half_of_the_values_of_a_sphere_s_function_give_no_surface() {
        // 0 is the only critical value of x² + y² + z²; −1 is regular, and nothing is there.
        assert_eq!(critical_value_of_quadric(&sphere()), Some(q(0, 1)));
        let over_the_origin = integers(&[1, 0, 1]);
        assert!(real_roots(&over_the_origin).expect("not zero").is_empty());
        let above_everything = sphere() + &terms(&[([0, 0, 0], 1)]);
        assert!(above_everything.terms().all(|(n, c)| n.iter().all(|n| n % 2 == 0) && c.cmp0().is_gt()));
    }

    proptest! {
        #[test]
        fn a_quadric_has_one_critical_value_or_none(coefficients in prop::array::uniform10(-2..=2_i64), at in point()) {
            let exponents = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 0, 0], [1, 1, 0], [1, 0, 1], [0, 2, 0], [0, 1, 1], [0, 0, 2]];
            let f = Multivariate::new(exponents.into_iter().zip(coefficients.map(Rational::from)));
            // Moved so that the point is critical, with the value that it has there.
            let slope = Jet::of_polynomial(&f, &at).gradient;
            let linear = |i: usize| Multivariate::variable(i) * &Multivariate::constant(slope[i].clone());
            let planted = (0..3).fold(f.clone(), |f, i| f - &linear(i));
            prop_assert!(is_critical_point(&planted, &at));
            prop_assert_eq!(critical_value_of_quadric(&planted), Some(planted.evaluate(&at)));
            if let Some(value) = critical_value_of_quadric(&f) {
                prop_assert!(!is_critical_point(&f, &at) || f.evaluate(&at) == value);
            } else {
                prop_assert!(!is_critical_point(&f, &at));
            }
        }
    }

    #[test]
    fn a_paraboloid_has_no_critical_value_and_a_cylinder_has_one() {
        assert_eq!(critical_value_of_quadric(&paraboloid()), None);
        let cylinder = terms(&[([2, 0, 0], 1), ([0, 2, 0], 1), ([1, 0, 0], 2), ([0, 0, 0], 5)]);
        assert_eq!(critical_value_of_quadric(&cylinder), Some(q(4, 1)));
    }
}

mod cu_141 {
    use super::*;

    proptest! {
        #[test]
        fn points_at_one_distance_are_a_level_set(c in point(), at in point()) {
            let f = squared_distance(&c);
            let offset = Vector(at.clone()) - &Vector(c.clone());
            prop_assert_eq!(f.evaluate(&at), offset.norm_squared());
            prop_assert_eq!(critical_value_of_quadric(&f), Some(q(0, 1)));
            prop_assert_eq!(is_critical_point(&f, &at), at == c);
        }
    }

    #[test]
    fn at_the_distance_0_there_is_no_surface() {
        // x² + y² + z² = 0: the origin alone, which is critical.
        let origin = [q(0, 1), q(0, 1), q(0, 1)];
        let f = squared_distance(&origin);
        assert_eq!(f, sphere());
        assert!(is_critical_point(&f, &origin) && f.evaluate(&origin) == 0);
    }
}

mod cu_142 {
    use super::*;

    #[test]
    fn a_differentiable_function_s_gradient_may_be_without_a_derivative() {
        // x|x|: x² and −x² have one value and one slope at 0, and the slopes have the derivatives 2 and −2.
        let halves = [1, -1].map(|sign| terms(&[([2, 0, 0], sign)]));
        let [right, left] = halves.map(|f| Jet::of_polynomial(&f, &[q(0, 1), q(0, 1), q(0, 1)]));
        assert_eq!((&right.value, &right.gradient), (&left.value, &left.gradient));
        assert_eq!((&right.hessian.0[0][0], &left.hessian.0[0][0]), (&q(2, 1), &q(-2, 1)));
    }

    proptest! {
        #[test]
        fn the_field_takes_a_point_to_its_jet_s_gradient(f in super::super::level::polynomial(), at in point()) {
            let field = gradient(&f).map(|g| g.evaluate(&at));
            prop_assert_eq!(field, Jet::of_polynomial(&f, &at).gradient);
        }
    }
}

mod cu_146 {
    use super::*;

    #[test]
    fn a_value_is_regular_iff_no_point_of_its_level_set_is_critical() {
        // xy + z²: 0 is critical by the origin, and no other value is.
        let f = terms(&[([1, 1, 0], 1), ([0, 0, 2], 1)]);
        assert_eq!(critical_value_of_quadric(&f), Some(q(0, 1)));
        let range = || (-2..=2_i64).map(Rational::from);
        for x in range() {
            for y in range() {
                for z in range() {
                    let at = [x.clone(), y.clone(), z];
                    assert!(f.evaluate(&at) == 0 || !is_critical_point(&f, &at));
                    assert_eq!(is_critical_point(&f, &at), at.iter().all(Rational::is_zero));
                }
            }
        }
    }
}

mod cu_148 {
    use super::*;

    #[test]
    fn a_level_set_of_a_critical_value_may_be_a_surface() {
        // z²: all points of z = 0 are critical, and it is a plane.
        let f = terms(&[([0, 0, 2], 1)]);
        assert!(is_critical_point(&f, &[q(5, 1), q(-2, 3), q(0, 1)]));
        assert_eq!(critical_value_of_quadric(&f), Some(q(0, 1)));
        // xyz: two of three planes meet at the critical points of 0.
        let f = terms(&[([1, 1, 1], 1)]);
        assert!(is_critical_point(&f, &[q(0, 1), q(0, 1), q(7, 1)]));
        assert!(!is_critical_point(&f, &[q(0, 1), q(1, 1), q(7, 1)]));
    }
}

mod cu_149 {
    use super::*;

    proptest! {
        #[test]
        fn the_gradient_of_an_ellipsoid_vanishes_at_its_centre_alone(axes in point(), at in point()) {
            let Some(f) = ellipsoid(&axes) else {
                prop_assert!(axes.iter().any(Rational::is_zero));
                return Ok(());
            };
            // f_x = 2x/a² and so on
            let expected: [Rational; 3] = std::array::from_fn(|i| {
                Rational::from(&at[i] * 2_u32) / Rational::from(axes[i].square_ref())
            });
            prop_assert_eq!(Jet::of_polynomial(&f, &at).gradient, Vector(expected));
            prop_assert_eq!(is_critical_point(&f, &at), at.iter().all(Rational::is_zero));
            prop_assert_eq!(critical_value_of_quadric(&f), Some(q(-1, 1)));
        }
    }

    #[test]
    fn of_the_axes_1_1_1_it_is_the_sphere() {
        let one = [q(1, 1), q(1, 1), q(1, 1)];
        assert_eq!(ellipsoid(&one), Some(sphere() - &terms(&[([0, 0, 0], 1)])));
    }
}

mod cu_150 {
    use super::*;

    proptest! {
        #[test]
        fn a_paraboloid_is_a_graph_everywhere(at in point()) {
            let f = paraboloid();
            prop_assert!(!is_critical_point(&f, &at));
            let jet = Jet::of_polynomial(&f, &at);
            let slopes = graph::graph(&jet).expect("f_z = −1").first;
            prop_assert_eq!(slopes, [Rational::from(&at[0] * 2_u32), Rational::from(&at[1] * 2_u32)]);
        }
    }
}

mod cu_151 {
    use super::*;

    proptest! {
        #[test]
        fn the_kernel_of_df_is_the_plane_of_the_graph_s_tangents(jet in super::super::level::regular_jet(), v in point()) {
            for axis in Axis::ALL {
                let Ok([a, b]) = graph::tangent_basis(&jet, axis) else { continue };
                prop_assert!(jet.gradient.dot(&a).is_zero() && jet.gradient.dot(&b).is_zero());
                // a × b is ∇f over its part along the axis.
                prop_assert_eq!(a.cross(&b).scaled(&jet.gradient[axis.index()]), jet.gradient.clone());
                // In the kernel iff a combination of the two: det(a, b, v) = 0.
                let v = Vector(v.clone());
                prop_assert_eq!(jet.gradient.dot(&v).is_zero(), a.cross(&b).dot(&v).is_zero());
            }
            prop_assert!(ShapeOperator::new(&jet).is_ok());
        }

        /// α(t) = (cos, sin, 0)·r by its rational parametrisation: (f∘α)′ = 0 and α′ in the kernel.
        #[test]
        fn velocities_of_curves_on_a_sphere_are_in_the_kernel(t in small(), height in small()) {
            let [t] = Jet::variables(&[t]);
            let integer = |n: i64| Jet::<Rational, 1>::constant(Rational::from(n));
            let square = t.clone() * &t;
            let scale = (integer(1) + &square).reciprocal().expect("1 + t² > 0");
            let curve = [(integer(1) - &square) * &scale, t * &integer(2) * &scale, Jet::constant(height)];
            let along = sphere().evaluate_in(&curve, |c| Jet::constant(c.clone()));
            prop_assert!(along.gradient[0].is_zero());
            let at = curve.each_ref().map(|x| x.value.clone());
            let velocity = Vector(curve.each_ref().map(|x| x.gradient[0].clone()));
            prop_assert!(Jet::of_polynomial(&sphere(), &at).gradient.dot(&velocity).is_zero());
        }
    }
}

mod cu_157 {
    use super::*;

    #[test]
    fn a_tangent_vector_need_not_lie_on_the_surface() {
        let f = -paraboloid();
        let [origin, e1] = [[0, 0, 0], [1, 0, 0]].map(|at: [i64; 3]| at.map(Rational::from));
        let jet = Jet::of_polynomial(&f, &origin);
        let [a, b] = graph::tangent_basis(&jet, Axis::Z).expect("f_z = 1");
        assert_eq!((a, b), (Vector(e1.clone()), Vector([0, 1, 0].map(Rational::from))));
        assert_eq!((f.evaluate(&origin), f.evaluate(&e1)), (q(0, 1), q(-1, 1)));
    }
}

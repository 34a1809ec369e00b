//! What the room computes: jets, K, H and the principal curvatures, parametric and implicit.

use super::q;
use isoracle::curvature::jet::Jet;
use isoracle::curvature::{implicit_curve, implicit_surface, parametric_curve, parametric_surface};
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Multivariate, Rational, Ring, Sign};
use proptest::prelude::*;

/// A polynomial with small integer coefficients, of degree at most 3 in each variable.
fn polynomial<const N: usize>() -> impl Strategy<Value = Multivariate<N>> {
    let term = (prop::array::uniform::<_, N>(0..=3_u32), -4..=4_i32);
    prop::collection::vec(term, 0..8)
        .prop_map(|terms| Multivariate::new(terms.into_iter().map(|(exponents, c)| (exponents, Rational::from(c)))))
}

/// A point with small coordinates.
fn point<const N: usize>() -> impl Strategy<Value = [Rational; N]> {
    prop::array::uniform::<_, N>((-6..=6_i64, 1..=4_i64).prop_map(|(n, d)| q(n, d)))
}

mod cu_1 {
    use super::*;

    /// The jet from the polynomials that are its derivatives.
    fn by_derivatives<const N: usize>(f: &Multivariate<N>, at: &[Rational; N]) -> Jet<Rational, N> {
        Jet {
            value: f.evaluate(at),
            gradient: Vector(std::array::from_fn(|i| f.derivative(i).evaluate(at))),
            hessian: Matrix::from_fn(|i, j| f.derivative(i).derivative(j).evaluate(at)),
        }
    }

    proptest! {
        #[test]
        fn jets_of_polynomials_are_those_of_their_derivatives(f in polynomial::<3>(), at in point::<3>()) {
            prop_assert_eq!(Jet::of_polynomial(&f, &at), by_derivatives(&f, &at));
        }

        #[test]
        fn a_quotient_times_its_denominator_is_the_numerator(
            f in polynomial::<2>(), g in polynomial::<2>(), at in point::<2>(),
        ) {
            let (f, g) = (Jet::of_polynomial(&f, &at), Jet::of_polynomial(&g, &at));
            match g.reciprocal() {
                None => prop_assert_eq!(&g.value, &Rational::new()),
                Some(reciprocal) => prop_assert_eq!(f.clone() * &reciprocal * &g, f),
            }
        }

        #[test]
        fn a_composition_is_the_polynomial_of_the_polynomial(f in polynomial::<2>(), at in point::<2>()) {
            // φ(y) = y³ − y
            let jet = Jet::of_polynomial(&f, &at);
            let y = jet.value.clone();
            let square = Rational::from(y.square_ref());
            let phi = [square.clone() * &y - &y, square * 3_u32 - 1_u32, y * 6_u32];
            let cube = jet.clone() * &jet * &jet;
            prop_assert_eq!(jet.composed(&phi), cube - &jet);
        }
    }
}

mod cu_2 {
    use super::*;

    #[test]
    fn a_circle_bends_away_from_its_gradient() {
        let f = Multivariate::<2>::new([([2, 0], q(1, 1)), ([0, 2], q(1, 1))]);
        let curve = implicit_curve::curvature(&Jet::of_polynomial(&f, &[q(3, 1), q(4, 1)])).expect("regular");
        assert_eq!((curve.kappa_squared, curve.kappa_sign), (q(1, 25), Sign::Negative));
        assert!(implicit_curve::curvature(&Jet::of_polynomial(&f, &[q(0, 1), q(0, 1)])).is_err());
    }

    proptest! {
        /// t = (f_y, −f_x): the solution x(s) of x′ = t through the point has x″ = (∂t)·t.
        #[test]
        fn kappa_is_that_of_the_flow_along_the_level_set(f in polynomial::<2>(), at in point::<2>()) {
            let jet = Jet::of_polynomial(&f, &at);
            let ([fx, fy], Matrix([[fxx, fxy], [_, fyy]])) = (&jet.gradient.0, &jet.hessian);
            let along = |a: &Rational, b: &Rational| Rational::from(fy * a) - Rational::from(fx * b);
            let second = [along(fxy, fyy), -along(fxx, fxy)];
            let flow = [(fy.clone(), &second[0]), (-fx.clone(), &second[1])].map(|(first, second)| Jet {
                value: Rational::new(),
                gradient: Vector([first]),
                hessian: Matrix([[second.clone()]]),
            });
            let flow = parametric_curve::curvature(&flow).ok().map(|c| (c.kappa_squared, c.kappa_sign));
            let level = implicit_curve::curvature(&jet).ok().map(|c| (c.kappa_squared, c.kappa_sign));
            prop_assert_eq!(flow, level);
        }
    }
}

mod cu_3 {
    use super::*;

    proptest! {
        /// Where f = z − g(x, y), the level set is the graph of g; its normal (−g_x, −g_y, 1)/W is ∇f/|∇f|.
        #[test]
        fn graphs_have_the_same_curvature_either_way(g in polynomial::<2>(), [x, y] in point::<2>()) {
            let f = Multivariate::<3>::variable(2) - &Multivariate::new(g.terms().map(|([i, j], c)| ([i, j, 0], c.clone())));
            let z = g.evaluate(&[x.clone(), y.clone()]);
            let level = implicit_surface::curvature(&Jet::of_polynomial(&f, &[x.clone(), y.clone(), z])).expect("f_z = 1");
            let [u, v] = Jet::variables(&[x.clone(), y.clone()]);
            let graph = parametric_surface::curvature(&[u, v, Jet::of_polynomial(&g, &[x, y])]).expect("a graph is regular");
            prop_assert_eq!(level.gaussian, graph.gaussian);
            prop_assert_eq!((level.mean_squared, level.mean_sign), (graph.mean_squared, graph.mean_sign));
        }
    }
}

mod cu_4 {
    use super::*;
    use isoracle::number::{OrderedField, Surd};

    proptest! {
        #[test]
        fn principal_curvatures_are_the_roots_of_the_characteristic_polynomial(f in polynomial::<3>(), at in point::<3>()) {
            let Ok(level) = implicit_surface::curvature(&Jet::of_polynomial(&f, &at)) else { return Ok(()) };
            let principal = level.principal();
            prop_assert!(principal.spread().sign() != Sign::Negative);
            if let Some([k1, k2]) = principal.exact() {
                prop_assert!(k1 >= k2);
                prop_assert_eq!(k1.clone() * &k2, Surd::from(level.gaussian.clone()));
                prop_assert_eq!(k1 + &k2, principal.mean() + &principal.mean());
            }
            let [k1, k2] = principal.enclosure(200);
            prop_assert!((k1.clone() * &k2).contains(&level.gaussian));
            let half_sum = (k1 + &k2) * &isoracle::number::Interval::from_rational(&q(1, 2), 200);
            prop_assert!((half_sum.clone() * &half_sum).contains(&level.mean_squared));
        }
    }
}

mod cu_5 {
    use super::*;

    #[test]
    fn a_circle_by_its_rational_parametrisation_turns_left() {
        // ((1 − t²)/(1 + t²), 2t/(1 + t²))·5
        let [t] = Jet::variables(&[q(1, 3)]);
        let one = Jet::integer(1);
        let square = t.clone() * &t;
        let scale = (one.clone() + &square).reciprocal().expect("1 + t² > 0") * &Jet::integer(5);
        let curve = [(one - &square) * &scale, t * &Jet::integer(2) * &scale];
        let curve = parametric_curve::curvature(&curve).expect("regular");
        assert_eq!((curve.kappa_squared, curve.kappa_sign), (q(1, 25), Sign::Positive));
    }
}

mod cu_6 {
    use super::*;

    proptest! {
        #[test]
        fn dn_is_the_derivative_of_the_normal(
            x in polynomial::<2>(), y in polynomial::<2>(), z in polynomial::<2>(), at in point::<2>(),
        ) {
            let surface = [x, y, z].map(|x| Jet::of_polynomial(&x, &at));
            let Ok(curvature) = parametric_surface::curvature(&surface) else { return Ok(()) };
            // W² N_u = W (σᵤ×σᵥ)_u, but for a multiple of N; so ⟨N_u, σᵤ⟩W = ⟨(σᵤ×σᵥ)_u, σᵤ⟩ and so on.
            let d = |i: usize| Vector(surface.each_ref().map(|x| x.gradient[i].clone()));
            let dd = |i: usize, j: usize| Vector(surface.each_ref().map(|x| x.hessian.0[i][j].clone()));
            let a = curvature.weingarten_w();
            for i in 0..2 {
                let derivative = dd(0, i).cross(&d(1)) + &d(0).cross(&dd(1, i));
                let combination = d(0).scaled(&a.0[0][i]) + &d(1).scaled(&a.0[1][i]);
                for j in 0..2 {
                    prop_assert_eq!(derivative.dot(&d(j)), combination.dot(&d(j)));
                }
            }
            let determinant = Rational::from(&a.0[0][0] * &a.0[1][1]) - Rational::from(&a.0[0][1] * &a.0[1][0]);
            prop_assert_eq!(determinant / &curvature.w_squared, curvature.gaussian);
        }
    }
}

mod cu_7 {
    use super::*;
    use isoracle::curvature::normalize::normalize;

    #[test]
    fn n_is_a_half_at_0_and_symmetric() {
        assert!(normalize(&q(1, 2), &q(0, 1), 100).expect("λ > 0").contains(&q(1, 2)));
        for x in [q(1, 3), q(10, 1), q(1000, 1)] {
            let [a, b] = [x.clone(), -x].map(|x| normalize(&q(1, 2), &x, 100).expect("λ > 0"));
            assert!((a + &b).contains(&q(1, 1)));
        }
    }

    #[test]
    fn the_printed_map_needs_a_positive_slope() {
        // n₀ = 1/2 everywhere, and n₋₁(−1) = e/2 > 1.
        for slope in [q(0, 1), q(-1, 1)] {
            assert!(normalize(&slope, &q(1, 1), 100).is_err());
        }
    }
}

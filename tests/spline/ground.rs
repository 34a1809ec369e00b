//! What the room computes: coefficients, values and derivatives.

use super::q;
use isoracle::number::{Integer, Rational, Surd};
use isoracle::spline::basis::weights;
use isoracle::spline::impulse;
use isoracle::spline::prefilter::{interpolate, solve};
use isoracle::spline::signal::{Boundary, Signal};
use proptest::prelude::*;

fn boundary() -> impl Strategy<Value = Boundary> {
    prop_oneof![Just(Boundary::Mirror), Just(Boundary::Periodic)]
}

fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![2 => (-9..=9_i64).prop_map(|n| q(n, 1)), 1 => (-40..=40_i64, 1..=8_i64).prop_map(|(n, d)| q(n, d))]
}

mod sp_1 {
    use super::*;

    /// The cubic B-spline, from the truncated cubes: B₃(x) = Σ (−1)ʲ C(4, j) (x + 2 − j)³₊/6.
    fn b3(x: &Rational) -> Rational {
        let binomials = [1, -4, 6, -4, 1];
        let cube = |y: Rational| if y > 0 { Rational::from(y.square_ref()) * &y } else { Rational::new() };
        let terms = (0..5).map(|j| cube(Rational::from(x + 2) - j) * binomials[j as usize]);
        terms.fold(Rational::new(), |sum, term| sum + term) / 6
    }

    #[test]
    fn the_weights_are_the_b_spline_at_four_distances() {
        for n in 0..8 {
            let t = q(n, 8);
            let four: Vec<Rational> = (-1..=2).map(|k| b3(&Rational::from(&t - k))).collect();
            assert_eq!(weights(&t, 0).to_vec(), four);
            for order in 0..3 {
                let sum = weights(&t, order).iter().fold(Rational::new(), |sum, w| sum + w);
                assert_eq!(sum, i32::from(order == 0));
            }
        }
    }

    #[test]
    fn the_derivatives_are_those_of_the_weights() {
        // w(t + s) + w(t − s) − 2w(t) = w″(t)s² exactly for a cubic, and w(t + s) − w(t − s) = 2sw′(t) + s³w‴/3.
        let (t, s) = (q(2, 5), q(1, 5));
        let [up, down] = [Rational::from(&t + &s), Rational::from(&t - &s)].map(|t| weights(&t, 0));
        for i in 0..4 {
            let (middle, first, second) = (&weights(&t, 0)[i], &weights(&t, 1)[i], &weights(&t, 2)[i]);
            assert_eq!(Rational::from(&up[i] + &down[i]) - Rational::from(middle * 2), second * s.clone().square());
            let third = [q(-1, 1), q(3, 1), q(-3, 1), q(1, 1)][i].clone();
            let odd = Rational::from(first * &s) * 2 + third * s.clone().square() * &s / 3;
            assert_eq!(Rational::from(&up[i] - &down[i]), odd);
        }
    }
}

mod sp_2 {
    use super::*;

    proptest! {
        #[test]
        fn coefficients_of_a_line_solve_the_equations(g in prop::collection::vec(number(), 2..14), boundary in boundary()) {
            let c = solve(&g, boundary);
            let at = |k: usize, step: i32| &c[boundary.index(&(Integer::from(k) + step), g.len())];
            for (k, g) in g.iter().enumerate() {
                let sum = Rational::from(at(k, -1) + at(k, 1)) + Rational::from(at(k, 0) * 4);
                prop_assert_eq!(sum / 6, g.clone());
            }
        }

        #[test]
        fn splines_interpolate(
            shape in prop::array::uniform3(2..5_usize), numbers in prop::collection::vec(number(), 64), boundary in boundary(),
        ) {
            let count = shape.iter().product();
            let signal = Signal::new(shape, numbers[..count].to_vec(), boundary).expect("the shape fits");
            let spline = interpolate(&signal);
            for (i, value) in signal.values().iter().enumerate() {
                let at = [i % shape[0], i / shape[0] % shape[1], i / shape[0] / shape[1]].map(Rational::from);
                prop_assert_eq!(&spline.value(&at), value);
            }
        }
    }
}

mod sp_3 {
    use super::*;

    proptest! {
        /// x ↦ f(x + s) is a cubic between two knots: five values on a line give its derivatives.
        #[test]
        fn jets_are_the_derivatives_of_the_values(
            numbers in prop::collection::vec(number(), 24), boundary in boundary(), at in prop::array::uniform3(-40..40_i64),
        ) {
            let signal = Signal::new([2, 3, 4], numbers, boundary).expect("the shape fits");
            let spline = interpolate(&signal);
            // The middle of a cell of width 1/2, away from the knots.
            let at = at.map(|n| q(2 * n + 1, 4));
            let jet = spline.jet(&at);
            for axis in 0..3 {
                let f = |step: i64| {
                    let mut at = at.clone();
                    at[axis] += q(step, 16);
                    spline.value(&at)
                };
                let second = (f(1) + f(-1) - f(0) * 2) * 256;
                prop_assert_eq!(&second, &jet.hessian.0[axis][axis]);
                // 8(f(s) − f(−s)) − (f(2s) − f(−2s)) = 12 s f′ for a cubic.
                let first = ((f(1) - f(-1)) * 8 - (f(2) - f(-2))) * q(16, 12);
                prop_assert_eq!(&first, &jet.gradient[axis]);
            }
        }
    }

    #[test]
    fn mixed_derivatives_are_those_of_products() {
        // The spline of g(x)h(y) is the product of the splines.
        let (g, h) = ([1, -2, 5, 3].map(Rational::from), [4, 0, -7].map(Rational::from));
        let product = h.iter().flat_map(|h| g.iter().map(move |g| Rational::from(g * h))).collect();
        let line = |values: &[Rational]| {
            interpolate(&Signal::new([values.len()], values.to_vec(), Boundary::Mirror).expect("a line"))
        };
        let spline = interpolate(&Signal::new([4, 3], product, Boundary::Mirror).expect("a grid"));
        let (x, y) = (q(7, 5), q(-9, 4));
        let jet = spline.jet(&[x.clone(), y.clone()]);
        let (gx, hy) = (line(&g).jet(&[x]), line(&h).jet(&[y]));
        assert_eq!(jet.hessian.0[0][1], Rational::from(&gx.gradient[0] * &hy.gradient[0]));
        assert_eq!(jet.hessian.0[1][1], Rational::from(&gx.value * &hy.hessian.0[0][0]));
    }
}

mod sp_4 {
    use super::*;

    #[test]
    fn the_inverse_filter_inverts() {
        let h = |k: i32| impulse::inverse_filter(k.unsigned_abs());
        for k in -20..=20 {
            let sum = h(k - 1) + &h(k + 1) + &(h(k) * &Surd::from(q(4, 1)));
            assert_eq!(sum, Surd::from(q(if k == 0 { 6 } else { 0 }, 1)));
        }
    }

    #[test]
    fn a_long_periodic_signal_looks_like_an_infinite_one() {
        // 0 but for one sample: the sum over all images of h.
        let mut g = vec![Rational::new(); 30];
        g[15] = q(1, 1);
        let c = solve(&g, Boundary::Periodic);
        let h = impulse::inverse_filter(3);
        let difference = Surd::from(c[18].clone()) - &h;
        // The nearest image is 27 away.
        assert!(difference.norm().abs() < q(1, 1_000_000_000) && difference < impulse::inverse_filter(24));
    }
}

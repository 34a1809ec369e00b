//! Linear interpolation, and S₁.

use super::{at, few, number, q};
use isoracle::number::{Integer, Polynomial, Rational};
use isoracle::spline::bspline::{b1, basis};
use isoracle::spline::degree_one::{by_hats, interpolate, slope_change};
use isoracle::spline::piecewise::Piecewise;
use isoracle::spline::printed;
use isoracle::spline::space::{combination, membership};
use proptest::prelude::*;
use std::collections::BTreeMap;

fn square(k: &Integer) -> Rational {
    Rational::from(k.clone().square())
}

/// The value at x on the line through (a, ga) and (a + 1, gb).
fn on_line(a: &Rational, ga: &Rational, gb: &Rational, x: &Rational) -> Rational {
    ga + Rational::from(x - a) * Rational::from(gb - ga)
}

mod sp_5 {
    use super::*;

    #[test]
    fn the_printed_argument_names_one_place_for_all_intervals() {
        // g[k] = k², x = 3/2: i = 1, t = 1/2. As printed this is f(1/2) = 5/2; at x = 1/2, it is f(1/2) = 1/2.
        assert_eq!(printed::linear(&square, &q(3, 2)), (q(1, 2), q(5, 2)));
        assert_eq!(printed::linear(&square, &q(1, 2)), (q(1, 2), q(1, 2)));
        assert_eq!(interpolate(&square, &q(3, 2)), q(5, 2));
        assert_eq!(interpolate(&square, &q(1, 2)), q(1, 2));
    }

    #[test]
    fn the_integer_part_of_a_negative_number_is_its_floor() {
        for n in -40..40 {
            let x = q(n, 8);
            let i = n.div_euclid(8);
            let line = on_line(&q(i, 1), &q(i * i, 1), &q((i + 1) * (i + 1), 1), &x);
            assert_eq!(interpolate(&square, &x), line, "{x}");
        }
        // Cut toward 0, −1/2 would be i = 0, t = −1/2, and the value −1/2.
        assert_eq!(interpolate(&square, &q(-1, 2)), q(1, 2));
    }
}

mod sp_6 {
    use super::*;

    proptest! {
        #[test]
        fn it_interpolates_and_is_continuous(g in few(), k in -7..7_i64, bits in 1..200_u32) {
            let g = |k: &Integer| at(&g, k);
            let value = g(&Integer::from(k));
            prop_assert_eq!(&interpolate(&g, &q(k, 1)), &value);
            // Near k it is within the slopes times the distance, from either side.
            let hair = Rational::from((Integer::from(1), Integer::from(1) << bits));
            for side in [-1, 1] {
                let near = interpolate(&g, &(q(k, 1) + Rational::from(&hair * side)));
                let slope = g(&Integer::from(k + i64::from(side))) - &value;
                prop_assert_eq!(near - &value, slope * &hair);
            }
        }
    }
}

mod sp_7 {
    use super::*;

    /// The slopes of f on both sides of k, from values of f.
    fn slopes(g: &dyn Fn(&Integer) -> Rational, k: i64) -> [Rational; 2] {
        let f = |n: i64| interpolate(g, &q(n, 3));
        [(f(3 * k) - f(3 * k - 1)) * 3, (f(3 * k + 1) - f(3 * k)) * 3]
    }

    #[test]
    fn a_kink_and_none() {
        assert_eq!(slopes(&square, 0), [q(-1, 1), q(1, 1)]);
        assert_eq!(slope_change(&square, &Integer::new()), 2);
        let straight = |k: &Integer| Rational::from(k * 3_u32) - 7;
        assert!((-5..5).all(|k| slope_change(&straight, &Integer::from(k)).is_zero()));
    }

    proptest! {
        #[test]
        fn it_is_differentiable_where_the_second_difference_is_0(g in few(), k in -7..7_i64, flat: bool) {
            let mut g = g;
            if flat {
                // Planted: the middle of its neighbours.
                let middle = (at(&g, &Integer::from(k - 1)) + at(&g, &Integer::from(k + 1))) / 2;
                g.insert(Integer::from(k), middle);
            }
            let g = |k: &Integer| at(&g, k);
            let [left, right] = slopes(&g, k);
            prop_assert_eq!(left == right, slope_change(&g, &Integer::from(k)).is_zero());
            prop_assert_eq!(right - left, slope_change(&g, &Integer::from(k)));
            prop_assert!(!flat || slope_change(&g, &Integer::from(k)).is_zero());
        }
    }
}

/// The continuous function through (k, g[k]) for k = −6, …, 6 that is linear between, and 0 outside: from two values each.
fn through(g: &BTreeMap<Integer, Rational>) -> Piecewise {
    let zero = Polynomial::new(Vec::new());
    let knots: Vec<i64> = (-6..=6).collect();
    let value = |k: i64| at(g, &Integer::from(k));
    let line = |k: i64| {
        let slope = value(k + 1) - value(k);
        Polynomial::new(vec![value(k) - Rational::from(&slope * k), slope])
    };
    let inner = knots[..12].iter().map(|k| line(*k));
    let pieces = std::iter::once(zero.clone()).chain(inner).chain([zero.clone()]).collect();
    Piecewise::new(knots.iter().map(|k| q(*k, 1)).collect(), pieces).expect("increasing")
}

mod sp_12 {
    use super::*;

    proptest! {
        #[test]
        fn the_only_function_of_s1_through_a_signal_is_the_linear_interpolant(g in few(), n in -60..60_i64) {
            let f = through(&g);
            prop_assert_eq!(membership(&f, 1), Ok(()));
            prop_assert_eq!(f.evaluate(&q(n, 8)), interpolate(&|k: &Integer| at(&g, k), &q(n, 8)));
        }

        #[test]
        fn a_function_of_s1_is_fixed_by_two_values_on_each_interval(slope in number(), constant in number(), k in -5..5_i64) {
            // What is 0 at k and k + 1 is 0: slope·k + constant = 0 and slope = 0.
            let p = Polynomial::new(vec![constant, slope]);
            let vanishes = [k, k + 1].iter().all(|k| p.evaluate(&q(*k, 1)).is_zero());
            prop_assert_eq!(vanishes, p.is_zero());
        }
    }
}

mod sp_13 {
    use super::*;

    #[test]
    fn the_hat() {
        for n in -20..=20 {
            assert_eq!(b1(&q(n, 8)), basis(1).evaluate(&q(n, 8)));
        }
    }

    proptest! {
        #[test]
        fn sums_of_hats_are_the_linear_interpolant(g in few(), n in -60..60_i64) {
            let on = |k: &Integer| at(&g, k);
            prop_assert_eq!(by_hats(&on, &q(n, 8)).0, interpolate(&on, &q(n, 8)));
            prop_assert_eq!(combination(&g, 1), through(&g));
        }
    }
}

mod sp_14 {
    use super::*;

    #[test]
    fn a_constant_is_no_finite_sum_of_hats() {
        // Finite sums have a support; the constant 1 has none, and is the sum of all hats.
        let finite = |m: i32| combination(&(-m..=m).map(|k| (Integer::from(k), q(1, 1))).collect(), 1);
        let one = Piecewise::polynomial(Polynomial::new(vec![q(1, 1)]));
        assert_eq!(membership(&one, 1), Ok(()));
        for m in 0..6 {
            assert_eq!(finite(m).support(), Some((&q(-i64::from(m) - 1, 1), &q(i64::from(m) + 1, 1))));
            assert_eq!(finite(m).evaluate(&q(i64::from(m) + 1, 1)), 0);
        }
        assert_eq!(by_hats(&|_: &Integer| q(1, 1), &q(123_456, 7)).0, 1);
    }

    proptest! {
        #[test]
        fn coefficients_are_the_values(g in few(), k in -7..7_i64) {
            prop_assert_eq!(combination(&g, 1).evaluate(&q(k, 1)), at(&g, &Integer::from(k)));
        }
    }
}

mod sp_15 {
    use super::*;

    #[test]
    fn two_terms_are_not_zero_or_one_at_an_integer() {
        for n in -40..40 {
            let (value, seen) = by_hats(&|_: &Integer| q(1, 1), &q(n, 8));
            let by_search: Vec<Integer> =
                (-10..10).filter(|k| !b1(&(q(n, 8) - k)).is_zero()).map(Integer::from).collect();
            assert_eq!(seen, by_search);
            assert_eq!((value, seen.len()), (q(1, 1), if n % 8 == 0 { 1 } else { 2 }));
        }
    }
}

//! The map n_λ: its range, smoothness and slope, and its values at irrational curvatures.

use super::level::{jet, small};
use super::q;
use isoracle::curvature::implicit_surface;
use isoracle::curvature::normalize::normalize;
use isoracle::curvature::normalize_derivative::{normalize_derivative, normalized_curvature};
use isoracle::number::{Enclosure, Interval, OrderedField, Rational, Ring, Sign, Surd};
use proptest::prelude::*;

fn enclosed(x: &Rational) -> Interval {
    Interval::from_rational(x, 700)
}

fn value(slope: &Rational, x: &Rational) -> Interval {
    normalize(slope, x, 700).expect("λ > 0")
}

fn slope() -> impl Strategy<Value = Rational> {
    (1..=9_i64, 1..=5_i64).prop_map(|(n, d)| q(n, d))
}

mod cu_200 {
    use super::*;

    proptest! {
        #[test]
        fn values_lie_between_0_and_1_and_grow(l in slope(), x in small(), step in (1..=6_i64, 1..=9_i64)) {
            let y = Rational::from(&x + &q(step.0, step.1));
            let (a, b) = (value(&l, &x), value(&l, &y));
            prop_assert_eq!(a.known_sign(), Some(Sign::Positive));
            prop_assert_eq!((b.clone() - &a).known_sign(), Some(Sign::Positive));
            prop_assert_eq!((Interval::integer(1) - &b).known_sign(), Some(Sign::Positive));
        }
    }

    #[test]
    fn values_come_as_close_to_the_ends_as_asked_for() {
        // e^(−100)/2 < 10⁻⁴³
        let hair = enclosed(&Rational::from((1, (0..43).fold(isoracle::number::Integer::from(1), |p, _| p * 10_u32))));
        let low = value(&q(1, 1), &q(-100, 1));
        assert_eq!((hair.clone() - &low).known_sign(), Some(Sign::Positive));
        let high = Interval::integer(1) - &value(&q(1, 1), &q(100, 1));
        assert_eq!((hair - &high).known_sign(), Some(Sign::Positive));
    }
}

mod cu_201 {
    use super::*;

    proptest! {
        /// The mean value theorem with a derivative that falls with |x|: on one side of 0 the quotient lies between the derivatives.
        #[test]
        fn difference_quotients_lie_between_the_derivatives(
            l in slope(), x in (0..=20_i64, 1..=6_i64), step in (1..=12_i64, 1..=9_i64), negative in any::<bool>(),
        ) {
            let sign = if negative { -1 } else { 1 };
            let near = q(x.0, x.1) * sign;
            let h = q(step.0, step.1);
            let far = Rational::from(&near + &(h.clone() * sign));
            let rise = (value(&l, &far) - &value(&l, &near)) * &enclosed(&(h.recip() * sign));
            let [least, most] = [&far, &near].map(|x| normalize_derivative(&l, x, 700).expect("λ > 0"));
            prop_assert_eq!((rise.clone() - &least).known_sign(), Some(Sign::Positive));
            prop_assert_eq!((most - &rise).known_sign(), Some(Sign::Positive));
        }
    }

    #[test]
    fn both_pieces_meet_at_0_with_one_slope_and_two_curvatures() {
        let (l, zero) = (q(3, 2), q(0, 1));
        // e⁰/2 = 1 − e⁰/2
        assert!(value(&l, &zero).contains(&q(1, 2)));
        let at_zero = normalize_derivative(&l, &zero, 700).expect("λ > 0");
        assert!(at_zero.contains(&q(3, 4)));
        // (n′(h) − n′(0))/h tends to −λ²/2 from the right and to λ²/2 from the left: n is C¹ and not C².
        for (sign, limit) in [(1_i64, q(-9, 8)), (-1, q(9, 8))] {
            let h = q(sign, 1 << 40);
            let quotient = (normalize_derivative(&l, &h, 700).expect("λ > 0") - &at_zero) * &enclosed(&h.recip());
            let margin = enclosed(&q(1, 1 << 30));
            let off = quotient - &enclosed(&limit);
            assert_eq!((margin.clone() - &off).known_sign(), Some(Sign::Positive));
            assert_eq!((margin + &off).known_sign(), Some(Sign::Positive));
        }
    }
}

mod cu_202 {
    use super::*;

    #[test]
    fn the_slope_is_greatest_at_0_and_half_of_lambda() {
        for l in [q(1, 2), q(1, 1), q(7, 3)] {
            let at_zero = normalize_derivative(&l, &q(0, 1), 700).expect("λ > 0");
            assert!(at_zero.contains(&Rational::from(&l / 2_u32)));
            for x in [q(-1, 9), q(1, 9), q(5, 1)] {
                let there = normalize_derivative(&l, &x, 700).expect("λ > 0");
                assert_eq!((at_zero.clone() - &there).known_sign(), Some(Sign::Positive));
            }
        }
    }

    #[test]
    fn without_a_positive_slope_there_is_no_derivative_to_tell() {
        for l in [q(0, 1), q(-2, 1)] {
            assert!(normalize_derivative(&l, &q(1, 1), 100).is_err());
            assert!(normalized_curvature(&l, &Surd::integer(1), 100).is_err());
        }
    }

    #[test]
    fn the_curve_of_the_figure_passes_half_at_0_and_four_fifths_near_2() {
        // n_0.5(2) = 1 − 1/(2e) = 0.8160…, n_0.5(−2) = 0.1839…
        let half = q(1, 2);
        assert!(value(&half, &q(0, 1)).contains(&half));
        for (x, lo, hi) in [(2, q(8160, 10_000), q(8161, 10_000)), (-2, q(1839, 10_000), q(1840, 10_000))] {
            let there = value(&half, &q(x, 1));
            assert_eq!((there.clone() - &enclosed(&lo)).known_sign(), Some(Sign::Positive));
            assert_eq!((enclosed(&hi) - &there).known_sign(), Some(Sign::Positive));
        }
    }
}

mod cu_203 {
    use super::*;

    proptest! {
        #[test]
        fn at_rational_curvatures_it_is_the_map(l in slope(), x in small()) {
            let [a, b] = [value(&l, &x), normalized_curvature(&l, &Surd::from(x), 700).expect("λ > 0")];
            // Both enclose one number, to 190 bits.
            let width = a.clone() - &b;
            let hair = enclosed(&Rational::from((1, isoracle::number::Integer::from(1) << 190)));
            prop_assert!(width.contains(&q(0, 1)));
            prop_assert_eq!((hair - &width).known_sign(), Some(Sign::Positive));
        }
    }

    #[test]
    fn the_four_curvatures_of_a_saddle_have_colours_on_both_sides_of_a_half() {
        // ∇f = (1, 0, 1): H is irrational.
        let level = implicit_surface::curvature(&jet([1, 0, 1], [1, 0, 0, -3, 0, 0])).expect("regular");
        let l = q(1, 2);
        assert!(level.principal().mean().rational().is_none());
        let [k1, k2] = level.principal().exact().expect("one field");
        let gaussian = Surd::from(level.gaussian.clone());
        for (k, side) in [(k1, Sign::Positive), (k2, Sign::Negative), (gaussian, Sign::Negative)] {
            let colour = normalized_curvature(&l, &k, 700).expect("λ > 0");
            assert_eq!((colour.clone() - &enclosed(&q(1, 2))).known_sign(), Some(side));
            assert_eq!(colour.known_sign(), Some(Sign::Positive));
            assert_eq!((Interval::integer(1) - &colour).known_sign(), Some(Sign::Positive));
        }
    }
}

mod cu_217 {
    use super::*;

    proptest! {
        #[test]
        fn the_side_of_a_half_is_the_sign_of_the_curvature(l in slope(), a in small(), b in small(), d in 1..=7_u32) {
            let k = Surd::new(a, b, &Rational::from(d)).expect("d > 0");
            let off = normalized_curvature(&l, &k, 300).expect("λ > 0") - &enclosed(&q(1, 2));
            match k.sign() {
                Sign::Zero => prop_assert!(off.contains(&q(0, 1))),
                sign @ (Sign::Negative | Sign::Positive) => prop_assert_eq!(off.known_sign(), Some(sign)),
            }
        }
    }
}

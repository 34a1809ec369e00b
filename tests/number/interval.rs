//! Intervals of MPFR numbers.

mod nu_8 {
    use crate::strategy::{interval, rational};
    use isoracle::number::decimal::Digits;
    use isoracle::number::text::parse;
    use isoracle::number::{Enclosure, Integer, Interval, Rational, Ring, Sign};
    use proptest::prelude::*;

    fn q(p: i64, q: i64) -> Rational {
        Rational::from((p, q))
    }

    /// The interval has the number in it, and any sign that it claims is right.
    fn encloses(interval: &Interval, x: &Rational) -> bool {
        interval.contains(x) && interval.known_sign().is_none_or(|s| s == Sign::of(x.cmp0()))
    }

    #[test]
    fn a_third_is_enclosed_as_narrowly_as_the_precision_allows() {
        for precision in [2, 3, 24, 53, 400] {
            let third = Interval::from_rational(&q(1, 3), precision);
            assert_eq!(third.precision(), precision);
            assert!(third.contains(&q(1, 3)));
            // 1/3 has its leading bit at 2⁻²: one unit of the last place is 2^(−1−precision).
            assert_eq!(third.width(), Some(Rational::from((Integer::from(1), Integer::from(1) << (precision + 1)))));
        }
        assert_eq!(Interval::from_rational(&q(1, 3), 0).precision(), 2);
    }

    #[test]
    fn the_precision_of_a_result_is_the_larger_one() {
        let (a, b) = (Interval::from_rational(&q(1, 3), 10), Interval::from_rational(&q(1, 3), 90));
        for result in [a.clone() + &b, a.clone() - &b, b.clone() * &a] {
            assert_eq!(result.precision(), 90);
        }
        assert_eq!(b.checked_div(&a).map(|c| c.precision()), Some(90));
        assert_eq!(Interval::integer(i64::MIN).width(), Some(q(0, 1)));
        assert_eq!(Interval::integer(i64::MAX).bounds(), Some((q(i64::MAX, 1), q(i64::MAX, 1))));
    }

    #[test]
    fn an_undecided_sign_is_none() {
        let third = Interval::from_rational(&q(1, 3), 20);
        assert_eq!((third.clone() - &third).known_sign(), None);
        assert_eq!(Interval::integer(0).known_sign(), Some(Sign::Zero));
        assert_eq!(third.known_sign(), Some(Sign::Positive));
        assert_eq!((-third).known_sign(), Some(Sign::Negative));
        assert_eq!(Interval::between(&q(0, 1), &q(1, 1), 9).expect("in order").known_sign(), None);
        assert!(Interval::between(&q(1, 1), &q(0, 1), 9).is_none());
    }

    #[test]
    fn division_by_an_interval_with_zero_is_refused() {
        let one = Interval::integer(1);
        let around = |lo, hi| Interval::between(&q(lo, 1), &q(hi, 1), 20).expect("in order");
        for divisor in [around(0, 0), around(-1, 1), around(0, 1), around(-1, 0)] {
            assert!(one.checked_div(&divisor).is_none(), "{divisor}");
        }
        let quotient = around(-6, 12).checked_div(&around(-3, -2)).expect("not zero");
        assert_eq!(quotient.bounds(), Some((q(-6, 1), q(3, 1))));
    }

    #[test]
    fn beyond_the_exponents_a_bound_is_infinite_and_nothing_is_a_nan() {
        let mut large = Interval::from_integer(&Integer::from(3), 4);
        while !large.hi().is_infinite() {
            large = large.clone() * &large;
        }
        assert!(large.lo().is_finite());
        assert_eq!(large.known_sign(), Some(Sign::Positive));
        assert_eq!(large.width(), None);
        assert!(large.decimals(Digits::default()).is_none());
        let anything = large.clone() - &large;
        let zero = Interval::integer(0);
        assert_eq!((anything.clone() * &zero).known_sign(), Some(Sign::Zero));
        for i in [
            anything.clone(),
            anything.clone() * &anything,
            anything.clone() + &large,
            -anything.clone() * &large,
            anything.checked_div(&large).expect("positive"),
            anything.checked_div(&-large.clone()).expect("negative"),
            large.checked_div(&large).expect("positive"),
        ] {
            assert!(!i.lo().is_nan() && !i.hi().is_nan());
            assert!(i.contains(&q(1, 1)) || i.known_sign().is_some(), "{i}");
        }
        assert!(large.checked_div(&large).expect("positive").contains(&q(1, 1)));
        let tiny = Interval::integer(1).checked_div(&large).expect("positive");
        assert!((tiny.clone() * &tiny).hi() > &0);
    }

    proptest! {
        #[test]
        fn every_operation_encloses((x, a) in interval(), (y, b) in interval()) {
            prop_assert!(encloses(&a, &x) && encloses(&b, &y));
            prop_assert!(encloses(&(a.clone() + &b), &Rational::from(&x + &y)));
            prop_assert!(encloses(&(a.clone() - &b), &Rational::from(&x - &y)));
            prop_assert!(encloses(&(a.clone() * &b), &Rational::from(&x * &y)));
            prop_assert!(encloses(&-a.clone(), &Rational::from(-&x)));
            if let Some(quotient) = a.checked_div(&b) {
                prop_assert!(encloses(&quotient, &Rational::from(&x / &y)));
            }
        }

        #[test]
        fn a_root_of_a_square_is_found_again((x, a) in interval()) {
            let (lo, hi) = a.bounds().expect("finite");
            let square = a.clone() * &a;
            let root = square.sqrt();
            prop_assert_eq!(root.is_some(), square.bounds().expect("finite").0 >= 0);
            prop_assert!(root.is_none_or(|root| root.contains(&x.abs()) && root.contains(&lo.abs()) && root.contains(&hi.abs())));
        }

        #[test]
        fn the_square_of_a_root_encloses_the_number(x in rational(), precision in 2..200_u32) {
            let x = x.abs();
            let root = Interval::from_rational(&x, precision).sqrt().expect("not negative");
            let (lo, hi) = root.bounds().expect("finite");
            prop_assert!(lo.clone() * &lo <= x && x <= hi.clone() * &hi);
        }

        #[test]
        fn decimal_strings_enclose_the_bounds((_, a) in interval(), digits in 0..60_u32) {
            let (lo, hi) = a.bounds().expect("finite");
            if let Some(strings) = a.decimals(Digits::new(digits).expect("few digits")) {
                prop_assert!(parse(&strings.lo).expect("a decimal") <= lo);
                prop_assert!(parse(&strings.hi).expect("a decimal") >= hi);
            }
        }
    }
}

//! Intervals of binary64.

mod nu_7 {
    use crate::strategy::{f64_interval, rational};
    use isoracle::number::text::NumberError;
    use isoracle::number::{Enclosure, F64Interval, Rational, Ring, Sign};
    use proptest::prelude::*;

    /// The doubles where rounding is delicate: zero, subnormals, around 1, around 2⁵³, the largest ones.
    fn nasty() -> Vec<f64> {
        let positive = [
            0.0,
            5e-324,
            1e-323,
            f64::MIN_POSITIVE.next_down(),
            f64::MIN_POSITIVE,
            1.5e-162,
            1e-16,
            0.1,
            1.0_f64.next_down(),
            1.0,
            1.0_f64.next_up(),
            3.0,
            9_007_199_254_740_991.0,
            9_007_199_254_740_992.0,
            1.3407807929942597e154,
            f64::MAX.next_down(),
            f64::MAX,
        ];
        positive.iter().flat_map(|&x| [-x, x]).collect()
    }

    fn exact(x: f64) -> (Rational, F64Interval) {
        (Rational::from_f64(x).expect("finite"), F64Interval::exact(x).expect("finite"))
    }

    fn sign(x: &Rational) -> Sign {
        Sign::of(x.cmp0())
    }

    /// The interval has the number in it, is in order, and any sign that it claims is right.
    fn encloses(interval: F64Interval, x: &Rational) -> bool {
        !interval.lo().is_nan()
            && !interval.hi().is_nan()
            && interval.lo() < f64::INFINITY
            && interval.hi() > f64::NEG_INFINITY
            && interval.contains(x)
            && interval.known_sign().is_none_or(|s| s == sign(x))
    }

    #[test]
    fn every_pair_of_nasty_doubles_is_enclosed() {
        let doubles = nasty();
        for &x in &doubles {
            for &y in &doubles {
                let ((p, a), (q, b)) = (exact(x), exact(y));
                assert!(encloses(a + &b, &Rational::from(&p + &q)), "{x:e} + {y:e}");
                assert!(encloses(a - &b, &Rational::from(&p - &q)), "{x:e} - {y:e}");
                assert!(encloses(a * &b, &Rational::from(&p * &q)), "{x:e} * {y:e}");
                assert!(encloses(-a, &Rational::from(-&p)), "-{x:e}");
            }
        }
    }

    #[test]
    fn every_corner_of_a_pair_of_nasty_intervals_is_enclosed() {
        let doubles: Vec<f64> = nasty().into_iter().step_by(3).collect();
        let intervals: Vec<F64Interval> = doubles
            .iter()
            .flat_map(|&x| doubles.iter().map(move |&y| F64Interval::between(x, y).expect("finite")))
            .collect();
        for a in &intervals {
            for b in &intervals {
                let corners = |i: &F64Interval| [i.lo(), i.hi()].map(|x| exact(x).0);
                for p in corners(a) {
                    for q in corners(b) {
                        assert!(encloses(*a + b, &Rational::from(&p + &q)), "{a:?} + {b:?}");
                        assert!(encloses(*a - b, &Rational::from(&p - &q)), "{a:?} - {b:?}");
                        assert!(encloses(*a * b, &Rational::from(&p * &q)), "{a:?} * {b:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn an_infinite_bound_is_never_a_nan_and_never_a_decision() {
        let (_, large) = exact(f64::MAX);
        let unbounded = large * &large;
        assert_eq!((unbounded.lo(), unbounded.hi()), (f64::MAX, f64::INFINITY));
        assert_eq!(unbounded.known_sign(), Some(Sign::Positive));
        let anything = unbounded - &unbounded;
        assert_eq!((anything.lo(), anything.hi()), (f64::NEG_INFINITY, f64::INFINITY));
        let zero = F64Interval::integer(0);
        for undecided in
            [anything, anything + &unbounded, anything * &anything, anything * &zero, -anything * &unbounded]
        {
            assert_eq!(undecided.known_sign(), None, "{undecided:?}");
            assert!(!undecided.lo().is_nan() && !undecided.hi().is_nan());
        }
    }

    #[test]
    fn a_point_keeps_its_sign_and_only_an_exact_zero_is_zero() {
        assert_eq!(F64Interval::integer(0).known_sign(), Some(Sign::Zero));
        assert_eq!(exact(-0.0).1.known_sign(), Some(Sign::Zero));
        assert_eq!(exact(5e-324).1.known_sign(), Some(Sign::Positive));
        assert_eq!(exact(-5e-324).1.known_sign(), Some(Sign::Negative));
        let (_, tiny) = exact(5e-324);
        assert_eq!((tiny * &tiny).known_sign(), None, "the product underflows");
        assert_eq!((F64Interval::integer(2) - &F64Interval::integer(1)).known_sign(), Some(Sign::Positive));
        assert_eq!(F64Interval::between(2.0, -1.0).map(|i| (i.lo(), i.hi())), Ok((-1.0, 2.0)));
        assert_eq!(F64Interval::exact(f64::NAN).err(), Some(NumberError::NotANumber));
        assert_eq!(F64Interval::between(0.0, f64::INFINITY).err(), Some(NumberError::Infinite));
    }

    #[test]
    fn an_integer_is_a_point_up_to_2_to_the_53() {
        for n in [0, 1, -1, 1 << 53, -(1 << 53), (1 << 53) + 1, i64::MAX, i64::MIN] {
            let interval = F64Interval::integer(n);
            assert!(interval.contains(&Rational::from(n)), "{n}");
            assert_eq!(interval.lo() == interval.hi(), n.unsigned_abs() <= 1 << 53, "{n}");
        }
    }

    proptest! {
        #[test]
        fn a_rational_is_enclosed_by_neighbours(x in rational()) {
            let interval = F64Interval::from_rational(&x);
            prop_assert!(encloses(interval, &x));
            prop_assert!(interval.hi() <= interval.lo().next_up().next_up());
            let below = Rational::from_f64(interval.lo()).is_some_and(|lo| lo == x);
            prop_assert_eq!(interval.lo() == interval.hi(), below);
        }

        #[test]
        fn a_formula_is_enclosed((p, a) in f64_interval(), (q, b) in f64_interval(), (r, c) in f64_interval()) {
            let value = Rational::from(&p * &q) - Rational::from(&q * &r) * &p + &r;
            prop_assert!(encloses(a * &b - &(b * &c * &a) + &c, &value));
        }
    }
}

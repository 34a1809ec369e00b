//! Elementary functions of intervals.

mod nu_8 {
    use crate::strategy::interval;
    use isoracle::number::{Enclosure, Interval, Rational, Ring, Sign};
    use proptest::prelude::*;

    fn q(p: i64, q: i64) -> Rational {
        Rational::from((p, q))
    }

    fn at(x: &Rational) -> Interval {
        Interval::from_rational(x, 120)
    }

    /// Both enclose one number, so they meet; and they are as narrow as that.
    fn agree(a: &Interval, b: &Interval) -> bool {
        a.intersection(b).is_some()
    }

    fn is_narrow(a: &Interval, bits: i32) -> bool {
        a.width().is_some_and(|w| w <= Rational::from(1) >> bits)
    }

    #[test]
    fn a_coarse_exponential_encloses_a_fine_one() {
        for (n, d) in [(-40, 1), (-7, 3), (0, 1), (1, 1), (5, 7), (19, 2)] {
            let fine = Interval::from_rational(&q(n, d), 300).exp();
            let (lo, hi) = fine.bounds().expect("finite");
            for bits in [8, 20, 53, 120] {
                let coarse = Interval::from_rational(&q(n, d), bits).exp();
                assert!(coarse.contains(&lo) && coarse.contains(&hi), "e^({n}/{d}) in {bits} bits");
            }
            // e^x·e^(−x) = 1
            assert!((fine * &Interval::from_rational(&q(-n, d), 300).exp()).contains(&q(1, 1)));
        }
        let wide = Interval::between(&q(-1, 1), &q(2, 1), 60).expect("in order").exp();
        assert!(wide.contains(&q(368, 1000)) && wide.contains(&q(738, 100)) && !wide.contains(&q(739, 100)));
    }

    #[test]
    fn sines_of_parts_of_the_circle_are_known() {
        let pi = Interval::pi(200);
        let sixth = pi.checked_div(&Interval::integer(6)).expect("6 is not 0");
        assert!(sixth.sin().contains(&q(1, 2)) && is_narrow(&sixth.sin(), 190));
        assert!((sixth.clone() + &sixth).cos().contains(&q(1, 2)));
        assert!(pi.cos().contains(&q(-1, 1)) && pi.sin().contains(&q(0, 1)));
        // The sine of every number is at least −1.
        assert_eq!(pi.cos().bounds().map(|(lo, _)| lo), Some(q(-1, 1)));
    }

    #[test]
    fn a_sine_of_what_is_too_large_or_too_wide_says_nothing_but_is_no_nan() {
        let wide = Interval::between(&q(-1000, 1), &q(1000, 1), 60).expect("in order");
        let huge = (0..14).fold(Interval::integer(3), |x, _| x.square());
        for x in [wide, huge, Interval::everything(60)] {
            for y in [x.sin(), x.cos()] {
                assert_eq!(y.bounds(), Some((q(-1, 1), q(1, 1))));
            }
        }
    }

    #[test]
    fn squares_are_not_negative() {
        let around = Interval::between(&q(-2, 1), &q(1, 1), 60).expect("in order");
        assert_eq!(around.square().bounds(), Some((q(0, 1), q(4, 1))));
        assert_eq!(around.power(3).bounds(), Some((q(-8, 1), q(4, 1))));
        assert_eq!(around.power(0).bounds(), Some((q(1, 1), q(1, 1))));
        assert_eq!(around.abs().bounds(), Some((q(0, 1), q(2, 1))));
        assert_eq!(around.not_negative().expect("1 is in it").bounds(), Some((q(0, 1), q(1, 1))));
        assert!((around - &Interval::integer(2)).not_negative().is_none());
        assert!(Interval::everything(60).square().known_sign() != Some(Sign::Negative));
    }

    #[test]
    fn logarithms_of_what_may_be_0_are_refused() {
        assert!(Interval::integer(0).ln().is_none() && Interval::integer(-1).ln().is_none());
        assert!(Interval::integer(1).ln().expect("positive").contains(&q(0, 1)));
        // π/4 = arctan 1 = 4 arctan 1/5 − arctan 1/239
        let machin = at(&q(1, 5)).atan() * &Interval::integer(4) - &at(&q(1, 239)).atan();
        let quarter = Interval::pi(120).checked_div(&Interval::integer(4)).expect("4 is not 0");
        assert!(agree(&machin, &quarter) && is_narrow(&machin, 110));
        assert!(agree(&Interval::integer(1).atan(), &quarter));
    }

    proptest! {
        #[test]
        fn intervals_have_the_values_of_their_numbers((x, a) in interval()) {
            let point = at(&x);
            prop_assert!(agree(&a.sin(), &point.sin()) && agree(&a.cos(), &point.cos()) && agree(&a.atan(), &point.atan()));
            prop_assert!(a.square().contains(&x.clone().square()) && a.abs().contains(&x.clone().abs()));
            prop_assert!(a.power(5).contains(&(x.clone().square().square() * &x)));
            if let Some(ln) = a.ln() {
                prop_assert!(agree(&ln, &point.ln().expect("x is in it")) && agree(&ln.exp(), &point));
            }
        }

        #[test]
        fn a_sine_is_narrow_and_pythagorean(x in (-100..=100_i64, 1..=50_i64).prop_map(Rational::from)) {
            let (s, c) = (at(&x).sin(), at(&x).cos());
            prop_assert!(is_narrow(&s, 110) && is_narrow(&c, 110));
            prop_assert!((s.square() + &c.square()).contains(&q(1, 1)));
            // sin 2x = 2 sin x cos x
            let twice = at(&(x.clone() * 2_u32)).sin();
            prop_assert!(agree(&twice, &(s.clone() * &c * &Interval::integer(2))));
        }

        #[test]
        fn sets_are_those_of_their_numbers((x, a) in interval(), (y, b) in interval()) {
            let hull = a.hull(&b);
            prop_assert!(hull.contains(&x) && hull.contains(&y));
            match a.intersection(&b) {
                None => prop_assert!(!a.contains(&y) && !b.contains(&x)),
                Some(both) => prop_assert_eq!(both.contains(&x), b.contains(&x)),
            }
        }
    }
}

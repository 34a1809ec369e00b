//! ℚ(√d), and the roots of quadratic polynomials.

use crate::strategy::{rational, small_rational, surd, surd_and_near_rational, surd_over};
use isoracle::number::{
    Algebraic, Enclosure, Integer, OrderedField, Polynomial, QuadraticRoots, Rational, Ring, Sign, Surd, SurdError,
    quadratic_roots, real_roots,
};
use proptest::prelude::*;
use std::cmp::Ordering;

fn q(p: i64, q: i64) -> Rational {
    Rational::from((p, q))
}

fn surd_of(a: Rational, b: Rational, d: i64) -> Surd {
    Surd::new(a, b, &Rational::from(d)).expect("not negative")
}

mod nu_10 {
    use super::*;

    /// The numbers reach from 2⁻¹⁰⁷⁴ to 2¹⁰²⁴: two of them that this many bits do not part are equal.
    const BITS: u32 = 8000;

    /// The order by enclosures, where they part.
    fn order_by_enclosure(x: &Surd, y: &Surd) -> Option<Ordering> {
        let difference = x.enclosure(BITS) - &y.enclosure(BITS);
        difference.known_sign().map(|s| s.value().cmp(&0))
    }

    #[test]
    fn known_orders() {
        let phi = surd_of(q(1, 2), q(1, 2), 5);
        assert_eq!(phi.sign(), Sign::Positive);
        assert_eq!(phi.conjugate().sign(), Sign::Negative);
        assert!(surd_of(q(17, 12), q(-1, 1), 2).sign() == Sign::Positive);
        assert!(surd_of(q(-41, 29), q(1, 1), 2).sign() == Sign::Positive);
        assert!(surd_of(q(0, 1), q(1, 1), 2) < surd_of(q(0, 1), q(1, 1), 3));
        // √2 + √3 = 3.14626…, √10 = 3.16227…
        assert!(surd_of(q(-3, 1), q(1, 1), 10) > surd_of(q(0, 1), q(1, 100), 2));
        assert_eq!(Surd::integer(0).sign(), Sign::Zero);
    }

    #[test]
    fn equality_is_exact_where_no_factoring_is_done() {
        // p, r are primes above 2³²: neither p²r nor the same times 4 can have its square found by trial division.
        let (p, r) = (Integer::from((1_u64 << 32) + 15), Integer::from((1_u64 << 33) + 17));
        let hidden = Rational::from(Integer::from(p.square_ref()) * &r);
        let x = Surd::sqrt(&hidden).expect("positive");
        assert!(!x.radicand_is_proven_square_free());
        let y = Surd::new(q(0, 1), Rational::from(&p), &Rational::from(&r)).expect("positive");
        assert!(y.radicand_is_proven_square_free());
        assert_ne!(x.parts(), y.parts());
        assert_eq!(x, y);
        assert_eq!((x.clone() - &y).sign(), Sign::Zero);
        assert_eq!(x.clone() * &y, Surd::from(hidden));
        assert!(x.clone() + &Surd::integer(1) > y);
        assert_eq!((x.inverse().expect("not zero") * &y).rational(), Some(&q(1, 1)));
    }

    proptest! {
        #[test]
        fn the_order_is_that_of_enclosures(x in surd(), y in surd()) {
            match order_by_enclosure(&x, &y) {
                Some(order) => prop_assert_eq!(x.cmp(&y), order),
                None => prop_assert_eq!(&x, &y),
            }
            prop_assert_eq!(x.cmp(&y), y.cmp(&x).reverse());
        }

        #[test]
        fn a_near_rational_is_told_apart((x, near) in surd_and_near_rational()) {
            let y = Surd::from(near.clone());
            prop_assert!(y <= x);
            prop_assert_eq!(y == x, x.rational() == Some(&near));
            prop_assert_eq!(order_by_enclosure(&x, &y).unwrap_or(Ordering::Equal), x.cmp(&y));
        }

        #[test]
        fn the_sign_is_that_of_an_enclosure(x in surd()) {
            let by_enclosure = x.enclosure(BITS).known_sign().unwrap_or(Sign::Zero);
            prop_assert_eq!(x.sign(), by_enclosure);
        }
    }
}

mod nu_11 {
    use super::*;

    fn written(a: Rational, b: Rational, d: Rational) -> String {
        Surd::new(a, b, &d).expect("not negative").to_string()
    }

    #[test]
    fn squares_leave_the_root() {
        let (zero, one) = (|| q(0, 1), || q(1, 1));
        assert_eq!(written(q(7, 3), q(-2, 5), q(2, 1)), "7/3 - 2/5·√2");
        assert_eq!(written(q(7, 3), q(2, 5), q(2, 1)), "7/3 + 2/5·√2");
        assert_eq!(written(zero(), one(), q(12, 1)), "2·√3");
        assert_eq!(written(zero(), q(-1, 1), q(3, 1)), "-√3");
        assert_eq!(written(one(), one(), q(9, 4)), "5/2");
        assert_eq!(written(zero(), one(), q(1, 3)), "1/3·√3");
        assert_eq!(written(zero(), one(), q(8, 27)), "2/9·√6");
        assert_eq!(written(one(), zero(), q(7, 1)), "1");
        assert_eq!(written(one(), one(), zero()), "1");
        // (2³² + 15)² is above the bound of the trial division, but a square.
        let p = Rational::from((1_u64 << 32) + 15);
        assert_eq!(written(zero(), one(), p.clone().square() * 2), format!("{p}·√2"));
        assert_eq!(Surd::sqrt(&q(-1, 2)), Err(SurdError::NegativeRadicand { radicand: q(-1, 2) }));
    }

    #[test]
    fn every_small_radicand_is_made_square_free() {
        for n in 1..=3000_i64 {
            let x = Surd::sqrt(&q(n, 1)).expect("positive");
            assert!(x.radicand_is_proven_square_free());
            let s = (1..=60).rev().find(|s| n % (s * s) == 0).expect("1 divides");
            match x.rational() {
                Some(root) => assert_eq!((root, n), (&q(s, 1), s * s)),
                None => assert_eq!(x.parts(), (&q(0, 1), &q(s, 1), &Integer::from(n / (s * s))), "√{n}"),
            }
        }
    }

    proptest! {
        #[test]
        fn the_square_of_the_root_is_the_radicand(r in rational()) {
            let r = r.abs();
            let x = Surd::sqrt(&r).expect("not negative");
            prop_assert!(x.sign() != Sign::Negative);
            let square = x.clone() * &x;
            prop_assert_eq!(square.rational(), Some(&r));
            let (_, b, d) = x.parts();
            prop_assert_eq!(b.is_zero(), *d == 1);
            prop_assert!(*d == 1 || !d.is_perfect_square());
        }

        #[test]
        fn a_planted_square_is_found(s in 1..1_000_000_u64, d in 1..1000_u32) {
            let root = Surd::sqrt(&Rational::from(d)).expect("positive");
            let scaled = Surd::sqrt(&(Rational::from(s).square() * Rational::from(d))).expect("positive");
            prop_assert!(scaled.radicand_is_proven_square_free());
            prop_assert_eq!(scaled.parts().2, root.parts().2);
            prop_assert_eq!(scaled, root * &Surd::from(Rational::from(s)));
        }
    }
}

mod nu_12 {
    use super::*;

    #[test]
    fn two_fields_do_not_mix() {
        let (x, y) = (surd_of(q(0, 1), q(1, 1), 2), surd_of(q(1, 1), q(1, 1), 3));
        let refused = SurdError::DifferentFields { left: Integer::from(2), right: Integer::from(3) };
        assert_eq!(x.checked_add(&y), Err(refused.clone()));
        assert_eq!(x.checked_sub(&y), Err(refused.clone()));
        assert_eq!(x.checked_mul(&y), Err(refused.clone()));
        assert_eq!(x.checked_div(&y).map_err(|e| e.to_string()), Err("√2 and √3 are of different fields".to_string()));
        assert_eq!(x.checked_div(&Surd::integer(0)), Err(SurdError::DivisionByZero));
        assert_eq!(x.checked_add(&Surd::integer(1)), Ok(surd_of(q(1, 1), q(1, 1), 2)));
        assert_eq!(Surd::integer(3).checked_mul(&x), Ok(surd_of(q(0, 1), q(3, 1), 2)));
        // √2 and √8 are of one field.
        assert_eq!(x.checked_mul(&surd_of(q(0, 1), q(1, 1), 8)), Ok(Surd::integer(4)));
    }

    #[test]
    fn known_products_and_inverses() {
        let phi = surd_of(q(1, 2), q(1, 2), 5);
        assert_eq!(phi.clone() * &phi, phi.clone() + &Surd::integer(1));
        assert_eq!(phi.inverse(), Some(phi.clone() - &Surd::integer(1)));
        assert_eq!(phi.norm(), q(-1, 1));
        assert_eq!(Surd::integer(0).inverse(), None);
    }

    proptest! {
        #[test]
        fn it_is_a_field(x in surd_over(5), y in surd_over(5), z in surd_over(5)) {
            prop_assert_eq!((x.clone() + &y) * &z, x.clone() * &z + &(y.clone() * &z));
            prop_assert_eq!(x.clone() * &y * &z, x.clone() * &(z.clone() * &y));
            prop_assert_eq!(x.clone() - &y + &y, x.clone());
            prop_assert_eq!(x.clone() + &-x.clone(), Surd::integer(0));
            prop_assert_eq!(y.sign() == Sign::Zero, y.inverse().is_none());
            if let Some(inverse) = y.inverse() {
                prop_assert_eq!(y.clone() * &inverse, Surd::integer(1));
                prop_assert_eq!(x.checked_div(&y).expect("one field") * &y, x.clone());
            }
        }

        #[test]
        fn the_order_is_that_of_a_field(x in surd_over(7), y in surd_over(7), z in surd_over(7)) {
            prop_assert_eq!(x.cmp(&y), (x.clone() + &z).cmp(&(y.clone() + &z)));
            prop_assert_eq!((x.clone() * &y).sign(), x.sign() * y.sign());
        }

        #[test]
        fn operations_are_enclosed_by_those_of_enclosures(x in surd_over(3), y in surd_over(3)) {
            let (a, b) = (x.enclosure(100), y.enclosure(100));
            for (exact, enclosed) in [
                (x.clone() + &y, a.clone() + &b),
                (x.clone() - &y, a.clone() - &b),
                (x.clone() * &y, a.clone() * &b),
            ] {
                let difference = exact.enclosure(500) - &enclosed;
                prop_assert!(difference.contains(&q(0, 1)), "{}", exact);
            }
        }
    }
}

mod nu_13 {
    use super::*;

    #[test]
    fn each_kind_of_roots() {
        let roots = |a, b, c| quadratic_roots(&q(a, 1), &q(b, 1), &q(c, 1));
        assert_eq!(roots(0, 0, 0), QuadraticRoots::Every);
        assert_eq!(roots(0, 0, 1), QuadraticRoots::None);
        assert_eq!(roots(0, 2, 1), QuadraticRoots::Linear(q(-1, 2)));
        assert_eq!(roots(0, 2, 0), QuadraticRoots::Linear(q(0, 1)));
        assert_eq!(roots(1, 0, 1), QuadraticRoots::None);
        assert_eq!(roots(1, -2, 1), QuadraticRoots::Double(q(1, 1)));
        let golden = QuadraticRoots::Two(surd_of(q(1, 2), q(-1, 2), 5), surd_of(q(1, 2), q(1, 2), 5));
        assert_eq!(roots(1, -1, -1), golden);
        assert_eq!(roots(-3, 3, 3), golden);
    }

    proptest! {
        #[test]
        fn they_are_the_roots_that_sturm_isolates(a in small_rational(), b in small_rational(), c in rational()) {
            let p = Polynomial::new(vec![c.clone(), b.clone(), a.clone()]);
            let isolated = real_roots(&p);
            let one = |x: &Rational| Some(vec![Algebraic::from(x.clone())]);
            match quadratic_roots(&a, &b, &c) {
                QuadraticRoots::Every => prop_assert!(isolated.is_none()),
                QuadraticRoots::None => prop_assert_eq!(isolated, Some(Vec::new())),
                QuadraticRoots::Linear(x) | QuadraticRoots::Double(x) => prop_assert_eq!(isolated, one(&x)),
                QuadraticRoots::Two(x, y) => {
                    let isolated = isolated.expect("not the zero polynomial");
                    prop_assert_eq!(isolated.len(), 2);
                    prop_assert!(x < y);
                    for (surd, root) in [x, y].into_iter().zip(isolated) {
                        let of = |k: &Rational| Surd::from(k.clone());
                        let value = (of(&a) * &surd + &of(&b)) * &surd + &of(&c);
                        prop_assert_eq!(value.sign(), Sign::Zero);
                        prop_assert_eq!(surd.rational(), root.rational());
                        let (lo, hi) = root.bounds();
                        prop_assert!(of(lo) <= surd && surd <= of(hi));
                    }
                }
            }
        }
    }
}

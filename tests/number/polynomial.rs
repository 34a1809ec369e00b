//! Polynomials, their real roots, and what can be asked of a root.

use crate::strategy::{Planted, planted_polynomial, rational, small_rational};
use isoracle::number::decimal::Digits;
use isoracle::number::text::parse;
use isoracle::number::{
    Algebraic, OrderedField, Polynomial, Rational, Ring, Sign, SturmChain, Surd, quadratic_roots, real_roots,
};
use proptest::prelude::*;

fn q(p: i64, q: i64) -> Rational {
    Rational::from((p, q))
}

/// With integer coefficients, the constant first.
fn polynomial(coefficients: &[i64]) -> Polynomial {
    Polynomial::new(coefficients.iter().map(|&a| Rational::from(a)).collect())
}

/// x² − n.
fn square_minus(n: i64) -> Polynomial {
    polynomial(&[-n, 0, 1])
}

fn roots(p: &Polynomial) -> Vec<Algebraic> {
    real_roots(p).expect("not the zero polynomial")
}

mod nu_14 {
    use super::*;

    #[test]
    fn known_divisions() {
        let p = polynomial(&[-1, 0, 0, 1]);
        assert_eq!(p.divide(&polynomial(&[-1, 1])), Some((polynomial(&[1, 1, 1]), polynomial(&[]))));
        assert_eq!(p.divide(&polynomial(&[])), None);
        assert_eq!(polynomial(&[1]).divide(&p), Some((polynomial(&[]), polynomial(&[1]))));
        assert_eq!(p.gcd(&polynomial(&[1, -2, 1])), polynomial(&[-1, 1]));
        assert_eq!(polynomial(&[]).gcd(&polynomial(&[-2, -4])), polynomial(&[1, 2]));
        assert_eq!(polynomial(&[]).gcd(&polynomial(&[])), polynomial(&[]));
        assert_eq!(polynomial(&[6, -4]).primitive(), polynomial(&[3, -2]));
        assert_eq!(Polynomial::new(vec![q(1, 2), q(2, 3), q(0, 1)]).primitive(), polynomial(&[3, 4]));
        assert_eq!(polynomial(&[0, 0, 1]).derivative(), polynomial(&[0, 2]));
        assert_eq!(polynomial(&[5]).square_free(), polynomial(&[1]));
        assert_eq!(polynomial(&[0, 1, -2, 1]).to_string(), "x - 2·x^2 + x^3");
        assert_eq!(Polynomial::new(vec![q(-1, 2), q(-1, 1)]).to_string(), "-1/2 - x");
        assert_eq!(polynomial(&[]).to_string(), "0");
    }

    proptest! {
        #[test]
        fn division_undoes_multiplication(p in planted_polynomial(), d in planted_polynomial(), x in small_rational()) {
            let (p, d) = (p.polynomial, d.polynomial);
            let (quotient, rest) = p.divide(&d).expect("not zero");
            prop_assert!(rest.degree() < d.degree());
            prop_assert_eq!(quotient.clone() * &d + &rest, p.clone());
            prop_assert_eq!((p.clone() * &d).divide(&d), Some((p.clone(), polynomial(&[]))));
            prop_assert_eq!((p.clone() * &d).evaluate(&x), p.evaluate(&x) * d.evaluate(&x));
            prop_assert_eq!((p.clone() * &d).derivative(), p.derivative() * &d + &(p * &d.derivative()));
        }

        #[test]
        fn the_square_free_part_has_each_root_once(planted in planted_polynomial()) {
            let free = planted.polynomial.square_free();
            prop_assert_eq!(free.gcd(&free.derivative()).degree(), Some(0));
            for (root, multiplicity) in &planted.roots {
                prop_assert!(free.evaluate(root).is_zero());
                let mut derivative = planted.polynomial.clone();
                for _ in 0..*multiplicity {
                    prop_assert!(derivative.evaluate(root).is_zero());
                    derivative = derivative.derivative();
                }
                prop_assert!(!derivative.evaluate(root).is_zero());
            }
            let (_, rest) = planted.polynomial.divide(&free).expect("not zero");
            prop_assert!(rest.is_zero());
        }

        #[test]
        fn the_gcd_has_the_common_roots(p in planted_polynomial(), q in planted_polynomial(), shared in planted_polynomial()) {
            let gcd = (p.polynomial.clone() * &shared.polynomial).gcd(&(q.polynomial.clone() * &shared.polynomial));
            let (_, rest) = gcd.divide(&shared.polynomial).expect("not zero");
            prop_assert!(rest.is_zero());
            for (root, n) in &p.roots {
                let common = q.roots.iter().find(|(x, _)| x == root).map_or(0, |(_, m)| *m.min(n));
                let shared = shared.roots.iter().find(|(x, _)| x == root).map_or(0, |(_, m)| *m);
                prop_assert_eq!(gcd.evaluate(root).is_zero(), common + shared > 0);
            }
            for common in [&p.polynomial, &q.polynomial] {
                let (_, rest) = (common.clone() * &shared.polynomial).divide(&gcd).expect("not zero");
                prop_assert!(rest.is_zero());
            }
        }
    }
}

mod nu_15 {
    use super::*;

    #[test]
    fn known_counts() {
        let count = |p: &[i64]| SturmChain::new(&polynomial(p)).map(|chain| chain.count_all());
        assert_eq!(count(&[]), None);
        assert_eq!(count(&[7]), Some(0));
        assert_eq!(count(&[1, 0, 1]), Some(0));
        assert_eq!(count(&[0, -1, 0, 1]), Some(3));
        // Wilkinson's polynomial of degree 8, and x⁴ − 1 squared.
        assert_eq!(count(&[40320, -109584, 118124, -67284, 22449, -4536, 546, -36, 1]), Some(8));
        assert_eq!(count(&[1, 0, 0, 0, -2, 0, 0, 0, 1]), Some(2));
        let chain = SturmChain::new(&polynomial(&[0, -1, 0, 1])).expect("not zero");
        assert_eq!(chain.count(&q(-1, 1), &q(1, 1)), 2, "the left end is left out");
        assert_eq!(chain.count(&q(1, 1), &q(-1, 1)), 0);
        assert_eq!(chain.count(&q(1, 1), &q(1, 1)), 0);
    }

    proptest! {
        #[test]
        fn counts_are_those_of_the_planted_roots(planted in planted_polynomial(), a in small_rational(), b in small_rational()) {
            let Planted { polynomial, roots } = planted;
            let chain = SturmChain::new(&polynomial).expect("not zero");
            prop_assert_eq!(chain.count_all(), roots.len());
            let within = |lo: &Rational, hi: &Rational| roots.iter().filter(|(x, _)| lo < x && x <= hi).count();
            prop_assert_eq!(chain.count(&a, &b), within(&a, &b));
            // Ends at roots, simple and multiple.
            for (x, _) in &roots {
                prop_assert_eq!(chain.count(x, &b), within(x, &b));
                prop_assert_eq!(chain.count(&a, x), within(&a, x));
            }
        }
    }
}

mod nu_16 {
    use super::*;

    fn check_isolation(p: &Polynomial) {
        let roots = roots(p);
        for root in &roots {
            let (lo, hi) = root.bounds();
            let (at_lo, at_hi) = (root.polynomial().evaluate(lo), root.polynomial().evaluate(hi));
            match root.rational() {
                Some(x) => assert!(lo == x && hi == x && at_lo.is_zero()),
                None => {
                    assert!(lo < hi);
                    assert_eq!(Sign::of(at_lo.cmp0()) * Sign::of(at_hi.cmp0()), Sign::Negative);
                }
            }
        }
        for pair in roots.windows(2) {
            assert!(pair[0].bounds().1 <= pair[1].bounds().0, "{p}");
        }
    }

    #[test]
    fn irrational_roots_are_intervals_and_rational_ones_points() {
        // (x² − 2)(3x − 1)(7x + 5)
        let p = square_minus(2) * &polynomial(&[-1, 3]) * &polynomial(&[5, 7]);
        let isolated = roots(&p);
        check_isolation(&p);
        let rationals: Vec<_> = isolated.iter().map(|root| root.rational().cloned()).collect();
        assert_eq!(rationals, [None, Some(q(-5, 7)), Some(q(1, 3)), None]);
        assert_eq!(real_roots(&polynomial(&[])), None);
        assert_eq!(roots(&polynomial(&[3])), []);
        assert_eq!(roots(&polynomial(&[0, 0, 0, 1])), [Algebraic::from(q(0, 1))]);
    }

    #[test]
    fn roots_much_closer_than_a_unit_are_parted() {
        // (x² − 2)(x − 1.41421356237309504880)
        let near = parse("1.41421356237309504880").expect("a decimal");
        let isolated = roots(&(square_minus(2) * &Polynomial::with_root(&near)));
        assert_eq!(isolated.len(), 3);
        assert_eq!(isolated[1].rational(), Some(&near));
        assert_eq!(isolated[2].rational(), None);
        // Mignotte's x⁸ − 2(20x − 1)²: two roots within 2·20⁻⁵.
        let linear = polynomial(&[-1, 20]);
        let mignotte = polynomial(&[0, 0, 0, 0, 0, 0, 0, 0, 1]) - &(linear.clone() * &linear * &polynomial(&[2]));
        check_isolation(&mignotte);
        assert_eq!(roots(&mignotte).len(), 4);
    }

    #[test]
    fn a_rational_root_next_to_an_interval_is_not_taken_for_its_own() {
        // (x² − 3x + 1)(x − 3): the irrational 2.618… is parted from 3, the next integer.
        let isolated = roots(&(polynomial(&[1, -3, 1]) * &polynomial(&[-3, 1])));
        let rationals: Vec<_> = isolated.iter().map(Algebraic::rational).collect();
        assert_eq!(rationals, [None, None, Some(&q(3, 1))]);
    }

    #[test]
    fn refinement_reaches_the_width_and_keeps_the_root() {
        let root = roots(&square_minus(2)).pop().expect("two roots");
        let refined = root.refined(200);
        let (lo, hi) = refined.bounds();
        assert!(lo.clone().square() < 2 && hi.clone().square() > 2);
        assert!(Rational::from(hi - lo) * (rug::Integer::from(1) << 200_u32) <= 1);
        let strings = root.decimals(Digits::default());
        assert_eq!(strings.lo, "1.4142135623730950488016887242096");
        assert_eq!(strings.hi, "1.4142135623730950488016887242097");
    }

    proptest! {
        #[test]
        fn planted_roots_are_found_as_points(planted in planted_polynomial()) {
            check_isolation(&planted.polynomial);
            let found: Option<Vec<Rational>> = roots(&planted.polynomial).iter().map(|root| root.rational().cloned()).collect();
            prop_assert_eq!(found, Some(planted.roots.into_iter().map(|(x, _)| x).collect::<Vec<_>>()));
        }

        #[test]
        fn every_planted_root_is_within_the_bound(planted in planted_polynomial()) {
            let bound = planted.polynomial.root_bound();
            prop_assert!(planted.roots.iter().all(|(x, _)| x.clone().abs() < bound));
        }

        #[test]
        fn any_polynomial_is_isolated(coefficients in prop::collection::vec(rational(), 1..7)) {
            let p = Polynomial::new(coefficients);
            if !p.is_zero() {
                check_isolation(&p);
                prop_assert_eq!(roots(&p).len(), SturmChain::new(&p).expect("not zero").count_all());
            }
        }
    }
}

mod nu_17 {
    use super::*;

    #[test]
    fn known_signs() {
        let root = roots(&square_minus(2)).pop().expect("two roots");
        assert_eq!(root.sign_of(&square_minus(2)), Sign::Zero);
        assert_eq!(root.sign_of(&(square_minus(2) * &square_minus(3))), Sign::Zero);
        assert_eq!(root.sign_of(&polynomial(&[])), Sign::Zero);
        assert_eq!(root.sign_of(&polynomial(&[-1])), Sign::Negative);
        assert_eq!(root.sign_of(&polynomial(&[-665_857, 470_832])), Sign::Negative);
        assert_eq!(root.sign_of(&polynomial(&[-275_807, 195_025])), Sign::Positive);
    }

    proptest! {
        #[test]
        fn at_a_surd_it_is_the_sign_of_the_field(
            a in small_rational(), b in small_rational(), c in small_rational(),
            coefficients in prop::collection::vec(small_rational(), 0..5),
            factor in any::<bool>(),
        ) {
            let p = Polynomial::new(vec![c.clone(), b.clone(), a.clone()]);
            let probe = Polynomial::new(coefficients);
            // Half of the probes have the root itself.
            let probe = if factor { probe * &p } else { probe };
            if let isoracle::number::QuadraticRoots::Two(x, y) = quadratic_roots(&a, &b, &c) {
                for (surd, root) in [x, y].into_iter().zip(roots(&p)) {
                    let zero = Surd::integer(0);
                    let value = probe.coefficients().iter().rev().fold(zero, |v, k| v * &surd + &Surd::from(k.clone()));
                    prop_assert_eq!(root.sign_of(&probe), value.sign());
                }
            }
        }

        #[test]
        fn at_a_planted_root_it_is_the_sign_of_the_value(planted in planted_polynomial(), probe in planted_polynomial()) {
            for (root, (x, _)) in roots(&planted.polynomial).iter().zip(&planted.roots) {
                prop_assert_eq!(root.sign_of(&probe.polynomial), Sign::of(probe.polynomial.evaluate(x).cmp0()));
            }
        }
    }
}

mod nu_18 {
    use super::*;

    #[test]
    fn one_number_of_two_polynomials_is_equal() {
        let (x, y) = (roots(&square_minus(2)), roots(&(square_minus(2) * &square_minus(3))));
        assert_eq!(x[0], y[1]);
        assert_eq!(x[1], y[2]);
        assert!(x[1] < y[3] && y[0] < x[0] && x[0] < x[1]);
        assert_eq!(x[1].refined(300), y[2]);
        assert!(Algebraic::from(q(665_857, 470_832)) > x[1]);
        assert!(Algebraic::from(q(275_807, 195_025)) < x[1]);
    }

    #[test]
    fn two_roots_of_one_polynomial_with_a_third_between_them_are_different() {
        let isolated = roots(&polynomial(&[0, -2, 0, 1]));
        assert_eq!(isolated.len(), 3);
        for (i, x) in isolated.iter().enumerate() {
            for (j, y) in isolated.iter().enumerate() {
                assert_eq!(x.cmp(y), i.cmp(&j));
            }
        }
    }

    #[test]
    fn a_third_root_near_a_square_root_is_told_apart() {
        // 2^(1/3) = 1.259921…, and √(1587401/1000000) = 1.2599210…: they agree to 7 digits.
        let cube = roots(&polynomial(&[-2, 0, 0, 1])).pop().expect("one root");
        let square = roots(&polynomial(&[-1_587_401, 0, 1_000_000])).pop().expect("two roots");
        // 1.587401³ = 3.99999…
        assert!(square < cube);
        assert_ne!(square, cube);
    }

    proptest! {
        #[test]
        fn the_order_is_that_of_the_surds(
            a in small_rational(), b in small_rational(), c in small_rational(),
            d in small_rational(), e in small_rational(), multiple in planted_polynomial(),
        ) {
            use isoracle::number::QuadraticRoots::Two;
            let second = [(d, e), (b.clone(), c.clone())];
            for (d, e) in second {
                let (p, r) = (Polynomial::new(vec![c.clone(), b.clone(), a.clone()]), Polynomial::new(vec![e.clone(), d.clone(), a.clone()]));
                let (Two(x, y), Two(z, w)) = (quadratic_roots(&a, &b, &c), quadratic_roots(&a, &d, &e)) else { continue };
                let of_p = roots(&p);
                // The same roots as of r, isolated by another polynomial.
                let of_r: Vec<Algebraic> = roots(&(r.clone() * &multiple.polynomial))
                    .into_iter()
                    .filter(|root| root.sign_of(&r) == Sign::Zero)
                    .collect();
                prop_assert_eq!(of_r.len(), 2);
                for (s, x) in [x, y].iter().zip(&of_p) {
                    for (t, z) in [&z, &w].into_iter().zip(&of_r) {
                        prop_assert_eq!(x.cmp(z), s.cmp(t));
                        prop_assert_eq!(z.cmp(x), t.cmp(s));
                        prop_assert_eq!(x == z, s == t);
                    }
                }
            }
        }
    }
}

//! Infinitesimals.

mod nu_9 {
    use crate::strategy::{rational, sign, small_rational};
    use isoracle::number::{Enclosure, F64Interval, Integer, Perturbed, Polynomial, Rational, Ring, Sign};
    use proptest::prelude::*;

    /// The polynomial in ε at one ε that is small enough: half the inverse of the bound on the inverses of its roots.
    fn sign_at_a_small_epsilon(p: &Polynomial) -> Sign {
        let lowest_first = p.coefficients().iter().skip_while(|a| a.is_zero()).cloned();
        // ε is a root iff 1/ε is one of the reversed polynomial.
        let reversed = Polynomial::new(lowest_first.collect::<Vec<_>>().into_iter().rev().collect());
        let epsilon = (reversed.root_bound() * Rational::from(2)).recip();
        Sign::of(p.evaluate(&epsilon).cmp0())
    }

    #[test]
    fn the_lowest_coefficient_that_is_not_zero_decides() {
        let number = |a, b| Perturbed::new(Integer::from(a), Integer::from(b));
        assert_eq!(number(0, 0).known_sign(), Some(Sign::Zero));
        assert_eq!(number(0, -5).known_sign(), Some(Sign::Negative));
        assert_eq!(number(1, -1_000_000).known_sign(), Some(Sign::Positive));
        assert_eq!((number(0, 1) * &number(0, -1)).known_sign(), Some(Sign::Negative));
        assert_eq!((number(2, 1) - &number(2, 1)).known_sign(), Some(Sign::Zero));
        assert_eq!((number(2, 1) * &number(2, -1)).limit(), Integer::from(4));
    }

    #[test]
    fn an_undecided_coefficient_leaves_the_sign_undecided() {
        let undecided = F64Interval::between(-1.0, 1.0).expect("finite");
        assert_eq!(Perturbed::new(undecided, F64Interval::integer(1)).known_sign(), None);
        assert_eq!(Perturbed::new(F64Interval::integer(0), F64Interval::integer(1)).known_sign(), Some(Sign::Positive));
    }

    proptest! {
        #[test]
        fn it_is_the_sign_for_a_small_epsilon(a in small_rational(), b in rational(), c in small_rational(), d in rational(), e in sign()) {
            // The same formula in the infinitesimal and in polynomials.
            let scale = i64::from(e.value());
            let formula = |x: Perturbed<Rational>, y: Perturbed<Rational>| {
                x.clone() * &y - &(y * &Perturbed::integer(scale)) + &(x.clone() * &x)
            };
            let as_polynomial = |x: Polynomial, y: Polynomial| {
                x.clone() * &y - &(y * &Polynomial::integer(scale)) + &(x.clone() * &x)
            };
            let p = as_polynomial(Polynomial::new(vec![a.clone(), b.clone()]), Polynomial::new(vec![c.clone(), d.clone()]));
            let sign = formula(Perturbed::new(a, b), Perturbed::new(c, d)).known_sign();
            prop_assert_eq!(sign, Some(sign_at_a_small_epsilon(&p)));
        }
    }
}

//! Signals on ℤ: the mask, its inverses, and what is unique.

use super::{at, few, number, q, root3};
use isoracle::number::{Integer, OrderedField, Rational, Ring, Sign, Surd};
use isoracle::spline::bspline::{b3, basis};
use isoracle::spline::impulse::{self, Samples, pole};
use isoracle::spline::infinite::{
    absolute_sum, causal_inverse, convolution, filter_of, growing_inverse, kernel, mask, power_of_pole, solution,
    value, z_transform,
};
use isoracle::spline::printed;
use isoracle::spline::space::combination;
use proptest::prelude::*;
use std::collections::BTreeMap;

fn z(k: i64) -> Surd {
    power_of_pole(&Integer::from(k)).expect("near")
}

fn h(k: &Integer) -> Surd {
    impulse::inverse_filter(Integer::from(k.abs_ref()).to_u32().expect("near"))
}

/// δ[k].
fn delta(k: &Integer) -> Surd {
    Surd::integer(i64::from(k.is_zero()))
}

/// (c[k−1] + 4c[k] + c[k+1])/6.
fn masked(c: impl Fn(i64) -> Surd, k: i64) -> Surd {
    (c(k - 1) + &c(k + 1) + &(c(k) * &Surd::integer(4))) * &Surd::from(q(1, 6))
}

mod sp_28 {
    use super::*;

    #[test]
    fn a_b_spline_is_left_out() {
        let c = |k: &Integer| q(i64::from(*k == 1), 1);
        let zero = Integer::new();
        assert_eq!(printed::value_at(&c, &zero), -1);
        assert_eq!(printed::corrected_value_at(&c, &zero), q(1, 6));
        assert_eq!(combination(&[(Integer::from(1), q(1, 1))].into(), 3).evaluate(&q(0, 1)), q(1, 6));
    }

    proptest! {
        #[test]
        fn with_it_the_line_is_the_spline(c in few(), k in -7..7_i64) {
            let f = combination(&c, 3).evaluate(&q(k, 1));
            let on = |k: &Integer| at(&c, k);
            let k = Integer::from(k);
            let printed = printed::value_at(&on, &k);
            // The two differ by 7/6 of the coefficient on the right.
            prop_assert_eq!(&f - printed, on(&Integer::from(&k + 1)) * q(7, 6));
            prop_assert_eq!(printed::corrected_value_at(&on, &k), f);
        }
    }
}

mod sp_29 {
    use super::*;

    #[test]
    fn values_of_b3_at_the_integers() {
        assert_eq!([-1, 0, 1].map(|k| b3(&q(k, 1))), [q(1, 6), q(4, 6), q(1, 6)]);
        for (k, b) in mask() {
            assert_eq!(basis(3).evaluate(&Rational::from(k)), b);
        }
        assert_eq!(mask().len(), 3);
    }

    proptest! {
        #[test]
        fn the_spline_at_an_integer(c in few(), k in -7..7_i64) {
            let c = |k: i64| at(&c, &Integer::from(k));
            let f = combination(&(-9..9).map(|k| (Integer::from(k), c(k))).collect(), 3);
            let by_hand = c(k - 1) * q(1, 6) + c(k) * q(4, 6) + c(k + 1) * q(1, 6);
            prop_assert_eq!(f.evaluate(&q(k, 1)), by_hand);
        }
    }
}

mod sp_30 {
    use super::*;

    proptest! {
        #[test]
        fn the_convolution_with_the_mask_is_the_spline_at_the_integers(c in few(), k in -8..8_i64) {
            let f = combination(&c, 3).evaluate(&q(k, 1));
            let on = |k: &Integer| Surd::from(at(&c, k));
            prop_assert_eq!(convolution(&mask(), on, &Integer::from(k)), Surd::from(f));
        }

        #[test]
        fn the_discrete_convolution_multiplies_polynomials(a in few(), b in few(), k in -12..12_i64) {
            // Σ a[i]xⁱ · Σ b[j]xʲ: coefficients by the two-fold sum.
            let by_pairs = a.iter().flat_map(|(i, a)| b.iter().map(move |(j, b)| (Integer::from(i + j), Rational::from(a * b))))
                .filter(|(s, _)| *s == k).fold(Rational::new(), |sum, (_, product)| sum + product);
            prop_assert_eq!(convolution(&a, |j| Surd::from(at(&b, j)), &Integer::from(k)), Surd::from(by_pairs));
        }
    }

    #[test]
    fn the_middle_of_the_mask_stands_at_0() {
        // Read as starting at 0, the mask would move the signal by one.
        let c = |k: &Integer| Surd::from(q(i64::from(*k == 0), 1));
        let from_0: Samples = mask().into_iter().map(|(k, b)| (k + 1, b)).collect();
        assert_eq!(convolution(&from_0, c, &Integer::from(0)), Surd::from(q(1, 6)));
        assert_eq!(convolution(&mask(), c, &Integer::from(0)), Surd::from(q(4, 6)));
        assert_eq!(b3(&q(0, 1)), q(4, 6));
    }
}

mod sp_31 {
    use super::*;

    #[test]
    fn a_spline_that_is_0_at_every_integer_and_not_elsewhere() {
        let c = |k: &Integer| kernel(&Surd::integer(1), &Surd::integer(0), k).expect("near");
        for k in -20..=20 {
            assert_eq!(value(c, &q(k, 1)), Surd::integer(0));
        }
        // f(1/2) = (1/z + 23 + 23z + z²)/48 = (z² + 1/z + 23(1 + z))/48.
        let at_half = value(c, &q(1, 2));
        assert_eq!(
            at_half,
            (z(2) + &z(-1) + &(Surd::integer(23) * &(Surd::integer(1) + &z(1)))) * &Surd::from(q(1, 48))
        );
        assert_eq!(at_half, root3(-18, 18) * &Surd::from(q(1, 48)));
        assert_eq!(at_half.sign(), Sign::Positive);
    }

    proptest! {
        #[test]
        fn two_dimensions_of_them(a in number(), b in number(), k in -12..12_i64) {
            let c = |k: i64| kernel(&Surd::from(a.clone()), &Surd::from(b.clone()), &Integer::from(k)).expect("near");
            prop_assert_eq!(masked(c, k), Surd::integer(0));
            // Any two neighbours fix a and b: z^−1 − z = −2√3 ≠ 0.
            let zero = c(0) == Surd::integer(0) && c(1) == Surd::integer(0);
            prop_assert_eq!(zero, a == 0 && b == 0);
        }

        /// What is bounded on both sides has a = b = 0.
        #[test]
        fn the_others_are_not_bounded(a in -9..=9_i64, b in -9..=9_i64) {
            prop_assume!(a != 0 || b != 0);
            let c = |k: i64| kernel(&Surd::integer(a), &Surd::integer(b), &Integer::from(k)).expect("near");
            let large = |x: Surd| x > Surd::integer(1_000_000) || -x > Surd::integer(1_000_000);
            prop_assert!(large(c(14)) || large(c(-14)));
        }
    }
}

mod sp_32 {
    use super::*;

    proptest! {
        #[test]
        fn any_two_neighbours_go_on(g in few(), c0 in number(), c1 in number(), k in -9..9_i64) {
            let g = |k: &Integer| at(&g, k);
            let c = |k: i64| solution(g, [&c0, &c1], &Integer::from(k));
            prop_assert_eq!((c(0), c(1)), (c0.clone(), c1.clone()));
            prop_assert_eq!((c(k - 1) + c(k) * 4 + c(k + 1)) / 6, g(&Integer::from(k)));
        }

        #[test]
        fn two_solutions_differ_by_one_of_the_kernel(g in few(), d0 in number(), d1 in number(), k in -9..9_i64) {
            let g = |k: &Integer| at(&g, k);
            let c = |c: [&Rational; 2], k: i64| solution(g, c, &Integer::from(k));
            let zero = Rational::new();
            let difference = c([&d0, &d1], k) - c([&zero, &zero], k);
            // a + b = d0, az + b/z = d1.
            let (d0, d1) = (Surd::from(d0.clone()), Surd::from(d1.clone()));
            let scale = (z(1) - &z(-1)).inverse().expect("2√3");
            let a = (d1 - &(d0.clone() * &z(-1))) * &scale;
            let b = d0 - &a;
            prop_assert_eq!(Surd::from(difference), kernel(&a, &b, &Integer::from(k)).expect("near"));
        }
    }
}

mod sp_33 {
    use super::*;

    #[test]
    fn convolutions_that_all_exist_and_are_not_associative() {
        let c = |k: &Integer| power_of_pole(k).expect("near");
        // h ⋆ mask = δ and mask ⋆ c = 0, each by finite sums.
        for k in -15..=15 {
            assert_eq!(convolution(&mask(), h, &Integer::from(k)), delta(&Integer::from(k)));
            assert_eq!(convolution(&mask(), c, &Integer::from(k)), Surd::integer(0));
        }
        // (h ⋆ mask) ⋆ c = δ ⋆ c = c; h ⋆ (mask ⋆ c) = h ⋆ 0 = 0.
        let left = convolution(&[(Integer::new(), q(1, 1))].into(), c, &Integer::new());
        let right = (-15..=15).fold(Surd::integer(0), |sum, i| {
            sum + &(h(&Integer::from(i)) * &convolution(&mask(), c, &Integer::from(-i)))
        });
        assert_eq!((left, right), (Surd::integer(1), Surd::integer(0)));
    }

    proptest! {
        /// Where two of the three are finite all is well.
        #[test]
        fn with_two_finite_ones_it_is(a in few(), b in few(), k in -6..6_i64) {
            let c = |k: &Integer| power_of_pole(k).expect("near");
            let ab: Samples = (-10..=10).map(|k| {
                let k = Integer::from(k);
                let product = convolution(&a, |j| Surd::from(at(&b, j)), &k);
                (k, product.rational().expect("of rationals").clone())
            }).collect();
            let k = Integer::from(k);
            prop_assert_eq!(convolution(&ab, c, &k), convolution(&a, |j| convolution(&b, c, j), &k));
        }
    }
}

mod sp_34 {
    use super::*;

    proptest! {
        #[test]
        fn the_bounded_solution_of_a_finite_signal(g in few(), k in -9..9_i64) {
            let c = |k: i64| impulse::coefficient(&g, &Integer::from(k)).expect("near");
            prop_assert_eq!(masked(c, k), Surd::from(at(&g, &Integer::from(k))));
            // Beyond the samples it falls by z a step.
            prop_assert_eq!(c(7) * &z(1), c(8));
            prop_assert_eq!(c(-7) * &z(1), c(-8));
        }
    }

    #[test]
    fn a_signal_that_grows_as_the_filter_falls_has_no_such_sum() {
        // g[k] = z^−|k|: the terms of (h ⋆ g)[0] are all √3, though a solution exists.
        for i in -9..=9_i64 {
            let term = h(&Integer::from(i)) * &z(-i.abs());
            assert_eq!(term, root3(0, 1));
        }
    }

    #[test]
    fn a_constant_and_an_alternating_signal() {
        // Σ h = 1 and Σ (−1)ᵏ h = 3, up to what is left out: √3·2z^(n+1)/(1 − z) and its like.
        for n in 1..12_i64 {
            let partial = (-n..=n).fold(Surd::integer(0), |sum, k| sum + &h(&Integer::from(k)));
            let rest = root3(0, 2) * &z(n + 1) * &(Surd::integer(1) - &z(1)).inverse().expect("z is not 1");
            assert_eq!(partial + &rest, Surd::integer(1));
        }
        // The coefficients of g = 1 are 1, those of g = (−1)ᵏ are 3(−1)ᵏ.
        assert_eq!(masked(|_| Surd::integer(1), 4), Surd::integer(1));
        assert_eq!(masked(|k| Surd::integer(if k % 2 == 0 { 3 } else { -3 }), 4), Surd::integer(1));
    }
}

mod sp_35 {
    use super::*;

    #[test]
    fn there_are_other_inverses() {
        let causal = |k: i64| Surd::from(Rational::from(causal_inverse(&Integer::from(k)).expect("near")));
        let growing = |k: i64| growing_inverse(&Integer::from(k)).expect("near");
        for k in -12..=12 {
            assert_eq!(masked(causal, k), delta(&Integer::from(k)), "{k}");
            assert_eq!(masked(growing, k), delta(&Integer::from(k)), "{k}");
        }
        assert_eq!(
            [0, 1, 2, 3].map(|k| causal_inverse(&Integer::from(k))),
            [0, 6, -24, 90].map(|n| Some(Integer::from(n)))
        );
        assert_ne!(causal(1), h(&Integer::from(1)));
        assert_eq!(growing(0), root3(0, -1));
        // From c[0] = 0, c[1] = 6 by the recursion too, c[2] = 6·0 − 4·6 − 0.
        for k in -5..=9 {
            let by_recursion = solution(|k| q(i64::from(k.is_zero()), 1), [&q(0, 1), &q(6, 1)], &Integer::from(k));
            assert_eq!(causal(k), Surd::from(by_recursion));
        }
    }

    proptest! {
        #[test]
        fn all_inverses_differ_by_the_kernel(a in number(), b in number(), k in -9..9_i64) {
            let (a, b) = (Surd::from(a), Surd::from(b));
            let other = |k: i64| h(&Integer::from(k)) + &kernel(&a, &b, &Integer::from(k)).expect("near");
            prop_assert_eq!(masked(other, k), delta(&Integer::from(k)));
        }
    }
}

mod sp_36 {
    use super::*;

    #[test]
    fn the_factor_is_the_root_of_3() {
        assert_eq!(filter_of(&pole()), Some(root3(0, 1)));
        assert_eq!(filter_of(&pole().conjugate()), Some(root3(0, -1)));
        assert_eq!((filter_of(&Surd::integer(1)), filter_of(&Surd::integer(-1))), (None, None));
        for k in 0..20 {
            assert_eq!(h(&Integer::from(-k)), filter_of(&pole()).expect("z² is not 1") * &z(k));
        }
    }

    #[test]
    fn definition_and_relation_give_the_inverse() {
        // For k ≥ 1 the sum is √3 z^(k−1)(1 + 4z + z²)/6 = 0; at 0 it is √3(4 + 2z)/6 = 1.
        assert_eq!(Surd::integer(1) + &(z(1) * &Surd::integer(4)) + &z(2), Surd::integer(0));
        assert_eq!(root3(0, 1) * &(Surd::integer(4) + &(z(1) * &Surd::integer(2))), Surd::integer(6));
        for k in -15..=15 {
            assert_eq!(masked(|k| h(&Integer::from(k)), k), delta(&Integer::from(k)));
        }
    }
}

mod sp_37 {
    use super::*;

    #[test]
    fn the_relation_has_two_roots_of_product_1() {
        let w = pole().conjugate();
        for root in [pole(), w.clone()] {
            assert_eq!(root.clone() * &root + &Surd::integer(1), root * &Surd::integer(-4));
        }
        assert_eq!(pole() * &w, Surd::integer(1));
        assert!(-pole() < Surd::integer(1) && -w > Surd::integer(1));
    }

    #[test]
    fn powers_by_multiplication() {
        let (mut up, mut down) = (Surd::integer(1), Surd::integer(1));
        for k in 0..25 {
            assert_eq!((z(k), z(-k)), (up.clone(), down.clone()));
            up = up * &root3(-2, 1);
            down = down * &root3(-2, -1);
        }
        assert_eq!(power_of_pole(&(Integer::from(1) << 31)), None);
    }
}

mod sp_38 {
    use super::*;

    #[test]
    fn the_transforms_of_mask_and_inverse_are_reciprocal() {
        for (n, d) in [(1, 1), (-1, 1), (1, 2), (-1, 2), (3, 1), (-3, 1), (2, 7), (7, 2)] {
            let zeta = q(n, d);
            let inverse = Rational::from(zeta.recip_ref());
            let of_mask = Rational::from(&zeta + &inverse) / 6 + q(4, 6);
            assert_eq!(z_transform(&zeta).expect("in the annulus") * &Surd::from(of_mask), Surd::integer(1));
        }
        // Σ h = 1, Σ (−1)ᵏ h = 3.
        assert_eq!(z_transform(&q(1, 1)), Some(Surd::integer(1)));
        assert_eq!(z_transform(&q(-1, 1)), Some(Surd::integer(3)));
        for outside in [q(0, 1), q(1, 4), q(-1, 4), q(4, 1), q(-4, 1)] {
            assert_eq!(z_transform(&outside), None);
        }
    }

    #[test]
    fn the_sum_closes_in_on_it() {
        // |rest| < 2·√3·Σ r^k 2^k beyond n for ζ = 2, r = 2 − √3 < 0.268, so below 10·(0.536)ⁿ.
        let zeta = 2_i64;
        let partial = (-30..=30_i64).fold(Surd::integer(0), |sum, k| {
            let power = if k >= 0 { q(1, zeta.pow(k as u32)) } else { q(zeta.pow(-k as u32), 1) };
            sum + &(h(&Integer::from(k)) * &Surd::from(power))
        });
        let rest = partial - &z_transform(&q(2, 1)).expect("in the annulus");
        let bound = Surd::from(q(1, 1_000_000));
        assert!(rest < bound && -rest < bound);
    }
}

mod sp_39 {
    use super::*;

    #[test]
    fn what_a_graph_of_the_filter_shows() {
        assert_eq!(
            [0, 1, 2, 3].map(|k| h(&Integer::from(k))),
            [root3(0, 1), root3(3, -2), root3(-12, 7), root3(45, -26)]
        );
        for k in 1..20_i64 {
            let (now, next) = (h(&Integer::from(k)), h(&Integer::from(k + 1)));
            assert_eq!(now.sign(), if k % 2 == 0 { Sign::Positive } else { Sign::Negative });
            assert_eq!(h(&Integer::from(-k)), now);
            // Between a quarter and two sevenths remains.
            let [now, next] = [now, next].map(|x| if x.sign() == Sign::Negative { -x } else { x });
            assert!(next > now.clone() * &Surd::from(q(1, 4)) && next < now * &Surd::from(q(2, 7)));
        }
    }
}

mod sp_78 {
    use super::*;

    #[test]
    fn the_absolute_sum_rises_to_3() {
        let mut sum = root3(0, 1);
        for n in 0..20_u32 {
            assert_eq!(absolute_sum(n), sum);
            // 3 less the rest 2√3·r^(n+1)/(1 − r).
            let size = |k: i64| if k % 2 == 0 { z(k) } else { -z(k) };
            let rest =
                root3(0, 2) * &size(i64::from(n) + 1) * &(Surd::integer(1) - &size(1)).inverse().expect("r is not 1");
            assert_eq!(sum.clone() + &rest, Surd::integer(3));
            let next = h(&Integer::from(n + 1)) * &Surd::integer(2);
            sum = sum + &(if next.sign() == Sign::Negative { -next } else { next });
        }
    }

    proptest! {
        #[test]
        fn coefficients_are_at_most_three_times_the_samples(g in prop::collection::vec(-9..=9_i64, 9), k in -3..12_i64) {
            let samples: BTreeMap<_, _> = g.iter().enumerate().map(|(k, g)| (Integer::from(k), q(*g, 1))).collect();
            let c = impulse::coefficient(&samples, &Integer::from(k)).expect("near");
            let bound = Surd::integer(3 * g.iter().map(|g| g.abs()).max().expect("nine of them"));
            prop_assert!(c <= bound && -c <= bound);
        }
    }
}

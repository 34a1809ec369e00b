//! Errors and their buckets, by a second derivation.

use isoracle::curvature::principal::Principal;
use isoracle::judge::accuracy::ALL_DIGITS_WRONG;
use isoracle::judge::numbers::deviation::{Unit, is_at_most, magnitude};
use isoracle::judge::numbers::real::{Real, largest};
use isoracle::number::binary::{from_f64, nearest_f64, ulp_error};
use isoracle::number::{Integer, Rational, Sign, Surd};
use proptest::prelude::*;

fn q(n: i64, d: i64) -> Rational {
    Rational::from((n, d))
}

fn two_to(n: i32) -> Rational {
    let power = Integer::from(1) << n.unsigned_abs();
    if n < 0 { Rational::from((Integer::from(1), power)) } else { Rational::from(power) }
}

/// The bucket of a known error: the first bound of ½, 1, 2, …, 2⁵² that it does not exceed.
fn bucket(error: &Rational) -> usize {
    (0..ALL_DIGITS_WRONG).find(|i| *error <= two_to(i32::try_from(*i).expect("few") - 1)).unwrap_or(ALL_DIGITS_WRONG)
}

fn surd(a: Rational, b: Rational, d: i64) -> Real {
    Real::Surd(Surd::new(a, b, &Rational::from(d)).expect("d ≥ 0"))
}

/// k₁, k₂ = √2 ± √3: H² = 2, K = 2 − 3.
fn degree_four() -> [Real; 2] {
    Real::principal(Principal::new(Sign::Positive, &q(2, 1), &q(-1, 1)))
}

proptest! {
    #[test]
    fn a_rational_truth_is_measured_as_by_ulp_error(n in any::<i64>(), d in 1_i64.., steps in -5_i64..5, scale in -60_i32..60) {
        let y = q(n, d) * two_to(scale);
        let near = nearest_f64(&y);
        let x = f64::from_bits(near.to_bits().saturating_add_signed(steps));
        prop_assume!(x.is_finite());
        let (exact, error) = (from_f64(x).expect("finite"), ulp_error(x, &y).expect("finite"));
        let found = magnitude(&exact, &Real::from(y.clone()), Unit::LastPlace);
        prop_assert_eq!(found.bucket, bucket(&error));
        prop_assert!((found.units - error.to_f64()).abs() <= error.to_f64() * 1e-12);
        if steps == 0 {
            prop_assert_eq!(found.bucket, 0);
        }
    }

    #[test]
    fn normwise_errors_are_relative_to_the_largest(x in -1000_i64..1000, y in -1000_i64..1000, m in -1000_i64..1000, d in 1_i64..50) {
        prop_assume!(m.abs() >= y.abs() && m != 0);
        let (x, y, m) = (q(x, d), q(y, d), q(m, d));
        let error = (x.clone() - &y).abs() / m.clone().abs() * two_to(52);
        let truth = Real::from(y);
        let scale = Real::from(m);
        let unit = Unit::Relative { largest: &scale, is_own: false };
        prop_assert_eq!(magnitude(&x, &truth, unit).bucket, bucket(&error));
        prop_assert!(is_at_most(&x, &truth, unit, &error));
        prop_assert!(error == 0 || !is_at_most(&x, &truth, unit, &(error * q(999_999, 1_000_000))));
    }

    /// a + b√2 against enclosures 200 bits wide; x is planted within a few steps of it.
    #[test]
    fn an_irrational_truth_is_measured_as_its_enclosure_is(a in -99_i64..99, b in 1_i64..99, d in 1_i64..20, steps in -40_i64..40) {
        let truth = surd(q(a, d), q(b, d), 2);
        let y = truth.near();
        let x = f64::from_bits(nearest_f64(&y).to_bits().saturating_add_signed(steps));
        let exact = from_f64(x).expect("finite");
        let by_enclosure = ulp_error(x, &y).expect("finite");
        prop_assert_eq!(magnitude(&exact, &truth, Unit::LastPlace).bucket, bucket(&by_enclosure));
        let unit = Unit::Relative { largest: &truth, is_own: true };
        let relative = (exact.clone() - &y).abs() / y.clone().abs() * two_to(52);
        prop_assert_eq!(magnitude(&exact, &truth, unit).bucket, bucket(&relative));
    }
}

#[test]
fn errors_on_the_bounds_belong_below_them() {
    // Steps of 2⁻⁵² above 1, where the unit is 2⁻⁵².
    let one = Real::from(q(1, 1));
    for i in 0..53 {
        let bound = two_to(i - 1);
        for unit in [Unit::LastPlace, Unit::Relative { largest: &one, is_own: true }] {
            let at = |more: &Rational| magnitude(&(q(1, 1) + (bound.clone() + more) * two_to(-52)), &one, unit).bucket;
            let i = usize::try_from(i).expect("from 0 on");
            assert_eq!([at(&Rational::new()), at(&two_to(-90))], [i, i + 1]);
        }
    }
}

#[test]
fn a_multiple_of_an_irrational_number_is_compared_exactly() {
    // x = 0 is off by exactly 2⁵² units of 2⁻⁵²·|y|, which no enclosure could tell from a little more.
    let [k1, k2] = degree_four();
    let root = surd(q(0, 1), q(1, 1), 2);
    for y in [&k1, &k2, &root, &Real::normalized(q(1, 1), q(-3, 1))] {
        let unit = Unit::Relative { largest: y, is_own: true };
        assert_eq!(magnitude(&Rational::new(), y, unit).bucket, 53);
        assert_eq!(magnitude(&q(-1, 1_000_000), &k1, Unit::Relative { largest: &k1, is_own: true }).bucket, 54);
    }
    // |2 − (1 + √2)| = |1 − √2|.
    let [y, m] = [surd(q(1, 1), q(1, 1), 2), surd(q(1, 1), q(-1, 1), 2)];
    let unit = Unit::Relative { largest: &m, is_own: false };
    assert!(is_at_most(&q(2, 1), &y, unit, &two_to(52)));
    assert!(!is_at_most(&q(2, 1), &y, unit, &(two_to(52) - two_to(-200))));
}

#[test]
fn numbers_of_degree_four_are_enclosed_until_they_are_decided() {
    let [k1, k2] = degree_four();
    assert!(k1.rational().is_none());
    let [near1, near2] = [2_f64.sqrt() + 3_f64.sqrt(), 2_f64.sqrt() - 3_f64.sqrt()];
    for (k, near) in [(&k1, near1), (&k2, near2)] {
        let exact = from_f64(near).expect("finite");
        let unit = Unit::Relative { largest: &k1, is_own: k == &k1 };
        assert!(magnitude(&exact, k, unit).bucket <= 2 && magnitude(&exact, k, Unit::LastPlace).bucket <= 4);
        let wrong = magnitude(&(exact + two_to(-30)), k, unit);
        // 2⁻³⁰ of 3.146…, in units of 2⁻⁵².
        assert_eq!(wrong.bucket, bucket(&(two_to(22) / q(3146, 1000))));
    }
    assert_eq!(largest(&degree_four()), 0);
    assert_eq!(largest(&Real::principal(Principal::new(Sign::Negative, &q(2, 1), &q(-1, 1)))), 1);
}

#[test]
fn the_largest_is_that_by_absolute_value_and_the_first_of_equals() {
    let numbers = |list: &[i64]| list.iter().map(|n| Real::from(Rational::from(*n))).collect::<Vec<_>>();
    assert_eq!(largest(&numbers(&[1, -7, 7, 3])), 1);
    assert_eq!(largest(&numbers(&[0, 0])), 0);
    assert_eq!(largest(&[surd(q(-3, 1), q(0, 1), 2), surd(q(0, 1), q(-5, 2), 2)]), 1);
    assert_eq!(largest(&[]), 0);
}

#[test]
fn units_end_at_the_least_binary64() {
    let zero = Real::from(Rational::new());
    let unit = Unit::Relative { largest: &zero, is_own: true };
    assert_eq!(magnitude(&Rational::new(), &zero, unit).bucket, 0);
    assert_eq!(magnitude(&two_to(-1074), &zero, unit).bucket, 1);
    assert_eq!(magnitude(&two_to(-1000), &zero, unit).bucket, ALL_DIGITS_WRONG);
    // e^(−2000)/2 is nearest to 0 among the binary64.
    let tiny = Real::normalized(q(1, 1), q(-2000, 1));
    assert_eq!(magnitude(&Rational::new(), &tiny, Unit::LastPlace).bucket, 0);
    assert_eq!(magnitude(&Rational::new(), &tiny, Unit::Relative { largest: &tiny, is_own: true }).bucket, 0);
    assert_eq!(magnitude(&two_to(-1074), &tiny, Unit::LastPlace).bucket, 1);
}

#[test]
fn half_at_0_is_exact() {
    assert_eq!(Real::normalized(q(3, 1), Rational::new()), Real::from(q(1, 2)));
}

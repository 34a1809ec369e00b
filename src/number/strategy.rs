//! Proptest strategies for numbers, biased to coincidences: equal, nearly equal, zero, at the ends of a format.

use crate::number::binary::from_f64;
use crate::number::{F64Interval, Integer, Interval, Polynomial, Rational, Ring, Sign, Surd};
use proptest::prelude::*;

/// Each sign as often.
pub fn sign() -> impl Strategy<Value = Sign> {
    prop_oneof![Just(Sign::Negative), Just(Sign::Zero), Just(Sign::Positive)]
}

/// Rationals: small integers, small fractions, dyadic numbers, the exact values of all kinds of binary64, and numbers that
/// differ from a small one by a tiny amount.
pub fn rational() -> impl Strategy<Value = Rational> {
    let near = (small_rational(), -1..=1_i32, 1..200_u32)
        .prop_map(|(x, hair, bits)| x + Rational::from((Integer::from(hair), Integer::from(1) << bits)));
    let of_f64 = finite_f64().prop_map(|x| from_f64(x).expect("the strategy gives finite ones"));
    let any_fraction = (any::<i64>(), 1..i64::MAX).prop_map(Rational::from);
    prop_oneof![4 => small_rational(), 2 => near, 1 => of_f64, 1 => any_fraction]
}

/// Rationals of few bits, in which coincidences are common: −3 … 3, p/q with |p|, q ≤ 9, and p/2ᵏ.
pub fn small_rational() -> impl Strategy<Value = Rational> {
    let dyadic = (-64..=64_i32, 0..8_u32).prop_map(|(p, k)| Rational::from((p, 1_i32 << k)));
    prop_oneof![(-3..=3_i32).prop_map(Rational::from), (-9..=9_i32, 1..=9_i32).prop_map(Rational::from), dyadic,]
}

/// Finite binary64: of any bits, small integers, and those at and around the ends of the format.
pub fn finite_f64() -> impl Strategy<Value = f64> {
    let ends = prop::sample::select(vec![0.0, -0.0, 5e-324, f64::MIN_POSITIVE, 1.0, 9_007_199_254_740_992.0, f64::MAX]);
    let at_ends = (ends, any::<bool>(), -1..=1_i32).prop_map(|(x, negative, step)| {
        let x = if negative { -x } else { x };
        match step {
            -1 => x.next_down(),
            1 => x.next_up(),
            _ => x,
        }
    });
    let finite = |x: &f64| x.is_finite();
    prop_oneof![
        any::<u64>().prop_map(f64::from_bits).prop_filter("finite", finite),
        (-16..=16_i32).prop_map(f64::from),
        at_ends.prop_filter("finite", finite),
    ]
}

/// Elements of ℚ(√d), a third of them rational.
pub fn surd_over(d: u32) -> impl Strategy<Value = Surd> {
    (rational(), prop_oneof![1 => Just(Rational::new()), 2 => rational()])
        .prop_map(move |(a, b)| Surd::new(a, b, &Rational::from(d)).expect("the radicand is not negative"))
}

/// Elements of different ℚ(√d) with small d, squares and multiples of squares among them.
pub fn surd() -> impl Strategy<Value = Surd> {
    (0..=50_u32).prop_flat_map(surd_over)
}

/// A surd and a rational next to it: the surd rounded to some bits.
pub fn surd_and_near_rational() -> impl Strategy<Value = (Surd, Rational)> {
    (surd(), 2..120_u32).prop_map(|(x, bits)| {
        let (near, _) = x.enclosure(bits).bounds().expect("the bounds are finite");
        (x, near)
    })
}

/// A number, and an interval around it, of 2 to 200 bits and of any width, 0 too.
pub fn interval() -> impl Strategy<Value = (Rational, Interval)> {
    (rational(), margin(), margin(), 2..200_u32).prop_map(|(x, below, above, precision)| {
        let (lo, hi) = (Rational::from(&x - &below), Rational::from(&x + &above));
        let interval = Interval::between(&lo, &hi, precision).expect("the margins are not negative");
        (x, interval)
    })
}

/// A number, and an interval of binary64 around it.
pub fn f64_interval() -> impl Strategy<Value = (Rational, F64Interval)> {
    let point = finite_f64().prop_map(|x| (from_f64(x).expect("finite"), F64Interval::exact(x).expect("finite")));
    let around = rational().prop_map(|x| {
        let interval = F64Interval::from_rational(&x);
        (x, interval)
    });
    prop_oneof![point, around]
}

fn margin() -> impl Strategy<Value = Rational> {
    prop_oneof![Just(Rational::new()), small_rational().prop_map(Rational::abs)]
}

/// A polynomial that is built from its real roots.
#[derive(Clone, Debug)]
pub struct Planted {
    /// c · Π (x − rootᵢ)^multiplicityᵢ · Π (x² + pⱼx + qⱼ), the last ones without real roots.
    pub polynomial: Polynomial,
    /// The different real roots, in increasing order, with their multiplicities.
    pub roots: Vec<(Rational, u32)>,
}

/// Polynomials with up to four different rational roots, equal and nearly equal ones among them, of multiplicity up to three, times up to
/// two factors without a real root.
pub fn planted_polynomial() -> impl Strategy<Value = Planted> {
    let root = (small_rational(), prop_oneof![Just(0_i32), Just(1)], 1..40_u32)
        .prop_map(|(x, hair, bits)| x + Rational::from((Integer::from(hair), Integer::from(1) << bits)));
    let roots = prop::collection::vec((root, 1..=3_u32), 0..=4);
    // (x + s)² + t² with t ≠ 0
    let rootless = prop::collection::vec((small_rational(), 1..=3_i32), 0..=2);
    let factor = small_rational().prop_filter("not zero", |c| !c.is_zero());
    (factor, roots, rootless).prop_map(|(c, mut roots, rootless)| {
        roots.sort();
        roots.dedup_by(|a, b| a.0 == b.0);
        let real = roots.iter().flat_map(|(x, n)| (0..*n).map(|_| Polynomial::with_root(x)));
        let pairs = rootless.iter().map(|(s, t)| {
            let shifted = Polynomial::with_root(s);
            shifted.clone() * &shifted + &Polynomial::integer(i64::from(t * t))
        });
        let polynomial = real.chain(pairs).fold(Polynomial::new(vec![c]), |p, factor| p * &factor);
        Planted { polynomial, roots }
    })
}

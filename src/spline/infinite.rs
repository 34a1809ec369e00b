//! Signals on ℤ without a bound: what solves the interpolation problem (12), and how far it is the only one.
//!
//! Coefficients c with (c\[k−1] + 4c\[k] + c\[k+1])/6 = g\[k] are given by any two neighbours. Those of g = 0 are a·z^k +
//! b·z^−k; among bounded ones only 0, so that "the" inverse of the mask and "the" spline through a signal are the bounded
//! ones.

use super::basis::{split, weights};
use super::impulse::{Samples, pole};
use super::inverse::convergent;
use crate::number::{Integer, OrderedField, Rational, Ring, Surd};

/// [1/6 4/6 1/6], its middle at 0: B₃ at the integers. SP-29, SP-30.
#[doc(alias = "SP-29")]
#[doc(alias = "SP-30")]
pub fn mask() -> Samples {
    [(-1, (1, 6)), (0, (4, 6)), (1, (1, 6))].map(|(k, b)| (Integer::from(k), Rational::from(b))).into()
}

/// (g ⋆ h)\[k] = Σ g\[i]h\[k − i] of a signal g that is 0 but at finitely many places, and any h. SP-30, SP-33.
#[doc(alias = "SP-33")]
pub fn convolution(g: &Samples, h: impl Fn(&Integer) -> Surd, k: &Integer) -> Surd {
    g.iter().fold(Surd::integer(0), |sum, (i, g)| sum + &(h(&Integer::from(k - i)) * &Surd::from(g.clone())))
}

/// zᵏ, z = −2 + √3, for any integer k: z^−1 = −2 − √3, the conjugate. SP-37.
///
/// zᵏ = (−1)ᵏ(P − Q√3) with P + Q√3 = (2 + √3)ᵏ. `None` where |k| > 2³⁰.
#[doc(alias = "SP-37")]
pub fn power_of_pole(k: &Integer) -> Option<Surd> {
    let n = Integer::from(k.abs_ref()).to_u32().filter(|n| *n <= 1 << 30)?;
    let (p, q) = convergent(2 * n);
    let sign = if n.is_multiple_of(2) { 1 } else { -1 };
    // (2 − √3)ⁿ is the conjugate of (2 + √3)ⁿ.
    let q = if k.cmp0().is_lt() { q } else { -q };
    Some(Surd::new(Rational::from(p * sign), Rational::from(q * sign), &Rational::from(3)).expect("3 is not negative"))
}

/// a·zᵏ + b·z^−k: all coefficients whose spline is 0 at every integer. SP-31.
///
/// `None` where |k| > 2³⁰.
#[doc(alias = "SP-31")]
pub fn kernel(a: &Surd, b: &Surd, k: &Integer) -> Option<Surd> {
    let [falling, growing] = [power_of_pole(k)?, power_of_pole(&Integer::from(-k))?];
    Some(falling * a + &(growing * b))
}

/// f(x) = Σ c\[k]B₃(x − k) of any coefficients on ℤ. SP-31.
pub fn value(c: impl Fn(&Integer) -> Surd, x: &Rational) -> Surd {
    let (i, t) = split(x);
    weights(&t, 0)
        .into_iter()
        .enumerate()
        .fold(Surd::integer(0), |sum, (m, weight)| sum + &(c(&(Integer::from(&i + m) - 1_u32)) * &Surd::from(weight)))
}

/// c\[k] of the coefficients that solve (12) and have the given c\[0] and c\[1], by c\[k+1] = 6g\[k] − 4c\[k] − c\[k−1] and the same
/// backward, |k| steps: for every signal g there are such. SP-32.
#[doc(alias = "SP-32")]
pub fn solution(g: impl Fn(&Integer) -> Rational, [c0, c1]: [&Rational; 2], k: &Integer) -> Rational {
    let (mut from, mut to) = (c0.clone(), c1.clone());
    let next = |g: Rational, from: &Rational, to: &Rational| g * 6 - Rational::from(to * 4) - from;
    let mut place = Integer::from(1);
    if k.cmp0().is_lt() {
        // The same recursion, run from c[1], c[0] to the left.
        (from, to, place) = (to, from, Integer::new());
        while place > *k {
            let c = next(g(&place), &from, &to);
            (from, to, place) = (to, c, place - 1);
        }
        return to;
    }
    if k.is_zero() {
        return from;
    }
    while place < *k {
        let c = next(g(&place), &from, &to);
        (from, to, place) = (to, c, place + 1);
    }
    to
}

/// 0 for k ≤ 0, else (−1)ᵏ⁻¹·6Q with P + Q√3 = (2 + √3)ᵏ: 6, −24, 90, …: an inverse of the mask that is 0 to the left and
/// grows without bound. SP-35.
///
/// `None` where k > 2³⁰.
#[doc(alias = "SP-35")]
pub fn causal_inverse(k: &Integer) -> Option<Integer> {
    if k.cmp0().is_le() {
        return Some(Integer::new());
    }
    let n = k.to_u32().filter(|n| *n <= 1 << 30)?;
    let (_, q) = convergent(2 * n);
    Some(q * if n % 2 == 1 { 6 } else { -6 })
}

/// −6w/(1 − w²)·w^|k| with the other root w = 1/z: an inverse too, and unbounded. SP-35.
///
/// `None` where |k| > 2³⁰.
pub fn growing_inverse(k: &Integer) -> Option<Surd> {
    Some(filter_of(&pole().conjugate())? * &power_of_pole(&-Integer::from(k.abs_ref()))?)
}

/// −6z/(1 − z²); `None` where z² = 1. SP-36.
#[doc(alias = "SP-36")]
pub fn filter_of(z: &Surd) -> Option<Surd> {
    let denominator = Surd::integer(1) - &(z.clone() * z);
    Some(z.clone() * &Surd::integer(-6) * &denominator.inverse()?)
}

/// Σ h\[k]ζ^−k, the Z transform of the inverse filter on the annulus |z| < |ζ| < 1/|z|: √3·(1/(1 − zζ) + 1/(1 − z/ζ) − 1).
/// SP-38.
///
/// `None` outside of the annulus.
#[doc(alias = "SP-38")]
pub fn z_transform(zeta: &Rational) -> Option<Surd> {
    let (z, one) = (pole(), Surd::integer(1));
    let size = Surd::from(Rational::from(zeta.abs_ref()));
    let modulus = -z.clone();
    if size <= modulus || size.clone() * &modulus >= one {
        return None;
    }
    let zeta = Surd::from(zeta.clone());
    let half = |ratio: Surd| (one.clone() - &ratio).inverse();
    let both = half(z.clone() * &zeta)? + &half(z * &zeta.inverse()?)?;
    Some((both - &one) * &Surd::sqrt(&Rational::from(3)).expect("3 is not negative"))
}

/// Σ |h\[k]| over |k| ≤ n, which rises to 3: bounded coefficients are at most three times the greatest sample. SP-78.
///
/// # Panics
/// Iff n ≥ 2³⁰.
#[doc(alias = "SP-78")]
pub fn absolute_sum(n: u32) -> Surd {
    // √3(1 + 2(r + … + rⁿ)) = √3(1 + 2(r − rⁿ⁺¹)/(1 − r)), r = 2 − √3.
    let r = -pole();
    let power = power_of_pole(&Integer::from(n + 1)).expect("n is below the limit");
    let power = if n.is_multiple_of(2) { -power } else { power };
    let inverse = (Surd::integer(1) - &r).inverse().expect("r is not 1");
    let sum = (r - &power) * &inverse * &Surd::integer(2) + &Surd::integer(1);
    sum * &Surd::sqrt(&Rational::from(3)).expect("3 is not negative")
}

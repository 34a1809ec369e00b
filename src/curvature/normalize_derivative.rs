//! More of the text's map n_λ: its derivative, and its value at curvatures that are irrational.

use super::normalize::SlopeError;
use crate::number::{Interval, OrderedField, Rational, Ring, Sign, Surd};
use std::cmp::Ordering;

/// n_λ′(x) = λe^(−λ|x|)/2, for x = 0 too: positive, even, at most λ/2. CU-200, CU-201, CU-202.
///
/// # Errors
/// iff λ ≤ 0.
#[doc(alias = "CU-200")]
#[doc(alias = "CU-201")]
#[doc(alias = "CU-202")]
pub fn normalize_derivative(slope: &Rational, x: &Rational, precision: u32) -> Result<Interval, SlopeError> {
    if slope.cmp0() != Ordering::Greater {
        return Err(SlopeError(slope.clone()));
    }
    let exponent = -Rational::from(slope * x).abs();
    let half = Interval::from_rational(&Rational::from(slope / 2_u32), precision);
    Ok(Interval::from_rational(&exponent, precision).exp() * &half)
}

/// n_λ(k) for a curvature k = H, k₁ or k₂, which is irrational in general: the normalised curvature kₙ(p) = n_λ(k(p)). CU-203.
///
/// # Errors
/// iff λ ≤ 0.
#[doc(alias = "CU-203")]
#[doc(alias = "CU-217")]
pub fn normalized_curvature(slope: &Rational, k: &Surd, precision: u32) -> Result<Interval, SlopeError> {
    if slope.cmp0() != Ordering::Greater {
        return Err(SlopeError(slope.clone()));
    }
    let enclosed = |x: &Rational| Interval::from_rational(x, precision);
    let power = |minus_size: Interval| (minus_size * &enclosed(slope)).exp() * &enclosed(&Rational::from((1, 2)));
    Ok(match k.sign() {
        Sign::Negative => power(k.enclosure(precision)),
        Sign::Zero | Sign::Positive => Interval::integer(1) - &power(-k.enclosure(precision)),
    })
}

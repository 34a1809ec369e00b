//! The text's map n_λ of a curvature to the interval (0, 1), for colours.

use crate::number::decimal::{DecimalEnclosure, Digits};
use crate::number::{Interval, Rational, Ring};
use std::cmp::Ordering;
use thiserror::Error;

/// λ is not above 0, so that n_λ does not map ℝ onto (0, 1).
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("expected a number above 0, found {0}")]
pub struct SlopeError(pub Rational);

/// n_λ(x) = e^(λx)/2 where x < 0, 1 − e^(−λx)/2 where x ≥ 0: increasing, from ℝ onto (0, 1). CU-7.
///
/// # Errors
/// iff λ ≤ 0.
#[doc(alias = "CU-7")]
pub fn normalize(slope: &Rational, x: &Rational, precision: u32) -> Result<Interval, SlopeError> {
    if slope.cmp0() != Ordering::Greater {
        return Err(SlopeError(slope.clone()));
    }
    let exponent = -Rational::from(slope * x).abs();
    let half = Interval::from_rational(&Rational::from((1, 2)), precision);
    let power = Interval::from_rational(&exponent, precision).exp() * &half;
    Ok(if x.cmp0() == Ordering::Less { power } else { Interval::integer(1) - &power })
}

/// n_λ(x) within decimal strings as narrow as asked for. CU-7.
///
/// # Errors
/// iff λ ≤ 0.
pub fn decimals(slope: &Rational, x: &Rational, digits: Digits) -> Result<DecimalEnclosure, SlopeError> {
    let mut precision = 64 + 4 * digits.count();
    loop {
        if let Some(enclosure) = normalize(slope, x, precision)?.decimals(digits) {
            return Ok(enclosure);
        }
        precision *= 2;
    }
}

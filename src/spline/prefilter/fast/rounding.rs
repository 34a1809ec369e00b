//! From an enclosure to the nearest binary64, where every number of the enclosure has the same.

use super::doubled::INFLATION;
use super::powers;
use crate::number::binary::nearest_f64;
use crate::number::{Integer, Rational};
use rug::Float;

/// 2⁻⁵¹.
const FOUR_UNITS: f64 = 1.0 / (1_u64 << 51) as f64;

/// The precision of the first look at a quotient.
const QUOTIENT_BITS: u32 = 128;

/// The factor 2^s that numbers were scaled by, and the scaled number above which rounding is that of 53 bits.
pub(super) struct Scale {
    back: [f64; 2],
    least: f64,
}

impl Scale {
    pub(super) fn new(s: i32) -> Scale {
        let [p, q] = powers(s);
        let [back_p, back_q] = powers(-s);
        Scale { back: [back_p, back_q], least: f64::MIN_POSITIVE * p * q }
    }

    /// Whether hi/2^s is nearest to all of (hi + lo ± err)/2^s. SP-80.
    ///
    /// Rounding is monotone: if both ends round to hi, so does all between. Above the least normal number dividing by 2^s commutes
    /// with it, where what is 2¹⁰²⁴ in 53 bits is an infinity.
    #[inline(always)]
    pub(super) fn decides(&self, hi: f64, lo: f64, err: f64) -> bool {
        // Wider by more than the roundings of err and of lo ± err.
        let err = err * INFLATION + lo.abs() * FOUR_UNITS;
        let (above, below) = (hi + (lo + err), hi + (lo - err));
        let is_zero = hi == 0.0 && err == 0.0;
        (above == hi) & (below == hi) & (hi.abs() > self.least) | is_zero
    }

    /// x/2^s, where that is a binary64.
    #[inline(always)]
    pub(super) fn unscaled(&self, x: f64) -> f64 {
        x * self.back[0] * self.back[1]
    }
}

/// The binary64 that is nearest to every number between two; `None` where there is no such one.
pub(super) fn nearest_within(lo: &Rational, hi: &Rational) -> Option<f64> {
    // −0 is nearest to small negative numbers and +0 to 0, so the bits decide the sign of a zero too.
    let (a, b) = (nearest_f64(lo), nearest_f64(hi));
    (a.to_bits() == b.to_bits()).then_some(a)
}

/// The binary64 nearest to n/d·2^q, d > 0. SP-81.
pub(super) fn nearest_quotient(n: &Integer, d: &Integer, q: i32) -> f64 {
    if n.is_zero() {
        return 0.0;
    }
    // Three roundings: within 2⁻¹²⁵ of the quotient, relative to it.
    let float = |x: &Integer| Float::with_val(QUOTIENT_BITS, x);
    let quotient = (float(n) / float(d)) << q;
    let slack = Float::with_val(QUOTIENT_BITS, quotient.abs_ref()) >> (QUOTIENT_BITS - 8);
    let [a, b] = [Float::with_val(QUOTIENT_BITS, &quotient - &slack), quotient + slack].map(|x| x.to_f64());
    if a.to_bits() == b.to_bits() {
        return a;
    }
    let x = Rational::from((n.clone(), d.clone()));
    nearest_f64(&if q < 0 { x >> q.unsigned_abs() } else { x << q.unsigned_abs() })
}

//! Intervals of binary64: the cheap first look at a sign.

use super::binary::nearest_f64;
use super::text::NumberError;
use super::{Enclosure, Rational, Ring, Sign};
use std::ops::{Add, Mul, Neg, Sub};

/// The real numbers x with lo ≤ x ≤ hi.
///
/// A binary64 operation rounds to nearest, so the exact result lies between the two neighbours of the
/// rounded one: `next_down` and `next_up` enclose it, for subnormals and after an overflow too (NU-7). lo may be −∞
/// and hi +∞, lo is never +∞ nor hi −∞, and no bound is NaN: what is too large is undecided, not decided wrongly.
#[derive(Clone, Copy, Debug)]
#[doc(alias = "NU-7")]
pub struct F64Interval {
    lo: f64,
    hi: f64,
}

impl F64Interval {
    /// The single number x.
    ///
    /// # Errors
    /// `NotANumber`, `Infinite`.
    pub fn exact(x: f64) -> Result<F64Interval, NumberError> {
        F64Interval::between(x, x)
    }

    /// lo ≤ x ≤ hi; the bounds are put in order.
    ///
    /// # Errors
    /// `NotANumber`, `Infinite`.
    pub fn between(lo: f64, hi: f64) -> Result<F64Interval, NumberError> {
        match (lo.is_nan() || hi.is_nan(), lo.is_infinite() || hi.is_infinite()) {
            (true, _) => Err(NumberError::NotANumber),
            (false, true) => Err(NumberError::Infinite),
            (false, false) => Ok(F64Interval { lo: lo.min(hi), hi: lo.max(hi) }),
        }
    }

    /// The narrowest interval around x, or one step wider; the point itself where x is a binary64.
    pub fn from_rational(x: &Rational) -> F64Interval {
        let nearest = nearest_f64(x);
        match Rational::from_f64(nearest) {
            Some(exact) if exact == *x => F64Interval { lo: nearest, hi: nearest },
            Some(_) | None => F64Interval::around(nearest, nearest),
        }
    }

    /// The lower bound; never +∞.
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// The upper bound; never −∞.
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// Whether lo ≤ x ≤ hi.
    pub fn contains(self, x: &Rational) -> bool {
        // A bound that is no rational is an infinite one, which every x is within.
        Rational::from_f64(self.lo).is_none_or(|lo| lo <= *x) && Rational::from_f64(self.hi).is_none_or(|hi| *x <= hi)
    }

    /// The interval around results that were rounded to nearest.
    fn around(lo: f64, hi: f64) -> F64Interval {
        F64Interval { lo: lo.next_down(), hi: hi.next_up() }
    }
}

impl Add<&F64Interval> for F64Interval {
    type Output = F64Interval;
    fn add(self, other: &F64Interval) -> F64Interval {
        // No ∞ − ∞: both lower bounds are below +∞, both upper ones above −∞.
        F64Interval::around(self.lo + other.lo, self.hi + other.hi)
    }
}

impl Sub<&F64Interval> for F64Interval {
    type Output = F64Interval;
    fn sub(self, other: &F64Interval) -> F64Interval {
        F64Interval::around(self.lo - other.hi, self.hi - other.lo)
    }
}

impl Mul<&F64Interval> for F64Interval {
    type Output = F64Interval;
    fn mul(self, other: &F64Interval) -> F64Interval {
        let (a, b, c, d) =
            (times(self.lo, other.lo), times(self.lo, other.hi), times(self.hi, other.lo), times(self.hi, other.hi));
        F64Interval::around(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

/// The rounded product of two bounds. An infinite bound stands for numbers as large as you like, all finite:
/// times 0 they are 0, where IEEE 754 has NaN.
fn times(x: f64, y: f64) -> f64 {
    if x == 0.0 || y == 0.0 { 0.0 } else { x * y }
}

impl Neg for F64Interval {
    type Output = F64Interval;
    fn neg(self) -> F64Interval {
        F64Interval { lo: -self.hi, hi: -self.lo }
    }
}

impl Ring for F64Interval {
    fn integer(n: i64) -> F64Interval {
        let nearest = n as f64;
        // Up to 2⁵³ every integer is a binary64.
        if n.unsigned_abs() <= 1 << 53 {
            F64Interval { lo: nearest, hi: nearest }
        } else {
            F64Interval::around(nearest, nearest)
        }
    }
}

impl Enclosure for F64Interval {
    fn known_sign(&self) -> Option<Sign> {
        if self.lo > 0.0 {
            Some(Sign::Positive)
        } else if self.hi < 0.0 {
            Some(Sign::Negative)
        } else if self.lo == 0.0 && self.hi == 0.0 {
            Some(Sign::Zero)
        } else {
            None
        }
    }
}

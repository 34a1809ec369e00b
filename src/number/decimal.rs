//! Decimal strings lo ≤ x ≤ hi: how a real number that is neither rational nor in ℚ(√d) leaves.

use super::text::NumberError;
use super::{Integer, Rational};
use rug::ops::Pow;
use std::cmp::Ordering;

/// The most decimal digits that can be asked for.
pub const MAX_DIGITS: u32 = 10_000;

/// How narrow an enclosure is to be: hi − lo ≤ 10^−digits · max(1, |x|). The default is 30.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Digits(u32);

impl Digits {
    /// # Errors
    /// `TooManyDigits` iff digits > [`MAX_DIGITS`].
    pub fn new(digits: u32) -> Result<Digits, NumberError> {
        if digits > MAX_DIGITS { Err(NumberError::TooManyDigits { digits }) } else { Ok(Digits(digits)) }
    }

    /// The number of digits.
    pub fn count(self) -> u32 {
        self.0
    }
}

impl Default for Digits {
    fn default() -> Digits {
        Digits(30)
    }
}

/// Two decimal strings of as many digits, lo ≤ x ≤ hi.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DecimalEnclosure {
    /// The lower bound.
    pub lo: String,
    /// The upper bound.
    pub hi: String,
}

impl DecimalEnclosure {
    /// The decimal strings around every x with lo ≤ x ≤ hi: lo is rounded down, hi up, and
    /// hi − lo ≤ 10^−digits · max(1, |x|) afterwards. NU-5.
    ///
    /// `None` where the bounds are too far apart for that (8/10 of it is near enough), or lo > hi.
    #[doc(alias = "NU-5")]
    pub fn around(lo: &Rational, hi: &Rational, digits: Digits) -> Option<DecimalEnclosure> {
        let scale = least_magnitude(lo, hi).max(Rational::from(1));
        // One digit more than is asked for: each rounding then costs a tenth of the width at most.
        let whole_digits = scale.clone().floor().numer().to_string().len() - 1;
        let whole_digits = u32::try_from(whole_digits).unwrap_or(u32::MAX);
        let places = (digits.0 + 1).saturating_sub(whole_digits);
        let power = Integer::from(10).pow(places);
        let down = Rational::from(lo * &power).floor().into_numer_denom().0;
        let up = Rational::from(hi * &power).ceil().into_numer_denom().0;
        let width = Rational::from((Integer::from(&up - &down), power));
        let narrow = width * Integer::from(10).pow(digits.0) <= scale;
        (lo <= hi && narrow).then(|| DecimalEnclosure { lo: shifted(&down, places), hi: shifted(&up, places) })
    }

    /// [`DecimalEnclosure::around`] a single rational, which always succeeds. NU-5.
    pub fn of(x: &Rational, digits: Digits) -> DecimalEnclosure {
        DecimalEnclosure::around(x, x, digits).expect("a point is narrow: the roundings add 10^-(digits+1)·max(1, |x|)")
    }
}

/// The least |x| with lo ≤ x ≤ hi.
fn least_magnitude(lo: &Rational, hi: &Rational) -> Rational {
    match (lo.cmp0(), hi.cmp0()) {
        (Ordering::Greater, _) => lo.clone(),
        (_, Ordering::Less) => Rational::from(-hi),
        (Ordering::Less | Ordering::Equal, Ordering::Equal | Ordering::Greater) => Rational::from(0),
    }
}

/// n·10^−places, written with that many places.
fn shifted(n: &Integer, places: u32) -> String {
    let sign = if n.cmp0() == Ordering::Less { "-" } else { "" };
    let places = places as usize;
    if places == 0 {
        return n.to_string();
    }
    let digits = Integer::from(n.abs_ref()).to_string();
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    format!("{sign}{whole}.{fraction}")
}

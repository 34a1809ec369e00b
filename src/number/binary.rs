//! IEEE 754 binary64 and binary32: exactly in, correctly rounded out.
//!
//! A finite value of such a format is m·2^q with integers m, q, where |m| < 2^(f+1) and q is at least
//! the format's least exponent: f = 52, q ≥ −1074 for binary64; f = 23, q ≥ −149 for binary32.

use super::text::NumberError;
use super::{Integer, Rational};
use std::cmp::Ordering;

/// The exact value of a binary64, a dyadic rational. NU-1.
///
/// # Errors
/// `NotANumber`, `Infinite`.
#[doc(alias = "NU-1")]
pub fn from_f64(x: f64) -> Result<Rational, NumberError> {
    if x.is_nan() {
        return Err(NumberError::NotANumber);
    }
    Rational::from_f64(x).ok_or(NumberError::Infinite)
}

/// The binary64 nearest to x, ties to the even one: the IEEE 754 rounding. At least 2¹⁰²⁴ − 2⁹⁷⁰ in absolute
/// value is an infinity; zero is +0; a negative number that rounds to zero is −0. NU-4.
#[doc(alias = "NU-4")]
pub fn nearest_f64(x: &Rational) -> f64 {
    let magnitude = f64::from_bits(BINARY64.nearest(x));
    if x.cmp0() == Ordering::Less { -magnitude } else { magnitude }
}

/// x as a binary64; `None` where it is none. A zero is +0.
pub fn exact_f64(x: &Rational) -> Option<f64> {
    Some(nearest_f64(x)).filter(|y| Rational::from_f64(*y).as_ref() == Some(x))
}

/// The binary32 nearest to x, as [`nearest_f64`], rounded once: not by way of binary64. NU-4.
pub fn nearest_f32(x: &Rational) -> f32 {
    let bits = u32::try_from(BINARY32.nearest(x)).expect("a binary32 has 32 bits");
    let magnitude = f32::from_bits(bits);
    if x.cmp0() == Ordering::Less { -magnitude } else { magnitude }
}

/// |x − exact| in units of the last place of [`nearest_f64`]`(exact)`: at most 1/2 where x is correctly rounded. NU-6.
///
/// The unit of the last place of y, 2^e ≤ |y| < 2^(e+1), is 2^max(e−52, −1074); of 0, 2^−1074; where the
/// nearest binary64 is infinite, it is that of the largest finite one, 2⁹⁷¹.
///
/// # Errors
/// `NotANumber`, `Infinite` where x is.
#[doc(alias = "NU-6")]
pub fn ulp_error(x: f64, exact: &Rational) -> Result<Rational, NumberError> {
    Ok((from_f64(x)? - exact).abs() / BINARY64.unit_at(exact))
}

/// The unit of the last place of [`nearest_f64`]`(x)`, in which [`ulp_error`] counts. NU-6.
pub fn unit_in_last_place(x: &Rational) -> Rational {
    BINARY64.unit_at(x)
}

/// [`ulp_error`] for binary32: the unit is 2^max(e−23, −149), and 2¹⁰⁴ beyond the largest one. NU-6.
///
/// # Errors
/// `NotANumber`, `Infinite` where x is.
pub fn ulp_error_f32(x: f32, exact: &Rational) -> Result<Rational, NumberError> {
    Ok((from_f64(f64::from(x))? - exact).abs() / BINARY32.unit_at(exact))
}

struct Format {
    /// Bits after the leading one.
    fraction_bits: u32,
    /// The smallest positive number is 2^this.
    least_exponent: i64,
    /// The bits of +∞.
    infinity: u64,
}

const BINARY64: Format = Format { fraction_bits: 52, least_exponent: -1074, infinity: 0x7FF0_0000_0000_0000 };
const BINARY32: Format = Format { fraction_bits: 23, least_exponent: -149, infinity: 0x7F80_0000 };

impl Format {
    /// The bits of the value of this format that is nearest to |x|, ties to even.
    fn nearest(&self, x: &Rational) -> u64 {
        let (mut n, mut d) = (Integer::from(x.numer().abs_ref()), x.denom().clone());
        if n.is_zero() {
            return 0;
        }
        // |x| = (n/d), to be rounded to m·2^q.
        let q = (floor_log2(&n, &d) - i64::from(self.fraction_bits)).max(self.least_exponent);
        if q > 2 * -self.least_exponent {
            return self.infinity;
        }
        let shift = u32::try_from(q.unsigned_abs()).expect("q is bounded by the format");
        if q < 0 {
            n <<= shift
        } else {
            d <<= shift
        }
        let (mut m, remainder) = n.div_rem(d.clone());
        let up = match (remainder * 2_u32).cmp(&d) {
            Ordering::Less => false,
            Ordering::Equal => m.is_odd(),
            Ordering::Greater => true,
        };
        if up {
            m += 1;
        }
        // Adding m to the exponent field, whose unit is 2^fraction_bits, counts the leading one as a step of
        // the exponent: so subnormals, normals and a carry into the next binade are one formula.
        let m = m.to_u64().expect("m ≤ 2^(fraction_bits + 1)");
        let binades = u64::try_from(q - self.least_exponent).expect("q is at least the least exponent");
        ((binades << self.fraction_bits) + m).min(self.infinity)
    }

    /// The unit of the last place of the format's nearest finite value.
    fn unit_at(&self, x: &Rational) -> Rational {
        let bits = self.nearest(x).min(self.infinity - 1);
        let field = i64::try_from(bits >> self.fraction_bits).expect("an exponent field is small");
        power_of_two(field.max(1) - 1 + self.least_exponent)
    }
}

/// ⌊log₂(n/d)⌋ for positive n, d.
fn floor_log2(n: &Integer, d: &Integer) -> i64 {
    // 2^(k−1) < n/d < 2^(k+1)
    let k = i64::from(n.significant_bits()) - i64::from(d.significant_bits());
    let shift = u32::try_from(k.unsigned_abs()).expect("a difference of bit counts");
    let reaches = if k < 0 { Integer::from(n << shift) >= *d } else { *n >= Integer::from(d << shift) };
    if reaches { k } else { k - 1 }
}

fn power_of_two(exponent: i64) -> Rational {
    let power = Integer::from(1) << u32::try_from(exponent.unsigned_abs()).expect("an exponent of a format");
    if exponent < 0 { Rational::from((Integer::from(1), power)) } else { Rational::from(power) }
}

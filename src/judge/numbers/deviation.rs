//! How far a rational number is from a real one, in either unit, exactly.

use super::real::{Real, decided};
use crate::judge::accuracy::{ALL_DIGITS_WRONG, Magnitude};
use crate::number::binary::nearest_f64;
use crate::number::{Integer, Rational, Surd};

/// What an error is counted in.
#[derive(Clone, Copy, Debug)]
pub enum Unit<'a> {
    /// The unit of the last place of the binary64 nearest to the truth.
    LastPlace,
    /// 2⁻⁵²·|M|, M the largest number of the truth's list, but no less than 2⁻¹⁰⁷⁴.
    Relative {
        /// M.
        largest: &'a Real,
        /// Whether M is the truth itself.
        is_own: bool,
    },
}

/// 2^exponent.
fn power_of_two(exponent: i32) -> Rational {
    let power = Integer::from(1) << exponent.unsigned_abs();
    if exponent < 0 { Rational::from((Integer::from(1), power)) } else { Rational::from(power) }
}

/// |x − y| ≤ bound·unit?
pub fn is_at_most(x: &Rational, y: &Real, unit: Unit, bound: &Rational) -> bool {
    match unit {
        Unit::LastPlace => is_near(x, y, &(y.unit_in_last_place() * bound)),
        Unit::Relative { largest, is_own } => {
            let relative = power_of_two(-52) * bound;
            is_near(x, y, &(power_of_two(-1074) * bound)) || is_relatively_near(x, y, largest, is_own, &relative)
        }
    }
}

/// |x − y| ≤ d?
fn is_near(x: &Rational, y: &Real, d: &Rational) -> bool {
    y.cmp_rational(&Rational::from(x - d)).is_ge() && y.cmp_rational(&Rational::from(x + d)).is_le()
}

/// |x − y| ≤ t·|M|?
fn is_relatively_near(x: &Rational, y: &Real, m: &Real, is_own: bool, t: &Rational) -> bool {
    if let Some(m) = m.rational() {
        return is_near(x, y, &(Rational::from(m.abs_ref()) * t));
    }
    if let Some(y) = y.rational() {
        // |M| ≥ |x − y|/t; M is irrational, so not 0.
        let distance = Rational::from(x - y).abs();
        return distance.is_zero() || (!t.is_zero() && !m.is_within(&(distance / t)));
    }
    match (y, m) {
        (Real::Surd(y), Real::Surd(m)) => {
            let abs = |x: Surd| if x < Surd::from(Rational::new()) { -x } else { x };
            abs(Surd::from(x.clone()) - y) <= abs(m.clone()) * &Surd::from(t.clone())
        }
        // |0 − y| = 1·|y|.
        (_, _) if is_own && x.is_zero() => *t >= 1,
        // |x − y| = t·|M| holds for no rational x and t: with M = y it would make y rational, and with M the other one of k₁, k₂ = h ± s
        // it would be a rational relation between h and s, roots of different fields. So narrow enclosures settle it.
        (_, _) => decided([y, m], |[[lo, hi], m]| {
            let [near, far] = sizes([Rational::from(x - &hi), Rational::from(x - &lo)]);
            let [small, large] = sizes(m).map(|size| size * t);
            if far <= small {
                Some(true)
            } else if near > large {
                Some(false)
            } else {
                None
            }
        }),
    }
}

/// The least and the greatest |y| with lo ≤ y ≤ hi.
fn sizes([lo, hi]: [Rational; 2]) -> [Rational; 2] {
    let has_zero = lo <= 0 && hi >= 0;
    let (lo, hi) = (lo.abs(), hi.abs());
    let [small, large] = if lo <= hi { [lo, hi] } else { [hi, lo] };
    [if has_zero { Rational::new() } else { small }, large]
}

/// The error of x, in that unit.
pub fn magnitude(x: &Rational, y: &Real, unit: Unit) -> Magnitude {
    // The buckets' bounds are ½, 1, 2, …, 2⁵².
    let (mut low, mut high) = (0, ALL_DIGITS_WRONG);
    while low < high {
        let middle = (low + high) / 2;
        let bound = power_of_two(i32::try_from(middle).expect("few buckets") - 1);
        if is_at_most(x, y, unit, &bound) { high = middle } else { low = middle + 1 }
    }
    Magnitude { bucket: low, units: units(x, y, unit, low) }
}

/// The error as a number for reading; the bucket is what was decided.
fn units(x: &Rational, y: &Real, unit: Unit, bucket: usize) -> f64 {
    let unit = match unit {
        Unit::LastPlace => y.unit_in_last_place(),
        Unit::Relative { largest, .. } => (power_of_two(-52) * largest.near().abs()).max(power_of_two(-1074)),
    };
    let units = nearest_f64(&((Rational::from(x - &y.near())).abs() / unit)).min(f64::MAX);
    let bound = |bucket: usize| 2_f64.powi(i32::try_from(bucket).expect("few buckets") - 1);
    match bucket {
        0 => units.min(0.5),
        ALL_DIGITS_WRONG => units.max(bound(ALL_DIGITS_WRONG - 1)),
        i => units.clamp(bound(i - 1), bound(i)),
    }
}

//! What binary64 enclosures need beyond ring operations: hulls, squares, quotients, roots, and a first-order part.

use crate::number::{Enclosure, F64Interval, Ring, Sign};
use std::ops::{Add, Mul, Neg, Sub};

/// The least interval around both bounds, which need not be finite nor in order.
///
/// A bound that is no finite number says nothing, so the interval is then as wide as enclosures get.
pub(super) fn between(lo: f64, hi: f64) -> F64Interval {
    F64Interval::between(lo, hi).unwrap_or_else(|_| everything())
}

/// An interval around every real number that is found in practice: (−∞, +∞).
fn everything() -> F64Interval {
    let largest = F64Interval::between(-f64::MAX, f64::MAX).expect("both are finite");
    largest + &largest
}

/// The least interval around all of them, of which there is one at least.
pub(super) fn hull(mut values: impl Iterator<Item = F64Interval>) -> F64Interval {
    let first = values.next().expect("a hull of something");
    let bounds = |x: F64Interval| (x.lo(), x.hi());
    let (lo, hi) = values.map(bounds).fold(bounds(first), |(lo, hi), (a, b)| (lo.min(a), hi.max(b)));
    between(lo, hi)
}

/// A number, exactly.
pub(super) fn exactly(x: f64) -> F64Interval {
    between(x, x)
}

/// Around every x² with x in the interval: never below 0.
pub(super) fn square(x: F64Interval) -> F64Interval {
    match x.known_sign() {
        Some(Sign::Positive | Sign::Negative) => x * &x,
        Some(Sign::Zero) | None => between(0.0, (largest(x) * largest(x)).next_up()),
    }
}

/// max |x| over the interval.
pub(super) fn largest(x: F64Interval) -> f64 {
    x.hi().max(-x.lo())
}

/// min |x| over the interval.
pub(super) fn smallest(x: F64Interval) -> f64 {
    x.lo().max(-x.hi()).max(0.0)
}

/// Around every x/y; `None` where y may be 0. Division is rounded to nearest, so the neighbours enclose it.
pub(super) fn quotient(x: F64Interval, y: F64Interval) -> Option<F64Interval> {
    match y.known_sign() {
        Some(Sign::Positive | Sign::Negative) => {
            let [a, b, c, d] = [x.lo() / y.lo(), x.lo() / y.hi(), x.hi() / y.lo(), x.hi() / y.hi()];
            let is_number = !(a.is_nan() || b.is_nan() || c.is_nan() || d.is_nan());
            let (lo, hi) = (a.min(b).min(c.min(d)), a.max(b).max(c.max(d)));
            Some(if is_number { between(lo.next_down(), hi.next_up()) } else { everything() })
        }
        Some(Sign::Zero) | None => None,
    }
}

/// Around every √x; `None` where x may be negative. The square root is rounded to nearest.
pub(super) fn root(x: F64Interval) -> Option<F64Interval> {
    (x.lo() >= 0.0).then(|| between(x.lo().sqrt().next_down().max(0.0), x.hi().sqrt().next_up()))
}

/// a + a₁ du + a₂ dv with (du, dv)² = 0: a number and how it changes along two parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dual {
    pub value: F64Interval,
    pub slopes: [F64Interval; 2],
}

impl Dual {
    fn entrywise(self, other: &Dual, combine: impl Fn(F64Interval, &F64Interval) -> F64Interval) -> Dual {
        let slopes = [0, 1].map(|i| combine(self.slopes[i], &other.slopes[i]));
        Dual { value: combine(self.value, &other.value), slopes }
    }

    /// Leibniz' rule.
    fn product(self, other: &Dual) -> Dual {
        let slope = |i: usize| self.slopes[i] * &other.value + &(other.slopes[i] * &self.value);
        Dual { value: self.value * &other.value, slopes: [slope(0), slope(1)] }
    }

    /// φ(a) with φ′(a).
    fn composed(self, value: F64Interval, first: F64Interval) -> Dual {
        Dual { value, slopes: self.slopes.map(|slope| slope * &first) }
    }

    /// a².
    pub fn square(self) -> Dual {
        self.composed(square(self.value), self.value + &self.value)
    }

    /// 1/a; `None` where a may be 0.
    pub fn reciprocal(self) -> Option<Dual> {
        let value = quotient(F64Interval::integer(1), self.value)?;
        Some(self.composed(value, -square(value)))
    }

    /// √a; `None` unless a > 0 for certain.
    pub fn root(self) -> Option<Dual> {
        let value = root(self.value)?;
        Some(self.composed(value, quotient(F64Interval::integer(1), value + &value)?))
    }
}

impl Add<&Dual> for Dual {
    type Output = Dual;
    fn add(self, other: &Dual) -> Dual {
        self.entrywise(other, |a, b| a + b)
    }
}

impl Sub<&Dual> for Dual {
    type Output = Dual;
    fn sub(self, other: &Dual) -> Dual {
        self.entrywise(other, |a, b| a - b)
    }
}

impl Mul<&Dual> for Dual {
    type Output = Dual;
    fn mul(self, other: &Dual) -> Dual {
        self.product(other)
    }
}

impl Neg for Dual {
    type Output = Dual;
    fn neg(self) -> Dual {
        Dual { value: -self.value, slopes: self.slopes.map(|slope| -slope) }
    }
}

impl Ring for Dual {
    fn integer(n: i64) -> Dual {
        Dual { value: F64Interval::integer(n), slopes: [F64Interval::integer(0); 2] }
    }
}

//! Elementary functions of intervals, and the sets that quadrature makes of them.

use super::{Interval, clamped, rounded};
use crate::number::Ring;
use rug::Float;
use rug::float::Round;
use std::cmp::Ordering;

/// The sine of a number beyond 2^this says no more than −1 ≤ sin ≤ 1: its reduction modulo 2π takes as many bits.
const LARGEST_EXPONENT: i32 = 4096;

impl Interval {
    /// (−∞, ∞).
    pub fn everything(precision: u32) -> Interval {
        let p = clamped(precision);
        let infinity = Float::with_val(p, rug::float::Special::Infinity);
        Interval { lo: -infinity.clone(), hi: infinity }
    }

    /// Around every x² with x in the interval: never below 0, unlike the product of the interval with itself.
    pub fn square(&self) -> Interval {
        let product = self.clone() * self;
        match self.sign_of_bounds() {
            (Ordering::Less, Ordering::Greater) => Interval { lo: Float::new(self.precision()), ..product },
            _ => product,
        }
    }

    /// Around every ln x with x in the interval; `None` unless lo > 0.
    pub fn ln(&self) -> Option<Interval> {
        let p = self.precision();
        (self.lo.cmp0() == Some(Ordering::Greater)).then(|| Interval {
            lo: rounded(p, self.lo.ln_ref(), Round::Down),
            hi: rounded(p, self.hi.ln_ref(), Round::Up),
        })
    }

    /// Around every arctan x with x in the interval.
    pub fn atan(&self) -> Interval {
        let p = self.precision();
        Interval { lo: rounded(p, self.lo.atan_ref(), Round::Down), hi: rounded(p, self.hi.atan_ref(), Round::Up) }
    }

    /// Around every sin x with x in the interval, x in radians; wider than the narrowest by the interval's width at most.
    pub fn sin(&self) -> Interval {
        self.of_slope_one(|p, m, round| rounded(p, m.sin_ref(), round))
    }

    /// Around every cos x with x in the interval, x in radians; wider than the narrowest by the interval's width at most.
    pub fn cos(&self) -> Interval {
        self.of_slope_one(|p, m, round| rounded(p, m.cos_ref(), round))
    }

    /// |f(x) − f(m)| ≤ |x − m| for f = sin and cos, at the middle m.
    fn of_slope_one(&self, f: impl Fn(u32, &Float, Round) -> Float) -> Interval {
        let p = self.precision();
        let unit = Interval { lo: Float::with_val(p, -1), hi: Float::with_val(p, 1) };
        let m = rounded(p, &self.lo + &self.hi, Round::Nearest) / 2_u32;
        if !m.is_finite() || m.get_exp().is_some_and(|e| e > LARGEST_EXPONENT) {
            return unit;
        }
        let (below, above) = (rounded(p, &m - &self.lo, Round::Up), rounded(p, &self.hi - &m, Round::Up));
        let radius = if below > above { below } else { above };
        let (lo, hi) = (f(p, &m, Round::Down), f(p, &m, Round::Up));
        let around = Interval { lo: rounded(p, lo - &radius, Round::Down), hi: rounded(p, hi + radius, Round::Up) };
        around.intersection(&unit).expect("the sine of a number lies in both")
    }

    /// xⁿ for every x in the interval.
    pub fn power(&self, n: u32) -> Interval {
        match (n, n % 2) {
            (0, _) => Interval::integer(1),
            (_, 0) => self.power(n / 2).square(),
            (_, _) => self.power(n - 1) * self,
        }
    }

    /// The numbers in both; `None` iff there are none.
    pub fn intersection(&self, other: &Interval) -> Option<Interval> {
        let p = self.precision().max(other.precision());
        let lo = if self.lo > other.lo { &self.lo } else { &other.lo };
        let hi = if self.hi < other.hi { &self.hi } else { &other.hi };
        (lo <= hi).then(|| Interval { lo: rounded(p, lo, Round::Down), hi: rounded(p, hi, Round::Up) })
    }

    /// The numbers in one of them, and between.
    pub fn hull(&self, other: &Interval) -> Interval {
        let p = self.precision().max(other.precision());
        let lo = if self.lo < other.lo { &self.lo } else { &other.lo };
        let hi = if self.hi > other.hi { &self.hi } else { &other.hi };
        Interval { lo: rounded(p, lo, Round::Down), hi: rounded(p, hi, Round::Up) }
    }

    /// The numbers x ≥ 0 in the interval; `None` iff there are none.
    pub fn not_negative(&self) -> Option<Interval> {
        match self.sign_of_bounds() {
            (Ordering::Less, Ordering::Less) => None,
            (Ordering::Less, _) => Some(Interval { lo: Float::new(self.precision()), hi: self.hi.clone() }),
            (Ordering::Equal | Ordering::Greater, _) => Some(self.clone()),
        }
    }

    /// Around every |x| with x in the interval.
    pub fn abs(&self) -> Interval {
        match self.sign_of_bounds() {
            (Ordering::Less, Ordering::Greater) => self.hull(&-self.clone()).not_negative().expect("it is around 0"),
            (Ordering::Less, _) => -self.clone(),
            (Ordering::Equal | Ordering::Greater, _) => self.clone(),
        }
    }

    /// Whether both bounds are 0.
    pub fn is_zero(&self) -> bool {
        self.lo.is_zero() && self.hi.is_zero()
    }

    fn sign_of_bounds(&self) -> (Ordering, Ordering) {
        let message = "a bound is a number";
        (self.lo.cmp0().expect(message), self.hi.cmp0().expect(message))
    }
}

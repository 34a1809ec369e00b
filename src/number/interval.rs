//! Intervals of MPFR numbers, rounded outward: they enclose the exact result of every operation.

mod elementary;

use super::decimal::{DecimalEnclosure, Digits};
use super::{Enclosure, Integer, Rational, Ring, Sign};
use rug::Float;
use rug::float::{Constant, Round};
use rug::ops::AssignRound;
use std::cmp::Ordering;
use std::fmt::{self, Display, Formatter};
use std::ops::{Add, Mul, Neg, Sub};

/// The least and the largest precision in bits; one outside is taken as the nearer of the two.
const PRECISIONS: (u32, u32) = (2, 1 << 24);

/// The precision of an integer constant: enough for every `i64`.
const INTEGER_PRECISION: u32 = 64;

/// The real numbers x with lo ≤ x ≤ hi, whose bounds are binary floating-point numbers of one precision.
///
/// An operation rounds lo down and hi up, at the larger precision of its operands: whatever numbers the operands
/// stand for, the result of the exact operation lies in the interval (NU-8). Beyond MPFR's exponents, about
/// 2^±2³⁰, a bound is infinite: lo may be −∞ and hi +∞; neither is ever NaN.
#[derive(Clone, Debug)]
#[doc(alias = "NU-8")]
pub struct Interval {
    lo: Float,
    hi: Float,
}

impl Interval {
    /// The narrowest interval of that precision, in bits, around x.
    pub fn from_rational(x: &Rational, precision: u32) -> Interval {
        outward(precision, |p, round| rounded(p, x, round))
    }

    /// The narrowest interval of that precision, in bits, around n.
    pub fn from_integer(n: &Integer, precision: u32) -> Interval {
        outward(precision, |p, round| rounded(p, n, round))
    }

    /// The narrowest interval of that precision around all x with lo ≤ x ≤ hi; `None` iff lo > hi.
    pub fn between(lo: &Rational, hi: &Rational, precision: u32) -> Option<Interval> {
        let p = clamped(precision);
        (lo <= hi).then(|| Interval { lo: rounded(p, lo, Round::Down), hi: rounded(p, hi, Round::Up) })
    }

    /// The lower bound; never +∞.
    pub fn lo(&self) -> &Float {
        &self.lo
    }

    /// The upper bound; never −∞.
    pub fn hi(&self) -> &Float {
        &self.hi
    }

    /// The bounds, exactly; `None` where one is infinite.
    pub fn bounds(&self) -> Option<(Rational, Rational)> {
        Some((self.lo.to_rational()?, self.hi.to_rational()?))
    }

    /// The precision in bits.
    pub fn precision(&self) -> u32 {
        self.lo.prec()
    }

    /// hi − lo, exactly; `None` where a bound is infinite.
    pub fn width(&self) -> Option<Rational> {
        self.bounds().map(|(lo, hi)| hi - lo)
    }

    /// Whether lo ≤ x ≤ hi.
    pub fn contains(&self, x: &Rational) -> bool {
        self.lo <= *x && *x <= self.hi
    }

    /// Around every √x with x in the interval; `None` where lo < 0, for then some x has no root.
    pub fn sqrt(&self) -> Option<Interval> {
        (self.lo.cmp0() != Some(Ordering::Less)).then(|| Interval {
            lo: rounded(self.precision(), self.lo.sqrt_ref(), Round::Down),
            hi: rounded(self.precision(), self.hi.sqrt_ref(), Round::Up),
        })
    }

    /// Around every x/y with x in the interval and y in the other; `None` where that contains 0.
    pub fn checked_div(&self, other: &Interval) -> Option<Interval> {
        match other.known_sign() {
            Some(Sign::Zero) | None => None,
            Some(Sign::Negative | Sign::Positive) => Some(hull_of_corners(self, other, |p, x, y, round| {
                // 0 is the limit of x/y for y → ∞; the other corners are the larger ones.
                if y.is_infinite() { Float::new(p) } else { rounded(p, x / y, round) }
            })),
        }
    }

    /// Around every eˣ with x in the interval.
    pub fn exp(&self) -> Interval {
        let p = self.precision();
        Interval { lo: rounded(p, self.lo.exp_ref(), Round::Down), hi: rounded(p, self.hi.exp_ref(), Round::Up) }
    }

    /// The narrowest interval of that precision around π.
    pub fn pi(precision: u32) -> Interval {
        outward(precision, |p, round| rounded(p, Constant::Pi, round))
    }

    /// Around the argument, in (0, π), of every x + iy with x in the one interval and y in the other; `None` unless
    /// all y > 0.
    pub fn argument(x: &Interval, y: &Interval) -> Option<Interval> {
        // Where y > 0, arg falls with x, and for each x it rises or falls with y: the extremes are at corners.
        let is_above = y.lo.cmp0() == Some(Ordering::Greater);
        is_above.then(|| hull_of_corners(x, y, |p, x, y, round| rounded(p, y.atan2_ref(x), round)))
    }

    /// Decimal strings around the interval; `None` where it is too wide for that many digits, or infinite.
    pub fn decimals(&self, digits: Digits) -> Option<DecimalEnclosure> {
        let (lo, hi) = self.bounds()?;
        DecimalEnclosure::around(&lo, &hi, digits)
    }
}

/// The interval from one computation, rounded down and rounded up.
fn outward(precision: u32, compute: impl Fn(u32, Round) -> Float) -> Interval {
    let p = clamped(precision);
    Interval { lo: compute(p, Round::Down), hi: compute(p, Round::Up) }
}

/// The smallest interval around an operation that takes its extremes over two intervals at their ends.
fn hull_of_corners(a: &Interval, b: &Interval, operation: impl Fn(u32, &Float, &Float, Round) -> Float) -> Interval {
    let p = a.precision().max(b.precision());
    let corners = [(&a.lo, &b.lo), (&a.lo, &b.hi), (&a.hi, &b.lo), (&a.hi, &b.hi)];
    let [lo, hi] = [(Round::Down, Ordering::Less), (Round::Up, Ordering::Greater)].map(|(round, wanted)| {
        let values = corners.map(|(x, y)| operation(p, x, y, round));
        values.into_iter().reduce(|m, x| if x.partial_cmp(&m) == Some(wanted) { x } else { m })
    });
    let message = "there are four corners";
    Interval { lo: lo.expect(message), hi: hi.expect(message) }
}

fn rounded<T>(precision: u32, value: T, round: Round) -> Float
where
    Float: AssignRound<T, Round = Round, Ordering = Ordering>,
{
    Float::with_val_round(precision, value, round).0
}

fn clamped(precision: u32) -> u32 {
    precision.clamp(PRECISIONS.0, PRECISIONS.1)
}

impl Add<&Interval> for Interval {
    type Output = Interval;
    fn add(self, other: &Interval) -> Interval {
        let p = self.precision().max(other.precision());
        Interval { lo: rounded(p, &self.lo + &other.lo, Round::Down), hi: rounded(p, &self.hi + &other.hi, Round::Up) }
    }
}

impl Sub<&Interval> for Interval {
    type Output = Interval;
    fn sub(self, other: &Interval) -> Interval {
        let p = self.precision().max(other.precision());
        Interval { lo: rounded(p, &self.lo - &other.hi, Round::Down), hi: rounded(p, &self.hi - &other.lo, Round::Up) }
    }
}

impl Mul<&Interval> for Interval {
    type Output = Interval;
    fn mul(self, other: &Interval) -> Interval {
        let p = self.precision().max(other.precision());
        let is_negative = |x: &Float| x.cmp0() == Some(Ordering::Less);
        let is_positive = |x: &Float| x.cmp0() == Some(Ordering::Greater);
        // Where one factor has one sign, that of the other's bound tells the corner.
        match (self, other) {
            (x, y) if !is_negative(&y.lo) => times_positive(p, &x, y),
            (x, y) if !is_negative(&x.lo) => times_positive(p, y, &x),
            (x, y) if !is_positive(&y.hi) => -times_positive(p, &x, &-y.clone()),
            (x, y) if !is_positive(&x.hi) => -times_positive(p, y, &-x),
            (x, y) => hull_of_corners(&x, y, times),
        }
    }
}

/// An infinite bound stands for numbers as large as you like, all finite: times 0 they are 0.
fn times(p: u32, x: &Float, y: &Float, round: Round) -> Float {
    if x.is_zero() || y.is_zero() { Float::new(p) } else { rounded(p, x * y, round) }
}

/// x·y, where y is nowhere negative.
fn times_positive(p: u32, x: &Interval, y: &Interval) -> Interval {
    let is_negative = |x: &Float| x.cmp0() == Some(Ordering::Less);
    let lo = times(p, &x.lo, if is_negative(&x.lo) { &y.hi } else { &y.lo }, Round::Down);
    let hi = times(p, &x.hi, if is_negative(&x.hi) { &y.lo } else { &y.hi }, Round::Up);
    Interval { lo, hi }
}

impl Neg for Interval {
    type Output = Interval;
    fn neg(self) -> Interval {
        Interval { lo: -self.hi, hi: -self.lo }
    }
}

impl Ring for Interval {
    fn integer(n: i64) -> Interval {
        outward(INTEGER_PRECISION, |p, round| rounded(p, n, round))
    }
}

impl Enclosure for Interval {
    fn known_sign(&self) -> Option<Sign> {
        match (self.lo.cmp0()?, self.hi.cmp0()?) {
            (Ordering::Greater, _) => Some(Sign::Positive),
            (_, Ordering::Less) => Some(Sign::Negative),
            (Ordering::Equal, Ordering::Equal) => Some(Sign::Zero),
            (Ordering::Less | Ordering::Equal, Ordering::Equal | Ordering::Greater) => None,
        }
    }
}

/// `[lo, hi]`, in MPFR's decimal notation, whose digits are rounded: for a person, not for a proof.
impl Display for Interval {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "[{}, {}]", self.lo, self.hi)
    }
}

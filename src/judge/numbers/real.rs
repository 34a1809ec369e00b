//! True real numbers: exact, or as narrowly enclosed as a decision needs.

use crate::curvature::normalize::normalize;
use crate::curvature::principal::Principal;
use crate::number::binary::{nearest_f64, unit_in_last_place};
use crate::number::{Interval, Rational, Ring, Surd};
use std::cmp::Ordering;
use std::fmt::{self, Display, Formatter};

/// Bits of the first enclosure; each further one has twice as many.
const FIRST_PRECISION: u32 = 192;

/// A real number that is the answer, or a part of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Real {
    /// A number of some ℚ(√d).
    Surd(Surd),
    /// k₁ (0) or k₂ (1), where H and √(H² − K) lie in different fields: irrational, and of degree four.
    Principal(Box<Principal>, usize),
    /// n_λ(x) for a λ > 0 and an x ≠ 0: transcendental, for e^(λx) is.
    Normalized {
        /// λ.
        slope: Rational,
        /// x.
        x: Rational,
    },
}

impl Real {
    /// k₁, k₂.
    pub fn principal(principal: Principal) -> [Real; 2] {
        match principal.exact() {
            Some(exact) => exact.map(Real::Surd),
            None => [0, 1].map(|i| Real::Principal(Box::new(principal.clone()), i)),
        }
    }

    /// n_λ(x), λ > 0.
    pub fn normalized(slope: Rational, x: Rational) -> Real {
        if x.is_zero() { Real::from(Rational::from((1, 2))) } else { Real::Normalized { slope, x } }
    }

    /// The number, where it is rational.
    pub fn rational(&self) -> Option<&Rational> {
        match self {
            Real::Surd(x) => x.rational(),
            Real::Principal(..) | Real::Normalized { .. } => None,
        }
    }

    /// An enclosure of that many bits.
    pub fn enclosure(&self, precision: u32) -> Interval {
        match self {
            Real::Surd(x) => x.enclosure(precision),
            Real::Principal(principal, i) => principal.enclosure(precision)[*i].clone(),
            Real::Normalized { slope, x } => normalize(slope, x, precision).expect("λ > 0"),
        }
    }

    /// Where the number lies beside a rational one.
    pub fn cmp_rational(&self, q: &Rational) -> Ordering {
        if let Some(x) = self.rational() {
            return x.cmp(q);
        }
        match self {
            Real::Surd(x) => x.cmp(&Surd::from(q.clone())),
            Real::Principal(..) | Real::Normalized { .. } => {
                decided([self], |[[lo, hi]]| match (lo.cmp(q), hi.cmp(q)) {
                    (Ordering::Greater, _) => Some(Ordering::Greater),
                    (_, Ordering::Less) => Some(Ordering::Less),
                    (_, _) => None,
                })
            }
        }
    }

    /// |y| ≤ q?
    pub fn is_within(&self, q: &Rational) -> bool {
        self.cmp_rational(q) != Ordering::Greater && self.cmp_rational(&Rational::from(-q)) != Ordering::Less
    }

    /// The unit of the last place of the binary64 nearest to the number.
    pub fn unit_in_last_place(&self) -> Rational {
        match self.rational() {
            Some(x) => unit_in_last_place(x),
            // An irrational number is nowhere near the points where the unit changes.
            None => decided([self], |[bounds]| {
                let [low, high] = bounds.each_ref().map(unit_in_last_place);
                (low == high).then_some(low)
            }),
        }
    }

    /// A rational number near it, for reading.
    pub fn near(&self) -> Rational {
        match self.rational() {
            Some(x) => x.clone(),
            None => {
                let (lo, hi) = self.enclosure(FIRST_PRECISION).bounds().unwrap_or_default();
                (lo + hi) / 2_u32
            }
        }
    }
}

/// The first answer that enclosures settle. The question must be one that narrow enough enclosures do.
pub fn decided<T, const N: usize>(numbers: [&Real; N], settle: impl Fn([[Rational; 2]; N]) -> Option<T>) -> T {
    let mut precision = FIRST_PRECISION;
    loop {
        // A bound is infinite only beyond MPFR's exponents, where no number of a question leads.
        let bounds = numbers.map(|x| x.enclosure(precision).bounds().map(|(lo, hi)| [lo, hi]));
        if bounds.iter().all(Option::is_some)
            && let Some(answer) = settle(bounds.map(Option::unwrap_or_default))
        {
            return answer;
        }
        precision *= 2;
    }
}

/// The index of the number that is largest in absolute value, of numbers that one answer lists together; 0 of none.
///
/// Those that are not of some ℚ(√d) come alone, or as k₁ and k₂, where |k₁| > |k₂| iff H > 0; H = 0 would be of every field.
pub fn largest(numbers: &[Real]) -> usize {
    match numbers.first() {
        Some(Real::Principal(principal, _)) => usize::from(principal.mean() < Surd::integer(0)),
        Some(Real::Surd(_) | Real::Normalized { .. }) | None => {
            let size = |x: &Real| match x {
                Real::Surd(x) if *x < Surd::integer(0) => -x.clone(),
                Real::Surd(x) => x.clone(),
                Real::Principal(..) | Real::Normalized { .. } => Surd::integer(1),
            };
            // The first of equal ones.
            (0..numbers.len()).rev().max_by_key(|i| size(&numbers[*i])).unwrap_or(0)
        }
    }
}

impl From<Rational> for Real {
    fn from(x: Rational) -> Real {
        Real::Surd(Surd::from(x))
    }
}

/// Exactly where it is short, else beginning with "≈".
impl Display for Real {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        const MOST: usize = 40;
        let exact = match self {
            Real::Surd(x) => Some(x.to_string()).filter(|text| text.chars().count() <= MOST),
            Real::Principal(..) | Real::Normalized { .. } => None,
        };
        match exact {
            Some(text) => f.write_str(&text),
            None => write!(f, "≈ {:e}", nearest_f64(&self.near())),
        }
    }
}

//! Principal curvatures from K and H.

use crate::number::decimal::{DecimalEnclosure, Digits};
use crate::number::{Interval, Rational, Ring, Sign, Surd};

/// k₁ ≥ k₂, the roots of k² − 2Hk + K: k = H ± √(H² − K), where H is a square root of a rational. CU-4.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-4")]
pub struct Principal {
    mean_sign: Sign,
    mean_squared: Rational,
    /// H² − K ≥ 0.
    discriminant: Rational,
}

const NOT_NEGATIVE: &str = "squares are not negative";

impl Principal {
    /// From the sign of H, H² and K.
    ///
    /// # Panics
    /// Iff H² < 0 or H² < K, which no pair of real principal curvatures has.
    pub fn new(mean_sign: Sign, mean_squared: &Rational, gaussian: &Rational) -> Principal {
        let discriminant = Rational::from(mean_squared - gaussian);
        assert!(*mean_squared >= 0 && discriminant >= 0, "{NOT_NEGATIVE}");
        Principal { mean_sign, mean_squared: mean_squared.clone(), discriminant }
    }

    /// H.
    pub fn mean(&self) -> Surd {
        let sign = Rational::from(self.mean_sign.value());
        Surd::new(Rational::new(), sign, &self.mean_squared).expect(NOT_NEGATIVE)
    }

    /// (k₁ − k₂)/2 = √(H² − K).
    pub fn spread(&self) -> Surd {
        Surd::sqrt(&self.discriminant).expect(NOT_NEGATIVE)
    }

    /// k₁, k₂ in one field ℚ(√d); `None` where H and √(H² − K) lie in different ones.
    pub fn exact(&self) -> Option<[Surd; 2]> {
        let (mean, spread) = (self.mean(), self.spread());
        Some([mean.checked_add(&spread).ok()?, mean.checked_sub(&spread).ok()?])
    }

    /// k₁, k₂ within intervals of that precision.
    pub fn enclosure(&self, precision: u32) -> [Interval; 2] {
        let root = |x: &Rational| Interval::from_rational(x, precision).sqrt().expect(NOT_NEGATIVE);
        let mean = root(&self.mean_squared) * &Interval::integer(self.mean_sign.value().into());
        let spread = root(&self.discriminant);
        [mean.clone() + &spread, mean - &spread]
    }

    /// k₁, k₂ within decimal strings as narrow as asked for; both strings are the same where it is a decimal of so many places.
    pub fn decimals(&self, digits: Digits) -> [DecimalEnclosure; 2] {
        if let (Some(mean), Some(spread)) = (rational_root(&self.mean_squared), rational_root(&self.discriminant)) {
            let mean = mean * Rational::from(self.mean_sign.value());
            let [first, second] = [Rational::from(&mean + &spread), mean - spread];
            return [first, second].map(|k| DecimalEnclosure::of(&k, digits));
        }
        // Each doubling halves the widths at least, so one precision is enough in the end.
        let mut precision = 64 + 4 * digits.count();
        loop {
            let [first, second] = self.enclosure(precision);
            if let (Some(first), Some(second)) = (first.decimals(digits), second.decimals(digits)) {
                return [first, second];
            }
            precision *= 2;
        }
    }
}

/// √x, where it is rational; x ≥ 0.
fn rational_root(x: &Rational) -> Option<Rational> {
    let (n, d) = (x.numer(), x.denom());
    let is_square = n.is_perfect_square() && d.is_perfect_square();
    is_square.then(|| Rational::from((n.clone().sqrt(), d.clone().sqrt())))
}

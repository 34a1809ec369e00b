//! Principal curvatures from K and H.

use crate::number::decimal::{DecimalEnclosure, Digits};
use crate::number::{Interval, Rational, Sign, Surd};

/// k₁ ≥ k₂, the roots of k² − 2Hk + K: k = H ± √(H² − K), where H is a square root of a rational. CU-4.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-4")]
pub struct Principal {
    mean: Surd,
    /// √(H² − K) ≥ 0.
    spread: Surd,
}

impl Principal {
    /// From the sign of H, H² and K.
    ///
    /// # Panics
    /// Iff H² < K, which no pair of real principal curvatures has.
    pub fn new(mean_sign: Sign, mean_squared: &Rational, gaussian: &Rational) -> Principal {
        let message = "(k₁ − k₂)² is not negative";
        let mean = Surd::new(Rational::new(), Rational::from(mean_sign.value()), mean_squared).expect(message);
        let spread = Surd::sqrt(&Rational::from(mean_squared - gaussian)).expect(message);
        Principal { mean, spread }
    }

    /// H.
    pub fn mean(&self) -> &Surd {
        &self.mean
    }

    /// (k₁ − k₂)/2.
    pub fn spread(&self) -> &Surd {
        &self.spread
    }

    /// k₁, k₂ in one field ℚ(√d); `None` where H and √(H² − K) lie in different ones.
    pub fn exact(&self) -> Option<[Surd; 2]> {
        Some([self.mean.checked_add(&self.spread).ok()?, self.mean.checked_sub(&self.spread).ok()?])
    }

    /// k₁, k₂ within intervals of that precision.
    pub fn enclosure(&self, precision: u32) -> [Interval; 2] {
        let (mean, spread) = (self.mean.enclosure(precision), self.spread.enclosure(precision));
        [mean.clone() + &spread, mean - &spread]
    }

    /// k₁, k₂ within decimal strings as narrow as asked for.
    pub fn decimals(&self, digits: Digits) -> [DecimalEnclosure; 2] {
        if let Some(exact) = self.exact() {
            return exact.map(|k| k.decimals(digits));
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

//! Signals on all of ℤ: the bounded solution of the interpolation problem, in ℚ(√3).

use super::basis::{split, weights};
use crate::number::{Integer, Rational, Ring, Surd};
use std::collections::BTreeMap;

/// A signal on ℤ that is 0 but at finitely many places.
pub type Samples = BTreeMap<Integer, Rational>;

/// z = −2 + √3, the root of z² + 4z + 1 with |z| < 1.
pub fn pole() -> Surd {
    Surd::new(Rational::from(-2), Rational::from(1), &Rational::from(3)).expect("3 is not negative")
}

/// h\[k] = −6z/(1 − z²) · z^|k| = √3 z^|k|: the bounded inverse of [1/6 4/6 1/6]. SP-4.
#[doc(alias = "SP-4")]
#[doc(alias = "SP-39")]
pub fn inverse_filter(distance: u32) -> Surd {
    let root = Surd::sqrt(&Rational::from(3)).expect("3 is not negative");
    root * &power(&pole(), distance)
}

/// xⁿ by squaring.
fn power(x: &Surd, n: u32) -> Surd {
    (0..u32::BITS - n.leading_zeros()).rev().fold(Surd::integer(1), |power, bit| {
        let square = power.clone() * &power;
        if n >> bit & 1 == 1 { square * x } else { square }
    })
}

/// c\[k] = Σ h\[k − j] g\[j], the only bounded coefficients whose spline takes the values g on ℤ. SP-4, SP-34.
///
/// `None` where k is more than 2³² − 1 away from a sample.
#[doc(alias = "SP-34")]
pub fn coefficient(samples: &Samples, k: &Integer) -> Option<Surd> {
    samples.iter().try_fold(Surd::integer(0), |sum, (j, g)| {
        let distance = Integer::from(k - j).abs().to_u32()?;
        Some(sum + &(inverse_filter(distance) * &Surd::from(g.clone())))
    })
}

/// f⁽ⁿ⁾(x), n = 0, 1 or 2, of the spline with these coefficients. SP-4.
///
/// `None` where x is more than 2³² − 3 away from a sample.
///
/// # Panics
/// Iff n > 2.
pub fn derivative(samples: &Samples, x: &Rational, n: u32) -> Option<Surd> {
    let (floor, t) = split(x);
    let mut sum = Surd::integer(0);
    for (m, weight) in weights(&t, n).into_iter().enumerate() {
        let c = coefficient(samples, &(Integer::from(&floor + m) - 1_u32))?;
        sum = sum + &(c * &Surd::from(weight));
    }
    Some(sum)
}

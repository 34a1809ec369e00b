//! Numbers with an infinitesimal part: a₀ + a₁ε + a₂ε² + …, ordered for every small enough ε > 0.

use super::{Enclosure, Ring, Sign};
use std::ops::{Add, Mul, Neg, Sub};

/// A polynomial in a positive infinitesimal ε. Its sign is that of its lowest non-zero coefficient,
/// which is its sign for every small enough ε > 0 (NU-9).
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "NU-9")]
pub struct Perturbed<K> {
    /// Coefficients, the constant first; empty is zero.
    coefficients: Vec<K>,
}

impl<K: Enclosure> Perturbed<K> {
    /// a + bε.
    pub fn new(a: K, b: K) -> Perturbed<K> {
        Perturbed { coefficients: vec![a, b] }
    }

    /// The limit for ε → 0.
    pub fn limit(&self) -> K {
        self.coefficients.first().cloned().unwrap_or_else(|| K::integer(0))
    }
}

fn merge<K: Clone>(mut a: Vec<K>, b: &[K], both: impl Fn(K, &K) -> K, alone: impl Fn(&K) -> K) -> Vec<K> {
    for (x, y) in a.iter_mut().zip(b) {
        *x = both(x.clone(), y);
    }
    let shared = a.len();
    a.extend(b.iter().skip(shared).map(alone));
    a
}

impl<K: Enclosure> Add<&Perturbed<K>> for Perturbed<K> {
    type Output = Perturbed<K>;
    fn add(self, other: &Perturbed<K>) -> Perturbed<K> {
        Perturbed { coefficients: merge(self.coefficients, &other.coefficients, |a, b| a + b, K::clone) }
    }
}

impl<K: Enclosure> Sub<&Perturbed<K>> for Perturbed<K> {
    type Output = Perturbed<K>;
    fn sub(self, other: &Perturbed<K>) -> Perturbed<K> {
        Perturbed { coefficients: merge(self.coefficients, &other.coefficients, |a, b| a - b, |b| -b.clone()) }
    }
}

impl<K: Enclosure> Mul<&Perturbed<K>> for Perturbed<K> {
    type Output = Perturbed<K>;
    fn mul(self, other: &Perturbed<K>) -> Perturbed<K> {
        let (a, b) = (&self.coefficients, &other.coefficients);
        if a.is_empty() || b.is_empty() {
            return Perturbed { coefficients: Vec::new() };
        }
        let mut coefficients = vec![K::integer(0); a.len() + b.len() - 1];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                coefficients[i + j] = coefficients[i + j].clone() + &(x.clone() * y);
            }
        }
        Perturbed { coefficients }
    }
}

impl<K: Enclosure> Neg for Perturbed<K> {
    type Output = Perturbed<K>;
    fn neg(self) -> Perturbed<K> {
        Perturbed { coefficients: self.coefficients.into_iter().map(|a| -a).collect() }
    }
}

impl<K: Enclosure> Ring for Perturbed<K> {
    fn integer(n: i64) -> Perturbed<K> {
        Perturbed { coefficients: vec![K::integer(n)] }
    }
}

impl<K: Enclosure> Enclosure for Perturbed<K> {
    fn known_sign(&self) -> Option<Sign> {
        for a in &self.coefficients {
            match a.known_sign() {
                Some(Sign::Zero) => {}
                decided => return decided,
            }
        }
        Some(Sign::Zero)
    }
}

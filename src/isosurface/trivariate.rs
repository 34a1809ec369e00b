//! Polynomials in x, y, z with rational coefficients.

use crate::number::{Integer, Rational, Ring};
use std::collections::BTreeMap;
use std::ops::{Add, Mul, Neg, Sub};

/// A polynomial in three variables: its non-zero coefficients by their exponents.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Trivariate {
    terms: BTreeMap<[u32; 3], Rational>,
}

impl Trivariate {
    /// The sum of these terms.
    pub fn new(terms: impl IntoIterator<Item = ([u32; 3], Rational)>) -> Trivariate {
        let mut sum = Trivariate::default();
        for (exponents, coefficient) in terms {
            sum.add_term(exponents, &coefficient);
        }
        sum
    }

    /// A constant.
    pub fn constant(value: Rational) -> Trivariate {
        Trivariate::new([([0, 0, 0], value)])
    }

    /// x, y or z.
    ///
    /// # Panics
    /// Iff the axis is none of 0, 1, 2.
    pub fn variable(axis: usize) -> Trivariate {
        let mut exponents = [0; 3];
        exponents[axis] = 1;
        Trivariate::new([(exponents, Rational::from(1))])
    }

    fn add_term(&mut self, exponents: [u32; 3], coefficient: &Rational) {
        let sum = self.terms.entry(exponents).or_default();
        *sum += coefficient;
        if sum.is_zero() {
            self.terms.remove(&exponents);
        }
    }

    /// The non-zero terms, by their exponents.
    pub fn terms(&self) -> impl Iterator<Item = ([u32; 3], &Rational)> {
        self.terms.iter().map(|(exponents, coefficient)| (*exponents, coefficient))
    }

    /// Whether all coefficients are zero.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The degree in each variable; that of zero is 0.
    pub fn degrees(&self) -> [u32; 3] {
        [0, 1, 2].map(|axis| self.terms.keys().map(|exponents| exponents[axis]).max().unwrap_or(0))
    }

    /// The value at a point.
    pub fn evaluate(&self, at: &[Rational; 3]) -> Rational {
        let power = |x: &Rational, n: u32| (0..n).fold(Rational::from(1), |power, _| power * x);
        self.terms().fold(Rational::new(), |sum, (exponents, coefficient)| {
            let product = |product: Rational, axis: usize| product * power(&at[axis], exponents[axis]);
            sum + (0..3).fold(coefficient.clone(), product)
        })
    }

    /// The partial derivative along an axis.
    ///
    /// # Panics
    /// Iff the axis is none of 0, 1, 2.
    pub fn derivative(&self, axis: usize) -> Trivariate {
        Trivariate::new(self.terms().filter(|(exponents, _)| exponents[axis] > 0).map(
            |(mut exponents, coefficient)| {
                let factor = Integer::from(exponents[axis]);
                exponents[axis] -= 1;
                (exponents, coefficient.clone() * factor)
            },
        ))
    }
}

impl Add<&Trivariate> for Trivariate {
    type Output = Trivariate;
    fn add(mut self, other: &Trivariate) -> Trivariate {
        for (exponents, coefficient) in other.terms() {
            self.add_term(exponents, coefficient);
        }
        self
    }
}

impl Neg for Trivariate {
    type Output = Trivariate;
    fn neg(self) -> Trivariate {
        Trivariate { terms: self.terms.into_iter().map(|(exponents, coefficient)| (exponents, -coefficient)).collect() }
    }
}

impl Sub<&Trivariate> for Trivariate {
    type Output = Trivariate;
    fn sub(self, other: &Trivariate) -> Trivariate {
        self + &-other.clone()
    }
}

impl Mul<&Trivariate> for Trivariate {
    type Output = Trivariate;
    fn mul(self, other: &Trivariate) -> Trivariate {
        Trivariate::new(self.terms().flat_map(|(a, f)| {
            other.terms().map(move |(b, g)| ([0, 1, 2].map(|axis| a[axis] + b[axis]), Rational::from(f * g)))
        }))
    }
}

impl Ring for Trivariate {
    fn integer(n: i64) -> Trivariate {
        Trivariate::constant(Rational::from(n))
    }
}

//! Polynomials in several variables with rational coefficients.

use super::{Integer, Rational, Ring};
use std::collections::BTreeMap;
use std::ops::{Add, Mul, Neg, Sub};

/// A polynomial in N variables: its non-zero coefficients by their exponents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Multivariate<const N: usize> {
    terms: BTreeMap<[u32; N], Rational>,
}

/// A polynomial in x, y and z.
pub type Trivariate = Multivariate<3>;

impl<const N: usize> Multivariate<N> {
    /// The sum of these terms.
    pub fn new(terms: impl IntoIterator<Item = ([u32; N], Rational)>) -> Multivariate<N> {
        let mut sum = Multivariate { terms: BTreeMap::new() };
        for (exponents, coefficient) in terms {
            sum.add_term(exponents, &coefficient);
        }
        sum
    }

    /// A constant.
    pub fn constant(value: Rational) -> Multivariate<N> {
        Multivariate::new([([0; N], value)])
    }

    /// The variable of an axis: x, y, z, …
    ///
    /// # Panics
    /// Iff there is no such axis.
    pub fn variable(axis: usize) -> Multivariate<N> {
        let mut exponents = [0; N];
        exponents[axis] = 1;
        Multivariate::new([(exponents, Rational::from(1))])
    }

    fn add_term(&mut self, exponents: [u32; N], coefficient: &Rational) {
        let sum = self.terms.entry(exponents).or_default();
        *sum += coefficient;
        if sum.is_zero() {
            self.terms.remove(&exponents);
        }
    }

    /// The non-zero terms, by their exponents.
    pub fn terms(&self) -> impl Iterator<Item = ([u32; N], &Rational)> {
        self.terms.iter().map(|(exponents, coefficient)| (*exponents, coefficient))
    }

    /// Whether all coefficients are zero.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The degree in each variable; that of zero is 0.
    pub fn degrees(&self) -> [u32; N] {
        std::array::from_fn(|axis| self.terms.keys().map(|exponents| exponents[axis]).max().unwrap_or(0))
    }

    /// The value at a point.
    pub fn evaluate(&self, at: &[Rational; N]) -> Rational {
        self.evaluate_in(at, Rational::clone)
    }

    /// The value at a point of another ring, into which `embed` takes the coefficients: a jet, an interval, a root.
    pub fn evaluate_in<K: Ring>(&self, at: &[K; N], embed: impl Fn(&Rational) -> K) -> K {
        let powers = self.powers(at);
        self.terms().fold(K::integer(0), |sum, (exponents, coefficient)| {
            let factors = exponents.iter().zip(&powers).filter(|(n, _)| **n > 0);
            sum + &factors.fold(embed(coefficient), |product, (n, powers)| product * &powers[*n as usize])
        })
    }

    /// The powers of each coordinate that the terms need: x⁰, x¹, …
    fn powers<K: Ring>(&self, at: &[K; N]) -> [Vec<K>; N] {
        let degrees = self.degrees();
        std::array::from_fn(|axis| {
            let mut powers = vec![K::integer(1)];
            for n in 0..degrees[axis] as usize {
                powers.push(powers[n].clone() * &at[axis]);
            }
            powers
        })
    }

    /// The partial derivative along an axis.
    ///
    /// # Panics
    /// Iff there is no such axis.
    pub fn derivative(&self, axis: usize) -> Multivariate<N> {
        Multivariate::new(self.terms().filter(|(exponents, _)| exponents[axis] > 0).map(
            |(mut exponents, coefficient)| {
                let factor = Integer::from(exponents[axis]);
                exponents[axis] -= 1;
                (exponents, coefficient.clone() * factor)
            },
        ))
    }
}

impl<const N: usize> Add<&Multivariate<N>> for Multivariate<N> {
    type Output = Multivariate<N>;
    fn add(mut self, other: &Multivariate<N>) -> Multivariate<N> {
        for (exponents, coefficient) in other.terms() {
            self.add_term(exponents, coefficient);
        }
        self
    }
}

impl<const N: usize> Neg for Multivariate<N> {
    type Output = Multivariate<N>;
    fn neg(self) -> Multivariate<N> {
        Multivariate {
            terms: self.terms.into_iter().map(|(exponents, coefficient)| (exponents, -coefficient)).collect(),
        }
    }
}

impl<const N: usize> Sub<&Multivariate<N>> for Multivariate<N> {
    type Output = Multivariate<N>;
    fn sub(self, other: &Multivariate<N>) -> Multivariate<N> {
        self + &-other.clone()
    }
}

impl<const N: usize> Mul<&Multivariate<N>> for Multivariate<N> {
    type Output = Multivariate<N>;
    fn mul(self, other: &Multivariate<N>) -> Multivariate<N> {
        Multivariate::new(self.terms().flat_map(|(a, f)| {
            other.terms().map(move |(b, g)| (std::array::from_fn(|axis| a[axis] + b[axis]), Rational::from(f * g)))
        }))
    }
}

impl<const N: usize> Ring for Multivariate<N> {
    fn integer(n: i64) -> Multivariate<N> {
        Multivariate::constant(Rational::from(n))
    }
}

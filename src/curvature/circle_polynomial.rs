//! Polynomials in cos t and sin t, exactly: the ring ℚ[c, s, …]/(c² + s² − 1) with c′ = −s, s′ = c.

use super::rational_curve::Period;
use crate::number::{Multivariate, Polynomial, Rational, Ring};
use std::ops::{Add, Mul, Neg, Sub};

/// A polynomial in c = cos t, s = sin t, and N − 2 constants, of degree at most 1 in c. CU-17.
///
/// Two are equal iff they are the same function of t and the constants: c² + s² − 1 divides every polynomial that is 0 on the circle.
/// So an identity here is one for all t.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-17")]
#[doc(alias = "CU-49")]
pub struct CirclePolynomial<const N: usize>(Multivariate<N>);

impl<const N: usize> CirclePolynomial<N> {
    /// The function of a polynomial in cos t, sin t and the constants.
    pub fn new(f: &Multivariate<N>) -> CirclePolynomial<N> {
        let s = Multivariate::<N>::variable(1);
        let c_squared = Multivariate::<N>::integer(1) - &(s.clone() * &s);
        let reduced = f.terms().map(|(mut exponents, coefficient)| {
            let pairs = exponents[0] / 2;
            exponents[0] %= 2;
            (0..pairs).fold(Multivariate::new([(exponents, coefficient.clone())]), |f, _| f * &c_squared)
        });
        CirclePolynomial(reduced.fold(Multivariate::integer(0), |sum, term| sum + &term))
    }

    /// cos t, sin t, and the constants.
    pub fn variables() -> [CirclePolynomial<N>; N] {
        std::array::from_fn(|axis| CirclePolynomial(Multivariate::variable(axis)))
    }

    /// In normal form.
    pub fn polynomial(&self) -> &Multivariate<N> {
        &self.0
    }

    /// d/dt: −s·∂f/∂c + c·∂f/∂s. CU-23.
    #[doc(alias = "CU-23")]
    pub fn derivative(&self) -> CirclePolynomial<N> {
        let (c, s) = (Multivariate::<N>::variable(0), Multivariate::<N>::variable(1));
        CirclePolynomial::new(&(self.0.derivative(1) * &c - &(self.0.derivative(0) * &s)))
    }

    /// The value at (cos t, sin t) = ((1 − m²)/(1 + m²), 2m/(1 + m²)), the constants given.
    ///
    /// # Panics
    /// Iff there are not N − 2 constants.
    pub fn at_slope(&self, m: &Rational, constants: &[Rational]) -> Rational {
        let square = Rational::from(m.square_ref());
        let norm = Rational::from(&square + 1_u32);
        let circle = [(1_u32 - square) / &norm, Rational::from(m * 2_u32) / &norm];
        self.at(circle, constants)
    }

    /// The value at t = kπ/2, the constants given.
    ///
    /// # Panics
    /// Iff there are not N − 2 constants.
    pub fn at_quarter_turns(&self, k: i64, constants: &[Rational]) -> Rational {
        let circle = [[1, 0], [0, 1], [-1, 0], [0, -1]][k.rem_euclid(4) as usize];
        self.at(circle.map(Rational::from), constants)
    }

    fn at(&self, circle: [Rational; 2], constants: &[Rational]) -> Rational {
        let at: Vec<Rational> = circle.into_iter().chain(constants.iter().cloned()).collect();
        self.0.evaluate(&at.try_into().expect("there are N − 2 constants"))
    }
}

impl CirclePolynomial<2> {
    /// The k ≥ 0 for which cos kt or sin kt is in the Fourier series. CU-44.
    #[doc(alias = "CU-44")]
    pub fn harmonics(&self) -> Vec<usize> {
        // With z = e^(it), c = (z² + 1)/2z and s = (z² − 1)/2iz; i^j is real for even j, so the two sums do not meet.
        let power = |sign: i64, n: u32| {
            let base = Polynomial::new([sign, 0, 1].map(Rational::from).to_vec());
            (0..n).fold(Polynomial::integer(1), |product, _| product * &base)
        };
        let degree = self.0.terms().map(|(e, _)| (e[0] + e[1]) as usize).max().unwrap_or(0);
        let mut sums = [Polynomial::new(Vec::new()), Polynomial::new(Vec::new())];
        for ([i, j], coefficient) in self.0.terms() {
            // c^i s^j = … / (2^(i+j) i^j z^(i+j)), all over z^degree; i^−j is ±1 or ±i.
            let n = (i + j) as usize;
            let sign = [1, -1, -1, 1][(j % 4) as usize];
            let mut factor = vec![Rational::new(); degree - n + 1];
            factor[degree - n] = Rational::from(coefficient * sign) >> (i + j);
            let of = (j % 2) as usize;
            sums[of] = sums[of].clone() + &(power(1, i) * &power(-1, j) * &Polynomial::new(factor));
        }
        let has = |k: &usize| sums.iter().any(|sum| sum.coefficients().get(degree + k).is_some_and(|a| !a.is_zero()));
        (0..=degree).filter(has).collect()
    }
}

/// The least ρ > 0 with α(t + ρ) = α(t) for all t, α being these functions of ωt: 2π/(|ω|g), g the greatest common divisor of the
/// harmonics. CU-11, CU-44.
pub fn least_period(curve: &[CirclePolynomial<2>; 2], frequency: &Rational) -> Period {
    let gcd = |a: usize, b: usize| {
        let (mut a, mut b) = (a, b);
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    let g = curve.iter().flat_map(CirclePolynomial::harmonics).fold(0, gcd);
    let turns = Rational::from(frequency.abs_ref()) * g as u64;
    if turns.is_zero() { Period::EveryNumber } else { Period::Turns(turns.recip()) }
}

impl<const N: usize> Add<&CirclePolynomial<N>> for CirclePolynomial<N> {
    type Output = CirclePolynomial<N>;
    fn add(self, other: &CirclePolynomial<N>) -> CirclePolynomial<N> {
        CirclePolynomial(self.0 + &other.0)
    }
}

impl<const N: usize> Sub<&CirclePolynomial<N>> for CirclePolynomial<N> {
    type Output = CirclePolynomial<N>;
    fn sub(self, other: &CirclePolynomial<N>) -> CirclePolynomial<N> {
        CirclePolynomial(self.0 - &other.0)
    }
}

impl<const N: usize> Mul<&CirclePolynomial<N>> for CirclePolynomial<N> {
    type Output = CirclePolynomial<N>;
    fn mul(self, other: &CirclePolynomial<N>) -> CirclePolynomial<N> {
        CirclePolynomial::new(&(self.0 * &other.0))
    }
}

impl<const N: usize> Neg for CirclePolynomial<N> {
    type Output = CirclePolynomial<N>;
    fn neg(self) -> CirclePolynomial<N> {
        CirclePolynomial(-self.0)
    }
}

impl<const N: usize> Ring for CirclePolynomial<N> {
    fn integer(n: i64) -> CirclePolynomial<N> {
        CirclePolynomial(Multivariate::integer(n))
    }
}

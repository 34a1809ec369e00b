//! Polynomials in the sines and cosines of two angles, exactly: ℚ[c, s, c′, s′, …] modulo c² + s² = 1 and c′² + s′² =
//! 1.

use super::jet::Jet;
use crate::linear::{Matrix, Vector};
use crate::number::{Multivariate, Rational, Ring};
use std::ops::{Add, Mul, Neg, Sub};

/// One of the two angles, the parameters of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Angle {
    /// The first parameter, such as θ.
    First,
    /// The second parameter, such as φ.
    Second,
}

impl Angle {
    /// Both, in order.
    pub const BOTH: [Angle; 2] = [Angle::First, Angle::Second];

    /// The axis of its cosine; that of its sine is the next one.
    const fn cosine_axis(self) -> usize {
        match self {
            Angle::First => 0,
            Angle::Second => 2,
        }
    }
}

/// A polynomial in cos θ, sin θ, cos φ, sin φ and N − 4 further variables, such as a radius.
///
/// Normal form: sin² = 1 − cos² leaves each sine with the exponent 0 or 1. Two of them are equal iff they are the same
/// function of the angles and the further variables, for 1 and sin θ are independent over ℚ(cos θ). CU-50.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-50")]
pub struct Trigonometric<const N: usize>(Multivariate<N>);

impl<const N: usize> Trigonometric<N> {
    /// There are two angles, so N ≥ 4.
    const ANGLES: () = assert!(N >= 4, "the first four variables are the cosines and sines");

    /// The function of a polynomial in (cos θ, sin θ, cos φ, sin φ, …).
    pub fn new(polynomial: Multivariate<N>) -> Trigonometric<N> {
        let () = Self::ANGLES;
        Trigonometric(Angle::BOTH.into_iter().fold(polynomial, |f, angle| reduced(&f, angle)))
    }

    /// cos of the angle.
    pub fn cos(angle: Angle) -> Trigonometric<N> {
        Trigonometric::new(Multivariate::variable(angle.cosine_axis()))
    }

    /// sin of the angle.
    pub fn sin(angle: Angle) -> Trigonometric<N> {
        Trigonometric::new(Multivariate::variable(angle.cosine_axis() + 1))
    }

    /// The further variable of that number, from 0.
    ///
    /// # Panics
    /// Iff there is no such variable.
    pub fn parameter(number: usize) -> Trigonometric<N> {
        Trigonometric::new(Multivariate::variable(number + 4))
    }

    /// A constant.
    pub fn constant(value: Rational) -> Trigonometric<N> {
        Trigonometric::new(Multivariate::constant(value))
    }

    /// In normal form.
    pub fn polynomial(&self) -> &Multivariate<N> {
        &self.0
    }

    /// The derivative by an angle: cos′ = −sin, sin′ = cos.
    pub fn derivative(&self, angle: Angle) -> Trigonometric<N> {
        let axis = angle.cosine_axis();
        let [c, s] = [axis, axis + 1].map(Multivariate::<N>::variable);
        Trigonometric::new(self.0.derivative(axis + 1) * &c - &(self.0.derivative(axis) * &s))
    }

    /// The derivative by the further variable of that number, from 0.
    ///
    /// # Panics
    /// Iff there is no such variable.
    pub fn derivative_by_parameter(&self, number: usize) -> Trigonometric<N> {
        Trigonometric(self.0.derivative(number + 4))
    }

    /// Its jet in the two angles, as functions.
    pub fn jet(&self) -> Jet<Trigonometric<N>, 2> {
        let gradient = Angle::BOTH.map(|angle| self.derivative(angle));
        let hessian = Matrix::from_fn(|i, j| gradient[i].derivative(Angle::BOTH[j]));
        Jet { value: self.clone(), gradient: Vector(gradient), hessian }
    }

    /// The value where cosines, sines and further variables are these.
    ///
    /// # Panics
    /// Iff a cosine and its sine are on no unit circle.
    pub fn evaluate(&self, at: &[Rational; N]) -> Rational {
        for axis in Angle::BOTH.map(Angle::cosine_axis) {
            let norm = Rational::from(at[axis].square_ref()) + Rational::from(at[axis + 1].square_ref());
            assert!(norm == 1, "cos² + sin² is {norm}, not 1");
        }
        self.0.evaluate(at)
    }
}

/// (cos, sin) = ((1 − m²)/(1 + m²), 2m/(1 + m²)), at tan of half the angle = m: every rational point of the circle but
/// (−1, 0).
pub fn circle_point(m: &Rational) -> [Rational; 2] {
    let square = Rational::from(m.square_ref());
    let scale = Rational::from(&square + 1).recip();
    [(Rational::from(1) - square) * &scale, Rational::from(m * 2) * scale]
}

/// With sin² = 1 − cos² as long as there is a sin².
fn reduced<const N: usize>(f: &Multivariate<N>, angle: Angle) -> Multivariate<N> {
    let [cosine, sine] = [angle.cosine_axis(), angle.cosine_axis() + 1];
    let square = Multivariate::constant(Rational::from(1))
        - &(Multivariate::<N>::variable(cosine) * &Multivariate::variable(cosine));
    f.terms().fold(Multivariate::integer(0), |sum, (mut exponents, coefficient)| {
        let squares = exponents[sine] / 2;
        exponents[sine] %= 2;
        let rest = Multivariate::new([(exponents, coefficient.clone())]);
        sum + &(0..squares).fold(rest, |product, _| product * &square)
    })
}

impl<const N: usize> Add<&Trigonometric<N>> for Trigonometric<N> {
    type Output = Trigonometric<N>;
    fn add(self, other: &Trigonometric<N>) -> Trigonometric<N> {
        Trigonometric(self.0 + &other.0)
    }
}

impl<const N: usize> Sub<&Trigonometric<N>> for Trigonometric<N> {
    type Output = Trigonometric<N>;
    fn sub(self, other: &Trigonometric<N>) -> Trigonometric<N> {
        Trigonometric(self.0 - &other.0)
    }
}

impl<const N: usize> Mul<&Trigonometric<N>> for Trigonometric<N> {
    type Output = Trigonometric<N>;
    fn mul(self, other: &Trigonometric<N>) -> Trigonometric<N> {
        Trigonometric::new(self.0 * &other.0)
    }
}

impl<const N: usize> Neg for Trigonometric<N> {
    type Output = Trigonometric<N>;
    fn neg(self) -> Trigonometric<N> {
        Trigonometric(-self.0)
    }
}

impl<const N: usize> Ring for Trigonometric<N> {
    fn integer(n: i64) -> Trigonometric<N> {
        Trigonometric::constant(Rational::from(n))
    }
}

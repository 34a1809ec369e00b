//! Curves by rational functions of a parameter: where they are defined, regular and closed.

use super::jet::Jet;
use crate::linear::{Matrix, Vector};
use crate::number::{Algebraic, Polynomial, Rational, Ring, Sign, SturmChain, real_roots};
use std::cmp::Ordering;
use thiserror::Error;

/// The denominator is the zero polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the denominator is zero everywhere")]
pub struct ZeroDenominator;

/// A curve α = (p₁, …, p_D)/q by polynomials of t, in lowest terms and q monic: its poles are the roots of q. CU-9.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-9")]
pub struct RationalCurve<const D: usize> {
    numerators: [Polynomial; D],
    denominator: Polynomial,
}

/// An end of an open interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// A number.
    At(Rational),
    /// −∞.
    MinusInfinity,
    /// +∞.
    PlusInfinity,
}

/// Whether a curve on an open interval is closed. CU-10.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-10")]
pub enum Closing<const D: usize> {
    /// Both limits are this point.
    Closed(Vector<Rational, D>),
    /// The limits, which differ.
    Open(Vector<Rational, D>, Vector<Rational, D>),
    /// There is no limit at one end, or at both.
    NoLimit,
}

/// Where a curve is not regular. CU-30.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-8")]
#[doc(alias = "CU-14")]
#[doc(alias = "CU-18")]
#[doc(alias = "CU-30")]
pub enum SingularParameters {
    /// At these parameters, in increasing order; nowhere if there are none.
    At(Vec<Algebraic>),
    /// Everywhere: the curve is one point.
    Everywhere,
}

impl<const D: usize> RationalCurve<D> {
    /// (p₁, …, p_D)/q; a common factor is divided out, and with it a pole that is none.
    ///
    /// # Errors
    /// iff q is the zero polynomial.
    pub fn new(numerators: [Polynomial; D], denominator: Polynomial) -> Result<RationalCurve<D>, ZeroDenominator> {
        if denominator.is_zero() {
            return Err(ZeroDenominator);
        }
        let common = numerators.iter().fold(denominator.clone(), |g, p| g.gcd(p));
        let without = |p: &Polynomial| p.divide(&common).expect("it divides q, which is not 0").0;
        // A monic denominator: then equal curves are equal records.
        let leading = without(&denominator).coefficients().last().cloned().expect("q is not 0");
        let common = common * &Polynomial::new(vec![leading]);
        let without = |p: &Polynomial| p.divide(&common).expect("it divides q, which is not 0").0;
        Ok(RationalCurve { numerators: numerators.each_ref().map(without), denominator: without(&denominator) })
    }

    /// (p₁, …, p_D).
    pub fn polynomial(numerators: [Polynomial; D]) -> RationalCurve<D> {
        RationalCurve { numerators, denominator: Polynomial::integer(1) }
    }

    /// p₁, …, p_D.
    pub fn numerators(&self) -> &[Polynomial; D] {
        &self.numerators
    }

    /// q.
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// α(t); `None` iff t is a pole.
    pub fn point(&self, t: &Rational) -> Option<Vector<Rational, D>> {
        let q = self.denominator.evaluate(t);
        (!q.is_zero()).then(|| Vector(self.numerators.each_ref().map(|p| p.evaluate(t) / &q)))
    }

    /// q²α′ = p′q − pq′, by coordinates. CU-30.
    pub fn velocity_numerators(&self) -> [Polynomial; D] {
        let q = &self.denominator;
        let slope = q.derivative();
        self.numerators.each_ref().map(|p| p.derivative() * q - &(p.clone() * &slope))
    }

    /// α′.
    pub fn derivative(&self) -> RationalCurve<D> {
        let square = self.denominator.clone() * &self.denominator;
        RationalCurve::new(self.velocity_numerators(), square).expect("q is not 0, so q² is not")
    }

    /// The 2-jets of the coordinates at t; `None` iff t is a pole. CU-9.
    pub fn jets(&self, t: &Rational) -> Option<[Jet<Rational, 1>; D]> {
        let (first, second) = (self.derivative(), self.derivative().derivative());
        let (value, first, second) = (self.point(t)?, first.point(t)?, second.point(t)?);
        Some(std::array::from_fn(|i| Jet {
            value: value[i].clone(),
            gradient: Vector([first[i].clone()]),
            hessian: Matrix([[second[i].clone()]]),
        }))
    }

    /// The real parameters with α′ = 0: the common roots of the p′q − pq′, which are no poles. CU-30.
    pub fn singular_parameters(&self) -> SingularParameters {
        // At a root of q of multiplicity m some p is not 0, and there p′q − pq′ has multiplicity m − 1: a pole of order ≥ 2 has to be left out.
        let common = self.velocity_numerators().iter().fold(Polynomial::new(Vec::new()), |g, p| g.gcd(p));
        match real_roots(&common) {
            None => SingularParameters::Everywhere,
            Some(roots) => {
                let is_defined = |t: &Algebraic| t.sign_of(&self.denominator) != Sign::Zero;
                SingularParameters::At(roots.into_iter().filter(is_defined).collect())
            }
        }
    }

    /// The real poles, in increasing order.
    pub fn poles(&self) -> Vec<Algebraic> {
        real_roots(&self.denominator).expect("q is not 0")
    }

    /// Whether α is defined on the closed interval: it has no pole there.
    pub fn is_defined_on(&self, from: &Rational, to: &Rational) -> bool {
        let chain = SturmChain::new(&self.denominator).expect("q is not 0");
        !self.denominator.evaluate(from).is_zero() && chain.count(from, to) == 0
    }

    /// The limit of α at an end; `None` iff there is none. CU-10.
    pub fn limit(&self, end: &End) -> Option<Vector<Rational, D>> {
        match end {
            End::At(t) => self.point(t),
            End::MinusInfinity | End::PlusInfinity => {
                // In lowest terms a rational function has one limit at both infinities, iff deg p ≤ deg q.
                let n = self.denominator.degree().expect("q is not 0");
                let q = self.denominator.coefficients().last().expect("q is not 0");
                let is_bounded = self.numerators.iter().all(|p| p.degree().is_none_or(|m| m <= n));
                let leading =
                    |p: &Polynomial| p.coefficients().get(n).map_or_else(Rational::new, |a| Rational::from(a / q));
                is_bounded.then(|| Vector(self.numerators.each_ref().map(leading)))
            }
        }
    }

    /// Whether the curve on the open interval between these ends is closed. CU-10.
    pub fn closing(&self, from: &End, to: &End) -> Closing<D> {
        match (self.limit(from), self.limit(to)) {
            (Some(a), Some(b)) if a == b => Closing::Closed(a),
            (Some(a), Some(b)) => Closing::Open(a, b),
            (None, _) | (_, None) => Closing::NoLimit,
        }
    }

    /// α∘h for a rational h: the Möbius map, a polynomial, or any other. CU-24, CU-25.
    ///
    /// # Errors
    /// iff h is a constant at which α has a pole.
    #[doc(alias = "CU-24")]
    #[doc(alias = "CU-25")]
    pub fn reparametrised(&self, h: &RationalCurve<1>) -> Result<RationalCurve<D>, ZeroDenominator> {
        let [top] = &h.numerators;
        let bottom = &h.denominator;
        let n = self.numerators.iter().chain([&self.denominator]).filter_map(Polynomial::degree).max().unwrap_or(0);
        // bottomⁿ p(top/bottom)
        let homogeneous = |p: &Polynomial| {
            let zero = Polynomial::new(Vec::new());
            let padded = (0..=n).rev().map(|k| p.coefficients().get(k).cloned().unwrap_or_default());
            let mut power = Polynomial::integer(1);
            padded.fold(zero, |value, a| {
                let next = value * top + &(power.clone() * &Polynomial::new(vec![a]));
                power = power.clone() * bottom;
                next
            })
        };
        RationalCurve::new(self.numerators.each_ref().map(homogeneous), homogeneous(&self.denominator))
    }

    /// M·α + v: a motion where M is orthogonal, a similarity where it is a multiple of such a matrix.
    pub fn moved(&self, m: &Matrix<Rational, D, D>, v: &Vector<Rational, D>) -> RationalCurve<D> {
        let constant = |a: &Rational| Polynomial::new(vec![a.clone()]);
        let row = |i: usize| {
            let terms = self.numerators.iter().zip(&m.0[i]).map(|(p, a)| p.clone() * &constant(a));
            terms.fold(self.denominator.clone() * &constant(&v[i]), |sum, term| sum + &term)
        };
        RationalCurve::new(std::array::from_fn(row), self.denominator.clone()).expect("q is not 0")
    }

    /// α reflected in time: α(−t).
    pub fn reversed(&self) -> RationalCurve<D> {
        let minus = RationalCurve::polynomial([Polynomial::new(vec![Rational::new(), Rational::from(-1)])]);
        self.reparametrised(&minus).expect("−t is no constant")
    }

    /// Whether α has a least period, every positive number for one, or none: a rational function with a period is constant. CU-11.
    #[doc(alias = "CU-11")]
    pub fn period(&self) -> Period {
        let is_constant = self.velocity_numerators().iter().all(Polynomial::is_zero);
        if is_constant { Period::EveryNumber } else { Period::None }
    }
}

/// The periods of a curve on ℝ. CU-11.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Period {
    /// The curve is one point: every ρ > 0 is a period, and there is no least one.
    EveryNumber,
    /// The least period, in multiples of 2π.
    Turns(Rational),
    /// No ρ > 0 is a period.
    None,
}

/// The number of derivatives, the value counted as the 0th, up to which two curves agree at t, that are taken to be the halves t ≤ 0 and t ≥ 0 of
/// one curve: 0 is a jump, 1 continuous, 2 differentiable once, …; `None` iff they are one rational curve, or t is a pole. CU-15.
#[doc(alias = "CU-15")]
pub fn agreeing_derivatives<const D: usize>(
    before: &RationalCurve<D>,
    after: &RationalCurve<D>,
    t: &Rational,
) -> Option<usize> {
    let (mut before, mut after) = (before.clone(), after.clone());
    let mut agreeing = 0;
    if before == after {
        return None;
    }
    // Different rational functions without a pole at t differ in some derivative there.
    loop {
        match before.point(t)?.cmp(&after.point(t)?) {
            Ordering::Equal => agreeing += 1,
            Ordering::Less | Ordering::Greater => return Some(agreeing),
        }
        (before, after) = (before.derivative(), after.derivative());
    }
}

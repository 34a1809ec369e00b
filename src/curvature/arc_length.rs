//! The length of curves: enclosed, and exact where the speed is a polynomial.

use super::circle_polynomial::CirclePolynomial;
use super::crossing::square_root;
use super::quadrature::{Goal, Integral, QuadratureError, integral};
use super::rational_curve::RationalCurve;
use super::series::Series;
use crate::number::{Algebraic, Integer, Interval, Polynomial, Rational, Ring, real_roots};

/// The order of the series for integrals over an interval.
const ORDER: usize = 14;

/// ∫ |α′| dt from t₀ to t, with the sign of t − t₀: the length of the curve between them where t ≥ t₀. CU-19.
///
/// For a rational curve p/q this is ∫ √(Σ(p′q − pq′)²)/q² dt. CU-20: its derivative by t is |α′|.
///
/// # Errors
/// `Pole` iff α has one between the parameters, or at one; `Width` iff the width is ≤ 0.
#[doc(alias = "CU-19")]
#[doc(alias = "CU-20")]
#[doc(alias = "CU-22")]
#[doc(alias = "CU-26")]
#[doc(alias = "CU-27")]
pub fn arc_length<const D: usize>(
    curve: &RationalCurve<D>,
    [t0, t]: [&Rational; 2],
    goal: &Goal,
) -> Result<Integral, QuadratureError> {
    let (from, to) = if t0 <= t { (t0, t) } else { (t, t0) };
    if !curve.is_defined_on(from, to) {
        return Err(QuadratureError::Pole);
    }
    let velocity = curve.velocity_numerators();
    let speed = |[x]: &[Series<1, ORDER>; 1], precision: u32| {
        let of = |p: &Polynomial| Series::of_polynomial(p, x, precision);
        let squared = velocity.iter().map(|v| of(v).square()).reduce(|sum, v| sum + &v)?;
        match curve.denominator().degree() {
            Some(0) => squared.sqrt(),
            Some(_) | None => Some(squared.sqrt()? * &of(curve.denominator()).square().inverse()?),
        }
    };
    let length = integral(speed, &[(from.clone(), to.clone())], goal)?;
    Ok(if t0 <= t { length } else { Integral { value: -length.value, ..length } })
}

/// The length of a trigonometric curve between two angles in turns, t = 2π·turn: ∫ √(x′² + y′²) dt. CU-23, CU-49.
///
/// # Errors
/// `Reversed` iff from > to; `Width` iff the width is ≤ 0.
pub fn length_of_turns(
    curve: &[CirclePolynomial<2>; 2],
    [from, to]: [&Rational; 2],
    goal: &Goal,
) -> Result<Integral, QuadratureError> {
    let velocity = curve.each_ref().map(CirclePolynomial::derivative);
    let speed = |[turn]: &[Series<1, ORDER>; 1], precision: u32| {
        let constant = |a: &Rational| Series::rational(a, precision);
        let full = Series::constant(Interval::pi(precision)) * &Series::integer(2);
        let (s, c) = (turn.clone() * &full).sin_cos();
        let circle = [c, s];
        let [x, y] = velocity.each_ref().map(|f| f.polynomial().evaluate_in(&circle, constant).square());
        Some((x + &y).sqrt()? * &full)
    };
    integral(speed, &[(from.clone(), to.clone())], goal)
}

/// Σ |α(tᵢ₊₁) − α(tᵢ)|: the length of the inscribed polygon, which is no more than the curve's; `None` iff some tᵢ is a pole. CU-29.
#[doc(alias = "CU-29")]
pub fn polygon_length<const D: usize>(
    curve: &RationalCurve<D>,
    parameters: &[Rational],
    precision: u32,
) -> Option<Interval> {
    let points: Vec<_> = parameters.iter().map(|t| curve.point(t)).collect::<Option<_>>()?;
    let side = |pair: &[crate::linear::Vector<Rational, D>]| {
        let squared = (pair[1].clone() + &-pair[0].clone()).norm_squared();
        Interval::from_rational(&squared, precision).sqrt().expect("a sum of squares is not negative")
    };
    Some(points.windows(2).map(side).fold(Interval::integer(0), |sum, side| sum + &side))
}

/// A polynomial curve whose speed |α′| is the absolute value of a polynomial w: that w, with a positive leading coefficient. `None`
/// iff there is no such rational polynomial, or α is no polynomial curve. CU-28.
#[doc(alias = "CU-28")]
pub fn polynomial_speed<const D: usize>(curve: &RationalCurve<D>) -> Option<Polynomial> {
    let is_polynomial = curve.denominator().degree() == Some(0);
    let squared = curve.velocity_numerators().iter().fold(Polynomial::integer(0), |sum, v| sum + &(v.clone() * v));
    if is_polynomial { square_root(&squared) } else { None }
}

/// ∫ p from t₀: the polynomial with the derivative p that is 0 at t₀. CU-21.
#[doc(alias = "CU-21")]
pub fn antiderivative(p: &Polynomial, t0: &Rational) -> Polynomial {
    let terms = p.coefficients().iter().enumerate().map(|(n, a)| Rational::from(a / Integer::from(n + 1)));
    let from_zero = Polynomial::new([Rational::new()].into_iter().chain(terms).collect());
    let constant = Polynomial::new(vec![from_zero.evaluate(t0)]);
    from_zero - &constant
}

/// t(s), the inverse of the arc length from t₀: the parameter at which a curve of a polynomial speed without a real zero has gone s; of either
/// sign. `None` where the speed is no such polynomial. CU-28.
pub fn parameter_at_length<const D: usize>(curve: &RationalCurve<D>, t0: &Rational, s: &Rational) -> Option<Algebraic> {
    let speed = polynomial_speed(curve)?;
    if !real_roots(&speed)?.is_empty() {
        return None;
    }
    // The leading coefficient is positive, and so is the speed everywhere: s is strictly increasing, and takes each value once.
    let reached = antiderivative(&speed, t0) - &Polynomial::new(vec![s.clone()]);
    real_roots(&reached)?.into_iter().next()
}

//! Plane curves by a parametrisation α(t) = (x(t), y(t)).

use super::jet::Jet;
use crate::linear::{Matrix, Vector, determinant2};
use crate::number::{Rational, Ring, Sign};
use thiserror::Error;

/// Why a parametrised curve has no curvature at t.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum CurveError {
    /// The denominator is 0: the curve is not defined there.
    #[error("a pole: the denominator is zero")]
    Pole,
    /// α′ = 0.
    #[error("a singular point: the tangent vector is zero")]
    Singular,
}

/// A regular plane curve at a parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaneCurve {
    /// α.
    pub point: Vector<Rational, 2>,
    /// |α′|² > 0.
    pub speed_squared: Rational,
    /// κ².
    pub kappa_squared: Rational,
    /// The sign of κ: positive where the curve turns counterclockwise.
    pub kappa_sign: Sign,
}

/// det(α′, α″) = x′y″ − x″y′ = κ|α′|³. CU-5.
pub fn kappa_numerator<K: Ring>([x, y]: &[Jet<K, 1>; 2]) -> K {
    let (first, second) = (|f: &Jet<K, 1>| f.gradient[0].clone(), |f: &Jet<K, 1>| f.hessian.0[0][0].clone());
    determinant2(&Matrix([[first(x), second(x)], [first(y), second(y)]]))
}

/// κ = (x′y″ − x″y′)/(x′² + y′²)^(3/2). CU-5.
///
/// # Errors
/// `Singular` iff α′ = 0.
#[doc(alias = "CU-5")]
pub fn curvature(curve: &[Jet<Rational, 1>; 2]) -> Result<PlaneCurve, CurveError> {
    let tangent = Vector(curve.each_ref().map(|f| f.gradient[0].clone()));
    let speed_squared = tangent.norm_squared();
    if speed_squared.is_zero() {
        return Err(CurveError::Singular);
    }
    let numerator = kappa_numerator(curve);
    let kappa_sign = Sign::of(numerator.cmp0());
    let cube = Rational::from(speed_squared.square_ref()) * &speed_squared;
    let kappa_squared = numerator.square() / cube;
    let point = Vector(curve.each_ref().map(|f| f.value.clone()));
    Ok(PlaneCurve { point, speed_squared, kappa_squared, kappa_sign })
}

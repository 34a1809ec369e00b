//! Level curves of a function of two variables.

use super::jet::Jet;
use crate::linear::Vector;
use crate::number::{Rational, Ring, Sign};
use thiserror::Error;

/// The gradient vanishes: the level set has no normal there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("a singular point: the gradient is zero")]
pub struct SingularPoint;

/// A level curve of f at a point, directed with larger f to its left: t = (f_y, −f_x)/|∇f|, n = +∇f/|∇f|.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LevelCurve {
    /// f.
    pub value: Rational,
    /// ∇f ≠ 0.
    pub gradient: Vector<Rational, 2>,
    /// κ².
    pub kappa_squared: Rational,
    /// The sign of κ: positive where the curve bends toward n.
    pub kappa_sign: Sign,
}

/// f_xx f_y² − 2 f_xy f_x f_y + f_yy f_x² = −κ|∇f|³. CU-2.
pub fn kappa_numerator<K: Ring>(jet: &Jet<K, 2>) -> K {
    let ([fx, fy], [[fxx, fxy], [_, fyy]]) = (&jet.gradient.0, &jet.hessian.0);
    let times = |a: &K, b: &K| a.clone() * b;
    let mixed = times(fx, fy) * fxy;
    times(fy, fy) * fxx - &(mixed.clone() + &mixed) + &(times(fx, fx) * fyy)
}

/// The curvature κ = −(f_xx f_y² − 2 f_xy f_x f_y + f_yy f_x²)/|∇f|³ of the level curve through the point. CU-2.
///
/// # Errors
/// iff ∇f = 0.
#[doc(alias = "CU-2")]
pub fn curvature(jet: &Jet<Rational, 2>) -> Result<LevelCurve, SingularPoint> {
    let w = jet.gradient.norm_squared();
    if w.is_zero() {
        return Err(SingularPoint);
    }
    let numerator = -kappa_numerator(jet);
    let kappa_sign = Sign::of(numerator.cmp0());
    let cube = Rational::from(w.square_ref()) * &w;
    let kappa_squared = numerator.square() / cube;
    Ok(LevelCurve { value: jet.value.clone(), gradient: jet.gradient.clone(), kappa_squared, kappa_sign })
}

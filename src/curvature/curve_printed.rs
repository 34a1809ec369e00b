//! What 002 prints of curves where that is wrong, as printed: to be compared with what is right.

use super::area::RationalSurface;
use super::implicit_curve::SingularPoint;
use super::jet::Jet;
use super::quadrature::{Goal, Integral, QuadratureError};
use super::rational_curve::RationalCurve;
use crate::number::{Rational, Surd};

/// The printed κ of (5), −(f_xx f_x² − 2f_xy f_x f_y + f_yy f_y²)/|∇f|³: f_x² and f_y² have changed places. CU-134.
///
/// # Errors
/// iff ∇f = 0.
pub fn level_kappa_printed(jet: &Jet<Rational, 2>) -> Result<Surd, SingularPoint> {
    printed_kappa(jet, -1)
}

/// The other reading of the printed line, with the minus before the first term alone: (−f_xx f_x² − 2f_xy f_x f_y + f_yy f_y²)/|∇f|³. CU-134.
///
/// # Errors
/// iff ∇f = 0.
pub fn level_kappa_printed_first_minus(jet: &Jet<Rational, 2>) -> Result<Surd, SingularPoint> {
    printed_kappa(jet, 1)
}

fn printed_kappa(jet: &Jet<Rational, 2>, others: i32) -> Result<Surd, SingularPoint> {
    let ([fx, fy], [[fxx, fxy], [_, fyy]]) = (&jet.gradient.0, &jet.hessian.0);
    let w = jet.gradient.norm_squared();
    if w.is_zero() {
        return Err(SingularPoint);
    }
    let first = Rational::from(fx.square_ref()) * fxx;
    let mixed = Rational::from(fx * fy) * fxy * 2_u32;
    let last = Rational::from(fy.square_ref()) * fyy;
    let numerator = (last - mixed) * others - first;
    let factor = numerator / &w / &w;
    Ok(Surd::new(Rational::new(), factor, &w).expect("a sum of squares is not negative"))
}

/// The printed κ = 1/r of the circle x² + y² − r² (exercise 3.4), r > 0. CU-136.
pub fn circle_kappa_printed(r: &Rational) -> Rational {
    Rational::from(r.recip_ref())
}

/// The printed arc length s(t) = rt of α(t) = c + r(cos t/r, sin t/r) (example 2.11). CU-45.
pub fn circle_arc_length_printed(r: &Rational, t: &Rational) -> Rational {
    Rational::from(r * t)
}

/// The arc length of α(t) = c + r(cos t/r, sin t/r) from 0: |α′| = 1, so that s(t) = t. CU-45.
#[doc(alias = "CU-45")]
#[doc(alias = "CU-46")]
pub fn circle_arc_length(t: &Rational) -> Rational {
    t.clone()
}

/// The curvature that the text reads from an osculating circle, "o inverso do raio", as its square: 1/R². The sign is not in it. CU-42.
pub fn inverse_radius_squared_printed(radius_squared: &Rational) -> Rational {
    Rational::from(radius_squared.recip_ref())
}

/// The printed length of a curve on a surface, s(t) = ∫₀ᵗ ‖α′(t)‖ dt: from 0, whether or not the curve is defined there. CU-121.
///
/// # Errors
/// As [`RationalSurface::path_length`]: `Pole` where the path has one between 0 and t.
pub fn path_length_printed(
    surface: &RationalSurface,
    path: &RationalCurve<2>,
    t: &Rational,
    goal: &Goal,
) -> Result<Integral, QuadratureError> {
    surface.path_length(path, [&Rational::new(), t], goal)
}

/// The printed domain [0, 2π] of α(t) = c + r(cos t/r, sin t/r) (example 2.11): the number of times it runs around the circle. It is 1 iff r = 1.
/// CU-44.
pub fn circle_turns_printed(r: &Rational) -> Rational {
    Rational::from(r.recip_ref())
}

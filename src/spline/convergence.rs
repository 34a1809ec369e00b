//! How fast the spline through samples of a polynomial converges to it: values, gradients and curvatures, at halved spacings (002, 5(e)).
//!
//! A polynomial is a sum of products of powers, and the spline through samples of a product is the product of the splines of its factors. So the
//! spline on any grid, however fine, is had from a few splines of one variable, exactly.

use super::prefilter::interpolate;
use super::signal::{Boundary, Signal};
use crate::curvature::implicit_curve::SingularPoint;
use crate::curvature::implicit_surface::{LevelSurface, curvature};
use crate::curvature::jet::Jet;
use crate::linear::{Matrix, Vector};
use crate::number::{Integer, Interval, Rational, Trivariate};

/// The precision, in bits, of the enclosures of mean curvatures.
const PRECISION: u32 = 512;

/// The jet at a point of the spline through the samples of a polynomial at the points h·(i, j, k), 0 ≤ i, j, k ≤ n, h = 1/n. SP-92.
///
/// Derivatives are those of the polynomial's own coordinates, not of the grid's.
///
/// # Panics
/// Iff n = 0.
#[doc(alias = "SP-92")]
pub fn spline_jet(f: &Trivariate, n: u32, boundary: Boundary, at: &[Rational; 3]) -> Jet<Rational, 3> {
    assert!(n > 0, "a grid has a cell");
    let degrees = f.degrees();
    let of_power = |axis: usize, power: u32| {
        let samples = (0..=n).map(|k| (0..power).fold(Rational::from(1), |x, _| x * Rational::from((k, n))));
        let signal = Signal::new([n as usize + 1], samples.collect(), boundary).expect("two samples at least");
        let jet = interpolate(&signal).jet(&[Rational::from(&at[axis] * n)]);
        [jet.value, jet.gradient.0[0].clone() * n, jet.hessian.0[0][0].clone() * n * n]
    };
    let powers: [Vec<[Rational; 3]>; 3] =
        std::array::from_fn(|axis| (0..=degrees[axis]).map(|power| of_power(axis, power)).collect());
    let derivative = |axes: &[usize]| {
        f.terms().fold(Rational::new(), |sum, (exponents, coefficient)| {
            sum + (0..3).fold(coefficient.clone(), |product, axis| {
                let order = axes.iter().filter(|a| **a == axis).count();
                product * &powers[axis][exponents[axis] as usize][order]
            })
        })
    };
    Jet {
        value: derivative(&[]),
        gradient: Vector(std::array::from_fn(|i| derivative(&[i]))),
        hessian: Matrix::from_fn(|i, j| derivative(&[i, j])),
    }
}

/// By how much the spline errs at a point, each as a magnitude.
#[derive(Clone, Debug)]
pub struct Errors {
    /// In f.
    pub value: Rational,
    /// In ∇f: the largest of the three.
    pub gradient: Rational,
    /// In the Hessian: the largest of the nine.
    pub hessian: Rational,
    /// In K of the level surface through the point.
    pub gaussian: Rational,
    /// In H, enclosed.
    pub mean: Interval,
}

/// The errors of the spline on a grid of spacing 1/n over [0, 1]³, against the polynomial itself.
///
/// # Errors
/// iff the gradient of one of the two is 0 there.
pub fn errors(f: &Trivariate, n: u32, boundary: Boundary, at: &[Rational; 3]) -> Result<Errors, SingularPoint> {
    let (truth, spline) = (Jet::of_polynomial(f, at), spline_jet(f, n, boundary, at));
    let gap = |a: &Rational, b: &Rational| Rational::from(a - b).abs();
    let largest = |gaps: Vec<Rational>| gaps.into_iter().max().expect("there is one");
    let entries = |jet: &Jet<Rational, 3>| jet.hessian.0.iter().flatten().cloned().collect::<Vec<_>>();
    let all = |a: &[Rational], b: &[Rational]| largest(a.iter().zip(b).map(|(a, b)| gap(a, b)).collect());
    let [of_truth, of_spline] = [curvature(&truth)?, curvature(&spline)?];
    let mean = mean_curvature(&of_spline) - &mean_curvature(&of_truth);
    let mean = if mean.hi().is_sign_negative() { -mean } else { mean };
    Ok(Errors {
        value: gap(&truth.value, &spline.value),
        gradient: all(&truth.gradient.0, &spline.gradient.0),
        hessian: all(&entries(&truth), &entries(&spline)),
        gaussian: gap(&of_truth.gaussian, &of_spline.gaussian),
        mean,
    })
}

/// Around H.
fn mean_curvature(surface: &LevelSurface) -> Interval {
    let root = Interval::from_rational(&surface.mean_squared, PRECISION).sqrt().expect("a square is not negative");
    root * &Interval::from_rational(&Rational::from(surface.mean_sign.value()), PRECISION)
}

/// 100·log₂(coarse/fine), rounded down: the observed order of convergence in hundredths, exactly; `None` unless both errors are positive. SP-93.
#[doc(alias = "SP-93")]
#[doc(alias = "SP-96")]
pub fn order_in_hundredths(coarse: &Rational, fine: &Rational) -> Option<i64> {
    if coarse.cmp0().is_le() || fine.cmp0().is_le() {
        return None;
    }
    let ratio = Rational::from(coarse / fine);
    // ⌊log₂(r¹⁰⁰)⌋. The power of an enclosure settles it but for a ratio within 2⁻²⁴⁰ or so of a root of a power of two.
    let enclosed = Interval::from_rational(&ratio, 256);
    let (lo, hi) = (0..99).fold(enclosed.clone(), |power, _| power * &enclosed).bounds()?;
    match (floor_of_logarithm(lo), floor_of_logarithm(hi)) {
        (low, high) if low == high => Some(low),
        _ => Some(floor_of_logarithm((0..99).fold(ratio.clone(), |power, _| power * &ratio))),
    }
}

/// ⌊log₂ x⌋, x > 0, from the lengths of numerator and denominator.
pub fn floor_of_logarithm(x: Rational) -> i64 {
    let length = |n: &Integer| i64::from(n.significant_bits());
    let estimate = length(x.numer()) - length(x.denom());
    // The estimate is ⌊log₂⌋ or one more.
    let shifted = if estimate >= 0 { x >> estimate as u32 } else { x << estimate.unsigned_abs() as u32 };
    if shifted >= 1 { estimate } else { estimate - 1 }
}

/// The same from enclosures, where they settle it.
pub fn enclosed_order_in_hundredths(coarse: &Interval, fine: &Interval) -> Option<i64> {
    let ((a, b), (c, d)) = (coarse.bounds()?, fine.bounds()?);
    let [low, high] = [order_in_hundredths(&a, &d)?, order_in_hundredths(&b, &c)?];
    (low == high).then_some(low)
}

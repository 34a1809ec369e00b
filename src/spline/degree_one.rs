//! Linear interpolation, and interpolation in S₁.

use super::basis::split;
use super::bspline::b1;
use crate::number::{Integer, Rational};

/// A signal g on ℤ.
pub type OnIntegers<'a> = dyn Fn(&Integer) -> Rational + 'a;

/// f(x) = (1 − t)g\[i] + t·g\[i + 1] with i = ⌊x⌋, t = x − ⌊x⌋. SP-5, SP-6, SP-12.
#[doc(alias = "SP-5")]
#[doc(alias = "SP-6")]
#[doc(alias = "SP-12")]
pub fn interpolate(g: &OnIntegers, x: &Rational) -> Rational {
    let (i, t) = split(x);
    Rational::from(1 - &t) * g(&i) + t * g(&(i + 1))
}

/// g\[k − 1] − 2g\[k] + g\[k + 1], by how much the slope of the linear interpolant changes at k: it is differentiable there
/// iff this is 0. SP-7.
#[doc(alias = "SP-7")]
pub fn slope_change(g: &OnIntegers, k: &Integer) -> Rational {
    g(&Integer::from(k - 1)) + g(&Integer::from(k + 1)) - g(k) * 2
}

/// Σ g\[k]B₁(x − k), (9), and the k whose terms are not zero wherever g is not. SP-13, SP-14, SP-15.
#[doc(alias = "SP-13")]
#[doc(alias = "SP-14")]
#[doc(alias = "SP-15")]
pub fn by_hats(g: &OnIntegers, x: &Rational) -> (Rational, Vec<Integer>) {
    let (i, _) = split(x);
    // B₁(x − k) = 0 unless |x − k| < 1.
    let seen: Vec<Integer> = [i.clone(), i + 1].into_iter().filter(|k| !b1(&Rational::from(x - k)).is_zero()).collect();
    let terms = seen.iter().map(|k| g(k) * b1(&Rational::from(x - k)));
    (terms.fold(Rational::new(), |sum, term| sum + term), seen)
}

//! What 002 says of convergence and of Gauss–Bonnet in 5(e) as printed, and the signals that show where it fails.

use super::coherence::Characteristic;
use super::signal::{Boundary, Signal, SignalError};
use crate::isosurface::volume::{Volume, VolumeError};
use crate::number::Rational;

/// ∫ K dA in units of π/2 as printed, 2πχ for every surface "sem bordo": 4χ. It holds for a compact surface. SP-85.
#[doc(alias = "SP-85")]
pub fn quarter_turns_printed(chi: i64) -> i64 {
    4 * chi
}

/// 2πχ with the χ of the surface in the box and nothing for the border, in units of π/2: what the text's relation is for a surface that is cut off.
pub fn quarter_turns_of_cut_surface_printed(surface: &Characteristic) -> i64 {
    4 * surface.chi
}

/// n + 1 samples a side of z + h²((−1)ⁱ + (−1)ʲ), h = 1/n: within 2h² of z, a plane's, yet the spline's level surfaces have K = ±144/f_z² at every
/// sample, in the coordinates (i, j, k)h. SP-94.
///
/// # Errors
/// As [`Signal::new`]: n = 0.
#[doc(alias = "SP-94")]
pub fn rippled(n: usize) -> Result<Signal<3>, SignalError> {
    let ripple = |i: usize| Rational::from((if i.is_multiple_of(2) { 1 } else { -1 }, n * n));
    let value = |[i, j, k]: [usize; 3]| Rational::from((k, n)) + ripple(i) + ripple(j);
    Signal::new([n + 1; 3], grid(n).map(value).collect(), Boundary::Mirror)
}

/// n + 1 samples a side of z − 1/2 + h/4 + (3h/2)(−1)^(i+j+k), times 4n, h = 1/n, n even: within 2h of a plane's signal, yet the trilinear
/// {g = 0} falls into ever more pieces: χ = 2n² + 3 for n ≥ 4. SP-95.
///
/// # Errors
/// As [`Volume::integers`]: n = 0, or too many samples.
#[doc(alias = "SP-95")]
pub fn speckled(n: usize) -> Result<Volume, VolumeError> {
    let sign = |[i, j, k]: [usize; 3]| if (i + j + k).is_multiple_of(2) { 6 } else { -6 };
    let value = |p: [usize; 3]| 4 * p[2] as i32 - 2 * n as i32 + 1 + sign(p);
    Volume::integers([n + 1; 3], grid(n).map(value).collect())
}

/// n + 1 samples a side of (3z − 1)²: where 3 does not divide n none of them is 0, though {f = 0} is the plane z = 1/3. SP-97.
///
/// # Errors
/// As [`Volume::rationals`]: n = 0, or too many samples.
#[doc(alias = "SP-97")]
pub fn touching(n: usize) -> Result<Volume, VolumeError> {
    let value = |[_, _, k]: [usize; 3]| (Rational::from((3 * k, n.max(1))) - 1_u32).square();
    Volume::rationals([n + 1; 3], grid(n).map(value).collect())
}

fn grid(n: usize) -> impl Iterator<Item = [usize; 3]> {
    (0..=n).flat_map(move |k| (0..=n).flat_map(move |j| (0..=n).map(move |i| [i, j, k])))
}

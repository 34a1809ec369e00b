//! The partial derivatives of a spline in three variables, each as the sum that the text writes down.

use super::basis::split;
use super::bspline::{b3, b3_first, b3_second};
use super::tensor::Spline;
use crate::number::{Integer, Rational};

/// A function of one variable: B₃, B₃′ or B₃″.
type Factor = fn(&Rational) -> Rational;

/// Σ c\[i, j, k] X(x − i) Y(y − j) Z(z − k): the terms with |x − i| ≤ 2, and so on, for the factors are 0 elsewhere. SP-149.
#[doc(alias = "SP-149")]
pub fn sum(spline: &Spline<3>, at: &[Rational; 3], factors: [Factor; 3]) -> Rational {
    let near = at.each_ref().map(|x| split(x).0);
    let place = |axis: usize, m: u32| Integer::from(&near[axis] + m) - 1_u32;
    let factor = |axis: usize, k: &Integer| factors[axis](&Rational::from(&at[axis] - k));
    let mut sum = Rational::new();
    for m in 0..64_u32 {
        let k = [place(0, m % 4), place(1, m / 4 % 4), place(2, m / 16)];
        let product = factor(0, &k[0]) * factor(1, &k[1]) * factor(2, &k[2]);
        sum += product * spline.coefficients().sample(&k);
    }
    sum
}

/// f(x, y, z) = Σ c B₃(x − i) B₃(y − j) B₃(z − k), (15). SP-149.
pub fn f(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3, b3])
}

/// f_x = Σ c B₃′(x − i) B₃(y − j) B₃(z − k). SP-150.
#[doc(alias = "SP-150")]
pub fn fx(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3_first, b3, b3])
}

/// f_y = Σ c B₃(x − i) B₃′(y − j) B₃(z − k). SP-151.
#[doc(alias = "SP-151")]
pub fn fy(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3_first, b3])
}

/// f_z = Σ c B₃(x − i) B₃(y − j) B₃′(z − k). SP-152.
#[doc(alias = "SP-152")]
pub fn fz(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3, b3_first])
}

/// f_xx = Σ c B₃″(x − i) B₃(y − j) B₃(z − k). SP-153.
#[doc(alias = "SP-153")]
pub fn fxx(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3_second, b3, b3])
}

/// f_xy = Σ c B₃′(x − i) B₃′(y − j) B₃(z − k). SP-154.
#[doc(alias = "SP-154")]
pub fn fxy(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3_first, b3_first, b3])
}

/// f_xz = Σ c B₃′(x − i) B₃(y − j) B₃′(z − k). SP-155.
#[doc(alias = "SP-155")]
pub fn fxz(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3_first, b3, b3_first])
}

/// f_yy = Σ c B₃(x − i) B₃″(y − j) B₃(z − k). SP-156.
#[doc(alias = "SP-156")]
pub fn fyy(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3_second, b3])
}

/// f_yz = Σ c B₃(x − i) B₃′(y − j) B₃′(z − k). SP-157.
#[doc(alias = "SP-157")]
pub fn fyz(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3_first, b3_first])
}

/// f_zz = Σ c B₃(x − i) B₃(y − j) B₃″(z − k). SP-158.
#[doc(alias = "SP-158")]
pub fn fzz(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3, b3_second])
}

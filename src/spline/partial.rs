//! The partial derivatives of a spline in three variables, each as the sum that the text writes down.

use super::basis::split;
use super::bspline::{b3, b3_first, b3_second};
use super::tensor::Spline;
use crate::number::{Integer, Rational};

/// A function of one variable: B₃, B₃′ or B₃″.
type Factor = fn(&Rational) -> Rational;

/// Σ c\[i, j, k] X(x − i) Y(y − j) Z(z − k): the terms with |x − i| ≤ 2, and so on, for the factors are 0 elsewhere. SP-52.
#[doc(alias = "SP-52")]
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

/// f(x, y, z) = Σ c B₃(x − i) B₃(y − j) B₃(z − k), (15). SP-52.
pub fn f(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3, b3])
}

/// f_x = Σ c B₃′(x − i) B₃(y − j) B₃(z − k). SP-53.
#[doc(alias = "SP-53")]
pub fn fx(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3_first, b3, b3])
}

/// f_y = Σ c B₃(x − i) B₃′(y − j) B₃(z − k). SP-54.
#[doc(alias = "SP-54")]
pub fn fy(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3_first, b3])
}

/// f_z = Σ c B₃(x − i) B₃(y − j) B₃′(z − k). SP-55.
#[doc(alias = "SP-55")]
pub fn fz(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3, b3_first])
}

/// f_xx = Σ c B₃″(x − i) B₃(y − j) B₃(z − k). SP-56.
#[doc(alias = "SP-56")]
pub fn fxx(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3_second, b3, b3])
}

/// f_xy = Σ c B₃′(x − i) B₃′(y − j) B₃(z − k). SP-57.
#[doc(alias = "SP-57")]
pub fn fxy(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3_first, b3_first, b3])
}

/// f_xz = Σ c B₃′(x − i) B₃(y − j) B₃′(z − k). SP-58.
#[doc(alias = "SP-58")]
pub fn fxz(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3_first, b3, b3_first])
}

/// f_yy = Σ c B₃(x − i) B₃″(y − j) B₃(z − k). SP-59.
#[doc(alias = "SP-59")]
pub fn fyy(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3_second, b3])
}

/// f_yz = Σ c B₃(x − i) B₃′(y − j) B₃′(z − k). SP-60.
#[doc(alias = "SP-60")]
pub fn fyz(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3_first, b3_first])
}

/// f_zz = Σ c B₃(x − i) B₃(y − j) B₃″(z − k). SP-61.
#[doc(alias = "SP-61")]
pub fn fzz(spline: &Spline<3>, at: &[Rational; 3]) -> Rational {
    sum(spline, at, [b3, b3, b3_second])
}

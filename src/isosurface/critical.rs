//! Where the gradient of a multilinear function vanishes.

use crate::number::Rational;

/// The critical points of a bilinear function in the whole plane. There is never a line of them: where
/// f_uv = 0 the gradient is constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BilinearCritical {
    /// f_uv = 0 and f is not constant.
    None,
    /// f_uv ≠ 0: one saddle.
    Saddle(Saddle),
    /// f is constant.
    Everywhere,
}

/// The saddle of a bilinear function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saddle {
    /// u_s = (g₀₀ − g₀₁) / f_uv.
    pub u: Rational,
    /// v_s = (g₀₀ − g₁₀) / f_uv.
    pub v: Rational,
    /// f(u_s, v_s) = (g₀₀ g₁₁ − g₁₀ g₀₁) / f_uv.
    pub value: Rational,
}

/// Where the gradient of the bilinear function vanishes, with f_uv = g₀₀ + g₁₁ − g₁₀ − g₀₁ (IS-?ex5.15).
///
/// Its sign at the saddle is that of the determinant g₀₀ g₁₁ − g₁₀ g₀₁ only where f_uv > 0. If the signs of the
/// corners alternate around the square, f_uv has the sign of g₀₀, and the saddle lies inside the square.
#[doc(alias = "IS-?ex5.15")]
pub fn bilinear_critical([g00, g10, g01, g11]: &[Rational; 4]) -> BilinearCritical {
    let f_uv = Rational::from(g00 + g11) - g10 - g01;
    if f_uv.is_zero() {
        return if g00 == g10 && g00 == g01 { BilinearCritical::Everywhere } else { BilinearCritical::None };
    }
    let determinant = Rational::from(g00 * g11) - Rational::from(g10 * g01);
    BilinearCritical::Saddle(Saddle {
        u: Rational::from(g00 - g01) / &f_uv,
        v: Rational::from(g00 - g10) / &f_uv,
        value: determinant / &f_uv,
    })
}

//! What kind of a point a level surface has, and its principal curvatures as roots of one rational polynomial.

use super::implicit_surface::LevelSurface;
use crate::number::{Algebraic, Multivariate, Polynomial, Rational, Sign, real_roots};

/// A point of a surface by its principal curvatures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PointKind {
    /// k₁ = k₂ = 0: K = H = 0.
    Planar,
    /// One of k₁, k₂ is 0: K = 0 ≠ H.
    Parabolic,
    /// k₁k₂ < 0: K < 0.
    Hyperbolic,
    /// k₁ ≠ k₂ of one sign: K > 0, H² ≠ K.
    Elliptic,
    /// k₁ = k₂ ≠ 0: K > 0, H² = K.
    Umbilic,
}

/// z − (ax² + by²)/2, whose zero set has the principal curvatures a and b at the origin. CU-199.
#[doc(alias = "CU-199")]
pub fn quadric_with(a: &Rational, b: &Rational) -> Multivariate<3> {
    let minus_half = |x: &Rational| -Rational::from(x / 2_u32);
    Multivariate::new([([0, 0, 1], Rational::from(1)), ([2, 0, 0], minus_half(a)), ([0, 2, 0], minus_half(b))])
}

impl LevelSurface {
    /// The kind of the point, by the signs of K, H and H² − K. CU-197.
    #[doc(alias = "CU-197")]
    pub fn kind(&self) -> PointKind {
        let sign = |x: &Rational| Sign::of(x.cmp0());
        match (sign(&self.gaussian), self.mean_sign, sign(&self.discriminant())) {
            (Sign::Negative, _, _) => PointKind::Hyperbolic,
            (Sign::Zero, Sign::Zero, _) => PointKind::Planar,
            (Sign::Zero, Sign::Negative | Sign::Positive, _) => PointKind::Parabolic,
            (Sign::Positive, _, Sign::Zero) => PointKind::Umbilic,
            (Sign::Positive, _, Sign::Negative | Sign::Positive) => PointKind::Elliptic,
        }
    }

    /// k⁴ + (2K − 4H²)k² + K² = (k² − k₁²)(k² − k₂²), rational. CU-193.
    #[doc(alias = "CU-193")]
    pub fn principal_quartic(&self) -> Polynomial {
        let middle = Rational::from(&self.gaussian * 2_u32) - Rational::from(&self.mean_squared * 4_u32);
        let (zero, last) = (Rational::new, Rational::from(self.gaussian.square_ref()));
        Polynomial::new(vec![last, zero(), middle, zero(), Rational::from(1)])
    }

    /// k₁ ≥ k₂ as isolated roots of [`LevelSurface::principal_quartic`]. CU-193.
    ///
    /// Of ±m, ±M with 0 ≤ m ≤ M the curvature of the sign of H has the size M, the other one, of K's sign times that, the size m.
    pub fn principal_roots(&self) -> [Algebraic; 2] {
        let roots = real_roots(&self.principal_quartic()).expect("the polynomial is monic");
        // In increasing order −M, −m, m, M, where equal ones stand once.
        let at = |large: bool, sign: Sign| {
            let size = if large || roots.len() < 3 { 0 } else { 1 };
            let i = match sign {
                Sign::Negative => size,
                // m = 0 is the middle one of three.
                Sign::Zero => roots.len() / 2,
                Sign::Positive => roots.len() - 1 - size,
            };
            roots[i].clone()
        };
        let product = Sign::of(self.gaussian.cmp0());
        match self.mean_sign {
            Sign::Positive => [at(true, Sign::Positive), at(false, product)],
            Sign::Negative => [at(false, -product), at(true, Sign::Negative)],
            Sign::Zero => [at(true, Sign::Positive), at(true, Sign::Negative)],
        }
    }
}

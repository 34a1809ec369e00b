//! Level surfaces of a function of three variables.

use super::implicit_curve::SingularPoint;
use super::jet::Jet;
use super::principal::Principal;
use crate::linear::{Matrix, Vector, determinant2};
use crate::number::{Rational, Ring, Sign, Surd};

/// A level surface of f at a point: N = +∇f/|∇f|, the principal curvatures the eigenvalues of −dN.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LevelSurface {
    /// f.
    pub value: Rational,
    /// ∇f ≠ 0.
    pub gradient: Vector<Rational, 3>,
    /// (∂ᵢ∂ⱼf).
    pub hessian: Matrix<Rational, 3, 3>,
    /// K = k₁k₂.
    pub gaussian: Rational,
    /// H², H = (k₁ + k₂)/2.
    pub mean_squared: Rational,
    /// The sign of H: negative on a sphere x² + y² + z² = r².
    pub mean_sign: Sign,
}

/// The adjugate of a symmetric 3×3 matrix: A·adj A = det A·I.
pub fn adjugate<K: Ring>(Matrix(a): &Matrix<K, 3, 3>) -> Matrix<K, 3, 3> {
    // The cofactor of (j, i), with rows and columns taken cyclically, carries its sign already.
    let next = |i: usize| (i + 1) % 3;
    let last = |i: usize| (i + 2) % 3;
    Matrix::from_fn(|i, j| {
        let entry = |row: usize, column: usize| a[row][column].clone();
        determinant2(&Matrix([
            [entry(next(j), next(i)), entry(next(j), last(i))],
            [entry(last(j), next(i)), entry(last(j), last(i))],
        ]))
    })
}

/// ∇fᵀ adj(Hess f) ∇f = K|∇f|⁴. CU-3.
pub fn gaussian_numerator<K: Ring>(jet: &Jet<K, 3>) -> K {
    jet.gradient.dot(&adjugate(&jet.hessian).apply(&jet.gradient))
}

/// |∇f|² tr(Hess f) − ∇fᵀ Hess f ∇f = −2H|∇f|³. CU-3.
pub fn mean_numerator<K: Ring>(jet: &Jet<K, 3>) -> K {
    let trace = (1..3).fold(jet.hessian.0[0][0].clone(), |sum, i| sum + &jet.hessian.0[i][i]);
    jet.gradient.norm_squared() * &trace - &jet.gradient.dot(&jet.hessian.apply(&jet.gradient))
}

/// The curvatures of the level surface through the point. CU-3.
///
/// K = ∇fᵀ adj(Hess f) ∇f/|∇f|⁴ and H = −(|∇f|² tr(Hess f) − ∇fᵀ Hess f ∇f)/(2|∇f|³).
///
/// # Errors
/// iff ∇f = 0.
#[doc(alias = "CU-3")]
pub fn curvature(jet: &Jet<Rational, 3>) -> Result<LevelSurface, SingularPoint> {
    let w = jet.gradient.norm_squared();
    if w.is_zero() {
        return Err(SingularPoint);
    }
    let w2 = Rational::from(w.square_ref());
    let gaussian = gaussian_numerator(jet) / &w2;
    let numerator = -mean_numerator(jet);
    let mean_sign = Sign::of(numerator.cmp0());
    let mean_squared = numerator.square() / (w2 * &w * 4_u32);
    let (value, gradient, hessian) = (jet.value.clone(), jet.gradient.clone(), jet.hessian.clone());
    Ok(LevelSurface { value, gradient, hessian, gaussian, mean_squared, mean_sign })
}

impl LevelSurface {
    /// N = +∇f/|∇f|, in ℚ(√|∇f|²).
    pub fn unit_normal(&self) -> Vector<Surd, 3> {
        let w = self.gradient.norm_squared();
        self.gradient
            .map(|x| Surd::new(Rational::new(), Rational::from(x / &w), &w).expect("a sum of squares is not negative"))
    }

    /// H² − K = ((k₁ − k₂)/2)², which is 0 at an umbilic alone.
    pub fn discriminant(&self) -> Rational {
        Rational::from(&self.mean_squared - &self.gaussian)
    }

    /// The principal curvatures.
    pub fn principal(&self) -> Principal {
        Principal::new(self.mean_sign, &self.mean_squared, &self.gaussian)
    }
}

//! The tangent plane, coordinates in it, the first fundamental form, and the differential of a map between surfaces.

use super::jet::Jet;
use super::parametric_surface::SurfaceError;
use crate::linear::{Matrix, Vector, solve};
use crate::number::Rational;
use thiserror::Error;

/// The vector does not lie in the tangent plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the vector is not tangent to the surface")]
pub struct NotTangent;

/// T_pS by its basis {σᵤ, σᵥ}, linearly independent. CU-67.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-67")]
pub struct TangentPlane {
    /// σᵤ.
    pub u: Vector<Rational, 3>,
    /// σᵥ.
    pub v: Vector<Rational, 3>,
}

impl TangentPlane {
    /// From the jets of x, y, z in (u, v). CU-53.
    ///
    /// # Errors
    /// `Singular` iff σᵤ × σᵥ = 0: iff σᵤ and σᵥ are linearly dependent.
    #[doc(alias = "CU-53")]
    pub fn new(surface: &[Jet<Rational, 2>; 3]) -> Result<TangentPlane, SurfaceError> {
        let [u, v] = [0, 1].map(|i| Vector(surface.each_ref().map(|x| x.gradient[i].clone())));
        match u.cross(&v) == Vector::zero() {
            true => Err(SurfaceError::Singular),
            false => Ok(TangentPlane { u, v }),
        }
    }

    /// W N = σᵤ × σᵥ.
    pub fn normal_w(&self) -> Vector<Rational, 3> {
        self.u.cross(&self.v)
    }

    /// dσ(a, b) = aσᵤ + bσᵥ.
    #[doc(alias = "CU-66")]
    pub fn vector(&self, [a, b]: &[Rational; 2]) -> Vector<Rational, 3> {
        self.u.scaled(a) + &self.v.scaled(b)
    }

    /// The (a, b) with w = aσᵤ + bσᵥ, those of the velocity of any curve σ(u(t), v(t)) with α′(0) = w. CU-68.
    ///
    /// # Errors
    /// Iff w is not tangent: ⟨w, σᵤ × σᵥ⟩ ≠ 0.
    #[doc(alias = "CU-68")]
    #[doc(alias = "CU-64")]
    pub fn coordinates(&self, w: &Vector<Rational, 3>) -> Result<[Rational; 2], NotTangent> {
        if !w.dot(&self.normal_w()).is_zero() {
            return Err(NotTangent);
        }
        let products = Vector([w.dot(&self.u), w.dot(&self.v)]);
        Ok(solve(&self.gram(), &products).expect("EG − F² = |σᵤ × σᵥ|² > 0").0)
    }

    /// (E F; F G): E = ⟨σᵤ, σᵤ⟩, F = ⟨σᵤ, σᵥ⟩, G = ⟨σᵥ, σᵥ⟩. CU-75.
    #[doc(alias = "CU-75")]
    #[doc(alias = "CU-76")]
    pub fn gram(&self) -> Matrix<Rational, 2, 2> {
        let basis = [&self.u, &self.v];
        Matrix::from_fn(|i, j| basis[i].dot(basis[j]))
    }

    /// I_p(w) = ⟨w, w⟩ = Ea² + 2Fab + Gb² for w = aσᵤ + bσᵥ: a quadratic form on T_pS, positive but for w = 0.
    /// CU-72, CU-73, CU-74.
    #[doc(alias = "CU-72")]
    #[doc(alias = "CU-73")]
    #[doc(alias = "CU-74")]
    pub fn first_form(&self, [a, b]: &[Rational; 2]) -> Rational {
        let Matrix([[e, f], [_, g]]) = self.gram();
        e * Rational::from(a.square_ref()) + f * Rational::from(a * b) * 2_u32 + g * Rational::from(b.square_ref())
    }
}

/// The matrix of dφ: T_pS₁ → T_φ(p)S₂ in the bases {σ₁ᵤ, σ₁ᵥ} and {σ₂ᵤ, σ₂ᵥ}, from the jets of φ∘σ₁; its columns are
/// the coordinates of (φ∘σ₁)ᵤ and (φ∘σ₁)ᵥ. CU-69.
///
/// # Errors
/// Iff φ does not map into a surface with that tangent plane.
#[doc(alias = "CU-69")]
#[doc(alias = "CU-70")]
#[doc(alias = "CU-62")]
pub fn differential(
    image: &[Jet<Rational, 2>; 3],
    target: &TangentPlane,
) -> Result<Matrix<Rational, 2, 2>, NotTangent> {
    let column = |i: usize| target.coordinates(&Vector(image.each_ref().map(|x| x.gradient[i].clone())));
    let [u, v] = [column(0)?, column(1)?];
    Ok(Matrix::from_columns(&[Vector(u), Vector(v)]))
}

/// The surface moved: p ↦ Ap + b. CU-57.
#[doc(alias = "CU-57")]
pub fn moved(
    surface: &[Jet<Rational, 2>; 3],
    a: &Matrix<Rational, 3, 3>,
    b: &Vector<Rational, 3>,
) -> [Jet<Rational, 2>; 3] {
    let row = |i: usize| {
        (0..3).fold(Jet::constant(b[i].clone()), |sum, j| sum + &(Jet::constant(a.0[i][j].clone()) * &surface[j]))
    };
    std::array::from_fn(row)
}

//! Surfaces by a parametrisation σ(u, v).

use super::jet::Jet;
use super::principal::Principal;
use crate::linear::{Matrix, Vector};
use crate::number::{Rational, Ring, Sign};
use thiserror::Error;

/// Why a parametrised surface has no curvature at (u, v).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum SurfaceError {
    /// The denominator is 0: the surface is not defined there.
    #[error("a pole: the denominator is zero")]
    Pole,
    /// σᵤ × σᵥ = 0.
    #[error("a singular point: the tangent vectors are linearly dependent")]
    Singular,
}

/// The fundamental forms of a parametrised surface over any ring: N = (σᵤ × σᵥ)/W, W = |σᵤ × σᵥ|, so that e, f, g are rational
/// after multiplication by W.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-6")]
pub struct FundamentalForms<K> {
    /// E = ⟨σᵤ, σᵤ⟩, F = ⟨σᵤ, σᵥ⟩, G = ⟨σᵥ, σᵥ⟩.
    pub first: [K; 3],
    /// We, Wf, Wg: e = ⟨N, σᵤᵤ⟩, f = ⟨N, σᵤᵥ⟩, g = ⟨N, σᵥᵥ⟩.
    pub second_w: [K; 3],
    /// W N = σᵤ × σᵥ.
    pub normal_w: Vector<K, 3>,
}

impl<K: Ring> FundamentalForms<K> {
    /// From the jets of the coordinates x, y, z in u, v. CU-6.
    pub fn new(surface: &[Jet<K, 2>; 3]) -> FundamentalForms<K> {
        let first = |i: usize| Vector(surface.each_ref().map(|x| x.gradient[i].clone()));
        let second = |i: usize, j: usize| Vector(surface.each_ref().map(|x| x.hessian.0[i][j].clone()));
        let (u, v) = (first(0), first(1));
        let normal_w = u.cross(&v);
        let second_w = [(0, 0), (0, 1), (1, 1)].map(|(i, j)| normal_w.dot(&second(i, j)));
        FundamentalForms { first: [u.dot(&u), u.dot(&v), v.dot(&v)], second_w, normal_w }
    }

    /// W² = EG − F² = |σᵤ × σᵥ|².
    #[doc(alias = "CU-71")]
    pub fn w_squared(&self) -> K {
        let [e, f, g] = &self.first;
        e.clone() * g - &(f.clone() * f)
    }
}

/// A regular parametrised surface at a parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParametricSurface {
    /// The fundamental forms.
    pub forms: FundamentalForms<Rational>,
    /// W² > 0.
    pub w_squared: Rational,
    /// K = (eg − f²)/(EG − F²).
    pub gaussian: Rational,
    /// H².
    pub mean_squared: Rational,
    /// The sign of H = (eG − 2fF + gE)/(2W²).
    pub mean_sign: Sign,
}

/// The curvatures of the surface at the point. CU-6.
///
/// # Errors
/// `Singular` iff σᵤ × σᵥ = 0.
pub fn curvature(surface: &[Jet<Rational, 2>; 3]) -> Result<ParametricSurface, SurfaceError> {
    let forms = FundamentalForms::new(surface);
    let w_squared = forms.w_squared();
    if w_squared.is_zero() {
        return Err(SurfaceError::Singular);
    }
    let times = |a: &Rational, b: &Rational| Rational::from(a * b);
    let ([big_e, big_f, big_g], [we, wf, wg]) = (&forms.first, &forms.second_w);
    let w4 = Rational::from(w_squared.square_ref());
    let gaussian = (times(we, wg) - times(wf, wf)) / &w4;
    // 2W³H
    let numerator = times(we, big_g) - times(wf, big_f) * 2_u32 + times(wg, big_e);
    let mean_sign = Sign::of(numerator.cmp0());
    let mean_squared = numerator.square() / (w4 * &w_squared * 4_u32);
    Ok(ParametricSurface { forms, w_squared, gaussian, mean_squared, mean_sign })
}

impl ParametricSurface {
    /// W·(a_ij) with Nᵤ = a₁₁σᵤ + a₂₁σᵥ and Nᵥ = a₁₂σᵤ + a₂₂σᵥ: the columns of the matrix of dN, times W. CU-6.
    ///
    /// (a_ij) = −(E F; F G)⁻¹(e f; f g).
    pub fn weingarten_w(&self) -> Matrix<Rational, 2, 2> {
        let ([big_e, big_f, big_g], [e, f, g]) = (&self.forms.first, &self.forms.second_w);
        let entry = |a: (&Rational, &Rational), b: (&Rational, &Rational)| {
            (Rational::from(a.0 * a.1) - Rational::from(b.0 * b.1)) / &self.w_squared
        };
        Matrix([
            [entry((f, big_f), (e, big_g)), entry((g, big_f), (f, big_g))],
            [entry((e, big_f), (f, big_e)), entry((f, big_f), (g, big_e))],
        ])
    }

    /// The principal curvatures.
    pub fn principal(&self) -> Principal {
        Principal::new(self.mean_sign, &self.mean_squared, &self.gaussian)
    }
}

//! Parametrisations of a surface: regularity, change of parameters, functions and maps in coordinates.

use super::jet::Jet;
use super::parametric_surface::SurfaceError;
use super::tangent::{NotTangent, TangentPlane};
use crate::linear::{Matrix, Vector};
use crate::number::{Multivariate, Rational, Ring};
use thiserror::Error;

/// A rational patch σ = (x, y, z)/w: three polynomials in (u, v) over a common one. CU-52.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-52")]
pub struct RationalPatch {
    /// wσ.
    pub numerators: [Multivariate<2>; 3],
    /// w.
    pub denominator: Multivariate<2>,
}

impl RationalPatch {
    /// A polynomial patch: w = 1.
    pub fn polynomial(coordinates: [Multivariate<2>; 3]) -> RationalPatch {
        RationalPatch { numerators: coordinates, denominator: Multivariate::integer(1) }
    }

    /// The plane p₀ + uw₁ + vw₂ (002, example 2.27). CU-77.
    #[doc(alias = "CU-77")]
    #[doc(alias = "CU-116")]
    pub fn plane(through: &Vector<Rational, 3>, [w1, w2]: [&Vector<Rational, 3>; 2]) -> RationalPatch {
        let coordinate = |i: usize| {
            Multivariate::new([([0, 0], through[i].clone()), ([1, 0], w1[i].clone()), ([0, 1], w2[i].clone())])
        };
        RationalPatch::polynomial(std::array::from_fn(coordinate))
    }

    /// The graph z = f(x, y) (002, exercise 2.16). CU-56.
    #[doc(alias = "CU-56")]
    pub fn graph(f: Multivariate<2>) -> RationalPatch {
        RationalPatch::polynomial([Multivariate::variable(0), Multivariate::variable(1), f])
    }

    /// The sphere of that radius by stereographic projection from its north pole: (2u, 2v, u² + v² − 1)r/(u² + v² + 1).
    /// It reaches every point but the pole, and no parametrisation reaches all of them. CU-79.
    pub fn sphere(radius: &Rational) -> RationalPatch {
        let term = |exponents: [u32; 2], n: i32| (exponents, Rational::from(radius * n));
        let numerators = [
            Multivariate::new([term([1, 0], 2)]),
            Multivariate::new([term([0, 1], 2)]),
            Multivariate::new([term([2, 0], 1), term([0, 2], 1), term([0, 0], -1)]),
        ];
        let one = || Rational::from(1);
        RationalPatch {
            numerators,
            denominator: Multivariate::new([([2, 0], one()), ([0, 2], one()), ([0, 0], one())]),
        }
    }

    /// The jets of the coordinates at (u, v).
    ///
    /// # Errors
    /// `Pole` iff w = 0 there.
    pub fn jets(&self, at: &[Rational; 2]) -> Result<[Jet<Rational, 2>; 3], SurfaceError> {
        let reciprocal = Jet::of_polynomial(&self.denominator, at).reciprocal().ok_or(SurfaceError::Pole)?;
        Ok(self.numerators.each_ref().map(|numerator| Jet::of_polynomial(numerator, at) * &reciprocal))
    }

    /// Whether dσ is injective at (u, v), by the tangent vectors: the third condition of a regular surface. CU-51.
    ///
    /// # Errors
    /// `Pole` iff w = 0 there, `Singular` iff dσ is not injective.
    #[doc(alias = "CU-51")]
    pub fn tangent_plane(&self, at: &[Rational; 2]) -> Result<TangentPlane, SurfaceError> {
        TangentPlane::new(&self.jets(at)?)
    }
}

/// The plane ax + by + cz = d as a graph over the two axes that are left when the last one with a coefficient ≠ 0 is
/// dropped; over x and y, as z = Ax + By + C, iff c ≠ 0 (002, example 2.15). CU-55.
///
/// `None` iff a = b = c = 0.
#[doc(alias = "CU-55")]
pub fn plane_as_graph(coefficients: &[Rational; 3], d: &Rational) -> Option<RationalPatch> {
    let dropped = coefficients.iter().rposition(|x| !x.is_zero())?;
    let kept: Vec<usize> = (0..3).filter(|&axis| axis != dropped).collect();
    let quotient = |x: &Rational| Rational::from(x / &coefficients[dropped]);
    let height = Multivariate::new([
        ([1, 0], -quotient(&coefficients[kept[0]])),
        ([0, 1], -quotient(&coefficients[kept[1]])),
        ([0, 0], quotient(d)),
    ]);
    Some(RationalPatch::polynomial(std::array::from_fn(|axis| match kept.iter().position(|&k| k == axis) {
        Some(variable) => Multivariate::variable(variable),
        None => height.clone(),
    })))
}

/// f∘h by the chain rule, from f's jet at h's value. CU-60.
///
/// ∂ᵢ(f∘h) = Σ ∂ₐf·∂ᵢhₐ and ∂ᵢ∂ⱼ(f∘h) = Σ ∂ₐf·∂ᵢ∂ⱼhₐ + Σ ∂ₐ∂ᵦf·∂ᵢhₐ·∂ⱼhᵦ.
#[doc(alias = "CU-60")]
#[doc(alias = "CU-59")]
#[doc(alias = "CU-65")]
#[doc(alias = "CU-87")]
pub fn composition<K: Ring, const N: usize, const M: usize>(f: &Jet<K, N>, h: &[Jet<K, M>; N]) -> Jet<K, M> {
    let zero = || K::integer(0);
    let first = |i: usize| (0..N).fold(zero(), |sum, a| sum + &(f.gradient[a].clone() * &h[a].gradient[i]));
    let second = |i: usize, j: usize| {
        (0..N).fold(zero(), |sum, a| {
            let curved = f.gradient[a].clone() * &h[a].hessian.0[i][j];
            let bent = (0..N)
                .fold(zero(), |sum, b| sum + &(f.hessian.0[a][b].clone() * &h[a].gradient[i] * &h[b].gradient[j]));
            sum + &curved + &bent
        })
    };
    Jet { value: f.value.clone(), gradient: Vector(std::array::from_fn(first)), hessian: Matrix::from_fn(second) }
}

/// Why two parametrisations have no change of parameters at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ChangeError {
    /// One of them has no tangent plane there.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
    /// They lead to different points.
    #[error("the points are different")]
    Points,
    /// The tangent planes are different.
    #[error("the tangent planes are different")]
    TangentPlanes,
    /// They have the tangent plane in common, and bend away from it in different ways.
    #[error("the surfaces agree to first order only")]
    SecondOrder,
}

/// The change of parameters h = σ⁻¹∘τ to second order at a common point, from the jets of σ and τ there; `at` is where
/// σ is taken. CU-58.
///
/// τᵢ = Σ ∂ᵢhₐ σₐ gives ∂h, and τᵢⱼ − Σ ∂ᵢhₐ ∂ⱼhᵦ σₐᵦ = Σ ∂ᵢ∂ⱼhₐ σₐ gives ∂∂h. Both parametrise one surface to second
/// order iff the left sides are tangent; h is then invertible, with det ∂h ≠ 0.
///
/// # Errors
/// `Surface` iff one of them is singular, else the first order in which they differ.
#[doc(alias = "CU-58")]
#[doc(alias = "CU-54")]
pub fn change_of_parameters(
    at: &[Rational; 2],
    sigma: &[Jet<Rational, 2>; 3],
    tau: &[Jet<Rational, 2>; 3],
) -> Result<[Jet<Rational, 2>; 2], ChangeError> {
    let (plane, other) = (TangentPlane::new(sigma)?, TangentPlane::new(tau)?);
    if sigma.iter().zip(tau).any(|(a, b)| a.value != b.value) {
        return Err(ChangeError::Points);
    }
    let first = |w: &Vector<Rational, 3>| plane.coordinates(w).map_err(|NotTangent| ChangeError::TangentPlanes);
    // columns[i][a] = ∂ᵢhₐ
    let columns = [first(&other.u)?, first(&other.v)?];
    let jet = |a: usize| Jet {
        value: at[a].clone(),
        gradient: Vector([columns[0][a].clone(), columns[1][a].clone()]),
        hessian: Matrix::from_fn(|_, _| Rational::new()),
    };
    let mut change = [jet(0), jet(1)];
    // With ∂∂h = 0 the second derivatives of σ∘h lack just Σ ∂ᵢ∂ⱼhₐ σₐ.
    let bent = sigma.each_ref().map(|x| composition(x, &change));
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let rest = Vector(std::array::from_fn(|x| Rational::from(&tau[x].hessian.0[i][j] - &bent[x].hessian.0[i][j])));
        let rest = plane.coordinates(&rest).map_err(|NotTangent| ChangeError::SecondOrder)?;
        for (jet, second) in change.iter_mut().zip(rest) {
            jet.hessian.0[i][j] = second;
        }
    }
    Ok(change)
}

/// The map (x, y, z) ↦ (ax, by, cz) of the text's example 2.21, which takes the unit sphere to the ellipsoid with
/// those half-axes. CU-63.
#[doc(alias = "CU-63")]
#[doc(alias = "CU-231")]
pub fn scaled_axes<K: Ring>(point: &[K; 3], axes: &[K; 3]) -> [K; 3] {
    std::array::from_fn(|i| point[i].clone() * &axes[i])
}

/// |p − p₀|² (002, example 2.19). CU-61.
#[doc(alias = "CU-61")]
pub fn distance_squared<K: Ring>(point: &[K; 3], from: &[K; 3]) -> K {
    (Vector(point.clone()) - &Vector(from.clone())).norm_squared()
}

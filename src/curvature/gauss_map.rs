//! The Gauss map, its differential, the second fundamental form, and the principal directions of a parametrised
//! surface.
//!
//! What has the factor 1/W, W = √(EG − F²), is kept times W, which makes it rational; the name then ends with `_w`.

use super::jet::Jet;
use super::parametric_surface::{FundamentalForms, SurfaceError};
use crate::linear::{Matrix, Vector, determinant2, inverse};
use crate::number::{OrderedField, Rational, Ring, Sign, Surd};

/// The Gauss map to first order at a regular point.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-225")]
pub struct GaussMap {
    /// W N = σᵤ × σᵥ.
    pub normal_w: Vector<Rational, 3>,
    /// W Nᵤ and W Nᵥ.
    pub derivatives_w: [Vector<Rational, 3>; 2],
}

impl GaussMap {
    /// By the quotient rule: with n = σᵤ × σᵥ and W² = ⟨n, n⟩, W Nᵤ = nᵤ − n⟨n, nᵤ⟩/W². CU-80, CU-81.
    ///
    /// # Errors
    /// `Singular` iff σᵤ × σᵥ = 0.
    #[doc(alias = "CU-81")]
    #[doc(alias = "CU-82")]
    pub fn new(surface: &[Jet<Rational, 2>; 3]) -> Result<GaussMap, SurfaceError> {
        let first = |i: usize| Vector(surface.each_ref().map(|x| x.gradient[i].clone()));
        let second = |i: usize, j: usize| Vector(surface.each_ref().map(|x| x.hessian.0[i][j].clone()));
        let n = first(0).cross(&first(1));
        let w_squared = n.norm_squared();
        if w_squared.is_zero() {
            return Err(SurfaceError::Singular);
        }
        let derivative = |i: usize| {
            let n_i = second(0, i).cross(&first(1)) + &first(0).cross(&second(1, i));
            let along = n.dot(&n_i) / &w_squared;
            n_i - &n.scaled(&along)
        };
        Ok(GaussMap { derivatives_w: [derivative(0), derivative(1)], normal_w: n })
    }

    /// N = (σᵤ × σᵥ)/W, a unit vector in ℚ(√W²). CU-80.
    #[doc(alias = "CU-80")]
    pub fn normal(&self) -> Vector<Surd, 3> {
        let w_squared = self.normal_w.norm_squared();
        self.normal_w.map(|x| {
            Surd::new(Rational::new(), Rational::from(x / &w_squared), &w_squared).expect("a square is not negative")
        })
    }

    /// W dN(w) for w = aσᵤ + bσᵥ: W(aNᵤ + bNᵥ), the derivative of N along every curve with the velocity w. CU-88.
    #[doc(alias = "CU-88")]
    pub fn differential_w(&self, [a, b]: &[Rational; 2]) -> Vector<Rational, 3> {
        let [u, v] = &self.derivatives_w;
        u.scaled(a) + &v.scaled(b)
    }
}

/// What −dN does, from both fundamental forms, at a regular point. It is that of the surface: another parametrisation
/// changes its matrix by ∂h, and its sign with that of det ∂h. CU-59.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShapeOperator {
    first: Matrix<Rational, 2, 2>,
    /// W(e f; f g).
    second_w: Matrix<Rational, 2, 2>,
}

/// The principal directions.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-97")]
pub enum PrincipalDirections {
    /// k₁ = k₂: every direction is principal.
    Umbilic {
        /// Wk₁ = Wk₂.
        curvature_w: Rational,
    },
    /// k₁ > k₂: two directions, orthogonal, each unique up to a factor.
    Two {
        /// Wk₁, Wk₂, in one field ℚ(√d).
        curvatures_w: [Surd; 2],
        /// e₁ and e₂ by their coordinates in {σᵤ, σᵥ}, in the same field, not of unit length. Boxed, for they are
        /// large.
        directions: Box<[[Surd; 2]; 2]>,
    },
}

impl ShapeOperator {
    /// From the fundamental forms.
    ///
    /// # Errors
    /// `Singular` iff EG − F² = 0.
    pub fn new(forms: &FundamentalForms<Rational>) -> Result<ShapeOperator, SurfaceError> {
        if forms.w_squared().is_zero() {
            return Err(SurfaceError::Singular);
        }
        let symmetric = |[a, b, c]: &[Rational; 3]| Matrix([[a.clone(), b.clone()], [b.clone(), c.clone()]]);
        Ok(ShapeOperator { first: symmetric(&forms.first), second_w: symmetric(&forms.second_w) })
    }

    /// The matrix of −W dN in the basis {σᵤ, σᵥ}, its columns the coordinates of the images: (E F; F G)⁻¹ W(e f; f g).
    /// dN is self-adjoint: the products ⟨dN σᵢ, σⱼ⟩ are symmetric, though this matrix need not be. CU-83.
    #[doc(alias = "CU-83")]
    pub fn matrix_w(&self) -> Matrix<Rational, 2, 2> {
        inverse(&self.first).expect("EG − F² > 0").times(&self.second_w)
    }

    /// K = det dN = det(−dN). CU-84.
    #[doc(alias = "CU-84")]
    pub fn gaussian(&self) -> Rational {
        determinant2(&self.matrix_w()) / determinant2(&self.first)
    }

    /// WH = −½ tr(W dN). CU-85.
    #[doc(alias = "CU-85")]
    pub fn mean_w(&self) -> Rational {
        let Matrix([[a, _], [_, d]]) = self.matrix_w();
        (a + d) / 2_u32
    }

    /// W II_p(w) = −⟨W dN(w), w⟩ = W(ea² + 2fab + gb²) for w = aσᵤ + bσᵥ: a quadratic form on T_pS. CU-86, CU-89.
    #[doc(alias = "CU-86")]
    #[doc(alias = "CU-89")]
    #[doc(alias = "CU-94")]
    pub fn second_form_w(&self, w: &[Rational; 2]) -> Rational {
        quadratic(&self.second_w, w, Rational::clone)
    }

    /// Wκₙ = W II_p(w)/I_p(w), the normal curvature of every curve on the surface with the tangent w (Meusnier).
    /// CU-95.
    ///
    /// `None` iff w = 0.
    #[doc(alias = "CU-95")]
    #[doc(alias = "CU-102")]
    pub fn normal_curvature_w(&self, w: &[Rational; 2]) -> Option<Rational> {
        let length = quadratic(&self.first, w, Rational::clone);
        (!length.is_zero()).then(|| self.second_form_w(w) / length)
    }

    /// The eigenvectors of −dN, the larger eigenvalue first. CU-96, CU-98, CU-99.
    #[doc(alias = "CU-96")]
    #[doc(alias = "CU-98")]
    #[doc(alias = "CU-99")]
    #[doc(alias = "CU-100")]
    pub fn principal_directions(&self) -> PrincipalDirections {
        let Matrix([[a, b], [c, d]]) = self.matrix_w();
        let half_trace = Rational::from(&a + &d) / 2_u32;
        let half_difference = Rational::from(&a - &d) / 2_u32;
        let spread_squared = half_difference.square() + Rational::from(&b * &c);
        if spread_squared.is_zero() {
            // −dN is self-adjoint, so that one eigenvalue alone makes it a multiple of the identity.
            return PrincipalDirections::Umbilic { curvature_w: half_trace };
        }
        let eigenvalue = |sign: i32| {
            Surd::new(half_trace.clone(), Rational::from(sign), &spread_squared).expect("k₁ and k₂ are real")
        };
        let curvatures_w = [eigenvalue(1), eigenvalue(-1)];
        let [a, b, c, d] = [a, b, c, d].map(Surd::from);
        let direction = |k: &Surd| {
            // (a − k, b) and (c, d − k) are orthogonal to it, and not both zero.
            let (row, other) = ([a.clone() - k, b.clone()], [c.clone(), d.clone() - k]);
            let [p, q] = if row.iter().all(|x| x.sign() == Sign::Zero) { other } else { row };
            [-q, p]
        };
        let directions = Box::new([direction(&curvatures_w[0]), direction(&curvatures_w[1])]);
        PrincipalDirections::Two { curvatures_w, directions }
    }

    /// ⟨x, y⟩ of two tangent vectors in coordinates of a field ℚ(√d).
    ///
    /// # Panics
    /// Iff the coordinates lie in different fields.
    pub fn inner_product(&self, x: &[Surd; 2], y: &[Surd; 2]) -> Surd {
        bilinear(&self.first, x, y, |q| Surd::from(q.clone()))
    }

    /// W II_p of a tangent vector in coordinates of a field ℚ(√d).
    ///
    /// # Panics
    /// Iff the coordinates lie in different fields.
    #[doc(alias = "CU-101")]
    pub fn second_form_of_surds_w(&self, x: &[Surd; 2]) -> Surd {
        bilinear(&self.second_w, x, x, |q| Surd::from(q.clone()))
    }
}

fn quadratic<K: Ring>(form: &Matrix<Rational, 2, 2>, x: &[K; 2], embed: impl Fn(&Rational) -> K) -> K {
    bilinear(form, x, x, embed)
}

/// Σ form_ij xᵢyⱼ.
fn bilinear<K: Ring>(form: &Matrix<Rational, 2, 2>, x: &[K; 2], y: &[K; 2], embed: impl Fn(&Rational) -> K) -> K {
    let entry = |i: usize, j: usize| embed(&form.0[i][j]) * &x[i] * &y[j];
    entry(0, 0) + &entry(0, 1) + &entry(1, 0) + &entry(1, 1)
}

/// A curve on a surface at one of its points, from the jets of α(t) = σ(u(t), v(t)): κ, and its part along N.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CurveOnSurface {
    /// α′ ≠ 0.
    pub velocity: Vector<Rational, 3>,
    /// dt/ds = κn, t = α′/|α′|: orthogonal to α′, and 0 where the curve is straight to second order.
    pub curvature_vector: Vector<Rational, 3>,
    /// Wκₙ = ⟨κn, W N⟩.
    pub normal_curvature_w: Rational,
}

impl CurveOnSurface {
    /// κn = (α″|α′|² − α′⟨α′, α″⟩)/|α′|⁴ for any parameter t, and κₙ = κ⟨n, N⟩, which is 0 where κ = 0. CU-91, CU-92.
    ///
    /// `None` iff α′ = 0.
    #[doc(alias = "CU-91")]
    #[doc(alias = "CU-92")]
    #[doc(alias = "CU-93")]
    pub fn new(curve: &[Jet<Rational, 1>; 3], normal_w: &Vector<Rational, 3>) -> Option<CurveOnSurface> {
        let velocity = Vector(curve.each_ref().map(|x| x.gradient[0].clone()));
        let second = Vector(curve.each_ref().map(|x| x.hessian.0[0][0].clone()));
        let speed_squared = velocity.norm_squared();
        if speed_squared.is_zero() {
            return None;
        }
        let across = second.scaled(&speed_squared) - &velocity.scaled(&velocity.dot(&second));
        let curvature_vector = across.scaled(&speed_squared.square().recip());
        let normal_curvature_w = curvature_vector.dot(normal_w);
        Some(CurveOnSurface { velocity, curvature_vector, normal_curvature_w })
    }

    /// κ² = |dt/ds|².
    pub fn kappa_squared(&self) -> Rational {
        self.curvature_vector.norm_squared()
    }
}

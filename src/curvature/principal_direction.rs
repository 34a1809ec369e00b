//! Directions in the tangent plane of a level surface: normal curvature, Euler's formula, principal directions.

use super::implicit_graph::over_root;
use super::jet::Jet;
use super::shape_operator::ShapeOperator;
use crate::linear::Vector;
use crate::number::{Rational, Sign, Surd};
use thiserror::Error;

/// Why there is no curvature in a direction.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DirectionError {
    /// ∇f = 0.
    #[error("a singular point: the gradient is zero")]
    Singular,
    /// The vector is 0.
    #[error("the zero vector is no direction")]
    Zero,
    /// ⟨∇f, v⟩ ≠ 0.
    #[error("the vector is not tangent: its product with the gradient is {product}")]
    NotTangent {
        /// ⟨∇f, v⟩.
        product: Rational,
    },
}

/// −vᵀ Hess f v/|v|² = |∇f| times the normal curvature.
fn normal_curvature_w(jet: &Jet<Rational, 3>, v: &Vector<Rational, 3>) -> Result<Rational, DirectionError> {
    if jet.gradient.norm_squared().is_zero() {
        return Err(DirectionError::Singular);
    }
    let square = v.norm_squared();
    if square.is_zero() {
        return Err(DirectionError::Zero);
    }
    let product = jet.gradient.dot(v);
    if !product.is_zero() {
        return Err(DirectionError::NotTangent { product });
    }
    Ok(-v.dot(&jet.hessian.apply(v)) / square)
}

/// The normal curvature k(v) = ⟨−dN(v), v⟩/|v|² = −vᵀ Hess f v/(|∇f||v|²) in a tangent direction, in ℚ(√|∇f|²): of any
/// curve of the surface along v, the part of its curvature vector along N. CU-195.
///
/// # Errors
/// `Singular` iff ∇f = 0; else `Zero` iff v = 0; else `NotTangent` iff ⟨∇f, v⟩ ≠ 0.
#[doc(alias = "CU-195")]
pub fn normal_curvature(jet: &Jet<Rational, 3>, v: &Vector<Rational, 3>) -> Result<Surd, DirectionError> {
    Ok(over_root(&normal_curvature_w(jet, v)?, &jet.gradient.norm_squared()))
}

/// The principal directions at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PrincipalDirections {
    /// k₁ = k₂: every tangent direction is one. Two of them, across one another, with rational entries.
    Umbilic([Vector<Surd, 3>; 2]),
    /// The direction of k₁ and that of k₂ < k₁, not of unit length, with entries in one field ℚ(√d).
    Two([Vector<Surd, 3>; 2]),
}

/// u and ∇f × u, across one another and across ∇f ≠ 0: rational, of the lengths |u| and |∇f||u|.
fn orthogonal_basis(gradient: &Vector<Rational, 3>) -> [Vector<Rational, 3>; 2] {
    let axes = [0, 1, 2].map(|axis| Vector(std::array::from_fn(|i| Rational::from(i32::from(i == axis)))));
    let crossed = axes.into_iter().map(|axis| gradient.cross(&axis));
    let u = crossed.into_iter().find(|u| !u.norm_squared().is_zero()).expect("∇f is along one axis at most");
    let across = gradient.cross(&u);
    [u, across]
}

/// A rational vector over ℚ(√d).
fn embedded(v: &Vector<Rational, 3>) -> Vector<Surd, 3> {
    v.map(|x| Surd::from(x.clone()))
}

/// The principal directions: the tangent v with det(v, ∇f, Hess f v) = 0. CU-194, CU-198.
///
/// In an orthogonal basis u, u′ = ∇f × u with α = uᵀHu, β = uᵀHu′, γ = u′ᵀHu′, w = |∇f|² and v = su + tu′, that is
/// βs² + (γ − wα)st − wβt² = 0, of the discriminant (γ − wα)² + 4wβ² ≥ 0, which is 0 at an umbilic alone.
///
/// # Errors
/// `Singular` iff ∇f = 0.
#[doc(alias = "CU-183")]
#[doc(alias = "CU-194")]
#[doc(alias = "CU-198")]
pub fn principal_directions(jet: &Jet<Rational, 3>) -> Result<PrincipalDirections, DirectionError> {
    let w = jet.gradient.norm_squared();
    if w.is_zero() {
        return Err(DirectionError::Singular);
    }
    let [u, across] = orthogonal_basis(&jet.gradient);
    let form = |a: &Vector<Rational, 3>, b: &Vector<Rational, 3>| a.dot(&jet.hessian.apply(b));
    let (beta, difference) = (form(&u, &across), form(&u, &u) * &w - form(&across, &across));
    let discriminant = Rational::from(difference.square_ref()) + Rational::from(beta.square_ref()) * 4_u32 * &w;
    if discriminant.is_zero() {
        return Ok(PrincipalDirections::Umbilic([u, across].map(|v| embedded(&v))));
    }
    let root =
        |a: Rational, b: i32| Surd::new(a, Rational::from(b), &discriminant).expect("a sum of squares is not negative");
    // k₁ has the least vᵀHv/|v|². Of two expressions for its direction one may vanish: take the other.
    let (s, t) = match Sign::of(difference.cmp0()) {
        Sign::Negative | Sign::Zero => (root(difference, -1), Surd::from(beta * 2_u32)),
        Sign::Positive => (Surd::from(beta * 2_u32 * &w), root(-difference, -1)),
    };
    let combination = |s: &Surd, t: &Surd| embedded(&u).scaled(s) + &embedded(&across).scaled(t);
    // ⟨su + tu′, s′u + t′u′⟩ = |u|²(ss′ + wtt′)
    Ok(PrincipalDirections::Two([combination(&s, &t), combination(&-(t * &Surd::from(w)), &s)]))
}

/// |∇f|(k₁ cos²θ + k₂ sin²θ), θ the angle from the first principal direction to v: Euler's formula, in the field of the
/// principal directions. It is |∇f| times the normal curvature. CU-196.
///
/// # Errors
/// As [`normal_curvature`].
#[doc(alias = "CU-196")]
pub fn euler_w(jet: &Jet<Rational, 3>, v: &Vector<Rational, 3>) -> Result<Surd, DirectionError> {
    normal_curvature_w(jet, v)?;
    let [k1, k2] = ShapeOperator::new(jet).map_err(|_| DirectionError::Singular)?.scaled_principal();
    let PrincipalDirections::Two([first, second]) = principal_directions(jet)? else { return Ok(k1) };
    let v = embedded(v);
    // ⟨v, vᵢ⟩²/(|v|²|vᵢ|²)
    let cosine_squared = |direction: &Vector<Surd, 3>| {
        let product = v.dot(direction);
        let lengths = v.norm_squared() * &direction.norm_squared();
        (product.clone() * &product).checked_div(&lengths).expect("directions are not zero")
    };
    Ok(k1 * &cosine_squared(&first) + &(k2 * &cosine_squared(&second)))
}

/// Whether v is a principal direction, from det(v, ∇f, Hess f v) = 0.
///
/// # Errors
/// As [`normal_curvature`].
pub fn is_principal(jet: &Jet<Rational, 3>, v: &Vector<Rational, 3>) -> Result<bool, DirectionError> {
    normal_curvature_w(jet, v)?;
    Ok(v.cross(&jet.gradient).dot(&jet.hessian.apply(v)).is_zero())
}

//! Formulas of parametrised surfaces as the text prints them, where that is not what holds, beside what holds. They
//! take any numbers: those times W too.

use crate::linear::{Matrix, Vector, determinant2};
use crate::number::{OrderedField, Rational};

/// E, F, G.
pub type First = [Rational; 3];
/// e, f, g, or these times W.
pub type Second = [Rational; 3];

fn times(a: &Rational, b: &Rational) -> Rational {
    Rational::from(a * b)
}

/// "I_p: T_pS × T_pS → ℝ" as a function of two vectors: the inner product, no quadratic form of a vector. CU-73.
pub fn first_form_printed(w1: &Vector<Rational, 3>, w2: &Vector<Rational, 3>) -> Rational {
    w1.dot(w2)
}

/// "II_p: T_pS × T_pS → ℝ" as a function of two vectors, by the derivative of the Gauss map in the direction of the
/// first. CU-86.
pub fn second_form_printed(dn_of_first: &Vector<Rational, 3>, second: &Vector<Rational, 3>) -> Rational {
    -dn_of_first.dot(second)
}

/// "A metade do traço de dN_p é chamado de curvatura média": ½ tr dN = −(k₁ + k₂)/2. CU-85.
pub fn mean_curvature_printed(dn: &Matrix<Rational, 2, 2>) -> Rational {
    Rational::from(&dn.0[0][0] + &dn.0[1][1]) / 2_u32
}

/// f = −⟨Nᵥ, σᵥ⟩, which is g. CU-90, CU-106.
pub fn f_printed(n_v: &Vector<Rational, 3>, sigma_v: &Vector<Rational, 3>) -> Rational {
    -n_v.dot(sigma_v)
}

/// f = −⟨Nᵤ, σᵥ⟩ = −⟨Nᵥ, σᵤ⟩ = ⟨N, σᵤᵥ⟩. CU-90, CU-106.
#[doc(alias = "CU-90")]
#[doc(alias = "CU-106")]
pub fn f_corrected(n_v: &Vector<Rational, 3>, sigma_u: &Vector<Rational, 3>) -> Rational {
    -n_v.dot(sigma_u)
}

/// The left and the right side of ⟨σᵥ, Nᵥ⟩ = −⟨σᵤᵥ, N⟩. CU-105.
pub fn mixed_product_printed(
    sigma_v: &Vector<Rational, 3>,
    n_v: &Vector<Rational, 3>,
    sigma_uv: &Vector<Rational, 3>,
    n: &Vector<Rational, 3>,
) -> [Rational; 2] {
    [sigma_v.dot(n_v), -sigma_uv.dot(n)]
}

/// The left and the right side of ⟨σᵤ, Nᵥ⟩ = −⟨σᵤᵥ, N⟩, the derivative of ⟨σᵤ, N⟩ = 0 by v. CU-105.
#[doc(alias = "CU-105")]
pub fn mixed_product_corrected(
    sigma_u: &Vector<Rational, 3>,
    n_v: &Vector<Rational, 3>,
    sigma_uv: &Vector<Rational, 3>,
    n: &Vector<Rational, 3>,
) -> [Rational; 2] {
    [sigma_u.dot(n_v), -sigma_uv.dot(n)]
}

/// The (a_ij) of equations (1), Nᵤ = a₁₁σᵤ + a₁₂σᵥ and Nᵥ = a₂₁σᵤ + a₂₂σᵥ, as the text solves for it: −(e f; f g)(E F;
/// F G)⁻¹. Its rows are the coordinates of Nᵤ and Nᵥ. CU-103, CU-108, CU-109, CU-110.
///
/// `None` iff EG − F² = 0.
#[doc(alias = "CU-103")]
#[doc(alias = "CU-108")]
#[doc(alias = "CU-109")]
#[doc(alias = "CU-110")]
pub fn rows(first: &First, second: &Second) -> Option<Matrix<Rational, 2, 2>> {
    let inverse = first_form_inverse(first)?;
    let [e, f, g] = second.each_ref().map(|x| Rational::from(-x));
    Some(Matrix([[e, f.clone()], [f, g]]).times(&inverse))
}

/// (E F; F G)⁻¹ = (G −F; −F E)/(EG − F²). CU-110.
///
/// `None` iff EG − F² = 0.
pub fn first_form_inverse([e, f, g]: &First) -> Option<Matrix<Rational, 2, 2>> {
    let scale = (times(e, g) - times(f, f)).inverse()?;
    let off = Rational::from(-f) * &scale;
    Some(Matrix([[times(g, &scale), off.clone()], [off, times(e, &scale)]]))
}

/// a₁₁, a₁₂, a₂₁, a₂₂ as printed: (fF − eG)/W², (gF − fG)/W², (eF − fE)/W², (fF − gE)/W². They are the coefficients of
/// Nᵤ = a₁₁σᵤ + a₂₁σᵥ and Nᵥ = a₁₂σᵤ + a₂₂σᵥ, the transposes of those of (1). CU-111.
///
/// `None` iff EG − F² = 0.
pub fn entries_printed([big_e, big_f, big_g]: &First, [e, f, g]: &Second) -> Option<Matrix<Rational, 2, 2>> {
    let scale = (times(big_e, big_g) - times(big_f, big_f)).inverse()?;
    Some(Matrix([
        [(times(f, big_f) - times(e, big_g)) * &scale, (times(g, big_f) - times(f, big_g)) * &scale],
        [(times(e, big_f) - times(f, big_e)) * &scale, (times(f, big_f) - times(g, big_e)) * &scale],
    ]))
}

/// a₁₁, a₁₂, a₂₁, a₂₂ of equations (1): (fF − eG)/W², (eF − fE)/W², (gF − fG)/W², (fF − gE)/W². CU-111.
///
/// `None` iff EG − F² = 0.
#[doc(alias = "CU-111")]
pub fn entries_corrected([big_e, big_f, big_g]: &First, [e, f, g]: &Second) -> Option<Matrix<Rational, 2, 2>> {
    let scale = (times(big_e, big_g) - times(big_f, big_f)).inverse()?;
    Some(Matrix([
        [(times(f, big_f) - times(e, big_g)) * &scale, (times(e, big_f) - times(f, big_e)) * &scale],
        [(times(g, big_f) - times(f, big_g)) * &scale, (times(f, big_f) - times(g, big_e)) * &scale],
    ]))
}

/// The right sides of equations (2), in their order: ⟨σᵤ, Nᵤ⟩, ⟨σᵥ, Nᵥ⟩, ⟨σᵤ, Nᵥ⟩, ⟨σᵥ, Nᵤ⟩ by the (a_ij) of (1).
/// CU-104.
#[doc(alias = "CU-104")]
pub fn products(a: &Matrix<Rational, 2, 2>, [big_e, big_f, big_g]: &First) -> [Rational; 4] {
    let Matrix([[a11, a12], [a21, a22]]) = a;
    [
        times(a11, big_e) + times(a12, big_f),
        times(a21, big_f) + times(a22, big_g),
        times(a21, big_e) + times(a22, big_f),
        times(a11, big_f) + times(a12, big_g),
    ]
}

/// The right sides of the four lines that the text takes from (2): those of −f = ⟨Nᵤ, σᵥ⟩, −f = ⟨Nᵥ, σᵤ⟩, −e = ⟨Nᵤ,
/// σᵤ⟩ and −g = ⟨Nᵥ, σᵥ⟩, with a₁₂ and a₂₁ interchanged. CU-107.
pub fn lines_printed(a: &Matrix<Rational, 2, 2>, [big_e, big_f, big_g]: &First) -> [Rational; 4] {
    let Matrix([[a11, a12], [a21, a22]]) = a;
    [
        times(a11, big_f) + times(a21, big_g),
        times(a12, big_e) + times(a22, big_f),
        times(a11, big_e) + times(a21, big_f),
        times(a12, big_f) + times(a22, big_g),
    ]
}

/// The same with the (a_ij) of (1). CU-107.
#[doc(alias = "CU-107")]
pub fn lines_corrected(a: &Matrix<Rational, 2, 2>, first: &First) -> [Rational; 4] {
    let [uu, vv, uv, vu] = products(a, first);
    [vu, uv, uu, vv]
}

/// K = det(a_ij) = (eg − f²)/(EG − F²) = det II/det I. CU-112.
///
/// `None` iff EG − F² = 0.
#[doc(alias = "CU-112")]
pub fn gaussian([big_e, big_f, big_g]: &First, [e, f, g]: &Second) -> Option<Rational> {
    Some((times(e, g) - times(f, f)) * (times(big_e, big_g) - times(big_f, big_f)).inverse()?)
}

/// The determinant of dN − kI, which "dN = kI não é invertível" is read as; 0 iff −k is a principal curvature. CU-113.
pub fn singular_map_printed(a: &Matrix<Rational, 2, 2>, k: &Rational) -> Rational {
    characteristic(a, &Rational::from(-k))
}

/// det(a₁₁ + k, a₁₂; a₂₁, a₂₂ + k), the determinant of dN + kI: 0 iff k is a principal curvature. CU-113, CU-114.
#[doc(alias = "CU-113")]
#[doc(alias = "CU-114")]
pub fn characteristic(Matrix([[a11, a12], [a21, a22]]): &Matrix<Rational, 2, 2>, k: &Rational) -> Rational {
    let shifted = |x: &Rational| Rational::from(x + k);
    determinant2(&Matrix([[shifted(a11), a12.clone()], [a21.clone(), shifted(a22)]]))
}

/// H = −½(eG − 2fF + gE)/(EG − F²), which is minus the mean curvature. CU-115.
///
/// `None` iff EG − F² = 0.
pub fn mean_printed(first: &First, second: &Second) -> Option<Rational> {
    Some(-mean_corrected(first, second)?)
}

/// H = ½(eG − 2fF + gE)/(EG − F²) = −½ tr(a_ij). CU-115.
///
/// `None` iff EG − F² = 0.
#[doc(alias = "CU-115")]
pub fn mean_corrected([big_e, big_f, big_g]: &First, [e, f, g]: &Second) -> Option<Rational> {
    let scale = (times(big_e, big_g) - times(big_f, big_f)).inverse()?;
    Some((times(e, big_g) - times(f, big_f) * 2_u32 + times(g, big_e)) * scale / 2_u32)
}

/// H = 1/r of the sphere with the normal that points outward. CU-120.
///
/// `None` iff r = 0.
pub fn sphere_mean_printed(radius: &Rational) -> Option<Rational> {
    radius.inverse()
}

/// H = −1/r of the sphere with the normal that points outward. CU-120.
///
/// `None` iff r = 0.
#[doc(alias = "CU-120")]
pub fn sphere_mean_corrected(radius: &Rational) -> Option<Rational> {
    Some(-radius.inverse()?)
}

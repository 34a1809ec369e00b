//! What the text prints of level surfaces, letter for letter, where it prints it wrongly. For exhibits, never for answers.

use super::implicit_curve::SingularPoint;
use super::implicit_graph::product;
use super::jet::Jet;
use super::motion::Affine;
use super::shape_operator::{ShapeOperator, frobenius_squared, projection, trace};
use crate::linear::{Matrix, Vector};
use crate::number::{Rational, Ring, Surd, Trivariate};

/// 2|∇f|³H as the second line of the text's H has it:
/// (f_y² + f_z²)f_xx + (f_x² + f_z²)f_yy + (f_x² + f_y²)f_zz − 2(f_x f_y f_xy + f_x f_z f_xz + f_y f_z f_yz).
/// It has the opposite sign of the first line, by determinants. CU-167.
pub fn printed_mean_numerator<K: Ring>(jet: &Jet<K, 3>) -> K {
    let ([fx, fy, fz], [[fxx, fxy, fxz], [_, fyy, fyz], [_, _, fzz]]) = (&jet.gradient.0, &jet.hessian.0);
    let squares = |a: &K, b: &K| product([a, a]) + &product([b, b]);
    let mixed = product([fx, fy, fxy]) + &product([fx, fz, fxz]) + &product([fy, fz, fyz]);
    squares(fy, fz) * fxx + &(squares(fx, fz) * fyy) + &(squares(fx, fy) * fzz) - &(mixed * &K::integer(2))
}

/// The normal as (8) has it at last, (f_x² + f_y² + f_z²)^(−1/2)·(f_x, f_y, f_z), for the graph's normal (−g_x, −g_y, 1)/√…; the
/// two are opposite where f_z < 0. CU-158.
///
/// # Errors
/// iff ∇f = 0.
pub fn printed_graph_normal(jet: &Jet<Rational, 3>) -> Result<Vector<Surd, 3>, SingularPoint> {
    Ok(ShapeOperator::new(jet)?.unit_normal())
}

/// ∇(∇fᵀ∇f) = 2∇fᵀ·Hess f, a row. CU-177.
#[doc(alias = "CU-177")]
pub fn squared_norm_derivative<K: Ring>(jet: &Jet<K, 3>) -> Vector<K, 3> {
    // ∂ⱼ Σ fᵢ² = Σ 2 fᵢ ∂ⱼfᵢ
    let term = |i: usize, j: usize| product([&K::integer(2), &jet.gradient[i], &jet.hessian.0[i][j]]);
    Vector(std::array::from_fn(|j| term(0, j) + &term(1, j) + &term(2, j)))
}

/// |∇f| times each of the five lines in which the text derives "dN", all printed with a leading minus; ∇f ≠ 0.
/// CU-175, CU-176, CU-178, CU-179.
///
/// Lines 1, 2, 3 and 5 are the matrix of −dN. Line 4 has Hess f within the bracket that should be closed before it:
/// −(1/|∇f|)(1 − (∇f∇fᵀ/|∇f|²)Hess f), where 1 is read as I.
///
/// # Errors
/// iff ∇f = 0.
#[doc(alias = "CU-175")]
#[doc(alias = "CU-176")]
#[doc(alias = "CU-178")]
pub fn printed_normal_derivative_w(jet: &Jet<Rational, 3>) -> Result<[Matrix<Rational, 3, 3>; 5], SingularPoint> {
    let w = jet.gradient.norm_squared();
    if w.is_zero() {
        return Err(SingularPoint);
    }
    let (gradient, hessian) = (&jet.gradient, &jet.hessian);
    let minus = |a: Matrix<Rational, 3, 3>| Matrix(a.0.map(|row| row.map(|x| -x)));
    let without = |row: &Vector<Rational, 3>| {
        Matrix::from_fn(|i, j| hessian.0[i][j].clone() - Rational::from(&gradient[i] * &row[j]))
    };
    // 1: |∇f|·∇f·∇(|∇f|)/|∇f|² with |∇f|·∇(|∇f|) = Hess f·∇f, from Σ fᵢ dfᵢ
    let first = without(&hessian.transposed().apply(gradient).map(|x| Rational::from(x / &w)));
    // 2: ∇f·∇(∇fᵀ∇f)/(2|∇f|(∇fᵀ∇f)^(1/2))
    let twice_w = Rational::from(&w * 2_u32);
    let second = without(&squared_norm_derivative(jet).map(|x| Rational::from(x / &twice_w)));
    // 3: ∇f·(2∇fᵀ·Hess f)/(2|∇f|²)
    let row = Matrix::from_columns(std::array::from_ref(gradient)).transposed().times(hessian);
    let third = without(&Vector(row.0[0].clone()).scaled(&(Rational::from(2) / &twice_w)));
    let outer: Matrix<Rational, 3, 3> = Matrix::from_fn(|i, j| Rational::from(&gradient[i] * &gradient[j]) / &w);
    let outer = outer.times(hessian);
    let fourth = Matrix::from_fn(|i, j| Rational::from(i32::from(i == j)) - &outer.0[i][j]);
    let fifth = projection(gradient).times(hessian);
    Ok([first, second, third, fourth, fifth].map(minus))
}

/// k₁² + k₂² as the text has it: tr(dN dNᵀ), the square of Frobenius' norm of (16). Too large by |SN|². CU-186.
pub fn printed_sum_of_squares(shape: &ShapeOperator) -> Rational {
    shape.frobenius_squared()
}

/// |∇f| times the text's k₁,₂ = (tr(dN) ± √(2|dN|²_F − tr(dN)²))/2 with dN as in (16). CU-188.
///
/// The root is of (k₁ − k₂)² + 2|SN|²: these are the principal curvatures iff SN = 0.
pub fn printed_principal_w(shape: &ShapeOperator) -> [Surd; 2] {
    from_trace_and_norm(&trace(shape.scaled()), &frobenius_squared(shape.scaled()))
}

/// |∇f| times k₁,₂ = (tr S ± √(2|SP|²_F − (tr S)²))/2: the same formula with the symmetric operator. CU-187, CU-188.
#[doc(alias = "CU-187")]
#[doc(alias = "CU-188")]
pub fn corrected_principal_w(shape: &ShapeOperator) -> [Surd; 2] {
    from_trace_and_norm(&trace(shape.scaled()), &frobenius_squared(&shape.tangential()))
}

/// (t ± √(2n − t²))/2. Both norms are at least t²/2.
fn from_trace_and_norm(t: &Rational, n: &Rational) -> [Surd; 2] {
    let half = |x: &Rational| Rational::from(x / 2_u32);
    let spread = Rational::from(n * 2_u32) - Rational::from(t.square_ref());
    [1, -1].map(|sign| {
        let b = half(&Rational::from(sign));
        Surd::new(half(t), b, &spread).expect("twice the sum of two squares is at least the square of the sum")
    })
}

/// dN in the basis v₁, v₂, N as the text has it, diag(k₁, k₂, 0), times |∇f|. CU-184.
#[doc(alias = "CU-184")]
pub fn printed_diagonal_w(shape: &ShapeOperator) -> Matrix<Surd, 3, 3> {
    let [k1, k2] = shape.scaled_principal();
    let zero = || Surd::integer(0);
    Matrix([[k1, zero(), zero()], [zero(), k2, zero()], [zero(), zero(), zero()]])
}

/// What "A(T(p)) = A(p)" compares where A is read as the same field on both sides: the jets of the unmoved f at p and at T(p). CU-204.
#[doc(alias = "CU-204")]
pub fn printed_invariance_jets(f: &Trivariate, motion: &Affine, at: &[Rational; 3]) -> [Jet<Rational, 3>; 2] {
    let image = motion.image(&Vector(at.clone()));
    [Jet::of_polynomial(f, at), Jet::of_polynomial(f, &image.0)]
}

//! The gradient and the Hessian of a polynomial as polynomials.

use crate::linear::{Matrix, Vector};
use crate::number::Multivariate;

/// ∇f: p ↦ (f_x(p), f_y(p), …). CU-142.
#[doc(alias = "CU-142")]
pub fn gradient<const N: usize>(f: &Multivariate<N>) -> Vector<Multivariate<N>, N> {
    Vector(std::array::from_fn(|i| f.derivative(i)))
}

/// (∂ᵢ∂ⱼf), symmetric. CU-180.
#[doc(alias = "CU-180")]
pub fn hessian<const N: usize>(f: &Multivariate<N>) -> Matrix<Multivariate<N>, N, N> {
    let gradient = gradient(f);
    Matrix::from_fn(|i, j| gradient[i].derivative(j))
}

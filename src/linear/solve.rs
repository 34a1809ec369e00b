//! Linear systems over an ordered field, by elimination with exact pivots.

use super::{Matrix, Vector};
use crate::number::{OrderedField, Sign};
use thiserror::Error;

/// Why a linear system has no unique solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum LinearError {
    /// The determinant is 0.
    #[error("the matrix is singular: its column {column} depends on the columns before it")]
    Singular {
        /// The first column, from 0, that is a combination of those before it.
        column: usize,
    },
}

/// The x with Ax = b. NU-21.
///
/// # Errors
/// `Singular` iff det A = 0.
#[doc(alias = "NU-21")]
pub fn solve<K: OrderedField, const N: usize>(
    a: &Matrix<K, N, N>,
    b: &Vector<K, N>,
) -> Result<Vector<K, N>, LinearError> {
    let solution = eliminated(a, Matrix::<K, N, 1>::from_columns(std::array::from_ref(b)))?;
    Ok(solution.column(0))
}

/// A⁻¹. NU-21.
///
/// # Errors
/// `Singular` iff det A = 0.
pub fn inverse<K: OrderedField, const N: usize>(a: &Matrix<K, N, N>) -> Result<Matrix<K, N, N>, LinearError> {
    eliminated(a, Matrix::identity())
}

/// The X with AX = B: Gauss and Jordan's elimination. Any pivot that is not 0 will do, as nothing is rounded.
fn eliminated<K: OrderedField, const N: usize, const M: usize>(
    a: &Matrix<K, N, N>,
    b: Matrix<K, N, M>,
) -> Result<Matrix<K, N, M>, LinearError> {
    let (Matrix(mut a), Matrix(mut b)) = (a.clone(), b);
    for column in 0..N {
        let pivot = (column..N).find(|&row| a[row][column].sign() != Sign::Zero);
        let pivot = pivot.ok_or(LinearError::Singular { column })?;
        a.swap(column, pivot);
        b.swap(column, pivot);
        let scale = a[column][column].inverse().expect("the pivot is not zero");
        a[column] = a[column].clone().map(|x| x * &scale);
        b[column] = b[column].clone().map(|x| x * &scale);
        for row in (0..N).filter(|&row| row != column) {
            let factor = a[row][column].clone();
            a[row] = without(&a[row], &factor, &a[column]);
            b[row] = without(&b[row], &factor, &b[column]);
        }
    }
    Ok(Matrix(b))
}

/// row − factor·other.
fn without<K: OrderedField, const C: usize>(row: &[K; C], factor: &K, other: &[K; C]) -> [K; C] {
    std::array::from_fn(|j| row[j].clone() - &(factor.clone() * &other[j]))
}

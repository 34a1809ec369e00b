//! Matrices of a fixed shape.

use super::Vector;
use crate::number::Ring;

/// A matrix of R rows and C columns, as its rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matrix<K, const R: usize, const C: usize>(pub [[K; C]; R]);

impl<K: Ring, const R: usize, const C: usize> Matrix<K, R, C> {
    /// The matrix of the entries f(row, column).
    pub fn from_fn(f: impl Fn(usize, usize) -> K) -> Matrix<K, R, C> {
        Matrix(std::array::from_fn(|i| std::array::from_fn(|j| f(i, j))))
    }

    /// The matrix with these columns.
    pub fn from_columns(columns: &[Vector<K, R>; C]) -> Matrix<K, R, C> {
        Matrix::from_fn(|i, j| columns[j][i].clone())
    }

    /// The column j.
    pub fn column(&self, j: usize) -> Vector<K, R> {
        Vector(std::array::from_fn(|i| self.0[i][j].clone()))
    }

    /// Aᵀ.
    pub fn transposed(&self) -> Matrix<K, C, R> {
        Matrix::from_fn(|i, j| self.0[j][i].clone())
    }

    /// Av.
    pub fn apply(&self, v: &Vector<K, C>) -> Vector<K, R> {
        Vector(std::array::from_fn(|i| Vector(self.0[i].clone()).dot(v)))
    }

    /// AB.
    pub fn times<const D: usize>(&self, other: &Matrix<K, C, D>) -> Matrix<K, R, D> {
        Matrix::from_columns(&std::array::from_fn(|j| self.apply(&other.column(j))))
    }
}

impl<K: Ring, const N: usize> Matrix<K, N, N> {
    /// I.
    pub fn identity() -> Matrix<K, N, N> {
        Matrix::from_fn(|i, j| K::integer(i64::from(i == j)))
    }
}

//! Points, vectors, matrices and determinants over any ring.

mod determinant;
mod matrix;
mod solve;
mod vector;

pub use determinant::{determinant, determinant2, determinant3};
pub use matrix::Matrix;
pub use solve::{LinearError, inverse, solve};
pub use vector::Vector;

//! Isosurfaces of sampled functions: multilinear interpolation and the marching algorithms.

pub mod adaptive;
#[cfg(feature = "quickcheck")]
mod arbitrary;
pub mod bernstein;
pub mod boundary;
pub mod cases;
pub mod cell;
pub mod classes;
pub mod critical;
pub mod cube;
pub mod fast;
mod interior;
pub mod mesh;
pub mod multilinear;
pub mod patch;
pub mod polyline;
pub mod slices;
pub mod square;
#[cfg(feature = "proptest")]
pub mod strategy;
pub mod subdivision;
pub mod symmetry;
pub mod table;
pub mod tetrahedra;
pub mod topology;
pub mod triangle;
pub mod volume;
pub mod witness;

//! Isosurfaces of sampled functions: multilinear interpolation and the marching algorithms.

pub mod boundary;
pub mod cases;
pub mod cell;
pub mod classes;
pub mod cube;
pub mod fast;
mod interior;
pub mod mesh;
pub mod patch;
pub mod table;
pub mod topology;
pub mod volume;

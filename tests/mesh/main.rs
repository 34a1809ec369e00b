//! Polygon meshes: each entry of spec/mesh.md against a second derivation.

mod classify;
mod connected_sum;
mod domain;
mod euler;
mod euler_numbers;
mod examples;
mod figures;
mod homology;
mod implicit;
mod manifold;

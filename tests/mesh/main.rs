//! Polygon meshes: each entry of spec/mesh.md against a second derivation.

mod examples;
mod fast;
mod fast_exact;

//! Polygon meshes: each entry of spec/mesh.md against a second derivation.

mod defects;
mod examples;
mod naive_check;
mod specimens;

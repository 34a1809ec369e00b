//! Polygon meshes: each entry of spec/mesh.md against a second derivation.

#[cfg(feature = "cli")]
mod answers;
mod criteria;
mod defects;
mod edge_criteria;
mod examples;
mod fast;
mod fast_exact;
mod naive_check;
mod normals;
mod plane;
mod printed;
mod specimens;

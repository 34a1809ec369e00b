//! Polygon meshes: each entry of spec/mesh.md against a second derivation.

mod costs;
mod examples;
mod loops;
mod meshes;
mod operations;
mod printed;
mod representations;
mod winged_edge;

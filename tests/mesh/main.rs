//! Polygon meshes: each entry of spec/mesh.md against a second derivation.

mod angle_answers;
mod angle_complexes;
mod angle_isosurface;
mod angle_multiples;
mod angle_polygons;
mod euler_operators;
mod costs;
mod examples;
mod loops;
mod meshes;
mod operations;
mod printed;
mod representations;
mod winged_edge;

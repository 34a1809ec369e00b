//! Polygon meshes: each entry of spec/mesh.md against a second derivation.

mod angle_answers;
mod angle_complexes;
mod angle_isosurface;
mod angle_multiples;
mod angle_polygons;
#[cfg(feature = "cli")]
mod answers;
mod classify;
mod connected_sum;
mod costs;
mod criteria;
mod defects;
mod domain;
mod edge_criteria;
mod euler;
mod euler_numbers;
mod euler_operators;
mod examples;
mod fast;
mod fast_exact;
mod fast_order;
mod figures;
mod homology;
mod implicit;
mod loops;
mod manifold;
mod meshes;
mod naive_check;
mod normals;
mod operations;
mod plane;
mod printed;
mod printed_criteria;
mod representations;
mod specimens;
mod winged_edge;

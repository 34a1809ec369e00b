//! Polygon meshes: how they are stored, what can be wrong with them, what they are as surfaces; and simplicial and
//! cell complexes.

pub mod angle_deficit;
#[cfg(feature = "quickcheck")]
mod arbitrary;
pub mod cells;
pub mod classify;
pub mod connected_sum;
pub mod convert;
pub mod defects;
pub mod edge_list;
pub mod euler;
pub mod euler_operators;
pub mod examples;
pub mod explicit;
pub mod face;
pub mod fast;
pub mod gluing;
pub mod half_edge;
pub mod homology;
pub mod manifold;
pub mod operations;
pub mod orientation;
pub mod plane;
pub mod printed;
pub mod realisation;
pub mod simplicial;
#[cfg(feature = "proptest")]
pub mod strategy;
pub mod triangles;
pub mod vertex_list;
pub mod weld;
pub mod winged_edge;
pub mod word;

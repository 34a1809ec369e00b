//! Polygon meshes: how they are stored, what can be wrong with them, what they are as surfaces; and simplicial and
//! cell complexes.

pub mod angle_deficit;
pub mod cells;
pub mod defects;
pub mod euler_operators;
pub mod convert;
pub mod edge_list;
pub mod examples;
pub mod explicit;
pub mod face;
pub mod plane;
pub mod half_edge;
pub mod operations;
pub mod printed;
pub mod realisation;
pub mod simplicial;
pub mod triangles;
pub mod vertex_list;
pub mod weld;
pub mod winged_edge;

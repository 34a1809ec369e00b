//! Polygon meshes: how they are stored, what can be wrong with them, what they are as surfaces; and simplicial and
//! cell complexes.

pub mod angle_deficit;
pub mod cells;
pub mod defects;
pub mod examples;
pub mod face;
pub mod fast;
pub mod plane;
pub mod realisation;
pub mod simplicial;
pub mod triangles;
pub mod vertex_list;
pub mod weld;

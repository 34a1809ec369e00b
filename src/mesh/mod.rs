//! Facts about any polygon mesh, and about simplicial and cell complexes.

pub mod angle_deficit;
pub mod cells;
pub mod defects;
pub mod realisation;
pub mod simplicial;
pub mod weld;

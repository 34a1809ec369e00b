//! Facts about any polygon mesh.

pub mod defects;
pub mod weld;

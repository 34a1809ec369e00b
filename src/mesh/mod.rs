//! Facts about any polygon mesh.

//! Isosurfaces: each claim of spec/isosurface.md against a second derivation.

mod cells;
mod critical;
mod domain;
mod witness;

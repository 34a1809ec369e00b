//! Isosurfaces: each claim of spec/isosurface.md against a second derivation.

mod cells;
mod contours;
mod critical;
mod domain;
mod squares;
mod triangles;
mod witness;

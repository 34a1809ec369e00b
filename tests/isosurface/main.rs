//! Isosurfaces: each claim of spec/isosurface.md against a second derivation.

mod cells;
mod classes;
mod contours;
mod critical;
mod cubes;
mod domain;
mod meshing;
mod patches;
mod squares;
mod triangles;
mod witness;

//! Isosurfaces: each entry of spec/isosurface.md against a second derivation.

mod cells;
mod classes;
mod complexes;
mod contours;
mod counting;
mod critical;
mod cubes;
mod domain;
mod interpolation;
mod limits;
mod meshing;
mod patches;
mod squares;
mod surfaces;
mod tetrahedra_spec;
mod triangles;
mod witness;

//! Isosurfaces: each entry of spec/isosurface.md against a second derivation.

mod cells;
mod complexes;
mod counting;
mod critical;
mod domain;
mod interpolation;
mod limits;
mod surfaces;
mod tetrahedra_spec;
mod witness;

//! Isosurfaces: each entry of spec/isosurface.md against a second derivation.

mod complexes;
mod counting;
mod interpolation;
mod limits;
mod surfaces;
mod tetrahedra_spec;
mod witness;

//! Closed 3-complexes: each entry of spec/complex.md against a second derivation.

mod gluings;
mod explore;
mod ground;
mod refine;

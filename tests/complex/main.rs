//! Closed 3-complexes: each entry of spec/complex.md against a second derivation.

mod gluings;
mod ground;
mod radial;
mod refine;
#[cfg(feature = "cli")]
mod refine_answers;
mod simplicial;
mod subdivision;

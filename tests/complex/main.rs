//! Closed 3-complexes: each entry of spec/complex.md against a second derivation.

mod embedding;
mod ground;
#[cfg(feature = "realise")]
mod realise;

//! Closed 3-complexes: each entry of spec/complex.md against a second derivation.

mod census;
mod connected_sums;
mod ground;
mod invalid_zoo;
mod naive_scheme;
mod scheme_text;
mod validity;
mod zoo;

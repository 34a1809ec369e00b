//! Closed 3-complexes: each entry of spec/complex.md against a second derivation.

mod census;
mod connected_sums;
mod embedding;
mod euler;
mod every_gluing;
mod every_specimen;
mod facet_edge;
mod facet_edge_map;
mod facet_edge_samples;
mod facet_edge_sense;
mod fundamental_group;
#[cfg(feature = "cli")]
mod glue_answers;
mod glue_tetra;
mod gluings;
mod ground;
mod homology;
mod homology_fast;
mod invalid_zoo;
mod isosig;
mod naive_scheme;
mod radial;
#[cfg(feature = "realise")]
mod realise;
mod refine;
#[cfg(feature = "cli")]
mod refine_answers;
mod scheme_text;
mod simplicial;
mod splice;
mod subdivided;
mod subdivision;
mod validity;
mod zoo;

/// Whether the long form of a test is asked for: the environment has `ISORACLE_LONG=1`.
fn is_long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

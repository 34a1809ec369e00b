//! Closed 3-complexes: each entry of spec/complex.md against a second derivation.

mod euler;
mod every_gluing;
mod explore;
mod facet_edge;
mod facet_edge_map;
mod facet_edge_samples;
mod facet_edge_sense;
mod fundamental_group;
mod glue_tetra;
mod gluings;
mod ground;
mod homology;
mod homology_fast;
mod refine;
mod splice;
mod subdivided;
mod gluings;
mod ground;
mod radial;
mod refine;
#[cfg(feature = "cli")]
mod refine_answers;
mod simplicial;
mod subdivision;
mod isosig;
mod census;
mod connected_sums;
mod ground;
mod invalid_zoo;
mod naive_scheme;
mod scheme_text;
mod validity;
mod zoo;
#[cfg(feature = "realise")]
mod realise;
mod embedding;

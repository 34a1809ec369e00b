//! Closed 3-complexes: each entry of spec/complex.md against a second derivation.

mod gluings;
mod explore;
mod ground;
mod refine;
mod euler;
mod every_gluing;
mod fundamental_group;
mod ground;
mod homology;
mod homology_fast;
mod subdivided;
mod facet_edge;
mod facet_edge_map;
mod facet_edge_samples;
mod facet_edge_sense;
mod glue_tetra;
mod ground;
mod splice;

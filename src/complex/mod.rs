//! Closed 3-complexes: polyhedra glued face to face, what they are as spaces, and their subdivision into tetrahedra.
//!
//! Parse, don't validate: a [`GluingScheme`](scheme::GluingScheme) is what somebody wrote down, a
//! [`ClosedComplex`](closed_complex::ClosedComplex) one whose cells are cells, a [`Manifold3`](manifold::Manifold3) one in
//! which every point has a neighbourhood like that of a point of space.

pub mod abelian;
pub mod barycentric;
pub mod census;
pub mod chain;
pub mod check;
pub mod closed_complex;
pub mod connected_sum;
pub mod embedding;
pub mod euler;
pub mod examples;
pub mod facet_edge;
pub mod facet_edge_map;
pub mod facet_edge_sense;
pub mod finite_group;
pub mod flag;
pub mod fundamental_group;
pub mod glue_tetra;
pub mod gluing_table;
pub mod handle;
pub mod homology_fast;
pub mod isosig;
pub mod isosig_fast;
pub mod kuhn_torus;
pub mod manifold;
pub mod orientation;
pub mod permutation;
pub mod polyhedron;
pub mod presentation;
pub mod radial;
#[cfg(feature = "realise")]
pub mod realise;
pub mod refine;
pub mod relations;
pub mod scheme;
pub mod splice;
pub mod symmetry;
pub mod tetrahedra;
pub mod tietze;
pub mod triangulation;
pub mod triangulation_chain;
pub mod triangulation_link;
pub mod zoo;

//! Closed 3-complexes: polyhedra glued face to face, what they are as spaces, and their subdivision into tetrahedra.
//!
//! Parse, don't validate: a [`GluingScheme`](scheme::GluingScheme) is what somebody wrote down, a
//! [`ClosedComplex`](closed_complex::ClosedComplex) one whose cells are cells, a [`Manifold3`](manifold::Manifold3) one in
//! which every point has a neighbourhood like that of a point of space.

pub mod chain;
pub mod closed_complex;
pub mod examples;
pub mod flag;
pub mod gluing_table;
pub mod isosig;
pub mod isosig_fast;
pub mod manifold;
pub mod permutation;
pub mod polyhedron;
pub mod scheme;
pub mod tetrahedra;
pub mod triangulation;

//! The harness that judges a candidate against the oracle.

pub mod accuracy;
pub mod builtin;
pub mod candidate;
pub mod complex;
pub mod fault;
pub mod html;
pub mod isosurface;
pub mod junit;
pub mod mesh;
pub mod numbers;
pub mod report;
pub mod run;
mod shrink;
pub mod suite;
pub mod svg;
pub mod text;

//! The harness that judges a candidate against the oracle.

pub mod builtin;
pub mod candidate;
pub mod fault;
pub mod html;
pub mod junit;
pub mod place;
pub mod report;
pub mod run;
mod shrink;
pub mod suite;
pub mod svg;
pub mod text;
pub mod tie;
pub mod verdict;

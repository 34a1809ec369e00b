//! The harness that judges a candidate against the oracle.

pub mod builtin;
pub mod candidate;
pub mod fault;
pub mod place;
pub mod report;
pub mod run;
mod shrink;
pub mod suite;
pub mod tie;
pub mod verdict;

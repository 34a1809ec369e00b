//! The harness that judges a candidate against the oracle.

pub mod fault;
pub mod place;
pub mod report;
pub mod tie;
pub mod verdict;

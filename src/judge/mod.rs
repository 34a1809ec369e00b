//! The harness that judges a candidate against the oracle.

pub mod report;
pub mod svg;

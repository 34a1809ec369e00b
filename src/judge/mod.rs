//! The harness that judges a candidate against the oracle.

pub mod html;
pub mod junit;
pub mod report;
pub mod svg;
pub mod text;

//! The harness that judges a candidate against the oracle.

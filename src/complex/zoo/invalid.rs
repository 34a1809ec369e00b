//! Schemes that are no manifolds.

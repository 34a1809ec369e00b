//! Curvature: each entry of spec/curvature.md against a second derivation.

mod ground;
mod surface_charts;
mod surface_curvatures;
mod surface_families;
mod surface_forms;
mod surface_gauss;
mod surface_orientation;
mod surface_samples;
mod surface_tangents;
mod surface_topology;
mod surface_weingarten;

use isoracle::number::Rational;

/// n/d.
fn q(n: i64, d: i64) -> Rational {
    Rational::from((n, d))
}

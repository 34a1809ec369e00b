//! Curvature: each entry of spec/curvature.md against a second derivation.

mod arcs;
mod areas;
mod curves;
mod frames;
mod ground;
mod implicit_curvature;
mod implicit_function;
mod implicit_graph;
mod level;
mod level_curves;
mod motion;
mod normal_field;
mod normalize_derivative;
mod point_kind;
mod principal_direction;
mod quadrature;
mod regular_value;
mod sampled;
mod shape_operator;
mod small_jets;
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

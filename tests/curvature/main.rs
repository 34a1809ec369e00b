//! Curvature: each entry of spec/curvature.md against a second derivation.

mod ground;
mod implicit_curvature;
mod implicit_function;
mod implicit_graph;
mod level;
mod motion;
mod normal_field;
mod normalize_derivative;
mod point_kind;
mod principal_direction;
mod regular_value;
mod sampled;
mod shape_operator;
mod small_jets;

use isoracle::number::Rational;

/// n/d.
fn q(n: i64, d: i64) -> Rational {
    Rational::from((n, d))
}

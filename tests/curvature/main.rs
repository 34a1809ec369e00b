//! Curvature: each entry of spec/curvature.md against a second derivation.

mod arcs;
mod areas;
mod curves;
mod frames;
mod ground;
mod level_curves;
mod quadrature;

use isoracle::number::Rational;

/// n/d.
fn q(n: i64, d: i64) -> Rational {
    Rational::from((n, d))
}

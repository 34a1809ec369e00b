//! Cubic splines: each entry of spec/spline.md against a second derivation.

mod coherence;
mod convergence;
mod ground;

use isoracle::number::Rational;

/// n/d.
fn q(n: i64, d: i64) -> Rational {
    Rational::from((n, d))
}

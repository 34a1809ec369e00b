//! The spaces Sₙ of splines of degree n with their knots at the integers, and what is unique in them.

use super::bspline::basis;
use super::piecewise::{Piecewise, Smoothness, factorial};
use crate::number::{Integer, Polynomial, Rational};
use std::collections::BTreeMap;
use thiserror::Error;

/// Why a piecewise polynomial is not in Sₙ.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NotASpline {
    /// The polynomial changes between two integers.
    #[error("the polynomial changes at {0}, which is no integer")]
    Knot(Rational),
    /// A piece has a larger degree than n.
    #[error("a piece has degree {found}, above {n}")]
    Degree {
        /// The degree of the piece.
        found: usize,
        /// The degree of the space.
        n: usize,
    },
    /// The function is not Cⁿ⁻¹.
    #[error("the function is not continuously differentiable {required} times: it is {found:?}")]
    Rough {
        /// n − 1.
        required: usize,
        /// What it is.
        found: Smoothness,
    },
}

/// Whether f is in Sₙ: Cⁿ⁻¹, and a polynomial of degree ≤ n on each (k, k + 1]. SP-9, SP-10.
///
/// For n = 0 smoothness asks for nothing, and a function takes its values at integers from the left.
///
/// # Errors
/// The first reason why it is not.
#[doc(alias = "SP-9")]
#[doc(alias = "SP-10")]
pub fn membership(f: &Piecewise, n: usize) -> Result<(), NotASpline> {
    if let Some(knot) = f.breaks().iter().find(|knot| !knot.is_integer()) {
        return Err(NotASpline::Knot(knot.clone()));
    }
    if let Some(found) = f.pieces().iter().filter_map(Polynomial::degree).find(|degree| *degree > n) {
        return Err(NotASpline::Degree { found, n });
    }
    match (n.checked_sub(1), f.smoothness()) {
        (None, _) => Ok(()),
        (Some(required), found) if found < Smoothness::Times(required) => Err(NotASpline::Rough { required, found }),
        (Some(_), _) => Ok(()),
    }
}

/// The function whose integer translates are a basis of Sₙ: Bₙ for odd n, Bₙ(x − ½) for even n. SP-16.
#[doc(alias = "SP-16")]
pub fn generator(n: usize) -> Piecewise {
    basis(n).shifted(&centre(n))
}

/// The middle of the generator's support: 0 for odd n, ½ for even n.
fn centre(n: usize) -> Rational {
    if n % 2 == 1 { Rational::new() } else { Rational::from((1, 2)) }
}

/// Σ c\[k]Bₙ(x − k), Bₙ moved by ½ for even n: (10) for finitely many coefficients. SP-16.
pub fn combination(c: &BTreeMap<Integer, Rational>, n: usize) -> Piecewise {
    let b = generator(n);
    c.iter().fold(Piecewise::zero(), |sum, (k, c)| sum + &b.shifted(&Rational::from(k)).scaled(c))
}

/// The coefficient c\[k] of f in (10), the only one that there is. SP-17.
///
/// By the dual functionals of de Boor and Fix: with ψ(t) = Π (m − t)/n! over the n knots m inside the support of the k-th
/// B-spline, c\[k] = Σ (−1)ⁿ⁻ʳ ψ⁽ⁿ⁻ʳ⁾(τ) f⁽ʳ⁾(τ) over r = 0 … n, for any τ within the support.
///
/// # Errors
/// Iff f is not in Sₙ.
#[doc(alias = "SP-17")]
pub fn coefficient(f: &Piecewise, n: usize, k: &Integer) -> Result<Rational, NotASpline> {
    membership(f, n)?;
    Ok(coefficient_at(f, n, k, n / 2))
}

/// [`coefficient`] of a function known to be in Sₙ, from its piece on the interval-th of the n + 1 intervals of the
/// support. SP-17.
///
/// # Panics
/// Iff there is no such interval.
pub fn coefficient_at(f: &Piecewise, n: usize, k: &Integer, interval: usize) -> Rational {
    assert!(interval <= n, "a B-spline of degree n has n + 1 intervals");
    let first = centre(n) + k - Rational::from((n + 1, 2));
    let scale = Polynomial::new(vec![Rational::from((Integer::from(1), factorial(n)))]);
    // (m − t)
    let factor = |m: usize| -Polynomial::with_root(&(Rational::from(&first + Integer::from(m))));
    let mut psi = (1..=n).fold(scale, |product, m| product * &factor(m));
    // τ is the right end of the interval, where the piece is taken from the left.
    let tau = first + Integer::from(interval + 1);
    let mut derivatives = vec![f.piece_at(&tau).clone()];
    (0..n).for_each(|r| derivatives.push(derivatives[r].derivative()));
    // From r = n down, while ψ is differentiated.
    let mut sum = Rational::new();
    for derivative in derivatives.iter().rev() {
        sum += psi.evaluate(&tau) * derivative.evaluate(&tau);
        psi = -psi.derivative();
    }
    sum
}

/// The n + 1 polynomials that the B-splines of Sₙ are on (0, 1], those to the left first: a basis of all polynomials of
/// degree ≤ n. SP-76.
#[doc(alias = "SP-76")]
pub fn local_basis(n: usize) -> Vec<Polynomial> {
    let (b, one) = (generator(n), Rational::from(1));
    // The support of the k-th ends at k + centre + (n + 1)/2: from 1, for the first of them, to n + 1.
    let end = centre(n) + Rational::from((n + 1, 2));
    (1..=n + 1).map(|m| b.shifted(&(Rational::from(m) - &end)).piece_at(&one).clone()).collect()
}

/// The dimension m + n of Sₙ restricted to [0, m], m ≥ 1; for n = 0, to (0, m]. SP-11.
#[doc(alias = "SP-11")]
pub fn dimension(n: usize, m: usize) -> usize {
    m + n
}

//! What the text prints and is not so, as printed.

use super::basis::split;
use super::bspline::{b3, basis};
use super::degree_one::OnIntegers;
use super::piecewise::{Piecewise, Smoothness};
use crate::number::{Integer, Rational};

/// "f(t) = (1 − t)g\[i] + t·g\[i + 1]", i and t the integer and the fractional part of x: the argument t, and the value that
/// f is given there. SP-5.
pub fn linear(g: &OnIntegers, x: &Rational) -> (Rational, Rational) {
    let (i, t) = split(x);
    let value = Rational::from(1 - &t) * g(&i) + &t * g(&(i + 1));
    (t, value)
}

/// "f|[k,k+1] é um polinômio de grau n", of degree n and not less: on every interval [k, k + 1]. SP-9.
pub fn has_degree_everywhere(f: &Piecewise, n: usize) -> bool {
    f.pieces().iter().all(|piece| piece.degree() == Some(n))
}

/// S₀ as printed: a polynomial of degree 0 on each closed interval [k, k + 1]. Two neighbours share an end, so they are
/// equal. SP-10.
pub fn is_in_s0(f: &Piecewise) -> bool {
    f.pieces().iter().all(|piece| piece.degree().unwrap_or(0) == 0) && f.smoothness() != Smoothness::Discontinuous
}

/// Bₙ(· − k) of (10), with the Bₙ of exercise 4.2 whatever n is. SP-16.
pub fn translate(n: usize, k: i32) -> Piecewise {
    basis(n).shifted(&Rational::from(k))
}

/// The first line for f(k), "c\[k−1]B₃(k − (k−1)) + c\[k]B₃(k − k) + c\[k+1](k − (k+1))", where a B₃ is left out. SP-28.
#[doc(alias = "SP-28")]
pub fn value_at(c: &OnIntegers, k: &Integer) -> Rational {
    let left = c(&Integer::from(k - 1)) * b3(&Rational::from(1));
    left + c(k) * b3(&Rational::new()) - c(&Integer::from(k + 1))
}

/// The line that follows: c\[k−1]B₃(1) + c\[k]B₃(0) + c\[k+1]B₃(−1). SP-28.
pub fn corrected_value_at(c: &OnIntegers, k: &Integer) -> Rational {
    let place = |step: i32| c(&Integer::from(k + step)) * b3(&Rational::from(-step));
    place(-1) + place(0) + place(1)
}

//! The cubic B-spline and its derivatives.

use crate::number::{Integer, Rational};

/// B₃⁽ⁿ⁾(x − k) for the four k = i − 1, i, i + 1, i + 2 whose B-splines are not zero on i ≤ x < i + 1, with t = x − i; n = 0, 1 or 2. SP-1.
///
/// They are (1 − t)³/6, (3t³ − 6t² + 4)/6, (−3t³ + 3t² + 3t + 1)/6, t³/6 and their derivatives. At t = 0 the last is 0: three samples
/// are seen from an integer, four from elsewhere (SP-27). A third derivative is not offered: it jumps at the knots (SP-43).
///
/// # Panics
/// Iff n > 2.
#[doc(alias = "SP-1")]
#[doc(alias = "SP-27")]
#[doc(alias = "SP-43")]
pub fn weights(t: &Rational, n: u32) -> [Rational; 4] {
    cubics(n).map(|cubic| cubic.iter().rev().fold(Rational::new(), |sum, c| sum * t + Rational::from(*c)) / 6_u32)
}

/// Six times the weights, each by its coefficients of 1, t, t², t³.
pub(super) fn cubics(n: u32) -> [[i32; 4]; 4] {
    match n {
        0 => [[1, -3, 3, -1], [4, 0, -6, 3], [1, 3, 3, -3], [0, 0, 0, 1]],
        1 => [[-3, 6, -3, 0], [0, -12, 9, 0], [3, 6, -9, 0], [0, 0, 3, 0]],
        2 => [[6, -6, 0, 0], [-12, 18, 0, 0], [6, -18, 0, 0], [0, 6, 0, 0]],
        _ => panic!("a cubic spline is C²: it has no derivative of order {n}"),
    }
}

/// ⌊x⌋ and x − ⌊x⌋.
pub fn split(x: &Rational) -> (Integer, Rational) {
    let floor = x.clone().floor().into_numer_denom().0;
    let fraction = Rational::from(x - &floor);
    (floor, fraction)
}

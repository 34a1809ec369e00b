//! The B-splines B₀, B₁, B₂, … as piecewise polynomials, by four routes; and B₃, B₃′, B₃″ as the text has them.

use super::piecewise::{Piecewise, factorial};
use crate::number::{Integer, Polynomial, Rational};

/// B₀, the characteristic function of (−½, ½]. SP-19.
pub fn indicator() -> Piecewise {
    let half = Rational::from((1, 2));
    Piecewise::truncated_power(&Rational::from(-&half), 0) - &Piecewise::truncated_power(&half, 0)
}

/// Bₙ by Bₙ₊₁ = Bₙ ⋆ B₀. SP-19.
///
/// Its knots are −(n + 1)/2, …, (n + 1)/2, a step of 1 apart: integers for odd n, halves between them for even n. Its integer
/// translates add up to 1, and it is positive within its support (SP-25).
#[doc(alias = "SP-25")]
pub fn basis(n: usize) -> Piecewise {
    (0..n).fold(indicator(), |b, _| b.averaged())
}

/// Bₙ(x) = 1/n! · Σ (−1)ʲ C(n + 1, j) (x + (n + 1)/2 − j)ⁿ₊. SP-22.
#[doc(alias = "SP-22")]
pub fn by_truncated_powers(n: usize) -> Piecewise {
    let mut binomial = Integer::from(1);
    let mut sum = Piecewise::zero();
    for j in 0..=n + 1 {
        let at = Rational::from(j) - Rational::from((n + 1, 2));
        let signed = if j.is_multiple_of(2) { binomial.clone() } else { Integer::from(-&binomial) };
        sum = sum + &Piecewise::truncated_power(&at, n).scaled(&Rational::from((signed, factorial(n))));
        binomial = binomial * Integer::from(n + 1 - j) / Integer::from(j + 1);
    }
    sum
}

/// n·Bₙ(x) = ((n + 1)/2 + x)·Bₙ₋₁(x + ½) + ((n + 1)/2 − x)·Bₙ₋₁(x − ½): the recursion of de Boor and Cox. SP-21.
#[doc(alias = "SP-21")]
pub fn by_de_boor(n: usize) -> Piecewise {
    let half = Rational::from((1, 2));
    (1..=n).fold(indicator(), |b, n| {
        let middle = Rational::from((n + 1, 2));
        let [rising, falling] = [1, -1].map(|s| Polynomial::new(vec![middle.clone(), Rational::from(s)]));
        let sum = b.shifted(&Rational::from(-&half)).times(&rising) + &b.shifted(&half).times(&falling);
        sum.scaled(&Rational::from((1, n)))
    })
}

/// B₀, B₁, B₂, B₃ written out; `None` for n > 3. SP-18.
///
/// B₁ = 1 − |x| for |x| ≤ 1; B₂ = ¾ − x² for |x| ≤ ½, (3/2 − |x|)²/2 for ½ ≤ |x| ≤ 3/2; B₃ is (11).
#[doc(alias = "SP-18")]
pub fn closed_form(n: usize) -> Option<Piecewise> {
    // The pieces between the knots, each by its coefficients of 1, x, x², x³ over a common denominator.
    let (denominator, pieces): (i32, &[[i32; 4]]) = match n {
        0 => (1, &[[1, 0, 0, 0]]),
        1 => (1, &[[1, 1, 0, 0], [1, -1, 0, 0]]),
        2 => (8, &[[9, 12, 4, 0], [6, 0, -8, 0], [9, -12, 4, 0]]),
        3 => (6, &[[8, 12, 6, 1], [4, 0, -6, -3], [4, 0, -6, 3], [8, -12, 6, -1]]),
        _ => return None,
    };
    let knot = |i: usize| Rational::from(i) - Rational::from((n + 1, 2));
    let of = |piece: &[i32; 4]| Polynomial::new(piece.iter().map(|a| Rational::from((*a, denominator))).collect());
    let zero = || std::iter::once(Polynomial::new(Vec::new()));
    let pieces = zero().chain(pieces.iter().map(of)).chain(zero()).collect();
    Some(Piecewise::new((0..=n + 1).map(knot).collect(), pieces).expect("the knots increase, a piece between two"))
}

/// B₁(x) = 1 − |x| for |x| < 1, else 0. SP-13.
pub fn b1(x: &Rational) -> Rational {
    let distance = Rational::from(x.abs_ref());
    if distance < 1 { 1 - distance } else { Rational::new() }
}

/// B₃(x), (11). SP-23.
///
/// 0 for |x| ≥ 2; (2 − |x|)³/6 for 1 ≤ |x| < 2; 2/3 − ½|x|²(2 − |x|) for |x| < 1.
#[doc(alias = "SP-23")]
pub fn b3(x: &Rational) -> Rational {
    let distance = Rational::from(x.abs_ref());
    let rest = Rational::from(2 - &distance);
    if distance >= 2 {
        Rational::new()
    } else if distance >= 1 {
        Rational::from(rest.square_ref()) * &rest / 6
    } else {
        Rational::from((2, 3)) - distance.square() * rest / 2
    }
}

/// B₃′(x), (13). It is B₂(x + ½) − B₂(x − ½). SP-41, SP-44.
#[doc(alias = "SP-41")]
#[doc(alias = "SP-44")]
pub fn b3_first(x: &Rational) -> Rational {
    // ½x² + 2x + 2, −3/2 x² − 2x, 3/2 x² − 2x, −½x² + 2x − 2
    on_pieces(x, [[2, 2], [0, -2], [0, -2], [-2, 2]], [(1, 2), (-3, 2), (3, 2), (-1, 2)])
}

/// B₃″(x), (14). It is B₁(x + 1) − 2B₁(x) + B₁(x − 1). SP-42, SP-45, SP-47.
#[doc(alias = "SP-42")]
#[doc(alias = "SP-45")]
#[doc(alias = "SP-47")]
pub fn b3_second(x: &Rational) -> Rational {
    // x + 2, −3x − 2, 3x − 2, −x + 2
    on_pieces(x, [[2, 1], [-2, -3], [-2, 3], [2, -1]], [(0, 1); 4])
}

/// a + bx + cx² on (−2, −1], (−1, 0], (0, 1] and (1, 2), else 0: the pieces of (13) and (14).
fn on_pieces(x: &Rational, linear: [[i32; 2]; 4], squares: [(i32, i32); 4]) -> Rational {
    if Rational::from(x.abs_ref()) >= 2 {
        return Rational::new();
    }
    let piece = [-1, 0, 1].iter().filter(|knot| *x > **knot).count();
    let ([a, b], c) = (linear[piece], Rational::from(squares[piece]));
    (c * x + b) * x + a
}

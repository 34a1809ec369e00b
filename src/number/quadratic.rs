//! The real roots of a polynomial of degree at most two.

use super::{Rational, Sign, Surd};

/// The real roots of ax² + bx + c.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum QuadraticRoots {
    /// a = b = c = 0: every number is a root.
    Every,
    /// No real number is.
    None,
    /// The polynomial is linear: its root.
    Linear(Rational),
    /// One root, of multiplicity two.
    Double(Rational),
    /// Two simple roots, the smaller first.
    Two(Surd, Surd),
}

/// The real roots of ax² + bx + c: where a ≠ 0, they are −b/(2a) ± √(b² − 4ac)/(2|a|). NU-13.
#[doc(alias = "NU-13")]
pub fn quadratic_roots(a: &Rational, b: &Rational, c: &Rational) -> QuadraticRoots {
    match (a.is_zero(), b.is_zero(), c.is_zero()) {
        (true, true, true) => return QuadraticRoots::Every,
        (true, true, false) => return QuadraticRoots::None,
        (true, false, _) => return QuadraticRoots::Linear(-Rational::from(c / b)),
        (false, _, _) => {}
    }
    let discriminant: Rational = Rational::from(b.square_ref()) - Rational::from(a * c) * 4;
    let middle = -Rational::from(b / a) / 2;
    match Sign::of(discriminant.cmp0()) {
        Sign::Negative => QuadraticRoots::None,
        Sign::Zero => QuadraticRoots::Double(middle),
        Sign::Positive => {
            let spread: Rational = Rational::from(a.abs_ref()).recip() / 2;
            let root = |b: Rational| Surd::new(middle.clone(), b, &discriminant).expect("the discriminant is positive");
            QuadraticRoots::Two(root(Rational::from(-&spread)), root(spread.clone()))
        }
    }
}

//! Exact numbers and enclosures.
//!
//! A formula is written once, over [`Ring`]; the same text is evaluated on cheap `f64` enclosures, on
//! exact integers and rationals, and on numbers with an infinitesimal part. What it decides is the
//! [`Sign`] of a value, never a rounded comparison.

mod algebraic;
#[cfg(feature = "quickcheck")]
mod arbitrary;
pub mod binary;
pub mod decimal;
mod filter;
mod interval;
mod multivariate;
mod perturbed;
mod polynomial;
mod quadratic;
mod radicand;
mod rational;
#[cfg(feature = "proptest")]
pub mod strategy;
mod sturm;
mod surd;
pub mod text;
mod word;

pub use algebraic::{Algebraic, real_roots};
#[cfg(feature = "quickcheck")]
pub use arbitrary::ArbitraryRational;
pub use filter::F64Interval;
pub use interval::Interval;
pub use multivariate::{Multivariate, Trivariate};
pub use perturbed::Perturbed;
pub use polynomial::Polynomial;
pub use quadratic::{QuadraticRoots, quadratic_roots};
pub use rational::{Integer, Rational};
pub use sturm::SturmChain;
pub use surd::{Surd, SurdError};
pub use word::Word;

use std::fmt::Debug;
use std::ops::{Add, Mul, Neg, Sub};

/// The three-way answer of every comparison with zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Exactly zero.
    Zero,
    /// Greater than zero.
    Positive,
}

impl Sign {
    /// −1, 0 or 1.
    pub const fn value(self) -> i8 {
        match self {
            Sign::Negative => -1,
            Sign::Zero => 0,
            Sign::Positive => 1,
        }
    }

    /// The sign of a comparison's outcome: `a.cmp(b)` ↦ sign of a − b.
    pub const fn of(ordering: std::cmp::Ordering) -> Sign {
        match ordering {
            std::cmp::Ordering::Less => Sign::Negative,
            std::cmp::Ordering::Equal => Sign::Zero,
            std::cmp::Ordering::Greater => Sign::Positive,
        }
    }
}

impl Neg for Sign {
    type Output = Sign;
    fn neg(self) -> Sign {
        match self {
            Sign::Negative => Sign::Positive,
            Sign::Zero => Sign::Zero,
            Sign::Positive => Sign::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Sign;
    fn mul(self, other: Sign) -> Sign {
        match self {
            Sign::Negative => -other,
            Sign::Zero => Sign::Zero,
            Sign::Positive => other,
        }
    }
}

/// A commutative ring whose elements are exact, or enclose the exact result.
///
/// f64 does not implement it. The operations take the left operand by value and the right one by
/// reference, so that a product costs at most one clone.
pub trait Ring:
    Clone
    + Debug
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + Neg<Output = Self>
{
    /// The image of an integer.
    fn integer(n: i64) -> Self;
}

/// A ring whose elements enclose a real number, or are one.
pub trait Enclosure: Ring {
    /// The sign of the enclosed number, where the enclosure settles it. Exact numbers always answer.
    fn known_sign(&self) -> Option<Sign>;
}

/// An exact ordered field: [`Enclosure::known_sign`] is never `None`, and `Ord` is the field's order.
pub trait OrderedField: Enclosure + Ord {
    /// 1/x; `None` iff x = 0.
    fn inverse(&self) -> Option<Self>;

    /// The sign of the number.
    fn sign(&self) -> Sign {
        self.known_sign().expect("an exact number has a sign")
    }
}

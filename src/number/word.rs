//! Machine integers as a ring: the fast twin of [`Integer`](super::Integer) for numbers known to be small.

use super::{Enclosure, Ring, Sign};
use std::ops::{Add, Mul, Neg, Sub};

/// An integer of 128 bits. Exact as long as no result leaves that range, which whoever makes one has to
/// show; the crate is built with overflow checks, so that a mistake there stops the program instead of
/// giving a wrong answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Word(pub i128);

impl Add<&Word> for Word {
    type Output = Word;
    fn add(self, other: &Word) -> Word {
        Word(self.0 + other.0)
    }
}

impl Sub<&Word> for Word {
    type Output = Word;
    fn sub(self, other: &Word) -> Word {
        Word(self.0 - other.0)
    }
}

impl Mul<&Word> for Word {
    type Output = Word;
    fn mul(self, other: &Word) -> Word {
        Word(self.0 * other.0)
    }
}

impl Neg for Word {
    type Output = Word;
    fn neg(self) -> Word {
        Word(-self.0)
    }
}

impl Ring for Word {
    fn integer(n: i64) -> Word {
        Word(n.into())
    }
}

impl Enclosure for Word {
    fn known_sign(&self) -> Option<Sign> {
        Some(Sign::of(self.0.cmp(&0)))
    }
}

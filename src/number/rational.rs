//! The integers and the rationals, arbitrarily large.

use super::{Enclosure, OrderedField, Ring, Sign};
pub use rug::{Integer, Rational};

impl Ring for Integer {
    fn integer(n: i64) -> Integer {
        Integer::from(n)
    }
}

impl Enclosure for Integer {
    fn known_sign(&self) -> Option<Sign> {
        Some(Sign::of(self.cmp0()))
    }
}

impl Ring for Rational {
    fn integer(n: i64) -> Rational {
        Rational::from(n)
    }
}

impl Enclosure for Rational {
    fn known_sign(&self) -> Option<Sign> {
        Some(Sign::of(self.cmp0()))
    }
}

impl OrderedField for Rational {
    fn inverse(&self) -> Option<Rational> {
        (!self.is_zero()).then(|| self.clone().recip())
    }
}

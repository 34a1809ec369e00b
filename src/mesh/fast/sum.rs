//! Exact sums of many dyadic numbers, a machine word for each exponent.

use super::exact::Dyadic;
use crate::number::{Integer, Rational};

/// Σ mᵢ·2^eᵢ, exactly. ME-148.
///
/// Mantissas of one exponent are added in one word of 128 bits; one that would overflow is first carried into an integer of any size.
#[derive(Clone, Debug, Default)]
pub struct DyadicSum {
    words: Vec<i128>,
    carried: Integer,
}

/// The least exponent: three times that of the least binary64, and 256 bits for roots.
const LEAST: i32 = -3 * 1074 - 256;
const EXPONENTS: usize = 6656;

impl DyadicSum {
    /// Adds m·2^e, e from −3478 to 3177.
    pub fn add(&mut self, mantissa: i128, exponent: i32) {
        if self.words.is_empty() {
            self.words = vec![0; EXPONENTS];
        }
        let place = (exponent - LEAST) as usize;
        let word = &mut self.words[place];
        match word.checked_add(mantissa) {
            Some(sum) => *word = sum,
            None => self.carried += Integer::from(std::mem::replace(word, mantissa)) << place as u32,
        }
    }

    /// Adds ± xyz.
    pub fn add_product(&mut self, [x, y, z]: [Dyadic; 3], negative: bool) {
        let exponent = x.exponent + y.exponent + z.exponent;
        let xy = i128::from(x.mantissa) * i128::from(y.mantissa);
        let xy = if negative { -xy } else { xy };
        let z = i128::from(z.mantissa);
        match xy.checked_mul(z) {
            Some(xyz) => self.add(xyz, exponent),
            None => {
                // |xy| < 2¹⁰⁶ in two halves of 53 bits, each times |z| < 2⁵³.
                self.add((xy & ((1 << 53) - 1)) * z, exponent);
                self.add((xy >> 53) * z, exponent + 53);
            }
        }
    }

    /// Adds an integer of any size, times 2^e.
    pub fn add_integer(&mut self, mantissa: Integer, exponent: i32) {
        self.carried += mantissa << (exponent - LEAST) as u32;
    }

    /// The sum.
    pub fn total(&self) -> Rational {
        let words = self.words.iter().enumerate().filter(|(_, word)| **word != 0);
        let sum = words.fold(self.carried.clone(), |sum, (place, &word)| sum + (Integer::from(word) << place as u32));
        Rational::from(sum) >> LEAST.unsigned_abs()
    }
}

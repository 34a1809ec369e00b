//! A question of either suite, and how questions are drawn.

use super::Family;
use crate::answer::value::{self, InvalidField, Object};
use crate::judge::fault;
use crate::number::text::exact_text;
use crate::number::{Multivariate, Rational};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

/// A question.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The row that it belongs to.
    pub row: &'static str,
    /// What it asks.
    pub operation: &'static str,
    /// Its `in`, an object.
    pub input: Value,
}

impl Question {
    /// The oracle's answer, or the kind of error that the question is.
    pub fn truth(&self) -> Result<Value, &'static str> {
        fault::truth(self.operation, &self.input)
    }

    /// A question from `{"op":…,"in":…}`, of the family's first row.
    ///
    /// # Errors
    /// `op` is no operation of the family, or `in` is no object.
    pub fn parse(family: Family, text: &Object) -> Result<Question, InvalidField> {
        let words: Vec<(&str, &'static str)> = family.operations().iter().map(|op| (*op, *op)).collect();
        let operation = value::field(text, "op", |op| value::word(op, "an operation of the suite", &words))?;
        let input = value::field(text, "in", |input| value::object(input).map(|object| Value::Object(object.clone())))?;
        Ok(Question { row: family.rows()[0][0], operation, input })
    }
}

/// `cases` questions of each row: the same seed, the same questions.
pub fn questions(
    family: Family,
    seed: u64,
    cases: usize,
    question: impl Fn(&mut ChaCha8Rng, &'static str, usize) -> Question,
) -> Vec<Question> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let rows = family.rows().into_iter().flatten();
    rows.flat_map(|row| (0..cases).map(move |i| (*row, i))).map(|(row, i)| question(&mut random, row, i)).collect()
}

/// A number as it is asked.
pub fn text(x: &Rational) -> Value {
    json!(exact_text(x))
}

/// Numbers as they are asked.
pub fn texts<'a>(numbers: impl IntoIterator<Item = &'a Rational>) -> Value {
    numbers.into_iter().map(text).collect()
}

/// A polynomial as it is asked.
pub fn terms<const N: usize>(polynomial: &Multivariate<N>) -> Value {
    let term = |(exponents, coefficient): ([u32; N], &Rational)| {
        let exponents = exponents.iter().map(|n| json!(n));
        Value::Array([text(coefficient)].into_iter().chain(exponents).collect())
    };
    polynomial.terms().map(term).collect()
}

/// An integer from −n to n.
pub fn integer(random: &mut ChaCha8Rng, n: i32) -> Rational {
    Rational::from(random.random_range(-n..=n))
}

/// An integer from −n to n, but not 0.
pub fn nonzero(random: &mut ChaCha8Rng, n: i32) -> Rational {
    let magnitude = Rational::from(random.random_range(1..=n));
    if random.random() { magnitude } else { -magnitude }
}

/// A multiple of 1/8 from −n to n.
pub fn eighth(random: &mut ChaCha8Rng, n: i32) -> Rational {
    integer(random, 8 * n) / 8_u32
}

/// A number from −n to n that is an integer, or a fraction that is no binary64, or a decimal that is none.
pub fn any(random: &mut ChaCha8Rng, n: i32) -> Rational {
    match random.random_range(0..3) {
        0 => integer(random, n),
        1 => integer(random, 3 * n) / 3_u32,
        _ => integer(random, 10 * n) / 10_u32,
    }
}

/// 2^exponent.
pub fn power_of_two(exponent: i32) -> Rational {
    if exponent < 0 {
        Rational::from(1) >> exponent.unsigned_abs()
    } else {
        Rational::from(1) << exponent.unsigned_abs()
    }
}

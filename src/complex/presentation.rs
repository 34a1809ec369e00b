//! Groups by generators and relators, and words in them.

use super::abelian::AbelianGroup;
use crate::number::Integer;
use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};
use thiserror::Error;

/// A generator or its inverse: ±(1 + its number).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Letter(i32);

impl Letter {
    /// The generator of that number, or its inverse.
    pub fn new(generator: usize, forward: bool) -> Letter {
        let number = i32::try_from(generator + 1).expect("fewer than 2³¹ generators");
        Letter(if forward { number } else { -number })
    }

    /// The number of the generator.
    pub fn generator(self) -> usize {
        self.0.unsigned_abs() as usize - 1
    }

    /// Whether it is the generator itself.
    pub fn is_forward(self) -> bool {
        self.0 > 0
    }

    /// What undoes it.
    pub fn inverse(self) -> Letter {
        Letter(-self.0)
    }
}

/// A word: the product of its letters, read from left to right.
pub type Word = Vec<Letter>;

/// What undoes a word.
pub fn inverse(word: &[Letter]) -> Word {
    word.iter().rev().map(|letter| letter.inverse()).collect()
}

/// The word without any letter beside its inverse.
pub fn freely_reduced(word: &[Letter]) -> Word {
    let mut reduced = Word::new();
    for letter in word {
        match reduced.last() {
            Some(last) if *last == letter.inverse() => drop(reduced.pop()),
            _ => reduced.push(*letter),
        }
    }
    reduced
}

/// The freely reduced word without a letter at its beginning whose inverse is at its end: a conjugate of the word.
pub fn cyclically_reduced(word: &[Letter]) -> Word {
    let word = freely_reduced(word);
    let mut cut = 0;
    while 2 * cut + 1 < word.len() && word[cut] == word[word.len() - 1 - cut].inverse() {
        cut += 1;
    }
    word[cut..word.len() - cut].to_vec()
}

/// A group: the free group of the generators 0 … n−1, in which each relator is made 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Presentation {
    pub(super) generators: usize,
    pub(super) relators: Vec<Word>,
}

/// A relator with a letter that is no generator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("relator {relator} has generator {generator}; there are {generators}")]
pub struct NoSuchGenerator {
    /// The relator.
    pub relator: usize,
    /// The number that stands there.
    pub generator: usize,
    /// How many generators there are.
    pub generators: usize,
}

impl Presentation {
    /// The group of so many generators with these relators.
    ///
    /// # Errors
    /// Iff a relator has a letter that is no generator: the first one.
    pub fn new(generators: usize, relators: Vec<Word>) -> Result<Presentation, NoSuchGenerator> {
        for (relator, word) in relators.iter().enumerate() {
            if let Some(letter) = word.iter().find(|letter| letter.generator() >= generators) {
                return Err(NoSuchGenerator { relator, generator: letter.generator(), generators });
            }
        }
        Ok(Presentation { generators, relators })
    }

    /// How many generators it has.
    pub fn generators(&self) -> usize {
        self.generators
    }

    /// Its relators.
    pub fn relators(&self) -> &[Word] {
        &self.relators
    }

    /// The group made abelian (CX-76), by the matrix of exponents.
    #[doc(alias = "CX-76")]
    pub fn abelianisation(&self) -> AbelianGroup {
        let exponents = |word: &Word| {
            let mut sum: BTreeMap<usize, Integer> = BTreeMap::new();
            for letter in word {
                *sum.entry(letter.generator()).or_default() += if letter.is_forward() { 1 } else { -1 };
            }
            sum
        };
        AbelianGroup::of_relations(self.generators, self.relators.iter().map(exponents).collect())
    }

    fn letter(&self, letter: Letter) -> String {
        // Up to 26 generators have letters of their own, capital for the inverse.
        match (u8::try_from(letter.generator()), self.generators <= 26, letter.is_forward()) {
            (Ok(n), true, true) => char::from(b'a' + n).to_string(),
            (Ok(n), true, false) => char::from(b'A' + n).to_string(),
            (_, _, true) => format!("x{}", letter.generator() + 1),
            (_, _, false) => format!("X{}", letter.generator() + 1),
        }
    }
}

impl Display for Presentation {
    /// `⟨a, b | a b A B⟩`, capitals for inverses, 1 for the empty word; x1, X1, … where there are more than 26 generators.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let word = |word: &Word| match word.is_empty() {
            true => "1".to_owned(),
            false => word.iter().map(|letter| self.letter(*letter)).collect::<Vec<_>>().join(" "),
        };
        let generators = (0..self.generators).map(|g| self.letter(Letter::new(g, true))).collect::<Vec<_>>().join(", ");
        match self.relators.is_empty() {
            true => write!(f, "⟨{generators}⟩"),
            false => {
                let relators = self.relators.iter().map(word).collect::<Vec<_>>().join(", ");
                write!(f, "⟨{generators}{}| {relators}⟩", if self.generators == 0 { "" } else { " " })
            }
        }
    }
}

//! Shorter presentations of the same group.

use super::presentation::{Letter, Presentation, Word, cyclically_reduced, inverse};

impl Presentation {
    /// The same group in fewer letters (CX-78): relators are reduced cyclically; empty ones and those that are another one, turned
    /// or inverted, are dropped; a generator that stands once in a relator is replaced throughout by what the relator says that it
    /// is, cheapest first, as long as all relators together stay within the letters there were at first.
    ///
    /// The result is the same for the same presentation. It need not be the shortest: no algorithm finds that.
    #[doc(alias = "CX-78")]
    pub fn simplified(&self) -> Presentation {
        let mut group = Presentation { generators: self.generators, relators: distinct(&self.relators) };
        let limit = group.letters();
        while let Some((relator, generator)) = group.cheapest_elimination(limit) {
            group = group.without(relator, generator);
        }
        group
    }

    /// How many letters all relators have together.
    pub fn letters(&self) -> usize {
        self.relators.iter().map(Vec::len).sum()
    }

    /// A relator and a generator that stands in it once, such that replacing it adds the fewest letters; none iff there is none
    /// within the limit.
    fn cheapest_elimination(&self, limit: usize) -> Option<(usize, usize)> {
        let mut uses = vec![0_usize; self.generators];
        self.relators.iter().flatten().for_each(|letter| uses[letter.generator()] += 1);
        let total = self.letters();
        let mut best: Option<(usize, usize, usize)> = None;
        for (number, relator) in self.relators.iter().enumerate() {
            let mut letters: Vec<usize> = relator.iter().map(|letter| letter.generator()).collect();
            letters.sort_unstable();
            for run in letters.chunk_by(|a, b| a == b).filter(|run| run.len() == 1) {
                // Each other use becomes the rest of the relator.
                let others = uses[run[0]] - 1;
                let letters = total - relator.len() - others + others * (relator.len() - 1);
                if letters <= limit && best.is_none_or(|(least, _, _)| letters < least) {
                    best = Some((letters, number, run[0]));
                }
            }
        }
        best.map(|(_, relator, generator)| (relator, generator))
    }

    /// Without a generator that stands in a relator once.
    fn without(&self, relator: usize, generator: usize) -> Presentation {
        let word = &self.relators[relator];
        let at = word.iter().position(|letter| letter.generator() == generator).expect("it stands there");
        // x w = 1 says x = w⁻¹, and X w = 1 says x = w.
        let rest = [&word[at + 1..], &word[..at]].concat();
        let value = if word[at].is_forward() { inverse(&rest) } else { rest };
        let undone = inverse(&value);
        let renumbered = |letter: Letter| {
            let old = letter.generator();
            Letter::new(if old > generator { old - 1 } else { old }, letter.is_forward())
        };
        let replaced = |word: &Word| -> Word {
            let mut result = Word::new();
            for letter in word {
                match (letter.generator() == generator, letter.is_forward()) {
                    (false, _) => result.push(*letter),
                    (true, true) => result.extend(&value),
                    (true, false) => result.extend(&undone),
                }
            }
            result.into_iter().map(renumbered).collect()
        };
        let others = self.relators.iter().enumerate().filter(|(number, _)| *number != relator);
        let relators: Vec<Word> = others.map(|(_, word)| replaced(word)).collect();
        Presentation { generators: self.generators - 1, relators: distinct(&relators) }
    }
}

/// The words reduced cyclically, none empty, none twice up to turning and inverting; short ones first.
fn distinct(relators: &[Word]) -> Vec<Word> {
    let mut words: Vec<Word> = relators.iter().map(|word| least_form(&cyclically_reduced(word))).collect();
    words.retain(|word| !word.is_empty());
    words.sort_by(|a, b| (a.len(), a).cmp(&(b.len(), b)));
    words.dedup();
    words
}

/// The least of the rotations of a word and of its inverse, generators before their inverses.
fn least_form(word: &[Letter]) -> Word {
    let key = |word: &Word| word.iter().map(|letter| (letter.generator(), !letter.is_forward())).collect::<Vec<_>>();
    let rotations = |word: Word| (0..word.len()).map(move |i| [&word[i..], &word[..i]].concat());
    rotations(word.to_vec()).chain(rotations(inverse(word))).min_by_key(key).unwrap_or_default()
}

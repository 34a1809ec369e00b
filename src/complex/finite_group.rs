//! Small finite groups, and how many homomorphisms lead to them.

use super::presentation::{Letter, Presentation, Word};
use crate::number::Integer;
use std::collections::BTreeMap;

/// A finite group by its table. Element 0 is the identity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FiniteGroup {
    /// products[a][b] is ab.
    products: Vec<Vec<u32>>,
    inverses: Vec<u32>,
}

impl FiniteGroup {
    /// The group that permutations of 0 … n−1 generate, each as the list of its images; ab is first a, then b.
    /// `None` iff one of them is no permutation of them.
    pub fn generated(n: usize, generators: &[Vec<usize>]) -> Option<FiniteGroup> {
        let is_permutation = |images: &Vec<usize>| images.len() == n && (0..n).all(|i| images.contains(&i));
        if !generators.iter().all(is_permutation) {
            return None;
        }
        let identity: Vec<usize> = (0..n).collect();
        let then = |a: &[usize], b: &[usize]| -> Vec<usize> { a.iter().map(|i| b[*i]).collect() };
        let mut elements = vec![identity.clone()];
        let mut numbers = BTreeMap::from([(identity, 0)]);
        let mut next = 0;
        while next < elements.len() {
            for generator in generators {
                let product = then(&elements[next], generator);
                let number = elements.len() as u32;
                if *numbers.entry(product.clone()).or_insert(number) == number {
                    elements.push(product);
                }
            }
            next += 1;
        }
        let row = |a: &Vec<usize>| elements.iter().map(|b| numbers[&then(a, b)]).collect();
        let products: Vec<Vec<u32>> = elements.iter().map(row).collect();
        let inverse =
            |row: &Vec<u32>| row.iter().position(|product| *product == 0).expect("a row has each element") as u32;
        let inverses = products.iter().map(inverse).collect();
        Some(FiniteGroup { products, inverses })
    }

    /// ℤ/n, n ≥ 1.
    pub fn cyclic(n: usize) -> FiniteGroup {
        FiniteGroup::generated(n, &[(0..n).map(|i| (i + 1) % n).collect()]).expect("a permutation")
    }

    /// S_n.
    pub fn symmetric(n: usize) -> FiniteGroup {
        let swap = |i: usize| {
            (0..n)
                .map(|j| {
                    if j == i {
                        i + 1
                    } else if j == i + 1 {
                        i
                    } else {
                        j
                    }
                })
                .collect()
        };
        FiniteGroup::generated(n, &(1..n).map(|i| swap(i - 1)).collect::<Vec<_>>()).expect("permutations")
    }

    /// A_n.
    pub fn alternating(n: usize) -> FiniteGroup {
        // The cycles (i, i + 1, i + 2) generate it.
        let cycle = |i: usize| {
            let mut images: Vec<usize> = (0..n).collect();
            (images[i], images[i + 1], images[i + 2]) = (i + 1, i + 2, i);
            images
        };
        FiniteGroup::generated(n, &(2..n).map(|i| cycle(i - 2)).collect::<Vec<_>>()).expect("permutations")
    }

    /// How many elements it has.
    pub fn order(&self) -> usize {
        self.products.len()
    }

    /// The value of a word, by those of the generators.
    fn value(&self, word: &[Letter], images: &[u32]) -> u32 {
        word.iter().fold(0, |product, letter| {
            let image = images[letter.generator()];
            let factor = if letter.is_forward() { image } else { self.inverses[image as usize] };
            self.products[product as usize][factor as usize]
        })
    }
}

impl Presentation {
    /// How many homomorphisms lead to a finite group (CX-77): choices of images such that each relator becomes 1. Of order
    /// |G|^n for n generators in the worst case, so a group is best simplified before.
    #[doc(alias = "CX-77")]
    pub fn homomorphism_count(&self, group: &FiniteGroup) -> Integer {
        // Relators are tested as soon as the last one of their generators has its image.
        let mut tests: Vec<Vec<&Word>> = vec![Vec::new(); self.generators()];
        for word in self.relators() {
            if let Some(last) = word.iter().map(|letter| letter.generator()).max() {
                tests[last].push(word);
            }
        }
        // Generators after the last one that stands in a relator are free.
        let bound = tests.iter().rposition(|words| !words.is_empty()).map_or(0, |last| last + 1);
        let count = choices(group, &tests[..bound], &mut Vec::new());
        (bound..self.generators()).fold(count, |count, _| count * group.order() as u64)
    }
}

/// How many ways there are to go on with the images of the first generators.
fn choices(group: &FiniteGroup, tests: &[Vec<&Word>], images: &mut Vec<u32>) -> Integer {
    let Some(words) = tests.get(images.len()) else { return Integer::from(1) };
    let mut count = Integer::new();
    for image in 0..group.order() as u32 {
        images.push(image);
        if words.iter().all(|word| group.value(word, images) == 0) {
            count += choices(group, tests, images);
        }
        images.pop();
    }
    count
}

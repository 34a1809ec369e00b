//! Sums of generators of an abelian group whose relations become known one by one.

use super::abelian::AbelianGroup;
use crate::mesh::homology::{Homology, divisors, into_divisor_chain};
use crate::number::Integer;
use crate::partition::Partition;
use std::collections::{BTreeMap, HashMap, HashSet};

/// A sum of generators, by their numbers; no coefficient is 0.
pub type Combination = BTreeMap<u32, Integer>;

/// ℤ^n modulo the relations told so far (CX-80). Elements are known by numbers: 0 is zero, 2k and 2k + 1 are each other's negatives.
///
/// The relations stand in echelon form: by the last generator of each, whose coefficient, the pivot, is positive.
#[derive(Clone, Debug)]
#[doc(alias = "CX-80")]
pub struct Relations {
    generators: u32,
    rows: BTreeMap<u32, Combination>,
    elements: Vec<Combination>,
    numbers: HashMap<Combination, u32>,
    sums: HashMap<[u32; 2], u32>,
    told: HashSet<u32>,
}

impl Relations {
    /// The group 0, of no generators.
    pub fn new() -> Relations {
        let elements = vec![Combination::new(); 2];
        let numbers = HashMap::from([(Combination::new(), 0)]);
        Relations {
            generators: 0,
            rows: BTreeMap::new(),
            elements,
            numbers,
            sums: HashMap::new(),
            told: HashSet::new(),
        }
    }

    /// How many generators were made.
    pub fn generators(&self) -> usize {
        self.generators as usize
    }

    /// Another generator.
    pub fn generator(&mut self) -> u32 {
        let element = self.element(Combination::from([(self.generators, Integer::from(1))]));
        self.generators += 1;
        element
    }

    /// −a.
    pub fn negative(a: u32) -> u32 {
        if a == 0 { 0 } else { a ^ 1 }
    }

    /// a + b.
    pub fn sum(&mut self, a: u32, b: u32) -> u32 {
        match (a, b) {
            (0, other) | (other, 0) => return other,
            (a, b) if b == Relations::negative(a) => return 0,
            _ => {}
        }
        let key = [a.min(b), a.max(b)];
        if let Some(sum) = self.sums.get(&key) {
            return *sum;
        }
        let mut sum = self.elements[a as usize].clone();
        subtract(&mut sum, &Integer::from(-1), &self.elements[b as usize]);
        self.reduce(&mut sum);
        let sum = self.element(sum);
        self.sums.insert(key, sum);
        sum
    }

    /// From now on, a = 0.
    pub fn tell(&mut self, a: u32) {
        if a == 0 || !self.told.insert(a & !1) {
            return;
        }
        let mut relation = self.elements[a as usize].clone();
        while let Some((lead, n)) = relation.last_key_value() {
            let (lead, n) = (*lead, n.clone());
            let Some(row) = self.rows.get_mut(&lead) else {
                if n < 0 {
                    relation.values_mut().for_each(|n| *n = Integer::from(-&*n));
                }
                self.rows.insert(lead, relation);
                return;
            };
            // Euclid's algorithm, on whole rows.
            subtract(&mut relation, &floor(&n, &row[&lead]), row);
            if relation.contains_key(&lead) {
                std::mem::swap(row, &mut relation);
            }
        }
    }

    /// The group, up to isomorphism.
    pub fn group(&self) -> AbelianGroup {
        // A relation whose pivot is 1 takes its generator away, and nothing else names it once the others are reduced.
        let others = self.rows.iter().filter(|(lead, row)| row[lead] != 1).map(|(lead, row)| {
            let mut rest = row.clone();
            let pivot = rest.remove(lead).expect("the pivot stands there");
            self.reduce(&mut rest);
            rest.into_iter().chain([(*lead, pivot)]).map(|(generator, n)| (generator as usize, n)).collect()
        });
        let mut torsion: Vec<Integer> = blocks(others.collect()).into_iter().flat_map(divisors).collect();
        into_divisor_chain(&mut torsion);
        // Each row is one generator less.
        let rank = self.generators() - self.rows.len();
        AbelianGroup { rank, torsion: torsion.into_iter().filter(|t| *t != 1).collect() }
    }

    /// Another form of the same element: the coefficient of each pivot's generator lies in 0 … pivot − 1.
    fn reduce(&self, sum: &mut Combination) {
        let mut bound = self.generators;
        while let Some((generator, n)) = sum.range(..bound).next_back() {
            bound = *generator;
            if let Some(row) = self.rows.get(generator) {
                let quotient = floor(n, &row[generator]);
                subtract(sum, &quotient, row);
            }
        }
    }

    fn element(&mut self, sum: Combination) -> u32 {
        if let Some(number) = self.numbers.get(&sum) {
            return *number;
        }
        let number = u32::try_from(self.elements.len()).expect("fewer than 2³² elements");
        let negative: Combination = sum.iter().map(|(generator, n)| (*generator, Integer::from(-n))).collect();
        self.numbers.insert(sum.clone(), number);
        self.numbers.insert(negative.clone(), number + 1);
        self.elements.extend([sum, negative]);
        number
    }
}

impl AbelianGroup {
    /// The group of so many generators with these relations: each the coefficients, by generator, of a sum that is 0. The plain
    /// twin of [`Relations`].
    pub fn of_relations(generators: usize, relations: Vec<BTreeMap<usize, Integer>>) -> AbelianGroup {
        let divisors = divisors(relations);
        let rank = generators - divisors.len();
        AbelianGroup { rank, torsion: divisors.into_iter().filter(|t| *t != 1).collect() }
    }

    /// H_k; the group 0 above the dimension.
    pub fn of_homology(homology: &Homology, k: usize) -> AbelianGroup {
        AbelianGroup {
            rank: homology.betti.get(k).copied().unwrap_or(0),
            torsion: homology.torsion.get(k).cloned().unwrap_or_default(),
        }
    }
}

impl Default for Relations {
    fn default() -> Relations {
        Relations::new()
    }
}

/// Rows that have no column in common with those of another block, for Smith's form of each.
fn blocks(rows: Vec<BTreeMap<usize, Integer>>) -> Vec<Vec<BTreeMap<usize, Integer>>> {
    let columns = rows.iter().filter_map(|row| row.keys().last()).max().map_or(0, |last| last + 1);
    let mut same = Partition::new(columns);
    for row in &rows {
        row.keys().zip(row.keys().skip(1)).for_each(|(a, b)| _ = same.join(*a, *b));
    }
    let mut blocks: BTreeMap<usize, Vec<_>> = BTreeMap::new();
    for row in rows {
        let column = *row.keys().next().expect("a row has its pivot");
        blocks.entry(same.find(column)).or_default().push(row);
    }
    blocks.into_values().collect()
}

/// ⌊n/d⌋, d > 0.
fn floor(n: &Integer, d: &Integer) -> Integer {
    let (quotient, _) = <(Integer, Integer)>::from(n.div_rem_floor_ref(d));
    quotient
}

/// sum −= factor · other.
fn subtract(sum: &mut Combination, factor: &Integer, other: &Combination) {
    if *factor == 0 {
        return;
    }
    for (generator, n) in other {
        let entry = sum.entry(*generator).or_default();
        *entry -= Integer::from(factor * n);
        if *entry == 0 {
            sum.remove(generator);
        }
    }
}

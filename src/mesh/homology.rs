//! Homology of finite complexes, by the ranks and the divisors of their boundary maps.

use super::face::{self, Face};
use super::gluing::{FaceError, Gluing, check_loops};
use super::simplicial::SimplicialComplex;
use super::triangles::EdgeKey;
use super::word::rank_mod_2;
use crate::number::Integer;
use crate::partition::Partition;
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// The boundary of a cell: coefficients, none 0, by the numbers of cells of the dimension below.
pub type Chain = BTreeMap<usize, i64>;

/// A finite chain complex of free groups: how many cells there are of each dimension, and their boundaries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChainComplex {
    /// By dimension, then by cell. The boundary of a vertex is empty.
    boundaries: Vec<Vec<Chain>>,
}

/// Why boundaries make no chain complex: the cell has a boundary with a cell that does not exist, or whose own boundary
/// is not 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("cell {cell} of dimension {dimension}: its boundary is no cycle of cells below")]
pub struct NoCycle {
    /// The dimension.
    pub dimension: usize,
    /// The cell.
    pub cell: usize,
}

/// H₀, H₁, …, each ℤ^b ⊕ ℤ/t₁ ⊕ ℤ/t₂ ⊕ … with t₁ | t₂ | …
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Homology {
    /// The Betti numbers b.
    pub betti: Vec<usize>,
    /// The torsion coefficients t > 1.
    pub torsion: Vec<Vec<Integer>>,
}

impl ChainComplex {
    /// The complex with these boundaries, by dimension, then by cell. Coefficients 0 are dropped.
    ///
    /// # Errors
    /// Iff the boundary of a cell, the first one, is not a cycle of cells of the dimension below.
    pub fn new(mut boundaries: Vec<Vec<Chain>>) -> Result<ChainComplex, NoCycle> {
        boundaries.iter_mut().flatten().for_each(|chain| chain.retain(|_, n| *n != 0));
        for (dimension, cells) in boundaries.iter().enumerate() {
            let below = dimension.checked_sub(1).map_or(&[][..], |k| &boundaries[k]);
            let is_cycle = |chain: &Chain| {
                let mut twice = Chain::new();
                for (cell, n) in chain {
                    let Some(boundary) = below.get(*cell) else { return false };
                    add(&mut twice, boundary, *n);
                }
                twice.is_empty()
            };
            if let Some(cell) = cells.iter().position(|chain| !is_cycle(chain)) {
                return Err(NoCycle { dimension, cell });
            }
        }
        Ok(ChainComplex { boundaries })
    }

    /// That of a simplicial complex: ∂(v₀ … v_k) = Σ (−1)^i (v₀ … v̂_i … v_k), vertices sorted.
    pub fn of_complex(complex: &SimplicialComplex) -> ChainComplex {
        let dimensions = 0..complex.f_vector().len();
        let numbers: Vec<BTreeMap<&[u32], usize>> =
            dimensions.map(|k| complex.of_dimension(k).map(|s| s.vertices()).zip(0..).collect()).collect();
        let boundary = |vertices: &[u32]| {
            let facet = |i: usize| [&vertices[..i], &vertices[i + 1..]].concat();
            let sign = |i: usize| if i.is_multiple_of(2) { 1 } else { -1 };
            match vertices.len() {
                1 => Chain::new(),
                n => (0..n).map(|i| (numbers[n - 2][&facet(i)[..]], sign(i))).collect(),
            }
        };
        let boundaries = numbers.iter().map(|cells| cells.keys().map(|v| boundary(v)).collect()).collect();
        ChainComplex::new(boundaries).expect("∂∂ = 0")
    }

    /// That of a gluing's vertices, edges and polygons.
    pub fn of_gluing(gluing: &Gluing) -> ChainComplex {
        let [vertices, _, _] = gluing.counts();
        let labels: BTreeMap<u32, usize> = gluing.places().keys().copied().zip(0..).collect();
        let edges = labels.keys().map(|edge| {
            let [from, to] = gluing.ends(*edge).expect("it is an edge");
            chain([(from as usize, -1), (to as usize, 1)])
        });
        let sign = |forward: bool| if forward { 1 } else { -1 };
        let polygons =
            gluing.polygons().iter().map(|sides| chain(sides.iter().map(|s| (labels[&s.edge], sign(s.forward)))));
        let boundaries = vec![vec![Chain::new(); vertices as usize], edges.collect(), polygons.collect()];
        ChainComplex::new(boundaries).expect("a polygon's sides are a closed walk")
    }

    /// That of a mesh, vertices named as they are: the vertices that the faces have, their edges, and the faces, cut open
    /// by a bridge to each hole. Edges may have any number of faces.
    ///
    /// # Errors
    /// Iff a loop has fewer than three vertices, or a side from a vertex to itself.
    pub fn of_faces(faces: &[Face]) -> Result<ChainComplex, FaceError> {
        check_loops(faces)?;
        let vertices: BTreeSet<u32> = faces.iter().flat_map(Face::vertices).collect();
        let numbers: BTreeMap<u32, usize> = vertices.into_iter().zip(0..).collect();
        let keys: BTreeSet<EdgeKey> = faces.iter().flat_map(Face::sides).map(face::edge).collect();
        let labels: BTreeMap<EdgeKey, usize> = keys.into_iter().zip(0..).collect();
        // A bridge is run along both ways, so it does not stand in the boundary of its face.
        let bridges = faces.iter().flat_map(|face| face.holes.iter().map(|hole| [face.outer[0], hole[0]]));
        let edges = labels.keys().copied().chain(bridges);
        let edges = edges.map(|[a, b]| chain([(numbers[&a], -1), (numbers[&b], 1)]));
        let side = |[a, b]: [u32; 2]| (labels[&face::edge([a, b])], if a < b { 1 } else { -1 });
        let polygons = faces.iter().map(|face| chain(face.sides().map(side)));
        let boundaries = vec![vec![Chain::new(); numbers.len()], edges.collect(), polygons.collect()];
        Ok(ChainComplex::new(boundaries).expect("loops are closed"))
    }

    /// How many cells there are of each dimension.
    pub fn counts(&self) -> Vec<usize> {
        self.boundaries.iter().map(Vec::len).collect()
    }

    /// χ, the alternating sum of the numbers of cells.
    pub fn euler_characteristic(&self) -> i64 {
        alternating_sum(&self.counts())
    }

    /// H₀, H₁, … over ℤ (ME-101): b_k = n_k − rank ∂_k − rank ∂_{k+1}, and the torsion of H_k is the divisors of ∂_{k+1}.
    #[doc(alias = "ME-101")]
    pub fn homology(&self) -> Homology {
        let mut divisors: Vec<Vec<Integer>> = self.boundaries.iter().map(|cells| elementary_divisors(cells)).collect();
        divisors.push(Vec::new());
        let torsion = |k: usize| divisors[k + 1].iter().filter(|t| **t != 1).cloned().collect();
        Homology {
            betti: betti(&self.counts(), &divisors.iter().map(Vec::len).collect::<Vec<_>>()),
            torsion: (0..self.boundaries.len()).map(torsion).collect(),
        }
    }

    /// The dimensions of H₀, H₁, … over ℤ/2.
    pub fn betti_mod_2(&self) -> Vec<usize> {
        let odd = |chain: &Chain| chain.iter().filter(|(_, n)| *n % 2 != 0).map(|(cell, _)| *cell).collect();
        let mut ranks: Vec<usize> =
            self.boundaries.iter().map(|cells| rank_mod_2(cells.iter().map(odd).collect())).collect();
        ranks.push(0);
        betti(&self.counts(), &ranks)
    }

    /// How many connected components it has, by its edges.
    pub fn component_count(&self) -> usize {
        let vertices = self.boundaries.first().map_or(0, Vec::len);
        let mut parts = Partition::new(vertices);
        let ends = |edge: &Chain| <[usize; 2]>::try_from(edge.keys().copied().collect::<Vec<_>>()).ok();
        let edges = self.boundaries.get(1).into_iter().flatten().filter_map(ends);
        vertices - edges.filter(|[a, b]| parts.join(*a, *b)).count()
    }
}

/// Σ (−1)^k n_k.
pub fn alternating_sum(numbers: &[usize]) -> i64 {
    numbers.iter().rev().fold(0, |sum, n| *n as i64 - sum)
}

fn betti(counts: &[usize], ranks: &[usize]) -> Vec<usize> {
    counts.iter().enumerate().map(|(k, n)| n - ranks[k] - ranks[k + 1]).collect()
}

fn chain(terms: impl IntoIterator<Item = (usize, i64)>) -> Chain {
    let mut chain = Chain::new();
    terms.into_iter().for_each(|(cell, n)| add(&mut chain, &Chain::from([(cell, 1)]), n));
    chain
}

/// chain += factor · other.
fn add(chain: &mut Chain, other: &Chain, factor: i64) {
    for (cell, n) in other {
        let sum = chain.entry(*cell).or_default();
        *sum += factor * n;
        if *sum == 0 {
            chain.remove(cell);
        }
    }
}

/// The elementary divisors d₁ | d₂ | … > 0 of an integer matrix, by its rows; as many as its rank.
pub fn elementary_divisors(rows: &[Chain]) -> Vec<Integer> {
    divisors(rows.iter().map(|row| row.iter().map(|(j, n)| (*j, Integer::from(*n))).collect()).collect())
}

/// As [`elementary_divisors`], of integers of any size.
pub fn divisors(mut rows: Vec<BTreeMap<usize, Integer>>) -> Vec<Integer> {
    rows.iter_mut().for_each(|row| row.retain(|_, n| *n != 0));
    let mut diagonal: Vec<Integer> = Vec::new();
    // Smith's form: the entry of least size divides its row and column, or leaves a lesser remainder.
    while let Some((i, j)) = least_entry(&rows) {
        let pivot_row = rows[i].clone();
        let pivot = &pivot_row[&j];
        for (_, row) in rows.iter_mut().enumerate().filter(|(k, row)| *k != i && row.contains_key(&j)) {
            let quotient = Integer::from(&row[&j] / pivot);
            subtract(row, &quotient, &pivot_row);
        }
        if rows.iter().enumerate().any(|(k, row)| k != i && row.contains_key(&j)) {
            continue;
        }
        // Nothing else is left in the column, so column operations change the pivot's row only.
        for (_, n) in rows[i].iter_mut().filter(|(k, _)| **k != j) {
            *n %= pivot;
        }
        rows[i].retain(|_, n| *n != 0);
        if rows[i].len() == 1 {
            diagonal.push(pivot.clone().abs());
            rows.swap_remove(i);
        }
    }
    into_divisor_chain(&mut diagonal);
    diagonal
}

fn least_entry(rows: &[BTreeMap<usize, Integer>]) -> Option<(usize, usize)> {
    let entries = rows.iter().enumerate().flat_map(|(i, row)| row.iter().map(move |(j, n)| (i, *j, n)));
    entries.min_by(|(_, _, a), (_, _, b)| a.cmp_abs(b)).map(|(i, j, _)| (i, j))
}

fn subtract(row: &mut BTreeMap<usize, Integer>, factor: &Integer, other: &BTreeMap<usize, Integer>) {
    for (j, n) in other {
        let difference = row.entry(*j).or_default();
        *difference -= Integer::from(factor * n);
        if *difference == 0 {
            row.remove(j);
        }
    }
}

/// The elementary divisors of a diagonal matrix in place of its entries, all positive: diag(a, b) is equivalent to diag(gcd, lcm).
pub fn into_divisor_chain(diagonal: &mut [Integer]) {
    for i in 0..diagonal.len() {
        for j in i + 1..diagonal.len() {
            if diagonal[j].is_divisible(&diagonal[i]) {
                continue;
            }
            let gcd = Integer::from(diagonal[i].gcd_ref(&diagonal[j]));
            let lcm = Integer::from(diagonal[i].lcm_ref(&diagonal[j]));
            (diagonal[i], diagonal[j]) = (gcd, lcm);
        }
    }
}

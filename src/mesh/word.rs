//! Closed surfaces as words: one polygon, its sides glued in pairs (the classification theorem's proof, run on it).

use super::gluing::{Gluing, Side};
use std::collections::{BTreeMap, BTreeSet};

/// A closed surface as the polygon a₁b₁a₁⁻¹b₁⁻¹ … c₁c₁ …: a sphere with handles and cross-caps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct NormalForm {
    /// How many commutators.
    pub handles: usize,
    /// How many squares.
    pub crosscaps: usize,
}

impl Gluing {
    /// The words of its components, the border capped, in order: polygons are united across edges until one is left. A
    /// word has each of its labels twice; the empty word is a sphere.
    pub fn words(&self) -> Vec<Vec<Side>> {
        self.capped().components().iter().map(united).collect()
    }
}

/// The one polygon of a connected closed gluing.
fn united(gluing: &Gluing) -> Vec<Side> {
    let mut word = gluing.polygons()[0].clone();
    let mut rest: Vec<Vec<Side>> = gluing.polygons()[1..].to_vec();
    while !rest.is_empty() {
        let stands = |number: usize, edge: u32| rest[number].iter().position(|side| side.edge == edge);
        let found = word
            .iter()
            .enumerate()
            .find_map(|(i, side)| (0..rest.len()).find_map(|number| stands(number, side.edge).map(|j| (i, number, j))));
        let (i, number, j) = found.expect("a connected gluing");
        let mut other = rest.swap_remove(number);
        if other[j].forward == word[i].forward {
            other = inverse(&other);
        }
        let j = other.iter().position(|side| side.edge == word[i].edge).expect("it stands there");
        other.rotate_left(j);
        word.splice(i..=i, other.into_iter().skip(1));
    }
    word
}

/// The word run along the other way.
pub fn inverse(word: &[Side]) -> Vec<Side> {
    word.iter().rev().map(|side| side.reversed()).collect()
}

/// The normal form of a word that has each label twice (ME-131). The moves, with A for a⁻¹:
/// aA → nothing; aXaY → the cross-cap aa and X⁻¹Y; aXbYAZBW → the handle abAB and ZYXW.
///
/// # Panics
/// Iff a label does not stand just twice.
#[doc(alias = "ME-131")]
pub fn normal_form(word: &[Side]) -> NormalForm {
    assert!(pairs(word).values().all(|places| places.len() == 2), "each label stands twice");
    let mut word = word.to_vec();
    let mut form = NormalForm::default();
    while !word.is_empty() {
        let n = word.len();
        if let Some(i) = (0..n).find(|&i| word[i] == word[(i + 1) % n].reversed()) {
            word.rotate_left(i);
            word.drain(..2);
        } else if let Some((i, j)) = same_way(&word) {
            let (x, y) = (&word[i + 1..j], [&word[j + 1..], &word[..i]].concat());
            word = [inverse(x), y].concat();
            form.crosscaps += 1;
        } else {
            let [i, j, k, l] = interlaced(&word).expect("an innermost pair that is not interlaced is adjacent");
            let (x, y, z) = (&word[i + 1..j], &word[j + 1..k], &word[k + 1..l]);
            word = [z, y, x, &word[l + 1..], &word[..i]].concat();
            form.handles += 1;
        }
    }
    form
}

/// Where each label stands.
fn pairs(word: &[Side]) -> BTreeMap<u32, Vec<usize>> {
    let mut pairs: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (i, side) in word.iter().enumerate() {
        pairs.entry(side.edge).or_default().push(i);
    }
    pairs
}

/// Two places of one side.
fn same_way(word: &[Side]) -> Option<(usize, usize)> {
    pairs(word).into_values().map(|p| (p[0], p[1])).find(|&(i, j)| word[i] == word[j])
}

/// Places a … b … A … B.
fn interlaced(word: &[Side]) -> Option<[usize; 4]> {
    let pairs: Vec<[usize; 2]> = pairs(word).into_values().map(|p| [p[0], p[1]]).collect();
    let crossing =
        |&[i, k]: &[usize; 2]| pairs.iter().find(|[j, l]| i < *j && *j < k && k < *l).map(|&[j, l]| [i, j, k, l]);
    pairs.iter().find_map(crossing)
}

/// The rank over ℤ/2 of the intersection form of a word's labels: two labels meet if they are interlaced, a label meets itself if
/// both its sides run one way. It is 2 − χ (Cohn and Lempel), and the surface is orientable iff the diagonal is 0 (ME-132).
///
/// # Panics
/// Iff a label does not stand just twice.
#[doc(alias = "ME-132")]
pub fn intersection_rank(word: &[Side]) -> usize {
    let pairs: Vec<[usize; 2]> =
        pairs(word).into_values().map(|p| <[usize; 2]>::try_from(p).expect("each label stands twice")).collect();
    let meets = |&[i, k]: &[usize; 2], &[j, l]: &[usize; 2]| {
        if i == j { word[i] == word[k] } else { (i < j && j < k) != (i < l && l < k) }
    };
    let rows = pairs.iter().map(|a| (0..pairs.len()).filter(|&b| meets(a, &pairs[b])).collect::<BTreeSet<usize>>());
    rank_mod_2(rows.collect())
}

/// The rank of a matrix over ℤ/2, by the sets of places of each row's ones.
pub(super) fn rank_mod_2(rows: Vec<BTreeSet<usize>>) -> usize {
    // The reduced rows, by their first ones.
    let mut reduced: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for mut row in rows {
        while let Some(first) = row.first() {
            match reduced.get(first) {
                Some(other) => row = row.symmetric_difference(other).copied().collect(),
                None => {
                    reduced.insert(*first, row);
                    break;
                }
            }
        }
    }
    reduced.len()
}

//! Sets of real numbers that are finite unions of points and open intervals, with rational ends.

use crate::number::Rational;

/// A finite union of points and open intervals, also unbounded ones, by its cells: (−∞, p₁), {p₁}, (p₁, p₂), …, {pₙ},
/// (pₙ, ∞).
///
/// Normal form: no end pᵢ lies, with both its sides, in the set or out of it. So two of them are equal iff they are
/// the same set. CU-221.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-221")]
pub struct LineSet {
    ends: Vec<Rational>,
    /// Which of the 2n + 1 cells are in the set.
    cells: Vec<bool>,
}

impl LineSet {
    /// ∅.
    pub fn empty() -> LineSet {
        LineSet { ends: Vec::new(), cells: vec![false] }
    }

    /// ℝ.
    pub fn line() -> LineSet {
        LineSet { ends: Vec::new(), cells: vec![true] }
    }

    /// {x}.
    pub fn point(x: Rational) -> LineSet {
        LineSet { ends: vec![x], cells: vec![false, true, false] }
    }

    /// (a, b), where `None` is infinite; ∅ where a ≥ b.
    pub fn interval(a: Option<Rational>, b: Option<Rational>) -> LineSet {
        let above = a.map_or(LineSet::line(), |a| LineSet { ends: vec![a], cells: vec![false, false, true] });
        let below = b.map_or(LineSet::line(), |b| LineSet { ends: vec![b], cells: vec![true, false, false] });
        above.intersection(&below)
    }

    /// A ∪ B.
    pub fn union(&self, other: &LineSet) -> LineSet {
        self.combined(other, |a, b| a || b)
    }

    /// A ∩ B.
    pub fn intersection(&self, other: &LineSet) -> LineSet {
        self.combined(other, |a, b| a && b)
    }

    /// A ∖ B.
    pub fn difference(&self, other: &LineSet) -> LineSet {
        self.combined(other, |a, b| a && !b)
    }

    /// Whether x is in the set.
    pub fn contains(&self, x: &Rational) -> bool {
        match self.ends.binary_search(x) {
            Ok(i) => self.cells[2 * i + 1],
            Err(i) => self.cells[2 * i],
        }
    }

    /// Whether the set is open in ℝ: each of its points pᵢ has both sides in it.
    pub fn is_open(&self) -> bool {
        (0..self.ends.len()).all(|i| !self.cells[2 * i + 1] || (self.cells[2 * i] && self.cells[2 * i + 2]))
    }

    /// Whether the set is countable: it has no interval.
    pub fn is_countable(&self) -> bool {
        self.cells.iter().step_by(2).all(|cell| !cell)
    }

    /// Its connected components from left to right: runs of cells in the set. CU-224.
    pub fn components(&self) -> Vec<LineSet> {
        let mut runs: Vec<Vec<bool>> = Vec::new();
        for i in (0..self.cells.len()).filter(|i| self.cells[*i]) {
            if i == 0 || !self.cells[i - 1] {
                runs.push(vec![false; self.cells.len()]);
            }
            let run = runs.last_mut().expect("a run begins with its first cell");
            run[i] = true;
        }
        runs.into_iter().map(|cells| normal(self.ends.clone(), cells)).collect()
    }

    /// Whether the set is connected: an interval of some kind, a point, or ∅. CU-223.
    pub fn is_connected(&self) -> bool {
        self.components().len() <= 1
    }

    /// The open sets among families that are closed under countable unions and finite intersections, but not under all
    /// unions: at most countable sets, and ℝ. They satisfy the printed axioms of a topology (002, definition 3.13).
    /// CU-220.
    #[doc(alias = "CU-220")]
    pub fn is_open_printed(&self) -> bool {
        self.is_countable() || *self == LineSet::line()
    }

    fn combined(&self, other: &LineSet, rule: impl Fn(bool, bool) -> bool) -> LineSet {
        let mut ends: Vec<Rational> = self.ends.iter().chain(&other.ends).cloned().collect();
        ends.sort();
        ends.dedup();
        let cell = |set: &LineSet, i: usize| match i % 2 {
            1 => set.contains(&ends[i / 2]),
            // An open gap of the finer division lies in one cell of each.
            _ => match ends.get(i / 2) {
                Some(end) => set.cells[2 * set.ends.partition_point(|p| p < end)],
                None => *set.cells.last().expect("there is at least one cell"),
            },
        };
        let cells = (0..=2 * ends.len()).map(|i| rule(cell(self, i), cell(other, i))).collect();
        normal(ends, cells)
    }
}

/// Without the ends at which nothing changes.
fn normal(ends: Vec<Rational>, cells: Vec<bool>) -> LineSet {
    let mut set = LineSet { ends: Vec::new(), cells: vec![cells[0]] };
    for (i, end) in ends.into_iter().enumerate() {
        let [before, at, after] = [cells[2 * i], cells[2 * i + 1], cells[2 * i + 2]];
        if before != at || at != after {
            set.ends.push(end);
            set.cells.extend([at, after]);
        }
    }
    set
}

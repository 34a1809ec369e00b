//! The parts of a cell by its cuts across one axis: a second way to what `cell` decides.
//!
//! Nothing is asked of the faces along the axis, nor which class the cell is of: only what is negative together at
//! one height.

use super::cube::Corner;
use crate::number::Rational;
use crate::partition::Partition;

/// The open interval of heights at which the value on a line across the cuts is negative.
type Heights = [Rational; 2];

/// A line along the axis: its two corners, and the values there.
struct Line<'a> {
    corners: [Corner; 2],
    values: [&'a Rational; 2],
}

impl Line<'_> {
    fn at(&self, w: &Rational) -> Rational {
        Rational::from(self.values[1] - self.values[0]) * w + self.values[0]
    }

    /// Where the value is of a sign (1 or −1), `None` where nowhere.
    fn heights(&self, sign: i32) -> Option<Heights> {
        let is_of_sign = self.values.map(|v| Rational::from(v * sign) > 0);
        let zero = || self.values[0] / Rational::from(self.values[0] - self.values[1]);
        match is_of_sign {
            [false, false] => None,
            [true, true] => Some([Rational::new(), Rational::from(1)]),
            [true, false] => Some([Rational::new(), zero()]),
            [false, true] => Some([zero(), Rational::from(1)]),
        }
    }
}

fn meet(a: &Heights, b: &Heights) -> Option<Heights> {
    let both = [a[0].clone().max(b[0].clone()), a[1].clone().min(b[1].clone())];
    (both[0] < both[1]).then_some(both)
}

/// The corners of each part of {f < 0} (`sign` −1) or {f > 0} (`sign` 1), sorted: the components of the graph whose
/// nodes are the lines along the axis with a point of that sign. Two neighbouring lines are linked where both have it at
/// one height; two opposite ones where, besides, the cut there joins them: the text's test, asked for *some* cut, not for
/// all (IS-61, IS-85).
///
/// The isovalue 0 is no corner's value and no critical value.
///
/// # Panics
/// Iff the axis is none of 0, 1, 2.
#[doc(alias = "IS-61")]
#[doc(alias = "IS-85")]
pub fn parts(values: &[Rational; 8], axis: usize, sign: i32) -> Vec<Vec<Corner>> {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let base = Corner::ALL[0];
    let lines = [base, base.across(u), base.across(u).across(v), base.across(v)].map(|low| {
        let corners = [low, low.across(axis)];
        Line { corners, values: corners.map(|c| &values[c.index()]) }
    });
    let heights = lines.each_ref().map(|line| line.heights(sign));
    let mut linked = Partition::new(4);
    for p in 0..4 {
        let q = (p + 1) % 4;
        if let (Some(a), Some(b)) = (&heights[p], &heights[q])
            && meet(a, b).is_some()
        {
            linked.join(p, q);
        }
    }
    for p in 0..2 {
        if joined_in_some_cut(&lines, p, sign) {
            linked.join(p, p + 2);
        }
    }
    let mut parts: Vec<Vec<Corner>> = vec![Vec::new(); 4];
    for (p, line) in lines.iter().enumerate() {
        let of_sign = line.corners.into_iter().filter(|c| Rational::from(&values[c.index()] * sign) > 0);
        parts[linked.find(p)].extend(of_sign);
    }
    parts.retain(|corners| !corners.is_empty());
    parts.iter_mut().for_each(|corners| corners.sort());
    parts.sort();
    parts
}

/// Whether at some height lines p and p + 2 are of the sign, the two others of the other one, and the determinant
/// D = PR − QS of the cut is positive.
fn joined_in_some_cut(lines: &[Line; 4], p: usize, sign: i32) -> bool {
    let stretch = [(p, sign), (p + 2, sign), (p + 1, -sign), ((p + 3) % 4, -sign)]
        .iter()
        .try_fold([Rational::new(), Rational::from(1)], |met, (line, sign)| meet(&met, &lines[*line].heights(*sign)?));
    let Some([low, high]) = stretch else { return false };
    let determinant =
        |w: &Rational| lines[p].at(w) * lines[p + 2].at(w) - lines[p + 1].at(w) * lines[(p + 3) % 4].at(w);
    // D = D₀ + D₁w + D₂w²: if it is positive anywhere, it is so at an end or at its extreme point.
    let [start, middle, end] = [Rational::new(), Rational::from((1, 2)), Rational::from(1)].map(|w| determinant(&w));
    let second: Rational = (Rational::from(&start + &end) - middle * 2) * 2;
    let first = end - &start - &second;
    let extreme = (!second.is_zero()).then(|| -first / (second * 2)).filter(|w| *w > low && *w < high);
    [Some(low), Some(high), extreme].iter().flatten().any(|w| determinant(w) > 0)
}

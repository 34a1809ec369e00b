//! Boxes of vertices, halved.

use super::Point;

/// A vertex.
pub(super) struct Item {
    /// Its position.
    pub at: Point,
    /// Its number.
    pub id: u32,
}

/// A closed box.
pub(super) struct Bounds {
    low: Point,
    high: Point,
}

impl Bounds {
    /// The least box around vertices; none without vertices.
    pub(super) fn of(items: &[Item]) -> Option<Bounds> {
        let first = items.first()?.at;
        let mut bounds = Bounds { low: first, high: first };
        for item in items {
            for i in 0..3 {
                bounds.low[i] = bounds.low[i].min(item.at[i]);
                bounds.high[i] = bounds.high[i].max(item.at[i]);
            }
        }
        Some(bounds)
    }

    /// The lower and the upper half of these vertices along the longest side of their box, by number.
    pub(super) fn halves<'a>(&self, items: &'a mut [Item]) -> (&'a mut [Item], &'a mut [Item]) {
        let axis = self.longest_axis();
        let middle = items.len() / 2;
        items.select_nth_unstable_by(middle, |a, b| a.at[axis].total_cmp(&b.at[axis]));
        items.split_at_mut(middle)
    }

    fn longest_axis(&self) -> usize {
        let length = |i: usize| self.high[i] - self.low[i];
        (0..3).max_by(|&i, &j| length(i).total_cmp(&length(j))).expect("three axes")
    }

    /// Whether a segment may have a point in the box: false only where a plane separates them. ME-149.
    ///
    /// The planes tried are those along the faces of the box, by comparison alone, and those that contain the segment and
    /// are parallel to an axis: with d = b − a, the box is on one side of the latter if
    /// |dⱼ(mₖ − aₖ) − dₖ(mⱼ − aⱼ)| > |dⱼ|hₖ + |dₖ|hⱼ for its midpoint m and its half sides h; rounding is outweighed by 16ε
    /// times the sum of the products of all magnitudes.
    #[doc(alias = "ME-149")]
    pub(super) fn may_meet(&self, [a, b]: [&Point; 2]) -> bool {
        let apart = |i: usize| a[i].max(b[i]) < self.low[i] || a[i].min(b[i]) > self.high[i];
        if (0..3).any(apart) {
            return false;
        }
        // A short edge gains nothing from the other three.
        let long = |i: usize| (b[i] - a[i]).abs() > self.high[i] - self.low[i];
        !(0..3).any(long) || !(0..3).any(|axis| self.passes_by(axis, a, b))
    }

    fn passes_by(&self, axis: usize, a: &Point, b: &Point) -> bool {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let (dj, dk) = (b[j] - a[j], b[k] - a[k]);
        let middle = |i: usize| self.low[i] / 2.0 + self.high[i] / 2.0;
        let half = |i: usize| self.high[i] / 2.0 - self.low[i] / 2.0;
        let distance = dj * (middle(k) - a[k]) - dk * (middle(j) - a[j]);
        let reach = dj.abs() * half(k) + dk.abs() * half(j);
        let magnitude = |i: usize| self.low[i].abs().max(self.high[i].abs()) + a[i].abs();
        let error = 8.0 * f64::EPSILON * (dj.abs() * magnitude(k) + dk.abs() * magnitude(j));
        // Underflows: where a factor is tiny the other one may be large, but not beyond 2¹⁰⁰ here.
        let moderate = [a, b, &self.low, &self.high].iter().all(|p| p.iter().all(|x| x.abs() < 2_f64.powi(100)));
        moderate && distance.abs() > reach + error + 2_f64.powi(-900)
    }
}

//! The vertices strictly inside edges, among millions of both.

use super::Point;
use super::exact::strictly_between;
use crate::mesh::triangles::EdgeKey;

/// A vertex and the edge that it lies strictly inside.
pub type Junction = (u32, EdgeKey);

/// The vertices strictly inside edges, sorted, and whether these are all: the search stops at `limit` of them.
///
/// A tree over the vertices, halved along the longest side of their box again and again; the edges go down it, each
/// into those halves whose box it meets. Both together cost about log(vertices) steps an edge, however uneven the mesh.
pub fn junctions(
    points: &[Point],
    vertices: impl Iterator<Item = u32>,
    edges: &[EdgeKey],
    limit: usize,
) -> (Vec<Junction>, bool) {
    let mut items: Vec<Item> = vertices.map(|id| Item { at: points[id as usize], id }).collect();
    let mut search = Search { points, edges, limit, found: Vec::new() };
    let all = (0..edges.len() as u32).collect();
    search.descend(&mut items, all);
    let complete = search.found.len() <= limit;
    search.found.truncate(limit);
    search.found.sort_unstable();
    (search.found, complete)
}

struct Item {
    at: Point,
    id: u32,
}

struct Search<'a> {
    points: &'a [Point],
    edges: &'a [EdgeKey],
    limit: usize,
    found: Vec<Junction>,
}

/// So few of one kind are tried with all of the other.
const FEW_VERTICES: usize = 8;
const FEW_EDGES: usize = 4;

impl Search<'_> {
    fn descend(&mut self, items: &mut [Item], mut edges: Vec<u32>) {
        let Some(bounds) = Bounds::of(items) else { return };
        edges.retain(|&e| bounds.may_meet(self.ends(e)));
        if edges.is_empty() || self.found.len() > self.limit {
            return;
        }
        if items.len() <= FEW_VERTICES || edges.len() <= FEW_EDGES {
            return self.try_all(items, &edges);
        }
        let axis = bounds.longest_axis();
        let middle = items.len() / 2;
        items.select_nth_unstable_by(middle, |a, b| a.at[axis].total_cmp(&b.at[axis]));
        let (low, high) = items.split_at_mut(middle);
        self.descend(low, edges.clone());
        self.descend(high, edges);
    }

    fn try_all(&mut self, items: &[Item], edges: &[u32]) {
        for &e in edges {
            let edge = self.edges[e as usize];
            let [a, b] = edge.map(|v| &self.points[v as usize]);
            for item in items {
                if !edge.contains(&item.id) && strictly_between(&item.at, a, b) {
                    self.found.push((item.id, edge));
                }
            }
            if self.found.len() > self.limit {
                return;
            }
        }
    }

    fn ends(&self, edge: u32) -> [&Point; 2] {
        self.edges[edge as usize].map(|v| &self.points[v as usize])
    }
}

/// A closed box.
struct Bounds {
    low: Point,
    high: Point,
}

impl Bounds {
    fn of(items: &[Item]) -> Option<Bounds> {
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
    fn may_meet(&self, [a, b]: [&Point; 2]) -> bool {
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

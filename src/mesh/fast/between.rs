//! The vertices strictly inside edges, among millions of both.

use super::Point;
use super::bounds::{Bounds, Item};
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
        let (low, high) = bounds.halves(items);
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

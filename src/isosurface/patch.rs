//! The triangles of one cell: a disk or an annulus on given boundary loops (IS-77, IS-91).
//!
//! No triangle edge may lie in a face of the cell but the face's own arcs. Two crossings on one face are
//! therefore never joined by an inner edge: the cell across that face could hold the same edge, and an
//! edge with four triangles would come of it, which no look at a single cell can see.

use super::cell::Topology;
use super::cube::{Edge, Face};

/// A vertex of a cell's triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PatchVertex {
    /// Where the surface crosses an edge of the cell.
    Crossing(Edge),
    /// An inner point of the cell, an index into [`Patch::inner`].
    Inner(u8),
}

/// The triangles of a cell, in terms of its crossed edges.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Patch {
    /// Each inner vertex is the mean of these crossings.
    pub inner: Vec<Vec<Edge>>,
    /// The triangles, with their normals toward f > c.
    pub triangles: Vec<[PatchVertex; 3]>,
}

/// Whether the segment between two crossings would lie in a face of the cell (IS-91).
#[doc(alias = "IS-91")]
pub fn share_a_face(a: Edge, b: Edge) -> bool {
    Face::ALL.into_iter().any(|face| a.in_face(face) && b.in_face(face))
}

/// Twice the squared distance between the midpoints of two edges, the length by which patches are chosen.
fn length(a: Edge, b: Edge) -> u32 {
    let middle = |e: Edge| {
        let [p, q] = e.corners().map(|c| c.position());
        [0, 1, 2].map(|i| i32::from(p[i] + q[i]))
    };
    let (a, b) = (middle(a), middle(b));
    (0..3).map(|i| (a[i] - b[i]).pow(2) as u32).sum()
}

/// The triangles of a cell: a shortest allowed triangulation of each component, with an inner vertex
/// only where the crossings alone allow none.
pub fn patch(topology: &Topology) -> Patch {
    let mut patch = Patch::default();
    for component in &topology.components {
        let loops: Vec<&[Edge]> = component.loops.iter().map(|&l| topology.loops[l].as_slice()).collect();
        match loops[..] {
            [rim] => patch.disk(rim),
            [first, second] => patch.annulus(first, second),
            _ => unreachable!("a component in a cell is a disk or an annulus (IS-77)"),
        }
    }
    patch
}

impl Patch {
    fn disk(&mut self, rim: &[Edge]) {
        match polygon(rim) {
            Some(triangles) => self.triangles.extend(triangles.into_iter().map(|t| t.map(PatchVertex::Crossing))),
            None => self.cone(rim),
        }
    }

    fn annulus(&mut self, first: &[Edge], second: &[Edge]) {
        for piece in strip(first, second) {
            match piece[..] {
                [a, b, c] => self.triangles.push([a, b, c].map(PatchVertex::Crossing)),
                _ => self.cone(&piece),
            }
        }
    }

    /// A polygon as triangles around an inner vertex.
    fn cone(&mut self, rim: &[Edge]) {
        self.inner.push(rim.to_vec());
        let centre = PatchVertex::Inner(u8::try_from(self.inner.len() - 1).expect("few inner vertices"));
        for (i, &a) in rim.iter().enumerate() {
            let b = rim[(i + 1) % rim.len()];
            self.triangles.push([PatchVertex::Crossing(a), PatchVertex::Crossing(b), centre]);
        }
    }
}

/// The triangulation of a closed polygon of crossings whose inner edges are allowed and shortest in sum; none
/// where an inner vertex is needed (IS-90).
#[doc(alias = "IS-90")]
fn polygon(rim: &[Edge]) -> Option<Vec<[Edge; 3]>> {
    let n = rim.len();
    // best[i][j]: cost and apex of the best triangulation of rim[i..=j].
    let mut best = vec![vec![None::<(u32, usize)>; n]; n];
    for i in 0..n - 1 {
        best[i][i + 1] = Some((0, i));
    }
    for span in 2..n {
        for i in 0..n - span {
            let j = i + span;
            let is_rim = span == n - 1;
            if !is_rim && share_a_face(rim[i], rim[j]) {
                continue;
            }
            let chord = if is_rim { 0 } else { length(rim[i], rim[j]) };
            best[i][j] = (i + 1..j).filter_map(|k| Some((best[i][k]?.0 + best[k][j]?.0 + chord, k))).min();
        }
    }
    best[0][n - 1]?;
    let mut triangles = Vec::new();
    let mut open = vec![(0, n - 1)];
    while let Some((i, j)) = open.pop() {
        if j - i < 2 {
            continue;
        }
        let (_, k) = best[i][j].expect("a part of a triangulation is triangulated");
        triangles.push([rim[i], rim[k], rim[j]]);
        open.extend([(i, k), (k, j)]);
    }
    Some(triangles)
}

/// What an inner vertex costs, more than any strip of allowed edges.
const CONE: u32 = 1000;

/// The shortest strip of polygons between two loops, both oriented as its boundary: triangles, and, where
/// no allowed rung is near, larger polygons, each of which a cone over an inner vertex will fill (IS-92).
#[doc(alias = "IS-92")]
fn strip(first: &[Edge], second: &[Edge]) -> Vec<Vec<Edge>> {
    let shortest = (0..first.len())
        .flat_map(|i| (0..second.len()).map(move |j| (i, j)))
        .filter(|&(i, j)| !share_a_face(first[i], second[j]))
        .filter_map(|(i, j)| {
            // The strip advances along the first loop and, as both are its boundary, backward along the second.
            let first: Vec<_> = first[i..].iter().chain(&first[..=i]).copied().collect();
            let second: Vec<_> = second[..=j].iter().rev().chain(second[j..].iter().rev()).copied().collect();
            let mut search = Search { first, second, best: None };
            search.extend(&mut vec![[0, 0]], 0);
            search.best
        })
        .min();
    let (_, pieces) = shortest.expect("the two loops of a tunnel have at least two allowed rungs (IS-92)");
    pieces
}

/// The search for the shortest strip from a given rung around to the same rung.
struct Search {
    /// The loops from that rung on, the way the strip goes, its vertex at both ends.
    first: Vec<Edge>,
    second: Vec<Edge>,
    /// Length and polygons of the best strip so far.
    best: Option<(u32, Vec<Vec<Edge>>)>,
}

impl Search {
    fn ends(&self, [i, j]: [usize; 2]) -> [Edge; 2] {
        [self.first[i], self.second[j]]
    }

    /// Extends the strip, whose rungs so far are given, by every further rung.
    fn extend(&mut self, rungs: &mut Vec<[usize; 2]>, cost: u32) {
        let (n, m) = (self.first.len() - 1, self.second.len() - 1);
        let [i, j] = *rungs.last().expect("the strip starts with a rung");
        if self.best.as_ref().is_some_and(|(best, _)| *best < cost) {
            return;
        }
        if [i, j] == [n, m] {
            let pieces = rungs.windows(2).map(|pair| {
                let [[a, b], [c, d]] = [pair[0], pair[1]];
                self.first[a..=c].iter().chain(self.second[b..=d].iter().rev()).copied().collect()
            });
            let candidate = (cost, pieces.collect());
            self.best = Some(self.best.take().map_or(candidate.clone(), |best| best.min(candidate)));
            return;
        }
        for next in (i..=n).flat_map(|a| (j..=m).map(move |b| [a, b])) {
            let (along_first, along_second) = (next[0] - i, next[1] - j);
            let [p, q] = self.ends(next);
            // A piece that went all around a loop would meet itself, and so would a rung that is met twice;
            // only the last one is the first one again.
            let is_new = next == [n, m] || rungs.iter().all(|rung| self.ends(*rung) != [p, q]);
            if along_first + along_second > 0 && along_first < n && along_second < m && is_new && !share_a_face(p, q) {
                let filling = if along_first + along_second == 1 { 0 } else { CONE };
                rungs.push(next);
                self.extend(rungs, cost + filling + length(p, q));
                rungs.pop();
            }
        }
    }
}

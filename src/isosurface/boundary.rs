//! The curves that a level set cuts out of the boundary of a cell.

use super::cell::Decisions;
use super::cube::{Edge, Face};

/// The arcs of the level set on a face, from crossed edge to crossed edge, with f > c on the left when
/// the face is seen from outside the cell.
pub fn arcs(decisions: &Decisions, face: Face) -> Vec<[Edge; 2]> {
    let corners = face.cycle();
    let positive = corners.map(|c| decisions.is_positive(c));
    let side = |i: usize| {
        Edge::between(corners[i % 4], corners[(i + 1) % 4]).expect("neighbours in the cycle of a face share an edge")
    };
    // Counter-clockwise, an arc starts where f falls below c and ends where f next rises above it: it
    // closes the region of a positive run behind it, or of a negative run ahead.
    let falls = (0..4).filter(|&i| positive[i] && !positive[(i + 1) % 4]);
    let rise = |from: usize, ahead: bool| {
        (1..4)
            .map(|step| if ahead { from + step } else { from + 4 - step })
            .find(|&i| !positive[i % 4] && positive[(i + 1) % 4])
            .map(side)
            .expect("what falls below c on a closed curve rises above it again")
    };
    // Where positive corners are joined, arcs cut off the negative run ahead; else the positive one behind.
    falls.map(|i| [side(i), rise(i, decisions.faces[face.index()] > 0)]).collect()
}

/// The closed curves of the level set on the cell's boundary, each a cycle of crossed edges with f > c
/// on the left, seen from outside; a cycle starts at its smallest edge, and cycles are sorted (IS-76).
#[doc(alias = "IS-76")]
pub fn loops(decisions: &Decisions) -> Vec<Vec<Edge>> {
    let mut next = [None; 12];
    for [from, to] in Face::ALL.into_iter().flat_map(|face| arcs(decisions, face)) {
        next[from.index()] = Some(to);
    }
    let mut loops = Vec::new();
    for start in Edge::ALL {
        let mut cycle = Vec::new();
        let mut here = start;
        while let Some(to) = next[here.index()].take() {
            cycle.push(here);
            here = to;
        }
        if !cycle.is_empty() {
            loops.push(cycle);
        }
    }
    loops
}

//! Whether a surface has two sides: an orientation, or a path that comes back mirrored.

use super::gluing::{Gluing, Place};
use std::collections::VecDeque;

/// What a gluing is oriented by, or why it cannot be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Orientation {
    /// For each polygon whether it is to be turned over; then every edge of two sides is run along both ways.
    Oriented(Vec<bool>),
    /// A closed path from polygon to polygon that comes back mirrored: its neighbourhood is a Möbius band.
    Reversing(Vec<Crossing>),
}

/// A step from a polygon through an edge to a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Crossing {
    /// The side that it leaves through.
    pub from: Place,
    /// The side that it comes in through.
    pub to: Place,
}

impl Gluing {
    /// An orientation, or a path that excludes one (ME-126).
    #[doc(alias = "ME-126")]
    #[doc(alias = "ME-142")]
    pub fn orientation(&self) -> Orientation {
        let n = self.polygons().len();
        let mut turned: Vec<Option<bool>> = vec![None; n];
        let mut reached_by: Vec<Option<Crossing>> = vec![None; n];
        let mut queue = VecDeque::new();
        for root in 0..n {
            if turned[root].is_none() {
                turned[root] = Some(false);
                queue.push_back((root, false));
            }
            while let Some((polygon, is_turned)) = queue.pop_front() {
                for crossing in self.crossings(polygon) {
                    let wanted = is_turned != self.mirrors(&crossing);
                    match turned[crossing.to.polygon] {
                        None => {
                            turned[crossing.to.polygon] = Some(wanted);
                            reached_by[crossing.to.polygon] = Some(crossing);
                            queue.push_back((crossing.to.polygon, wanted));
                        }
                        Some(found) if found == wanted => {}
                        Some(_) => return Orientation::Reversing(closed_path(&reached_by, crossing)),
                    }
                }
            }
        }
        Orientation::Oriented(turned.into_iter().map(|t| t.expect("every polygon was reached")).collect())
    }

    /// Whether it can be oriented (ME-144).
    #[doc(alias = "ME-144")]
    pub fn is_orientable(&self) -> bool {
        match self.orientation() {
            Orientation::Oriented(_) => true,
            Orientation::Reversing(_) => false,
        }
    }

    /// The ways out of a polygon, through its glued sides in order.
    pub fn crossings(&self, polygon: usize) -> impl Iterator<Item = Crossing> {
        self.polygons()[polygon].iter().enumerate().filter_map(move |(side, label)| {
            let from = Place { polygon, side };
            let to = self.places()[&label.edge].iter().find(|place| **place != from)?;
            Some(Crossing { from, to: *to })
        })
    }

    /// Whether both polygons run along the edge the same way, so that one of them has to be turned over.
    pub fn mirrors(&self, crossing: &Crossing) -> bool {
        let forward = |place: &Place| self.polygons()[place.polygon][place.side].forward;
        forward(&crossing.from) == forward(&crossing.to)
    }

    /// Whether these steps are a closed path through the gluing that comes back mirrored.
    pub fn is_reversing(&self, path: &[Crossing]) -> bool {
        let follows = |i: usize| path[i].to.polygon == path[(i + 1) % path.len()].from.polygon;
        let exists =
            |c: &Crossing| c.from.polygon < self.polygons().len() && self.crossings(c.from.polygon).any(|d| d == *c);
        let mirrored = || path.iter().filter(|c| self.mirrors(c)).count();
        (0..path.len()).all(follows) && path.iter().all(exists) && mirrored() % 2 == 1
    }
}

/// The path in the tree to the crossing's start, the crossing, and back; less what both branches have in common.
fn closed_path(reached_by: &[Option<Crossing>], crossing: Crossing) -> Vec<Crossing> {
    let branch = |end: usize| {
        let mut steps: Vec<Crossing> =
            std::iter::successors(reached_by[end], |step| reached_by[step.from.polygon]).collect();
        steps.reverse();
        steps
    };
    let (there, back) = (branch(crossing.from.polygon), branch(crossing.to.polygon));
    let common = there.iter().zip(&back).take_while(|(a, b)| a == b).count();
    let returned = back[common..].iter().rev().map(|step| Crossing { from: step.to, to: step.from });
    there[common..].iter().copied().chain([crossing]).chain(returned).collect()
}

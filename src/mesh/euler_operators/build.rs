//! Any closed mesh from nothing: the sequence of operators that builds it.

use super::boundary::Boundary;
use super::names::{FaceId, HalfEdge, LoopId, Name, ShellId, VertexId};
use super::{Corner, Operator, Refused};
use thiserror::Error;

/// A step of a sequence that is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("step {step}: {refused}")]
pub struct RefusedStep {
    /// Its number, from 0.
    pub step: usize,
    /// Why.
    pub refused: Refused,
}

/// The sequence's boundary, made of nothing.
///
/// # Errors
/// Iff a step is refused; the first one is told.
pub fn replay(operators: &[Operator]) -> Result<Boundary, RefusedStep> {
    let mut boundary = Boundary::new();
    for (step, operator) in operators.iter().enumerate() {
        boundary.apply(operator).map_err(|refused| RefusedStep { step, refused })?;
    }
    Ok(boundary)
}

/// Operators that build a boundary from nothing, to the names (ME-113): C mvfs; G times mef, kfmrh and mekr, for the
/// handles; V − C mev; F − C mef; and H kemr, for the rings. These are C + G + E + 2H steps.
#[doc(alias = "ME-113")]
pub fn construction(boundary: &Boundary) -> Vec<Operator> {
    let mut taken_apart = TakenApart { left: boundary.clone(), undone_by: Vec::new() };
    taken_apart.join_rings();
    taken_apart.merge_faces();
    taken_apart.merge_vertices();
    boundary.shells().for_each(|shell| taken_apart.remove_handles(shell));
    boundary.shells().for_each(|shell| taken_apart.step(Operator::Kvfs { shell }));
    taken_apart.undone_by.reverse();
    taken_apart.undone_by
}

/// What is left of a boundary, and the inverses of the steps that were taken, the first one first.
struct TakenApart {
    left: Boundary,
    undone_by: Vec<Operator>,
}

impl TakenApart {
    fn step(&mut self, operator: Operator) {
        self.undone_by.push(self.left.apply(&operator).expect("each step is chosen where it is allowed"));
    }

    /// Joins each ring to its face's outer loop: no rings are left.
    fn join_rings(&mut self) {
        let rings: Vec<(FaceId, LoopId)> =
            self.left.faces().flat_map(|f| self.left.rings(f).map(move |ring| (f, ring))).collect();
        for (face, ring) in rings {
            let outer = self.left.faces[&face].outer;
            let [from, to] = [outer, ring].map(|l| self.left.some_corner(l));
            let half_edge = self.left.unused_half_edge();
            self.step(Operator::Mekr { from, to, half_edge });
        }
    }

    /// Kills every edge between two faces with one of them, the shorter one: each shell is left with a face. Merging makes
    /// no edge one between two faces, so that each edge is looked at once.
    fn merge_faces(&mut self) {
        for x in self.left.half_edges().collect::<Vec<_>>() {
            if let (Some(l), Some(m)) = (self.left.loop_of(x), self.left.loop_of(x.mate()))
                && l != m
            {
                let length = |l: LoopId| self.left.loops[&l].half_edges.len();
                let half_edge = if length(l) < length(m) { x } else { x.mate() };
                self.step(Operator::Kef { half_edge });
            }
        }
    }

    /// Kills every edge between two vertices with one of them: each shell is left with a vertex.
    fn merge_vertices(&mut self) {
        for x in self.left.half_edges().collect::<Vec<_>>() {
            if let (Some(v), Some(w)) = (self.left.origin(x), self.left.origin(x.mate()))
                && v != w
            {
                let degree = |v: VertexId| self.left.vertices[&v].half_edges.len();
                let half_edge = if degree(v) < degree(w) { x.mate() } else { x };
                self.step(Operator::Kev { half_edge });
            }
        }
    }

    /// Takes a shell of one vertex, one face and 2g edges to one vertex and one face. The loop falls into two along an
    /// edge; the ring becomes a face, and as all edges are in one cycle around the vertex, one of them is between the two
    /// faces.
    fn remove_handles(&mut self, shell: ShellId) {
        let of_shell = |f: &FaceId| self.left.shell_of(*f) == Some(shell);
        let face = self.left.faces().find(of_shell).expect("a shell has a face");
        let outer = self.left.faces[&face].outer;
        while let Some(&half_edge) = self.left.loops[&outer].half_edges.first() {
            let ring = self.left.unused_loop();
            self.step(Operator::Kemr { half_edge, ring });
            let face = self.left.unused_face();
            self.step(Operator::Mfkrh { ring, face });
            let between = |h: &&HalfEdge| self.left.loop_of(h.mate()) == Some(outer);
            let edge = self.left.loops[&ring].half_edges.iter().find(between);
            let half_edge = *edge.expect("the edges at the vertex are one cycle");
            self.step(Operator::Kef { half_edge });
        }
    }
}

impl Boundary {
    /// The first corner of a loop.
    fn some_corner(&self, l: LoopId) -> Corner {
        let record = &self.loops[&l];
        let lone = record.alone.map(Corner::Alone);
        let first = record.half_edges.first().map(|h| Corner::Before(*h));
        lone.or(first).expect("a loop has a vertex or half-edges")
    }

    /// A vertex that does not exist.
    pub fn unused_vertex(&self) -> VertexId {
        VertexId(unused(self.vertices.last_key_value().map(|(v, _)| v.0), |n| self.has(Name::Vertex(VertexId(n)))))
    }

    /// A half-edge that does not exist, the first of its edge.
    pub fn unused_half_edge(&self) -> HalfEdge {
        let last = self.half_edges.last_key_value().map(|(h, _)| h.0 / 2);
        HalfEdge(2 * unused(last, |n| n > u32::MAX / 2 || self.has(Name::HalfEdge(HalfEdge(2 * n)))))
    }

    /// A loop that does not exist.
    pub fn unused_loop(&self) -> LoopId {
        LoopId(unused(self.loops.last_key_value().map(|(l, _)| l.0), |n| self.has(Name::Loop(LoopId(n)))))
    }

    /// A face that does not exist.
    pub fn unused_face(&self) -> FaceId {
        FaceId(unused(self.faces.last_key_value().map(|(f, _)| f.0), |n| self.has(Name::Face(FaceId(n)))))
    }

    /// A shell that does not exist.
    pub fn unused_shell(&self) -> ShellId {
        ShellId(unused(self.shells.last().map(|s| s.0), |n| self.has(Name::Shell(ShellId(n)))))
    }
}

/// The number after the last, or where that is taken, the first that is not.
fn unused(last: Option<u32>, is_taken: impl Fn(u32) -> bool) -> u32 {
    let after = last.map_or(Some(0), |n| n.checked_add(1)).filter(|n| !is_taken(*n));
    after.unwrap_or_else(|| (0..u32::MAX).find(|n| !is_taken(*n)).expect("fewer than 2³² names are in use"))
}

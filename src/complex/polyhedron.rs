//! When edges and faces make a sphere, and so bound a ball.

use super::scheme::{Polyhedron, SignedEdge};
use crate::mesh::classify::Surface;
use crate::mesh::gluing::{Gluing, Side};
use std::collections::BTreeMap;
use thiserror::Error;

/// What keeps the faces of a polyhedron from making a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum PolyhedronFlaw {
    /// There is no face.
    #[error("it has no face")]
    NoFace,
    /// A face without sides.
    #[error("face {face} has no side")]
    EmptyFace {
        /// The face.
        face: usize,
    },
    /// A side that is no edge of the polyhedron.
    #[error("side {side} of face {face} is edge {edge}; edges are ±1 … ±{edges}")]
    NoSuchEdge {
        /// The face.
        face: usize,
        /// The place in it.
        side: usize,
        /// The number that stands there.
        edge: i32,
        /// How many edges there are.
        edges: usize,
    },
    /// A side that does not begin where the one before it ends.
    #[error("side {side} of face {face} begins at vertex {begins}, where the side before it ends at vertex {ends}")]
    BrokenWalk {
        /// The face.
        face: usize,
        /// The place in it.
        side: usize,
        /// Where it begins.
        begins: u32,
        /// Where the side before it ends.
        ends: u32,
    },
    /// An edge that is not a side of just two faces, or twice of one.
    #[error("edge {} is a side {uses} times, not twice", .edge + 1)]
    EdgeUses {
        /// The index of the edge.
        edge: usize,
        /// How many sides are this edge.
        uses: usize,
    },
    /// An edge that is walked along twice the same way: the faces are not all seen from one side.
    #[error("edge {} is walked along twice the same way: one of its faces is seen from inside, the other from outside", .edge + 1)]
    SameDirection {
        /// The index of the edge.
        edge: usize,
    },
    /// A vertex at which several parts of the surface touch.
    #[error("at vertex {vertex} {fans} fans of faces touch")]
    Pinch {
        /// The vertex.
        vertex: u32,
        /// How many fans of faces it has.
        fans: usize,
    },
    /// A surface in several parts.
    #[error("its faces make {parts} surfaces")]
    Disconnected {
        /// How many.
        parts: usize,
    },
    /// Another surface than the sphere.
    #[error("its faces make a {0}, not a sphere")]
    NotASphere(Surface),
}

impl Polyhedron {
    /// Where a side begins and ends, as a face walks along it.
    pub fn ends(&self, side: SignedEdge) -> Option<[u32; 2]> {
        let [tail, head] = *self.edges.get(side.index()?)?;
        Some(if side.is_forward() { [tail, head] } else { [head, tail] })
    }

    /// The first thing that keeps its faces from making a sphere; none iff they do.
    ///
    /// They do iff each face is a closed walk, each edge is walked along twice, once each way, faces around a vertex make one
    /// fan, and the surface is connected with V − E + F = 2. A sphere bounds one ball, up to homeomorphism.
    #[doc(alias = "CX-1")]
    pub fn flaw(&self) -> Option<PolyhedronFlaw> {
        if self.faces.is_empty() {
            return Some(PolyhedronFlaw::NoFace);
        }
        self.walk_flaw().or_else(|| self.use_flaw()).or_else(|| self.surface_flaw())
    }

    fn walk_flaw(&self) -> Option<PolyhedronFlaw> {
        self.faces.iter().enumerate().find_map(|(face, sides)| {
            if sides.is_empty() {
                return Some(PolyhedronFlaw::EmptyFace { face });
            }
            let stray = sides.iter().position(|side| self.ends(*side).is_none());
            if let Some(side) = stray {
                return Some(PolyhedronFlaw::NoSuchEdge { face, side, edge: sides[side].0, edges: self.edges.len() });
            }
            (0..sides.len()).find_map(|side| {
                let before = sides[(side + sides.len() - 1) % sides.len()];
                let ([_, ends], [begins, _]) = (self.ends(before)?, self.ends(sides[side])?);
                (ends != begins).then_some(PolyhedronFlaw::BrokenWalk { face, side, begins, ends })
            })
        })
    }

    fn use_flaw(&self) -> Option<PolyhedronFlaw> {
        let mut uses = vec![[0, 0]; self.edges.len()];
        for side in self.faces.iter().flatten() {
            uses[side.index().expect("the walks were checked")][usize::from(side.is_forward())] += 1;
        }
        uses.iter().enumerate().find_map(|(edge, [back, forward])| match (back + forward, back) {
            (2, 1) => None,
            (2, _) => Some(PolyhedronFlaw::SameDirection { edge }),
            (uses, _) => Some(PolyhedronFlaw::EdgeUses { edge, uses }),
        })
    }

    fn surface_flaw(&self) -> Option<PolyhedronFlaw> {
        let side = |s: &SignedEdge| Side { edge: s.0.unsigned_abs(), forward: s.is_forward() };
        let gluing = Gluing::new(self.faces.iter().map(|sides| sides.iter().map(side).collect()).collect())
            .expect("each edge is a side twice");
        // The gluing has a vertex for each fan of faces.
        let mut fans: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (sides, corners) in self.faces.iter().zip(gluing.corners()) {
            for (side, corner) in sides.iter().zip(corners) {
                let [begins, _] = self.ends(*side).expect("the walks were checked");
                fans.entry(begins).or_default().push(*corner);
            }
        }
        for (vertex, mut corners) in fans {
            corners.sort_unstable();
            corners.dedup();
            if corners.len() > 1 {
                return Some(PolyhedronFlaw::Pinch { vertex, fans: corners.len() });
            }
        }
        match gluing.surfaces()[..] {
            [surface] if surface.euler_characteristic() == 2 => None,
            [surface] => Some(PolyhedronFlaw::NotASphere(surface)),
            ref parts => Some(PolyhedronFlaw::Disconnected { parts: parts.len() }),
        }
    }
}

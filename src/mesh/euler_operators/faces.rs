//! Boundaries of given faces.

use super::boundary::{Boundary, FaceRecord, Links, LoopRecord, VertexRecord};
use super::names::{FaceId, HalfEdge, LoopId, ShellId, VertexId};
use crate::mesh::face::{Face, edge, sides};
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// Why loops of half-edges are no boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Error)]
pub enum NotPaired {
    /// A face has no loops.
    #[error("face {face} has no loops")]
    NoLoops {
        /// The face.
        face: usize,
    },
    /// A half-edge stands twice.
    #[error("half-edge {n} stands twice", n = .0.0)]
    Repeated(HalfEdge),
    /// A half-edge stands there without its mate.
    #[error("half-edge {n} has no mate", n = .0.0)]
    NoMate(HalfEdge),
}

/// Why faces are no closed, consistently oriented surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Error)]
pub enum NotClosed {
    /// A loop has no vertices.
    #[error("face {face} has a loop without vertices")]
    EmptyLoop {
        /// The face.
        face: usize,
    },
    /// A side leads from a vertex to itself.
    #[error("face {face} has a side from vertex {vertex} to itself")]
    ClosedSide {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: u32,
    },
    /// Two sides run along an edge in the same direction.
    #[error("two sides run from vertex {a} to vertex {b}", a = .side[0], b = .side[1])]
    RepeatedSide {
        /// From one vertex to the other.
        side: [u32; 2],
    },
    /// No side runs along an edge in the other direction.
    #[error("a side runs from vertex {a} to vertex {b}, and none back", a = .side[0], b = .side[1])]
    OpenSide {
        /// From one vertex to the other.
        side: [u32; 2],
    },
    /// The faces at a vertex are not one cycle around it.
    #[error("the faces at vertex {vertex} are not one cycle")]
    SplitVertex {
        /// The vertex.
        vertex: u32,
    },
}

impl Boundary {
    /// The boundary with these faces, each given by its loops of half-edges, the outer one first; an empty loop is a lone
    /// vertex. Faces and loops are numbered as they come, vertices by their first half-edges, lone ones last, and shells by
    /// their first faces. A polygon whose sides are glued in pairs is one face with one loop: with 1 for the opposite
    /// direction of 0, and 3 for that of 2, the torus is 0 2 1 3.
    ///
    /// # Errors
    /// Iff a face has no loops, or a half-edge stands twice, or without its mate.
    #[doc(alias = "ME-114")]
    pub fn from_loops(faces: &[Vec<Vec<HalfEdge>>]) -> Result<Boundary, NotPaired> {
        let mut boundary = Boundary::new();
        for (i, loops) in (0..).zip(faces) {
            let first = boundary.loops.last_key_value().map_or(0, |(l, _)| l.0 + 1);
            let names: Vec<LoopId> = (first..).map(LoopId).take(loops.len()).collect();
            let [outer, rings @ ..] = &names[..] else { return Err(NotPaired::NoLoops { face: i as usize }) };
            let rings = rings.iter().copied().collect();
            boundary.faces.insert(FaceId(i), FaceRecord { shell: ShellId(i), outer: *outer, rings });
            for (&name, cycle) in names.iter().zip(loops) {
                for (k, &h) in cycle.iter().enumerate() {
                    let (next, prev) = (cycle[(k + 1) % cycle.len()], cycle[(k + cycle.len() - 1) % cycle.len()]);
                    let links = Links { origin: VertexId(0), loop_: name, next, prev };
                    if boundary.half_edges.insert(h, links).is_some() {
                        return Err(NotPaired::Repeated(h));
                    }
                }
                let half_edges = cycle.iter().copied().collect();
                boundary.loops.insert(name, LoopRecord { face: FaceId(i), half_edges, alone: None });
            }
        }
        if let Some(h) = boundary.half_edges().find(|h| !boundary.half_edges.contains_key(&h.mate())) {
            return Err(NotPaired::NoMate(h));
        }
        boundary.name_vertices();
        boundary.name_shells();
        boundary.tracked = boundary.counted();
        Ok(boundary)
    }

    /// Makes a vertex of each cycle of half-edges, and of each loop without them.
    fn name_vertices(&mut self) {
        let mut named: BTreeSet<HalfEdge> = BTreeSet::new();
        let mut names = (0..).map(VertexId);
        for h in self.half_edges().collect::<Vec<_>>() {
            if named.contains(&h) {
                continue;
            }
            let name = names.next().expect("there are fewer vertices than half-edges");
            let half_edges: BTreeSet<HalfEdge> = self.around(h).into_iter().collect();
            for at in &half_edges {
                self.half_edges.get_mut(at).expect("the cycle is of half-edges that exist").origin = name;
            }
            named.extend(&half_edges);
            self.vertices.insert(name, VertexRecord { half_edges, alone: None });
        }
        for (&l, record) in self.loops.iter_mut().filter(|(_, record)| record.half_edges.is_empty()) {
            let name = names.next().expect("fewer than 2³² vertices");
            record.alone = Some(name);
            self.vertices.insert(name, VertexRecord { half_edges: BTreeSet::new(), alone: Some(l) });
        }
    }

    /// Makes a shell of the faces that hang together.
    fn name_shells(&mut self) {
        let number: BTreeMap<FaceId, usize> = self.faces().zip(0..).collect();
        let part_of = self.parts(&number);
        let firsts: BTreeSet<usize> = part_of.iter().copied().collect();
        let shell: BTreeMap<usize, ShellId> = firsts.into_iter().zip((0..).map(ShellId)).collect();
        for (f, record) in &mut self.faces {
            record.shell = shell[&part_of[number[f]]];
        }
        self.shells = shell.into_values().collect();
    }
}

impl TryFrom<&[Face]> for Boundary {
    type Error = NotClosed;

    /// The boundary with these faces. Vertices and faces keep their numbers; loops are numbered as they come, shells by
    /// their first faces, and half-edges by their vertices: of an edge, the one from the smaller number is even. Vertices
    /// that no loop names do not count. Two faces of the same vertices are a lamina.
    ///
    /// # Errors
    /// Iff a loop is empty, a side leads to its own vertex, a side is not the only one in its direction, or none runs in
    /// the opposite one, or the half-edges at a vertex are not one cycle.
    fn try_from(faces: &[Face]) -> Result<Boundary, NotClosed> {
        let half_edge = half_edges_of(faces)?;
        let cycle = |vertices: &[u32]| sides(vertices).map(|side| half_edge[&side]).collect();
        let loops: Vec<Vec<Vec<HalfEdge>>> = faces.iter().map(|face| face.loops().map(cycle).collect()).collect();
        let mut boundary = Boundary::from_loops(&loops).expect("every side has its opposite, and stands once");
        let mut cycles: BTreeMap<VertexId, VertexRecord> = BTreeMap::new();
        for ([a, _], h) in half_edge {
            boundary.half_edges.get_mut(&h).expect("every side is in a loop").origin = VertexId(a);
            cycles.entry(VertexId(a)).or_default().half_edges.insert(h);
        }
        let is_cycle = |at: &BTreeSet<HalfEdge>| boundary.around(*at.first().expect("it has a side")).len() == at.len();
        if let Some((vertex, _)) = cycles.iter().find(|(_, at)| !is_cycle(&at.half_edges)) {
            return Err(NotClosed::SplitVertex { vertex: vertex.0 });
        }
        boundary.vertices = cycles;
        Ok(boundary)
    }
}

/// The half-edge of each side.
fn half_edges_of(faces: &[Face]) -> Result<BTreeMap<[u32; 2], HalfEdge>, NotClosed> {
    let mut used: BTreeSet<[u32; 2]> = BTreeSet::new();
    for (face, polygon) in faces.iter().enumerate() {
        if polygon.loops().any(<[u32]>::is_empty) {
            return Err(NotClosed::EmptyLoop { face });
        }
        for side in polygon.sides() {
            match side {
                [vertex, b] if vertex == b => return Err(NotClosed::ClosedSide { face, vertex }),
                side if !used.insert(side) => return Err(NotClosed::RepeatedSide { side }),
                _ => {}
            }
        }
    }
    if let Some(&side) = used.iter().find(|[a, b]| !used.contains(&[*b, *a])) {
        return Err(NotClosed::OpenSide { side });
    }
    let edges: BTreeSet<[u32; 2]> = used.into_iter().map(edge).collect();
    let pairs = (0..).zip(edges).flat_map(|(n, [a, b])| [([a, b], HalfEdge(2 * n)), ([b, a], HalfEdge(2 * n + 1))]);
    Ok(pairs.collect())
}

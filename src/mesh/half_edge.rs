//! The half-edge view of winged edges: each direction of an edge has its own record, so that a walk needs no question
//! of direction, a loop is one reference, and a boundary can be walked along like a face.

use super::edge_list::{EdgeId, EdgeList, Side};
use super::explicit::Polygon;
use super::operations::{Counted, NoSuch, Operations, counted, without_faces};
use super::vertex_list::Point;
use super::winged_edge::WingedEdges;
use std::collections::BTreeSet;

/// The record of a half-edge; it is named by its [`Side`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct HalfEdge {
    /// The vertex that it begins at.
    pub origin: u32,
    /// The face whose loop it is part of; `None` on a boundary.
    pub face: Option<usize>,
    /// The half-edge before it.
    pub previous: Side,
    /// The half-edge after it.
    pub next: Side,
}

/// The record of a vertex.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HalfEdgeVertex {
    /// Where it is.
    pub position: Point,
    /// The half-edge that goes out along the first edge of each fan. It has no face iff the fan does not close.
    pub fans: Vec<Side>,
}

/// A mesh by half-edges: the same meshes as [`WingedEdges`]. Every half-edge has a next one: one without face goes on
/// at its end to the half-edge without face of the same fan, so that the boundary is that of the surface with its fans
/// taken apart.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct HalfEdges {
    vertices: Vec<HalfEdgeVertex>,
    half_edges: Vec<[HalfEdge; 2]>,
    faces: Vec<Polygon<Side>>,
}

impl From<&WingedEdges> for HalfEdges {
    /// The half-edges, numbered as the edges are. Back again, nothing has changed (ME-43).
    #[doc(alias = "ME-43")]
    fn from(mesh: &WingedEdges) -> HalfEdges {
        let outgoing =
            |edge: EdgeId, vertex: u32| Side { edge, is_backward: mesh.edges()[edge.index()].ends[0] != vertex };
        let mut half_edges: Vec<[HalfEdge; 2]> = Vec::with_capacity(mesh.edges().len());
        for (number, edge) in mesh.edges().iter().enumerate() {
            let id = EdgeId::of(number);
            half_edges.push([id.forward(), id.forward().reversed()].map(|side| {
                let [origin, target] = [edge.ends[side.index()], edge.ends[1 - side.index()]];
                match edge.wings[side.index()] {
                    Some(wing) => HalfEdge {
                        origin,
                        face: Some(wing.face),
                        previous: outgoing(wing.previous, origin).reversed(),
                        next: outgoing(wing.next, target),
                    },
                    // Set below.
                    None => HalfEdge { origin, face: None, previous: side.reversed(), next: side.reversed() },
                }
            }));
        }
        let mut vertices = Vec::with_capacity(mesh.vertices().len());
        for (vertex, record) in (0u32..).zip(mesh.vertices()) {
            let mut fans = Vec::with_capacity(record.fans.len());
            for fan in &record.fans {
                let first = outgoing(fan[0], vertex);
                let last = outgoing(fan[fan.len() - 1], vertex).reversed();
                fans.push(first);
                if half_edges[first.edge.index()][first.index()].face.is_none() {
                    half_edges[last.edge.index()][last.index()].next = first;
                    half_edges[first.edge.index()][first.index()].previous = last;
                }
            }
            vertices.push(HalfEdgeVertex { position: record.position.clone(), fans });
        }
        let first = |sides: &[Side]| sides.first().copied().expect("no loop of winged edges is empty");
        let faces = mesh.faces().iter().map(|polygon| {
            let holes = polygon.holes.iter().map(|hole| vec![first(hole)]).collect();
            Polygon { outer: vec![first(&polygon.outer)], holes }
        });
        HalfEdges { vertices, half_edges, faces: faces.collect() }
    }
}

impl From<&HalfEdges> for EdgeList {
    /// The edge list: edges by their half-edges' origins, loops walked along from their first half-edges.
    fn from(mesh: &HalfEdges) -> EdgeList {
        let positions = mesh.vertices.iter().map(|vertex| vertex.position.clone()).collect();
        let ends = mesh.half_edges.iter().map(|pair| pair.each_ref().map(|half| half.origin)).collect();
        EdgeList::new(positions, ends, mesh.face_sides()).expect("half-edges come from winged edges")
    }
}

impl From<&HalfEdges> for WingedEdges {
    /// The winged edges, by way of the edge list (ME-43).
    fn from(mesh: &HalfEdges) -> WingedEdges {
        WingedEdges::try_from(&EdgeList::from(mesh)).expect("half-edges come from winged edges")
    }
}

impl HalfEdges {
    /// The vertices, by number.
    pub fn vertices(&self) -> &[HalfEdgeVertex] {
        &self.vertices
    }

    /// The half-edges of each edge, forward and backward.
    pub fn half_edges(&self) -> &[[HalfEdge; 2]] {
        &self.half_edges
    }

    /// The first half-edge of each loop of each face, the outer one first.
    pub fn first_sides(&self, face: usize) -> Option<Vec<Side>> {
        Some(self.faces.get(face)?.corners().copied().collect())
    }

    /// The half-edge of that name.
    ///
    /// # Panics
    /// Iff there is no such edge.
    pub fn half_edge(&self, side: Side) -> &HalfEdge {
        &self.half_edges[side.edge.index()][side.index()]
    }

    /// The loop of a half-edge, beginning with it.
    ///
    /// # Panics
    /// Iff there is no such edge.
    pub fn loop_of(&self, first: Side) -> Vec<Side> {
        let walk = std::iter::successors(Some(first), |side| Some(self.half_edge(*side).next));
        std::iter::once(first).chain(walk.skip(1).take_while(|side| *side != first)).collect()
    }

    /// The half-edges that go out at a vertex in one fan, clockwise seen from outside, from its first.
    ///
    /// # Panics
    /// Iff there is no such edge.
    pub fn fan_of(&self, first: Side) -> Vec<Side> {
        let clockwise = |side: &Side| Some(self.half_edge(side.reversed()).next);
        let walk = std::iter::successors(Some(first), clockwise);
        std::iter::once(first).chain(walk.skip(1).take_while(|side| *side != first)).collect()
    }

    /// The faces by their sides, in order.
    pub fn face_sides(&self) -> Vec<Polygon<Side>> {
        let walked = |polygon: &Polygon<Side>| {
            let holes = polygon.holes.iter().map(|hole| self.loop_of(hole[0])).collect();
            Polygon { outer: self.loop_of(polygon.outer[0]), holes }
        };
        self.faces.iter().map(walked).collect()
    }

    /// The boundary loops: half-edges without face, each loop beginning with its least, in order of these. An edge
    /// without polygon that has others at its ends is a boundary of its own, back and forth.
    pub fn boundary_loops(&self) -> Vec<Vec<Side>> {
        let (mut loops, mut walked) = (Vec::new(), BTreeSet::new());
        for number in 0..self.half_edges.len() {
            let forward = EdgeId::of(number).forward();
            for side in [forward, forward.reversed()] {
                if self.half_edge(side).face.is_none() && !walked.contains(&side) {
                    let sides = self.loop_of(side);
                    walked.extend(sides.iter().copied());
                    loops.push(sides);
                }
            }
        }
        loops
    }

    /// The words it takes, a coordinate or a reference being one: 3V and one for each fan, 8E, and one for each loop.
    pub fn words(&self) -> u64 {
        let fans: usize = self.vertices.iter().map(|vertex| vertex.fans.len()).sum();
        let loops: usize = self.faces.iter().map(|polygon| polygon.loops().count()).sum();
        (3 * self.vertices.len() + fans + 8 * self.half_edges.len() + loops) as u64
    }

    fn pair(&self, edge: EdgeId) -> Result<&[HalfEdge; 2], NoSuch> {
        self.half_edges.get(edge.index()).ok_or(NoSuch::Edge)
    }

    /// The half-edges that go out at a vertex, and how many fans they make.
    fn outgoing(&self, vertex: u32) -> Result<(Vec<Side>, u64), NoSuch> {
        let fans = &self.vertices.get(vertex as usize).ok_or(NoSuch::Vertex)?.fans;
        Ok((fans.iter().flat_map(|first| self.fan_of(*first)).collect(), fans.len() as u64))
    }
}

/// A vertex and an edge are their numbers.
impl Operations for HalfEdges {
    type Vertex = u32;
    type Edge = EdgeId;

    fn polygons(&self) -> Result<Counted<Vec<Polygon<Point>>>, NoSuch> {
        let faces = self.face_sides();
        let loops: usize = faces.iter().map(|polygon| polygon.loops().count()).sum();
        let sides: usize = faces.iter().map(|polygon| polygon.corners().count()).sum();
        let place = |side: &Side| self.vertices[self.half_edge(*side).origin as usize].position.clone();
        counted(faces.iter().map(|polygon| polygon.map(place)).collect(), (loops + 2 * sides) as u64)
    }

    fn segments(&self) -> Result<Counted<Vec<[Point; 2]>>, NoSuch> {
        let place = |half: &HalfEdge| self.vertices[half.origin as usize].position.clone();
        let segments: Vec<_> = self.half_edges.iter().map(|pair| pair.each_ref().map(place)).collect();
        counted(segments, 4 * self.half_edges.len() as u64)
    }

    fn edges_at(&self, vertex: &u32) -> Result<Counted<Vec<EdgeId>>, NoSuch> {
        let (outgoing, fans) = self.outgoing(*vertex)?;
        let mut edges: Vec<EdgeId> = outgoing.into_iter().map(|side| side.edge).collect();
        edges.sort_unstable();
        let reads = fans + edges.len() as u64;
        counted(edges, reads)
    }

    fn ends(&self, edge: &EdgeId) -> Result<Counted<[u32; 2]>, NoSuch> {
        let [a, b] = self.pair(*edge)?.each_ref().map(|half| half.origin);
        counted([a.min(b), a.max(b)], 2)
    }

    fn faces_of_edge(&self, edge: &EdgeId) -> Result<Counted<Vec<usize>>, NoSuch> {
        let faces: BTreeSet<usize> = self.pair(*edge)?.iter().filter_map(|half| half.face).collect();
        counted(faces.into_iter().collect(), 2)
    }

    fn faces_at(&self, vertex: &u32) -> Result<Counted<Vec<usize>>, NoSuch> {
        let (outgoing, fans) = self.outgoing(*vertex)?;
        let faces: BTreeSet<usize> = outgoing.iter().filter_map(|side| self.half_edge(*side).face).collect();
        counted(faces.into_iter().collect(), fans + 2 * outgoing.len() as u64)
    }

    fn adjacent_faces(&self, face: usize) -> Result<Counted<Vec<usize>>, NoSuch> {
        let loops = self.first_sides(face).ok_or(NoSuch::Face)?;
        let sides: Vec<Side> = loops.iter().flat_map(|first| self.loop_of(*first)).collect();
        let faces: BTreeSet<usize> = sides.iter().filter_map(|side| self.half_edge(side.reversed()).face).collect();
        let others = faces.into_iter().filter(|other| *other != face).collect();
        counted(others, (loops.len() + 2 * sides.len()) as u64)
    }

    fn move_vertex(&mut self, vertex: &u32, to: Point) -> Result<Counted<()>, NoSuch> {
        self.vertices.get_mut(*vertex as usize).ok_or(NoSuch::Vertex)?.position = to;
        counted((), 1)
    }

    fn boundary_edges(&self) -> Result<Counted<Vec<EdgeId>>, NoSuch> {
        let is_boundary = |pair: &[HalfEdge; 2]| pair.iter().filter(|half| half.face.is_some()).count() == 1;
        let ids = self.half_edges.iter().enumerate().filter(|(_, pair)| is_boundary(pair)).map(|(i, _)| EdgeId::of(i));
        counted(ids.collect(), 2 * self.half_edges.len() as u64)
    }

    fn unused_vertices(&self) -> Result<Counted<Vec<u32>>, NoSuch> {
        without_faces(self, self.vertices.len())
    }
}

//! The winged edge: every edge with its vertices, its two faces, and the edges before and after it in each.

use super::edge_list::{EdgeId, EdgeList, Side};
use super::explicit::Polygon;
use super::operations::{Counted, NoSuch, Operations, counted, without_faces};
use super::vertex_list::Point;
use std::collections::BTreeSet;
use thiserror::Error;

/// What an edge knows of the loop that runs along it in one direction. The loops being counterclockwise, clockwise the
/// successor is `previous`, the predecessor `next` (ME-30).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Wing {
    /// The face.
    pub face: usize,
    /// The edge before it in the loop.
    pub previous: EdgeId,
    /// The edge after it in the loop.
    pub next: EdgeId,
}

/// The record of an edge (ME-28).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias = "ME-28")]
pub struct WingedEdge {
    /// Its two vertices.
    pub ends: [u32; 2],
    /// The loop that runs along it forward, and the one that runs backward; `None` where there is none.
    pub wings: [Option<Wing>; 2],
}

impl WingedEdge {
    /// The side that begins at one of its ends.
    fn from(&self, edge: EdgeId, vertex: u32) -> Side {
        Side { edge, is_backward: self.ends[0] != vertex }
    }
}

/// The record of a vertex.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WingedVertex {
    /// Where it is.
    pub position: Point,
    /// Its edges, by fans: two edges in a row have a common face between them. Seen from outside, a fan is clockwise. A
    /// fan that does not close begins and ends with an edge that lacks a wing; one that closes begins with its least
    /// edge. The fans that do not close come first; of either kind the one with the least first edge comes first.
    pub fans: Vec<Vec<EdgeId>>,
}

/// A mesh by winged edges. It holds what has at most one use of each edge in either direction: manifolds with or
/// without boundary, and also vertices with several fans (ME-44), polygons with holes, edges without polygon.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
#[doc(alias = "ME-44")]
pub struct WingedEdges {
    vertices: Vec<WingedVertex>,
    edges: Vec<WingedEdge>,
    faces: Vec<Polygon<Side>>,
}

/// Why a mesh has no winged edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum WingError {
    /// An edge from a vertex to itself: its two directions cannot be told apart.
    #[error("edge {} runs from vertex {vertex} to itself", .edge.0)]
    OneEnd {
        /// The edge.
        edge: EdgeId,
        /// The vertex.
        vertex: u32,
    },
    /// A loop without sides: no edge leads to it.
    #[error("face {face}: loop {loop_number} is empty")]
    EmptyLoop {
        /// The face.
        face: usize,
        /// The loop, the outer one being 0.
        loop_number: usize,
    },
    /// Loops run along an edge more than once in one direction.
    #[error("loops run along edge {} from {} to {} {} times, and back {} times, where one is the most",
        .edge.0, .ends[0], .ends[1], .uses[0], .uses[1])]
    Uses {
        /// The edge.
        edge: EdgeId,
        /// Its ends.
        ends: [u32; 2],
        /// How often it is used forward, and backward.
        uses: [usize; 2],
    },
}

impl TryFrom<&EdgeList> for WingedEdges {
    type Error = WingError;

    /// The winged edges of a mesh, vertices, edges and faces numbered as they are.
    ///
    /// Errors: `OneEnd`, `Uses`, `EmptyLoop` for the first edge or loop for which it holds, in this order.
    #[doc(alias = "ME-29")]
    fn try_from(list: &EdgeList) -> Result<WingedEdges, WingError> {
        for (number, (edge, uses)) in list.edges().iter().zip(list.uses()).enumerate() {
            let (id, [a, b]) = (EdgeId::of(number), edge.ends);
            if a == b {
                return Err(WingError::OneEnd { edge: id, vertex: a });
            }
            if uses.iter().any(|n| *n > 1) {
                return Err(WingError::Uses { edge: id, ends: [a, b], uses });
            }
        }
        let mut edges: Vec<WingedEdge> =
            list.edges().iter().map(|edge| WingedEdge { ends: edge.ends, wings: [None; 2] }).collect();
        for (face, polygon) in list.faces().iter().enumerate() {
            for (loop_number, sides) in polygon.loops().enumerate() {
                let n = sides.len();
                if n == 0 {
                    return Err(WingError::EmptyLoop { face, loop_number });
                }
                for (i, side) in sides.iter().enumerate() {
                    let (previous, next) = (sides[(i + n - 1) % n].edge, sides[(i + 1) % n].edge);
                    edges[side.edge.index()].wings[side.index()] = Some(Wing { face, previous, next });
                }
            }
        }
        let at = |position: &Point| WingedVertex { position: position.clone(), fans: Vec::new() };
        let mut mesh =
            WingedEdges { vertices: list.vertices().iter().map(at).collect(), edges, faces: list.faces().to_vec() };
        mesh.set_fans();
        Ok(mesh)
    }
}

impl From<&WingedEdges> for EdgeList {
    /// The edge list: the numbers and loops are the same, so that both ways round nothing changes (ME-42).
    #[doc(alias = "ME-42")]
    fn from(mesh: &WingedEdges) -> EdgeList {
        let positions = mesh.vertices.iter().map(|vertex| vertex.position.clone()).collect();
        let ends = mesh.edges.iter().map(|edge| edge.ends).collect();
        EdgeList::new(positions, ends, mesh.faces.clone()).expect("winged edges come from an edge list")
    }
}

impl WingedEdges {
    /// The vertices, by number.
    pub fn vertices(&self) -> &[WingedVertex] {
        &self.vertices
    }

    /// The edges, by number.
    pub fn edges(&self) -> &[WingedEdge] {
        &self.edges
    }

    /// The faces: the list of its edges for each loop, with their directions.
    pub fn faces(&self) -> &[Polygon<Side>] {
        &self.faces
    }

    /// The side after a side in its loop, found by the wing and the vertex between; `None` where no loop runs along it.
    ///
    /// # Panics
    /// Iff there is no such edge.
    pub fn next(&self, side: Side) -> Option<Side> {
        let edge = &self.edges[side.edge.index()];
        let next = edge.wings[side.index()]?.next;
        Some(self.edges[next.index()].from(next, edge.ends[1 - side.index()]))
    }

    /// The edge that comes after an edge clockwise around one of its ends, seen from outside: the successor in the loop
    /// that comes in along the edge. `None` where there is no such loop.
    fn clockwise(&self, edge: EdgeId, vertex: u32) -> Option<EdgeId> {
        let outgoing = self.edges[edge.index()].from(edge, vertex);
        self.next(outgoing.reversed()).map(|side| side.edge)
    }

    /// The edges at every vertex, clockwise (ME-30).
    #[doc(alias = "ME-30")]
    fn set_fans(&mut self) {
        let mut spokes: Vec<Vec<EdgeId>> = vec![Vec::new(); self.vertices.len()];
        for (number, edge) in self.edges.iter().enumerate() {
            edge.ends.iter().for_each(|v| spokes[*v as usize].push(EdgeId::of(number)));
        }
        for (vertex, spokes) in (0u32..).zip(spokes) {
            // A fan that does not close begins where no loop goes out.
            let begins = |edge: &EdgeId| {
                let edge_record = &self.edges[edge.index()];
                edge_record.wings[edge_record.from(*edge, vertex).index()].is_none()
            };
            let (open, closed): (Vec<EdgeId>, Vec<EdgeId>) = spokes.into_iter().partition(begins);
            let (mut fans, mut placed) = (Vec::new(), BTreeSet::new());
            for first in open.into_iter().chain(closed) {
                if placed.contains(&first) {
                    continue;
                }
                let mut fan = vec![first];
                let mut at = first;
                while let Some(next) = self.clockwise(at, vertex).filter(|next| *next != first) {
                    fan.push(next);
                    at = next;
                }
                placed.extend(fan.iter().copied());
                fans.push(fan);
            }
            self.vertices[vertex as usize].fans = fans;
        }
    }

    /// The words it takes, a coordinate or a reference being one: 3V + 8E for two wings, 2E for the edges of the
    /// vertices, S for those of the faces. A missing wing takes its place too.
    pub fn words(&self) -> u64 {
        (3 * self.vertices.len() + 10 * self.edges.len()) as u64 + self.side_count()
    }

    fn side_count(&self) -> u64 {
        self.faces.iter().map(|polygon| polygon.corners().count() as u64).sum()
    }

    fn edge(&self, edge: EdgeId) -> Result<&WingedEdge, NoSuch> {
        self.edges.get(edge.index()).ok_or(NoSuch::Edge)
    }

    fn spokes(&self, vertex: u32) -> Result<Vec<EdgeId>, NoSuch> {
        let vertex = self.vertices.get(vertex as usize).ok_or(NoSuch::Vertex)?;
        Ok(vertex.fans.iter().flatten().copied().collect())
    }
}

/// A vertex and an edge are their numbers.
impl Operations for WingedEdges {
    type Vertex = u32;
    type Edge = EdgeId;

    fn polygons(&self) -> Result<Counted<Vec<Polygon<Point>>>, NoSuch> {
        let origin = |side: &Side| self.edges[side.edge.index()].ends[side.index()];
        let place = |side: &Side| self.vertices[origin(side) as usize].position.clone();
        counted(self.faces.iter().map(|polygon| polygon.map(place)).collect(), 3 * self.side_count())
    }

    fn segments(&self) -> Result<Counted<Vec<[Point; 2]>>, NoSuch> {
        let place = |edge: &WingedEdge| edge.ends.map(|v| self.vertices[v as usize].position.clone());
        counted(self.edges.iter().map(place).collect(), 3 * self.edges.len() as u64)
    }

    /// They stand in the vertex's record: no list is searched, here and below (ME-31).
    #[doc(alias = "ME-31")]
    fn edges_at(&self, vertex: &u32) -> Result<Counted<Vec<EdgeId>>, NoSuch> {
        let mut edges = self.spokes(*vertex)?;
        edges.sort_unstable();
        let reads = 1 + edges.len() as u64;
        counted(edges, reads)
    }

    fn ends(&self, edge: &EdgeId) -> Result<Counted<[u32; 2]>, NoSuch> {
        let [a, b] = self.edge(*edge)?.ends;
        counted([a.min(b), a.max(b)], 1)
    }

    /// They stand in the edge's record, one or two (ME-27).
    #[doc(alias = "ME-27")]
    fn faces_of_edge(&self, edge: &EdgeId) -> Result<Counted<Vec<usize>>, NoSuch> {
        let wings = self.edge(*edge)?.wings;
        let faces: BTreeSet<usize> = wings.iter().flatten().map(|wing| wing.face).collect();
        counted(faces.into_iter().collect(), 1)
    }

    fn faces_at(&self, vertex: &u32) -> Result<Counted<Vec<usize>>, NoSuch> {
        let spokes = self.spokes(*vertex)?;
        let wings = spokes.iter().flat_map(|edge| self.edges[edge.index()].wings);
        let faces: BTreeSet<usize> = wings.flatten().map(|wing| wing.face).collect();
        counted(faces.into_iter().collect(), 1 + 2 * spokes.len() as u64)
    }

    fn adjacent_faces(&self, face: usize) -> Result<Counted<Vec<usize>>, NoSuch> {
        let polygon = self.faces.get(face).ok_or(NoSuch::Face)?;
        let across = |side: &Side| self.edges[side.edge.index()].wings[side.reversed().index()];
        let faces: BTreeSet<usize> = polygon.corners().filter_map(across).map(|wing| wing.face).collect();
        let others = faces.into_iter().filter(|other| *other != face).collect();
        counted(others, 2 * polygon.corners().count() as u64)
    }

    fn move_vertex(&mut self, vertex: &u32, to: Point) -> Result<Counted<()>, NoSuch> {
        self.vertices.get_mut(*vertex as usize).ok_or(NoSuch::Vertex)?.position = to;
        counted((), 1)
    }

    fn boundary_edges(&self) -> Result<Counted<Vec<EdgeId>>, NoSuch> {
        let is_boundary = |edge: &WingedEdge| edge.wings.iter().flatten().count() == 1;
        let ids = self.edges.iter().enumerate().filter(|(_, edge)| is_boundary(edge)).map(|(i, _)| EdgeId::of(i));
        counted(ids.collect(), self.edges.len() as u64)
    }

    fn unused_vertices(&self) -> Result<Counted<Vec<u32>>, NoSuch> {
        without_faces(self, self.vertices.len())
    }
}

//! The edge list: vertices, edges and polygons, each edge with its vertices and its polygons, each polygon by its
//! edges.

use super::explicit::Polygon;
use super::operations::{Counted, NoSuch, Operations, counted};
use super::vertex_list::Point;
use std::collections::BTreeSet;
use thiserror::Error;

/// An edge by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EdgeId(pub u32);

impl EdgeId {
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }

    pub(super) fn of(index: usize) -> EdgeId {
        EdgeId(u32::try_from(index).expect("fewer than 2³² edges"))
    }

    /// The side from its first end to its second.
    pub fn forward(self) -> Side {
        Side { edge: self, is_backward: false }
    }
}

/// An edge with a direction: a side of a loop, or a half-edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Side {
    /// The edge.
    pub edge: EdgeId,
    /// Whether it is run along from its second end to its first.
    pub is_backward: bool,
}

impl Side {
    /// The other direction.
    pub fn reversed(self) -> Side {
        Side { is_backward: !self.is_backward, ..self }
    }

    /// 0 forward, 1 backward.
    pub(super) fn index(self) -> usize {
        usize::from(self.is_backward)
    }
}

/// The record of an edge, Aⱼ = [Vₒ, Vₚ], P_q, …, P_t (ME-19). Its ends are in an order, which is the direction in
/// which its sides run forward.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[doc(alias = "ME-19")]
pub struct Edge {
    /// Its vertices.
    pub ends: [u32; 2],
    /// The polygons that use it, sorted, one that uses it twice standing twice.
    pub faces: Vec<usize>,
}

/// The edge list as the text has it: numbers, of which nothing is promised.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
#[doc(alias = "ME-17")]
#[doc(alias = "ME-20")]
pub struct EdgeRecords {
    /// V₁, …, Vₙ (ME-17).
    pub vertices: Vec<Point>,
    /// A₁, …, Aₘ (ME-18).
    pub edges: Vec<Edge>,
    /// P₁, …, each loop by the numbers of its edges in order, without their directions (ME-20, ME-21).
    pub faces: Vec<Polygon<u32>>,
}

/// A mesh by its edge list, checked: every number names something, every loop is a closed walk, and an edge lists a
/// polygon iff the polygon uses it. Any number of polygons may use an edge, two edges may have the same ends, an edge
/// may have one vertex as both its ends, vertices and edges may be unused, and loops empty.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
#[doc(alias = "ME-18")]
pub struct EdgeList {
    vertices: Vec<Point>,
    edges: Vec<Edge>,
    faces: Vec<Polygon<Side>>,
}

/// Why records make no edge list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum EdgeListError {
    /// An edge names a vertex that does not exist.
    #[error("edge {} names vertex {vertex}, which does not exist", .edge.0)]
    VertexOutOfRange {
        /// The edge.
        edge: EdgeId,
        /// What it names.
        vertex: u32,
    },
    /// A face names an edge that does not exist.
    #[error("face {face} names edge {}, which does not exist", .edge.0)]
    EdgeOutOfRange {
        /// The face.
        face: usize,
        /// What it names.
        edge: EdgeId,
    },
    /// An edge lists other faces than those that use it.
    #[error("edge {} lists other faces than those that use it", .edge.0)]
    NotReciprocal {
        /// The edge.
        edge: EdgeId,
    },
    /// The edges of a loop, in order, are no closed walk.
    #[error("face {face}: the edges of loop {loop_number} are no closed walk")]
    Open {
        /// The face.
        face: usize,
        /// The loop, the outer one being 0.
        loop_number: usize,
    },
    /// The edges of a loop, in order, are a closed walk in either direction: they all have the same two ends.
    #[error("face {face}: the edges of loop {loop_number} all have the same ends, so that it has two directions")]
    TwoDirections {
        /// The face.
        face: usize,
        /// The loop, the outer one being 0.
        loop_number: usize,
    },
}

/// The closed walks that run along edges with these ends in this order, each as its vertices from its start: none where
/// the edges are no closed walk; two, one against the other, where all have the same two ends; else one. So the
/// polygon's list of edges, which gives no direction, determines the loop (ME-22).
#[doc(alias = "ME-22")]
pub fn walks(ends: &[[u32; 2]]) -> Vec<Vec<u32>> {
    let Some(&[a, b]) = ends.first() else { return vec![Vec::new()] };
    let starts = if a == b { vec![a] } else { vec![a, b] };
    starts.into_iter().filter_map(|start| walk(ends, start)).collect()
}

fn walk(ends: &[[u32; 2]], start: u32) -> Option<Vec<u32>> {
    let (mut at, mut vertices) = (start, Vec::with_capacity(ends.len()));
    for &[a, b] in ends {
        vertices.push(at);
        at = match at {
            _ if at == a => b,
            _ if at == b => a,
            _ => return None,
        };
    }
    (at == start).then_some(vertices)
}

/// The first edge that names a missing vertex.
fn check_ends(ends: &[[u32; 2]], vertices: usize) -> Result<(), EdgeListError> {
    for (number, ends) in ends.iter().enumerate() {
        if let Some(&vertex) = ends.iter().find(|v| **v as usize >= vertices) {
            return Err(EdgeListError::VertexOutOfRange { edge: EdgeId::of(number), vertex });
        }
    }
    Ok(())
}

impl EdgeList {
    /// The edge list of these vertices, edges by their ends, and faces by their sides. A side of an edge whose ends are
    /// one vertex is made a forward one.
    ///
    /// # Errors
    /// `VertexOutOfRange`, `EdgeOutOfRange` or `Open` for the first edge or loop for which it holds, in this order.
    pub fn new(
        vertices: Vec<Point>,
        ends: Vec<[u32; 2]>,
        faces: Vec<Polygon<Side>>,
    ) -> Result<EdgeList, EdgeListError> {
        check_ends(&ends, vertices.len())?;
        let edges = ends.into_iter().map(|ends| Edge { ends, faces: Vec::new() }).collect();
        let mut list = EdgeList { vertices, edges, faces: Vec::with_capacity(faces.len()) };
        for (face, polygon) in faces.into_iter().enumerate() {
            if let Some(side) = polygon.corners().find(|side| side.edge.index() >= list.edges.len()) {
                return Err(EdgeListError::EdgeOutOfRange { face, edge: side.edge });
            }
            let polygon = polygon.try_map(|loop_number, sides| {
                let steps: Vec<[u32; 2]> = sides.iter().map(|side| list.directed(*side)).collect();
                let goes_on = (0..steps.len()).all(|i| steps[i][1] == steps[(i + 1) % steps.len()][0]);
                let normal =
                    sides.iter().zip(steps).map(|(s, [a, b])| Side { is_backward: s.is_backward && a != b, ..*s });
                if goes_on { Ok(normal.collect()) } else { Err(EdgeListError::Open { face, loop_number }) }
            })?;
            polygon.corners().for_each(|side| list.edges[side.edge.index()].faces.push(face));
            list.faces.push(polygon);
        }
        Ok(list)
    }

    /// The positions, by vertex number.
    pub fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// The edges, by number.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The faces by their sides, in order.
    pub fn faces(&self) -> &[Polygon<Side>] {
        &self.faces
    }

    /// The vertices of a side, in its direction.
    ///
    /// # Panics
    /// Iff there is no such edge.
    pub fn directed(&self, side: Side) -> [u32; 2] {
        let [a, b] = self.edges[side.edge.index()].ends;
        if side.is_backward { [b, a] } else { [a, b] }
    }

    /// The edge list in the numbers of the text: sides without their directions.
    #[doc(alias = "ME-21")]
    pub fn records(&self) -> EdgeRecords {
        EdgeRecords {
            vertices: self.vertices.clone(),
            edges: self.edges.clone(),
            faces: self.faces.iter().map(|polygon| polygon.map(|side| side.edge.0)).collect(),
        }
    }

    /// Its vertices and edges without its polygons: the wire frame, which does not determine them (ME-39). Drawing
    /// edges needs no more (ME-2).
    #[doc(alias = "ME-2")]
    #[doc(alias = "ME-39")]
    pub fn wire_frame(&self) -> EdgeList {
        let ends = self.edges.iter().map(|edge| edge.ends).collect();
        EdgeList::new(self.vertices.clone(), ends, Vec::new()).expect("the ends have been checked")
    }

    /// How often each edge is used: forward, and backward. Where all are [1, 1] the mesh is closed and consistently
    /// oriented (ME-37).
    #[doc(alias = "ME-37")]
    pub fn uses(&self) -> Vec<[usize; 2]> {
        let mut uses = vec![[0, 0]; self.edges.len()];
        for side in self.faces.iter().flat_map(Polygon::corners) {
            uses[side.edge.index()][side.index()] += 1;
        }
        uses
    }

    /// The words it takes, a coordinate or a reference being one: 3V + 2E + 2S. Each of the S uses of an edge stands at
    /// the edge and at the polygon (ME-23).
    #[doc(alias = "ME-23")]
    pub fn words(&self) -> u64 {
        let uses: usize = self.edges.iter().map(|edge| edge.faces.len()).sum();
        let sides: usize = self.faces.iter().map(|polygon| polygon.corners().count()).sum();
        (3 * self.vertices.len() + 2 * self.edges.len() + uses + sides) as u64
    }

    fn edge(&self, edge: EdgeId) -> Result<&Edge, NoSuch> {
        self.edges.get(edge.index()).filter(|edge| edge.ends[0] != edge.ends[1]).ok_or(NoSuch::Edge)
    }

    fn ids(&self) -> impl Iterator<Item = (EdgeId, &Edge)> {
        self.edges.iter().enumerate().map(|(i, edge)| (EdgeId::of(i), edge))
    }

    fn known(&self, vertex: u32) -> Result<(), NoSuch> {
        if (vertex as usize) < self.vertices.len() { Ok(()) } else { Err(NoSuch::Vertex) }
    }

    fn side_count(&self) -> u64 {
        self.faces.iter().map(|polygon| polygon.corners().count() as u64).sum()
    }
}

impl TryFrom<&EdgeRecords> for EdgeList {
    type Error = EdgeListError;

    /// The edge list of these records, directions found by [`walks`]. The order of an edge's faces, and how often one
    /// stands there, do not matter.
    fn try_from(records: &EdgeRecords) -> Result<EdgeList, EdgeListError> {
        let ends: Vec<[u32; 2]> = records.edges.iter().map(|edge| edge.ends).collect();
        check_ends(&ends, records.vertices.len())?;
        let directed = |face: usize, polygon: &Polygon<u32>| {
            polygon.try_map(|loop_number, edges| {
                let known = |edge: &u32| {
                    let missing = EdgeListError::EdgeOutOfRange { face, edge: EdgeId(*edge) };
                    ends.get(*edge as usize).copied().ok_or(missing)
                };
                let along: Vec<[u32; 2]> = edges.iter().map(known).collect::<Result<_, _>>()?;
                let is_backward = |(at, [a, _]): (&u32, &[u32; 2])| at != a;
                match &walks(&along)[..] {
                    [] => Err(EdgeListError::Open { face, loop_number }),
                    [walk] => {
                        let directions = walk.iter().zip(&along).map(is_backward);
                        Ok(edges
                            .iter()
                            .zip(directions)
                            .map(|(&e, is_backward)| Side { edge: EdgeId(e), is_backward })
                            .collect())
                    }
                    [..] => Err(EdgeListError::TwoDirections { face, loop_number }),
                }
            })
        };
        let faces = records.faces.iter().enumerate().map(|(face, p)| directed(face, p)).collect::<Result<_, _>>();
        let list = EdgeList::new(records.vertices.clone(), ends.clone(), faces?)?;
        let set = |edge: &Edge| edge.faces.iter().copied().collect::<BTreeSet<usize>>();
        match list.edges.iter().zip(&records.edges).position(|(truth, given)| set(truth) != set(given)) {
            Some(edge) => Err(EdgeListError::NotReciprocal { edge: EdgeId::of(edge) }),
            None => Ok(list),
        }
    }
}

/// A vertex and an edge are their numbers.
impl Operations for EdgeList {
    type Vertex = u32;
    type Edge = EdgeId;

    fn polygons(&self) -> Result<Counted<Vec<Polygon<Point>>>, NoSuch> {
        let place = |side: &Side| self.vertices[self.directed(*side)[0] as usize].clone();
        counted(self.faces.iter().map(|polygon| polygon.map(place)).collect(), 3 * self.side_count())
    }

    /// No polygon is read, and no edge comes twice (ME-25).
    #[doc(alias = "ME-25")]
    fn segments(&self) -> Result<Counted<Vec<[Point; 2]>>, NoSuch> {
        let edges = self.edges.iter().filter(|edge| edge.ends[0] != edge.ends[1]);
        let segments: Vec<_> = edges.map(|edge| edge.ends.map(|v| self.vertices[v as usize].clone())).collect();
        let reads = (self.edges.len() + 2 * segments.len()) as u64;
        counted(segments, reads)
    }

    /// All edges are read (ME-26).
    #[doc(alias = "ME-26")]
    fn edges_at(&self, vertex: &u32) -> Result<Counted<Vec<EdgeId>>, NoSuch> {
        self.known(*vertex)?;
        let is_at = |edge: &Edge| edge.ends.contains(vertex) && edge.ends[0] != edge.ends[1];
        counted(self.ids().filter(|(_, edge)| is_at(edge)).map(|(id, _)| id).collect(), self.edges.len() as u64)
    }

    fn ends(&self, edge: &EdgeId) -> Result<Counted<[u32; 2]>, NoSuch> {
        let [a, b] = self.edge(*edge)?.ends;
        counted([a.min(b), a.max(b)], 1)
    }

    /// They stand in the edge's record (ME-24).
    #[doc(alias = "ME-24")]
    fn faces_of_edge(&self, edge: &EdgeId) -> Result<Counted<Vec<usize>>, NoSuch> {
        let uses = &self.edge(*edge)?.faces;
        let faces: BTreeSet<usize> = uses.iter().copied().collect();
        counted(faces.into_iter().collect(), 1 + uses.len() as u64)
    }

    fn faces_at(&self, vertex: &u32) -> Result<Counted<Vec<usize>>, NoSuch> {
        self.known(*vertex)?;
        let (mut faces, mut reads) = (BTreeSet::new(), self.edges.len());
        for edge in self.edges.iter().filter(|edge| edge.ends.contains(vertex)) {
            faces.extend(edge.faces.iter().copied());
            reads += edge.faces.len();
        }
        counted(faces.into_iter().collect(), reads as u64)
    }

    fn adjacent_faces(&self, face: usize) -> Result<Counted<Vec<usize>>, NoSuch> {
        let polygon = self.faces.get(face).ok_or(NoSuch::Face)?;
        let (mut faces, mut reads) = (BTreeSet::new(), 0);
        for side in polygon.corners() {
            let edge = &self.edges[side.edge.index()];
            reads += 2;
            if edge.ends[0] != edge.ends[1] {
                faces.extend(edge.faces.iter().copied());
                reads += edge.faces.len() as u64;
            }
        }
        faces.remove(&face);
        counted(faces.into_iter().collect(), reads)
    }

    fn move_vertex(&mut self, vertex: &u32, to: Point) -> Result<Counted<()>, NoSuch> {
        *self.vertices.get_mut(*vertex as usize).ok_or(NoSuch::Vertex)? = to;
        counted((), 1)
    }

    fn boundary_edges(&self) -> Result<Counted<Vec<EdgeId>>, NoSuch> {
        let is_boundary = |edge: &Edge| edge.faces.len() == 1 && edge.ends[0] != edge.ends[1];
        counted(self.ids().filter(|(_, edge)| is_boundary(edge)).map(|(id, _)| id).collect(), self.edges.len() as u64)
    }

    fn unused_vertices(&self) -> Result<Counted<Vec<u32>>, NoSuch> {
        let mut is_used = vec![false; self.vertices.len()];
        for edge in self.edges.iter().filter(|edge| !edge.faces.is_empty()) {
            edge.ends.iter().for_each(|v| is_used[*v as usize] = true);
        }
        let unused = (0u32..).zip(is_used).filter(|(_, used)| !used).map(|(v, _)| v).collect();
        counted(unused, self.edges.len() as u64)
    }
}

//! The operations on polygon meshes, the same on every structure, with the number of records that each reads.
//!
//! A *read* is one of: a position; an item of a list (a polygon's corner or side, an edge's polygon, a vertex's edge);
//! the record of an edge, of a half-edge, or of a vertex that has more than a position. With S corners, V vertices, E
//! edges; at the vertex d edges in f fans; the edge used k times; the polygon, or all polygons, with n sides and l
//! loops; Σk over the edges at the vertex, or of the polygon; Σf over all vertices; where no edge is without polygon
//! and no side runs from a vertex to itself:
//!
//! | | explicit | vertex list | edge list | winged edge | half-edge |
//! |---|---|---|---|---|---|
//! | draw polygons | S | 2S | 3S | 3S | 2S + l |
//! | draw edges, each once | S | S + 2E | 3E | 3E | 4E |
//! | edges at a vertex | S | S | E | 1 + d | f + d |
//! | ends of an edge | 0 | 0 | 1 | 1 | 2 |
//! | polygons of an edge | S | S | 1 + k | 1 | 2 |
//! | polygons at a vertex | S | S | E + Σk | 1 + 2d | f + 2d |
//! | polygons beside a polygon | n + S | n + S | 2n + Σk | 2n | l + 2n |
//! | move a vertex | S | 1 | 1 | 1 | 1 |
//! | edges used once | S | S | E | E | 2E |
//! | vertices without polygon | 0 | S | E | V + 4E | Σf + 4E |
//!
//! An operation is *explicit* where its reads depend on the size of its answer only, not on that of the mesh.

use super::explicit::Polygon;
use super::face::{Face, edge};
use super::triangles::EdgeKey;
use super::vertex_list::{Point, VertexList};
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// An answer, with the number of records that were read for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counted<T> {
    /// The answer.
    pub answer: T,
    /// The records read.
    pub reads: u64,
}

/// Why there is no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum NoSuch {
    /// The mesh has no such vertex, or a polygon of it names one that it does not have.
    #[error("a vertex is named that the mesh does not have")]
    Vertex,
    /// The mesh has no such edge.
    #[error("an edge is named that the mesh does not have")]
    Edge,
    /// The mesh has no such polygon.
    #[error("a polygon is named that the mesh does not have")]
    Face,
}

pub(super) fn counted<T>(answer: T, reads: u64) -> Result<Counted<T>, NoSuch> {
    Ok(Counted { answer, reads })
}

/// The vertices, numbered from 0, that no polygon comes to, by asking at each.
pub(super) fn without_faces(
    mesh: &impl Operations<Vertex = u32>,
    vertices: usize,
) -> Result<Counted<Vec<u32>>, NoSuch> {
    let (mut unused, mut reads) = (Vec::new(), 0);
    for vertex in 0..vertices as u32 {
        let faces = mesh.faces_at(&vertex)?;
        reads += faces.reads;
        if faces.answer.is_empty() {
            unused.push(vertex);
        }
    }
    counted(unused, reads)
}

/// The operations that the text lists (ME-1). Answers that are lists of names are sorted, each name once. An edge
/// joins two different vertices: a side from a vertex to itself is none.
///
/// Each fails iff a name that it is given is not in the mesh; on a [`VertexList`], which promises nothing, also where
/// it comes upon a polygon that names a missing vertex.
#[doc(alias = "ME-1")]
pub trait Operations {
    /// The name of a vertex.
    type Vertex: Clone + Ord;
    /// The name of an edge.
    type Edge: Clone + Ord;

    /// The polygons by the positions of their corners, in order: what drawing faces needs.
    ///
    /// # Errors
    /// As for all operations.
    fn polygons(&self) -> Result<Counted<Vec<Polygon<Point>>>, NoSuch>;

    /// Every edge once, by the positions of its ends, in no promised order: what drawing edges needs.
    ///
    /// # Errors
    /// As for all operations.
    fn segments(&self) -> Result<Counted<Vec<[Point; 2]>>, NoSuch>;

    /// The edges at a vertex.
    ///
    /// # Errors
    /// As for all operations.
    fn edges_at(&self, vertex: &Self::Vertex) -> Result<Counted<Vec<Self::Edge>>, NoSuch>;

    /// The two vertices of an edge, the smaller one first. Where an edge is named by them, it is not looked up.
    ///
    /// # Errors
    /// As for all operations.
    fn ends(&self, edge: &Self::Edge) -> Result<Counted<[Self::Vertex; 2]>, NoSuch>;

    /// The polygons that use an edge.
    ///
    /// # Errors
    /// As for all operations.
    fn faces_of_edge(&self, edge: &Self::Edge) -> Result<Counted<Vec<usize>>, NoSuch>;

    /// The polygons with a corner at a vertex.
    ///
    /// # Errors
    /// As for all operations.
    fn faces_at(&self, vertex: &Self::Vertex) -> Result<Counted<Vec<usize>>, NoSuch>;

    /// The other polygons that share an edge with a polygon.
    ///
    /// # Errors
    /// As for all operations.
    fn adjacent_faces(&self, face: usize) -> Result<Counted<Vec<usize>>, NoSuch>;

    /// Gives a vertex another position.
    ///
    /// # Errors
    /// As for all operations; the mesh is then as before.
    fn move_vertex(&mut self, vertex: &Self::Vertex, to: Point) -> Result<Counted<()>, NoSuch>;

    /// The edges used exactly once: where a polygon is missing, if the mesh is meant to be closed.
    ///
    /// # Errors
    /// As for all operations.
    fn boundary_edges(&self) -> Result<Counted<Vec<Self::Edge>>, NoSuch>;

    /// The vertices that no polygon has a corner at.
    ///
    /// # Errors
    /// As for all operations.
    fn unused_vertices(&self) -> Result<Counted<Vec<Self::Vertex>>, NoSuch>;
}

/// How often each thing has been noted.
#[derive(Clone, Debug)]
pub(super) struct Noted<T>(BTreeMap<T, u32>);

impl<T: Ord> Default for Noted<T> {
    fn default() -> Noted<T> {
        Noted(BTreeMap::new())
    }
}

impl<T: Ord> Noted<T> {
    pub(super) fn note(&mut self, thing: T) {
        *self.0.entry(thing).or_default() += 1;
    }

    pub(super) fn once_each(self) -> Vec<T> {
        self.0.into_keys().collect()
    }

    pub(super) fn noted_once(self) -> Vec<T> {
        self.0.into_iter().filter(|(_, times)| *times == 1).map(|(thing, _)| thing).collect()
    }
}

impl VertexList {
    /// S, the number of corners.
    pub fn corner_count(&self) -> u64 {
        self.faces.iter().map(|face| face.vertices().count() as u64).sum()
    }

    /// The words it takes, a coordinate or a reference being one: 3V + S. That is less than the explicit list's 3S iff
    /// S > 3V/2, that is, iff a vertex has more than 3/2 corners on average (ME-13).
    #[doc(alias = "ME-13")]
    pub fn words(&self) -> u64 {
        3 * self.vertices.len() as u64 + self.corner_count()
    }

    /// The edges drawn where each polygon draws its sides: a common edge as often as polygons use it, as on the
    /// explicit list (ME-15).
    #[doc(alias = "ME-15")]
    pub fn strokes(&self) -> Vec<EdgeKey> {
        self.faces.iter().flat_map(Face::sides).filter(|[a, b]| a != b).map(edge).collect()
    }

    fn at(&self, vertex: u32) -> Result<&Point, NoSuch> {
        self.vertices.get(vertex as usize).ok_or(NoSuch::Vertex)
    }

    /// All edges, each as often as it is used.
    fn uses(&self) -> Result<Noted<EdgeKey>, NoSuch> {
        let mut uses = Noted::default();
        for [a, b] in self.faces.iter().flat_map(Face::sides) {
            self.at(a)?;
            if a != b {
                uses.note(edge([a, b]));
            }
        }
        Ok(uses)
    }

    /// The faces with a side such as `is_sought`. All are read: the list says nothing of what shares what (ME-16).
    #[doc(alias = "ME-16")]
    fn faces_with(&self, is_sought: impl Fn([u32; 2]) -> bool) -> Result<Vec<usize>, NoSuch> {
        let mut faces = Vec::new();
        for (number, face) in self.faces.iter().enumerate() {
            face.vertices().try_for_each(|v| self.at(v).map(drop))?;
            if face.sides().any(&is_sought) {
                faces.push(number);
            }
        }
        Ok(faces)
    }
}

/// A vertex is its number; an edge is the numbers of its two ends, the smaller one first.
impl Operations for VertexList {
    type Vertex = u32;
    type Edge = EdgeKey;

    fn polygons(&self) -> Result<Counted<Vec<Polygon<Point>>>, NoSuch> {
        let place = |corners: &[u32]| corners.iter().map(|v| self.at(*v).cloned()).collect::<Result<Vec<_>, _>>();
        let polygon = |face: &Face| {
            let holes = face.holes.iter().map(|hole| place(hole)).collect::<Result<_, _>>()?;
            Ok(Polygon { outer: place(&face.outer)?, holes })
        };
        counted(self.faces.iter().map(polygon).collect::<Result<_, _>>()?, 2 * self.corner_count())
    }

    fn segments(&self) -> Result<Counted<Vec<[Point; 2]>>, NoSuch> {
        let edges = self.uses()?.once_each();
        let reads = self.corner_count() + 2 * edges.len() as u64;
        let place = |[a, b]: EdgeKey| Ok([self.at(a)?.clone(), self.at(b)?.clone()]);
        counted(edges.into_iter().map(place).collect::<Result<_, _>>()?, reads)
    }

    fn edges_at(&self, vertex: &u32) -> Result<Counted<Vec<EdgeKey>>, NoSuch> {
        self.at(*vertex)?;
        let edges = self.uses()?.once_each().into_iter().filter(|ends| ends.contains(vertex)).collect();
        counted(edges, self.corner_count())
    }

    fn ends(&self, ends: &EdgeKey) -> Result<Counted<[u32; 2]>, NoSuch> {
        counted(edge(*ends), 0)
    }

    fn faces_of_edge(&self, ends: &EdgeKey) -> Result<Counted<Vec<usize>>, NoSuch> {
        let faces = self.faces_with(|side| side[0] != side[1] && edge(side) == edge(*ends))?;
        if faces.is_empty() { Err(NoSuch::Edge) } else { counted(faces, self.corner_count()) }
    }

    fn faces_at(&self, vertex: &u32) -> Result<Counted<Vec<usize>>, NoSuch> {
        self.at(*vertex)?;
        counted(self.faces_with(|[a, _]| a == *vertex)?, self.corner_count())
    }

    fn adjacent_faces(&self, face: usize) -> Result<Counted<Vec<usize>>, NoSuch> {
        let polygon = self.faces.get(face).ok_or(NoSuch::Face)?;
        let own: BTreeSet<EdgeKey> = polygon.sides().filter(|[a, b]| a != b).map(edge).collect();
        let mut faces = self.faces_with(|side| own.contains(&edge(side)))?;
        faces.retain(|other| *other != face);
        counted(faces, polygon.vertices().count() as u64 + self.corner_count())
    }

    /// One record is written, whatever polygons refer to it (ME-14).
    #[doc(alias = "ME-14")]
    fn move_vertex(&mut self, vertex: &u32, to: Point) -> Result<Counted<()>, NoSuch> {
        *self.vertices.get_mut(*vertex as usize).ok_or(NoSuch::Vertex)? = to;
        counted((), 1)
    }

    fn boundary_edges(&self) -> Result<Counted<Vec<EdgeKey>>, NoSuch> {
        counted(self.uses()?.noted_once(), self.corner_count())
    }

    fn unused_vertices(&self) -> Result<Counted<Vec<u32>>, NoSuch> {
        let mut is_used = vec![false; self.vertices.len()];
        for vertex in self.faces.iter().flat_map(Face::vertices) {
            *is_used.get_mut(vertex as usize).ok_or(NoSuch::Vertex)? = true;
        }
        counted((0u32..).zip(is_used).filter(|(_, used)| !used).map(|(v, _)| v).collect(), self.corner_count())
    }
}

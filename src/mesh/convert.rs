//! From one representation to another, and what each way keeps.
//!
//! | from, to | it fails iff | what is lost, or made normal |
//! |---|---|---|
//! | explicit → vertex list | never | nothing: back again it is the same. Equal positions become one vertex; numbers are in order of first use |
//! | vertex list → explicit | a vertex is missing | vertices of no polygon, vertex numbers, and the difference of vertices at one position |
//! | vertex list → edge list | a vertex is missing | nothing: back again it is the same. Edges are numbered in order of first use, and directed as first used |
//! | edge list → vertex list | never | edges of no polygon, edge numbers and directions, and the difference of edges with the same ends |
//! | edge list → winged edge | an edge has one end, or is used twice in one direction, or a loop is empty | nothing |
//! | winged edge → edge list, winged edge ↔ half-edge | never | nothing |
//!
//! Loops keep their first vertex and their direction everywhere.

use super::edge_list::{EdgeId, EdgeList, Side};
use super::explicit::{ExplicitList, Polygon};
use super::face::{Face, edge, sides};
use super::half_edge::HalfEdges;
use super::triangles::EdgeKey;
use super::vertex_list::{Point, VertexList};
use super::winged_edge::{WingError, WingedEdges};
use std::collections::HashMap;
use thiserror::Error;

/// A face of a vertex list names a vertex that does not exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("face {face} names vertex {vertex}, which does not exist")]
pub struct MissingVertex {
    /// The face.
    pub face: usize,
    /// What it names.
    pub vertex: u32,
}

/// Why a vertex list has no winged edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ConvertError {
    /// A vertex is missing.
    #[error(transparent)]
    Missing(#[from] MissingVertex),
    /// It has an edge list, which has no winged edges.
    #[error(transparent)]
    Wing(#[from] WingError),
}

fn face_of(polygon: Polygon<u32>) -> Face {
    Face { outer: polygon.outer, holes: polygon.holes }
}

/// The first missing vertex, in the order of the loops.
fn check(list: &VertexList) -> Result<(), MissingVertex> {
    for (face, polygon) in list.faces.iter().enumerate() {
        if let Some(vertex) = polygon.vertices().find(|v| *v as usize >= list.vertices.len()) {
            return Err(MissingVertex { face, vertex });
        }
    }
    Ok(())
}

impl From<&ExplicitList> for VertexList {
    /// Each position once (ME-9), and polygons by the numbers of their vertices (ME-10, ME-12).
    #[doc(alias = "ME-9")]
    #[doc(alias = "ME-10")]
    #[doc(alias = "ME-12")]
    #[doc(alias = "ME-41")]
    fn from(list: &ExplicitList) -> VertexList {
        let mut numbers: HashMap<&Point, u32> = HashMap::new();
        let mut vertices: Vec<Point> = Vec::new();
        let mut faces = Vec::with_capacity(list.polygons.len());
        for polygon in &list.polygons {
            let mut face = Face::default();
            for (loop_number, corners) in polygon.loops().enumerate() {
                let number = |position| {
                    *numbers.entry(position).or_insert_with(|| {
                        vertices.push(Point::clone(position));
                        u32::try_from(vertices.len() - 1).expect("fewer than 2³² vertices")
                    })
                };
                let numbered = corners.iter().map(number).collect();
                if loop_number == 0 { face.outer = numbered } else { face.holes.push(numbered) }
            }
            faces.push(face);
        }
        VertexList { vertices, faces }
    }
}

impl TryFrom<&VertexList> for ExplicitList {
    type Error = MissingVertex;

    /// The polygons by positions. Errors: the first vertex that does not exist.
    fn try_from(list: &VertexList) -> Result<ExplicitList, MissingVertex> {
        check(list)?;
        let place = |corners: &[u32]| corners.iter().map(|v| list.vertices[*v as usize].clone()).collect();
        let polygon = |face: &Face| Polygon {
            outer: place(&face.outer),
            holes: face.holes.iter().map(|hole| place(hole)).collect(),
        };
        Ok(ExplicitList { polygons: list.faces.iter().map(polygon).collect() })
    }
}

impl TryFrom<&VertexList> for EdgeList {
    type Error = MissingVertex;

    /// The edge list with one edge for each pair of vertices that a side joins. Errors: the first vertex that does not
    /// exist.
    #[doc(alias = "ME-40")]
    fn try_from(list: &VertexList) -> Result<EdgeList, MissingVertex> {
        check(list)?;
        let mut numbers: HashMap<EdgeKey, EdgeId> = HashMap::new();
        let mut ends: Vec<[u32; 2]> = Vec::new();
        let mut polygons = Vec::with_capacity(list.faces.len());
        for face in &list.faces {
            let mut along = |corners: &[u32]| -> Vec<Side> {
                let number = |side: [u32; 2]| {
                    let id = *numbers.entry(edge(side)).or_insert_with(|| {
                        ends.push(side);
                        EdgeId::of(ends.len() - 1)
                    });
                    Side { edge: id, is_backward: ends[id.index()] != side }
                };
                sides(corners).map(number).collect()
            };
            let outer = along(&face.outer);
            polygons.push(Polygon { outer, holes: face.holes.iter().map(|hole| along(hole)).collect() });
        }
        Ok(EdgeList::new(list.vertices.clone(), ends, polygons).expect("the sides of a loop are a closed walk"))
    }
}

impl From<&EdgeList> for VertexList {
    /// Every loop by the first vertices of its sides.
    fn from(list: &EdgeList) -> VertexList {
        let faces = list.faces().iter().map(|polygon| face_of(polygon.map(|side| list.directed(*side)[0])));
        VertexList { vertices: list.vertices().to_vec(), faces: faces.collect() }
    }
}

impl TryFrom<&VertexList> for WingedEdges {
    type Error = ConvertError;

    /// The winged edges of the edge list.
    fn try_from(list: &VertexList) -> Result<WingedEdges, ConvertError> {
        Ok(WingedEdges::try_from(&EdgeList::try_from(list)?)?)
    }
}

impl TryFrom<&VertexList> for HalfEdges {
    type Error = ConvertError;

    /// The half-edges of the winged edges.
    fn try_from(list: &VertexList) -> Result<HalfEdges, ConvertError> {
        Ok(HalfEdges::from(&WingedEdges::try_from(list)?))
    }
}

impl From<&WingedEdges> for VertexList {
    /// By way of the edge list.
    fn from(mesh: &WingedEdges) -> VertexList {
        VertexList::from(&EdgeList::from(mesh))
    }
}

impl From<&HalfEdges> for VertexList {
    /// By way of the edge list.
    fn from(mesh: &HalfEdges) -> VertexList {
        VertexList::from(&EdgeList::from(mesh))
    }
}

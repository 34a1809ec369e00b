//! What a check finds.

use super::area::Area;
use super::between::Junction;
use crate::mesh::defects::{Category, Counts, Element};
use crate::mesh::triangles::EdgeKey;
use std::collections::{BTreeMap, BTreeSet};

/// The elements of one category, sorted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Elements {
    /// Faces.
    Faces(Vec<u32>),
    /// Vertices.
    Vertices(Vec<u32>),
    /// Edges.
    Edges(Vec<EdgeKey>),
    /// Groups of vertices.
    VertexGroups(Vec<Vec<u32>>),
    /// Groups of faces.
    FaceGroups(Vec<Vec<u32>>),
    /// Vertices with the edges that they lie inside.
    Junctions(Vec<Junction>),
    /// The mesh as a whole.
    Whole,
}

impl Elements {
    /// How many there are; 1 for the whole.
    pub fn len(&self) -> usize {
        match self {
            Elements::Faces(list) | Elements::Vertices(list) => list.len(),
            Elements::Edges(list) => list.len(),
            Elements::VertexGroups(list) | Elements::FaceGroups(list) => list.len(),
            Elements::Junctions(list) => list.len(),
            Elements::Whole => 1,
        }
    }

    /// The same elements as the plain check has them.
    pub fn plain(&self) -> BTreeSet<Element> {
        let faces = |group: &Vec<u32>| Element::Faces(group.iter().map(|&face| face as usize).collect());
        match self {
            Elements::Faces(list) => list.iter().map(|&face| Element::Face(face as usize)).collect(),
            Elements::Vertices(list) => list.iter().map(|&vertex| Element::Vertex(vertex)).collect(),
            Elements::Edges(list) => list.iter().map(|&edge| Element::Edge(edge)).collect(),
            Elements::VertexGroups(list) => list.iter().map(|group| Element::Vertices(group.clone())).collect(),
            Elements::FaceGroups(list) => list.iter().map(faces).collect(),
            Elements::Junctions(list) => list.iter().map(|&(v, edge)| Element::VertexInEdge(v, edge)).collect(),
            Elements::Whole => BTreeSet::from([Element::Mesh]),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// One connected component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Component {
    /// Its faces.
    pub faces: u64,
    /// Its vertices.
    pub vertices: u64,
    /// Its edges.
    pub edges: u64,
    /// The closed curves of its boundary edges.
    pub boundary_loops: u64,
    /// Where it is an orientable surface, perhaps with boundary: V − E + F = 2 − 2·genus − loops.
    pub genus: Option<i64>,
}

/// All that is found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The defects, by category; one without elements is absent.
    pub defects: BTreeMap<Category, Elements>,
    /// The numbers; none where a face names a vertex that does not exist.
    pub counts: Option<Counts>,
    /// The components, those of most faces first; empty where there are no counts.
    pub components: Vec<Component>,
    /// The area; none where there are no counts.
    pub area: Option<Area>,
    /// Whether the t-junctions are all: their search stops at [`super::MAX_JUNCTIONS`].
    pub all_junctions: bool,
}

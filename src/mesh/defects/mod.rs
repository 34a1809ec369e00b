//! The consistency of polygon meshes: what can be wrong with one, each kind of defect by its own name (003, 5.5).
//!
//! A *loop* is a face's outer cycle of vertex numbers or one of its holes. An *edge* is an unordered pair of different
//! vertices; a *use* is one side of one loop, so that a loop of two vertices uses its edge twice. A side from a vertex to
//! itself is no edge. All decisions are exact.

mod combinatorial;
mod counts;
mod crossing;
mod edge_list;
mod geometric;
mod t_junction;

pub use counts::Counts;
pub use edge_list::{ListedEdges, WrongLength};

use super::triangles::EdgeKey;
use super::vertex_list::VertexList;
use combinatorial::Uses;
use std::collections::{BTreeMap, BTreeSet};

/// A kind of defect. Where its meaning leaves something open, the second sentence says how it is read here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Category {
    /// Face: a loop names a vertex that does not exist. Then nothing else is told.
    IndexOutOfRange,
    /// Face: a loop has fewer than 3 vertices. They are counted as they stand, a repeated one each time.
    FaceLt3Vertices,
    /// Face: a loop visits a vertex twice. A last vertex equal to the first is one: loops close implicitly.
    RepeatedVertexInLoop,
    /// Face: a side of a loop goes from a vertex to itself.
    DegenerateEdgeSameIndex,
    /// Edge: different vertices at one position. Only edges that a loop uses.
    ZeroLengthEdge,
    /// Edge: exactly one use.
    BoundaryEdge,
    /// Edge: more than two uses.
    EdgeUsedGt2,
    /// Edge: an odd number of uses, three or more.
    EdgeOddUse,
    /// Edge: two uses, or more, by one face.
    EdgeTwiceInSameFace,
    /// Edge: exactly two uses, both in the same direction. One face may have both.
    InconsistentWindingEdge,
    /// Vertex: used by no loop.
    IsolatedVertex,
    /// Vertices: all those at one position, where there is more than one. Isolated ones too.
    DuplicateVertexPosition,
    /// Faces: all those whose outer loops are equal as cycles, in either direction. Holes play no part; two empty loops are equal.
    DuplicateFace,
    /// Face: 3 or more vertices, those of holes included, all on one line. A repeated one counts each time.
    ZeroAreaFace,
    /// Face: its vertices, those of holes included, are in no common plane.
    NonplanarFace,
    /// Face: plane, not on a line, and (A, B, C) of all its loops together is 0. Each loop adds with its own sense.
    ZeroSignedAreaFace,
    /// Face: plane, and two sides of the outer loop cross in one point inside both.
    SelfCrossingLoop,
    /// Vertex and edge: a used vertex strictly inside an edge that it is not an end of. Only edges that a loop uses; a vertex
    /// at the position of an end is not inside.
    TJunction,
    /// Vertex: its neighbours, joined by the corners at it, make more than one component. A vertex that follows itself in a
    /// loop makes one corner.
    NonmanifoldVertex,
    /// Vertex: used, and fewer than two different neighbours.
    VertexLt2Edges,
    /// The mesh: closed, no hole has its face's sense, and no choice of faces to flip, each with its holes, makes every
    /// two-use edge run both ways.
    NonOrientable,
    /// The mesh: closed, consistent winding, volume < 0.
    InsideOut,
    /// The mesh: closed, consistent winding, volume = 0. A mesh without faces is one.
    ZeroVolume,
    /// Face: a hole is wound like the outer loop: their (A, B, C) have a positive scalar product.
    HoleSameSenseAsOuter,
    /// Record: a listed edge that no loop uses. One from a vertex to itself, or to a vertex that does not exist, is one.
    EdgeUnreferenced,
    /// Edge: used, but not listed.
    EdgeMissingFromList,
    /// Edge: listed more than once, in either direction.
    DuplicateEdgeRecord,
    /// Record: its listed faces are, as a set, not those that use it. One that does not exist uses nothing.
    EdgeFaceNotReciprocal,
}

impl Category {
    /// All of them, in order.
    pub const ALL: [Category; 28] = [
        Category::IndexOutOfRange,
        Category::FaceLt3Vertices,
        Category::RepeatedVertexInLoop,
        Category::DegenerateEdgeSameIndex,
        Category::ZeroLengthEdge,
        Category::BoundaryEdge,
        Category::EdgeUsedGt2,
        Category::EdgeOddUse,
        Category::EdgeTwiceInSameFace,
        Category::InconsistentWindingEdge,
        Category::IsolatedVertex,
        Category::DuplicateVertexPosition,
        Category::DuplicateFace,
        Category::ZeroAreaFace,
        Category::NonplanarFace,
        Category::ZeroSignedAreaFace,
        Category::SelfCrossingLoop,
        Category::TJunction,
        Category::NonmanifoldVertex,
        Category::VertexLt2Edges,
        Category::NonOrientable,
        Category::InsideOut,
        Category::ZeroVolume,
        Category::HoleSameSenseAsOuter,
        Category::EdgeUnreferenced,
        Category::EdgeMissingFromList,
        Category::DuplicateEdgeRecord,
        Category::EdgeFaceNotReciprocal,
    ];

    /// Its name in the protocol.
    pub const fn name(self) -> &'static str {
        match self {
            Category::IndexOutOfRange => "index_out_of_range",
            Category::FaceLt3Vertices => "face_lt3_vertices",
            Category::RepeatedVertexInLoop => "repeated_vertex_in_loop",
            Category::DegenerateEdgeSameIndex => "degenerate_edge_same_index",
            Category::ZeroLengthEdge => "zero_length_edge",
            Category::BoundaryEdge => "boundary_edge",
            Category::EdgeUsedGt2 => "edge_used_gt2",
            Category::EdgeOddUse => "edge_odd_use",
            Category::EdgeTwiceInSameFace => "edge_twice_in_same_face",
            Category::InconsistentWindingEdge => "inconsistent_winding_edge",
            Category::IsolatedVertex => "isolated_vertex",
            Category::DuplicateVertexPosition => "duplicate_vertex_position",
            Category::DuplicateFace => "duplicate_face",
            Category::ZeroAreaFace => "zero_area_face",
            Category::NonplanarFace => "nonplanar_face",
            Category::ZeroSignedAreaFace => "zero_signed_area_face",
            Category::SelfCrossingLoop => "self_crossing_loop",
            Category::TJunction => "t_junction",
            Category::NonmanifoldVertex => "nonmanifold_vertex",
            Category::VertexLt2Edges => "vertex_lt2_edges",
            Category::NonOrientable => "non_orientable",
            Category::InsideOut => "inside_out",
            Category::ZeroVolume => "zero_volume",
            Category::HoleSameSenseAsOuter => "hole_same_sense_as_outer",
            Category::EdgeUnreferenced => "edge_unreferenced",
            Category::EdgeMissingFromList => "edge_missing_from_list",
            Category::DuplicateEdgeRecord => "duplicate_edge_record",
            Category::EdgeFaceNotReciprocal => "edge_face_not_reciprocal",
        }
    }
}

/// Where a defect is.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Element {
    /// In the mesh as a whole.
    Mesh,
    /// At a vertex.
    Vertex(u32),
    /// At some vertices, in increasing order.
    Vertices(Vec<u32>),
    /// At an edge, its smaller vertex first.
    Edge(EdgeKey),
    /// At a vertex in an edge.
    VertexInEdge(u32, EdgeKey),
    /// In a face, by its index.
    Face(usize),
    /// In some faces, in increasing order.
    Faces(Vec<usize>),
    /// In a record of the list of edges, by its index.
    Record(usize),
}

/// Defects by category, each category's elements in increasing order; a category without elements is absent.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Defects(BTreeMap<Category, BTreeSet<Element>>);

impl Defects {
    fn add(&mut self, category: Category, element: Element) {
        self.0.entry(category).or_default().insert(element);
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether there is one of that category.
    pub fn has(&self, category: Category) -> bool {
        self.0.contains_key(&category)
    }

    /// The elements of a category, in increasing order.
    pub fn of(&self, category: Category) -> impl Iterator<Item = &Element> {
        self.0.get(&category).into_iter().flatten()
    }

    /// The categories that have elements, with them, in order.
    pub fn iter(&self) -> impl Iterator<Item = (Category, &BTreeSet<Element>)> {
        self.0.iter().map(|(category, elements)| (*category, elements))
    }
}

/// What is wrong with a mesh, and what there is of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// Its defects.
    pub defects: Defects,
    /// Its numbers; `None` iff an index is out of range.
    pub counts: Option<Counts>,
}

/// Every defect of a mesh, and its numbers; with a list of edges, also the defects of that list.
///
/// No category tells whether two faces cut each other, or whether a hole lies inside its face (ME-74).
#[doc(alias = "ME-49")]
#[doc(alias = "ME-50")]
#[doc(alias = "ME-74")]
pub fn check(mesh: &VertexList, listed: Option<&ListedEdges>) -> Report {
    let mut defects = Defects::default();
    combinatorial::out_of_range(mesh, &mut defects);
    if !defects.is_empty() {
        return Report { defects, counts: None };
    }
    let uses = Uses::of(mesh);
    combinatorial::loops(mesh, &mut defects);
    combinatorial::edges(&uses, &mut defects);
    combinatorial::vertices(mesh, &uses, &mut defects);
    combinatorial::duplicate_faces(mesh, &mut defects);
    geometric::positions(mesh, &uses, &mut defects);
    geometric::faces(mesh, &mut defects);
    t_junction::t_junctions(mesh, &uses, &mut defects);
    if let Some(listed) = listed {
        edge_list::records(listed, &uses, &mut defects);
    }
    let counts = counts::counts(mesh, &uses, &mut defects);
    Report { defects, counts: Some(counts) }
}

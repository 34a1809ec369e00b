//! A list of edges that comes with a mesh, against the edges that its loops use.

use super::combinatorial::Uses;
use super::{Category, Defects, Element};
use crate::mesh::face::edge;
use crate::mesh::triangles::EdgeKey;
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// A list of edges, perhaps with the faces of each. Nothing else is promised.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct ListedEdges {
    edges: Vec<[u32; 2]>,
    faces: Option<Vec<Vec<u32>>>,
}

/// The lists of edges and of their faces differ in length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("expected {expected} items, one for each edge, found {found}")]
pub struct WrongLength {
    /// How many edges there are.
    pub expected: usize,
    /// How many lists of faces.
    pub found: usize,
}

impl ListedEdges {
    /// A list of edges, by their ends in either order, and the faces that each is said to belong to.
    ///
    /// # Errors
    /// Iff there are lists of faces, and not as many as edges.
    pub fn new(edges: Vec<[u32; 2]>, faces: Option<Vec<Vec<u32>>>) -> Result<ListedEdges, WrongLength> {
        match &faces {
            Some(faces) if faces.len() != edges.len() => Err(WrongLength { expected: edges.len(), found: faces.len() }),
            Some(_) | None => Ok(ListedEdges { edges, faces }),
        }
    }

    /// The ends of each edge.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// The faces of each edge, where they are listed.
    pub fn faces(&self) -> Option<&[Vec<u32>]> {
        self.faces.as_deref()
    }
}

/// The records against the uses, and the uses against the records.
///
/// The reference between edges and faces must go both ways (ME-59).
#[doc(alias = "ME-51")]
#[doc(alias = "ME-59")]
pub fn records(listed: &ListedEdges, uses: &Uses, defects: &mut Defects) {
    let mut times: BTreeMap<EdgeKey, usize> = BTreeMap::new();
    for (i, ends) in listed.edges.iter().enumerate() {
        let found = uses.at(edge(*ends));
        *times.entry(edge(*ends)).or_default() += 1;
        if found.is_empty() {
            defects.add(Category::EdgeUnreferenced, Element::Record(i));
        }
        if let Some(faces) = &listed.faces {
            let said: BTreeSet<usize> = faces[i].iter().map(|f| *f as usize).collect();
            let using: BTreeSet<usize> = found.iter().map(|u| u.face).collect();
            if said != using {
                defects.add(Category::EdgeFaceNotReciprocal, Element::Record(i));
            }
        }
    }
    for (edge, _) in uses.iter().filter(|(edge, _)| !times.contains_key(edge)) {
        defects.add(Category::EdgeMissingFromList, Element::Edge(edge));
    }
    for (edge, _) in times.into_iter().filter(|(_, n)| *n > 1) {
        defects.add(Category::DuplicateEdgeRecord, Element::Edge(edge));
    }
}

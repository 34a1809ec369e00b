//! What is placed in space: tetrahedra by their vertices, with their edges and triangles.

use crate::complex::triangulation::{EDGES, Skeleton, Triangulation};
use std::collections::BTreeSet;
use thiserror::Error;

/// Tetrahedra, and each of their edges and triangles once, by their vertices 0 … n−1. Several cells may have the same
/// vertices, and one cell may have a vertex twice: [`TetrahedralMesh::not_simplicial`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TetrahedralMesh {
    vertices: usize,
    edges: Vec<[u32; 2]>,
    triangles: Vec<[u32; 3]>,
    tetrahedra: Vec<[u32; 4]>,
}

/// Why lists of vertices are no tetrahedra.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum MeshError {
    /// A vertex that does not exist.
    #[error("tetrahedron {tetrahedron} has vertex {vertex}, which does not exist")]
    NoSuchVertex {
        /// The tetrahedron.
        tetrahedron: usize,
        /// The vertex.
        vertex: u32,
    },
    /// A vertex twice.
    #[error("tetrahedron {tetrahedron} has vertex {vertex} twice")]
    VertexTwice {
        /// The tetrahedron.
        tetrahedron: usize,
        /// The vertex.
        vertex: u32,
    },
}

/// What keeps the cells from being the simplices of a simplicial complex.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotSimplicial {
    /// A tetrahedron has a vertex twice.
    VertexTwice {
        /// The tetrahedron.
        tetrahedron: u32,
    },
    /// Two edges, triangles or tetrahedra have these vertices.
    SameVertices {
        /// The vertices, sorted.
        vertices: Vec<u32>,
    },
}

impl TetrahedralMesh {
    /// The cells of a closed triangulation.
    pub fn of(triangulation: &Triangulation) -> TetrahedralMesh {
        TetrahedralMesh::of_skeleton(&triangulation.skeleton())
    }

    /// The cells of a skeleton; its vertices, edges, triangles and tetrahedra keep their numbers.
    pub fn of_skeleton(skeleton: &Skeleton) -> TetrahedralMesh {
        let [vertices, edges, triangles, _] = skeleton.counts;
        let (mut edges, mut triangles) = (vec![[0; 2]; edges], vec![[0; 3]; triangles]);
        for (tetrahedron, corners) in skeleton.vertices.iter().enumerate() {
            for (edge, ends) in skeleton.edges[tetrahedron].iter().zip(EDGES) {
                edges[*edge as usize] = ends.map(|i| corners[i]);
            }
            for (i, triangle) in skeleton.triangles[tetrahedron].iter().enumerate() {
                triangles[*triangle as usize] = without(corners, i);
            }
        }
        TetrahedralMesh { vertices, edges, triangles, tetrahedra: skeleton.vertices.clone() }
    }

    /// The simplicial complex of these tetrahedra: edges and triangles are sets of vertices.
    ///
    /// # Errors
    /// Iff a tetrahedron has a vertex beyond `vertices`, or one twice.
    pub fn of_tetrahedra(vertices: usize, tetrahedra: &[[u32; 4]]) -> Result<TetrahedralMesh, MeshError> {
        let (mut edges, mut triangles) = (BTreeSet::new(), BTreeSet::new());
        for (tetrahedron, corners) in tetrahedra.iter().enumerate() {
            if let Some(vertex) = corners.iter().find(|v| **v as usize >= vertices) {
                return Err(MeshError::NoSuchVertex { tetrahedron, vertex: *vertex });
            }
            let mut corners = *corners;
            corners.sort_unstable();
            if let Some(pair) = corners.windows(2).find(|pair| pair[0] == pair[1]) {
                return Err(MeshError::VertexTwice { tetrahedron, vertex: pair[0] });
            }
            edges.extend(EDGES.map(|ends| ends.map(|i| corners[i])));
            triangles.extend([0, 1, 2, 3].map(|i| without(&corners, i)));
        }
        let (edges, triangles) = (edges.into_iter().collect(), triangles.into_iter().collect());
        Ok(TetrahedralMesh { vertices, edges, triangles, tetrahedra: tetrahedra.to_vec() })
    }

    /// How many vertices there are.
    pub fn vertices(&self) -> usize {
        self.vertices
    }

    /// The ends of each edge; a loop has the same vertex twice.
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// The corners of each triangle.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The corners of each tetrahedron.
    pub fn tetrahedra(&self) -> &[[u32; 4]] {
        &self.tetrahedra
    }

    /// The first thing that keeps it from being a simplicial complex; `None` iff it is one: no tetrahedron has a vertex twice,
    /// and edges, triangles and tetrahedra are each determined by their vertices.
    pub fn not_simplicial(&self) -> Option<NotSimplicial> {
        let twice = |corners: &[u32; 4]| EDGES.iter().any(|[i, j]| corners[*i] == corners[*j]);
        if let Some(tetrahedron) = self.tetrahedra.iter().position(twice) {
            return Some(NotSimplicial::VertexTwice { tetrahedron: tetrahedron as u32 });
        }
        let same = repeated(&self.edges).or_else(|| repeated(&self.triangles)).or_else(|| repeated(&self.tetrahedra));
        same.map(|vertices| NotSimplicial::SameVertices { vertices })
    }
}

/// The corners of the triangle opposite corner i.
fn without(corners: &[u32; 4], i: usize) -> [u32; 3] {
    std::array::from_fn(|j| corners[if j < i { j } else { j + 1 }])
}

/// The least set of vertices that two of the cells have.
fn repeated<const N: usize>(cells: &[[u32; N]]) -> Option<Vec<u32>> {
    let mut sets = cells.to_vec();
    sets.iter_mut().for_each(|set| set.sort_unstable());
    sets.sort_unstable();
    sets.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0].to_vec())
}

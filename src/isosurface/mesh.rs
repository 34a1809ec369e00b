//! Marching cubes with the topology of the trilinear isosurface (IS-91, IS-94).

use super::cell::assemble;
use super::cube::Edge;
use super::patch::{PatchVertex, patch};
use super::volume::{DegenerateCell, GridEdge, Level};
use crate::number::Rational;
use std::collections::HashMap;

/// A vertex of an isosurface mesh, by what it is; its position follows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Vertex {
    /// The crossing on an edge of the grid.
    Crossing(GridEdge),
    /// The mean of some crossings of one cell, inside that cell.
    Inner(Box<[GridEdge]>),
}

/// A triangle mesh of an isosurface, normals toward f > c.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Mesh {
    /// Its vertices.
    pub vertices: Vec<Vertex>,
    /// Its triangles, as vertex numbers, counter-clockwise seen from f > c.
    pub triangles: Vec<[u32; 3]>,
}

impl Level<'_> {
    /// The exact position of a vertex.
    pub fn position(&self, vertex: &Vertex) -> [Rational; 3] {
        match vertex {
            Vertex::Crossing(edge) => self.crossing_position(*edge),
            Vertex::Inner(edges) => {
                let mut sum = [Rational::new(), Rational::new(), Rational::new()];
                for edge in edges {
                    for (total, x) in sum.iter_mut().zip(self.crossing_position(*edge)) {
                        *total += x;
                    }
                }
                sum.map(|total| total / Rational::from(edges.len()))
            }
        }
    }
}

/// A triangle mesh homeomorphic to the piecewise trilinear {f = c}: a 2-manifold whose boundary lies on
/// the border of the grid, with one vertex on each crossed grid edge.
///
/// Errors: a cell of which c is a critical value, unless ties are broken.
#[doc(alias = "IS-94")]
pub fn extract(level: &Level) -> Result<Mesh, DegenerateCell> {
    let mut mesh = Mesh::default();
    let mut crossings: HashMap<GridEdge, u32> = HashMap::new();
    for cell in level.volume.cells() {
        let patch = patch(&assemble(level.decisions(cell)?));
        let grid_edge = |edge: Edge| level.grid_edge(cell, edge);
        let mut number = |vertices: &mut Vec<Vertex>, edge: GridEdge| {
            *crossings.entry(edge).or_insert_with(|| push(vertices, Vertex::Crossing(edge)))
        };
        let inner: Vec<u32> = patch
            .inner
            .iter()
            .map(|rim| push(&mut mesh.vertices, Vertex::Inner(rim.iter().map(|e| grid_edge(*e)).collect())))
            .collect();
        for triangle in &patch.triangles {
            mesh.triangles.push(triangle.map(|vertex| match vertex {
                PatchVertex::Crossing(edge) => number(&mut mesh.vertices, grid_edge(edge)),
                PatchVertex::Inner(i) => inner[usize::from(i)],
            }));
        }
    }
    Ok(mesh)
}

pub(super) fn push(vertices: &mut Vec<Vertex>, vertex: Vertex) -> u32 {
    vertices.push(vertex);
    u32::try_from(vertices.len() - 1).expect("fewer than 2³² vertices")
}

//! Meshes as they leave: `{"vertices":[[x,y,z],…],"faces":[[0,1,2],…]}`.

use super::value::Exact;
use crate::isosurface::mesh::Mesh;
use crate::isosurface::volume::Level;
use serde::Serialize;

/// A triangle mesh with exact positions.
#[derive(Serialize)]
pub struct MeshOut<'a> {
    vertices: Vec<[Exact; 3]>,
    faces: &'a [[u32; 3]],
}

impl<'a> MeshOut<'a> {
    /// An isosurface mesh of a level.
    pub fn of(mesh: &'a Mesh, level: &Level) -> MeshOut<'a> {
        let vertices = mesh.vertices.iter().map(|vertex| level.position(vertex).map(Exact)).collect();
        MeshOut { vertices, faces: &mesh.triangles }
    }
}

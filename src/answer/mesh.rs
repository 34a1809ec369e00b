//! Meshes as they leave: `{"vertices":[[x,y,z],…],"faces":[[0,1,2],…]}`.

use super::value::Exact;
use crate::format::{MeshRecord, Precision};
use crate::isosurface::mesh::Mesh;
use crate::isosurface::tetrahedra::TetrahedraMesh;
use crate::isosurface::volume::Level;
use crate::number::binary::nearest_f64;
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

    /// The surface of marching tetrahedra of a level.
    pub fn of_tetrahedra(mesh: &'a TetrahedraMesh, level: &Level) -> MeshOut<'a> {
        let vertices = mesh.vertices.iter().map(|pair| level.crossing_between(*pair).map(Exact)).collect();
        MeshOut { vertices, faces: &mesh.triangles }
    }
}

/// An isosurface mesh as a file has it: each coordinate the binary64 nearest to it.
pub fn record(mesh: &Mesh, level: &Level) -> MeshRecord {
    MeshRecord {
        vertices: mesh.vertices.iter().map(|vertex| level.position(vertex).map(|x| nearest_f64(&x))).collect(),
        faces: mesh.triangles.iter().map(|triangle| triangle.to_vec()).collect(),
        precision: Precision::Binary64,
        soup: false,
    }
}

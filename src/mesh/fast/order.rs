//! The order of a mesh in memory: what lies close in space is given numbers close together.

use super::bounds::{Bounds, Item};
use super::polygons::Polygons;
use super::report::{Elements, Report};
use crate::mesh::triangles::EdgeKey;
use std::mem;

/// Whether the corners, one after another, so often name a vertex that is far from those named before that most of the time
/// of a check would go into waiting for memory.
///
/// They are counted that miss a cache of 256 lines of 16 vertices. Where a mesh is in any order of space, there are few.
pub fn is_scattered(mesh: &Polygons) -> bool {
    let mut held = [u32::MAX; 256];
    let missed = |v: &&u32| {
        let line = **v / 16;
        // Lines a power of two apart, as of the rows of a grid, have different places.
        let place = line.wrapping_mul(0x9E37_79B1) >> 24;
        mem::replace(&mut held[place as usize], line) != line
    };
    mesh.corners().iter().filter(missed).count() > mesh.corners().len() / 8
}

/// A mesh with other numbers for its vertices and faces, and those that they had.
pub struct Renumbered {
    mesh: Polygons,
    /// By new number, the old one.
    vertices: Vec<u32>,
    faces: Vec<u32>,
}

/// So few vertices stay in the order that they have.
const CLOSE: usize = 8;

impl Renumbered {
    /// Vertices by the halves of their box along its longest side, then by the halves of these and so on; faces by their
    /// least vertices. Loops begin where they did, and a number that no vertex has stays as it is.
    pub fn in_space(mesh: &Polygons) -> Renumbered {
        let mut items: Vec<Item> = (0..).zip(mesh.vertices()).map(|(id, &at)| Item { at, id }).collect();
        halve(&mut items);
        let mut number = vec![0; items.len()];
        (0..).zip(&items).for_each(|(new, item)| number[item.id as usize] = new);
        let (points, vertices) = items.into_iter().map(|item| (item.at, item.id)).unzip();
        let renamed: Vec<u32> = mesh.corners().iter().map(|&v| number.get(v as usize).copied().unwrap_or(v)).collect();
        let faces = by_least_vertex(mesh, &renamed);
        let mut corners = Vec::with_capacity(renamed.len());
        let ends = faces.iter().map(|&face| {
            corners.extend_from_slice(&renamed[mesh.range(face as usize)]);
            corners.len() as u32
        });
        let ends = ends.collect();
        Renumbered { mesh: Polygons::new(points, corners, ends).expect("as sound as before"), vertices, faces }
    }

    /// The mesh with the new numbers.
    pub fn mesh(&self) -> &Polygons {
        &self.mesh
    }

    /// What is reported of the mesh with the new numbers, in the old ones.
    pub fn in_old_numbers(&self, mut report: Report) -> Report {
        let vertex = |v: &mut u32| *v = self.vertices[*v as usize];
        let face = |f: &mut u32| *f = self.faces[*f as usize];
        let edge = |edge: &mut EdgeKey| {
            edge.iter_mut().for_each(vertex);
            edge.sort_unstable();
        };
        for elements in report.defects.values_mut() {
            match elements {
                Elements::Faces(list) => restore(list, face),
                Elements::Vertices(list) => restore(list, vertex),
                Elements::Edges(list) => restore(list, edge),
                Elements::VertexGroups(list) => restore(list, |group| restore(group, vertex)),
                Elements::FaceGroups(list) => restore(list, |group| restore(group, face)),
                Elements::Junctions(list) => restore(list, |(v, e)| {
                    vertex(v);
                    edge(e);
                }),
                Elements::Whole => {}
            }
        }
        report
    }
}

fn halve(items: &mut [Item]) {
    if items.len() <= CLOSE {
        return;
    }
    if let Some(bounds) = Bounds::of(items) {
        let (low, high) = bounds.halves(items);
        halve(low);
        halve(high);
    }
}

/// The faces in the order of their least vertices, those with the same one as before. Sorted by counting.
///
/// `corners` are those of the mesh with new numbers.
fn by_least_vertex(mesh: &Polygons, corners: &[u32]) -> Vec<u32> {
    let vertices = mesh.vertices().len();
    // What has no vertex, or none that exists, comes last.
    let least = |f: usize| corners[mesh.range(f)].iter().map(|&v| v as usize).min().unwrap_or(vertices).min(vertices);
    let mut free = vec![0; vertices + 2];
    (0..mesh.faces()).for_each(|f| free[least(f) + 1] += 1);
    for v in 1..free.len() {
        free[v] += free[v - 1];
    }
    let mut faces = vec![0; mesh.faces()];
    for f in 0..mesh.faces() {
        let place = &mut free[least(f)];
        faces[*place] = f as u32;
        *place += 1;
    }
    faces
}

/// Gives every element of a list its old number, and sorts the list again.
fn restore<T: Ord>(list: &mut [T], old: impl FnMut(&mut T)) {
    list.iter_mut().for_each(old);
    list.sort_unstable();
}

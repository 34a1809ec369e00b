//! The criteria of 003, 5 and 5.5, by counting anew.

use isoracle::mesh::defects::{Category, Counts, check};
use isoracle::mesh::face::Face;
use isoracle::mesh::vertex_list::{Point, VertexList};
use std::collections::{BTreeMap, BTreeSet};

/// The polygons at each edge, a polygon once for each use.
pub fn polygons_at(mesh: &VertexList) -> BTreeMap<[u32; 2], Vec<usize>> {
    let mut at: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    for (i, face) in mesh.faces.iter().enumerate() {
        for [a, b] in face.sides().filter(|[a, b]| a != b) {
            at.entry([a.min(b), a.max(b)]).or_default().push(i);
        }
    }
    at
}

/// The numbers of uses of edges that occur.
pub fn uses(mesh: &VertexList) -> BTreeSet<usize> {
    polygons_at(mesh).values().map(Vec::len).collect()
}

/// The numbers of different polygons at an edge that occur.
pub fn different_polygons(mesh: &VertexList) -> BTreeSet<usize> {
    polygons_at(mesh).values().map(|at| at.iter().collect::<BTreeSet<_>>().len()).collect()
}

/// The categories that a mesh has defects of.
pub fn categories(mesh: &VertexList) -> Vec<Category> {
    check(mesh, None).defects.iter().map(|(category, _)| category).collect()
}

/// The numbers of a mesh.
pub fn counts(mesh: &VertexList) -> Counts {
    check(mesh, None).counts.expect("indices are in range")
}

/// The mesh without some of its faces.
pub fn without(mesh: &VertexList, is_missing: impl Fn(usize) -> bool) -> VertexList {
    let faces = (0..).zip(&mesh.faces).filter(|(i, _)| !is_missing(*i)).map(|(_, face)| face.clone()).collect();
    VertexList { faces, ..mesh.clone() }
}

/// Whether edges join all used vertices.
pub fn edges_connect(mesh: &VertexList) -> bool {
    let edges: Vec<[u32; 2]> = polygons_at(mesh).into_keys().collect();
    let mut reached: BTreeSet<u32> = mesh.faces.iter().flat_map(Face::vertices).take(1).collect();
    for _ in &mesh.vertices {
        let next = edges.iter().filter(|edge| edge.iter().any(|v| reached.contains(v)));
        reached.extend(next.flatten().copied().collect::<Vec<_>>());
    }
    mesh.faces.iter().flat_map(Face::vertices).all(|v| reached.contains(&v))
}

/// The criteria of 003, 5 and 5.5, that a mesh fails, for one that is to be closed, connected and plane.
pub fn printed_failures(mesh: &VertexList) -> Vec<&'static str> {
    let at = polygons_at(mesh);
    let degree = |v: u32| at.keys().filter(|edge| edge.contains(&v)).count();
    let plane = |face: &Face| {
        let points: Vec<Point> = face.vertices().map(|v| mesh.vertices[v as usize].clone()).collect();
        face.outer.len() <= 3 || super::naive_check::in_a_plane(&points)
    };
    let (used, n) = (mesh.faces.iter().flat_map(Face::vertices).collect::<BTreeSet<_>>(), mesh.vertices.len());
    let criteria = [
        ("three vertices", mesh.faces.iter().all(|face| face.outer.len() >= 3)),
        ("two polygons", different_polygons(mesh).iter().all(|n| *n >= 2)),
        ("even", uses(mesh).iter().all(|n| n % 2 == 0)),
        ("at most two", uses(mesh).iter().all(|n| *n <= 2)),
        ("two edges", used.iter().all(|v| degree(*v) >= 2)),
        ("connected", edges_connect(mesh)),
        ("plane", mesh.faces.iter().all(plane)),
        ("once in a polygon", at.values().all(|at| at.iter().collect::<BTreeSet<_>>().len() == at.len())),
        ("in a polygon", used.len() == n),
        ("length", at.keys().all(|[a, b]| mesh.vertices[*a as usize] != mesh.vertices[*b as usize])),
    ];
    criteria.into_iter().filter(|(_, holds)| !holds).map(|(name, _)| name).collect()
}

//! What positions show: coinciding vertices, and each face by itself.

use super::combinatorial::Uses;
use super::crossing::crosses_itself;
use super::{Category, Defects, Element};
use crate::linear::Vector;
use crate::mesh::face::Face;
use crate::mesh::plane::{Span, projected_areas, span};
use crate::mesh::vertex_list::{Point, VertexList};
use crate::number::Rational;
use std::collections::BTreeMap;

/// Vertices at one position, and edges between them.
#[doc(alias = "ME-58")]
pub fn positions(mesh: &VertexList, uses: &Uses, defects: &mut Defects) {
    let mut at: BTreeMap<&Point, Vec<u32>> = BTreeMap::new();
    for (v, point) in (0..).zip(&mesh.vertices) {
        at.entry(point).or_default().push(v);
    }
    for vertices in at.into_values().filter(|vertices| vertices.len() > 1) {
        defects.add(Category::DuplicateVertexPosition, Element::Vertices(vertices));
    }
    for (edge, _) in uses.iter() {
        let [a, b] = edge.map(|v| &mesh.vertices[v as usize]);
        if a == b {
            defects.add(Category::ZeroLengthEdge, Element::Edge(edge));
        }
    }
}

/// Each face by its shape.
#[doc(alias = "ME-55")]
pub fn faces(mesh: &VertexList, defects: &mut Defects) {
    for (i, face) in mesh.faces.iter().enumerate() {
        let mut add = |category| defects.add(category, Element::Face(i));
        if face.vertices().count() >= 3 {
            match span(face.vertices().map(|v| &mesh.vertices[v as usize])) {
                Span::Empty | Span::Point | Span::Line => add(Category::ZeroAreaFace),
                Span::Space => add(Category::NonplanarFace),
                Span::Plane(normal) => {
                    if area(mesh, face) == Vector::zero() {
                        add(Category::ZeroSignedAreaFace);
                    }
                    if crosses_itself(&points(mesh, &face.outer), &normal) {
                        add(Category::SelfCrossingLoop);
                    }
                }
            }
        }
        if !same_sense_holes(mesh, face).is_empty() {
            add(Category::HoleSameSenseAsOuter);
        }
    }
}

/// The positions of a loop's vertices.
pub fn points<'a>(mesh: &'a VertexList, loop_: &[u32]) -> Vec<&'a Point> {
    loop_.iter().map(|&v| &mesh.vertices[v as usize]).collect()
}

/// (A, B, C) of all loops of a face together.
fn area(mesh: &VertexList, face: &Face) -> Point {
    face.loops().fold(Vector::zero(), |sum, loop_| sum + &projected_areas(points(mesh, loop_)))
}

/// The loops of a face, as [`Face::loops`] counts them, that are holes wound like the outer one.
pub fn same_sense_holes(mesh: &VertexList, face: &Face) -> Vec<usize> {
    if face.holes.is_empty() {
        return Vec::new();
    }
    let outer = projected_areas(points(mesh, &face.outer));
    let same = |hole: &[u32]| projected_areas(points(mesh, hole)).dot(&outer) > Rational::new();
    (1..).zip(&face.holes).filter(|(_, hole)| same(hole)).map(|(loop_, _)| loop_).collect()
}

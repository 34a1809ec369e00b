//! Quickcheck's `Arbitrary` for polygon meshes.

use super::face::Face;
use super::vertex_list::VertexList;
use crate::linear::Vector;
use crate::number::Rational;
use quickcheck::{Arbitrary, Gen};

/// Up to six corners of the numbers 0 … 5, now and then with a hole.
impl Arbitrary for Face {
    fn arbitrary(g: &mut Gen) -> Face {
        let any_loop = |g: &mut Gen| (0..u8::arbitrary(g) % 7).map(|_| u32::arbitrary(g) % 6).collect();
        let holes = if u8::arbitrary(g).is_multiple_of(4) { vec![any_loop(g)] } else { Vec::new() };
        Face { outer: any_loop(g), holes }
    }

    /// Without its holes, or without one corner.
    fn shrink(&self) -> Box<dyn Iterator<Item = Face>> {
        let face = self.clone();
        let without_holes = (!face.holes.is_empty()).then(|| Face::new(face.outer.clone()));
        let fewer = (0..face.outer.len()).map(move |i| {
            let mut fewer = face.clone();
            fewer.outer.remove(i);
            fewer
        });
        Box::new(without_holes.into_iter().chain(fewer))
    }
}

/// Up to six faces over six vertices with small integer coordinates; every vertex number exists.
impl Arbitrary for VertexList {
    fn arbitrary(g: &mut Gen) -> VertexList {
        let coordinate = |g: &mut Gen| Rational::from(i8::arbitrary(g) % 3);
        let vertices = (0..6).map(|_| Vector([coordinate(g), coordinate(g), coordinate(g)])).collect();
        let faces = (0..u8::arbitrary(g) % 7).map(|_| Face::arbitrary(g)).collect();
        VertexList { vertices, faces }
    }

    /// Without one face, or with one face smaller.
    fn shrink(&self) -> Box<dyn Iterator<Item = VertexList>> {
        let mesh = self.clone();
        let with = |mesh: &VertexList, faces: Vec<Face>| VertexList { vertices: mesh.vertices.clone(), faces };
        Box::new((0..mesh.faces.len()).flat_map(move |f| {
            let mut fewer = mesh.faces.clone();
            let face = fewer.remove(f);
            let smaller: Vec<VertexList> = face
                .shrink()
                .map(|smaller| {
                    let mut faces = mesh.faces.clone();
                    faces[f] = smaller;
                    with(&mesh, faces)
                })
                .collect();
            std::iter::once(with(&mesh, fewer)).chain(smaller)
        }))
    }
}

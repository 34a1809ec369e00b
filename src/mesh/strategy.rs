//! Proptest strategies for polygon meshes: sound solids, and heaps of faces in which most defects are common.

use super::examples::solids::{
    block_with_cavity, block_with_pit, block_with_through_holes, divided_cube, frame, hexagonal_prism, pierced_block,
};
use super::examples::{cube, tetrahedron};
use super::face::Face;
use super::vertex_list::{Point, VertexList};
use crate::linear::Vector;
use crate::number::Rational;
use proptest::prelude::*;

/// A sound solid: closed, plane faces, counterclockwise from outside, of genus 0 to 2, with holes in faces or without, of
/// one shell or two; under an affine map that keeps its orientation, its vertices in another order.
pub fn solid() -> impl Strategy<Value = VertexList> {
    let solids = vec![
        tetrahedron(),
        cube(),
        hexagonal_prism(),
        divided_cube(),
        frame(),
        block_with_pit(),
        block_with_through_holes(1),
        block_with_through_holes(2),
        pierced_block(),
        block_with_cavity(),
    ];
    prop::sample::select(solids).prop_flat_map(|solid| {
        let order = Just((0..solid.vertices.len() as u32).collect::<Vec<_>>()).prop_shuffle();
        (Just(solid), order, affine_map()).prop_map(|(solid, order, [origin, stretch, shear])| {
            // Lower triangular with a positive diagonal.
            let map = |v: &Point| {
                let [x, y, z] = &v.0;
                let row = |a: &Rational, x: &Rational, b: &Rational, y: &Rational| {
                    Rational::from(a * x) + Rational::from(b * y)
                };
                let zero = Rational::new();
                let image = Vector([
                    row(&stretch[0], x, &zero, y),
                    row(&shear[0], x, &stretch[1], y),
                    row(&shear[1], x, &shear[2], y) + Rational::from(&stretch[2] * z),
                ]);
                image + &Vector(origin.clone())
            };
            let mut vertices = vec![Vector::zero(); order.len()];
            for (v, position) in solid.vertices.iter().enumerate() {
                vertices[order[v] as usize] = map(position);
            }
            let renumbered = |l: &[u32]| l.iter().map(|v| order[*v as usize]).collect::<Vec<u32>>();
            let face = |face: &Face| Face {
                outer: renumbered(&face.outer),
                holes: face.holes.iter().map(|hole| renumbered(hole)).collect(),
            };
            VertexList { vertices, faces: solid.faces.iter().map(face).collect() }
        })
    })
}

/// An origin, three positive stretches, three shears.
fn affine_map() -> impl Strategy<Value = [[Rational; 3]; 3]> {
    let rational = |p: std::ops::RangeInclusive<i64>| (p, 1..=9_i64).prop_map(Rational::from);
    let triple = move |p: std::ops::RangeInclusive<i64>| prop::array::uniform3(rational(p));
    (triple(-9..=9), triple(1..=9), triple(-9..=9)).prop_map(|(origin, stretch, shear)| [origin, stretch, shear])
}

/// Up to `most` faces of up to five corners, some with a hole, over six vertices on a grid of 3×3×3 or next to it: nothing is
/// promised, but that every vertex number exists.
pub fn heap(most: usize) -> impl Strategy<Value = VertexList> {
    let nudge = prop_oneof![8 => Just(Rational::new()), 1 => Just(Rational::from((1, 1_000_000_000_000_000_i64)))];
    let coordinate = (0..3_i64, nudge).prop_map(|(x, nudge)| nudge + x);
    let vertices = prop::collection::vec(prop::array::uniform3(coordinate).prop_map(Vector), 6);
    let a_loop = || prop::collection::vec(0..6_u32, 0..=5);
    let holes = prop_oneof![4 => Just(Vec::new()), 1 => a_loop().prop_map(|hole| vec![hole])];
    let face = (a_loop(), holes).prop_map(|(outer, holes)| Face { outer, holes });
    (vertices, prop::collection::vec(face, 0..=most)).prop_map(|(vertices, faces)| VertexList { vertices, faces })
}

//! The same gluing, written in another way.

use crate::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, SignedEdge};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// How the corners of a face are numbered anew: corner i becomes corner `sense` · i + `offset`.
#[derive(Clone, Copy)]
struct Corners {
    sense: i64,
    offset: i64,
}

/// The same gluing with other names: polyhedra, faces, edges, vertices and pairings in another order, edges the other way round,
/// cycles begun elsewhere, polyhedra seen from the other side, pairings turned round, shifts by multiples of n more.
/// No answer about a scheme depends on any of it. The scheme has no defect by itself.
#[doc(alias = "CX-97")]
pub fn disguised(random: &mut ChaCha8Rng, scheme: &GluingScheme) -> GluingScheme {
    let polyhedron_to = shuffled(random, scheme.polyhedra.len());
    let mut polyhedra = vec![Polyhedron::default(); scheme.polyhedra.len()];
    let mut faces = Vec::new();
    for (number, polyhedron) in scheme.polyhedra.iter().enumerate() {
        let (other, of_faces) = renamed(random, polyhedron);
        polyhedra[polyhedron_to[number]] = other;
        faces.push(of_faces);
    }
    let place = |id: FaceId| {
        let (face, corners) = faces[id.polyhedron][id.face];
        (FaceId { polyhedron: polyhedron_to[id.polyhedron], face }, corners)
    };
    let mut pairings: Vec<Pairing> = Vec::new();
    for Pairing { a, b, shift, dir } in &scheme.pairings {
        let n = scheme.face(*a).expect("the scheme was checked").len() as i64;
        let ((a, of_a), (b, of_b)) = (place(*a), place(*b));
        // j = shift + dir · i, in the new numbers of i and j.
        let dir = of_b.sense * dir * of_a.sense;
        let shift = of_b.sense * shift + of_b.offset - dir * of_a.offset;
        let turned = if random.random() {
            Pairing { a, b, shift, dir }
        } else {
            // i = dir · (j − shift), for dir is its own inverse.
            Pairing { a: b, b: a, shift: -dir * shift, dir }
        };
        let shift = turned.shift.rem_euclid(n) + n * [0, 0, 0, 1, -1, 1000][random.random_range(0..6)];
        pairings.insert(random.random_range(0..=pairings.len()), Pairing { shift, ..turned });
    }
    GluingScheme { polyhedra, pairings }
}

/// A polyhedron with other names; and for each face its new number and those of its corners.
fn renamed(random: &mut ChaCha8Rng, polyhedron: &Polyhedron) -> (Polyhedron, Vec<(usize, Corners)>) {
    let names = polyhedron.edges.iter().flatten().max().map_or(0, |most| *most as usize + 1);
    let (vertex_to, gap) = (shuffled(random, names), random.random_range(1..3));
    let edge_to = shuffled(random, polyhedron.edges.len());
    let flips: Vec<bool> = polyhedron.edges.iter().map(|_| random.random()).collect();
    let mut edges = vec![[0, 0]; polyhedron.edges.len()];
    for (i, [tail, head]) in polyhedron.edges.iter().enumerate() {
        let [tail, head] = [tail, head].map(|v| (gap * vertex_to[*v as usize]) as u32);
        edges[edge_to[i]] = if flips[i] { [head, tail] } else { [tail, head] };
    }
    let side = |side: &SignedEdge| {
        let old = side.index().expect("the scheme was checked");
        let edge = edge_to[old] as i32 + 1;
        SignedEdge(if side.is_forward() == flips[old] { -edge } else { edge })
    };
    let from_the_other_side: bool = random.random();
    let face_to = shuffled(random, polyhedron.faces.len());
    let mut faces = vec![Vec::new(); polyhedron.faces.len()];
    let mut of_faces = Vec::new();
    for (number, old) in polyhedron.faces.iter().enumerate() {
        let mut sides: Vec<SignedEdge> = old.iter().map(side).collect();
        if from_the_other_side {
            sides.reverse();
            sides.iter_mut().for_each(|side| side.0 = -side.0);
        }
        let begin = random.random_range(0..sides.len());
        sides.rotate_left(begin);
        faces[face_to[number]] = sides;
        let sense = if from_the_other_side { -1 } else { 1 };
        of_faces.push((face_to[number], Corners { sense, offset: -(begin as i64) }));
    }
    (Polyhedron { edges, faces }, of_faces)
}

/// The numbers 0 … n − 1 in a random order.
fn shuffled(random: &mut ChaCha8Rng, n: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..n).collect();
    for i in (1..n).rev() {
        order.swap(i, random.random_range(0..=i));
    }
    order
}

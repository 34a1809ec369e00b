//! Planting a defect in a sound scheme. Others may come with it; whether it is there is the oracle's to say.

use super::bases;
use crate::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, Reason, SignedEdge};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// Tries to give the scheme a defect of that reason.
pub fn plant(random: &mut ChaCha8Rng, scheme: &mut GluingScheme, reason: Reason) {
    let i = random.random_range(0..scheme.pairings.len());
    let j = random.random_range(0..scheme.pairings.len());
    let Pairing { a, b, .. } = scheme.pairings[i];
    let other = scheme.pairings[j];
    match reason {
        Reason::UnmatchedFace => match random.random_range(0..3) {
            0 => drop(scheme.pairings.remove(i)),
            1 => scheme.polyhedra.push(Polyhedron::lens(random.random_range(1..4))),
            _ => scheme.pairings.clear(),
        },
        Reason::PolygonSizeMismatch => {
            // Beside something with other faces, partners exchanged.
            *scheme = bases::beside(scheme.clone(), bases::twisted_prism(6, 0));
            let last = scheme.pairings.len() - [1, 4][random.random_range(0..2)];
            scheme.pairings[i].b = scheme.pairings[last].b;
            scheme.pairings[last].b = b;
        }
        Reason::FaceGluedToItself => match random.random_range(0..3) {
            0 => scheme.pairings[i].b = a,
            1 => scheme.pairings.push(Pairing { a, b: a, shift: 0, dir: 1 }),
            _ => {
                // Both faces of a pairing folded.
                scheme.pairings[i].b = a;
                scheme.pairings.push(Pairing { a: b, b, shift: 1, dir: -1 });
            }
        },
        Reason::FaceInTwoPairings => match random.random_range(0..3) {
            0 => scheme.pairings.push(other),
            1 => scheme.pairings[i].b = other.a,
            _ => scheme.pairings.push(Pairing { a: b, b: other.a, shift: 0, dir: -1 }),
        },
        Reason::BadPairing => match random.random_range(0..4) {
            0 => scheme.pairings[i].dir = [0, 2, -2, 3][random.random_range(0..4)],
            1 => scheme.pairings[i].a.face = scheme.polyhedra[a.polyhedron].faces.len(),
            2 => scheme.pairings[i].b.polyhedron = scheme.polyhedra.len() + random.random_range(0..2),
            _ => {
                let stray = FaceId { polyhedron: scheme.polyhedra.len(), face: 0 };
                scheme.pairings.push(Pairing { a: stray, b: stray, shift: 0, dir: 1 });
            }
        },
        Reason::BadPolyhedron => spoil(random, scheme, a),
        Reason::EdgeReversed | Reason::VertexLink => *scheme = pseudomanifold(random),
    }
}

/// What makes no manifold most of the time.
fn pseudomanifold(random: &mut ChaCha8Rng) -> GluingScheme {
    let count = random.random_range(1..4);
    match random.random_range(0..4) {
        0 => bases::tetrahedron(random.random_range(0..bases::TETRAHEDRA)),
        1 => bases::cube(random.random_range(0..bases::CUBES)),
        2 => bases::prism(random),
        _ => bases::several(random, count),
    }
}

/// Makes the polyhedron of that face no ball.
fn spoil(random: &mut ChaCha8Rng, scheme: &mut GluingScheme, id: FaceId) {
    let edges = scheme.polyhedra[id.polyhedron].edges.len() as i32;
    let polyhedron = &mut scheme.polyhedra[id.polyhedron];
    let face = &mut polyhedron.faces[id.face];
    let side = random.random_range(0..face.len());
    match random.random_range(0..11) {
        0 => drop(face.remove(side)),
        1 => face[side].0 = -face[side].0,
        2 => face[side] = SignedEdge([0, edges + 1, -edges - 1, i32::MIN][random.random_range(0..4)]),
        3 => face.clear(),
        4 => {
            // Seen from inside, where the others are seen from outside.
            face.reverse();
            face.iter_mut().for_each(|side| side.0 = -side.0);
        }
        5 => drop(polyhedron.faces.remove(id.face)),
        6 => {
            let twin = polyhedron.faces[id.face].clone();
            polyhedron.faces.push(twin);
        }
        7 => scheme.polyhedra.clear(),
        8 => polyhedron.edges[side % edges as usize][0] += 1,
        9 => {
            // A torus, or two spheres, or two spheres that touch.
            let from = random.random_range(0..2);
            *polyhedron = match random.random_range(0..2) {
                0 => Polyhedron { edges: vec![[0, 0]; 2], faces: vec![[1, 2, -1, -2].map(SignedEdge).to_vec()] },
                _ => two_spheres(1 - from),
            };
        }
        _ => polyhedron.edges.push([0, 1]),
    }
}

/// Two spheres of two monogons each, at vertices that differ or not.
fn two_spheres(other: u32) -> Polyhedron {
    let faces = [1, -1, 2, -2].map(|side| vec![SignedEdge(side)]);
    Polyhedron { edges: vec![[0, 0], [other, other]], faces: faces.to_vec() }
}

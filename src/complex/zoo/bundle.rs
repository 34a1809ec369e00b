//! Bundles over the circle: a prism whose top is glued to its bottom, or a pile of them.

use super::super::examples::paired;
use super::super::scheme::{GluingScheme, Polyhedron};
use super::convex::by_corners;

/// A surface from a polygon, times an interval, closed up: the prism over an n-gon whose sides are glued as the letters of the word
/// are, straight up; vertex i of the bottom goes to vertex turn + i of the top, or to turn − i if it is mirrored.
///
/// The word has each letter twice, a capital one where the side is walked along backwards; side i goes from vertex i to
/// i + 1. The map of the polygon has to be one of the surface.
pub(super) fn prism(word: &str, turn: u32, mirrored: bool) -> GluingScheme {
    let letters: Vec<char> = word.chars().collect();
    let n = letters.len();
    let mut pairs = Vec::new();
    for (i, letter) in letters.iter().enumerate() {
        let other = (i + 1..n).find(|j| letters[*j].eq_ignore_ascii_case(letter));
        if let Some(j) = other {
            // Side i is the face (i, i + 1, above, above): corner 0 goes to corner 0, or to corner 1 along a mirrored edge.
            let (shift, dir) = if letters[j] == *letter { (0, 1) } else { (1, -1) };
            pairs.push((i + 2, j + 2, shift, dir));
        }
    }
    // Corner c of the bottom is vertex n − 1 − c.
    let (last, turn) = (n as i64 - 1, i64::from(turn));
    pairs.push(if mirrored { (0, 1, turn - last, 1) } else { (0, 1, turn + last, -1) });
    paired(Polyhedron::prism(n as u32), &pairs)
}

/// The bundle of tori whose monodromy is the product of these letters, U = (1 1; 0 1) and L = (1 0; 1 1): a cube a letter, whose sides
/// are glued straight across, bottom cut along a diagonal and top along the other one, which the shear takes to that of the
/// next bottom.
pub(super) fn torus_bundle(letters: &str) -> GluingScheme {
    // Bottom 0 (0,0), 1 (1,0), 2 (1,1), 3 (0,1), top 4 … 7 above.
    let cube: [&[u32]; 8] =
        [&[0, 2, 1], &[0, 3, 2], &[4, 5, 7], &[5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
    let n = letters.chars().count();
    let mut pairings = Vec::new();
    for (i, letter) in letters.chars().enumerate() {
        let glue = |face: usize, polyhedron: usize, to: usize, images: &[u32]| {
            by_corners([i, face], [polyhedron, to], cube[to], images)
        };
        let next = (i + 1) % n;
        pairings.push(glue(4, i, 6, &[3, 2, 6, 7]));
        pairings.push(glue(5, i, 7, &[0, 3, 7, 4]));
        pairings.extend(match letter {
            'U' => [glue(2, next, 0, &[0, 1, 2]), glue(3, next, 1, &[0, 2, 3])],
            _ => [glue(2, next, 1, &[0, 2, 3]), glue(3, next, 0, &[1, 2, 0])],
        });
    }
    let polyhedron = Polyhedron::of_vertex_cycles(&cube.map(<[u32]>::to_vec));
    GluingScheme { polyhedra: vec![polyhedron; n], pairings }
}

//! Flat manifolds: the cubes of ℤ³ up to a group of isometries.

use super::super::scheme::{GluingScheme, Polyhedron};
use super::convex::by_corners;
use std::collections::BTreeSet;

/// An isometry of the cubes of ℤ³: coordinate i of the image is sign · x_axis + shift.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Isometry(pub(super) [(usize, i64, i64); 3]);

impl Isometry {
    /// First `self`, then `next`, shifts mod n.
    fn then(self, next: Isometry, n: i64) -> Isometry {
        Isometry(next.0.map(|(axis, sign, shift)| {
            let (inner, inner_sign, inner_shift) = self.0[axis];
            (inner, sign * inner_sign, (sign * inner_shift + shift).rem_euclid(n))
        }))
    }

    /// The cube, by its least corner, that this one goes to, mod n.
    fn cube(self, c: [i64; 3], n: i64) -> [i64; 3] {
        self.0.map(|(axis, sign, shift)| (if sign == 1 { c[axis] } else { -c[axis] - 1 } + shift).rem_euclid(n))
    }

    /// The corner of a cube that this corner of its image comes from, both as points of {0, 1}³.
    fn corner_before(self, corner: [i64; 3]) -> [i64; 3] {
        let mut before = [0; 3];
        for (i, (axis, sign, _)) in self.0.iter().enumerate() {
            before[*axis] = if *sign == 1 { corner[i] } else { 1 - corner[i] };
        }
        before
    }
}

const IDENTITY: Isometry = Isometry([(0, 1, 0), (1, 1, 0), (2, 1, 0)]);

/// The corners of the cube as [`Polyhedron::cube`] has them.
const CORNERS: [[i64; 3]; 8] = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];

/// The corners of each of its faces, and the step across it.
const FACES: [([u32; 4], [i64; 3]); 6] = [
    ([3, 2, 1, 0], [0, 0, -1]),
    ([4, 5, 6, 7], [0, 0, 1]),
    ([0, 1, 5, 4], [0, -1, 0]),
    ([1, 2, 6, 5], [1, 0, 0]),
    ([2, 3, 7, 6], [0, 1, 0]),
    ([3, 0, 4, 7], [-1, 0, 0]),
];

/// ℝ³ up to the group that these isometries and the translations nℤ³ generate: a cube for each orbit of cubes. No element of the group
/// but the identity may leave a cube where it is.
pub(super) fn quotient(n: i64, generators: &[Isometry]) -> GluingScheme {
    let mut group = BTreeSet::from([IDENTITY]);
    let mut pending = vec![IDENTITY];
    while let Some(element) = pending.pop() {
        let products = generators.iter().map(|generator| element.then(*generator, n));
        pending.extend(products.filter(|product| group.insert(*product)).collect::<Vec<_>>());
    }
    let place = |[x, y, z]: [i64; 3]| (x + n * y + n * n * z) as usize;
    // The orbit of each cube, and what takes the orbit's first cube there.
    let mut reached: Vec<Option<(usize, Isometry)>> = vec![None; (n * n * n) as usize];
    let mut first = Vec::new();
    for cube in 0..n * n * n {
        let cube = [cube % n, cube / n % n, cube / n / n];
        if reached[place(cube)].is_none() {
            group.iter().for_each(|g| reached[place(g.cube(cube, n))] = Some((first.len(), *g)));
            first.push(cube);
        }
    }
    assert_eq!(first.len() * group.len(), reached.len(), "an isometry leaves a cube where it is");
    let mut pairings = Vec::new();
    for (number, cube) in first.iter().enumerate() {
        for (face, (corners, step)) in FACES.iter().enumerate() {
            let next: [i64; 3] = std::array::from_fn(|i| (cube[i] + step[i]).rem_euclid(n));
            let (other, g) = reached[place(next)].expect("each cube is in an orbit");
            let images = corners.map(|v| {
                let corner = CORNERS[v as usize];
                let before = g.corner_before(std::array::from_fn(|i| corner[i] - step[i]));
                CORNERS.iter().position(|c| *c == before).expect("a corner goes to a corner") as u32
            });
            let there = FACES.iter().position(|(cycle, _)| images.iter().all(|v| cycle.contains(v))).expect("a face");
            if (number, face) < (other, there) {
                pairings.push(by_corners([number, face], [other, there], &FACES[there].0, &images));
            }
        }
    }
    GluingScheme { polyhedra: vec![Polyhedron::cube(); first.len()], pairings }
}

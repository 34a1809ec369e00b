//! The 3-torus as a grid of cubes, each cut into six tetrahedra: triangulations as large as one likes.

use super::permutation::Perm4;
use super::triangulation::{TriangleGluing, Triangulation};

/// The orders of the three axes.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// The 3-torus of a × b × c cubes, a, b, c ≥ 1, opposite sides identified, each cut into the 6 tetrahedra around its diagonal
/// (Kuhn): 6abc tetrahedra. Corner 0 of a tetrahedron is the least corner of its cube, corner k goes one step along the k-th of
/// the axes in its order.
pub fn kuhn_torus([a, b, c]: [usize; 3]) -> Triangulation {
    let sizes = [a, b, c];
    let number = |[x, y, z]: [usize; 3], order: [usize; 3]| {
        let order = ORDERS.iter().position(|o| *o == order).expect("an order");
        u32::try_from(6 * ((z * b + y) * a + x) + order).expect("fewer than 2³² tetrahedra")
    };
    let gluings = |cube: [usize; 3], [i, j, k]: [usize; 3]| {
        let moved = |axis: usize, steps: usize| {
            let mut cube = cube;
            cube[axis] = (cube[axis] + steps) % sizes[axis];
            cube
        };
        let glued =
            |tetrahedron, images| TriangleGluing { tetrahedron, corners: Perm4::new(images).expect("a permutation") };
        // Opposite corners 1 and 2 two axes change places; opposite 0 and 3 lie the next cubes along the first and the last one.
        [
            glued(number(moved(i, 1), [j, k, i]), [3, 0, 1, 2]),
            glued(number(cube, [j, i, k]), [0, 1, 2, 3]),
            glued(number(cube, [i, k, j]), [0, 1, 2, 3]),
            glued(number(moved(k, sizes[k] - 1), [k, i, j]), [1, 2, 3, 0]),
        ]
    };
    let cubes = (0..c).flat_map(|z| (0..b).flat_map(move |y| (0..a).map(move |x| [x, y, z])));
    let all = cubes.flat_map(|cube| ORDERS.map(|order| gluings(cube, order)));
    Triangulation::new(all.collect()).expect("each gluing undoes the other")
}

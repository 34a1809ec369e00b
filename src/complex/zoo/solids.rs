//! The solids whose faces the zoo glues, and regular polytopes of four dimensions, by integer points.

use super::convex::{Solid, boundary};
use crate::complex::scheme::GluingScheme;

/// All points with these coordinates, in every order and with every sign.
fn signed_orders<const N: usize>(coordinates: [i64; N]) -> Vec<[i64; N]> {
    let mut points = Vec::new();
    for choice in 0..N.pow(N as u32) {
        let order: [usize; N] = std::array::from_fn(|i| choice / N.pow(i as u32) % N);
        if !(0..N).all(|i| order.contains(&i)) {
            continue;
        }
        for signs in 0..1 << N {
            points.push(std::array::from_fn(|i| coordinates[order[i]] * if signs >> i & 1 == 1 { -1 } else { 1 }));
        }
    }
    points.sort_unstable();
    points.dedup();
    points
}

pub(super) fn cube() -> Solid {
    Solid::new(signed_orders([1, 1, 1]))
}

pub(super) fn octahedron() -> Solid {
    Solid::new(signed_orders([1, 0, 0]))
}

pub(super) fn truncated_cube() -> Solid {
    Solid::new(signed_orders([1, 2, 2]))
}

pub(super) fn truncated_octahedron() -> Solid {
    Solid::new(signed_orders([0, 1, 2]))
}

pub(super) fn rhombic_dodecahedron() -> Solid {
    Solid::new([signed_orders([1, 1, 1]), signed_orders([2, 0, 0])].concat())
}

/// A dodecahedron of pentagons that are not regular, but plane: that of pyrite.
pub(super) fn dodecahedron() -> Solid {
    let mut points = signed_orders([4, 4, 4]);
    for [x, y] in signed_orders([1, 1]).into_iter().filter(|[x, y]| x.abs() == 1 && y.abs() == 1) {
        points.extend([[0, 6 * x, 3 * y], [6 * x, 3 * y, 0], [3 * y, 0, 6 * x]]);
    }
    Solid::new(points)
}

/// The prism over a polygon, which is symmetric about the origin.
fn prism(polygon: &[[i64; 2]]) -> Solid {
    Solid::new(polygon.iter().flat_map(|[x, y]| [[*x, *y, 1], [*x, *y, -1]]).collect())
}

pub(super) fn hexagonal_prism() -> Solid {
    prism(&[[2, 0], [1, 1], [-1, 1], [-2, 0], [-1, -1], [1, -1]])
}

pub(super) fn octagonal_prism() -> Solid {
    prism(&signed_orders([1, 2]))
}

pub(super) fn decagonal_prism() -> Solid {
    let half = [[3, 1], [2, 3], [0, 4], [-2, 3], [-3, 1]];
    prism(&[half, half.map(|[x, y]| [-x, -y])].concat())
}

/// Five tetrahedra.
pub(super) fn simplex_4() -> GluingScheme {
    boundary(&[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [-1, -1, -1, -1]])
}

/// Sixteen tetrahedra.
pub(super) fn cross_polytope() -> GluingScheme {
    boundary(&signed_orders([1, 0, 0, 0]))
}

/// Eight cubes.
pub(super) fn tesseract() -> GluingScheme {
    boundary(&signed_orders([1, 1, 1, 1]))
}

/// Twenty-four octahedra.
pub(super) fn cell_24() -> GluingScheme {
    boundary(&signed_orders([1, 1, 0, 0]))
}

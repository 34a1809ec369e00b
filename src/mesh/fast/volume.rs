//! The exact volume that a closed mesh encloses.

use super::Point;
use super::exact::Dyadic;
use super::polygons::Polygons;
use super::sum::DyadicSum;
use crate::number::Rational;

/// Σ |p₀ pᵢ pᵢ₊₁| / 6 over the triangles of the fan of each face from its first vertex: the signed volume that a closed,
/// consistently wound mesh encloses, positive where its faces run counterclockwise from outside. Exact. ME-148.
pub fn volume(mesh: &Polygons) -> Rational {
    let mut sum = DyadicSum::default();
    for face in mesh.loops() {
        let [first, rest @ ..] = face else { continue };
        let a = dyadic(&mesh.vertices()[*first as usize]);
        for pair in rest.windows(2) {
            add_determinant(
                &mut sum,
                [a, dyadic(&mesh.vertices()[pair[0] as usize]), dyadic(&mesh.vertices()[pair[1] as usize])],
            );
        }
    }
    sum.total() / 6
}

fn dyadic(point: &Point) -> [Dyadic; 3] {
    point.map(Dyadic::of)
}

fn add_determinant(sum: &mut DyadicSum, [a, b, c]: [[Dyadic; 3]; 3]) {
    for [i, j, k] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        sum.add_product([a[i], b[j], c[k]], false);
        sum.add_product([a[i], b[k], c[j]], true);
    }
}

//! What is wrong with the shape of one face.

use super::Point;
use super::exact::{collinear, cross_properly, side_of_plane};
use super::polygons::exact;
use crate::linear::Vector;
use crate::number::{OrderedField, Rational, Sign};

/// The shape of a loop of three and more vertices, in the terms of the defects of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// All vertices lie on one line.
    Collinear,
    /// Not all lie in one plane.
    Nonplanar,
    /// They lie in one plane, and not on a line.
    Planar {
        /// The signed areas of the projections are all zero.
        zero_signed_area: bool,
        /// Two sides that are not adjacent cross in a point inside both.
        self_crossing: bool,
    },
}

/// The shape of a loop; `None` where it has fewer than three vertices.
pub fn shape(points: &[Point]) -> Option<Shape> {
    if let [a, b, c] = points {
        let planar = Shape::Planar { zero_signed_area: false, self_crossing: false };
        return Some(if collinear(a, b, c) { Shape::Collinear } else { planar });
    }
    let [a, .., _, _] = points else { return None };
    let Some((b, c)) = frame(points) else { return Some(Shape::Collinear) };
    if points.iter().any(|d| side_of_plane(a, b, c, d) != Sign::Zero) {
        return Some(Shape::Nonplanar);
    }
    // Seen along an axis that the plane does not contain, nothing is lost.
    let axis = (0..3).find(|&axis| super::exact::orientation(axis, a, b, c) != Sign::Zero);
    let axis = axis.expect("three points that are not collinear have a normal");
    Some(Shape::Planar {
        zero_signed_area: signed_area_is_zero(points, axis),
        self_crossing: crosses_itself(points, axis),
    })
}

/// Two vertices that are not on one line with the first.
fn frame(points: &[Point]) -> Option<(&Point, &Point)> {
    let b = points.iter().find(|p| **p != points[0])?;
    Some((b, points.iter().find(|c| !collinear(&points[0], b, c))?))
}

/// Whether Σ vᵢ × vᵢ₊₁ has the coordinate 0 along an axis; for a planar loop that the axis is not parallel to, whether all of it is 0.
fn signed_area_is_zero(points: &[Point], axis: usize) -> bool {
    if let [a, b, c, d] = points {
        // 2·area = (c − a) × (d − b): the two diagonals. Parallel to another axis than the plane, so one coordinate decides.
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let (p, q) = ((c[j] - a[j]) * (d[k] - b[k]), (c[k] - a[k]) * (d[j] - b[j]));
        if (p - q).abs() > 2_f64.powi(-51) * (p.abs() + q.abs()) + f64::MIN_POSITIVE {
            return false;
        }
    }
    doubled_vector_area(points).0[axis].sign() == Sign::Zero
}

/// Σ vᵢ × vᵢ₊₁, twice the vector area of a loop.
pub fn doubled_vector_area(points: &[Point]) -> Vector<Rational, 3> {
    let points: Vec<_> = points.iter().map(exact).collect();
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).fold(Vector::zero(), |sum, (a, b)| {
        let product = a.cross(b);
        Vector(std::array::from_fn(|i| Rational::from(&sum.0[i] + &product.0[i])))
    })
}

/// Whether two sides that are not adjacent cross properly, as seen along an axis.
///
/// Sides are swept in the order of their least coordinate; only pairs whose boxes overlap are tried.
fn crosses_itself(points: &[Point], axis: usize) -> bool {
    let n = points.len();
    let side = |i: usize| [&points[i], &points[(i + 1) % n]];
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let low = |i: usize, t: usize| side(i)[0][t].min(side(i)[1][t]);
    let high = |i: usize, t: usize| side(i)[0][t].max(side(i)[1][t]);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_unstable_by(|&s, &t| low(s, j).total_cmp(&low(t, j)));
    let mut open: Vec<usize> = Vec::new();
    for &s in &order {
        open.retain(|&t| high(t, j) >= low(s, j));
        for &t in &open {
            let adjacent = (s + 1) % n == t || (t + 1) % n == s;
            let apart = high(t, k) < low(s, k) || high(s, k) < low(t, k);
            if !adjacent && !apart && cross_properly(axis, side(s), side(t)) {
                return true;
            }
        }
        open.push(s);
    }
    false
}

//! Whether a plane polygon crosses itself.

use crate::mesh::vertex_list::Point;
use crate::number::{Rational, Sign};

/// A point of the plane, by the two coordinates that are kept.
type Flat<'a> = [&'a Rational; 2];

/// Whether two sides of a polygon in a plane with that normal cross in one point inside both.
///
/// Sides with a common end never do, so that adjacent ones need not be left out.
pub fn crosses_itself(polygon: &[&Point], normal: &Point) -> bool {
    // A projection along an axis that the plane does not contain is one-to-one on it.
    let Some(along) = (0..3).find(|&k| !normal[k].is_zero()) else { return false };
    let [u, v] = [(along + 1) % 3, (along + 2) % 3];
    let flat = |i: usize| -> Flat { [&polygon[i % polygon.len()][u], &polygon[i % polygon.len()][v]] };
    let mut sides: Vec<[Flat; 2]> = (0..polygon.len()).map(|i| [flat(i), flat(i + 1)]).collect();
    let low = |[a, b]: &[Flat; 2], axis: usize| -> Rational { a[axis].min(b[axis]).clone() };
    let high = |[a, b]: &[Flat; 2], axis: usize| -> Rational { a[axis].max(b[axis]).clone() };
    sides.sort_by_cached_key(|side| low(side, 0));
    for (i, side) in sides.iter().enumerate() {
        let (right, bottom, top) = (high(side, 0), low(side, 1), high(side, 1));
        for other in sides[i + 1..].iter().take_while(|other| low(other, 0) < right) {
            if low(other, 1) < top && high(other, 1) > bottom && cross(side, other) {
                return true;
            }
        }
    }
    false
}

/// Whether two segments cross in one point inside both: the ends of each lie strictly on different sides of the other.
fn cross([a, b]: &[Flat; 2], [c, d]: &[Flat; 2]) -> bool {
    let separates = |p, q, r, s| orientation(p, q, r) * orientation(p, q, s) == Sign::Negative;
    separates(a, b, c, d) && separates(c, d, a, b)
}

/// The sense of a triangle: positive where it runs counterclockwise.
fn orientation([px, py]: &Flat, [qx, qy]: &Flat, [rx, ry]: &Flat) -> Sign {
    let d = |a: &Rational, b: &Rational| Rational::from(a - b);
    Sign::of((d(qx, px) * d(ry, py)).cmp(&(d(qy, py) * d(rx, px))))
}

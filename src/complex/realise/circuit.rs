//! Whether two simplices with vertices in ℝⁿ meet outside their common face: an affine dependence with its positive part in
//! the one and its negative part in the other.

use super::orientation::{determinant, orientation};
use crate::number::{Rational, Sign};

/// Which of two simplices a point is a vertex of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The first one only.
    First,
    /// The second one only.
    Second,
    /// Both.
    Both,
}

/// Points by their indices, without repetition: the hull of `first` meets that of `second` in one point, inside both.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Circuit {
    /// Points of the first simplex.
    pub first: Vec<usize>,
    /// Points of the second simplex, none of the former.
    pub second: Vec<usize>,
}

/// Disjoint faces, one of each simplex, whose hulls meet; `None` iff there are none.
///
/// There are such faces iff Σλ_p p = 0, Σλ_p = 0 has a solution λ ≠ 0 that is ≥ 0 at points of the first simplex only and ≤ 0 at
/// points of the second only. Each solution is a sum of solutions of least support with signs that agree with it, and
/// these are seen from the orientations of r + 1 points: r + 2 of them have λ_i = (−1)^i χ(all but i), r the dimension they span.
#[doc(alias = "CX-85")]
pub fn circuit(points: &[&[f64]], sides: &[Side]) -> Option<Circuit> {
    let coordinates = spanning(points);
    let r = coordinates.len();
    // Affinely independent points have no dependence.
    if points.len() < r + 2 {
        return None;
    }
    let of_side = |side: Side| sides.iter().enumerate().map(|(i, s)| usize::from(*s != side) << i).sum::<usize>();
    let (in_first, in_second) = (of_side(Side::Second), of_side(Side::First));
    let mut known: Vec<Option<Sign>> = vec![None; 1 << points.len()];
    for set in sets(points.len(), r + 2) {
        let mut parts = [0_usize; 2];
        for (position, i) in members(set).enumerate() {
            let others = set & !(1 << i);
            let chi = *known[others].get_or_insert_with(|| chi(points, others, &coordinates));
            match if position.is_multiple_of(2) { chi } else { -chi } {
                Sign::Zero => {}
                Sign::Positive => parts[0] |= 1 << i,
                Sign::Negative => parts[1] |= 1 << i,
            }
        }
        let [positive, negative] = parts;
        for [first, second] in [[positive, negative], [negative, positive]] {
            if first != 0 && first & !in_first == 0 && second & !in_second == 0 {
                return Some(Circuit { first: members(first).collect(), second: members(second).collect() });
            }
        }
    }
    None
}

/// The orientation of a set of the points.
fn chi(points: &[&[f64]], set: usize, coordinates: &[usize]) -> Sign {
    let mut chosen = [points[0]; usize::BITS as usize];
    members(set).zip(&mut chosen).for_each(|(i, place)| *place = points[i]);
    orientation(&chosen, coordinates)
}

/// Whether the points are affinely independent.
pub fn independent(points: &[&[f64]]) -> bool {
    spanning(points).len() + 1 == points.len()
}

/// The point in which the hulls of the circuit's two sides meet, exactly: Σ λ_p p over the first, with Σ λ_p = 1.
pub fn common_point(first: &[&[f64]], second: &[&[f64]]) -> Vec<Rational> {
    let points = [first, second].concat();
    let coordinates = spanning(&points);
    let weight = |i: usize| {
        let others: Vec<&[f64]> = points.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, p)| *p).collect();
        let size = determinant(&others, &coordinates);
        if i.is_multiple_of(2) { size } else { -size }
    };
    let weights: Vec<Rational> = (0..first.len()).map(weight).collect();
    let total = weights.iter().fold(Rational::new(), |sum, w| sum + w);
    let coordinate = |axis: usize| {
        let terms = weights.iter().zip(first).map(|(w, p)| Rational::from_f64(p[axis]).expect("finite") * w);
        terms.fold(Rational::new(), |sum, term| sum + term) / &total
    };
    (0..first[0].len()).map(coordinate).collect()
}

/// Coordinates, as many as the dimension that the points span, in which some of the points span as much.
fn spanning(points: &[&[f64]]) -> Vec<usize> {
    let n = points[0].len();
    for r in (1..=n.min(points.len() - 1)).rev() {
        for axes in sets(n, r) {
            let axes: Vec<usize> = members(axes).collect();
            if sets(points.len(), r + 1).any(|set| chi(points, set, &axes) != Sign::Zero) {
                return axes;
            }
        }
    }
    Vec::new()
}

/// The sets of `size` among 0 … n−1, as bits, in the order of these numbers.
fn sets(n: usize, size: usize) -> impl Iterator<Item = usize> {
    (0_usize..1 << n).filter(move |set| set.count_ones() as usize == size)
}

fn members(mut set: usize) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let i = set.trailing_zeros() as usize;
        // A set without members has all its zeros trailing.
        (set != 0).then(|| {
            set &= set - 1;
            i
        })
    })
}

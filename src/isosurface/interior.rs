//! Which diagonal pair of a cell's corners is joined through its inside (IS-78).
//!
//! Cut the cell by the planes z = w. Each cut is a bilinear square whose corners A, B, C, D (at (0,0),
//! (1,0), (1,1), (0,1)) are linear in w, and whose determinant Q(w) = AC − BD is quadratic. A and C are
//! joined in the cut at w iff they have one sign and Q(w) > 0. At the ends of the stretch where they
//! have one sign, Q > 0 already joins them on the boundary of the cell; what the boundary does not see
//! is a greatest value Q(w*) > 0 inside the stretch. For B and D the same holds with −Q.

use super::cell::Obstacle;
use super::cube::Corner;
use crate::number::{Enclosure, Sign};

/// Two corners of one sign, diagonal in x and y, that some cut z = w joins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Join {
    /// The two corners, the smaller first.
    pub corners: [Corner; 2],
}

/// The cut whose determinant is extreme: w* = n/d with d > 0, 0 < n < d.
struct Extreme<K> {
    n: K,
    d: K,
    /// The sign of Q(w*) against the pair that could be joined: positive joins, zero is a critical point.
    excess: Sign,
    /// The pair that could be joined, and the other one, as vertical lines.
    pair: [usize; 2],
    rivals: [usize; 2],
}

/// A vertical line of the cell by its position x + 2y; its values at z = 0 and z = 1.
fn line<K>(values: &[K; 8], xy: usize) -> [&K; 2] {
    [&values[xy], &values[xy + 4]]
}

fn product_sum<K: Enclosure>(a: &K, b: &K, c: &K, d: &K) -> K {
    a.clone() * b + &(c.clone() * d)
}

fn sign<K: Enclosure>(value: &K) -> Result<Sign, Obstacle> {
    value.known_sign().ok_or(Obstacle::Undecided)
}

/// Q(w) = q0 + q1 w + q2 w², the determinant of the cut at w (IS-74).
#[doc(alias = "IS-74")]
fn determinant<K: Enclosure>(values: &[K; 8]) -> [K; 3] {
    let [[a0, a1], [b0, b1], [d0, d1], [c0, c1]] = [0, 1, 2, 3].map(|xy| line(values, xy));
    let [a, b, c, d] = [(a0, a1), (b0, b1), (c0, c1), (d0, d1)].map(|(low, high)| high.clone() - low);
    [
        a0.clone() * c0 - &(b0.clone() * d0),
        product_sum(a0, &c, &a, c0) - &product_sum(b0, &d, &b, d0),
        a * &c - &(b * &d),
    ]
}

fn extreme<K: Enclosure>(values: &[K; 8]) -> Result<Option<Extreme<K>>, Obstacle> {
    let [q0, q1, q2] = determinant(values);
    let (pair, rivals) = match sign(&q2)? {
        Sign::Zero => return Ok(None),
        Sign::Negative => ([0, 3], [1, 2]),
        Sign::Positive => ([1, 2], [0, 3]),
    };
    // Q′(w*) = 0 at w* = −q1 / 2q2, and Q(w*) = (4 q0 q2 − q1²) / 4 q2.
    let twice = q2.clone() + &q2;
    let (n, d) = if pair == [0, 3] { (q1.clone(), -twice) } else { (-q1.clone(), twice) };
    if sign(&n)? != Sign::Positive || sign(&(d.clone() - &n))? != Sign::Positive {
        return Ok(None);
    }
    let discriminant = q1.clone() * &q1 - &(K::integer(4) * &q0 * &q2);
    Ok(match sign(&discriminant)? {
        Sign::Negative => None,
        excess => Some(Extreme { n, d, excess, pair, rivals }),
    })
}

impl<K: Enclosure> Extreme<K> {
    /// The sign of a vertical line at w*: that of low·(d − n) + high·n.
    fn sign_of(&self, values: &[K; 8], xy: usize) -> Result<Sign, Obstacle> {
        let [low, high] = line(values, xy);
        sign(&product_sum(low, &(self.d.clone() - &self.n), high, &self.n))
    }
}

/// The one pair of corners that a cut inside the cell may join though neither its lowest nor its
/// highest cut does; it may be joined on the boundary of the cell all the same (IS-78).
#[doc(alias = "IS-78")]
pub(super) fn join<K: Enclosure>(values: &[K; 8]) -> Result<Option<Join>, Obstacle> {
    let Some(extreme) = extreme(values)? else { return Ok(None) };
    let [p, q] = extreme.pair;
    let side = extreme.sign_of(values, p)?;
    if side == Sign::Zero || side != extreme.sign_of(values, q)? {
        return Ok(None);
    }
    if extreme.excess == Sign::Zero {
        // AC = BD > 0: two crossing lines if B and D have the other sign, else no zero at all.
        return match extreme.sign_of(values, extreme.rivals[0])? {
            rival if rival == side => Ok(None),
            _ => Err(Obstacle::Interior),
        };
    }
    let corner = |xy: usize| -> Result<Corner, Obstacle> {
        let [low, _] = line(values, xy);
        Ok(Corner::ALL[if sign(low)? == side { xy } else { xy + 4 }])
    };
    let mut corners = [corner(p)?, corner(q)?];
    corners.sort();
    Ok(Some(Join { corners }))
}

/// The cut in which the critical point lies, as w* = n/d; only asked where [`join`] found one.
pub(super) fn critical_cut<K: Enclosure>(values: &[K; 8]) -> Option<[K; 2]> {
    extreme(values).ok().flatten().map(|extreme| [extreme.n, extreme.d])
}

#[cfg(test)]
mod is_74 {
    use super::*;
    use crate::isosurface::multilinear::trilinear;
    use crate::number::{Rational, Ring};

    #[test]
    fn its_coefficients_are_those_of_the_determinant_of_the_cut() {
        for seed in 0..500i64 {
            let g: [Rational; 8] =
                std::array::from_fn(|i| Rational::from((seed + 3) * (2 * i as i64 + 7) * 31 % 19 - 9));
            let [q0, q1, q2] = determinant(&g);
            for w in [0, 1, 2, -3].map(Rational::from) {
                let at = |x: i64, y: i64| trilinear(&g, &[Rational::integer(x), Rational::integer(y), w.clone()]);
                let value = at(0, 0) * at(1, 1) - at(1, 0) * at(0, 1);
                assert_eq!((q2.clone() * &w + &q1) * &w + &q0, value);
            }
        }
    }
}

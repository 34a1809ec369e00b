//! The topology of a cell by subdivision: a second way to what `cell` decides, which knows nothing of cuts,
//! classes or tunnels (IS-96).
//!
//! A box is cut in two by a plane until f has one sign in it, or one partial derivative has. Both are told by the
//! box's corners: f lies between its least and greatest corner value, and a partial derivative, which is bilinear,
//! between the least and the greatest difference along the box's four edges of that axis. A box of the second kind
//! retracts along the axis to the face where f is least (for {f ≤ 0}; greatest for {f ≥ 0}), and there f is bilinear:
//! what remains is counted by corner signs and one determinant. So it is on the face between two boxes, along which
//! what is known of them is put together: χ of the whole is the sum less χ of what they share.

use super::cell::{Degenerate, Side};
use super::critical::{BilinearCritical, TrilinearCritical, bilinear_critical, trilinear_critical};
use super::cube::{Corner, Edge, Face};
use crate::number::{Enclosure, OrderedField, Rational, Sign, Surd};
use crate::partition::Partition;
use std::collections::BTreeSet;
use thiserror::Error;

/// Why zero is a critical value of the cell, by the critical points themselves: the first corner at 0; else the first face
/// with its saddle inside it at 0; else a critical point inside the cell at 0. There is none else: on a curve of
/// critical points f is constant, and the curve leaves the cell through a face or an edge.
pub fn degenerate(values: &[Rational; 8]) -> Option<Degenerate> {
    let corner = Corner::ALL.into_iter().find(|c| values[c.index()].is_zero()).map(Degenerate::Corner);
    corner.or_else(|| Face::ALL.into_iter().find_map(|face| degenerate_face(values, face))).or_else(|| {
        let inside = |x: &Rational| *x > 0 && *x < 1;
        let point = match trilinear_critical(values) {
            TrilinearCritical::Point(point) => (point.value.is_zero()).then_some(point.position),
            TrilinearCritical::Pair(points) => points.into_iter().find_map(|point| {
                let (zero, one) = (Surd::from(Rational::new()), Surd::from(Rational::from(1)));
                let is_inside = point.position.iter().all(|x| *x > zero && *x < one);
                (is_inside && point.value.sign() == Sign::Zero).then(|| {
                    point
                        .position
                        .map(|x| x.rational().expect("a double root of a cut's determinant is rational").clone())
                })
            }),
            TrilinearCritical::None
            | TrilinearCritical::Line { .. }
            | TrilinearCritical::ThreeLines(_)
            | TrilinearCritical::Hyperbola { .. }
            | TrilinearCritical::Everywhere => None,
        };
        point.filter(|point| point.iter().all(inside)).map(|point| Degenerate::Interior { point: Box::new(point) })
    })
}

fn degenerate_face(values: &[Rational; 8], face: Face) -> Option<Degenerate> {
    let [u, v] = [(face.axis() + 1) % 3, (face.axis() + 2) % 3];
    let origin = Corner::ALL.into_iter().find(|c| {
        let at = c.position();
        at[face.axis()] == face.side() && at[u] == 0 && at[v] == 0
    })?;
    let corners = [origin, origin.across(u), origin.across(v), origin.across(u).across(v)];
    match bilinear_critical(&corners.map(|c| values[c.index()].clone())) {
        BilinearCritical::None | BilinearCritical::Everywhere => None,
        BilinearCritical::Saddle(saddle) => {
            let is_inside = [&saddle.u, &saddle.v].iter().all(|x| **x > 0 && **x < 1);
            (is_inside && saddle.value.is_zero()).then(|| {
                let mut point = [Rational::new(), Rational::new(), Rational::new()];
                (point[face.axis()], point[u], point[v]) = (Rational::from(face.side()), saddle.u, saddle.v);
                Degenerate::Face { face, point: Box::new(point) }
            })
        }
    }
}

/// What a subdivision shows of {f = 0} in a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subdivision {
    /// {f ≤ 0}.
    pub negative: Side,
    /// {f ≥ 0}.
    pub positive: Side,
    /// The components of {f = 0}: which part of {f ≤ 0} meets which of {f ≥ 0}, by their numbers; sorted.
    pub components: Vec<[usize; 2]>,
    /// χ of {f = 0}.
    pub chi: i64,
    /// How many boxes it took.
    pub boxes: usize,
}

/// The boxes do not show the topology: the cell is degenerate, or nearly so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("boxes made by {cuts} cuts do not show the topology")]
pub struct TooCoarse {
    /// How many times a box was cut.
    pub cuts: u32,
}

const SIDES: [Sign; 2] = [Sign::Negative, Sign::Positive];

/// What is known of {f ≤ 0} and {f ≥ 0} in a box.
struct Known {
    /// Which corners are connected in their sign. Every part has a corner (IS-75).
    parts: Partition,
    /// χ of both.
    chi: [i64; 2],
    /// Which parts meet, each by a corner: a negative and a positive one.
    meetings: Vec<[usize; 2]>,
    boxes: usize,
}

/// The topology of {f = 0} for a cell that is not [`degenerate`]; no box is cut more than `cuts` times. Numbers grow by
/// one bit a cut, by a few where a plane in the middle would be degenerate.
///
/// Errors: iff the cuts do not suffice.
#[doc(alias = "IS-96")]
pub fn topology<K: Enclosure>(values: &[K; 8], cuts: u32) -> Result<Subdivision, TooCoarse> {
    let mut known = look(values, 0, cuts)?;
    let mut sides = SIDES.map(|_| Side { parts: Vec::new(), b1: 0 });
    let mut number = [usize::MAX; 8];
    for c in Corner::ALL {
        let side = &mut sides[usize::from(sign(&values[c.index()]) == Sign::Positive)];
        let root = known.parts.find(c.index());
        if root == c.index() {
            number[root] = side.parts.len();
            side.parts.push(Vec::new());
        }
        side.parts[number[root]].push(c);
    }
    for (side, chi) in sides.iter_mut().zip(known.chi) {
        // No voids: they would be components of the other side without a corner.
        side.b1 = side.parts.len() as i64 - chi;
    }
    // Two parts meet in one component: with a second, a closed curve through both could not be shrunk to a point.
    let components: BTreeSet<[usize; 2]> =
        known.meetings.iter().map(|pair| pair.map(|c| number[known.parts.find(c)])).collect();
    let [negative, positive] = sides;
    Ok(Subdivision {
        negative,
        positive,
        components: components.into_iter().collect(),
        // The two sides cover the cell, χ = 1, and meet in {f = 0}.
        chi: known.chi[0] + known.chi[1] - 1,
        boxes: known.boxes,
    })
}

/// What the corners of a box show, or its halves do.
fn look<K: Enclosure>(values: &[K; 8], done: u32, cuts: u32) -> Result<Known, TooCoarse> {
    if values.iter().all(|v| sign(v) == sign(&values[0])) {
        return Ok(uniform(sign(&values[0])));
    }
    if let Some(known) = (0..3).find_map(|axis| monotone(values, axis)) {
        return Ok(known);
    }
    if done == cuts {
        return Err(TooCoarse { cuts });
    }
    let axis = done as usize % 3;
    let [low, high] = halves(values, axis).ok_or(TooCoarse { cuts: done })?;
    let known = [look(&low, done + 1, cuts)?, look(&high, done + 1, cuts)?];
    Ok(together(known, axis, &face_corners(axis, 1).map(|c| low[c.index()].clone())))
}

/// The box cut by a plane near its middle on which f is general: not 0 at an edge of the box, nor at a saddle. The values
/// of both halves are multiplied by one positive integer.
fn halves<K: Enclosure>(values: &[K; 8], axis: usize) -> Option<[[K; 8]; 2]> {
    let shares = [[1, 1], [3, 4], [4, 3], [2, 3], [3, 2], [1, 2], [2, 1], [4, 5], [5, 4], [1, 3], [3, 1]];
    shares.into_iter().find_map(|[p, q]: [i64; 2]| {
        let [near, far, all] = [K::integer(p), K::integer(q), K::integer(p + q)];
        // At the share p/(p + q) of the way from the low face to the high one.
        let plane = face_corners(axis, 0)
            .map(|c| values[c.index()].clone() * &far + &(values[c.across(axis).index()].clone() * &near));
        let is_general =
            plane.iter().all(|v| sign(v) != Sign::Zero) && !(alternates(&plane) && determinant(&plane) == Sign::Zero);
        is_general.then(|| {
            [1, 0].map(|side| {
                let mut half = values.each_ref().map(|v| v.clone() * &all);
                for (c, value) in face_corners(axis, side).into_iter().zip(&plane) {
                    half[c.index()] = value.clone();
                }
                half
            })
        })
    })
}

/// Two halves, which share a face with these values: high of the first, low of the second.
fn together<K: Enclosure>([low, high]: [Known; 2], axis: usize, face: &[K; 4]) -> Known {
    // Corners of the low half, then those of the high one.
    let mut parts = Partition::new(16);
    for (mut half, offset) in [(low.parts, 0), (high.parts, 8)] {
        (0..8).for_each(|c| {
            parts.join(offset + c, offset + half.find(c));
        });
    }
    for c in face_corners(axis, 1) {
        parts.join(c.index(), 8 + c.across(axis).index());
    }
    let chi = [0, 1].map(|side| low.chi[side] + high.chi[side] - pieces(face, SIDES[side]));
    // The corners of the whole, and a corner of the whole for each part.
    let own = Corner::ALL.map(|c| c.index() + 8 * usize::from(c.position()[axis]));
    let mut whole = Partition::new(8);
    let mut of_part = [usize::MAX; 16];
    for (c, &corner) in own.iter().enumerate() {
        let root = parts.find(corner);
        if of_part[root] == usize::MAX {
            of_part[root] = c;
        }
        whole.join(of_part[root], c);
    }
    let meetings = low.meetings.iter().copied().chain(high.meetings.iter().map(|pair| pair.map(|c| 8 + c)));
    let mut meetings: Vec<_> = meetings
        .map(|pair| {
            pair.map(|c| {
                let corner = of_part[parts.find(c)];
                assert!(corner < 8, "every part of a box has a corner (IS-75)");
                corner
            })
        })
        .collect();
    meetings.sort();
    meetings.dedup();
    Known { parts: whole, chi, meetings, boxes: low.boxes + high.boxes }
}

fn uniform(sign: Sign) -> Known {
    let mut parts = Partition::new(8);
    (1..8).for_each(|c| {
        parts.join(0, c);
    });
    Known { parts, chi: SIDES.map(|side| i64::from(side == sign)), meetings: Vec::new(), boxes: 1 }
}

/// A box with both signs in which the derivative along an axis has one sign.
fn monotone<K: Enclosure>(values: &[K; 8], axis: usize) -> Option<Known> {
    let slopes = face_corners(axis, 0).map(|c| sign(&(values[c.across(axis).index()].clone() - &values[c.index()])));
    if slopes[0] == Sign::Zero || slopes.iter().any(|slope| *slope != slopes[0]) {
        return None;
    }
    let mut parts = Partition::new(8);
    let mut chi = [0, 0];
    for (of, chi) in SIDES.into_iter().zip(&mut chi) {
        // The face to which this side retracts, along the edges of the axis.
        let end = u8::from(of == slopes[0]);
        let corners = face_corners(axis, end);
        let face = corners.map(|c| values[c.index()].clone());
        for [a, b] in joined(&face).into_iter().filter(|[a, _]| sign(&face[*a]) == of) {
            parts.join(corners[a].index(), corners[b].index());
        }
        for c in corners.into_iter().filter(|c| sign(&values[c.across(axis).index()]) == of) {
            parts.join(c.index(), c.across(axis).index());
        }
        *chi = pieces(&face, of);
    }
    // Parts of opposite sign meet in a box iff they do on an edge of it: {f = 0} is a graph over a part of a face, and
    // each of its components reaches an edge.
    let crossed = Edge::ALL.into_iter().map(|e| e.corners().map(Corner::index)).filter_map(|[a, b]| {
        match (sign(&values[a]), sign(&values[b])) {
            (Sign::Negative, Sign::Positive) => Some([a, b]),
            (Sign::Positive, Sign::Negative) => Some([b, a]),
            (Sign::Negative | Sign::Zero | Sign::Positive, _) => None,
        }
    });
    Some(Known { parts, chi, meetings: crossed.collect(), boxes: 1 })
}

fn sign<K: Enclosure>(value: &K) -> Sign {
    value.known_sign().expect("exact numbers have a sign")
}

/// The corners of a box's face, (0,0), (1,0), (0,1), (1,1) in the two other axes.
fn face_corners(axis: usize, side: u8) -> [Corner; 4] {
    let low = if side == 0 { Corner::ALL[0] } else { Corner::ALL[0].across(axis) };
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    [low, low.across(u), low.across(v), low.across(u).across(v)]
}

/// Whether the signs alternate around a rectangle with values g00, g10, g01, g11 at its corners, none of them 0.
fn alternates<K: Enclosure>(g: &[K; 4]) -> bool {
    let [a, b, c, d] = g.each_ref().map(sign);
    a == d && b == c && a != b
}

/// The sign of g00·g11 − g10·g01.
fn determinant<K: Enclosure>([a, b, c, d]: &[K; 4]) -> Sign {
    sign(&(a.clone() * d - &(b.clone() * c)))
}

/// The diagonal that an ambiguous rectangle joins.
fn diagonal<K: Enclosure>(g: &[K; 4]) -> [usize; 2] {
    if determinant(g) == Sign::Positive { [0, 3] } else { [1, 2] }
}

/// Of four corners of a rectangle the pairs that {f < 0} or {f > 0} connects.
fn joined<K: Enclosure>(g: &[K; 4]) -> Vec<[usize; 2]> {
    let edges = [[0, 1], [0, 2], [1, 3], [2, 3]].into_iter().filter(|[a, b]| sign(&g[*a]) == sign(&g[*b]));
    edges.chain(alternates(g).then(|| diagonal(g))).collect()
}

/// How many components {f < 0} (or {f > 0}) has in a rectangle; each is contractible.
fn pieces<K: Enclosure>(g: &[K; 4], of: Sign) -> i64 {
    match g.iter().filter(|v| sign(*v) == of).count() {
        0 => 0,
        2 if alternates(g) && sign(&g[diagonal(g)[0]]) != of => 2,
        _ => 1,
    }
}

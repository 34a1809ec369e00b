//! Every class of cells: which corner signs, face decisions and tunnels go together (IS-79 … IS-81).
//!
//! The list is an upper bound by argument. That each class on it is met by a cell, and no other class by
//! any cell, is what its tests show: by a witness with small integers for each.

use super::cell::{Decisions, Join};
use super::cube::{Corner, Edge, Face};

/// Every labelled class of non-degenerate cells, sorted: 768 of them (IS-80), the text's "more than 730" (IS-66).
#[doc(alias = "IS-66")]
#[doc(alias = "IS-80")]
pub fn classes() -> Vec<Decisions> {
    let mut classes: Vec<Decisions> = face_classes()
        .into_iter()
        .flat_map(|class| {
            let tunnels = tunnels(&class).into_iter().map(Some);
            [None].into_iter().chain(tunnels).map(move |tunnel| Decisions { tunnel, ..class }).collect::<Vec<_>>()
        })
        .collect();
    classes.sort();
    classes
}

/// Every class of corner signs and face decisions, without regard to the inside: 620 of 656 (IS-58, IS-79).
///
/// A face joins its positive pair iff L = Σ ± log|f − c| over its corners (+ at positive ones) is
/// positive. Where all six faces are ambiguous, the sums of L over opposite faces are the same number for
/// each axis, so no axis has both its faces positive while another has both negative. Every other
/// choice is free: some corner of each ambiguous face lies on no other one, or on fewer.
#[doc(alias = "IS-58")]
#[doc(alias = "IS-79")]
pub fn face_classes() -> Vec<Decisions> {
    let mut classes = Vec::new();
    for positive in 0..=255u8 {
        let ambiguous: Vec<Face> = Face::ALL.into_iter().filter(|f| is_ambiguous(positive, *f)).collect();
        for choice in 0..1u8 << ambiguous.len() {
            let mut faces = [0; 6];
            for (bit, face) in ambiguous.iter().enumerate() {
                faces[face.index()] = if choice >> bit & 1 == 1 { 1 } else { -1 };
            }
            let both = |sign: i8| (0..3).any(|axis| faces[2 * axis] == sign && faces[2 * axis + 1] == sign);
            if ambiguous.len() < 6 || !(both(1) && both(-1)) {
                classes.push(Decisions { positive, faces, tunnel: None });
            }
        }
    }
    classes
}

fn is_ambiguous(positive: u8, face: Face) -> bool {
    let [p, q, r, s] = face.cycle().map(|c| positive & c.bit() != 0);
    p == r && q == s && p != q
}

/// The tunnels that a class of signs and faces allows: those that cuts along each of the three axes allow (IS-81).
#[doc(alias = "IS-81")]
pub fn tunnels(class: &Decisions) -> Vec<Join> {
    let mut allowed = tunnels_along(class, 0);
    for axis in [1, 2] {
        let other = tunnels_along(class, axis);
        allowed.retain(|tunnel| other.contains(tunnel));
    }
    allowed
}

/// The tunnels that cuts across one axis allow.
///
/// A tunnel that joins A and C shows as an interval of cuts in which A, C have one sign and B, D the
/// other, with Q = AC − BD concave and positive just between two roots inside (IS-78). So Q is negative on
/// both faces of the cell across the axis, and at both ends of the interval; where B or D vanishes,
/// Q = AC > 0, so it is A or C that vanishes at an end inside the cell.
fn tunnels_along(class: &Decisions, axis: usize) -> Vec<Join> {
    let mut parts = class.boundary_parts();
    let mut found = Vec::new();
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    let base = Corner::ALL[0];
    let lines = [base, base.across(u), base.across(u).across(v), base.across(v)];
    for (pair, rivals) in [([lines[0], lines[2]], [lines[1], lines[3]]), ([lines[1], lines[3]], [lines[0], lines[2]])] {
        for joined in [false, true] {
            let is_joined_sign = |c: Corner| class.is_positive(c) == joined;
            let reaches = pair.iter().all(|&c| is_joined_sign(c) || is_joined_sign(c.across(axis)))
                && rivals.iter().all(|&c| !is_joined_sign(c) || !is_joined_sign(c.across(axis)));
            if !reaches || !(0..2).all(|side| end_is_allowed(class, axis, side, pair, rivals, joined)) {
                continue;
            }
            let ends = pair.map(|c| parts.find(if is_joined_sign(c) { c } else { c.across(axis) }.index()));
            if ends[0] != ends[1] {
                let join = Join { corners: [ends[0].min(ends[1]), ends[0].max(ends[1])].map(|i| Corner::ALL[i]) };
                if !found.contains(&join) {
                    found.push(join);
                }
            }
        }
    }
    found
}

/// Whether the interval of cuts can end toward `side` with a negative determinant.
fn end_is_allowed(
    class: &Decisions,
    axis: usize,
    side: u8,
    pair: [Corner; 2],
    rivals: [Corner; 2],
    joined: bool,
) -> bool {
    let at_end = |c: Corner| if c.position()[axis] == side { c } else { c.across(axis) };
    let is_joined_sign = |c: Corner| class.is_positive(at_end(c)) == joined;
    let bounding: Vec<Corner> = pair.into_iter().filter(|c| !is_joined_sign(*c)).collect();
    let bounding_rivals: Vec<Corner> = rivals.into_iter().filter(|c| is_joined_sign(*c)).collect();
    let separates = |face: Face| class.faces[face.index()] == if joined { -1 } else { 1 };
    // Q on the face: the product of the pair less that of the rivals.
    let [a, c] = pair.map(is_joined_sign);
    let [b, d] = rivals.map(is_joined_sign);
    let is_positive_on_face = match (a == c, b == d) {
        (true, false) => true,
        (true, true) if a != b => separates(Face::new(axis, side)) != a,
        // Both products have one sign, and the face is not ambiguous: either may be the greater.
        (true, true) | (false, false) | (false, true) => false,
    };
    if is_positive_on_face {
        return false;
    }
    // A rival that vanishes on this side must do so farther out than one of the pair: on the face of
    // both, whose signs then alternate, both have the rivals' sign in between.
    bounding_rivals.iter().all(|rival| {
        bounding.iter().any(|c| {
            let edge = Edge::between(*c, *rival).expect("a line of the pair is next to one of the rivals");
            let shared = Face::ALL.into_iter().find(|f| f.axis() != axis && edge.in_face(*f));
            separates(shared.expect("an edge across the axis lies in one face along it"))
        })
    })
}

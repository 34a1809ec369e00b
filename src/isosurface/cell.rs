//! The exact topology of {f = c} in a closed cell, f trilinear (IS-74 … IS-78).
//!
//! Three decisions make it: the sign of each corner; on each ambiguous face, which diagonal pair the
//! bilinear face function joins; and whether a diagonal pair is joined inside the cell, though on no
//! face. Each is the sign of a polynomial in the corner values, so one text serves every number: cheap
//! enclosures first, exact integers after, and numbers with an infinitesimal part for ties.

use super::boundary;
use super::cases::Case;
use super::cube::{Corner, Edge, Face};
use super::interior;
pub use super::interior::Join;
use crate::number::{Enclosure, Integer, Perturbed, Rational, Sign};
use crate::partition::Partition;
use thiserror::Error;

/// Where the isovalue is a critical value, so that the topology of {f = c} is not stable.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Degenerate {
    /// A corner's value equals the isovalue.
    #[error("the value at corner {} equals the isovalue", .0.index())]
    Corner(Corner),
    /// The saddle of an ambiguous face lies at the isovalue (IS-87).
    #[doc(alias = "IS-87")]
    #[error("the saddle of face {} at ({}, {}, {}) lies at the isovalue", .face.name(), .point[0], .point[1], .point[2])]
    Face {
        /// The face.
        face: Face,
        /// The saddle, in cell coordinates.
        point: [Rational; 3],
    },
    /// A critical point of f inside the cell lies at the isovalue (IS-88).
    #[doc(alias = "IS-88")]
    #[error("the critical point ({}, {}, {}) inside the cell lies at the isovalue", .point[0], .point[1], .point[2])]
    Interior {
        /// The critical point, in cell coordinates.
        point: [Rational; 3],
    },
}

/// What to do when the isovalue is a critical value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Tie {
    /// Report it.
    #[default]
    Degenerate,
    /// Take the isovalue c − ε instead, for every small enough ε > 0: a value equal to c is outside.
    Below,
}

/// The three decisions of a cell. Everything else about its topology is combinatorics of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Decisions {
    /// The set of the corners with f > c.
    pub positive: u8,
    /// For each face, the sign of the corner pair that it joins; 0 where it is not ambiguous.
    pub faces: [i8; 6],
    /// Corners that are joined inside the cell and, by the faces alone, would not be (IS-59).
    #[doc(alias = "IS-59")]
    pub tunnel: Option<Join>,
}

impl Decisions {
    /// The sign of a corner; no corner is at the isovalue.
    pub fn is_positive(&self, c: Corner) -> bool {
        self.positive & c.bit() != 0
    }

    /// Whether the surface crosses an edge; it does so once at most (IS-54).
    #[doc(alias = "IS-54")]
    pub fn crosses(&self, e: Edge) -> bool {
        let [a, b] = e.corners();
        self.is_positive(a) != self.is_positive(b)
    }

    /// Which corners the boundary of the cell connects: along edges, and across ambiguous faces.
    pub fn boundary_parts(&self) -> Partition {
        let mut parts = Partition::new(8);
        for e in Edge::ALL {
            let [a, b] = e.corners();
            if !self.crosses(e) {
                parts.join(a.index(), b.index());
            }
        }
        for face in Face::ALL {
            let [p, q, r, s] = face.cycle();
            let joins_positive = match self.faces[face.index()] {
                0 => continue,
                sign => sign > 0,
            };
            let (a, b) = if self.is_positive(p) == joins_positive { (p, r) } else { (q, s) };
            parts.join(a.index(), b.index());
        }
        parts
    }

    /// Two corners that some cut joins, as a tunnel: the least corners of their parts on the boundary;
    /// `None` where the boundary joins them already.
    pub(super) fn as_tunnel(&self, join: Join) -> Option<Join> {
        let mut parts = self.boundary_parts();
        let [a, b] = join.corners.map(|c| parts.find(c.index()));
        (a != b).then(|| Join { corners: [Corner::ALL[a.min(b)], Corner::ALL[a.max(b)]] })
    }

    /// Which corners the cell connects: on its boundary and through its inside (IS-84).
    #[doc(alias = "IS-84")]
    pub fn parts(&self) -> Partition {
        let mut parts = self.boundary_parts();
        if let Some(Join { corners: [a, b] }) = self.tunnel {
            parts.join(a.index(), b.index());
        }
        parts
    }
}

/// Why no decision was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// An enclosure contains zero; exact numbers never say so.
    Undecided,
    /// A corner's value is zero.
    Corner(Corner),
    /// An ambiguous face's saddle value is zero.
    Face(Face),
    /// A critical value inside the cell is zero.
    Interior,
}

/// The three decisions for the level set f = 0 of the trilinear function with these corner values
/// (IS-57, IS-78).
pub fn decide<K: Enclosure>(values: &[K; 8]) -> Result<Decisions, Obstacle> {
    let mut decisions = Decisions { positive: 0, faces: [0; 6], tunnel: None };
    for c in Corner::ALL {
        match values[c.index()].known_sign().ok_or(Obstacle::Undecided)? {
            Sign::Zero => return Err(Obstacle::Corner(c)),
            Sign::Positive => decisions.positive |= c.bit(),
            Sign::Negative => {}
        }
    }
    for face in Face::ALL {
        decisions.faces[face.index()] = face_decision(values, decisions.positive, face)?;
    }
    decisions.tunnel = interior::join(values)?.and_then(|join| decisions.as_tunnel(join));
    Ok(decisions)
}

/// The sign of the diagonal pair that the bilinear function of a face joins: the pair with the greater
/// product of values; 0 unless the signs alternate around the face. It is told by the four values of the face
/// alone, so that neighbours agree (IS-57), which a table by signs alone does not bring about (IS-56).
#[doc(alias = "IS-56")]
#[doc(alias = "IS-57")]
fn face_decision<K: Enclosure>(values: &[K; 8], positive: u8, face: Face) -> Result<i8, Obstacle> {
    let corners = face.cycle();
    let [p, q, r, s] = corners.map(|c| positive & c.bit() != 0);
    if p != r || q != s || p == q {
        return Ok(0);
    }
    let [g00, g10, g11, g01] = corners.map(|c| &values[c.index()]);
    let joins_positive = match determinant2(g00, g10, g01, g11).known_sign() {
        None => return Err(Obstacle::Undecided),
        Some(Sign::Zero) => return Err(Obstacle::Face(face)),
        Some(Sign::Positive) => p,
        Some(Sign::Negative) => q,
    };
    Ok(if joins_positive { 1 } else { -1 })
}

/// g00·g11 − g10·g01.
fn determinant2<K: Enclosure>(g00: &K, g10: &K, g01: &K, g11: &K) -> K {
    g00.clone() * g11 - &(g10.clone() * g01)
}

/// The three decisions for {f = c}, exactly; a tie as asked.
pub fn decisions(values: &[Rational; 8], isovalue: &Rational, tie: Tie) -> Result<Decisions, Degenerate> {
    let level = integral(&values.each_ref().map(|v| Rational::from(v - isovalue)));
    match (decide(&level), tie) {
        (Ok(decisions), _) => Ok(decisions),
        (Err(obstacle), Tie::Degenerate) => Err(locate(&level, obstacle)),
        (Err(_), Tie::Below) => Ok(decide_below(&level)),
    }
}

/// The decisions for f = −ε, every small enough ε > 0 (IS-86: they always exist).
#[doc(alias = "IS-86")]
pub fn decide_below<K: Enclosure>(level: &[K; 8]) -> Decisions {
    let raised = level.each_ref().map(|v| Perturbed::new(v.clone(), K::integer(1)));
    decide(&raised).expect("c − ε is no critical value for all small enough ε > 0 (IS-86)")
}

/// The values times their least common denominator: the same signs, by integers.
fn integral(values: &[Rational; 8]) -> [Integer; 8] {
    let denominator = values.iter().fold(Integer::from(1), |lcm, v| lcm.lcm(v.denom()));
    values.each_ref().map(|v| Integer::from(&denominator / v.denom()) * v.numer())
}

/// The critical point behind an obstacle, exactly.
fn locate(level: &[Integer; 8], obstacle: Obstacle) -> Degenerate {
    match obstacle {
        Obstacle::Undecided => unreachable!("integers have a sign"),
        Obstacle::Corner(c) => Degenerate::Corner(c),
        Obstacle::Face(face) => {
            let (axis, cycle) = (face.axis(), face.cycle());
            // The saddle in coordinates along the first and the last side of the cycle.
            let [s, t] = saddle(cycle.map(|c| Rational::from(&level[c.index()])));
            let origin = cycle[0].position().map(Rational::from);
            let mut point = origin;
            for (end, share) in [(cycle[1], s), (cycle[3], t)] {
                let along = (cycle[0].index() ^ end.index()).trailing_zeros() as usize;
                point[along] = if cycle[0].position()[along] == 0 { share } else { Rational::from(1) - share };
            }
            point[axis] = Rational::from(face.side());
            Degenerate::Face { face, point }
        }
        Obstacle::Interior => {
            let [n, d] = interior::critical_cut(level).expect("the obstacle was found in a cut");
            let w = Rational::from((n, d));
            let cut = [0, 1, 3, 2].map(|xy| {
                let (low, high) = (Rational::from(&level[xy]), Rational::from(&level[xy + 4]));
                (high - &low) * &w + low
            });
            let [u, v] = saddle(cut);
            Degenerate::Interior { point: [u, v, w] }
        }
    }
}

/// Where the gradient of a bilinear function vanishes; corners in cyclic order g00, g10, g11, g01.
fn saddle([g00, g10, g11, g01]: [Rational; 4]) -> [Rational; 2] {
    let mixed = Rational::from(&g00 + &g11) - Rational::from(&g10 + &g01);
    [(g00.clone() - g01) / &mixed, (g00 - g10) / &mixed]
}

/// One connected component of the surface in the cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Component {
    /// Its boundary loops, as indices into [`Topology::loops`].
    pub loops: Vec<usize>,
    /// Its Euler characteristic: 1 for a disk, 0 for an annulus.
    pub chi: i64,
    /// Its genus; always 0 in a cell (IS-77).
    pub genus: i64,
}

/// {f ≤ c} or {f ≥ c} in the cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Side {
    /// The corners of each component, sorted; each component holds at least one (IS-75).
    #[doc(alias = "IS-75")]
    pub parts: Vec<Vec<Corner>>,
    /// The first Betti number: how many independent loops cannot be shrunk within it.
    pub b1: i64,
}

/// The exact topology of a trilinear level set in a closed cell, labelled by the cell's corners and edges. Both
/// sides are told: with the faces, the numbers of their components determine it, and that of one does not (IS-60).
#[doc(alias = "IS-60")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Topology {
    /// The decisions that it follows from.
    pub decisions: Decisions,
    /// Chernyaev's name of the case.
    pub case: Case,
    /// The closed curves that the surface cuts out of the cell's boundary, as cycles of crossed edges,
    /// with f > c on the left of the direction of travel, seen from outside.
    pub loops: Vec<Vec<Edge>>,
    /// The components of the surface.
    pub components: Vec<Component>,
    /// {f ≤ c}.
    pub negative: Side,
    /// {f ≥ c}.
    pub positive: Side,
}

impl Topology {
    /// The Euler characteristic of the surface.
    pub fn chi(&self) -> i64 {
        self.components.iter().map(|c| c.chi).sum()
    }
}

/// The exact topology of {f = c} in the cell with these corner values (IS-76 … IS-78, IS-84).
///
/// Errors: [`Degenerate`] where c is a critical value and ties are not broken.
pub fn topology(values: &[Rational; 8], isovalue: &Rational, tie: Tie) -> Result<Topology, Degenerate> {
    decisions(values, isovalue, tie).map(assemble)
}

/// What follows from the decisions: loops on the boundary, and what bounds what inside.
#[doc(alias = "IS-77")]
pub fn assemble(decisions: Decisions) -> Topology {
    let loops = boundary::loops(&decisions);
    let mut parts = decisions.parts();
    // A surface component is where one negative and one positive part meet: the parts are the nodes of a
    // tree, of which the components are the edges (IS-77).
    let mut between: Vec<([usize; 2], Component)> = Vec::new();
    for (index, cycle) in loops.iter().enumerate() {
        let [a, b] = cycle[0].corners().map(|c| parts.find(c.index()));
        let meeting = if decisions.is_positive(Corner::ALL[a]) { [b, a] } else { [a, b] };
        match between.iter_mut().find(|(known, _)| *known == meeting) {
            Some((_, component)) => component.loops.push(index),
            None => between.push((meeting, Component { loops: vec![index], chi: 0, genus: 0 })),
        }
    }
    for (_, component) in &mut between {
        component.chi = 2 - component.loops.len() as i64;
    }
    let side = |positive: bool| {
        let (mut parts, mut regions) = (decisions.parts(), decisions.boundary_parts());
        let mut side = Side { parts: Vec::new(), b1: 0 };
        for root in Corner::ALL.into_iter().filter(|c| decisions.is_positive(*c) == positive) {
            if parts.find(root.index()) != root.index() {
                continue;
            }
            let corners: Vec<_> = Corner::ALL.into_iter().filter(|c| parts.find(c.index()) == root.index()).collect();
            // The boundary of a part is made of surface components and of regions on the cell's boundary,
            // glued along the loops; χ(part) is half its χ. A part has no voids, so b1 = 1 − χ(part).
            let bounding = between.iter().filter(|(meeting, _)| meeting.contains(&root.index()));
            let (components, loops) = bounding.fold((0, 0), |(n, l), (_, c)| (n + 1, l + c.loops.len() as i64));
            let patches = corners.iter().filter(|c| regions.find(c.index()) == c.index()).count() as i64;
            side.b1 += 1 - (components + patches - loops);
            side.parts.push(corners);
        }
        side
    };
    let (negative, positive) = (side(false), side(true));
    let components = between.into_iter().map(|(_, component)| component).collect();
    Topology { decisions, case: Case::of(&decisions), loops, components, negative, positive }
}

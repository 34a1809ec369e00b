//! The contour of a bilinear function in a square: marching squares with its one ambiguity decided.

use super::cell::Tie;
use super::critical::{BilinearCritical, Saddle, bilinear_critical};
use super::multilinear::{LinearZero, linear_zero};
use crate::number::{Enclosure, Perturbed, Rational, Ring, Sign};
use thiserror::Error;

/// A corner of the square: c = u + 2v lies at (c & 1, c >> 1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SquareCorner(u8);

impl SquareCorner {
    /// All four, in order.
    pub const ALL: [SquareCorner; 4] = [SquareCorner(0), SquareCorner(1), SquareCorner(2), SquareCorner(3)];

    /// Counter-clockwise from (0, 0).
    pub const CYCLE: [SquareCorner; 4] = [SquareCorner(0), SquareCorner(1), SquareCorner(3), SquareCorner(2)];

    /// 0 … 3.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Its coordinates, each 0 or 1.
    pub const fn position(self) -> [u8; 2] {
        [self.0 & 1, self.0 >> 1]
    }
}

/// An edge of the square: `[0,1]`, `[0,2]`, `[1,3]` or `[2,3]`, in that order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SquareEdge(u8);

impl SquareEdge {
    /// All four, in order.
    pub const ALL: [SquareEdge; 4] = [SquareEdge(0), SquareEdge(1), SquareEdge(2), SquareEdge(3)];

    /// 0 … 3.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Its two corners, the smaller first.
    pub const fn corners(self) -> [SquareCorner; 2] {
        let [a, b] = [[0, 1], [0, 2], [1, 3], [2, 3]][self.0 as usize];
        [SquareCorner(a), SquareCorner(b)]
    }

    /// The axis it runs along: 0 or 1.
    pub const fn axis(self) -> usize {
        [0, 1, 1, 0][self.0 as usize]
    }
}

/// Counter-clockwise, side i goes from corner i of [`SquareCorner::CYCLE`] to the next.
const SIDES: [SquareEdge; 4] = [SquareEdge(0), SquareEdge(2), SquareEdge(3), SquareEdge(1)];

/// Where the isovalue is a critical value of the square, or a corner's (IS-47).
#[doc(alias = "IS-47")]
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DegenerateSquare {
    /// A corner's value equals the isovalue; the edges may then hold infinitely many zeros (IS-38).
    #[doc(alias = "IS-38")]
    #[error("the value at corner {} equals the isovalue", .0.index())]
    Corner(SquareCorner),
    /// The signs of the corners alternate, and the saddle lies at the isovalue: the contour is two lines (IS-41).
    #[doc(alias = "IS-41")]
    #[error("the saddle ({u}, {v}) lies at the isovalue")]
    Saddle {
        /// Where it lies.
        u: Rational,
        /// Where it lies.
        v: Rational,
    },
}

/// Where the contour crosses an edge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Crossing {
    /// The edge.
    pub edge: SquareEdge,
    /// The share of the edge, from its smaller corner: t = (c − g₀) / (g₁ − g₀).
    pub t: Rational,
}

impl Crossing {
    /// Its position in the square.
    pub fn position(&self) -> [Rational; 2] {
        let mut position = self.edge.corners()[0].position().map(Rational::from);
        position[self.edge.axis()] += &self.t;
        position
    }
}

/// The contour of the bilinear function in a closed square.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SquareContour {
    /// The critical point of the bilinear function, wherever in the plane it lies; none iff f_uv = 0.
    pub saddle: Option<Saddle>,
    /// The sign of (g₀₀−c)(g₁₁−c) − (g₁₀−c)(g₀₁−c): which side of an ambiguous square is connected (IS-44).
    #[doc(alias = "IS-44")]
    pub determinant_sign: Sign,
    /// The arcs of the contour, from crossed edge to crossed edge, with f > c on the left where u runs to the
    /// right and v up; sorted.
    pub segments: Vec<[SquareEdge; 2]>,
    /// Its crossings with the edges, in their order.
    pub crossings: Vec<Crossing>,
}

/// What decides the contour: the corners with f > c, and the sign of the determinant.
struct Decisions {
    positive: [bool; 4],
    determinant: Sign,
}

/// Why there is no decision.
enum Obstacle {
    Corner(SquareCorner),
    Saddle,
}

/// The contour {f = c} of the bilinear function with values [g₀₀, g₁₀, g₀₁, g₁₁] at the corners of the square
/// (IS-36, IS-37, IS-42).
///
/// Where the signs alternate around the square, the contour is a hyperbola about the saddle, and the corners
/// with the greater product of values less c are joined: (0,0) and (1,1) iff the determinant is positive.
/// Else 0 or 2 edges are crossed, and the determinant does not matter.
///
/// Errors: iff ties are not broken and a corner's value is c, or the signs alternate and the saddle's value is
/// c. Where ties are broken, signs are those for c − ε, and t is the limit for ε → 0.
#[doc(alias = "IS-36")]
#[doc(alias = "IS-37")]
#[doc(alias = "IS-42")]
pub fn contour(values: &[Rational; 4], isovalue: &Rational, tie: Tie) -> Result<SquareContour, DegenerateSquare> {
    let level = values.each_ref().map(|v| Rational::from(v - isovalue));
    let saddle = match bilinear_critical(values) {
        BilinearCritical::None | BilinearCritical::Everywhere => None,
        BilinearCritical::Saddle(saddle) => Some(saddle),
    };
    let decided = match tie {
        Tie::Degenerate => decide(&level),
        Tie::Below => decide(&level.each_ref().map(|v| Perturbed::new(v.clone(), Rational::integer(1)))),
    };
    let decisions = match (decided, &saddle) {
        (Ok(decisions), _) => decisions,
        (Err(Obstacle::Corner(c)), _) => return Err(DegenerateSquare::Corner(c)),
        (Err(Obstacle::Saddle), Some(Saddle { u, v, .. })) => {
            return Err(DegenerateSquare::Saddle { u: u.clone(), v: v.clone() });
        }
        (Err(Obstacle::Saddle), None) => unreachable!("f_uv has a strict sign where corner signs alternate"),
    };
    let crossings = SquareEdge::ALL.into_iter().filter_map(|edge| crossing(&level, &decisions, edge)).collect();
    let segments = segments(&decisions);
    Ok(SquareContour { saddle, determinant_sign: decisions.determinant, segments, crossings })
}

fn decide<K: Enclosure>(level: &[K; 4]) -> Result<Decisions, Obstacle> {
    let sign = |value: &K| value.known_sign().expect("exact numbers have a sign");
    let mut positive = [false; 4];
    for c in SquareCorner::ALL {
        positive[c.index()] = match sign(&level[c.index()]) {
            Sign::Zero => return Err(Obstacle::Corner(c)),
            Sign::Positive => true,
            Sign::Negative => false,
        };
    }
    let [g00, g10, g01, g11] = level;
    let determinant = sign(&(g00.clone() * g11 - &(g10.clone() * g01)));
    let decisions = Decisions { positive, determinant };
    if decisions.alternates() && determinant == Sign::Zero {
        return Err(Obstacle::Saddle);
    }
    Ok(decisions)
}

impl Decisions {
    /// Whether there are two ways to join the crossings (IS-39).
    #[doc(alias = "IS-39")]
    fn alternates(&self) -> bool {
        let [p00, p10, p01, p11] = self.positive;
        p00 == p11 && p10 == p01 && p00 != p10
    }
}

fn crossing(level: &[Rational; 4], decisions: &Decisions, edge: SquareEdge) -> Option<Crossing> {
    let [a, b] = edge.corners().map(SquareCorner::index);
    if decisions.positive[a] == decisions.positive[b] {
        return None;
    }
    match linear_zero(&[level[a].clone(), level[b].clone()]) {
        LinearZero::At(t) => Some(Crossing { edge, t }),
        LinearZero::None | LinearZero::Everywhere => unreachable!("c − ε lies between the ends of a crossed edge"),
    }
}

fn segments(decisions: &Decisions) -> Vec<[SquareEdge; 2]> {
    let positive = SquareCorner::CYCLE.map(|c| decisions.positive[c.index()]);
    let falls = |i: usize| positive[i % 4] && !positive[(i + 1) % 4];
    let rises = |i: usize| !positive[i % 4] && positive[(i + 1) % 4];
    // Counter-clockwise, an arc starts where f falls below c. Where positive corners are joined, it cuts off
    // the negative corner ahead; where they are not, the positive one behind. Unless the signs alternate,
    // there is one rise only, and both ways lead to it.
    let joins_positive = match decisions.determinant {
        Sign::Positive => positive[0],
        Sign::Negative => !positive[0],
        Sign::Zero => false,
    };
    let rise_from = |fall: usize| {
        let steps = [1, 2, 3].map(|step| if joins_positive { fall + step } else { fall + 4 - step });
        steps.into_iter().find(|&i| rises(i)).expect("what falls on a closed curve rises again")
    };
    let mut segments: Vec<_> =
        (0..4).filter(|&i| falls(i)).map(|fall| [SIDES[fall], SIDES[rise_from(fall) % 4]]).collect();
    segments.sort();
    segments
}

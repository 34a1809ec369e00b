//! Gluing schemes as they are written down, and everything that can be wrong with one.

use super::polyhedron::PolyhedronFlaw;
use crate::mesh::classify::{ClosedSurface, Surface};
use std::fmt::{self, Display, Formatter};
use thiserror::Error;

/// Polyhedra and which of their faces are glued. Nothing is checked yet.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct GluingScheme {
    /// The polyhedra, unglued.
    pub polyhedra: Vec<Polyhedron>,
    /// Which faces are glued, and how.
    pub pairings: Vec<Pairing>,
}

/// A polyhedron by its edges and faces.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polyhedron {
    /// Tail and head of each edge, as names of vertices of this polyhedron; a loop has the same vertex twice.
    pub edges: Vec<[u32; 2]>,
    /// The edges around each face as seen from one side, the same for all faces (all from outside, or all from inside).
    pub faces: Vec<Vec<SignedEdge>>,
}

/// An edge as a face walks along it: ±(1 + its index), + from tail to head.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SignedEdge(pub i32);

impl SignedEdge {
    /// The index of the edge. `None` for 0, which has no sign.
    pub fn index(self) -> Option<usize> {
        (self.0.unsigned_abs() as usize).checked_sub(1)
    }

    /// Whether it is walked from tail to head.
    pub fn is_forward(self) -> bool {
        self.0 > 0
    }
}

/// A face of a polyhedron.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FaceId {
    /// The index of the polyhedron.
    pub polyhedron: usize,
    /// The index of the face in it.
    pub face: usize,
}

impl Display for FaceId {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "face {} of polyhedron {}", self.face, self.polyhedron)
    }
}

/// Two faces of n corners glued: corner i of `a` to corner shift + dir · i (mod n) of `b`. Corner i is where the i-th edge of
/// the face's cycle begins, from 0 on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pairing {
    /// One face.
    pub a: FaceId,
    /// The other face.
    pub b: FaceId,
    /// Where corner 0 goes; any integer, mod n.
    pub shift: i64,
    /// +1 or −1: whether the cycle of `a` is laid along that of `b`, or against it.
    pub dir: i64,
}

/// The pairings' ways to name no gluing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum PairingFlaw {
    /// One of the faces does not exist.
    #[error("there is no {0}")]
    NoSuchFace(FaceId),
    /// Neither +1 nor −1.
    #[error("dir is {0}; it is 1 or -1")]
    Direction(i64),
}

/// What keeps a scheme from being a closed 3-manifold, with a witness.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SchemeDefect {
    /// There is no polyhedron at all.
    #[error("there is no polyhedron")]
    Empty,
    /// The faces of a polyhedron do not make a sphere, so that nothing says what is inside.
    #[error("polyhedron {polyhedron} is not a ball: {flaw}")]
    BadPolyhedron {
        /// The polyhedron.
        polyhedron: usize,
        /// What is wrong with it.
        flaw: PolyhedronFlaw,
    },
    /// A pairing names no gluing.
    #[error("pairing {pairing}: {flaw}")]
    BadPairing {
        /// The pairing.
        pairing: usize,
        /// What is wrong with it.
        flaw: PairingFlaw,
    },
    /// A pairing of polygons with different numbers of sides.
    #[error("pairing {pairing} glues a face of {a} sides to one of {b}")]
    PolygonSizeMismatch {
        /// The pairing.
        pairing: usize,
        /// The sides of its face `a`.
        a: usize,
        /// The sides of its face `b`.
        b: usize,
    },
    /// A face paired with itself: it would be folded, or be a border.
    #[error("pairing {pairing} glues {face} to itself")]
    FaceGluedToItself {
        /// The pairing.
        pairing: usize,
        /// The face.
        face: FaceId,
    },
    /// A face in two pairings: three sheets or more would meet there.
    #[error("{face} is in pairing {} and in pairing {}", .pairings[0], .pairings[1])]
    FaceInTwoPairings {
        /// The face.
        face: FaceId,
        /// The two pairings.
        pairings: [usize; 2],
    },
    /// A face in no pairing: it would be a border.
    #[error("{face} is in no pairing")]
    UnmatchedFace {
        /// The face.
        face: FaceId,
    },
    /// An edge that the gluing turns on itself: its middle has the cone on a projective plane around it.
    #[error("edge {} of polyhedron {polyhedron} is glued to itself, tail to head", .edge + 1)]
    EdgeReversed {
        /// The polyhedron.
        polyhedron: usize,
        /// The index of the edge in it.
        edge: usize,
    },
    /// A vertex around which the space is the cone on another surface than the sphere.
    #[error("around vertex {vertex}, which is vertex {name} of polyhedron {polyhedron}, stands a {}, not a sphere", closed(*.link))]
    VertexLink {
        /// The vertex of the complex.
        vertex: u32,
        /// A polyhedron that has it.
        polyhedron: usize,
        /// What it is called there.
        name: u32,
        /// The surface around it.
        link: ClosedSurface,
    },
}

fn closed(link: ClosedSurface) -> Surface {
    Surface { closed: link, boundary_loops: 0 }
}

/// The reasons by which protocol and page tell defects apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Reason {
    /// [`SchemeDefect::UnmatchedFace`].
    UnmatchedFace,
    /// [`SchemeDefect::PolygonSizeMismatch`].
    PolygonSizeMismatch,
    /// [`SchemeDefect::FaceGluedToItself`].
    FaceGluedToItself,
    /// [`SchemeDefect::FaceInTwoPairings`].
    FaceInTwoPairings,
    /// [`SchemeDefect::BadPairing`].
    BadPairing,
    /// [`SchemeDefect::EdgeReversed`].
    EdgeReversed,
    /// [`SchemeDefect::VertexLink`].
    VertexLink,
    /// [`SchemeDefect::BadPolyhedron`] and [`SchemeDefect::Empty`].
    BadPolyhedron,
}

impl Reason {
    /// Its word in the protocol.
    pub const fn name(self) -> &'static str {
        match self {
            Reason::UnmatchedFace => "unmatched-face",
            Reason::PolygonSizeMismatch => "polygon-size-mismatch",
            Reason::FaceGluedToItself => "face-glued-to-itself",
            Reason::FaceInTwoPairings => "face-in-two-pairings",
            Reason::BadPairing => "bad-pairing",
            Reason::EdgeReversed => "edge-reversed",
            Reason::VertexLink => "vertex-link",
            Reason::BadPolyhedron => "bad-polyhedron",
        }
    }
}

impl SchemeDefect {
    /// Its reason.
    #[doc(alias = "CX-6")]
    pub fn reason(&self) -> Reason {
        match self {
            SchemeDefect::Empty | SchemeDefect::BadPolyhedron { .. } => Reason::BadPolyhedron,
            SchemeDefect::BadPairing { .. } => Reason::BadPairing,
            SchemeDefect::PolygonSizeMismatch { .. } => Reason::PolygonSizeMismatch,
            SchemeDefect::FaceGluedToItself { .. } => Reason::FaceGluedToItself,
            SchemeDefect::FaceInTwoPairings { .. } => Reason::FaceInTwoPairings,
            SchemeDefect::UnmatchedFace { .. } => Reason::UnmatchedFace,
            SchemeDefect::EdgeReversed { .. } => Reason::EdgeReversed,
            SchemeDefect::VertexLink { .. } => Reason::VertexLink,
        }
    }
}

impl GluingScheme {
    /// The polygon of a face, if there is such a face.
    pub fn face(&self, id: FaceId) -> Option<&[SignedEdge]> {
        self.polyhedra.get(id.polyhedron)?.faces.get(id.face).map(Vec::as_slice)
    }

    /// The faces of all polyhedra, in order.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        let faces =
            |(polyhedron, p): (usize, &Polyhedron)| (0..p.faces.len()).map(move |face| FaceId { polyhedron, face });
        self.polyhedra.iter().enumerate().flat_map(faces)
    }

    /// What is wrong with polyhedra and pairings by themselves, before anything is glued: polyhedra first, then pairings,
    /// then faces in none. Empty iff every polyhedron is a ball and the pairings match the faces in twos, sizes alike.
    #[doc(alias = "CX-3")]
    pub fn defects(&self) -> Vec<SchemeDefect> {
        if self.polyhedra.is_empty() {
            return vec![SchemeDefect::Empty];
        }
        let flaws = self.polyhedra.iter().map(Polyhedron::flaw).enumerate();
        let mut defects: Vec<SchemeDefect> = flaws
            .filter_map(|(polyhedron, flaw)| Some(SchemeDefect::BadPolyhedron { polyhedron, flaw: flaw? }))
            .collect();
        let mut first_use = std::collections::BTreeMap::new();
        for (pairing, Pairing { a, b, dir, .. }) in self.pairings.iter().enumerate() {
            let missing = [*a, *b].into_iter().find(|id| self.face(*id).is_none());
            if let Some(id) = missing {
                defects.push(SchemeDefect::BadPairing { pairing, flaw: PairingFlaw::NoSuchFace(id) });
                continue;
            }
            if ![1, -1].contains(dir) {
                defects.push(SchemeDefect::BadPairing { pairing, flaw: PairingFlaw::Direction(*dir) });
            }
            let [n, m] = [*a, *b].map(|id| self.face(id).map_or(0, <[SignedEdge]>::len));
            if n != m {
                defects.push(SchemeDefect::PolygonSizeMismatch { pairing, a: n, b: m });
            }
            if a == b {
                defects.push(SchemeDefect::FaceGluedToItself { pairing, face: *a });
            }
            for face in if a == b { vec![*a] } else { vec![*a, *b] } {
                match *first_use.entry(face).or_insert(pairing) {
                    first if first == pairing => {}
                    first => defects.push(SchemeDefect::FaceInTwoPairings { face, pairings: [first, pairing] }),
                }
            }
        }
        let unmatched = self.faces().filter(|face| !first_use.contains_key(face));
        defects.extend(unmatched.map(|face| SchemeDefect::UnmatchedFace { face }));
        defects
    }
}

//! Euler operators: the steps in which a boundary representation is made of nothing and changed (ME-106 … ME-117).
//!
//! A [`Boundary`] has shells, faces, loops, half-edges and vertices. It is purely combinatorial: positions belong to the
//! names of its vertices and are kept by whoever has them. A face is a sphere with as many holes as it has loops, so a
//! shell is a closed oriented surface, and V − E + F − H = 2(C − G) with H the loops but the outer ones.
//!
//! An operator names what it makes, so that it has one exact inverse, which [`Boundary::apply`] hands back.
//!
//! ```
//! use isoracle::mesh::euler_operators::{Boundary, construction, replay};
//! use isoracle::mesh::examples::cube;
//!
//! let cube = Boundary::try_from(&cube().faces[..])?;
//! let operators = construction(&cube);
//! assert_eq!(operators.len(), 13); // mvfs, 7 mev, 5 mef
//! assert_eq!(replay(&operators)?, cube);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod apply;
mod boundary;
mod build;
mod counts;
mod faces;
mod names;

pub use boundary::{Boundary, Defect};
pub use build::{RefusedStep, construction, replay};
pub use counts::{BASIS, Counts};
pub use faces::{NotClosed, NotPaired};
pub use names::{FaceId, HalfEdge, LoopId, Name, ShellId, VertexId};

use std::collections::BTreeSet;
use thiserror::Error;

/// A corner of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Corner {
    /// The one at which a half-edge begins, between it and the one before it.
    Before(HalfEdge),
    /// The vertex of a loop without edges.
    Alone(VertexId),
}

/// A run of half-edges: around a vertex for mev, along a loop for mef.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Span {
    /// None, at this corner: mev makes a strut, mef a face of one edge.
    NothingAt(Corner),
    /// From the first up to, but without, the second, which differs.
    Between(HalfEdge, HalfEdge),
    /// All of them, from this one around to it again.
    AllFrom(HalfEdge),
}

/// An Euler operator, with the names of what it makes: mvfs, mev, mef, kemr, kfmrh, ksfmr and their inverses kvfs, kev, kef,
/// mekr, mfkrh, msfkr. In the names, m makes and k kills: v a vertex, e an edge, f a face, s a shell, r a ring (a loop
/// that is not its face's outer one), h a handle.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Operator {
    /// Makes a shell of one vertex and one face: a sphere.
    Mvfs {
        /// The new shell.
        shell: ShellId,
        /// Its face.
        face: FaceId,
        /// The loop of the face.
        outer: LoopId,
        /// The loop's vertex.
        vertex: VertexId,
    },
    /// Kills a shell of one vertex and one face.
    Kvfs {
        /// The shell.
        shell: ShellId,
    },
    /// Makes an edge and a vertex: the vertex at which the span's half-edges begin is split, they then begin at the new one.
    Mev {
        /// The half-edges that go to the new vertex, as they follow one another around the old one: after h comes the one
        /// that follows h's mate in its loop.
        span: Span,
        /// The new half-edge from the old vertex to the new one.
        half_edge: HalfEdge,
        /// The new vertex.
        vertex: VertexId,
    },
    /// Kills an edge and the vertex that the half-edge leads to; what begins there then begins where the half-edge did.
    Kev {
        /// The half-edge.
        half_edge: HalfEdge,
    },
    /// Makes an edge and a face: the span's part of a loop becomes, closed by the new edge, the outer loop of a new face.
    Mef {
        /// The half-edges that go to the new face, as they follow one another in their loop.
        span: Span,
        /// The new half-edge that stays in the old face, in the place of the span.
        half_edge: HalfEdge,
        /// The new loop; it has the new half-edge's mate.
        outer: LoopId,
        /// The new face.
        face: FaceId,
        /// The rings of the old face that go to the new one; the loop of the span is none of them.
        rings: BTreeSet<LoopId>,
    },
    /// Kills an edge and the face with this half-edge in its outer loop; its rings go to the face beyond.
    Kef {
        /// The half-edge.
        half_edge: HalfEdge,
    },
    /// Kills an edge that one loop runs along in both directions, and makes a ring: the loop falls into two.
    Kemr {
        /// The half-edge; the part of the loop after it, up to its mate, becomes the ring.
        half_edge: HalfEdge,
        /// The new ring.
        ring: LoopId,
    },
    /// Makes an edge between two loops of a face, and kills a ring: the second loop becomes part of the first.
    Mekr {
        /// Where it begins.
        from: Corner,
        /// Where it ends, in a ring.
        to: Corner,
        /// The new half-edge from the one to the other.
        half_edge: HalfEdge,
    },
    /// Kills a face without rings, and makes its loop a ring of another face of the same shell, which gains a handle.
    Kfmrh {
        /// The face.
        face: FaceId,
        /// The face that gets the ring.
        into: FaceId,
    },
    /// Makes a ring a face, and kills a handle: the shell stays connected.
    Mfkrh {
        /// The ring.
        ring: LoopId,
        /// The new face.
        face: FaceId,
    },
    /// Kills a face without rings, and makes its loop a ring of a face of another shell: its own shell becomes part of
    /// that one, and no handle is made.
    Ksfmr {
        /// The face.
        face: FaceId,
        /// The face that gets the ring.
        into: FaceId,
    },
    /// Makes a ring a face, where that divides its shell: what hangs together with the new face is a new shell.
    Msfkr {
        /// The ring.
        ring: LoopId,
        /// The new face.
        face: FaceId,
        /// The new shell.
        shell: ShellId,
    },
}

/// Whether an operator changes the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Scope {
    /// Every shell stays the same surface, up to a homeomorphism ("rubber sheet"): points and lines are drawn on it,
    /// or wiped away.
    Local,
    /// The number of shells changes, or that of handles.
    Global,
}

impl Operator {
    /// What it adds to V, E, F, H, C and G.
    #[doc(alias = "ME-106")]
    #[doc(alias = "ME-117")]
    #[rustfmt::skip]
    pub fn change(&self) -> Counts {
        let counts = |[v, e, f, h, c, g]: [i64; 6]| Counts { v, e, f, h, c, g };
        counts(match self {     //  V   E   F   H   C   G
            Operator::Mvfs { .. } => [1, 0, 1, 0, 1, 0],
            Operator::Kvfs { .. } => [-1, 0, -1, 0, -1, 0],
            Operator::Mev { .. } => [1, 1, 0, 0, 0, 0],
            Operator::Kev { .. } => [-1, -1, 0, 0, 0, 0],
            Operator::Mef { .. } => [0, 1, 1, 0, 0, 0],
            Operator::Kef { .. } => [0, -1, -1, 0, 0, 0],
            Operator::Kemr { .. } => [0, -1, 0, 1, 0, 0],
            Operator::Mekr { .. } => [0, 1, 0, -1, 0, 0],
            Operator::Kfmrh { .. } => [0, 0, -1, 1, 0, 1],
            Operator::Mfkrh { .. } => [0, 0, 1, -1, 0, -1],
            Operator::Ksfmr { .. } => [0, 0, -1, 1, -1, 0],
            Operator::Msfkr { .. } => [0, 0, 1, -1, 1, 0],
        })
    }

    /// Whether it changes the surface: local operators are mev, mef, kemr and their inverses (ME-110), which make no torus
    /// of a sphere (ME-112); of the global ones, kfmrh and mfkrh change G by one and the others C (ME-111).
    #[doc(alias = "ME-110")]
    #[doc(alias = "ME-112")]
    #[doc(alias = "ME-111")]
    pub fn scope(&self) -> Scope {
        match self.change() {
            Counts { c: 0, g: 0, .. } => Scope::Local,
            Counts { .. } => Scope::Global,
        }
    }
}

/// A precondition that an operator does not meet. The boundary is as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Error)]
pub enum Refused {
    /// It names something that does not exist.
    #[error("there is no {0}")]
    NoSuch(Name),
    /// It would make something of a name that is taken.
    #[error("{0} exists already")]
    Taken(Name),
    /// It takes a vertex for a loop without edges, but the vertex has edges.
    #[error("{name} has edges", name = Name::Vertex(*.0))]
    NotAlone(VertexId),
    /// A span between two half-edges that are the same.
    #[error("a span from {name} to itself is either nothing or all", name = Name::HalfEdge(*.0))]
    EmptySpan(HalfEdge),
    /// mev: the half-edges do not begin at one vertex.
    #[error("half-edges {a} and {b} do not begin at one vertex", a = .0.0, b = .1.0)]
    TwoVertices(HalfEdge, HalfEdge),
    /// mef, kemr: the half-edges are not in one loop.
    #[error("half-edges {a} and {b} are not in one loop", a = .0.0, b = .1.0)]
    TwoLoops(HalfEdge, HalfEdge),
    /// kev: the edge leads back to its vertex.
    #[error("{name} ends where it begins", name = Name::HalfEdge(*.0))]
    ClosedEdge(HalfEdge),
    /// kef: both sides of the edge are one face; kfmrh, ksfmr: a face into itself.
    #[error("it takes two faces, but both are {name}", name = Name::Face(*.0))]
    OneFace(FaceId),
    /// mekr: both corners are in one loop.
    #[error("it takes two loops, but both are {name}", name = Name::Loop(*.0))]
    OneLoop(LoopId),
    /// mekr: the loops belong to different faces.
    #[error("loops {a} and {b} are of different faces", a = .0.0, b = .1.0)]
    TwoFaces(LoopId, LoopId),
    /// kef: the loop that would be killed is not its face's outer one.
    #[error("{name} is a ring", name = Name::Loop(*.0))]
    IsRing(LoopId),
    /// mekr, mfkrh, msfkr: the loop that should be a ring is its face's outer one.
    #[error("{name} is the outer loop of its face", name = Name::Loop(*.0))]
    IsOuter(LoopId),
    /// mef: a ring that should go to the new face is not a ring of the old one, or it is the loop that is divided.
    #[error("{name} is no ring of the face besides the divided loop", name = Name::Loop(*.0))]
    NotToMove(LoopId),
    /// kfmrh, ksfmr: the face that would be killed has rings.
    #[error("{name} has rings", name = Name::Face(*.0))]
    HasRings(FaceId),
    /// ksfmr: the faces are of one shell.
    #[error("both faces are of {name}", name = Name::Shell(*.0))]
    OneShell(ShellId),
    /// kfmrh: the faces are of different shells.
    #[error("the faces are of shells {a} and {b}", a = .0.0, b = .1.0)]
    TwoShells(ShellId, ShellId),
    /// mfkrh: without the ring its shell is not connected.
    #[error("without {name} its shell would fall in two", name = Name::Loop(*.0))]
    Divides(LoopId),
    /// msfkr: without the ring its shell is still connected.
    #[error("without {name} its shell would stay connected", name = Name::Loop(*.0))]
    DoesNotDivide(LoopId),
    /// kvfs: the shell is more than a face and a vertex.
    #[error("{name} is more than a face and a vertex", name = Name::Shell(*.0))]
    NotASingleVertex(ShellId),
}

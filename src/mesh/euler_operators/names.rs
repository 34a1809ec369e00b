//! The names of a boundary's elements.

use std::fmt::{self, Display, Formatter};

/// A vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexId(pub u32);

/// One side of an edge: an edge has the half-edges 2k and 2k + 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct HalfEdge(pub u32);

/// A loop of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LoopId(pub u32);

/// A face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FaceId(pub u32);

/// A shell: a connected component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ShellId(pub u32);

impl HalfEdge {
    /// The other half-edge of its edge.
    pub fn mate(self) -> HalfEdge {
        HalfEdge(self.0 ^ 1)
    }
}

/// The name of an element of any kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Name {
    /// A vertex.
    Vertex(VertexId),
    /// A half-edge.
    HalfEdge(HalfEdge),
    /// A loop.
    Loop(LoopId),
    /// A face.
    Face(FaceId),
    /// A shell.
    Shell(ShellId),
}

impl Display for Name {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Name::Vertex(v) => write!(f, "vertex {}", v.0),
            Name::HalfEdge(h) => write!(f, "half-edge {}", h.0),
            Name::Loop(l) => write!(f, "loop {}", l.0),
            Name::Face(face) => write!(f, "face {}", face.0),
            Name::Shell(s) => write!(f, "shell {}", s.0),
        }
    }
}

//! Faces by vertex numbers: an outer loop and the loops of holes.

use super::triangles::EdgeKey;

/// A polygon with holes. Its loops are closed implicitly: after its last vertex a loop goes back to its first. Nothing is
/// promised: a loop may be empty, or name a vertex twice, or one that does not exist.
///
/// Seen from outside the solid, the outer loop runs counterclockwise and the holes clockwise.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Face {
    /// The outer loop.
    pub outer: Vec<u32>,
    /// The loops of the holes.
    pub holes: Vec<Vec<u32>>,
}

impl Face {
    /// A face without holes.
    pub fn new(outer: impl Into<Vec<u32>>) -> Face {
        Face { outer: outer.into(), holes: Vec::new() }
    }

    /// Its loops, the outer one first.
    pub fn loops(&self) -> impl Iterator<Item = &[u32]> {
        std::iter::once(&self.outer[..]).chain(self.holes.iter().map(|hole| &hole[..]))
    }

    /// The vertices of all its loops, in order.
    pub fn vertices(&self) -> impl Iterator<Item = u32> {
        self.loops().flatten().copied()
    }

    /// The directed sides of all its loops, in order.
    pub fn sides(&self) -> impl Iterator<Item = [u32; 2]> {
        self.loops().flat_map(sides)
    }

    /// The face seen from its other side: every loop backwards, beginning with the same vertex (ME-38).
    #[doc(alias = "ME-38")]
    pub fn reversed(&self) -> Face {
        let back = |l: &[u32]| l.iter().take(1).chain(l.iter().skip(1).rev()).copied().collect();
        Face { outer: back(&self.outer), holes: self.holes.iter().map(|hole| back(hole)).collect() }
    }
}

impl<const N: usize> From<[u32; N]> for Face {
    fn from(outer: [u32; N]) -> Face {
        Face::new(outer)
    }
}

/// The directed sides of a loop, from each vertex to the next, and from the last to the first (ME-11): as many as it has
/// vertices. A loop of one vertex has the side from it to itself, one of two vertices both directions of its edge.
#[doc(alias = "ME-11")]
pub fn sides(vertices: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    (0..vertices.len()).map(|i| [vertices[i], vertices[(i + 1) % vertices.len()]])
}

/// The undirected edge of a side.
pub fn edge([a, b]: [u32; 2]) -> EdgeKey {
    [a.min(b), a.max(b)]
}

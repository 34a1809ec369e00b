//! Fans, components, orientation: everything that is joined.

use super::edges::{FaceOf, Side, Uses};
use super::polygons::Polygons;
use crate::mesh::triangles::EdgeKey;
use crate::partition::Partition;

/// The corners of a mesh, joined where two at one vertex have a neighbour of it in common.
pub struct Fans {
    corners: Partition,
    /// By vertex: its corners in loops where it has a neighbour, less the joins that have made two of their sets one.
    count: Vec<u32>,
}

impl Fans {
    /// Before any join.
    pub fn new(mesh: &Polygons) -> Fans {
        let mut fans = Fans { corners: Partition::new(mesh.corners().len()), count: vec![0; mesh.vertices().len()] };
        let mut start = 0;
        for face in mesh.loops() {
            // A loop of one vertex alone, however often, has no neighbours; a vertex that follows itself makes one corner.
            if face.iter().any(|&v| v != face[0]) {
                for (i, &v) in face.iter().enumerate() {
                    fans.count[v as usize] += 1;
                    let after = if i + 1 == face.len() { 0 } else { i + 1 };
                    if face[after] == v {
                        fans.count[v as usize] -= u32::from(fans.corners.join(start + i, start + after));
                    }
                }
            }
            start += face.len();
        }
        fans
    }

    /// Joins the corners at either end of an edge.
    pub fn join(&mut self, [a, b]: EdgeKey, uses: &[Side]) {
        let at = |side: &Side, low: bool| if side.up == low { side.corner } else { side.next };
        for (vertex, low) in [(a, true), (b, false)] {
            for pair in uses.windows(2) {
                let (s, t) = (at(&pair[0], low), at(&pair[1], low));
                self.count[vertex as usize] -= u32::from(self.corners.join(s as usize, t as usize));
            }
        }
    }

    /// The vertices whose link graph has more than one component. ME-151.
    ///
    /// The neighbours of a vertex in one component of its link are those of one set of corners: the number of
    /// components is the number of corners less the number of joins that have changed anything.
    #[doc(alias = "ME-151")]
    pub fn nonmanifold(&self) -> impl Iterator<Item = u32> {
        (0..).zip(&self.count).filter(|&(_, &count)| count > 1).map(|(vertex, _)| vertex)
    }
}

/// Whether flips of faces can make every two-use edge opposite.
///
/// Each face is two nodes, as it is and flipped; an edge joins those of its two faces that agree along it. A choice
/// exists iff no face is in one set with its flip.
pub fn orientable(mesh: &Polygons, faces: &FaceOf, uses: &Uses) -> bool {
    let n = mesh.faces();
    let mut nodes = Partition::new(2 * n);
    uses.for_each(mesh, faces, |_, sides| {
        if let [s, t] = sides {
            let differ = usize::from(s.up == t.up);
            let (f, g) = (2 * s.face as usize, 2 * t.face as usize);
            nodes.join(f, g + differ);
            nodes.join(f + 1, g + 1 - differ);
        }
    });
    (0..n).all(|f| nodes.find(2 * f) != nodes.find(2 * f + 1))
}

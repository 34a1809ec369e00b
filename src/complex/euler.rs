//! χ of a closed 3-complex, by what stands around its vertices.

use super::closed_complex::ClosedComplex;
use super::triangulation::Triangulation;
use crate::mesh::classify::ClosedSurface;

impl ClosedComplex {
    /// χ = Σ (1 − χ(link v)/2) over the vertices (CX-69): 0 iff all links are
    /// spheres (CX-70).
    #[doc(alias = "CX-69")]
    #[doc(alias = "CX-70")]
    pub fn euler_characteristic_by_links(&self) -> i64 {
        by_links(&self.vertex_links(), 0)
    }
}

impl Triangulation {
    /// χ = V − E + F − T, cells counted as classes: an edge that is glued to itself, tail to head, counts 1.
    pub fn euler_characteristic(&self) -> i64 {
        let [v, e, f, t] = self.skeleton().counts.map(|n| n as i64);
        v - e + f - t
    }

    /// χ = Σ (1 − χ(link v)/2) − r/2 over the vertices, where r edges are glued to themselves, tail to head (CX-69).
    #[doc(alias = "CX-69")]
    pub fn euler_characteristic_by_links(&self) -> i64 {
        by_links(&self.vertex_links(), self.reversed_edges().len())
    }
}

/// (Σ (2 − χ(link)) − r)/2.
fn by_links(links: &[ClosedSurface], reversed: usize) -> i64 {
    let twice = links.iter().map(|link| 2 - link.euler_characteristic()).sum::<i64>() - reversed as i64;
    assert!(twice % 2 == 0, "the cells at the vertices come in twos");
    twice / 2
}

//! What keeps a closed 3-manifold out of ℝ⁴.

use super::closed_complex::ClosedComplex;
use super::manifold::Manifold3;
use super::scheme::{FaceId, GluingScheme};
use crate::number::Integer;
use crate::partition::Partition;

/// A reason why a closed 3-manifold has no embedding in ℝ⁴.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum R4Obstruction {
    /// A component is not orientable: a closed hypersurface of ℝ⁴ has an inside and an outside.
    NonOrientable {
        /// A polyhedron of the component.
        polyhedron: usize,
    },
    /// The torsion of H₁ of a component is no A ⊕ A (Hantzsche's theorem).
    Torsion {
        /// A polyhedron of the component.
        polyhedron: usize,
        /// Its torsion coefficients t₁ | t₂ | …
        torsion: Vec<Integer>,
    },
}

/// The first component that cannot lie in ℝ⁴, and why. `None` is no promise: Poincaré's sphere has no obstruction of this kind,
/// and no piecewise linear embedding.
///
/// Hantzsche (1938): if a closed orientable 3-manifold M lies in S⁴, locally flat, then the torsion of H₁(M) is A ⊕ A. Every closed
/// 3-manifold embeds in ℝ⁵ (Hirsch; Wall 1965; Rokhlin), and is immersed in ℝ⁴.
#[doc(alias = "CX-89")]
pub fn r4_obstruction(manifold: &Manifold3) -> Option<R4Obstruction> {
    components(manifold.scheme()).into_iter().find_map(|(polyhedron, scheme)| {
        let component = ClosedComplex::new(scheme).expect("a component of a closed complex is one");
        if !component.is_orientable() {
            return Some(R4Obstruction::NonOrientable { polyhedron });
        }
        let h1 = component.first_homology();
        (!h1.torsion_is_double()).then_some(R4Obstruction::Torsion { polyhedron, torsion: h1.torsion })
    })
}

/// The connected parts of a scheme without defects, each with its first polyhedron.
fn components(scheme: &GluingScheme) -> Vec<(usize, GluingScheme)> {
    let mut parts = Partition::new(scheme.polyhedra.len());
    scheme.pairings.iter().for_each(|pairing| {
        parts.join(pairing.a.polyhedron, pairing.b.polyhedron);
    });
    let part_of: Vec<usize> = (0..scheme.polyhedra.len()).map(|i| parts.find(i)).collect();
    let firsts = (0..part_of.len()).filter(|i| part_of[*i] == *i);
    firsts
        .map(|first| {
            let members: Vec<usize> = (0..part_of.len()).filter(|i| part_of[*i] == first).collect();
            let number = |polyhedron| members.binary_search(&polyhedron).expect("faces of one part are glued");
            let renamed = |id: FaceId| FaceId { polyhedron: number(id.polyhedron), face: id.face };
            let pairings = scheme.pairings.iter().filter(|pairing| part_of[pairing.a.polyhedron] == first);
            let pairings =
                pairings.map(|p| super::scheme::Pairing { a: renamed(p.a), b: renamed(p.b), ..*p }).collect();
            let polyhedra = members.iter().map(|i| scheme.polyhedra[*i].clone()).collect();
            (first, GluingScheme { polyhedra, pairings })
        })
        .collect()
}

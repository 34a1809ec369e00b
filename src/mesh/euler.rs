//! Euler and Poincaré's formula for polygon meshes with holes in their faces: V − E + F − H = 2(C − G).

use super::face::{self, Face};
use super::gluing::{FaceError, Sheets, check_loops};
use super::triangles::EdgeKey;
use crate::number::Rational;
use crate::partition::Partition;
use std::collections::{BTreeMap, BTreeSet};

/// What the formula counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EulerPoincare {
    /// V, the vertices that faces have.
    pub vertices: i64,
    /// E, the edges: unordered pairs of vertices that are a side of a face.
    pub edges: i64,
    /// F, the faces.
    pub faces: i64,
    /// H, the loops of faces but the outer ones.
    pub holes: i64,
    /// C, the connected components of the surface (its shells), not of the solid within.
    pub shells: i64,
}

impl EulerPoincare {
    /// The counts of a mesh.
    ///
    /// # Errors
    /// Iff a loop has fewer than three vertices, or a side from a vertex to itself.
    #[doc(alias = "ME-81")]
    pub fn of(faces: &[Face]) -> Result<EulerPoincare, FaceError> {
        check_loops(faces)?;
        let vertices: BTreeSet<u32> = faces.iter().flat_map(Face::vertices).collect();
        let numbers: BTreeMap<u32, usize> = vertices.iter().copied().zip(0..).collect();
        let edges: BTreeSet<EdgeKey> = faces.iter().flat_map(Face::sides).map(face::edge).collect();
        let mut parts = Partition::new(vertices.len());
        let joined = faces
            .iter()
            .flat_map(|face| face.vertices().map(|v| [face.outer[0], v]))
            .filter(|[a, b]| parts.join(numbers[a], numbers[b]))
            .count();
        Ok(EulerPoincare {
            vertices: vertices.len() as i64,
            edges: edges.len() as i64,
            faces: faces.len() as i64,
            holes: faces.iter().map(|face| face.holes.len() as i64).sum(),
            shells: (vertices.len() - joined) as i64,
        })
    }

    /// V − E + F, Euler's number of the texts: χ iff every face is a disc (ME-75).
    #[doc(alias = "ME-75")]
    pub fn euler_number(&self) -> i64 {
        self.vertices - self.edges + self.faces
    }

    /// χ = V − E + F − H: a face with h holes adds 1 − h (ME-90).
    #[doc(alias = "ME-90")]
    pub fn characteristic(&self) -> i64 {
        self.euler_number() - self.holes
    }

    /// G = C − χ/2, which the formula wants: in a closed surface the genera of the components summed, half a handle for
    /// each cross-cap. It is an integer ≥ 0 for every closed orientable surface; no integer where the number of cross-caps is
    /// odd (ME-102). Other meshes have one too, and it means nothing.
    #[doc(alias = "ME-102")]
    pub fn genus(&self) -> Rational {
        Rational::from(self.shells) - Rational::from((self.characteristic(), 2))
    }
}

/// FP of the text's formula: the faces that have holes, however many (ME-92).
#[doc(alias = "ME-92")]
pub fn faces_with_holes(faces: &[Face]) -> i64 {
    faces.iter().filter(|face| !face.holes.is_empty()).count() as i64
}

/// The terms of V − E + F − H = 2(S − G) − B − P, which holds for every mesh whose edges have at most two sides (ME-103).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias = "ME-103")]
pub struct Balance {
    /// V, E, F, H, C.
    pub counts: EulerPoincare,
    /// S, how many surfaces the faces make, glued along edges only; C or more.
    pub sheets: i64,
    /// 2G, twice the handles and once the cross-caps of all sheets.
    pub twice_genus: i64,
    /// B, the loops of the border.
    pub boundary_loops: i64,
    /// P, how many fans of faces there are at vertices beyond the first at each.
    pub pinches: i64,
}

impl Balance {
    /// The terms for a mesh, 2G by the normal form of each sheet's word, which counts no vertices.
    ///
    /// # Errors
    /// Iff its faces cannot be glued along their edges ([`Sheets::new`]).
    #[doc(alias = "ME-88")]
    pub fn of(faces: &[Face]) -> Result<Balance, FaceError> {
        let sheets = Sheets::new(faces)?;
        let words = sheets.gluing.words();
        let forms = words.iter().map(|word| super::word::normal_form(word));
        Ok(Balance {
            counts: EulerPoincare::of(faces)?,
            sheets: words.len() as i64,
            twice_genus: forms.map(|form| (2 * form.handles + form.crosscaps) as i64).sum(),
            boundary_loops: sheets.gluing.boundary().len() as i64,
            pinches: sheets.pinches().values().map(|fans| *fans as i64 - 1).sum(),
        })
    }

    /// 2(S − G) − B − P.
    pub fn right_side(&self) -> i64 {
        2 * self.sheets - self.twice_genus - self.boundary_loops - self.pinches
    }

    /// Whether the mesh is a closed surface, the formula's domain: no border and no pinches (ME-91). It may be one-sided.
    #[doc(alias = "ME-91")]
    pub fn is_closed_surface(&self) -> bool {
        self.boundary_loops == 0 && self.pinches == 0
    }
}

//! Compact surfaces by their numbers: sides, genus or cross-caps, loops of the border.

use super::face::Face;
use super::gluing::{FaceError, Gluing, GluingError, Sheets, Side};
use super::manifold::{Dimension, ManifoldDefect, manifold_defects};
use super::simplicial::SimplicialComplex;
use super::word::NormalForm;
use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};
use thiserror::Error;

/// A closed connected surface, up to homeomorphism (ME-130).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[doc(alias = "ME-130")]
pub enum ClosedSurface {
    /// A sphere with so many handles.
    Orientable {
        /// How many.
        genus: usize,
    },
    /// A sphere with so many discs, at least one, replaced by Möbius bands.
    NonOrientable {
        /// How many.
        crosscaps: usize,
    },
}

/// A compact connected surface, up to homeomorphism: a closed one less so many open discs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Surface {
    /// With a disc glued into each loop of the border.
    pub closed: ClosedSurface,
    /// How many loops the border has.
    pub boundary_loops: usize,
}

/// The sphere.
pub const SPHERE: ClosedSurface = ClosedSurface::Orientable { genus: 0 };

impl ClosedSurface {
    /// χ = 2 − 2g with g handles, 2 − k with k cross-caps (ME-134).
    #[doc(alias = "ME-134")]
    pub fn euler_characteristic(self) -> i64 {
        match self {
            ClosedSurface::Orientable { genus } => 2 - 2 * genus as i64,
            ClosedSurface::NonOrientable { crosscaps } => 2 - crosscaps as i64,
        }
    }

    /// The connected sum: handles and cross-caps add; beside a cross-cap a handle is two cross-caps (ME-136).
    #[doc(alias = "ME-136")]
    pub fn sum(self, other: ClosedSurface) -> ClosedSurface {
        use ClosedSurface::{NonOrientable, Orientable};
        match (self, other) {
            (Orientable { genus: a }, Orientable { genus: b }) => Orientable { genus: a + b },
            (NonOrientable { crosscaps }, Orientable { genus })
            | (Orientable { genus }, NonOrientable { crosscaps }) => NonOrientable { crosscaps: crosscaps + 2 * genus },
            (NonOrientable { crosscaps: a }, NonOrientable { crosscaps: b }) => NonOrientable { crosscaps: a + b },
        }
    }
}

impl Surface {
    /// χ = that of the closed surface − b with b loops of the border.
    pub fn euler_characteristic(self) -> i64 {
        self.closed.euler_characteristic() - self.boundary_loops as i64
    }
}

impl From<NormalForm> for ClosedSurface {
    fn from(NormalForm { handles, crosscaps }: NormalForm) -> ClosedSurface {
        match crosscaps {
            0 => ClosedSurface::Orientable { genus: handles },
            _ => ClosedSurface::NonOrientable { crosscaps: crosscaps + 2 * handles },
        }
    }
}

impl Display for Surface {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match (self.closed, self.boundary_loops) {
            (ClosedSurface::Orientable { genus: 0 }, 1) => return f.write_str("disc"),
            (ClosedSurface::Orientable { genus: 0 }, 2) => return f.write_str("annulus"),
            (ClosedSurface::NonOrientable { crosscaps: 1 }, 1) => return f.write_str("Möbius band"),
            (ClosedSurface::Orientable { genus: 0 }, _) => f.write_str("sphere")?,
            (ClosedSurface::Orientable { genus: 1 }, _) => f.write_str("torus")?,
            (ClosedSurface::Orientable { genus }, _) => write!(f, "sphere with {genus} handles")?,
            (ClosedSurface::NonOrientable { crosscaps: 1 }, _) => f.write_str("projective plane")?,
            (ClosedSurface::NonOrientable { crosscaps: 2 }, _) => f.write_str("Klein bottle")?,
            (ClosedSurface::NonOrientable { crosscaps }, _) => write!(f, "sphere with {crosscaps} cross-caps")?,
        }
        match self.boundary_loops {
            0 => Ok(()),
            1 => f.write_str(" less a disc"),
            b => write!(f, " less {b} discs"),
        }
    }
}

impl Gluing {
    /// What its components are, in the order of their first polygons: by χ, the loops of the border, and whether it can be
    /// oriented. Two surfaces are homeomorphic iff they have the same list, sorted (ME-133).
    #[doc(alias = "ME-133")]
    pub fn surfaces(&self) -> Vec<Surface> {
        let surface = |component: &Gluing| {
            let boundary_loops = component.boundary().len();
            let missing = 2 - (component.euler_characteristic() + boundary_loops as i64);
            let missing = usize::try_from(missing).expect("a connected closed surface has χ ≤ 2");
            let closed = match component.is_orientable() {
                true => ClosedSurface::Orientable { genus: missing / 2 },
                false => ClosedSurface::NonOrientable { crosscaps: missing },
            };
            Surface { closed, boundary_loops }
        };
        self.components().iter().map(surface).collect()
    }
}

/// Why a mesh is no surface.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NoSurface {
    /// Its faces cannot be glued along their edges.
    #[error(transparent)]
    Face(#[from] FaceError),
    /// At vertices, several fans of faces meet.
    #[error("{} vertices have several fans of faces; the first one is {}", .0.len(), .0.keys().next().copied().unwrap_or(0))]
    Pinched(BTreeMap<u32, usize>),
}

/// What the components of a mesh are, in the order of their first faces.
///
/// # Errors
/// Iff the faces cannot be glued ([`Sheets::new`]), or a vertex has several fans of them.
#[doc(alias = "ME-84")]
pub fn mesh_surfaces(faces: &[Face]) -> Result<Vec<Surface>, NoSurface> {
    let sheets = Sheets::new(faces)?;
    match sheets.pinches() {
        pinches if pinches.is_empty() => Ok(sheets.gluing.surfaces()),
        pinches => Err(NoSurface::Pinched(pinches)),
    }
}

/// The triangles of a complex, glued along their common edges. Whatever else it has is left out.
///
/// # Errors
/// Iff an edge has more than two triangles.
pub fn glued_triangles(complex: &SimplicialComplex) -> Result<Gluing, GluingError> {
    let edges: BTreeMap<&[u32], u32> = complex.of_dimension(1).map(|e| e.vertices()).zip(0..).collect();
    let polygon = |t: &[u32]| {
        let side = |ends: &[u32], forward: bool| Side { edge: edges[ends], forward };
        vec![side(&t[..2], true), side(&t[1..], true), side(&[t[0], t[2]], false)]
    };
    Gluing::new(complex.of_dimension(2).map(|t| polygon(t.vertices())).collect())
}

/// What the components of a complex are, in the order of their first triangles.
///
/// # Errors
/// Iff it is no surface with border; with all its defects.
pub fn surfaces(complex: &SimplicialComplex) -> Result<Vec<Surface>, Vec<ManifoldDefect>> {
    match manifold_defects(complex, Dimension::Two) {
        defects if defects.is_empty() => {
            Ok(glued_triangles(complex).expect("an edge of a surface has one or two triangles").surfaces())
        }
        defects => Err(defects),
    }
}

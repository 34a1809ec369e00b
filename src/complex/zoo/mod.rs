//! A zoo of closed 3-manifolds by name, with what is known of each, and one of schemes that are none ([`invalid`]).
//!
//! The same schemes stand as text in the folder `zoo/`.

mod bundle;
mod convex;
mod cubical;
pub mod invalid;
mod other_spaces;
mod simplices;
mod solids;
mod spherical;

pub use simplices::of_triangulation;

use super::abelian::AbelianGroup;
use super::scheme::GluingScheme;
use crate::number::Integer;

/// A manifold as a scheme, with what the literature says of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Specimen {
    /// Its name here.
    pub name: &'static str,
    /// The space, up to homeomorphism.
    pub space: &'static str,
    /// How it is glued, and whose it is.
    pub about: &'static str,
    /// V, E, F, P.
    pub cells: [usize; 4],
    /// Whether it is orientable.
    pub orientable: bool,
    /// H₁ over ℤ.
    pub h1: AbelianGroup,
    /// The scheme.
    pub scheme: GluingScheme,
}

/// A line of the table: a specimen before it is built.
struct Row {
    name: &'static str,
    space: &'static str,
    about: &'static str,
    known: Known,
    scheme: fn() -> GluingScheme,
}

/// V, E, F, P; whether it is orientable; rank and torsion of H₁.
struct Known {
    cells: [usize; 4],
    orientable: bool,
    rank: usize,
    torsion: &'static [u32],
}

const fn row(
    name: &'static str,
    space: &'static str,
    about: &'static str,
    known: Known,
    scheme: fn() -> GluingScheme,
) -> Row {
    Row { name, space, about, known, scheme }
}

/// Orientable.
const fn two_sided(cells: [usize; 4], rank: usize, torsion: &'static [u32]) -> Known {
    Known { cells, orientable: true, rank, torsion }
}

/// Not orientable.
const fn one_sided(cells: [usize; 4], rank: usize, torsion: &'static [u32]) -> Known {
    Known { cells, orientable: false, rank, torsion }
}

impl Row {
    fn specimen(&self) -> Specimen {
        let Row { name, space, about, known: Known { cells, orientable, rank, torsion }, scheme } = *self;
        let h1 = AbelianGroup { rank, torsion: torsion.iter().copied().map(Integer::from).collect() };
        Specimen { name, space, about, cells, orientable, h1, scheme: scheme() }
    }
}

/// The names of all specimens, in the order of the table: spheres, projective and lens spaces, other spherical ones, flat ones,
/// bundles, sums, hyperbolic ones, such in several components.
pub fn names() -> Vec<&'static str> {
    rows().map(|row| row.name).collect()
}

/// The specimen of that name. `None` iff there is none.
#[doc(alias = "CX-8")]
pub fn get(name: &str) -> Option<Specimen> {
    rows().find(|row| row.name == name).map(Row::specimen)
}

fn rows() -> impl Iterator<Item = &'static Row> {
    let spherical = [spherical::SPHERES, spherical::PROJECTIVE_AND_LENS, spherical::SPHERICAL];
    let others = [other_spaces::FLAT, other_spaces::BUNDLES, other_spaces::SUMS, other_spaces::OTHERS];
    spherical.into_iter().chain(others).flatten()
}

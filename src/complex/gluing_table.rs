//! Triangulations as tables: that of Regina's long description, and plain arrays, as files have them.

use super::permutation::Perm4;
use super::triangulation::{TriangleGluing, Triangulation, TriangulationError};
use std::fmt::{self, Display, Formatter, Write};
use thiserror::Error;

/// Why a table is no closed triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum TableError {
    /// Four numbers that are not 0, 1, 2, 3 in some order.
    #[error("triangle {triangle} of tetrahedron {tetrahedron}: {images:?} are not 0, 1, 2, 3 in some order")]
    NoPermutation {
        /// The tetrahedron.
        tetrahedron: usize,
        /// The triangle.
        triangle: usize,
        /// What stands there.
        images: [u8; 4],
    },
    /// The gluings do not fit one another.
    #[error(transparent)]
    Gluings(#[from] TriangulationError),
}

impl Triangulation {
    /// The triangulation in which triangle i of a tetrahedron is glued to that of another, its corner j to corner images\[i\]\[j\],
    /// as rows (others, images).
    ///
    /// # Errors
    /// Iff images are no permutation, or the gluings do not fit one another ([`Triangulation::new`]).
    #[doc(alias = "CX-96")]
    pub fn of_rows(rows: impl IntoIterator<Item = ([u32; 4], [[u8; 4]; 4])>) -> Result<Triangulation, TableError> {
        let mut gluings = Vec::new();
        for (tetrahedron, (others, images)) in rows.into_iter().enumerate() {
            let mut triangles = [TriangleGluing { tetrahedron: 0, corners: Perm4::IDENTITY }; 4];
            for (triangle, gluing) in triangles.iter_mut().enumerate() {
                let images = images[triangle];
                let corners = Perm4::new(images).ok_or(TableError::NoPermutation { tetrahedron, triangle, images })?;
                *gluing = TriangleGluing { tetrahedron: others[triangle], corners };
            }
            gluings.push(triangles);
        }
        Ok(Triangulation::new(gluings)?)
    }

    /// The rows (others, images) that [`Triangulation::of_rows`] takes.
    pub fn rows(&self) -> impl Iterator<Item = ([u32; 4], [[u8; 4]; 4])> + '_ {
        self.gluings().iter().map(|triangles| {
            (triangles.map(|g| g.tetrahedron), triangles.map(|g| g.corners.images().map(|image| image as u8)))
        })
    }
}

/// The table of a triangulation's gluings, as Regina's long description has it: a row a tetrahedron; for each of its triangles,
/// named by its corners, the tetrahedron across it and which of its corners they are.
#[derive(Clone, Copy, Debug)]
#[doc(alias = "CX-95")]
pub struct GluingTable<'a>(pub &'a Triangulation);

/// The corners of triangles 3, 2, 1, 0.
const TRIANGLES: [[usize; 3]; 4] = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];

impl Display for GluingTable<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("  Tet  |  gluing:       (012)       (013)       (023)       (123)\n")?;
        f.write_str("  -----+---------------------------------------------------------\n")?;
        for (tetrahedron, triangles) in self.0.gluings().iter().enumerate() {
            write!(f, "{tetrahedron:>5}  |         ")?;
            for corners in TRIANGLES {
                // The triangle lies opposite the corner that is left, and 0 + 1 + 2 + 3 = 6.
                let gluing = triangles[6 - corners.iter().sum::<usize>()];
                let [a, b, c] = corners.map(|corner| gluing.corners.image(corner));
                write!(f, "{:>6} ({a}{b}{c})", gluing.tetrahedron)?;
            }
            f.write_char('\n')?;
        }
        Ok(())
    }
}

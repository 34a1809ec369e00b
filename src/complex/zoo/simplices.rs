//! Closed triangulations as schemes of tetrahedra.

use super::super::permutation::Perm4;
use super::super::scheme::{GluingScheme, Polyhedron};
use super::super::triangulation::{TriangleGluing, Triangulation};
use super::convex::by_corners;

/// The faces of [`Polyhedron::tetrahedron`], opposite its vertices.
const FACES: [[u32; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// The triangulation as tetrahedra whose faces are paired: faces and corners have their numbers.
pub fn of_triangulation(triangulation: &Triangulation) -> GluingScheme {
    let mut pairings = Vec::new();
    for (t, gluings) in triangulation.gluings().iter().enumerate() {
        for (face, TriangleGluing { tetrahedron, corners }) in gluings.iter().enumerate() {
            let (other, there) = (*tetrahedron as usize, corners.image(face));
            if (t, face) < (other, there) {
                let images = FACES[face].map(|v| corners.image(v as usize) as u32);
                pairings.push(by_corners([t, face], [other, there], &FACES[there], &images));
            }
        }
    }
    GluingScheme { polyhedra: vec![Polyhedron::tetrahedron(); triangulation.len()], pairings }
}

/// The triangulation written as `tetrahedron:images` for triangle 0, 1, 2, 3 of each tetrahedron, in order.
pub(super) fn written(table: &str) -> GluingScheme {
    let gluing = |word: &str| {
        let (tetrahedron, images) = word.split_once(':').expect("a gluing has a colon");
        let images: Vec<u8> = images.bytes().map(|digit| digit - b'0').collect();
        let corners = images.try_into().ok().and_then(Perm4::new).expect("a permutation");
        TriangleGluing { tetrahedron: tetrahedron.parse().expect("a number"), corners }
    };
    let words: Vec<TriangleGluing> = table.split_whitespace().map(gluing).collect();
    let (rows, _) = words.as_chunks::<4>();
    of_triangulation(&Triangulation::new(rows.to_vec()).expect("the gluings undo one another"))
}

/// The manifold of the least volume, 0.9427…, found by Weeks and by Matveev and Fomenko: nine tetrahedra.
pub(super) const WEEKS: &str = "0:1230 0:3012 1:3201 2:2310  0:2310 3:1023 4:1302 5:2310  0:3201 3:0132 4:0213 6:1230
    1:1023 2:0132 5:2310 7:2310  1:2031 2:0213 7:0213 8:2310  1:3201 3:3201 6:0213 8:3201  2:3012 5:0213 8:1023 7:2103
    3:3201 4:0213 8:1230 6:2103  4:3201 5:2310 6:1023 7:3012";

/// A hyperbolic manifold that is not orientable, of volume 2.0298…: eleven tetrahedra.
pub(super) const M018: &str = "8:1320 2:0321 8:2103 2:3102  5:3012 3:3102 2:2103 9:1032  1:2103 4:3120 0:2130 0:0321
    6:2130 1:2130 4:2031 6:0321  10:2103 2:3120 10:3210 3:1302  7:3120 7:1032 6:0132 1:1230  8:2103 3:0321 3:3102 5:0132
    5:1032 9:0321 8:0132 5:3120  0:2103 0:3021 6:2103 7:0132  10:3120 10:2013 1:1032 7:0321  9:1203 4:3210 4:2103 9:3120";

/// Poincaré's sphere in five tetrahedra.
pub(super) const POINCARE: &str =
    "1:0321 2:3012 3:3201 4:3120  0:0321 2:2103 4:2310 3:2031  0:1230 1:2103 3:1230 4:3012
    0:2310 1:1302 4:1230 2:3012  0:3120 1:3201 2:1230 3:3012";

/// S² × S¹ in two tetrahedra.
pub(super) const S2_X_S1: &str = "0:3012 1:0123 1:0123 0:1230  1:3012 0:0123 0:0123 1:1230";

/// RP² × S¹ in three tetrahedra.
pub(super) const RP2_X_S1: &str =
    "1:0123 2:2301 1:1230 2:2301  0:0123 2:3012 2:0123 0:3012  1:1230 0:2301 1:0123 0:2301";

/// S³, L(4, 1) and L(5, 2) in one tetrahedron each.
pub(super) const ONE_TETRAHEDRON: [&str; 3] =
    ["0:1230 0:3012 0:0132 0:0132", "0:1230 0:3012 0:1230 0:3012", "0:1230 0:3012 0:2031 0:1302"];

/// Gieseking's manifold, its cusp made a vertex: no closed manifold, for a Klein bottle stands around it.
pub(super) const GIESEKING: &str = "0:1203 0:2013 0:0231 0:0312";

/// The figure-eight knot's complement, its cusp made a vertex: a torus stands around it.
pub(super) const FIGURE_EIGHT: &str = "1:1302 1:2031 1:0321 1:2103  0:1302 0:2031 0:0321 0:2103";

/// Two tetrahedra with one vertex, around which stands a surface of genus two.
pub(super) const GENUS_TWO: &str = "1:0123 1:0231 1:1032 1:3021  0:0123 0:1320 0:0312 0:1032";

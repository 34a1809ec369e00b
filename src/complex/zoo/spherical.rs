//! Spheres, projective and lens spaces, and other quotients of the sphere.

use super::convex::Solid;
use super::simplices::{self, ONE_TETRAHEDRON, written};
use super::{Row, row, solids, two_sided};
use crate::complex::examples::lens_space;
use crate::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, SignedEdge};

fn two_balls() -> GluingScheme {
    twice(Polyhedron::lens(1))
}

/// A sphere of one bigon: both its sides are the one edge.
fn zipped() -> GluingScheme {
    twice(Polyhedron { edges: vec![[0, 1]], faces: vec![[1, -1].map(SignedEdge).to_vec()] })
}

/// Two copies of a polyhedron, each face glued to its copy.
fn twice(polyhedron: Polyhedron) -> GluingScheme {
    let face = |polyhedron, face| FaceId { polyhedron, face };
    let faces = 0..polyhedron.faces.len();
    let pairings = faces.map(|f| Pairing { a: face(0, f), b: face(1, f), shift: 0, dir: 1 }).collect();
    GluingScheme { polyhedra: vec![polyhedron; 2], pairings }
}

/// Sides after a quarter turn, the n-gons after 1/n of a turn.
fn prism_space(solid: Solid) -> GluingScheme {
    solid.opposite_faces_glued(|n| if n == 4 { 3 } else { n / 2 + 1 })
}

/// The 3-sphere.
pub(super) const SPHERES: &[Row] = &[
    row(
        "S3",
        "S³",
        "two balls, each a lens of two monogons, glued along the whole sphere",
        two_sided([1, 1, 2, 2], 0, &[]),
        two_balls,
    ),
    row(
        "S3-zipped",
        "S³",
        "two balls whose spheres are one bigon zipped along one edge",
        two_sided([2, 1, 1, 2], 0, &[]),
        zipped,
    ),
    row(
        "S3-two-tetrahedra",
        "S³",
        "two tetrahedra, each face glued to the same one of the other",
        two_sided([4, 6, 4, 2], 0, &[]),
        || twice(Polyhedron::tetrahedron()),
    ),
    row(
        "S3-one-tetrahedron",
        "S³",
        "one tetrahedron, its faces folded together in twos along edges",
        two_sided([1, 2, 2, 1], 0, &[]),
        || written(ONE_TETRAHEDRON[0]),
    ),
    row(
        "S3-4-simplex",
        "S³",
        "the boundary of the simplex in four dimensions",
        two_sided([5, 10, 10, 5], 0, &[]),
        solids::simplex_4,
    ),
    row(
        "S3-16-cell",
        "S³",
        "the boundary of the cross-polytope in four dimensions",
        two_sided([8, 24, 32, 16], 0, &[]),
        solids::cross_polytope,
    ),
    row(
        "S3-tesseract",
        "S³",
        "the boundary of the cube in four dimensions",
        two_sided([16, 32, 24, 8], 0, &[]),
        solids::tesseract,
    ),
    row(
        "S3-24-cell",
        "S³",
        "the boundary of the polytope of 24 octahedra",
        two_sided([24, 96, 96, 24], 0, &[]),
        solids::cell_24,
    ),
    row("L(1,0)", "S³", "a lens of two monogons, one glued to the other", two_sided([1, 1, 1, 1], 0, &[]), || {
        lens_space(1, 0)
    }),
    row(
        "L(5,0)",
        "S³",
        "a lens of two pentagons, one folded straight down onto the other",
        two_sided([5, 5, 1, 1], 0, &[]),
        || lens_space(5, 0),
    ),
];

/// Projective and lens spaces.
pub(super) const PROJECTIVE_AND_LENS: &[Row] = &[
    row("RP3", "RP³", "a cube, each face glued to the antipodal one", two_sided([4, 6, 3, 1], 0, &[2]), || {
        solids::cube().opposite_faces_glued(|_| 0)
    }),
    row(
        "RP3-octahedron",
        "RP³",
        "an octahedron, each face glued to the antipodal one",
        two_sided([3, 6, 4, 1], 0, &[2]),
        || solids::octahedron().opposite_faces_glued(|_| 0),
    ),
    row(
        "RP3-dodecahedron",
        "RP³",
        "a dodecahedron, each face glued to the antipodal one",
        two_sided([10, 15, 6, 1], 0, &[2]),
        || solids::dodecahedron().opposite_faces_glued(|_| 0),
    ),
    row(
        "L(2,1)",
        "RP³",
        "a lens of two bigons, one glued to the other after half a turn",
        two_sided([1, 1, 1, 1], 0, &[2]),
        || lens_space(2, 1),
    ),
    row(
        "L(3,1)",
        "L(3,1)",
        "a lens of two 3-gons, the upper one glued to the lower one 1/3 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[3]),
        || lens_space(3, 1),
    ),
    row(
        "L(3,2)",
        "L(3,2)",
        "a lens of two 3-gons, the upper one glued to the lower one 2/3 of a turn on; L(3,1) mirrored",
        two_sided([1, 1, 1, 1], 0, &[3]),
        || lens_space(3, 2),
    ),
    row(
        "L(4,1)",
        "L(4,1)",
        "a lens of two 4-gons, the upper one glued to the lower one 1/4 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[4]),
        || lens_space(4, 1),
    ),
    row(
        "L(5,1)",
        "L(5,1)",
        "a lens of two 5-gons, the upper one glued to the lower one 1/5 of a turn on; H₁ as L(5,2), not homotopy equivalent to it",
        two_sided([1, 1, 1, 1], 0, &[5]),
        || lens_space(5, 1),
    ),
    row(
        "L(5,2)",
        "L(5,2)",
        "a lens of two 5-gons, the upper one glued to the lower one 2/5 of a turn on; H₁ as L(5,1), not homotopy equivalent to it",
        two_sided([1, 1, 1, 1], 0, &[5]),
        || lens_space(5, 2),
    ),
    row(
        "L(6,1)",
        "L(6,1)",
        "a lens of two 6-gons, the upper one glued to the lower one 1/6 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[6]),
        || lens_space(6, 1),
    ),
    row(
        "L(7,1)",
        "L(7,1)",
        "a lens of two 7-gons, the upper one glued to the lower one 1/7 of a turn on; homotopy equivalent to L(7,2), not homeomorphic",
        two_sided([1, 1, 1, 1], 0, &[7]),
        || lens_space(7, 1),
    ),
    row(
        "L(7,2)",
        "L(7,2)",
        "a lens of two 7-gons, the upper one glued to the lower one 2/7 of a turn on; homotopy equivalent to L(7,1), not homeomorphic",
        two_sided([1, 1, 1, 1], 0, &[7]),
        || lens_space(7, 2),
    ),
    row(
        "L(7,3)",
        "L(7,3)",
        "a lens of two 7-gons, the upper one glued to the lower one 3/7 of a turn on; homeomorphic to L(7,2), mirrored: 2·3 = −1 mod 7",
        two_sided([1, 1, 1, 1], 0, &[7]),
        || lens_space(7, 3),
    ),
    row(
        "L(8,1)",
        "L(8,1)",
        "a lens of two 8-gons, the upper one glued to the lower one 1/8 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[8]),
        || lens_space(8, 1),
    ),
    row(
        "L(8,3)",
        "L(8,3)",
        "a lens of two 8-gons, the upper one glued to the lower one 3/8 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[8]),
        || lens_space(8, 3),
    ),
    row(
        "L(9,2)",
        "L(9,2)",
        "a lens of two 9-gons, the upper one glued to the lower one 2/9 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[9]),
        || lens_space(9, 2),
    ),
    row(
        "L(10,3)",
        "L(10,3)",
        "a lens of two 10-gons, the upper one glued to the lower one 3/10 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[10]),
        || lens_space(10, 3),
    ),
    row(
        "L(11,3)",
        "L(11,3)",
        "a lens of two 11-gons, the upper one glued to the lower one 3/11 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[11]),
        || lens_space(11, 3),
    ),
    row(
        "L(12,5)",
        "L(12,5)",
        "a lens of two 12-gons, the upper one glued to the lower one 5/12 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[12]),
        || lens_space(12, 5),
    ),
    row(
        "L(13,5)",
        "L(13,5)",
        "a lens of two 13-gons, the upper one glued to the lower one 5/13 of a turn on",
        two_sided([1, 1, 1, 1], 0, &[13]),
        || lens_space(13, 5),
    ),
    row(
        "lens-4-2",
        "RP³",
        "a lens of two 4-gons, 2/4 of a turn: each edge of L(2,1) in 2 parts",
        two_sided([2, 2, 1, 1], 0, &[2]),
        || lens_space(4, 2),
    ),
    row(
        "lens-6-4",
        "L(3,2)",
        "a lens of two 6-gons, 4/6 of a turn: each edge of L(3,2) in 2 parts",
        two_sided([2, 2, 1, 1], 0, &[3]),
        || lens_space(6, 4),
    ),
    row("L(4,1)-one-tetrahedron", "L(4,1)", "one tetrahedron", two_sided([1, 2, 2, 1], 0, &[4]), || {
        written(ONE_TETRAHEDRON[1])
    }),
    row("L(5,2)-one-tetrahedron", "L(5,2)", "one tetrahedron", two_sided([1, 2, 2, 1], 0, &[5]), || {
        written(ONE_TETRAHEDRON[2])
    }),
];

/// Other quotients of the sphere.
pub(super) const SPHERICAL: &[Row] = &[
    row(
        "quaternion-space",
        "S³/Q₈",
        "a cube, opposite faces glued after a quarter turn (Threlfall and Seifert)",
        two_sided([2, 4, 3, 1], 0, &[2, 2]),
        || solids::cube().opposite_faces_glued(|_| 3),
    ),
    row(
        "prism-space-3",
        "S³/Q₁₂",
        "a hexagonal prism: sides after a quarter turn, hexagons after a sixth (Threlfall and Seifert)",
        two_sided([3, 6, 4, 1], 0, &[4]),
        || prism_space(solids::hexagonal_prism()),
    ),
    row(
        "prism-space-4",
        "S³/Q₁₆",
        "an octagonal prism: sides after a quarter turn, octagons after an eighth",
        two_sided([4, 8, 5, 1], 0, &[2, 2]),
        || prism_space(solids::octagonal_prism()),
    ),
    row(
        "prism-space-5",
        "S³/Q₂₀",
        "a decagonal prism: sides after a quarter turn, decagons after a tenth",
        two_sided([5, 10, 6, 1], 0, &[4]),
        || prism_space(solids::decagonal_prism()),
    ),
    row(
        "octahedral-space",
        "S³/2O, 2O of order 48",
        "a truncated cube: octagons after an eighth of a turn, triangles after a sixth (Threlfall and Seifert)",
        two_sided([6, 12, 7, 1], 0, &[2]),
        || solids::truncated_cube().opposite_faces_glued(|n| if n == 3 { 2 } else { 5 }),
    ),
    row(
        "tetrahedral-space",
        "S³/2T, 2T of order 24",
        "an octahedron, opposite faces glued after a sixth of a turn (Threlfall and Seifert)",
        two_sided([1, 4, 4, 1], 0, &[3]),
        || solids::octahedron().opposite_faces_glued(|_| 2),
    ),
    row(
        "Poincare",
        "S³/2I, 2I of order 120",
        "a dodecahedron, opposite faces glued after a tenth of a turn (Weber and Seifert)",
        two_sided([5, 10, 6, 1], 0, &[]),
        || solids::dodecahedron().opposite_faces_glued(|_| 3),
    ),
    row(
        "Poincare-mirrored",
        "S³/2I, 2I of order 120",
        "a dodecahedron, opposite faces glued after a tenth of a turn the other way",
        two_sided([5, 10, 6, 1], 0, &[]),
        || solids::dodecahedron().opposite_faces_glued(|_| 2),
    ),
    row(
        "Poincare-five-tetrahedra",
        "S³/2I, 2I of order 120",
        "five tetrahedra (the census of Matveev and others)",
        two_sided([1, 6, 10, 5], 0, &[]),
        || written(simplices::POINCARE),
    ),
];

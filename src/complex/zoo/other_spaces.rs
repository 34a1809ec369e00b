//! Flat manifolds, bundles over the circle, sums, hyperbolic manifolds, unions.

use super::bundle::{prism, torus_bundle};
use super::convex::Solid;
use super::cubical::{self, Isometry};
use super::simplices::{self, written};
use super::{Row, get, one_sided, row, solids, two_sided};
use crate::complex::connected_sum::{connected_sum, disjoint_union};
use crate::complex::examples::three_torus;
use crate::complex::manifold::Manifold3;
use crate::complex::scheme::GluingScheme;

/// Every face straight across to the opposite one.
fn straight(solid: Solid) -> GluingScheme {
    solid.opposite_faces_glued(|n| n / 2)
}

fn hantzsche_wendt() -> GluingScheme {
    let screws = [[(0, 1, 1), (1, -1, 1), (2, -1, 0)], [(0, -1, 0), (1, 1, 1), (2, -1, 1)]];
    cubical::quotient(2, &screws.map(Isometry))
}

/// With the glide (x, y + 1, shift − z).
fn flat_klein(shift: i64) -> GluingScheme {
    let screw = [(0, 1, 1), (1, -1, 0), (2, -1, 0)];
    cubical::quotient(2, &[screw, [(0, 1, 0), (1, 1, 1), (2, -1, shift)]].map(Isometry))
}

fn named(name: &str) -> GluingScheme {
    get(name).expect("it stands in the table").scheme
}

fn sum(a: &str, b: &str) -> GluingScheme {
    let [a, b] = [a, b].map(|name| Manifold3::new(named(name)).expect("the zoo holds manifolds"));
    connected_sum(&a, &b)
}

fn beside(a: &str, b: &str) -> GluingScheme {
    disjoint_union(&named(a), &named(b))
}

/// The ten flat manifolds.
pub(super) const FLAT: &[Row] = &[
    row(
        "T3",
        "T³ = 𝒢₁",
        "a cube, opposite faces glued straight across (000, figures 7 and 8)",
        two_sided([1, 3, 3, 1], 3, &[]),
        three_torus,
    ),
    row(
        "T3-hexagonal-prism",
        "T³ = 𝒢₁",
        "a hexagonal prism, opposite faces glued straight across",
        two_sided([2, 5, 4, 1], 3, &[]),
        || straight(solids::hexagonal_prism()),
    ),
    row(
        "T3-rhombic-dodecahedron",
        "T³ = 𝒢₁",
        "a rhombic dodecahedron, opposite faces glued straight across",
        two_sided([3, 8, 6, 1], 3, &[]),
        || straight(solids::rhombic_dodecahedron()),
    ),
    row(
        "T3-truncated-octahedron",
        "T³ = 𝒢₁",
        "a truncated octahedron, opposite faces glued straight across",
        two_sided([6, 12, 7, 1], 3, &[]),
        || straight(solids::truncated_octahedron()),
    ),
    row("T3-27-cubes", "T³ = 𝒢₁", "27 cubes: ℝ³ up to 3ℤ³", two_sided([27, 81, 81, 27], 3, &[]), || {
        cubical::quotient(3, &[])
    }),
    row(
        "G2",
        "𝒢₂, holonomy ℤ/2",
        "a cube: sides straight across, bottom to top after half a turn (Wolf, 3.5.5)",
        two_sided([1, 3, 3, 1], 1, &[2, 2]),
        || prism("abAB", 2, false),
    ),
    row(
        "G3",
        "𝒢₃, holonomy ℤ/3",
        "a hexagonal prism: sides straight across, bottom to top after a third of a turn",
        two_sided([2, 5, 4, 1], 1, &[3]),
        || prism("abcABC", 2, false),
    ),
    row(
        "G4",
        "𝒢₄, holonomy ℤ/4",
        "a cube: sides straight across, bottom to top after a quarter turn",
        two_sided([1, 3, 3, 1], 1, &[2]),
        || prism("abAB", 1, false),
    ),
    row(
        "G5",
        "𝒢₅, holonomy ℤ/6",
        "a hexagonal prism: sides straight across, bottom to top after a sixth of a turn",
        two_sided([2, 5, 4, 1], 1, &[]),
        || prism("abcABC", 1, false),
    ),
    row(
        "G6",
        "𝒢₆, holonomy ℤ/2 ⊕ ℤ/2",
        "two cubes: ℝ³ up to 2ℤ³ and the screws (x+1, 1−y, −z), (−x, y+1, 1−z) (Hantzsche and Wendt)",
        two_sided([2, 6, 6, 2], 0, &[4, 4]),
        hantzsche_wendt,
    ),
    row(
        "B1",
        "ℬ₁ = K × S¹",
        "a cube: sides straight across, bottom to top mirrored along a side (Wolf, 3.5.9)",
        one_sided([1, 3, 3, 1], 2, &[2]),
        || prism("abAB", 1, true),
    ),
    row(
        "B2",
        "ℬ₂",
        "a cube: sides straight across, bottom to top mirrored along a diagonal",
        one_sided([1, 3, 3, 1], 2, &[]),
        || prism("abAB", 0, true),
    ),
    row(
        "B3",
        "ℬ₃",
        "two cubes: ℝ³ up to 2ℤ³, the screw (x+1, −y, −z) and the glide (x, y+1, −z)",
        one_sided([2, 6, 6, 2], 1, &[2, 2]),
        || flat_klein(0),
    ),
    row(
        "B4",
        "ℬ₄",
        "two cubes: ℝ³ up to 2ℤ³, the screw (x+1, −y, −z) and the glide (x, y+1, 1−z)",
        one_sided([2, 6, 6, 2], 1, &[4]),
        || flat_klein(1),
    ),
];

/// Bundles over the circle.
pub(super) const BUNDLES: &[Row] = &[
    row(
        "S2xS1",
        "S² × S¹",
        "the prism over a square of the word aAbB, bottom to top",
        two_sided([3, 5, 3, 1], 1, &[]),
        || prism("aAbB", 0, false),
    ),
    row(
        "S2~xS1",
        "the twisted S² bundle over S¹",
        "the prism over a square of the word aAbB, bottom to top mirrored in the line of a and b",
        one_sided([3, 5, 3, 1], 1, &[]),
        || prism("aAbB", 2, true),
    ),
    row("S2xS1-two-tetrahedra", "S² × S¹", "two tetrahedra", two_sided([1, 3, 4, 2], 1, &[]), || {
        written(simplices::S2_X_S1)
    }),
    row(
        "RP2xS1",
        "RP² × S¹",
        "the prism over a square of the word abab, bottom to top",
        one_sided([2, 4, 3, 1], 1, &[2]),
        || prism("abab", 0, false),
    ),
    row("RP2xS1-three-tetrahedra", "RP² × S¹", "three tetrahedra", one_sided([1, 4, 6, 3], 1, &[2]), || {
        written(simplices::RP2_X_S1)
    }),
    row(
        "KxS1",
        "K × S¹",
        "the prism over a square of the word aabb, bottom to top",
        one_sided([1, 3, 3, 1], 2, &[2]),
        || prism("aabb", 0, false),
    ),
    row(
        "genus2xS1",
        "genus two × S¹",
        "the prism over an octagon of the word abABcdCD, bottom to top",
        two_sided([1, 5, 5, 1], 5, &[]),
        || prism("abABcdCD", 0, false),
    ),
    row(
        "genus2-turned",
        "a bundle of surfaces of genus two, its monodromy of order eight",
        "the prism over an octagon of the word abcdABCD, bottom to top after an eighth of a turn",
        two_sided([1, 5, 5, 1], 1, &[2]),
        || prism("abcdABCD", 1, false),
    ),
    row(
        "N3xS1",
        "three cross-caps × S¹",
        "the prism over a hexagon of the word aabbcc, bottom to top",
        one_sided([1, 4, 4, 1], 3, &[2]),
        || prism("aabbcc", 0, false),
    ),
    row(
        "nil",
        "the bundle of tori of (1 1; 0 1), Heisenberg’s group up to its integer points",
        "a cube with triangles below and above: one shear",
        two_sided([1, 4, 4, 1], 2, &[]),
        || torus_bundle("U"),
    ),
    row(
        "nil-2",
        "the bundle of tori of (1 2; 0 1)",
        "two cubes with triangles below and above: two shears",
        two_sided([2, 8, 8, 2], 2, &[2]),
        || torus_bundle("UU"),
    ),
    row(
        "sol",
        "the bundle of tori of (2 1; 1 1)",
        "two cubes with triangles below and above: a shear each way",
        two_sided([2, 8, 8, 2], 1, &[]),
        || torus_bundle("UL"),
    ),
    row(
        "sol-2",
        "the bundle of tori of (3 2; 1 1)",
        "three cubes with triangles below and above",
        two_sided([3, 12, 12, 3], 1, &[2]),
        || torus_bundle("UUL"),
    ),
];

/// Connected sums.
pub(super) const SUMS: &[Row] = &[
    row("S3#S3", "S³", "two spheres, a ball taken out of each", two_sided([5, 12, 14, 7], 0, &[]), || {
        sum("S3", "S3-4-simplex")
    }),
    row("RP3#RP3", "RP³ # RP³", "two antipodal gluings of cubes", two_sided([7, 13, 8, 2], 0, &[2, 2]), || {
        sum("RP3", "RP3")
    }),
    row(
        "L(3,1)#L(3,1)",
        "L(3,1) # L(3,1)",
        "not homeomorphic to L(3,1) # L(3,2)",
        two_sided([1, 3, 4, 2], 0, &[3, 3]),
        || sum("L(3,1)", "L(3,1)"),
    ),
    row(
        "L(3,1)#L(3,2)",
        "L(3,1) # L(3,2)",
        "not homeomorphic to L(3,1) # L(3,1): the second one is mirrored",
        two_sided([1, 3, 4, 2], 0, &[3, 3]),
        || sum("L(3,1)", "L(3,2)"),
    ),
    row("S2xS1#S2xS1", "S² × S¹ # S² × S¹", "two prisms", two_sided([5, 11, 8, 2], 2, &[]), || {
        sum("S2xS1", "S2xS1")
    }),
    row("S2xS1#S2~xS1", "S² × S¹ # the twisted S² bundle", "two prisms", one_sided([5, 11, 8, 2], 2, &[]), || {
        sum("S2xS1", "S2~xS1")
    }),
    row("T3#RP3", "T³ # RP³", "two cubes", two_sided([4, 10, 8, 2], 3, &[2]), || sum("T3", "RP3")),
    row("RP2xS1#L(4,1)", "RP² × S¹ # L(4,1)", "a prism and a lens", one_sided([2, 6, 6, 2], 1, &[2, 4]), || {
        sum("RP2xS1", "L(4,1)")
    }),
];

/// Hyperbolic ones, and such in several components.
pub(super) const OTHERS: &[Row] = &[
    row(
        "Seifert-Weber",
        "the hyperbolic dodecahedral space",
        "a dodecahedron, opposite faces glued after three tenths of a turn (Weber and Seifert)",
        two_sided([1, 6, 6, 1], 0, &[5, 5, 5]),
        || solids::dodecahedron().opposite_faces_glued(|_| 4),
    ),
    row(
        "Seifert-Weber-mirrored",
        "the hyperbolic dodecahedral space",
        "a dodecahedron, opposite faces glued after three tenths of a turn the other way",
        two_sided([1, 6, 6, 1], 0, &[5, 5, 5]),
        || solids::dodecahedron().opposite_faces_glued(|_| 1),
    ),
    row(
        "Weeks",
        "the closed hyperbolic manifold of least volume, 0.9427…",
        "nine tetrahedra (the census of Hodgson and Weeks)",
        two_sided([1, 10, 18, 9], 0, &[5, 5]),
        || written(simplices::WEEKS),
    ),
    row(
        "m018(1,0)",
        "a closed hyperbolic manifold, not orientable, of volume 2.0298…",
        "eleven tetrahedra (the census of Hodgson and Weeks)",
        one_sided([1, 12, 22, 11], 1, &[]),
        || written(simplices::M018),
    ),
    row(
        "S3+S3",
        "S³ and S³ beside one another",
        "a sphere of two balls, and the boundary of the simplex",
        two_sided([6, 11, 12, 7], 0, &[]),
        || beside("S3", "S3-4-simplex"),
    ),
    row("T3+RP3", "T³ and RP³ beside one another", "two cubes", two_sided([5, 9, 6, 2], 3, &[2]), || {
        beside("T3", "RP3")
    }),
    row(
        "KxS1+Poincare",
        "K × S¹ and S³/2I beside one another",
        "a prism and a dodecahedron",
        one_sided([6, 13, 9, 2], 2, &[2]),
        || beside("KxS1", "Poincare"),
    ),
];

//! Small schemes and triangulations, all of them or at random, and named spaces.

use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, paired, three_torus};
use isoracle::complex::permutation::Perm4;
use isoracle::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron};
use isoracle::complex::triangulation::{TriangleGluing, Triangulation};
use proptest::prelude::*;

/// Pairs of faces of one polyhedron with their maps: (a, b, shift, dir).
pub type Pairs = Vec<(usize, usize, i64, i64)>;

/// All ways to glue the faces of one polyhedron in twos, each by all its maps.
pub fn every_pairing(sides: i64, faces: &[usize]) -> Vec<Pairs> {
    let Some((a, rest)) = faces.split_first() else { return vec![Vec::new()] };
    let mut found = Vec::new();
    for b in rest {
        let others: Vec<usize> = rest.iter().copied().filter(|face| face != b).collect();
        for pairs in every_pairing(sides, &others) {
            for (shift, dir) in (0..sides).flat_map(|shift| [(shift, 1), (shift, -1)]) {
                found.push([&[(*a, *b, shift, dir)], &pairs[..]].concat());
            }
        }
    }
    found
}

/// The 108 gluings of the tetrahedron.
pub fn tetrahedron_gluings() -> Vec<GluingScheme> {
    every_pairing(3, &[0, 1, 2, 3]).iter().map(|pairs| paired(Polyhedron::tetrahedron(), pairs)).collect()
}

/// The 7,680 gluings of the cube.
pub fn cube_gluings() -> Vec<GluingScheme> {
    every_pairing(4, &[0, 1, 2, 3, 4, 5]).iter().map(|pairs| paired(Polyhedron::cube(), pairs)).collect()
}

/// Closed complexes: every one of the tetrahedron, and of the cube one in so many, all if the long form is asked for.
pub fn small_complexes(one_in: usize) -> Vec<ClosedComplex> {
    let step = if crate::is_long() { 1 } else { one_in };
    let cubes = cube_gluings().into_iter().step_by(step);
    tetrahedron_gluings().into_iter().chain(cubes).filter_map(|scheme| ClosedComplex::new(scheme).ok()).collect()
}

/// The triangulation with these pairs of triangles (tetrahedron, triangle) and how the corners of the first go to those of the other.
pub fn triangulation(n: usize, pairs: &[([usize; 2], [usize; 2], Perm4)]) -> Triangulation {
    let mut gluings = vec![[TriangleGluing { tetrahedron: 0, corners: Perm4::IDENTITY }; 4]; n];
    for ([t, i], [u, j], corners) in pairs {
        assert_eq!(corners.image(*i), *j);
        gluings[*t][*i] = TriangleGluing { tetrahedron: *u as u32, corners: *corners };
        gluings[*u][*j] = TriangleGluing { tetrahedron: *t as u32, corners: corners.inverse() };
    }
    Triangulation::new(gluings).expect("each triangle is in one pair")
}

/// The 6 ways to glue triangle i to triangle j.
fn maps(i: usize, j: usize) -> Vec<Perm4> {
    Perm4::all().filter(|corners| corners.image(i) == j).collect()
}

/// The 108 closed triangulations of one tetrahedron, edges reversed or not.
pub fn one_tetrahedron() -> Vec<Triangulation> {
    let pairings = [[[0, 1], [2, 3]], [[0, 2], [1, 3]], [[0, 3], [1, 2]]];
    let glued = |[[a, b], [c, d]]: [[usize; 2]; 2]| {
        let both = maps(a, b).into_iter().flat_map(move |p| maps(c, d).into_iter().map(move |q| (p, q)));
        both.map(move |(p, q)| triangulation(1, &[([0, a], [0, b], p), ([0, c], [0, d], q)]))
    };
    pairings.into_iter().flat_map(glued).collect()
}

/// Random closed gluings of up to n tetrahedra: edges may be reversed, vertices have any links; half of them are oriented.
pub fn random_triangulation(n: usize) -> impl Strategy<Value = Triangulation> {
    (1..=n).prop_flat_map(|n| {
        let order = Just((0..4 * n).collect::<Vec<usize>>()).prop_shuffle();
        (order, prop::collection::vec(0..6_usize, 2 * n), any::<bool>()).prop_map(move |(order, choices, oriented)| {
            let pair = |(two, choice): (&[usize], &usize)| {
                let [a, b] = [two[0], two[1]].map(|k| [k / 4, k % 4]);
                let maps: Vec<Perm4> = maps(a[1], b[1]).into_iter().filter(|p| !oriented || !p.is_even()).collect();
                (a, b, maps[choice % maps.len()])
            };
            triangulation(n, &order.chunks(2).zip(&choices).map(pair).collect::<Vec<_>>())
        })
    })
}

/// The first one beside the second one.
pub fn beside(a: &Triangulation, b: &Triangulation) -> Triangulation {
    let moved = |gluing: TriangleGluing| TriangleGluing { tetrahedron: gluing.tetrahedron + a.len() as u32, ..gluing };
    let gluings = a.gluings().iter().copied().chain(b.gluings().iter().map(|gluings| gluings.map(moved)));
    Triangulation::new(gluings.collect()).expect("as they are")
}

/// Schemes beside one another.
pub fn schemes_beside(schemes: &[GluingScheme]) -> GluingScheme {
    let mut all = GluingScheme::default();
    for scheme in schemes {
        let moved = |face: FaceId| FaceId { polyhedron: face.polyhedron + all.polyhedra.len(), ..face };
        let pairings: Vec<Pairing> =
            scheme.pairings.iter().map(|p| Pairing { a: moved(p.a), b: moved(p.b), ..*p }).collect();
        all.pairings.extend(pairings);
        all.polyhedra.extend(scheme.polyhedra.iter().cloned());
    }
    all
}

/// The dodecahedron with each face glued to the opposite one through the centre, and then turned so many fifths.
pub fn dodecahedron(turn: i64) -> GluingScheme {
    let mut faces: Vec<Vec<u32>> = vec![(0..5).collect()];
    // Vertices: 0–4 around face 0, 5–9 below them, 10–14 between those, 15–19 around the last face.
    faces.extend((0..5).map(|i| vec![(i + 1) % 5, i, 5 + i, 10 + i, 5 + (i + 1) % 5]));
    faces.extend((0..5).map(|i| vec![15 + (i + 1) % 5, 10 + (i + 1) % 5, 5 + (i + 1) % 5, 10 + i, 15 + i]));
    faces.push((15..20).rev().collect());
    // Vertex i stands opposite 15 + (i + 2), 5 + i opposite 10 + (i + 2).
    let opposite = |v: u32| match v {
        0..5 => 15 + (v + 2) % 5,
        5..10 => 10 + (v - 5 + 2) % 5,
        10..15 => 5 + (v - 10 + 3) % 5,
        _ => (v - 15 + 3) % 5,
    };
    let mut pairs = Vec::new();
    for (a, face) in faces.iter().enumerate() {
        let images: Vec<u32> = face.iter().map(|v| opposite(*v)).collect();
        let b =
            faces.iter().position(|other| images.iter().all(|v| other.contains(v))).expect("it has an opposite face");
        if a < b {
            let corner = faces[b].iter().position(|v| *v == images[0]).expect("it is there") as i64;
            // The antipodal map turns outsides over, and runs around the opposite face the other way, as seen from outside.
            pairs.push((a, b, corner + turn, -1));
        }
    }
    paired(Polyhedron::of_vertex_cycles(&faces), &pairs)
}

/// The prism over a 4g-gon, g ≥ 1, top glued to bottom, sides four by four as a b A B: the surface of genus g times a circle.
pub fn surface_times_circle(genus: usize) -> GluingScheme {
    let n = 4 * genus;
    let sides = (0..genus).flat_map(|k| [0, 1].map(|i| (2 + 4 * k + i, 4 + 4 * k + i, 1, -1)));
    let pairs: Vec<_> = [(0, 1, n as i64 - 1, -1)].into_iter().chain(sides).collect();
    paired(Polyhedron::prism(n as u32), &pairs)
}

/// Named spaces, with one scheme each.
pub fn named() -> Vec<(&'static str, ClosedComplex)> {
    let cube = |pairs: &[(usize, usize, i64, i64)]| paired(Polyhedron::cube(), pairs);
    let schemes = [
        ("T³", three_torus()),
        ("S³", lens_space(1, 0)),
        ("L(2,1)", lens_space(2, 1)),
        ("L(4,2)", lens_space(4, 2)),
        ("L(5,2)", lens_space(5, 2)),
        ("L(7,3)", lens_space(7, 3)),
        ("Klein bottle × S¹", cube(&[(0, 1, 3, -1), (2, 4, 1, -1), (3, 5, 0, 1)])),
        ("genus 2 × S¹", surface_times_circle(2)),
        ("T³ and L(3,1)", schemes_beside(&[three_torus(), lens_space(3, 1)])),
    ];
    let complex =
        |(name, scheme)| (name, ClosedComplex::new(scheme).unwrap_or_else(|defects| panic!("{name}: {defects:?}")));
    schemes.into_iter().map(complex).collect()
}

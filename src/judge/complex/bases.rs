//! The schemes that questions begin with.

use crate::complex::examples::{lens_space, paired, three_torus};
use crate::complex::manifold::Manifold3;
use crate::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// How many gluings of the tetrahedron there are: 3 ways to pair its faces, 6 gluings of each pair.
pub const TETRAHEDRA: usize = 3 * 6 * 6;

/// How many gluings of the cube there are: 15 ways to pair its faces, 8 gluings of each pair.
pub const CUBES: usize = 15 * 8 * 8 * 8;

/// One of the gluings of the tetrahedron.
pub fn tetrahedron(number: usize) -> GluingScheme {
    glued_to_itself(Polyhedron::tetrahedron(), number % TETRAHEDRA)
}

/// One of the gluings of the cube.
pub fn cube(number: usize) -> GluingScheme {
    glued_to_itself(Polyhedron::cube(), number % CUBES)
}

/// A polyhedron whose faces are n-gons all, its faces paired: the number's digits, to bases F − 1, F − 3, …, 1 say which faces are
/// paired, to the base 2 n how.
fn glued_to_itself(polyhedron: Polyhedron, mut number: usize) -> GluingScheme {
    let n = polyhedron.faces[0].len();
    let mut digit = |base: usize| {
        let digit = number % base;
        number /= base;
        digit
    };
    let mut faces: Vec<usize> = (0..polyhedron.faces.len()).collect();
    let mut pairs = Vec::new();
    while !faces.is_empty() {
        let a = faces.remove(0);
        let b = faces.remove(digit(faces.len()));
        let turn = digit(2 * n);
        pairs.push((a, b, (turn % n) as i64, if turn < n { -1 } else { 1 }));
    }
    paired(polyhedron, &pairs)
}

/// The prism over an n-gon, n even: opposite sides glued by translations, bottom to top after `twist` steps around. For n = 4 and
/// n = 6 these are flat manifolds.
pub fn twisted_prism(n: u32, twist: u32) -> GluingScheme {
    let half = n / 2;
    let side = |i: u32| (2 + i as usize, 2 + (i + half) as usize, 1, -1);
    let ends = (0, 1, i64::from(n - 1 + twist), -1);
    paired(Polyhedron::prism(n), &[vec![ends], (0..half).map(side).collect()].concat())
}

/// A lens space L(p, q), p < 13; p and q may have common divisors.
pub fn lens(random: &mut ChaCha8Rng) -> GluingScheme {
    let p = random.random_range(1..13);
    lens_space(p, random.random_range(0..p))
}

/// Faces of these polyhedra glued at random to others of their size; against their cycles throughout, or either way.
/// `None` iff of some size there is an odd number.
pub fn glued_at_random(random: &mut ChaCha8Rng, polyhedra: Vec<Polyhedron>) -> Option<GluingScheme> {
    let scheme = GluingScheme { polyhedra, pairings: Vec::new() };
    let mut faces: Vec<(usize, u32, FaceId)> =
        scheme.faces().map(|id| (scheme.face(id).map_or(0, <[_]>::len), random.random(), id)).collect();
    // In a random order within each size.
    faces.sort_unstable();
    let is_oriented: bool = random.random();
    let mut pairings = Vec::new();
    for pair in faces.chunks(2) {
        let [(n, _, a), (m, _, b)] = pair else { return None };
        if n != m {
            return None;
        }
        let shift = random.random_range(0..*n as i64);
        let dir = if is_oriented || random.random() { -1 } else { 1 };
        pairings.push(Pairing { a: *a, b: *b, shift, dir });
    }
    Some(GluingScheme { pairings, ..scheme })
}

/// A polyhedron of few faces.
fn small(random: &mut ChaCha8Rng) -> Polyhedron {
    match random.random_range(0..5) {
        0 => Polyhedron::tetrahedron(),
        1 => Polyhedron::cube(),
        2 => Polyhedron::prism(random.random_range(3..7)),
        _ => Polyhedron::lens(random.random_range(1..7)),
    }
}

/// So many polyhedra, glued at random.
pub fn several(random: &mut ChaCha8Rng, count: usize) -> GluingScheme {
    loop {
        let polyhedra = (0..count).map(|_| small(random)).collect();
        if let Some(scheme) = glued_at_random(random, polyhedra) {
            return scheme;
        }
    }
}

/// A prism glued at random, or twisted.
pub fn prism(random: &mut ChaCha8Rng) -> GluingScheme {
    let n = 2 * random.random_range(2..5);
    if random.random() {
        return twisted_prism(n, random.random_range(0..n));
    }
    let any = random.random_range(3..9);
    // A prism over a polygon of odd size has an odd number of sides.
    let scheme = glued_at_random(random, vec![Polyhedron::prism(any)]);
    scheme.unwrap_or_else(|| twisted_prism(n, 1))
}

/// A closed 3-manifold; the first few are the examples as they are.
pub fn manifold(random: &mut ChaCha8Rng, number: usize) -> GluingScheme {
    match number {
        0 => return three_torus(),
        1 => return lens_space(1, 0),
        2 => return lens_space(7, 2),
        // In the cube, the hexagonal prism, the cube again: turned by a half, a third, a quarter.
        3 => return twisted_prism(4, 2),
        4 => return twisted_prism(6, 2),
        5 => return twisted_prism(4, 1),
        _ => {}
    }
    loop {
        let count = random.random_range(1..4);
        let scheme = match random.random_range(0..6) {
            0 => lens(random),
            1 => prism(random),
            2 | 3 => cube(random.random_range(0..CUBES)),
            4 => tetrahedron(random.random_range(0..TETRAHEDRA)),
            _ => several(random, count),
        };
        if Manifold3::new(scheme.clone()).is_ok() {
            return scheme;
        }
    }
}

/// Two schemes side by side.
pub fn beside(mut one: GluingScheme, other: GluingScheme) -> GluingScheme {
    let count = one.polyhedra.len();
    let moved = |id: FaceId| FaceId { polyhedron: id.polyhedron + count, ..id };
    one.polyhedra.extend(other.polyhedra);
    one.pairings.extend(other.pairings.into_iter().map(|p| Pairing { a: moved(p.a), b: moved(p.b), ..p }));
    one
}

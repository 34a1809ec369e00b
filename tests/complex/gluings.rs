//! Whole families of gluings, for tests that go through all of them.

use isoracle::complex::check::{TriangulationDefect, check};
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, paired, three_torus};
use isoracle::complex::permutation::Perm4;
use isoracle::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron, SignedEdge};
use isoracle::complex::triangulation::{TriangleGluing, Triangulation};
use std::collections::BTreeMap;

/// The ways to put an even number of things in twos.
pub fn matchings(things: &[usize]) -> Vec<Vec<[usize; 2]>> {
    let [first, rest @ ..] = things else { return vec![Vec::new()] };
    let with = |i: usize| {
        let others: Vec<usize> = rest.iter().copied().filter(|j| *j != rest[i]).collect();
        let pair = [*first, rest[i]];
        matchings(&others).into_iter().map(move |m| [vec![pair], m].concat()).collect::<Vec<_>>()
    };
    (0..rest.len()).flat_map(with).collect()
}

/// Every way to glue t topological tetrahedra, corners 0 and 1 to 0 and 1: the triangles that have both of them in twos, either
/// way around, and so those that have both of 2 and 3. ((2t − 1)!!·2ᵗ)² ways: 4, 144, 14,400 for t = 1, 2, 3.
pub fn all_gluings(t: usize) -> impl Iterator<Item = Triangulation> + use<> {
    let triangles: Vec<usize> = (0..2 * t).collect();
    let halves: Vec<(Vec<[usize; 2]>, usize)> =
        matchings(&triangles).into_iter().flat_map(|m| (0..1 << t).map(move |turns| (m.clone(), turns))).collect();
    let pairs: Vec<(usize, usize)> = (0..halves.len()).flat_map(|i| (0..halves.len()).map(move |j| (i, j))).collect();
    pairs.into_iter().map(move |(primal, dual)| {
        let mut gluings = vec![[TriangleGluing { tetrahedron: 0, corners: Perm4::IDENTITY }; 4]; t];
        for (kind, (matching, turns)) in [(2, &halves[primal]), (0, &halves[dual])] {
            for (number, [a, b]) in matching.iter().enumerate() {
                let [(s, i), (u, j)] = [a, b].map(|n| (n / 2, kind + n % 2));
                let turn = turns >> number & 1;
                let mut images = [0; 4];
                // The pair that both triangles have goes to itself, the triangles' fourth corners to one another.
                (images[i], images[i ^ 1]) = (j as u8, (j ^ 1) as u8);
                let common = 2 - kind;
                (0..2).for_each(|n| images[common + n] = (common + (n ^ turn)) as u8);
                let corners = Perm4::new(images).expect("two pairs");
                gluings[s][i] = TriangleGluing { tetrahedron: u as u32, corners };
                gluings[u][j] = TriangleGluing { tetrahedron: s as u32, corners: corners.inverse() };
            }
        }
        Triangulation::new(gluings).expect("glued in twos")
    })
}

/// The 108 gluings of one tetrahedron, and the 7,680 of one cube, as schemes: faces in twos, each way around.
pub fn all_schemes(polyhedron: &Polyhedron) -> impl Iterator<Item = GluingScheme> + use<> {
    let faces = polyhedron.faces.len();
    let (pairs, sides) = (faces / 2, polyhedron.faces[0].len());
    let ways = 2 * sides;
    let polyhedron = polyhedron.clone();
    matchings(&(0..faces).collect::<Vec<_>>()).into_iter().flat_map(move |matching| {
        let polyhedron = polyhedron.clone();
        (0..ways.pow(pairs as u32)).map(move |code| {
            let pair = |(i, [a, b]): (usize, &[usize; 2])| {
                let way = code / ways.pow(i as u32) % ways;
                (*a, *b, (way / 2) as i64, if way % 2 == 0 { 1 } else { -1 })
            };
            paired(polyhedron.clone(), &matching.iter().enumerate().map(pair).collect::<Vec<_>>())
        })
    })
}

/// Those of them whose cells are cells.
pub fn all_complexes(polyhedron: &Polyhedron) -> impl Iterator<Item = ClosedComplex> + use<> {
    all_schemes(polyhedron).filter_map(|scheme| ClosedComplex::new(scheme).ok())
}

/// A ball whose one face runs along an edge and back.
pub fn zipped_bigon() -> Polyhedron {
    Polyhedron { edges: vec![[0, 1]], faces: vec![vec![SignedEdge(1), SignedEdge(-1)]] }
}

/// Two copies of a polyhedron, each face glued to its copy: a 3-sphere.
pub fn doubled(polyhedron: Polyhedron) -> GluingScheme {
    let face = |polyhedron, face| FaceId { polyhedron, face };
    let pairings = (0..polyhedron.faces.len()).map(|f| Pairing { a: face(0, f), b: face(1, f), shift: 0, dir: 1 });
    GluingScheme { pairings: pairings.collect(), polyhedra: vec![polyhedron.clone(), polyhedron] }
}

/// n³ cubes, each glued to its neighbours: the 3-torus again.
pub fn torus_of_cubes(n: usize) -> GluingScheme {
    let at = |[x, y, z]: [usize; 3]| (x % n * n + y % n) * n + z % n;
    let face = |polyhedron, face| FaceId { polyhedron, face };
    let mut pairings = Vec::new();
    for place in 0..n.pow(3) {
        let [x, y, z] = [place / n / n, place / n % n, place % n];
        // As in the 3-torus: top on the next bottom, back on the next front, left on the next right.
        let steps = [([x, y, z + 1], 0, 1, 3), ([x, y + 1, z], 2, 4, 1), ([x + 1, y, z], 3, 5, 1)];
        pairings.extend(steps.map(|(next, a, b, shift)| Pairing {
            a: face(at(next), a),
            b: face(place, b),
            shift,
            dir: -1,
        }));
    }
    GluingScheme { polyhedra: vec![Polyhedron::cube(); n.pow(3)], pairings }
}

/// Named complexes of many kinds.
pub fn examples() -> Vec<(String, ClosedComplex)> {
    let mut schemes = vec![
        ("3-torus".to_owned(), three_torus()),
        ("27 cubes".to_owned(), torus_of_cubes(3)),
        ("two zipped bigons".to_owned(), doubled(zipped_bigon())),
        ("two tetrahedra".to_owned(), doubled(Polyhedron::tetrahedron())),
        ("two cubes".to_owned(), doubled(Polyhedron::cube())),
        ("two monogon lenses".to_owned(), doubled(Polyhedron::lens(1))),
        ("two pentagonal prisms".to_owned(), doubled(Polyhedron::prism(5))),
    ];
    let lenses = [(1, 0), (2, 0), (2, 1), (3, 1), (4, 1), (4, 2), (5, 0), (5, 2), (6, 1), (7, 2), (8, 3), (12, 3)];
    schemes.extend(lenses.map(|(p, q)| (format!("L({p}, {q})"), lens_space(p, q))));
    let complex = |scheme| ClosedComplex::new(scheme).expect("a closed complex");
    schemes.into_iter().map(|(name, scheme)| (name, complex(scheme))).collect()
}

/// A triangulation as a scheme of tetrahedra.
pub fn scheme_of(triangulation: &Triangulation) -> GluingScheme {
    // The cycles of the faces of a tetrahedron, opposite corners 0, 1, 2, 3.
    const CYCLES: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
    let mut pairings = Vec::new();
    for (tetrahedron, gluings) in triangulation.gluings().iter().enumerate() {
        for (triangle, gluing) in gluings.iter().enumerate() {
            let other = (gluing.tetrahedron as usize, gluing.corners.image(triangle));
            if other < (tetrahedron, triangle) {
                continue;
            }
            let place = CYCLES[triangle]
                .map(|i| CYCLES[other.1].iter().position(|j| *j == gluing.corners.image(i)).expect("a corner of it"));
            pairings.push(Pairing {
                a: FaceId { polyhedron: tetrahedron, face: triangle },
                b: FaceId { polyhedron: other.0, face: other.1 },
                shift: place[0] as i64,
                dir: if place[1] == (place[0] + 1) % 3 { 1 } else { -1 },
            });
        }
    }
    GluingScheme { polyhedra: vec![Polyhedron::tetrahedron(); triangulation.len()], pairings }
}

/// Whether a triangulation has no edge that is glued to itself, tail to head.
pub fn has_edges(triangulation: &Triangulation) -> bool {
    let reversed = |defect: &TriangulationDefect| matches!(defect, TriangulationDefect::EdgeReversed { .. });
    !check(triangulation).defects.iter().any(reversed)
}

/// How many tetrahedra stand around the edge of these corners, for each edge that has it.
pub fn rings(triangulation: &Triangulation, edge: usize) -> BTreeMap<u32, usize> {
    let mut rings = BTreeMap::new();
    triangulation.skeleton().edges.iter().for_each(|edges| *rings.entry(edges[edge]).or_default() += 1);
    rings
}

/// Every way to glue the triangles of one tetrahedron in twos, whatever corners meet: 108.
pub fn all_gluings_of_one() -> Vec<Triangulation> {
    let orders: Vec<Perm4> = Perm4::all().collect();
    let maps =
        |from: usize, to: usize| -> Vec<Perm4> { orders.iter().copied().filter(|p| p.image(from) == to).collect() };
    let mut all = Vec::new();
    for matching in matchings(&[0, 1, 2, 3]) {
        let [[a, b], [c, d]] = [matching[0], matching[1]];
        for first in maps(a, b) {
            for second in maps(c, d) {
                let mut row = [TriangleGluing { tetrahedron: 0, corners: Perm4::IDENTITY }; 4];
                for (i, corners) in [(a, first), (b, first.inverse()), (c, second), (d, second.inverse())] {
                    row[i].corners = corners;
                }
                all.push(Triangulation::new(vec![row]).expect("glued in twos"));
            }
        }
    }
    all
}

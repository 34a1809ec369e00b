//! Schemes that make no closed 3-manifold, each with its first defect and the witness in it.

use super::super::examples::{lens_space, paired, three_torus};
use super::super::polyhedron::PolyhedronFlaw;
use super::super::scheme::{FaceId, GluingScheme, Pairing, PairingFlaw, Polyhedron, SchemeDefect, SignedEdge};
use super::simplices::{self, written};
use crate::mesh::classify::{ClosedSurface, Surface};

/// A scheme that is no closed 3-manifold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Broken {
    /// Its name here.
    pub name: &'static str,
    /// What is wrong with it, in words.
    pub about: &'static str,
    /// The first defect that is found.
    pub defect: SchemeDefect,
    /// The scheme.
    pub scheme: GluingScheme,
}

/// The names of all broken schemes: no balls, pairings that glue nothing, faces glued wrongly, edges turned, vertices that are singular.
pub fn names() -> Vec<&'static str> {
    all().into_iter().map(|broken| broken.name).collect()
}

/// The broken scheme of that name. `None` iff there is none.
pub fn get(name: &str) -> Option<Broken> {
    all().into_iter().find(|broken| broken.name == name)
}

/// All of them.
pub fn all() -> Vec<Broken> {
    [no_balls(), no_pairings(), wrong_pairings(), wrong_cells()].concat()
}

fn broken(name: &'static str, about: &'static str, defect: SchemeDefect, scheme: GluingScheme) -> Broken {
    Broken { name, about, defect, scheme }
}

fn sides(signed: &[i32]) -> Vec<SignedEdge> {
    signed.iter().copied().map(SignedEdge).collect()
}

fn polyhedron(edges: &[[u32; 2]], faces: &[&[i32]]) -> Polyhedron {
    Polyhedron { edges: edges.to_vec(), faces: faces.iter().map(|face| sides(face)).collect() }
}

fn of_cycles(faces: &[&[u32]]) -> Polyhedron {
    Polyhedron::of_vertex_cycles(&faces.iter().map(|face| face.to_vec()).collect::<Vec<_>>())
}

/// Polyhedra that are no balls.
fn no_balls() -> Vec<Broken> {
    use PolyhedronFlaw::*;
    let one = |name, about, flaw, p: Polyhedron| {
        let defect = SchemeDefect::BadPolyhedron { polyhedron: 0, flaw };
        broken(name, about, defect, GluingScheme { polyhedra: vec![p], pairings: Vec::new() })
    };
    let orientable = |genus| Surface { closed: ClosedSurface::Orientable { genus }, boundary_loops: 0 };
    let tetrahedron = Polyhedron::tetrahedron();
    let with_face = |number: usize, signed: &[i32]| {
        let mut p = tetrahedron.clone();
        p.faces[number] = sides(signed);
        p
    };
    let mut unused = tetrahedron.clone();
    unused.edges.push([0, 1]);
    let open = of_cycles(&[&[3, 2, 1, 0], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]]);
    let mut twice = with_face(0, &[1, 2, 3]);
    twice.faces[0] = tetrahedron.faces[0].iter().rev().map(|side| SignedEdge(-side.0)).collect();
    vec![
        broken("empty", "no polyhedron at all", SchemeDefect::Empty, GluingScheme::default()),
        one("no-face", "a polyhedron without faces", NoFace, polyhedron(&[], &[])),
        one("empty-face", "a face without sides", EmptyFace { face: 2 }, polyhedron(&[[0, 0]], &[&[1], &[-1], &[]])),
        one(
            "no-such-edge",
            "a side that is edge 7 of six",
            NoSuchEdge { face: 1, side: 2, edge: -7, edges: 6 },
            with_face(1, &[4, -2, -7]),
        ),
        one(
            "edge-zero",
            "a side without a sign",
            NoSuchEdge { face: 0, side: 1, edge: 0, edges: 6 },
            with_face(0, &[1, 0, 3]),
        ),
        one(
            "broken-walk",
            "a face whose second side begins elsewhere than the first one ends",
            BrokenWalk { face: 0, side: 0, begins: 1, ends: 3 },
            with_face(0, &[1, 3, 2]),
        ),
        one(
            "monogon-without-loop",
            "a face of one side, which is no loop",
            BrokenWalk { face: 0, side: 0, begins: 0, ends: 1 },
            polyhedron(&[[0, 1]], &[&[1], &[-1]]),
        ),
        one("open-surface", "a cube without its top", EdgeUses { edge: 5, uses: 1 }, open),
        one("edge-unused", "an edge in no face", EdgeUses { edge: 6, uses: 0 }, unused),
        one(
            "edge-in-three-faces",
            "three triangles on one edge",
            EdgeUses { edge: 0, uses: 3 },
            of_cycles(&[&[0, 1, 2], &[1, 0, 3], &[1, 0, 4]]),
        ),
        one("face-turned", "a tetrahedron with one face seen from inside", SameDirection { edge: 0 }, twice),
        one(
            "projective-plane",
            "a bigon whose sides are one loop",
            SameDirection { edge: 0 },
            polyhedron(&[[0, 0]], &[&[1, 1]]),
        ),
        one(
            "klein-bottle",
            "a square of the word abAb",
            SameDirection { edge: 1 },
            polyhedron(&[[0, 0], [0, 0]], &[&[1, 2, -1, 2]]),
        ),
        one(
            "pinched-sphere",
            "two tetrahedra that have a vertex in common",
            Pinch { vertex: 0, fans: 2 },
            of_cycles(&[
                &[1, 2, 3],
                &[0, 3, 2],
                &[0, 1, 3],
                &[0, 2, 1],
                &[4, 5, 6],
                &[0, 6, 5],
                &[0, 4, 6],
                &[0, 5, 4],
            ]),
        ),
        one(
            "two-spheres",
            "two tetrahedra in one polyhedron",
            Disconnected { parts: 2 },
            of_cycles(&[
                &[1, 2, 3],
                &[0, 3, 2],
                &[0, 1, 3],
                &[0, 2, 1],
                &[5, 6, 7],
                &[4, 7, 6],
                &[4, 5, 7],
                &[4, 6, 5],
            ]),
        ),
        one(
            "torus-surface",
            "a square of the word abAB",
            NotASphere(orientable(1)),
            polyhedron(&[[0, 0], [0, 0]], &[&[1, 2, -1, -2]]),
        ),
        one(
            "genus-two-surface",
            "an octagon of the word abABcdCD",
            NotASphere(orientable(2)),
            polyhedron(&[[0, 0]; 4], &[&[1, 2, -1, -2, 3, 4, -3, -4]]),
        ),
    ]
}

fn face(polyhedron: usize, face: usize) -> FaceId {
    FaceId { polyhedron, face }
}

/// T³ with one more pairing.
fn torus_and(more: Pairing) -> GluingScheme {
    let mut scheme = three_torus();
    scheme.pairings.push(more);
    scheme
}

/// Pairings that name no gluing.
fn no_pairings() -> Vec<Broken> {
    let wrong =
        |name, about, flaw, more| broken(name, about, SchemeDefect::BadPairing { pairing: 3, flaw }, torus_and(more));
    let mut turned = three_torus();
    turned.pairings[1].dir = 0;
    let pairing = |a, b| Pairing { a, b, shift: 0, dir: 1 };
    vec![
        wrong(
            "no-such-face",
            "a pairing of face 6 of a cube",
            PairingFlaw::NoSuchFace(face(0, 6)),
            pairing(face(0, 0), face(0, 6)),
        ),
        wrong(
            "no-such-polyhedron",
            "a pairing of a polyhedron that is not there",
            PairingFlaw::NoSuchFace(face(1, 0)),
            pairing(face(1, 0), face(0, 0)),
        ),
        broken(
            "no-direction",
            "a pairing with dir 0",
            SchemeDefect::BadPairing { pairing: 1, flaw: PairingFlaw::Direction(0) },
            turned,
        ),
    ]
}

/// Pairings that do not match the faces in twos.
fn wrong_pairings() -> Vec<Broken> {
    let mut single = three_torus();
    single.pairings.pop();
    let mut folded = three_torus();
    folded.pairings[2] = Pairing { a: face(0, 3), b: face(0, 3), shift: 2, dir: 1 };
    let sizes = paired(Polyhedron::prism(3), &[(0, 2, 0, -1), (1, 3, 0, -1)]);
    vec![
        broken(
            "unmatched-face",
            "the cube of T³ with its last two faces left open",
            SchemeDefect::UnmatchedFace { face: face(0, 3) },
            single,
        ),
        broken(
            "size-mismatch",
            "a prism, a triangle glued to a square",
            SchemeDefect::PolygonSizeMismatch { pairing: 0, a: 3, b: 4 },
            sizes,
        ),
        broken(
            "face-glued-to-itself",
            "a face of a cube glued to itself after half a turn",
            SchemeDefect::FaceGluedToItself { pairing: 2, face: face(0, 3) },
            folded,
        ),
        broken(
            "face-in-two-pairings",
            "the cube of T³ with one face glued twice",
            SchemeDefect::FaceInTwoPairings { face: face(0, 1), pairings: [0, 3] },
            torus_and(Pairing { a: face(0, 1), b: face(0, 2), shift: 0, dir: -1 }),
        ),
    ]
}

/// The suspension of a closed surface: the double pyramid over a polygon whose sides are glued as the letters of the word are, the faces
/// above with the faces above.
fn suspension(word: &str) -> GluingScheme {
    let letters: Vec<char> = word.chars().collect();
    let n = letters.len() as u32;
    // Face i stands above side i, face n + i below; corner 0 of each is where side i begins, corner 2 is the top.
    let above = (0..n).map(|i| vec![i, (i + 1) % n, n]);
    let below = (0..n).map(|i| vec![(i + 1) % n, i, n + 1]);
    let polyhedron = Polyhedron::of_vertex_cycles(&above.chain(below).collect::<Vec<_>>());
    let mut pairs = Vec::new();
    for i in 0..letters.len() {
        if let Some(j) = (i + 1..letters.len()).find(|j| letters[*j].eq_ignore_ascii_case(&letters[i])) {
            let (shift, dir) = if letters[j] == letters[i] { (0, 1) } else { (1, -1) };
            pairs.extend([(i, j, shift, dir), (i + letters.len(), j + letters.len(), shift, dir)]);
        }
    }
    paired(polyhedron, &pairs)
}

/// Faces glued in twos, but an edge turned, or a vertex singular.
fn wrong_cells() -> Vec<Broken> {
    let edge = |name, about, polyhedron, edge, scheme| {
        broken(name, about, SchemeDefect::EdgeReversed { polyhedron, edge }, scheme)
    };
    let link = |name, about, (vertex, called), link, scheme| {
        broken(name, about, SchemeDefect::VertexLink { vertex, polyhedron: 0, name: called, link }, scheme)
    };
    let (torus, genus_2) = (ClosedSurface::Orientable { genus: 1 }, ClosedSurface::Orientable { genus: 2 });
    let crosscaps = |crosscaps| ClosedSurface::NonOrientable { crosscaps };
    let mut mirrored = lens_space(1, 0);
    mirrored.pairings[0].dir = 1;
    let mut bigons = lens_space(2, 0);
    bigons.pairings[0].dir = 1;
    vec![
        edge("edge-reversed", "a lens of two monogons, glued so that the loop goes to its reverse", 0, 0, mirrored),
        edge(
            "edge-reversed-cube",
            "a cube: bottom and top as for T³, front and back after half a turn, left and right mirrored",
            0,
            8,
            paired(Polyhedron::cube(), &[(0, 1, 3, -1), (2, 4, 3, -1), (3, 5, 0, 1)]),
        ),
        link(
            "suspension-RP2",
            "a lens of two bigons, each point glued to the antipode: a projective plane around both vertices",
            (0, 0),
            crosscaps(1),
            bigons,
        ),
        link("suspension-torus", "the double pyramid of the word abAB", (1, 4), torus, suspension("abAB")),
        link(
            "suspension-klein-bottle",
            "the double pyramid of the word aabb",
            (1, 4),
            crosscaps(2),
            suspension("aabb"),
        ),
        link(
            "suspension-crosscaps",
            "the double pyramid of the word aabbcc",
            (1, 6),
            crosscaps(3),
            suspension("aabbcc"),
        ),
        link("suspension-genus-2", "the double pyramid of the word abABcdCD", (1, 8), genus_2, suspension("abABcdCD")),
        link(
            "gieseking",
            "Gieseking’s tetrahedron: a Klein bottle around its vertex",
            (0, 1),
            crosscaps(2),
            written(simplices::GIESEKING),
        ),
        link(
            "figure-eight",
            "the complement of the figure-eight knot, its cusp made a vertex: a torus around it",
            (0, 1),
            torus,
            written(simplices::FIGURE_EIGHT),
        ),
        link(
            "genus-2-cusp",
            "two tetrahedra with one vertex and a surface of genus two around it",
            (0, 1),
            genus_2,
            written(simplices::GENUS_TWO),
        ),
    ]
}

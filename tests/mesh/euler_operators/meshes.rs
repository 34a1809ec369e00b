//! Meshes to build: as faces of vertex numbers.

use isoracle::mesh::examples::{cube, tetrahedron};
use isoracle::mesh::face::Face;
use std::collections::BTreeMap;

/// A mesh by its name, with V, E, F, H, C, G.
pub struct Named {
    pub name: &'static str,
    pub faces: Vec<Face>,
    pub counts: [i64; 6],
}

fn faces<const N: usize>(loops: &[[u32; N]]) -> Vec<Face> {
    loops.iter().copied().map(Face::from).collect()
}

/// A copy with these numbers added.
fn shifted(mesh: &[Face], by: u32) -> Vec<Face> {
    renamed(mesh, |v| v + by)
}

fn renamed(mesh: &[Face], name: impl Fn(u32) -> u32) -> Vec<Face> {
    let word = |l: &[u32]| l.iter().map(|v| name(*v)).collect::<Vec<u32>>();
    let face =
        |face: &Face| Face { outer: word(&face.outer), holes: face.holes.iter().map(|hole| word(hole)).collect() };
    mesh.iter().map(face).collect()
}

/// A torus of n × n squares.
pub fn torus(n: u32) -> Vec<Face> {
    let at = |i: u32, j: u32| i % n + n * (j % n);
    let square = |i, j| Face::from([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
    (0..n).flat_map(|i| (0..n).map(move |j| square(i, j))).collect()
}

/// Two tori, one inside out, without a square each, joined along it.
fn double_torus() -> Vec<Face> {
    let [first, second] = [torus(3), torus(3)];
    let glued = first[0].outer.clone();
    let name = |v: u32| if glued.contains(&v) { v } else { v + 9 };
    let reversed: Vec<Face> = second[1..].iter().map(Face::reversed).collect();
    first[1..].iter().cloned().chain(renamed(&reversed, name)).collect()
}

/// The cube with each face in n × n squares.
fn subdivided_cube(n: i64) -> Vec<Face> {
    let mut number: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    let mut faces = Vec::new();
    for axis in 0..3 {
        for (side, i, j) in [0, n].iter().flat_map(|s| (0..n * n).map(move |k| (*s, k / n, k % n))) {
            let mut corner = |i: i64, j: i64| {
                let mut at = [0; 3];
                (at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]) = (side, i, j);
                let free = number.len() as u32;
                *number.entry(at).or_insert(free)
            };
            let square = Face::from([corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]);
            faces.push(if side == 0 { square.reversed() } else { square });
        }
    }
    faces
}

/// Sides of a tube from a square below to one above it, seen from outside; from inside with the squares exchanged.
fn tube(below: [u32; 4], above: [u32; 4]) -> impl Iterator<Item = Face> {
    (0..4).map(move |i| Face::from([below[i], below[(i + 1) % 4], above[(i + 1) % 4], above[i]]))
}

/// A block with a hole through it and, beside it, a pocket in its top. Squares are counterclockwise seen from above.
fn block_with_hole_and_pocket() -> Vec<Face> {
    let square = |first: u32| [first, first + 1, first + 2, first + 3];
    let down = |square: [u32; 4]| Face::from(square).reversed();
    let ring = |square: [u32; 4]| down(square).outer;
    let [below, above, hole_below, hole_above, pocket, pocket_above] = [0, 4, 8, 12, 16, 20].map(square);
    let bottom = Face { outer: down(below).outer, holes: vec![hole_below.to_vec()] };
    let top = Face { outer: above.to_vec(), holes: vec![ring(hole_above), ring(pocket_above)] };
    let inner = tube(hole_above, hole_below).chain(tube(pocket_above, pocket));
    [bottom, top, Face::from(pocket)].into_iter().chain(tube(below, above)).chain(inner).collect()
}

/// A face and its other side.
fn lamina(face: Face) -> Vec<Face> {
    vec![face.clone(), face.reversed()]
}

pub fn meshes() -> Vec<Named> {
    let (cube, tetrahedron) = (cube().faces, tetrahedron().faces);
    let hollow = Face { outer: vec![0, 1, 2], holes: vec![vec![3, 5, 4]] };
    let prism = [faces(&[[0, 2, 1], [3, 4, 5]]), faces(&[[0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]])].concat();
    let seven: Vec<Face> = (0..7u32)
        .flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]])
        .map(Face::from)
        .collect();
    let cavity: Vec<Face> = shifted(&cube, 8).iter().map(Face::reversed).collect();
    let named = |name, faces, counts| Named { name, faces, counts };
    vec![
        named("nothing", vec![], [0, 0, 0, 0, 0, 0]),
        named("segment", faces(&[[0, 1]]), [2, 1, 1, 0, 1, 0]),
        named("lamina triangle", lamina(Face::from([0, 1, 2])), [3, 3, 2, 0, 1, 0]),
        named("thin quadrilateral", lamina(Face::from([0, 1, 2, 3])), [4, 4, 2, 0, 1, 0]),
        named("hollow triangle", lamina(hollow), [6, 6, 2, 2, 1, 1]),
        named("tetrahedron", tetrahedron, [4, 6, 4, 0, 1, 0]),
        named("prism", prism, [6, 9, 5, 0, 1, 0]),
        named("cube in quarters", subdivided_cube(2), [26, 48, 24, 0, 1, 0]),
        named("block with hole and pocket", block_with_hole_and_pocket(), [24, 36, 15, 3, 1, 1]),
        named("torus of 9 squares", torus(3), [9, 18, 9, 0, 1, 1]),
        named("torus of 7 vertices", seven, [7, 21, 14, 0, 1, 1]),
        named("double torus", double_torus(), [14, 32, 16, 0, 1, 2]),
        named("cube with a cavity", [cube.clone(), cavity].concat(), [16, 24, 12, 0, 2, 0]),
        named("two cubes", [cube.clone(), shifted(&cube, 8)].concat(), [16, 24, 12, 0, 2, 0]),
        named("two tori", [torus(3), shifted(&torus(3), 9)].concat(), [18, 36, 18, 0, 2, 2]),
        named("cube", cube, [8, 12, 6, 0, 1, 0]),
    ]
}

pub fn mesh(name: &str) -> Vec<Face> {
    meshes().into_iter().find(|mesh| mesh.name == name).expect("it is in the list").faces
}

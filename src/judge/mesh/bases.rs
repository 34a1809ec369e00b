//! The meshes that questions begin with.

use crate::linear::Vector;
use crate::mesh::examples::{cube, mesh, point, tetrahedron};
use crate::mesh::face::Face;
use crate::mesh::vertex_list::{Point, VertexList};
use crate::number::Rational;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// How many kinds of solids there are.
pub const SOLIDS: usize = 9;

/// A sound solid: closed, planar faces, counterclockwise from outside.
pub fn solid(random: &mut ChaCha8Rng, kind: usize) -> VertexList {
    match kind % SOLIDS {
        0 => tetrahedron(),
        1 => cube(),
        2 => prism(random.random_range(3..7)),
        3 => pyramid(random.random_range(4..7)),
        4 => octahedron(),
        5 => frame(),
        6 => block_with_hole(),
        7 => triangulated(&frame()),
        _ => beside(&cube(), &tetrahedron()),
    }
}

/// Convex position of n points with integer coordinates, counterclockwise.
fn polygon_at(n: u32, z: i64) -> Vec<[i64; 3]> {
    // On the parabola y = x², closed from above.
    (0..i64::from(n)).map(|x| [x, x * x, z]).collect()
}

fn prism(n: u32) -> VertexList {
    let vertices = [polygon_at(n, 0), polygon_at(n, 2)].concat();
    let mut faces: Vec<Vec<u32>> = vec![(0..n).rev().collect(), (n..2 * n).collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]));
    mesh(&vertices, &faces)
}

fn pyramid(n: u32) -> VertexList {
    let vertices = [polygon_at(n, 0), vec![[1, 2, 3]]].concat();
    let mut faces: Vec<Vec<u32>> = vec![(0..n).rev().collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n]));
    mesh(&vertices, &faces)
}

fn octahedron() -> VertexList {
    let vertices = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
    mesh(&vertices, &[[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
}

/// Four rings of four corners: outside below and above, inside above and below.
fn rings() -> Vec<[i64; 3]> {
    let square = |low: i64, high: i64, z: i64| [[low, low, z], [high, low, z], [high, high, z], [low, high, z]];
    [square(0, 3, 0), square(0, 3, 1), square(1, 2, 1), square(1, 2, 0)].concat()
}

/// A square torus of 16 quadrangles.
fn frame() -> VertexList {
    let quads: Vec<[u32; 4]> = (0..4)
        .flat_map(|ring: u32| {
            let (low, high) = (4 * ring, 4 * ((ring + 1) % 4));
            (0..4).map(move |i| [low + i, low + (i + 1) % 4, high + (i + 1) % 4, high + i])
        })
        .collect();
    mesh(&rings(), &quads)
}

/// The same solid with one ring-shaped face above and one below.
fn block_with_hole() -> VertexList {
    let quads = [0, 2].into_iter().flat_map(|ring: u32| {
        (0..4).map(move |i| [4 * ring + i, 4 * ring + (i + 1) % 4, 4 * ring + 4 + (i + 1) % 4, 4 * ring + 4 + i])
    });
    let mut block = mesh(&rings(), &quads.collect::<Vec<_>>());
    block.faces.push(Face { outer: vec![4, 5, 6, 7], holes: vec![vec![11, 10, 9, 8]] });
    block.faces.push(Face { outer: vec![3, 2, 1, 0], holes: vec![vec![12, 13, 14, 15]] });
    block
}

/// The projective plane of 6 vertices and 10 triangles, its vertices where no four are in one plane.
pub fn projective_plane() -> VertexList {
    // On the moment curve.
    let vertices: Vec<[i64; 3]> = (0..6).map(|t: i64| [t, t * t, t * t * t]).collect();
    let faces =
        [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 1], [1, 2, 4], [2, 3, 5], [3, 4, 1], [4, 5, 2], [5, 1, 3]];
    mesh(&vertices, &faces)
}

/// The second mesh set beside the first, in the direction of x.
pub fn beside(first: &VertexList, second: &VertexList) -> VertexList {
    let mut both = first.clone();
    let count = first.vertices.len() as u32;
    both.vertices.extend(second.vertices.iter().map(|v| v.clone() + &point([20, 0, 0])));
    both.faces.extend(second.faces.iter().map(|face| renumbered(face, |v| v + count)));
    both
}

/// A face with other vertex numbers.
pub fn renumbered(face: &Face, number: impl Fn(u32) -> u32) -> Face {
    let map = |l: &Vec<u32>| l.iter().map(|v| number(*v)).collect();
    Face { outer: map(&face.outer), holes: face.holes.iter().map(map).collect() }
}

/// The mesh with each face as a fan of triangles; faces with holes are left out.
pub fn triangulated(mesh: &VertexList) -> VertexList {
    let fans = mesh.faces.iter().filter(|face| face.holes.is_empty()).flat_map(|face| {
        let l = &face.outer;
        (1..l.len().saturating_sub(1)).map(move |i| Face::from([l[0], l[i], l[i + 1]]))
    });
    VertexList { vertices: mesh.vertices.clone(), faces: fans.collect() }
}

/// The mesh under an affine map that keeps the orientation, its vertices and faces in another order, its loops beginning
/// elsewhere. Every other mesh has coordinates that binary64 does not hold.
pub fn moved(random: &mut ChaCha8Rng, mesh: VertexList) -> VertexList {
    let fine = random.random::<bool>();
    let mut entry = |most: i64| {
        let numerator = random.random_range(-most..=most);
        Rational::from((numerator, if fine { random.random_range(1..=7) } else { 1 }))
    };
    let shear: [[Rational; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| match i.cmp(&j) {
            std::cmp::Ordering::Equal => Rational::from(1) + entry(3).abs(),
            std::cmp::Ordering::Less => entry(2),
            std::cmp::Ordering::Greater => Rational::new(),
        })
    });
    let origin: Point = Vector([(); 3].map(|()| entry(9)));
    let map = |v: &Point| Vector(shear.each_ref().map(|row| Vector(row.clone()).dot(v))) + &origin;
    let order = shuffled(random, mesh.vertices.len());
    let mut vertices = vec![Vector::zero(); mesh.vertices.len()];
    for (v, position) in mesh.vertices.iter().enumerate() {
        vertices[order[v] as usize] = map(position);
    }
    let mut faces: Vec<Face> = mesh.faces.iter().map(|face| renumbered(face, |v| order[v as usize])).collect();
    for face in &mut faces {
        let begin = random.random_range(0..face.outer.len());
        face.outer.rotate_left(begin);
    }
    let begin = random.random_range(0..faces.len());
    faces.rotate_left(begin);
    VertexList { vertices, faces }
}

fn shuffled(random: &mut ChaCha8Rng, n: usize) -> Vec<u32> {
    let mut order: Vec<u32> = (0..n as u32).collect();
    for i in (1..n).rev() {
        order.swap(i, random.random_range(0..=i));
    }
    order
}

/// A polygon: planar or nearly so, convex or not, a bow-tie, or without an area.
pub fn polygon(random: &mut ChaCha8Rng) -> VertexList {
    let n = random.random_range(3..8);
    let nearly = Rational::from((1, 1_000_000_000_000_000i64));
    let kind = random.random_range(0..6);
    let slope: [i64; 2] = [(); 2].map(|()| random.random_range(-3..=3));
    let flat: Vec<[i64; 2]> = match kind {
        // One line.
        0 => (0..n).map(|i| [i, 2 * i]).collect(),
        // A parallelogram that crosses itself: no signed area.
        1 => vec![[0, 0], [3, 2], [3, 0], [0, 2]],
        _ => (0..n).map(|_| [(); 2].map(|()| random.random_range(-6..=6))).collect(),
    };
    let lift = |[x, y]: [i64; 2]| Vector([x, y, slope[0] * x + slope[1] * y + 1].map(Rational::from));
    let mut vertices: Vec<Point> = flat.into_iter().map(lift).collect();
    let which = random.random_range(0..vertices.len());
    match kind {
        3 => vertices[which].0[2] += nearly,
        4 => vertices[which].0[2] += Rational::from(random.random_range(1..5)),
        _ => {}
    }
    let face = Face::new((0..vertices.len() as u32).collect::<Vec<u32>>());
    VertexList { vertices, faces: vec![face] }
}

//! The meshes that questions begin with.

use crate::linear::Vector;
use crate::mesh::examples::solids::{
    block_with_cavity, block_with_through_holes, divided_cube, frame, pierced_block, prism,
};
use crate::mesh::examples::{cube, mesh, point, surfaces, tetrahedron};
use crate::mesh::face::Face;
use crate::mesh::vertex_list::{Point, VertexList};
use crate::number::Rational;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

/// How many kinds of solids there are.
pub const SOLIDS: usize = 12;

/// A sound solid: closed, planar faces, counterclockwise from outside.
pub fn solid(random: &mut ChaCha8Rng, kind: usize) -> VertexList {
    match kind % SOLIDS {
        0 => tetrahedron(),
        1 => cube(),
        2 => prism(&parabola(random.random_range(3..7)), 2),
        3 => pyramid(random.random_range(4..7)),
        4 => octahedron(),
        5 => frame(),
        6 => block_with_through_holes(1),
        7 => triangulated(&frame()),
        8 => pierced_block(),
        9 => block_with_cavity(),
        10 => divided_cube(),
        _ => beside(&cube(), &tetrahedron()),
    }
}

/// n points in convex position, counterclockwise: on y = x².
fn parabola(n: i64) -> Vec<[i64; 2]> {
    (0..n).map(|x| [x, x * x]).collect()
}

fn pyramid(n: u32) -> VertexList {
    let base = parabola(n.into()).into_iter().map(|[x, y]| [x, y, 0]);
    let vertices: Vec<[i64; 3]> = base.chain([[1, 2, 3]]).collect();
    let mut faces: Vec<Vec<u32>> = vec![(0..n).rev().collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n]));
    mesh(&vertices, &faces)
}

fn octahedron() -> VertexList {
    let vertices = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
    mesh(&vertices, &[[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
}

/// The projective plane of 6 vertices and 10 triangles, its vertices where no four are in one plane.
pub fn projective_plane() -> VertexList {
    // On the moment curve.
    let vertices: Vec<[i64; 3]> = (0..6).map(|t: i64| [t, t * t, t * t * t]).collect();
    let triangles: Vec<Vec<u32>> =
        surfaces::projective_plane().of_dimension(2).map(|t| t.vertices().to_vec()).collect();
    mesh(&vertices, &triangles)
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

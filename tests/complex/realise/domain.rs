//! Meshes that are placed.

use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::permutation::Perm4;
use isoracle::complex::realise::mesh::TetrahedralMesh;
use isoracle::complex::realise::points::Points;
use isoracle::complex::scheme::GluingScheme;
use isoracle::complex::triangulation::{Triangulation, edge_between};
use std::f64::consts::TAU;

/// The boundary of the 4-simplex.
pub fn simplex_boundary() -> TetrahedralMesh {
    let tetrahedra: Vec<[u32; 4]> = (0..5_u32).map(|i| std::array::from_fn(|j| (i + 1 + j as u32) % 5)).collect();
    TetrahedralMesh::of_tetrahedra(5, &tetrahedra).expect("tetrahedra")
}

/// The boundary of the 16-cell: vertex 2i is e_i, 2i + 1 is −e_i.
pub fn cross_polytope() -> TetrahedralMesh {
    let tetrahedra: Vec<[u32; 4]> = (0..16_u32).map(|s| std::array::from_fn(|i| 2 * i as u32 + (s >> i & 1))).collect();
    TetrahedralMesh::of_tetrahedra(8, &tetrahedra).expect("tetrahedra")
}

/// The torus of a × b × c cubes, six tetrahedra along the diagonal of each; a simplicial complex from 3 × 3 × 3 on.
pub fn grid_torus(sizes: [u32; 3]) -> TetrahedralMesh {
    let [a, b, c] = sizes;
    let number = |p: [u32; 3]| (p[0] % a) + a * ((p[1] % b) + b * (p[2] % c));
    let mut tetrahedra = Vec::new();
    for corner in (0..a * b * c).map(|i| [i % a, i / a % b, i / a / b]) {
        for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let mut at = corner;
            let mut walk = vec![number(at)];
            for axis in order {
                at[axis] += 1;
                walk.push(number(at));
            }
            tetrahedra.push(walk.try_into().expect("three steps"));
        }
    }
    TetrahedralMesh::of_tetrahedra((a * b * c) as usize, &tetrahedra).expect("tetrahedra")
}

/// That torus in ℝ⁴, turned around one circle after another: smooth, and embedded where the grid is fine enough.
pub fn torus_of_revolution(sizes: [u32; 3], radii: [f64; 3]) -> Points {
    let [a, b, c] = sizes;
    let angle = |i: u32, n: u32| TAU * f64::from(i) / f64::from(n);
    let mut coordinates = Vec::new();
    for [i, j, k] in (0..a * b * c).map(|i| [i % a, i / a % b, i / a / b]) {
        let (x, y, z) = (angle(i, a), angle(j, b), angle(k, c));
        let inner = [radii[0] * x.cos(), radii[0] * x.sin()];
        let middle = [(radii[1] + inner[0]) * y.cos(), (radii[1] + inner[0]) * y.sin(), inner[1]];
        coordinates.extend([(radii[2] + middle[0]) * z.cos(), (radii[2] + middle[0]) * z.sin(), middle[1], middle[2]]);
    }
    Points::new(4, coordinates).expect("finite")
}

/// The barycentric subdivision of a triangulation whose tetrahedra have four different vertices each.
pub fn subdivided(triangulation: &Triangulation) -> TetrahedralMesh {
    let skeleton = triangulation.skeleton();
    let [v, e, f, t] = skeleton.counts;
    let mut tetrahedra = Vec::new();
    for i in 0..t {
        for order in Perm4::all().map(Perm4::images) {
            let edge = skeleton.edges[i][edge_between(order[0], order[1])];
            let triangle = skeleton.triangles[i][order[3]];
            tetrahedra.push([
                skeleton.vertices[i][order[0]],
                v as u32 + edge,
                (v + e) as u32 + triangle,
                (v + e + f + i) as u32,
            ]);
        }
    }
    TetrahedralMesh::of_tetrahedra(v + e + f + t, &tetrahedra).expect("tetrahedra")
}

/// A scheme, subdivided twice.
pub fn twice(scheme: GluingScheme) -> TetrahedralMesh {
    subdivided(&ClosedComplex::new(scheme).expect("a closed complex").barycentric())
}

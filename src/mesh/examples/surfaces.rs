//! Triangulated surfaces and other complexes, as combinatorics; and the torus of seven vertices in space.

use crate::linear::Vector;
use crate::mesh::cells::{Cell, CellComplex, CellId, Walk};
use crate::mesh::connected_sum::connected_sum;
use crate::mesh::realisation::GeometricComplex;
use crate::mesh::simplicial::{Simplex, SimplicialComplex};
use crate::number::Rational;

fn complex<S: AsRef<[u32]>>(simplices: impl IntoIterator<Item = S>) -> SimplicialComplex {
    SimplicialComplex::new(simplices.into_iter().map(|s| Simplex::new(s.as_ref()).expect("different vertices")))
}

/// The sphere of dimension d, as the facets of a simplex of dimension d + 1.
///
/// # Panics
/// Iff the simplex would have more vertices than a [`Simplex`] may.
pub fn sphere(d: usize) -> SimplicialComplex {
    let vertices: Vec<u32> = (0..d as u32 + 2).collect();
    SimplicialComplex::new(Simplex::new(&vertices).expect("few vertices").faces(d))
}

/// The ball of dimension d: a simplex.
///
/// # Panics
/// Iff it would have more vertices than a [`Simplex`] may.
pub fn ball(d: usize) -> SimplicialComplex {
    complex([(0..=d as u32).collect::<Vec<u32>>()])
}

/// The icosahedron's surface: 12 vertices, 20 triangles; the opposite of vertex 0 is vertex 11.
pub fn icosahedron() -> SimplicialComplex {
    let (upper, lower) = (|i: u32| 1 + i % 5, |i: u32| 6 + i % 5);
    complex((0..5).flat_map(|i| {
        [
            [0, upper(i), upper(i + 1)],
            [upper(i), upper(i + 1), lower(i)],
            [upper(i + 1), lower(i), lower(i + 1)],
            [11, lower(i), lower(i + 1)],
        ]
    }))
}

/// The projective plane of 6 vertices, 15 edges and 10 triangles: half an icosahedron.
pub fn projective_plane() -> SimplicialComplex {
    let around = |i: u32| 1 + i % 5;
    complex((0..5).flat_map(|i| [[0, around(i), around(i + 1)], [around(i), around(i + 1), around(i + 3)]]))
}

/// A Klein bottle of 8 vertices, 24 edges and 16 triangles.
#[doc(alias = "ME-86")]
#[doc(alias = "ME-141")]
pub fn klein_bottle() -> SimplicialComplex {
    complex([
        [0, 1, 3],
        [0, 1, 6],
        [0, 2, 3],
        [0, 2, 4],
        [0, 4, 7],
        [0, 5, 6],
        [0, 5, 7],
        [1, 2, 4],
        [1, 2, 5],
        [1, 3, 4],
        [1, 5, 7],
        [1, 6, 7],
        [2, 3, 5],
        [3, 4, 5],
        [4, 5, 6],
        [4, 6, 7],
    ])
}

/// The Möbius band of 5 vertices, 10 edges and 5 triangles; its border runs 0 2 4 1 3.
#[doc(alias = "ME-140")]
pub fn moebius_band() -> SimplicialComplex {
    complex((0..5).map(|i| [i, (i + 1) % 5, (i + 2) % 5]))
}

/// An annulus: a prism's three walls, 6 triangles.
pub fn annulus() -> SimplicialComplex {
    complex((0..3).flat_map(|i| [[i, (i + 1) % 3, i + 3], [(i + 1) % 3, i + 3, (i + 1) % 3 + 3]]))
}

/// The sphere with two handles: two tori of 7 vertices summed, 11 vertices.
#[doc(alias = "ME-87")]
pub fn double_torus() -> SimplicialComplex {
    let torus = SimplicialComplex::torus();
    connected_sum(&torus, [0, 1, 3], &torus, [0, 1, 3]).expect("the torus has that triangle")
}

/// The dunce hat: a triangle with all three sides glued, two one way and one the other. It is contractible, and no surface:
/// the edges on its seam have three triangles.
pub fn dunce_hat() -> SimplicialComplex {
    let seam = [0, 1, 2, 0, 1, 2, 0, 2, 1];
    let ring = |i: usize| 3 + (i % 9) as u32;
    complex((0..9).flat_map(|i| {
        let [a, b] = [seam[i], seam[(i + 1) % 9]];
        [[a, b, ring(i)], [ring(i), b, ring(i + 1)], [ring(i), ring(i + 1), 12]]
    }))
}

/// The suspension: two cones over a complex, with new tips. That of a sphere is a sphere of one dimension more.
pub fn suspension(of: &SimplicialComplex) -> SimplicialComplex {
    let free = of.of_dimension(0).map(|v| v.vertices()[0] + 1).max().unwrap_or(0);
    let cone = |tip: u32| of.maximal().into_iter().map(move |s| [s.vertices(), &[tip]].concat());
    complex(cone(free).chain(cone(free + 1)))
}

/// The cone over a complex, with a new tip.
pub fn cone(over: &SimplicialComplex) -> SimplicialComplex {
    let tip = over.of_dimension(0).map(|v| v.vertices()[0] + 1).max().unwrap_or(0);
    complex(over.maximal().into_iter().map(|s| [s.vertices(), &[tip]].concat()))
}

/// The torus of dimension 3 as n³ cubes, each of six tetrahedra around its diagonal, opposite faces glued. It is a simplicial complex for
/// n ≥ 3.
pub fn three_torus(n: u32) -> SimplicialComplex {
    let number = |[x, y, z]: [u32; 3]| ((x % n) * n + y % n) * n + z % n;
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let cells = (0..n).flat_map(|x| (0..n).flat_map(move |y| (0..n).map(move |z| [x, y, z])));
    complex(cells.flat_map(|cell| {
        orders.map(|order| {
            let mut at = cell;
            let mut path = vec![number(at)];
            for axis in order {
                at[axis] += 1;
                path.push(number(at));
            }
            path
        })
    }))
}

/// Császár's torus: [`SimplicialComplex::torus`] at seven points of space, its triangles disjoint but for common faces. Of
/// the 120 ways to lay that torus on these points this is the only one.
pub fn csaszar() -> GeometricComplex<3> {
    GeometricComplex::new(SimplicialComplex::torus(), csaszar_points().to_vec())
        .expect("its triangles meet in common faces")
}

/// The positions of the vertices of [`csaszar`].
pub fn csaszar_points() -> [Vector<Rational, 3>; 7] {
    [[3, -3, 0], [-3, 3, 0], [-1, -2, 3], [3, 3, 1], [0, 0, 15], [-3, -3, 1], [1, 2, 3]]
        .map(|at: [i64; 3]| Vector(at.map(Rational::from)))
}

/// A sphere as one point and one disc: a spherical face has no edge, and without a vertex it is no disc.
#[doc(alias = "ME-89")]
pub fn sphere_of_one_face() -> CellComplex {
    let face = Cell::Disc(Walk::Constant(CellId(0)));
    CellComplex::new(vec![Cell::Vertex, face]).expect("the disc's border is the point")
}

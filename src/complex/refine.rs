//! Refinement of order k: each tetrahedron cut into k³ along the lattice of the points with coordinates 0, 1/k, …, 1.

pub mod counts;
pub mod fast;
pub mod simplicial;

use super::closed_complex::ClosedComplex;
use super::permutation::Perm4;
use super::triangulation::{TriangleGluing, Triangulation};
use crate::number::Integer;
use crate::partition::Partition;
use std::collections::BTreeMap;
use thiserror::Error;

/// A point of the lattice of order k in a tetrahedron: its barycentric coordinates times k, whose sum is k.
pub type LatticePoint = [u32; 4];

/// The most tetrahedra that a refinement may have.
pub const MAX_TETRAHEDRA: usize = 1 << 27;

/// A triangulation whose tetrahedra were cut into k³ each, and what its vertices are called.
///
/// Tetrahedron k³·i + j is the j-th of [`small_tetrahedra`] in tetrahedron i of the one that was refined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refinement {
    order: u32,
    triangulation: Triangulation,
    /// By tetrahedron of the one that was refined, then by [`rank`] of the lattice point.
    numbers: Vec<u32>,
    vertices: Vec<[u32; 4]>,
    vertex_count: usize,
}

/// Why there is no refinement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum RefineError {
    /// The order is 0.
    #[error("the order is 0; it is at least 1")]
    OrderZero,
    /// There would be more than [`MAX_TETRAHEDRA`] tetrahedra.
    #[error("{tetrahedra} tetrahedra, each cut into {order}³, are more than 2²⁷")]
    TooLarge {
        /// How many there are.
        tetrahedra: usize,
        /// Into the cube of what each is cut.
        order: u32,
    },
}

impl ClosedComplex {
    /// Its topological tetrahedra, each cut into k³.
    ///
    /// # Errors
    /// Iff k is 0 or t·k³ is too large.
    pub fn refined(&self, order: u32) -> Result<Refinement, RefineError> {
        refine(&self.tetrahedra(), order)
    }
}

impl Refinement {
    /// k.
    pub fn order(&self) -> u32 {
        self.order
    }

    /// The small tetrahedra, glued.
    pub fn triangulation(&self) -> &Triangulation {
        &self.triangulation
    }

    /// The vertex at each corner of each small tetrahedron.
    pub fn vertices(&self) -> &[[u32; 4]] {
        &self.vertices
    }

    /// How many vertices there are.
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The vertex at a lattice point of a tetrahedron of the one that was refined. `None` iff there is no such point.
    pub fn vertex(&self, tetrahedron: usize, point: LatticePoint) -> Option<u32> {
        let sum: u64 = point.iter().map(|n| u64::from(*n)).sum();
        if sum != u64::from(self.order) {
            return None;
        }
        let start = tetrahedron.checked_mul(points_of_order(self.order))?;
        self.numbers.get(start.checked_add(rank(point))?).copied()
    }
}

/// The triangulation with each tetrahedron cut into k³ (000, section 5.3): the tetrahedra of [`small_tetrahedra`], glued where
/// the lattice points of their triangles are the same, in one tetrahedron or across a triangle of two.
///
/// The lattice in a triangle is mapped to itself by all symmetries of the triangle, so that every gluing may be refined.
///
/// # Errors
/// Iff k is 0 or there would be more than [`MAX_TETRAHEDRA`] tetrahedra.
#[doc(alias = "CX-56")]
pub fn refine(base: &Triangulation, order: u32) -> Result<Refinement, RefineError> {
    check_size(base, order)?;
    let small = small_tetrahedra(order);
    // Where each triangle lies: inner ones twice, those in a triangle of the tetrahedron once.
    let mut places: BTreeMap<[LatticePoint; 3], Vec<(usize, usize)>> = BTreeMap::new();
    for (j, corners) in small.iter().enumerate() {
        (0..4).for_each(|i| places.entry(sorted_triangle(corners, i)).or_default().push((j, i)));
    }
    let gluing = |tetrahedron: usize, j: usize, triangle: usize| {
        let key = sorted_triangle(&small[j], triangle);
        let inside = places[&key].iter().find(|place| **place != (j, triangle));
        let (other, map, (other_j, other_triangle)) = match inside {
            Some(place) => (tetrahedron, Perm4::IDENTITY, *place),
            None => {
                let outer = (0..4).find(|i| key.iter().all(|p| p[*i] == 0)).expect("it lies in a triangle");
                let TriangleGluing { tetrahedron, corners } = base.gluings()[tetrahedron][outer];
                let mut image = key.map(|point| moved(point, corners));
                image.sort_unstable();
                (tetrahedron as usize, corners, places[&image][0])
            }
        };
        let mut images = [other_triangle as u8; 4];
        for i in (0..4).filter(|i| *i != triangle) {
            let point = moved(small[j][i], map);
            images[i] =
                small[other_j].iter().position(|p| *p == point).expect("the triangles have the same points") as u8;
        }
        let corners = Perm4::new(images).expect("three corners and the fourth");
        TriangleGluing { tetrahedron: (other * small.len() + other_j) as u32, corners }
    };
    let all = (0..base.len()).flat_map(|i| (0..small.len()).map(move |j| (i, j)));
    let gluings = all.map(|(i, j)| [0, 1, 2, 3].map(|triangle| gluing(i, j, triangle))).collect();
    let triangulation = Triangulation::new(gluings).expect("what is glued to a triangle is glued back");
    let (numbers, vertex_count) = classes(base, order);
    Ok(Refinement {
        order,
        triangulation,
        vertices: corner_numbers(base.len(), &small, order, &numbers),
        numbers,
        vertex_count,
    })
}

/// The tetrahedra that a tetrahedron is cut into, by the lattice points at their corners; e_i is a unit of coordinate i.
///
/// First the upright ones p + e_0, …, p + e_3 with |p| = k − 1. Then the octahedra of the points q + e_i + e_j with |q| = k − 2, each
/// cut into four around the diagonal from q + e_0 + e_1 to q + e_2 + e_3; the one at corner c, whose partner in {0, 1} or {2, 3} is d and
/// whose other two are a and b, has q + e_a + e_b, q + e_c + e_d, q + e_c + e_a, q + e_c + e_b at its corners c, d, a, b. Then the
/// inverted ones r + (1, 1, 1, 1) − e_i with |r| = k − 3. Each family goes by the ranks of p, q, r.
///
/// The diagonal is the one that the symmetries keeping {0, 1} | {2, 3} keep: for k = 2 it joins the middles of e and f′.
#[doc(alias = "CX-53")]
#[doc(alias = "CX-54")]
pub fn small_tetrahedra(order: u32) -> Vec<[LatticePoint; 4]> {
    let with = |p: LatticePoint, units: &[usize]| {
        let mut sum = p;
        units.iter().for_each(|i| sum[*i] += 1);
        sum
    };
    let upright = |p| [0, 1, 2, 3].map(|i| with(p, &[i]));
    let quarter = |q, c: usize| {
        let (d, [a, b]) = partners(c);
        let mut corners = [q; 4];
        (corners[c], corners[d], corners[a], corners[b]) =
            (with(q, &[a, b]), with(q, &[c, d]), with(q, &[c, a]), with(q, &[c, b]));
        corners
    };
    let inverted = |r: LatticePoint| [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| r[j] + u32::from(i != j)));
    let of_sum = |less: u32| order.checked_sub(less).map(lattice_points).unwrap_or_default().into_iter();
    let quarters = of_sum(2).flat_map(|q| (0..4).map(move |c| quarter(q, c)));
    of_sum(1).map(upright).chain(quarters).chain(of_sum(3).map(inverted)).collect()
}

/// The other corner of the pair {0, 1} or {2, 3} that a corner belongs to, and the other pair.
pub fn partners(corner: usize) -> (usize, [usize; 2]) {
    (corner ^ 1, if corner < 2 { [2, 3] } else { [0, 1] })
}

/// The points of the lattice of that order, by their ranks.
pub fn lattice_points(order: u32) -> Vec<LatticePoint> {
    let point = |s: u32, u: u32, w: u32| [order - s, s - u, u - w, w];
    (0..=order).flat_map(|s| (0..=s).flat_map(move |u| (0..=u).map(move |w| point(s, u, w)))).collect()
}

/// How many points come before this one: (s+2 over 3) + (u+1 over 2) + w with s = b₁ + b₂ + b₃, u = b₂ + b₃, w = b₃, all below 2²⁰.
pub fn rank([_, b1, b2, b3]: LatticePoint) -> usize {
    let [w, u, s] = [b3, b2 + b3, b1 + b2 + b3].map(|n| n as usize);
    s * (s + 1) * (s + 2) / 6 + u * (u + 1) / 2 + w
}

/// (k+3 over 3), the number of lattice points of a tetrahedron.
pub fn points_of_order(order: u32) -> usize {
    rank([0, 0, 0, order]) + 1
}

/// The point with its coordinates at the corners that the permutation takes theirs to.
pub fn moved(point: LatticePoint, corners: Perm4) -> LatticePoint {
    let mut image = [0; 4];
    (0..4).for_each(|i| image[corners.image(i)] = point[i]);
    image
}

/// (n, n², …, n⁷): the place of vertex n on the moment curve. Eight vertices are never in one hyperplane of ℝ⁷, so that the straight
/// simplices of a simplicial complex of dimension 3 meet in their common vertices only (CX-62).
#[doc(alias = "CX-62")]
pub fn moment_point(vertex: u32) -> [Integer; 7] {
    std::array::from_fn(|i| Integer::from(Integer::u_pow_u(vertex, i as u32 + 1)))
}

fn sorted_triangle(corners: &[LatticePoint; 4], opposite: usize) -> [LatticePoint; 3] {
    let mut points = [1, 2, 3].map(|i| corners[(opposite + i) % 4]);
    points.sort_unstable();
    points
}

fn check_size(base: &Triangulation, order: u32) -> Result<(), RefineError> {
    let tetrahedra = base.len() as u128 * u128::from(order).pow(3);
    match order {
        0 => Err(RefineError::OrderZero),
        _ if tetrahedra > MAX_TETRAHEDRA as u128 => Err(RefineError::TooLarge { tetrahedra: base.len(), order }),
        _ => Ok(()),
    }
}

/// The class of each lattice point of each tetrahedron, points being one where a gluing lays one on the other.
fn classes(base: &Triangulation, order: u32) -> (Vec<u32>, usize) {
    let points = lattice_points(order);
    let mut parts = Partition::new(base.len() * points.len());
    for (tetrahedron, gluings) in base.gluings().iter().enumerate() {
        for (triangle, gluing) in gluings.iter().enumerate() {
            for (i, point) in points.iter().enumerate().filter(|(_, p)| p[triangle] == 0) {
                let image = rank(moved(*point, gluing.corners));
                parts.join(tetrahedron * points.len() + i, gluing.tetrahedron as usize * points.len() + image);
            }
        }
    }
    parts.numbered()
}

fn corner_numbers(tetrahedra: usize, small: &[[LatticePoint; 4]], order: u32, numbers: &[u32]) -> Vec<[u32; 4]> {
    let ranks: Vec<[usize; 4]> = small.iter().map(|corners| corners.map(rank)).collect();
    let points = points_of_order(order);
    (0..tetrahedra).flat_map(|i| ranks.iter().map(move |r| r.map(|rank| numbers[i * points + rank]))).collect()
}

//! Refinement by formulas: what a small triangle is glued to, and the number of each lattice point, without a search.

use super::{
    MAX_TETRAHEDRA, RefineError, Refinement, check_size, corner_numbers, lattice_points, moved, partners,
    points_of_order, rank, small_tetrahedra,
};
use crate::complex::permutation::Perm4;
use crate::complex::triangulation::{EDGES, TriangleGluing, Triangulation};

const _: () = assert!(16 * MAX_TETRAHEDRA <= u32::MAX as usize, "ends of edges of tetrahedra have 32-bit numbers");

/// As [`refine`](super::refine), vertices numbered in another order: those of the vertices, edges, triangles and tetrahedra of
/// the base one after the other, in each by the place.
///
/// # Errors
/// Iff k is 0 or there would be more than [`MAX_TETRAHEDRA`] tetrahedra.
#[doc(alias = "CX-63")]
pub fn refine(base: &Triangulation, order: u32) -> Result<Refinement, RefineError> {
    check_size(base, order)?;
    let triangulation = Triangulation::new(gluings(base, order)).expect("what is glued to a triangle is glued back");
    let (numbers, vertex_count) = numbers(base, order);
    let vertices = corner_numbers(base.len(), &small_tetrahedra(order), order, &numbers);
    Ok(Refinement { order, triangulation, numbers, vertices, vertex_count })
}

/// Where the families of small tetrahedra begin.
struct Families {
    octahedra: usize,
    inverted: usize,
}

/// Neighbours, with c, d, a, b as in [`small_tetrahedra`]: an upright p and the quarter c of q = p − e_c have the three points around
/// p + e_c in common; the quarters c and a of an octahedron the diagonal and q + e_c + e_a; the quarter c of q and the inverted q − e_d
/// the three points without e_d.
fn gluings(base: &Triangulation, order: u32) -> Vec<[TriangleGluing; 4]> {
    let below = |less: u32| order.checked_sub(less).map_or(0, points_of_order);
    let families = Families { octahedra: below(1), inverted: below(1) + 4 * below(2) };
    let small = order.pow(3) as usize;
    let of_sum = |less: u32| order.checked_sub(less).map(lattice_points).unwrap_or_default();
    let [upright, octahedra, inverted] = [1, 2, 3].map(of_sum);
    let mut gluings = Vec::with_capacity(base.len() * small);
    for (tetrahedron, outer) in base.gluings().iter().enumerate() {
        let start = tetrahedron * small;
        let at = |j: usize, corners: Perm4| TriangleGluing { tetrahedron: (start + j) as u32, corners };
        for p in &upright {
            gluings.push([0, 1, 2, 3].map(|i| match p[i] {
                0 => {
                    let j = rank(moved(*p, outer[i].corners));
                    TriangleGluing {
                        tetrahedron: outer[i].tetrahedron * small as u32 + j as u32,
                        corners: outer[i].corners,
                    }
                }
                _ => at(families.octahedra + 4 * rank(less_one(*p, i)) + i, Perm4::IDENTITY),
            }));
        }
        for (j, q) in octahedra.iter().enumerate() {
            for c in 0..4 {
                let (d, [a, b]) = partners(c);
                let mut triangles = [at(0, Perm4::IDENTITY); 4];
                triangles[c] = at(rank(plus_one(*q, c)), Perm4::IDENTITY);
                triangles[b] = at(families.octahedra + 4 * j + a, perm([(c, b), (d, a), (a, c), (b, d)]));
                triangles[a] = at(families.octahedra + 4 * j + b, perm([(c, a), (d, b), (b, c), (a, d)]));
                triangles[d] = match q[d] {
                    0 => {
                        let TriangleGluing { tetrahedron, corners } = outer[d];
                        let other = corners.image(d) ^ 1;
                        let j = families.octahedra + 4 * rank(moved(*q, corners)) + other;
                        let corners = exchanged(c).then(corners).then(exchanged(other));
                        TriangleGluing { tetrahedron: tetrahedron * small as u32 + j as u32, corners }
                    }
                    _ => at(families.inverted + rank(less_one(*q, d)), exchanged(c)),
                };
                gluings.push(triangles);
            }
        }
        for r in &inverted {
            gluings
                .push([0, 1, 2, 3].map(|d| at(families.octahedra + 4 * rank(plus_one(*r, d)) + (d ^ 1), exchanged(d))));
        }
    }
    gluings
}

/// Exchanges the two corners that are not in the pair of c: the point without e_b of the quarter c lies at corner a.
fn exchanged(c: usize) -> Perm4 {
    let (d, [a, b]) = partners(c);
    perm([(c, c), (d, d), (a, b), (b, a)])
}

fn perm(images: [(usize, usize); 4]) -> Perm4 {
    let mut list = [0; 4];
    images.into_iter().for_each(|(i, image)| list[i] = image as u8);
    Perm4::new(list).expect("each corner has one image")
}

fn plus_one(mut point: [u32; 4], i: usize) -> [u32; 4] {
    point[i] += 1;
    point
}

fn less_one(mut point: [u32; 4], i: usize) -> [u32; 4] {
    point[i] -= 1;
    point
}

/// The number of each lattice point: the offset of the cell that it is inside of, and its index there. On an edge that is its
/// distance from the tail, less 1; where the edge is reversed, from the nearer end. In a triangle it is the rank of its
/// coordinates on the side that comes first, less 1 each; in a tetrahedron that of its coordinates.
fn numbers(base: &Triangulation, order: u32) -> (Vec<u32>, usize) {
    let skeleton = base.skeleton();
    let [vertex_count, edge_count, triangle_count, _] = skeleton.counts;
    let tails = edge_tails(base, &skeleton.edges, edge_count);
    let inner = |less: u32| order.checked_sub(less);
    let on_edge = inner(1).unwrap_or(0) as usize;
    let in_triangle = inner(3).map_or(0, |n| (n as usize + 1) * (n as usize + 2) / 2);
    let in_tetrahedron = inner(4).map_or(0, points_of_order);
    // A reversed edge has its points twice; what is left over is taken out below.
    let edges_from = vertex_count;
    let triangles_from = edges_from + edge_count * on_edge;
    let tetrahedra_from = triangles_from + triangle_count * in_triangle;
    let points = lattice_points(order);
    let mut numbers = Vec::with_capacity(base.len() * points.len());
    for (tetrahedron, gluings) in base.gluings().iter().enumerate() {
        for point in &points {
            let inside: u8 = (0..4).filter(|i| point[*i] > 0).map(|i| 1 << i).sum();
            numbers.push(match inside.count_ones() {
                1 => skeleton.vertices[tetrahedron][inside.trailing_zeros() as usize],
                2 => {
                    let ends = [inside.trailing_zeros() as usize, 7 - inside.leading_zeros() as usize];
                    let edge = EDGES.iter().position(|e| *e == ends).expect("an edge");
                    let from_first = point[ends[1]];
                    let distance = match tails.of_edge[tetrahedron][edge] {
                        Direction::Forward => from_first,
                        Direction::Backward => order - from_first,
                        Direction::Both => from_first.min(order - from_first),
                    };
                    let class = skeleton.edges[tetrahedron][edge] as usize;
                    (edges_from + class * on_edge) as u32 + distance - 1
                }
                3 => {
                    let opposite = (!inside).trailing_zeros() as usize;
                    let other = &gluings[opposite];
                    let other_triangle = other.corners.image(opposite);
                    let is_first = (tetrahedron, opposite) < (other.tetrahedron as usize, other_triangle);
                    let (p, without) =
                        if is_first { (*point, opposite) } else { (moved(*point, other.corners), other_triangle) };
                    let [_, b, c] = [1, 2, 3].map(|i| p[(without + i) % 4] as usize - 1);
                    let class = skeleton.triangles[tetrahedron][opposite] as usize;
                    (triangles_from + class * in_triangle + (b + c) * (b + c + 1) / 2 + c) as u32
                }
                _ => (tetrahedra_from + tetrahedron * in_tetrahedron + rank(point.map(|n| n - 1))) as u32,
            });
        }
    }
    let count = tetrahedra_from + base.len() * in_tetrahedron;
    match tails.reversed {
        0 => (numbers, count),
        reversed => {
            let unused = reversed * (on_edge - order as usize / 2);
            (without_gaps(numbers, count), count - unused)
        }
    }
}

/// How an edge of a tetrahedron, from its corner of smaller number on, lies along the edge of the triangulation.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Direction {
    Forward,
    Backward,
    /// The edge of the triangulation is glued to itself, tail to head.
    Both,
}

struct Tails {
    of_edge: Vec<[Direction; 6]>,
    reversed: usize,
}

fn edge_tails(base: &Triangulation, edges: &[[u32; 6]], count: usize) -> Tails {
    let mut of_edge: Vec<[Option<Direction>; 6]> = vec![[None; 6]; base.len()];
    let mut is_reversed = vec![false; count];
    for start in 0..base.len() {
        for edge in 0..6 {
            if of_edge[start][edge].is_some() {
                continue;
            }
            let mut pending = vec![(start, EDGES[edge])];
            while let Some((tetrahedron, [tail, head])) = pending.pop() {
                let ends = [tail.min(head), tail.max(head)];
                let edge = EDGES.iter().position(|e| *e == ends).expect("an edge");
                let direction = if tail < head { Direction::Forward } else { Direction::Backward };
                match of_edge[tetrahedron][edge].replace(direction) {
                    None => {}
                    Some(known) if known == direction => continue,
                    Some(known) => {
                        of_edge[tetrahedron][edge] = Some(known);
                        is_reversed[edges[tetrahedron][edge] as usize] = true;
                        continue;
                    }
                }
                for triangle in (0..4).filter(|i| !ends.contains(i)) {
                    let gluing = &base.gluings()[tetrahedron][triangle];
                    pending.push((gluing.tetrahedron as usize, [tail, head].map(|i| gluing.corners.image(i))));
                }
            }
        }
    }
    let direction = |(d, class): (Option<Direction>, u32)| match is_reversed[class as usize] {
        true => Direction::Both,
        false => d.expect("every edge was reached"),
    };
    let rows =
        of_edge.into_iter().zip(edges).map(|(row, classes)| std::array::from_fn(|i| direction((row[i], classes[i]))));
    Tails { of_edge: rows.collect(), reversed: is_reversed.iter().filter(|r| **r).count() }
}

/// The same classes with numbers from 0 on, in the same order.
fn without_gaps(numbers: Vec<u32>, bound: usize) -> Vec<u32> {
    let mut used = vec![0_u32; bound];
    numbers.iter().for_each(|n| used[*n as usize] = 1);
    let mut next = 0;
    for slot in &mut used {
        next += std::mem::replace(slot, next);
    }
    numbers.into_iter().map(|n| used[n as usize]).collect()
}

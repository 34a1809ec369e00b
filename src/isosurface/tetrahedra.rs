//! Marching tetrahedra: each cell is cut into tetrahedra, and f is linear on each.

use super::cell::Tie;
use super::cube::Corner;
use super::volume::{Level, Volume};
use crate::number::Rational;
use std::collections::HashMap;
use thiserror::Error;

/// How each cell is cut into tetrahedra. All of these agree on the faces between cells, so that the surface is
/// closed; the topology of the surface depends on the choice (IS-68).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[doc(alias = "IS-68")]
pub enum Decomposition {
    /// Six tetrahedra around the diagonal from this corner to the opposite one: one for each order of the axes,
    /// along which to walk from the one to the other. Opposite corners give the same six.
    Kuhn(Corner),
    /// Five: one at each corner whose grid point has an odd coordinate sum, and one between the four others.
    Five,
}

impl Default for Decomposition {
    /// Kuhn's, around the diagonal from corner 0 to corner 7.
    fn default() -> Decomposition {
        Decomposition::Kuhn(Corner::at(0, 0, 0))
    }
}

impl Decomposition {
    /// The tetrahedra of a cell, by their corners a, b, c, d with det(b − a, c − a, d − a) > 0.
    pub fn tetrahedra(self, cell: [usize; 3]) -> Vec<[Corner; 4]> {
        match self {
            Decomposition::Kuhn(from) => kuhn(from),
            Decomposition::Five => five(cell.iter().sum::<usize>() % 2),
        }
    }
}

fn kuhn(from: Corner) -> Vec<[Corner; 4]> {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let walk = |order: [usize; 3]| {
        let [p, q, r] = [from.across(order[0]), from.across(order[0]).across(order[1]), opposite(from)];
        // The walk is right-handed iff its order is even and it starts at a corner of even coordinate sum, or
        // neither.
        let even_order = (order[0] + 1) % 3 == order[1];
        if even_order == (coordinate_sum(from).is_multiple_of(2)) { [from, p, q, r] } else { [from, q, p, r] }
    };
    ORDERS.map(walk).to_vec()
}

fn five(parity: usize) -> Vec<[Corner; 4]> {
    let mut tetrahedra = vec![if parity == 0 { [0, 5, 3, 6] } else { [1, 2, 4, 7] }.map(|c| Corner::ALL[c])];
    for c in Corner::ALL.into_iter().filter(|c| coordinate_sum(*c) % 2 != parity) {
        let [x, y, z] = [0, 1, 2].map(|axis| c.across(axis));
        tetrahedra.push(if coordinate_sum(c).is_multiple_of(2) { [c, x, y, z] } else { [c, y, x, z] });
    }
    tetrahedra
}

fn coordinate_sum(c: Corner) -> usize {
    c.position().iter().map(|x| usize::from(*x)).sum()
}

fn opposite(c: Corner) -> Corner {
    c.across(0).across(1).across(2)
}

/// What a level set cuts out of a tetrahedron, no corner being at the level: three cases, up to renumbering and
/// the exchange of f > c with f < c, of the 16 patterns of signs (IS-67). Each corner of a polygon is
/// the crossed edge, given by its ends; the polygon is counter-clockwise seen from f > c.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TetrahedronCase {
    /// All corners are on one side.
    Uncut,
    /// One corner is cut from the three others.
    Triangle([[usize; 2]; 3]),
    /// Two are cut from two.
    Quadrilateral([[usize; 2]; 4]),
}

/// The case of a tetrahedron with det(b − a, c − a, d − a) > 0, by which of its corners have f > c
/// (IS-67).
#[doc(alias = "IS-67")]
pub fn case(positive: [bool; 4]) -> TetrahedronCase {
    // Even renumberings: the corner i first; two corners i, j first.
    let with_first = |i: usize| [[0, 1, 2, 3], [1, 0, 3, 2], [2, 3, 0, 1], [3, 2, 1, 0]][i];
    let count = positive.iter().filter(|p| **p).count();
    match count {
        0 | 4 => TetrahedronCase::Uncut,
        1 | 3 => {
            let lone = positive.iter().position(|p| *p == (count == 1)).expect("one corner is alone");
            let [a, b, c, d] = with_first(lone);
            // Seen from a, b → c → d is clockwise.
            let [second, third] = if count == 1 { [d, c] } else { [c, d] };
            TetrahedronCase::Triangle([[a, b], [a, second], [a, third]])
        }
        _ => {
            let first = positive.iter().position(|p| *p).expect("two corners are positive");
            let mut order = with_first(first);
            while !positive[order[1]] {
                order[1..].rotate_left(1);
            }
            let [a, b, c, d] = order;
            TetrahedronCase::Quadrilateral([[a, c], [b, c], [b, d], [a, d]])
        }
    }
}

/// An edge of a tetrahedron: the numbers of two samples, the smaller first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SamplePair {
    /// The numbers of the samples at its ends.
    pub ends: [u32; 2],
}

/// A triangle mesh of the surface of marching tetrahedra, normals toward f > c.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct TetrahedraMesh {
    /// Its vertices, each by the edge that it lies on.
    pub vertices: Vec<SamplePair>,
    /// Its triangles, as vertex numbers, counter-clockwise seen from f > c.
    pub triangles: Vec<[u32; 3]>,
}

/// A sample of a volume that equals the isovalue.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("the sample at [{}, {}, {}] equals the isovalue", .point[0], .point[1], .point[2])]
pub struct DegenerateSample {
    /// Where it is.
    pub point: [usize; 3],
}

impl Level<'_> {
    /// Where the surface of marching tetrahedra crosses an edge: at the share t = (c − g₀) / (g₁ − g₀) of it. Only
    /// asked for crossed edges; for a tie, the limit.
    pub fn crossing_between(&self, pair: SamplePair) -> [Rational; 3] {
        let [a, b] = pair.ends.map(|end| end as usize);
        let (g0, g1) = (self.volume.sample(a), self.volume.sample(b));
        let t = Rational::from(&self.isovalue - &g0) / (g1 - &g0);
        let (a, b) = (self.volume.point(a), self.volume.point(b));
        [0, 1, 2].map(|i| {
            let (low, high) = (Rational::from(a[i]), Rational::from(b[i]));
            (high - &low) * &t + low
        })
    }
}

/// The surface {f = c}, f linear on each tetrahedron of a decomposition of the cells: a 2-manifold with boundary
/// only on the grid's border, one vertex on each crossed edge of a tetrahedron (IS-67).
///
/// Errors: iff a sample equals c and ties are not broken. Where they are, such a sample is outside, vertices have
/// their limit positions, and the surface is a manifold by its vertex numbers, though positions may coincide.
pub fn extract(level: &Level, decomposition: Decomposition) -> Result<TetrahedraMesh, DegenerateSample> {
    if let (Tie::Degenerate, Some(point)) = (level.tie, first_tie(level.volume, &level.isovalue)) {
        return Err(DegenerateSample { point });
    }
    let outside: Vec<bool> = (0..level.volume.len()).map(|index| level.is_outside(index)).collect();
    let mut numbers: HashMap<SamplePair, u32> = HashMap::new();
    let mut mesh = TetrahedraMesh::default();
    for cell in level.volume.cells() {
        for tetrahedron in decomposition.tetrahedra(cell) {
            let samples = tetrahedron.map(|c| level.volume.corner_index(cell, c));
            let mut vertex = |edge: [usize; 2]| {
                let mut ends = edge.map(|i| u32::try_from(samples[i]).expect("a volume has fewer than 2³¹ samples"));
                ends.sort();
                *numbers.entry(SamplePair { ends }).or_insert_with(|| {
                    mesh.vertices.push(SamplePair { ends });
                    u32::try_from(mesh.vertices.len() - 1).expect("fewer than 2³² vertices")
                })
            };
            match case(samples.map(|s| outside[s])) {
                TetrahedronCase::Uncut => {}
                TetrahedronCase::Triangle(edges) => mesh.triangles.push(edges.map(vertex)),
                TetrahedronCase::Quadrilateral(edges) => {
                    let [a, b, c, d] = edges.map(&mut vertex);
                    mesh.triangles.extend([[a, b, c], [a, c, d]]);
                }
            }
        }
    }
    Ok(mesh)
}

/// The first grid point whose sample equals c.
fn first_tie(volume: &Volume, isovalue: &Rational) -> Option<[usize; 3]> {
    (0..volume.len()).find(|&index| volume.sample(index) == *isovalue).map(|index| volume.point(index))
}

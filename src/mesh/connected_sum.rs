//! Connected sums, handles and cross-caps as operations on triangulated surfaces (ME-135 …).

use super::manifold::{Dimension, border};
use super::simplicial::{Simplex, SimplicialComplex};
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// Why two complexes have no sum there.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SumError {
    /// The complex has no such triangle.
    #[error("there is no triangle {0:?}")]
    NoTriangle([u32; 3]),
    /// A corner that is on the border of both complexes, by its number in the first.
    #[error("vertex {0} is on the border of both")]
    Border(u32),
    /// Two triangles of one complex that have a vertex in common.
    #[error("the triangles have vertex {0} in common")]
    Touching(u32),
    /// Both complexes have that edge, or the complex has it already.
    #[error("there is an edge from {0} to {1} already")]
    Edge(u32, u32),
    /// The link of the vertex is no cycle as long as the border of the band.
    #[error("the link of vertex {0} is no cycle of the border's length")]
    NoDisc(u32),
}

fn triangle(complex: &SimplicialComplex, corners: [u32; 3]) -> Result<Simplex, SumError> {
    let triangle = Simplex::new(&corners).ok().filter(|t| complex.contains(t));
    triangle.ok_or(SumError::NoTriangle(corners))
}

/// The connected sum of two triangulated surfaces (ME-135): a triangle is taken out of each, and their borders are glued,
/// corner to corner in order. The first one keeps its vertex numbers. χ is the sum of both less 2.
///
/// # Errors
/// Iff one of them has no such triangle, or a corner is on the border of both.
#[doc(alias = "ME-135")]
pub fn connected_sum(
    a: &SimplicialComplex,
    at: [u32; 3],
    b: &SimplicialComplex,
    to: [u32; 3],
) -> Result<SimplicialComplex, SumError> {
    let (out, into) = (triangle(a, at)?, triangle(b, to)?);
    let [border_a, border_b] = [a, b].map(|complex| border(complex, Dimension::Two));
    let is_in = |border: &SimplicialComplex, v: u32| border.contains(&Simplex::new(&[v]).expect("one vertex"));
    if let Some((v, _)) = at.into_iter().zip(to).find(|(v, w)| is_in(&border_a, *v) && is_in(&border_b, *w)) {
        return Err(SumError::Border(v));
    }
    let free = a.of_dimension(0).map(|v| v.vertices()[0] + 1).max().unwrap_or(0);
    let others = b.of_dimension(0).map(|v| v.vertices()[0]).filter(|v| !to.contains(v));
    let mut name: BTreeMap<u32, u32> = others.zip(free..).collect();
    name.extend(to.into_iter().zip(at));
    let moved = |s: &Simplex| {
        let vertices: Vec<u32> = s.vertices().iter().map(|v| name[v]).collect();
        Simplex::new(&vertices).expect("different vertices have different names")
    };
    let kept = a.maximal().into_iter().filter(|s| **s != out).cloned();
    let added = b.maximal().into_iter().filter(|s| **s != into).map(moved);
    Ok(SimplicialComplex::new(kept.chain(added)))
}

/// A handle as the text adds it (ME-137): two triangles are taken out, and a tube of six is glued to their borders, the
/// corners of the first to those of the second in order. χ falls by 2.
///
/// # Errors
/// Iff there is no such triangle, the two have a vertex in common, or an edge of the tube is there already.
#[doc(alias = "ME-137")]
pub fn with_tube(complex: &SimplicialComplex, from: [u32; 3], to: [u32; 3]) -> Result<SimplicialComplex, SumError> {
    let ends = [triangle(complex, from)?, triangle(complex, to)?];
    if let Some(common) = from.iter().find(|v| to.contains(v)) {
        return Err(SumError::Touching(*common));
    }
    let tube: Vec<[u32; 3]> = (0..3)
        .flat_map(|i| {
            let ([a, b], [c, d]) = ([from[i], from[(i + 1) % 3]], [to[i], to[(i + 1) % 3]]);
            [[a, b, d], [a, c, d]]
        })
        .collect();
    for (i, a) in from.into_iter().enumerate() {
        for b in [to[i], to[(i + 1) % 3]] {
            if complex.contains(&Simplex::new(&[a, b]).expect("they differ")) {
                return Err(SumError::Edge(a, b));
            }
        }
    }
    let kept = complex.maximal().into_iter().filter(|s| !ends.contains(s)).cloned();
    let tube = tube.iter().map(|t| Simplex::new(t).expect("three vertices of both ends"));
    Ok(SimplicialComplex::new(kept.chain(tube)))
}

/// The disc around a vertex replaced by another surface with one loop as border (ME-138): the vertex with its triangles is
/// taken out, and the border's cycle, in order, is glued to that of the vertex's link. A Möbius band makes a cross-cap.
///
/// # Errors
/// Iff the vertex has no link that is a cycle as long as the border, or an edge of the band would join two vertices of the
/// link that are joined already.
#[doc(alias = "ME-138")]
#[doc(alias = "ME-139")]
pub fn with_disc_replaced(
    complex: &SimplicialComplex,
    vertex: u32,
    band: &SimplicialComplex,
    border: &[u32],
) -> Result<SimplicialComplex, SumError> {
    let centre = Simplex::new(&[vertex]).expect("one vertex");
    let link =
        cycle(&complex.link(&centre)).filter(|link| link.len() == border.len()).ok_or(SumError::NoDisc(vertex))?;
    let free = complex.of_dimension(0).map(|v| v.vertices()[0] + 1).max().unwrap_or(0);
    let inner = band.of_dimension(0).map(|v| v.vertices()[0]).filter(|v| !border.contains(v));
    let mut name: BTreeMap<u32, u32> = inner.zip(free..).collect();
    name.extend(border.iter().copied().zip(link.iter().copied()));
    let moved: Vec<Vec<u32>> = band.maximal().iter().map(|s| s.vertices().iter().map(|v| name[v]).collect()).collect();
    let is_side =
        |a: u32, b: u32| (0..link.len()).any(|i| [[a, b], [b, a]].contains(&[link[i], link[(i + 1) % link.len()]]));
    for [a, b] in moved.iter().flat_map(|s| s.iter().flat_map(|a| s.iter().map(|b| [*a, *b]))) {
        let joined = |a: u32, b: u32| Simplex::new(&[a, b]).is_ok_and(|e| complex.contains(&e));
        if a < b && !is_side(a, b) && joined(a, b) {
            return Err(SumError::Edge(a, b));
        }
    }
    let kept = complex.maximal().into_iter().filter(|s| !s.has_face(&centre)).cloned();
    let added = moved.iter().map(|s| Simplex::new(s).expect("different vertices have different names"));
    Ok(SimplicialComplex::new(kept.chain(added)))
}

/// The vertices of a complex in order, where it is one cycle; beginning with the least one and its lesser neighbour.
pub fn cycle(complex: &SimplicialComplex) -> Option<Vec<u32>> {
    let mut neighbours: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for edge in complex.of_dimension(1) {
        let [a, b] = [edge.vertices()[0], edge.vertices()[1]];
        neighbours.entry(a).or_default().insert(b);
        neighbours.entry(b).or_default().insert(a);
    }
    if !complex.curve_defects().is_empty() || complex.component_count() != 1 {
        return None;
    }
    let (first, second) = neighbours.first_key_value().map(|(v, next)| (*v, next.first()))?;
    let mut walk = vec![first, *second?];
    while walk.len() < neighbours.len() {
        let [before, last] = [walk[walk.len() - 2], walk[walk.len() - 1]];
        walk.push(*neighbours[&last].iter().find(|v| **v != before)?);
    }
    Some(walk)
}

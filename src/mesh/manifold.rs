//! When a simplicial complex is a manifold with border, of dimension 1, 2 or 3: the links of its simplices decide.

use super::simplicial::{Simplex, SimplicialComplex};
use std::collections::BTreeMap;

/// The dimension that a manifold is to have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Dimension {
    /// Curves.
    One = 1,
    /// Surfaces.
    Two = 2,
    /// What is locally like space.
    Three = 3,
}

/// What a complex is, as the link of a simplex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum LinkKind {
    /// A sphere: the simplex is in the interior.
    Sphere,
    /// A ball: the simplex is in the border.
    Ball,
    /// None of these: near the simplex there is no manifold.
    Neither,
}

/// What keeps a complex from being a manifold with border.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ManifoldDefect {
    /// A simplex of larger dimension.
    TooLarge(Simplex),
    /// A simplex that is a face of no simplex of the dimension.
    Isolated(Simplex),
    /// A simplex whose link is neither a sphere nor a ball.
    Link {
        /// The simplex.
        simplex: Simplex,
        /// How many components its link has.
        components: usize,
        /// Its link's χ.
        chi: i64,
    },
}

/// What keeps a complex from being a manifold of that dimension, perhaps with border, sorted; empty iff it is one, or
/// has no simplices (ME-127, ME-128). A complex is one iff the link of each simplex of dimension k is a sphere or a ball of
/// dimension d − k − 1: for d = 1 two points or one at a vertex, for d = 2 the same at an edge, and a cycle or a path at a
/// vertex; for d = 3 a sphere or a disc at a vertex, which χ tells, as the links of the other simplices make it a surface.
#[doc(alias = "ME-127")]
#[doc(alias = "ME-128")]
pub fn manifold_defects(complex: &SimplicialComplex, dimension: Dimension) -> Vec<ManifoldDefect> {
    defects(complex, dimension as usize)
}

fn defects(complex: &SimplicialComplex, d: usize) -> Vec<ManifoldDefect> {
    let mut defects = Vec::new();
    for simplex in complex.simplices() {
        if simplex.dimension() > d {
            defects.push(ManifoldDefect::TooLarge(simplex.clone()));
        } else if simplex.dimension() < d {
            let link = complex.link(simplex);
            let codimension = d - simplex.dimension();
            if link.of_dimension(codimension - 1).next().is_none() {
                defects.push(ManifoldDefect::Isolated(simplex.clone()));
            } else if link_kind(&link, codimension - 1) == LinkKind::Neither {
                let (components, chi) = (link.component_count(), link.euler_characteristic());
                defects.push(ManifoldDefect::Link { simplex: simplex.clone(), components, chi });
            }
        }
    }
    defects.sort();
    defects
}

/// Whether a complex is a sphere or a ball of that dimension, at most 2. A ball of dimension 0 is a point, the sphere of
/// dimension 0 is two points. A connected curve without border is a circle, one with border a segment; a connected surface
/// is a sphere iff it is closed and χ = 2, a disc iff it has a border and χ = 1.
fn link_kind(complex: &SimplicialComplex, d: usize) -> LinkKind {
    if d == 0 {
        return match complex.f_vector()[..] {
            [1] => LinkKind::Ball,
            [2] => LinkKind::Sphere,
            _ => LinkKind::Neither,
        };
    }
    if !defects(complex, d).is_empty() || complex.component_count() != 1 {
        return LinkKind::Neither;
    }
    let of_sphere = if d == 1 { 0 } else { 2 };
    let has_border = facets_of_one(complex, d).next().is_some();
    match (has_border, complex.euler_characteristic()) {
        (false, chi) if chi == of_sphere => LinkKind::Sphere,
        (true, 1) => LinkKind::Ball,
        (false | true, _) => LinkKind::Neither,
    }
}

/// The simplices of dimension d − 1 that are a face of just one of dimension d.
fn facets_of_one(complex: &SimplicialComplex, d: usize) -> impl Iterator<Item = Simplex> {
    let mut larger: BTreeMap<Simplex, usize> = BTreeMap::new();
    for facet in complex.of_dimension(d).flat_map(|s| s.faces(d - 1)) {
        *larger.entry(facet).or_default() += 1;
    }
    larger.into_iter().filter(|(_, n)| *n == 1).map(|(facet, _)| facet)
}

/// The border: the simplices of dimension d − 1 that are a face of just one of dimension d, and their faces. Of a manifold
/// it is a closed manifold of dimension d − 1 (ME-129).
#[doc(alias = "ME-129")]
pub fn border(complex: &SimplicialComplex, dimension: Dimension) -> SimplicialComplex {
    SimplicialComplex::new(facets_of_one(complex, dimension as usize))
}

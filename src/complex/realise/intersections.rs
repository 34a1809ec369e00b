//! Whether a placement is an embedding, exactly, and how many pairs of tetrahedra say that it is not.

use super::apart::are_apart;
use super::circuit::{Side, circuit, common_point, independent};
use super::mesh::{NotSimplicial, TetrahedralMesh};
use super::points::Points;
use crate::number::Rational;
use rayon::prelude::*;

/// What was found about a placement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Intersections {
    /// What keeps the mesh from being a simplicial complex: then two of its points come to one place, or more. Nothing else is looked
    /// at.
    pub not_simplicial: Option<NotSimplicial>,
    /// How many tetrahedra are flat: their vertices are affinely dependent.
    pub flat: usize,
    /// How many pairs of tetrahedra meet outside their common face.
    pub pairs: usize,
    /// How many pairs were decided, those whose boxes meet.
    pub tested: usize,
    /// The first flat tetrahedron, or else the first pair.
    pub witness: Option<Witness>,
}

/// Two disjoint simplices, faces of these tetrahedra (the same one twice where it is flat), that meet in one point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// The two tetrahedra.
    pub tetrahedra: [u32; 2],
    /// The vertices of the two simplices.
    pub simplices: [Vec<u32>; 2],
}

impl Intersections {
    /// Whether the placement is an embedding.
    pub fn is_embedded(&self) -> bool {
        self.not_simplicial.is_none() && self.flat == 0 && self.pairs == 0
    }
}

impl Witness {
    /// The point in which they meet.
    pub fn point(&self, points: &Points) -> Vec<Rational> {
        let [first, second] =
            self.simplices.each_ref().map(|s| s.iter().map(|v| points.at(*v as usize)).collect::<Vec<_>>());
        common_point(&first, &second)
    }
}

/// Whether the map that is affine on each tetrahedron and takes the vertex i to the point i is injective.
///
/// It is iff the mesh is a simplicial complex, no tetrahedron is flat, and no two tetrahedra meet outside the image of their
/// common face. All decisions are exact.
///
/// # Panics
/// If there are not as many points as vertices.
#[doc(alias = "CX-86")]
pub fn intersections(mesh: &TetrahedralMesh, points: &Points) -> Intersections {
    assert_eq!(mesh.vertices(), points.len(), "a point for each vertex");
    let mut found =
        Intersections { not_simplicial: mesh.not_simplicial(), flat: 0, pairs: 0, tested: 0, witness: None };
    if found.not_simplicial.is_some() {
        return found;
    }
    let tetrahedra = mesh.tetrahedra();
    let at = |v: &u32| points.at(*v as usize);
    let flat: Vec<u32> = (0..tetrahedra.len() as u32)
        .into_par_iter()
        .filter(|t| !independent(&tetrahedra[*t as usize].each_ref().map(at)))
        .collect();
    let candidates = close_pairs(tetrahedra, points);
    let pairs: Vec<[u32; 2]> =
        candidates.par_iter().copied().filter(|pair| meeting(tetrahedra, points, *pair).is_some()).collect();
    (found.flat, found.pairs, found.tested) = (flat.len(), pairs.len(), candidates.len());
    let first = flat.first().map(|t| [*t, *t]).or_else(|| pairs.iter().min().copied());
    found.witness =
        first.and_then(|pair| Some(Witness { tetrahedra: pair, simplices: meeting(tetrahedra, points, pair)? }));
    found
}

/// Disjoint faces of two tetrahedra, or of one, that meet.
fn meeting(tetrahedra: &[[u32; 4]], points: &Points, [a, b]: [u32; 2]) -> Option<[Vec<u32>; 2]> {
    let [a, b] = [a, b].map(|t| tetrahedra[t as usize]);
    let places = |t: [u32; 4]| t.map(|v| points.at(v as usize));
    if a.iter().all(|v| !b.contains(v)) && are_apart(&places(a), &places(b)) {
        return None;
    }
    let mut vertices = a.to_vec();
    vertices.extend(b.iter().filter(|v| !a.contains(v)));
    let side = |v: &u32| match (a.contains(v), b.contains(v)) {
        (true, false) => Side::First,
        (false, _) => Side::Second,
        (true, true) => Side::Both,
    };
    let places: Vec<&[f64]> = vertices.iter().map(|v| points.at(*v as usize)).collect();
    let circuit = circuit(&places, &vertices.iter().map(side).collect::<Vec<_>>())?;
    Some([circuit.first, circuit.second].map(|part| part.into_iter().map(|i| vertices[i]).collect()))
}

/// A box: the least and the greatest of each coordinate.
#[derive(Clone)]
struct Box {
    lo: Vec<f64>,
    hi: Vec<f64>,
}

impl Box {
    fn around<'a>(mut points: impl Iterator<Item = &'a [f64]>) -> Box {
        let first = points.next().expect("a box has points");
        points.fold(Box { lo: first.to_vec(), hi: first.to_vec() }, |mut b, p| {
            b.lo.iter_mut().zip(p).for_each(|(lo, x)| *lo = lo.min(*x));
            b.hi.iter_mut().zip(p).for_each(|(hi, x)| *hi = hi.max(*x));
            b
        })
    }

    fn meets(&self, other: &Box) -> bool {
        let apart = |a: &Box, b: &Box| a.hi.iter().zip(&b.lo).any(|(hi, lo)| hi < lo);
        !apart(self, other) && !apart(other, self)
    }
}

/// Pairs of different tetrahedra whose boxes meet, by a tree halved at the medians of its longest axes.
fn close_pairs(tetrahedra: &[[u32; 4]], points: &Points) -> Vec<[u32; 2]> {
    let boxes: Vec<Box> = tetrahedra.iter().map(|t| Box::around(t.iter().map(|v| points.at(*v as usize)))).collect();
    let mut pairs = Vec::new();
    if !boxes.is_empty() {
        let tree = Tree::of((0..boxes.len() as u32).collect(), &boxes);
        tree.pairs_within(&boxes, &mut pairs);
    }
    pairs
}

/// So few tetrahedra are not halved.
const LEAF: usize = 4;

enum Tree {
    Leaf(Box, Vec<u32>),
    Halves(Box, std::boxed::Box<[Tree; 2]>),
}

impl Tree {
    fn of(mut items: Vec<u32>, boxes: &[Box]) -> Tree {
        let ends = items.iter().flat_map(|i| [&boxes[*i as usize].lo[..], &boxes[*i as usize].hi]);
        let hull = Box::around(ends);
        if items.len() <= LEAF {
            return Tree::Leaf(hull, items);
        }
        let length = |axis: &usize| hull.hi[*axis] - hull.lo[*axis];
        let axis = (0..hull.lo.len()).max_by(|i, j| length(i).total_cmp(&length(j))).expect("n ≥ 1");
        // Halved before they are added, so that their sum cannot overflow.
        let middle = |i: &u32| boxes[*i as usize].lo[axis] / 2.0 + boxes[*i as usize].hi[axis] / 2.0;
        let half = items.len() / 2;
        items.select_nth_unstable_by(half, |i, j| middle(i).total_cmp(&middle(j)).then(i.cmp(j)));
        let upper = items.split_off(half);
        Tree::Halves(hull, std::boxed::Box::new([Tree::of(items, boxes), Tree::of(upper, boxes)]))
    }

    fn hull(&self) -> &Box {
        match self {
            Tree::Leaf(hull, _) | Tree::Halves(hull, _) => hull,
        }
    }

    fn pairs_within(&self, boxes: &[Box], pairs: &mut Vec<[u32; 2]>) {
        match self {
            Tree::Leaf(_, items) => {
                for (k, i) in items.iter().enumerate() {
                    items[k + 1..].iter().for_each(|j| meet(*i, *j, boxes, pairs));
                }
            }
            Tree::Halves(_, halves) => {
                halves.iter().for_each(|half| half.pairs_within(boxes, pairs));
                halves[0].pairs_with(&halves[1], boxes, pairs);
            }
        }
    }

    fn pairs_with(&self, other: &Tree, boxes: &[Box], pairs: &mut Vec<[u32; 2]>) {
        if !self.hull().meets(other.hull()) {
            return;
        }
        match (self, other) {
            (Tree::Leaf(_, a), Tree::Leaf(_, b)) => {
                for i in a {
                    b.iter().for_each(|j| meet(*i, *j, boxes, pairs));
                }
            }
            (Tree::Halves(_, halves), _) => halves.iter().for_each(|half| half.pairs_with(other, boxes, pairs)),
            (Tree::Leaf(..), Tree::Halves(_, halves)) => {
                halves.iter().for_each(|half| self.pairs_with(half, boxes, pairs));
            }
        }
    }
}

fn meet(i: u32, j: u32, boxes: &[Box], pairs: &mut Vec<[u32; 2]>) {
    if boxes[i as usize].meets(&boxes[j as usize]) {
        pairs.push([i.min(j), i.max(j)]);
    }
}

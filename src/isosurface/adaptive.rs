//! Level sets of polynomials by cells refined until the topology in each is proven (the text's figure 48;
//! IS-69).
//!
//! **Certified.** A closed cell is certified iff f ≠ c at its 8 corners, and on each of its 12 edges, its 6 faces
//! and itself, f − c has a strict sign or the derivative of f along one of the part's own axes has one; all signs
//! proven by Bernstein coefficients.
//!
//! **Theorem.** Let S = {f = c} and the cell C be certified. (1) S meets an edge in one point if f − c has
//! different signs at its ends, else not at all. (2) S meets a face in ∅ or in one arc, whose ends are two
//! crossings of (1) and which meets the face's edges nowhere else: in ∅ iff its corners have one sign. (3) S ∩ C is
//! ∅ iff all corners have one sign; else it is a closed disk that meets ∂C in its boundary circle only, made of the
//! arcs of (2). This is also what the trilinear function with the corner values does in C.
//!
//! *Proof.* Write f for f − c. (1) A monotone function has at most one zero, and the ends are none.
//! (2) Let f increase with u on the face (else mirror it). S ∩ F is the graph of u over
//! V = {v : f(0,v) ≤ 0 ≤ f(1,v)}. By (1), f(0,·) and f(1,·) vanish at most once and change sign there, so both
//! conditions hold on intervals, and V is one. It is no single point v: one of f(0,v) < f(1,v) is not zero, so V
//! would end on both sides of v where the other one is zero, or at v = 0 or 1, where it is not as no corner is
//! zero. An end of V lies at v = 0 or 1, or where f(0,·) or f(1,·) is zero: on an edge. Inside V neither is zero,
//! so the arc's inner points are inner points of F. If V is empty, no edge is crossed; an arc has two crossings;
//! so the corners have one sign iff V = ∅.
//! (3) Let f increase with u on C. S ∩ C is a graph over V = A ∩ B, A = {f(0,·) ≤ 0}, B = {f(1,·) ≥ 0} in the
//! square Q. By (2) the complements A′ and B′ are each ∅, Q, or one side of an arc that ends on ∂Q; A′ and B′ are
//! disjoint, and so are the arcs, as f(0,·) < f(1,·). So V is ∅ iff A′ or B′ is Q, as Q is connected; else it is
//! the disk Q less two disjoint regions cut off by arcs: a disk. Its boundary is where f(0,·) = 0, f(1,·) = 0, or
//! the point is on ∂Q: where the graph is on ∂C. If V = ∅, the corners on one face u = const, and by monotony all
//! others, have one sign; if not, the circle crosses the boundary of some face, by (2) in an edge.
//! The corner values have no ambiguous face, as four crossings on a face contradict (2), and one loop on ∂C;
//! so the trilinear surface is one disk on the same edges. ∎
//!
//! **What stays uncertified.** A certified cell holds no singular point of S, as a derivative is not zero in it,
//! no corner on S, and no point where S touches one of the cell's edges or faces. So, at every depth, the
//! uncertified leaves cover all singular points of S and all such contacts. They close in on S, for f ≠ c holds
//! away from it and Bernstein coefficients converge to f. Contacts move with the share at which cells are split,
//! singular points do not. Near-contacts cost depth: an edge that S crosses twice is certified only when a cut
//! falls between the crossings. That regular surfaces without contacts are always certified at some depth is not
//! claimed.

use super::bernstein::{Bernstein, Extent, Part, Region};
use super::cube::{Corner, Edge, Face};
use super::topology::SurfaceComponent;
use crate::number::Trivariate;
use crate::number::{Rational, Sign};
use crate::partition::Partition;
use std::collections::{BTreeMap, HashMap};
use thiserror::Error;

/// How far and where to split cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refinement {
    /// How often a cell may be split, at most [`Refinement::DEEPEST`].
    pub max_depth: u32,
    /// The share of each axis at which a cell is split, 0 < share < 1.
    pub split: Rational,
}

impl Refinement {
    /// The greatest `max_depth`.
    pub const DEEPEST: u32 = 30;

    /// Splits in the middle.
    pub fn halving(max_depth: u32) -> Refinement {
        Refinement { max_depth, split: Rational::from((1, 2)) }
    }
}

/// Why there is nothing to refine.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum AdaptiveError {
    /// The split is not inside a cell.
    #[error("split: {0} is not between 0 and 1")]
    Split(Rational),
    /// The depth is beyond the limit.
    #[error("max_depth: {0} is more than {limit}", limit = Refinement::DEEPEST)]
    TooDeep(u32),
    /// f = c everywhere.
    #[error("the function equals the isovalue everywhere")]
    Everywhere,
}

/// What is proven about a leaf of the octree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The closed cell does not meet the surface: f − c has this sign.
    Empty(Sign),
    /// The surface in the closed cell is one disk, and its boundary circle the surface on the cell's boundary.
    Simple {
        /// The set of the corners with f > c: it determines which edges and faces the disk meets.
        positive: u8,
        /// An axis along which f is strictly monotone: the disk is a graph over the two others.
        axis: usize,
    },
    /// At the greatest depth, and a part of the cell is not certified: the least one by dimension.
    Uncertified(Part),
}

/// A leaf of the octree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// How often the box was split.
    pub depth: u32,
    /// Where: bit depth − 1 − n of each coordinate tells which side it is on at split n.
    pub address: [u32; 3],
    /// What is proven.
    pub verdict: Verdict,
}

/// How many leaves there are of a kind, and their volume.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Tally {
    /// How many.
    pub leaves: usize,
    /// Their volume together.
    pub volume: Rational,
}

/// The leaves by their verdict.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Census {
    /// Without surface.
    pub empty: Tally,
    /// With a disk.
    pub simple: Tally,
    /// Not certified.
    pub uncertified: Tally,
}

/// A box cut into leaves, each with what is proven about the surface in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Adapted {
    region: Region,
    split: Rational,
    leaves: Vec<Leaf>,
}

/// Cuts a box into cells until {f = c} is certified in each, or the greatest depth is reached (IS-69).
///
/// Errors: iff the split is not between 0 and 1, the depth is beyond [`Refinement::DEEPEST`], or f − c is zero.
#[doc(alias = "IS-69")]
pub fn adapt(
    f: &Trivariate,
    isovalue: &Rational,
    region: Region,
    refinement: &Refinement,
) -> Result<Adapted, AdaptiveError> {
    let Refinement { max_depth, split } = refinement.clone();
    if split <= 0 || split >= 1 {
        return Err(AdaptiveError::Split(split));
    }
    if max_depth > Refinement::DEEPEST {
        return Err(AdaptiveError::TooDeep(max_depth));
    }
    let level = f.clone() - &Trivariate::constant(isovalue.clone());
    if level.is_zero() {
        return Err(AdaptiveError::Everywhere);
    }
    let parts = Part::all();
    let mut leaves = Vec::new();
    let mut pending = vec![(0, [0; 3], Bernstein::of(&level, &region))];
    while let Some((depth, address, form)) = pending.pop() {
        let verdict = match certify(&form, &parts) {
            Ok(verdict) => verdict,
            Err(part) if depth == max_depth => Verdict::Uncertified(part),
            Err(_) => {
                let children = form.split(split.numer(), split.denom()).into_iter().zip(Corner::ALL);
                pending.extend(children.rev().map(|(form, c)| {
                    let side = c.position();
                    (depth + 1, [0, 1, 2].map(|i| 2 * address[i] + u32::from(side[i])), form)
                }));
                continue;
            }
        };
        leaves.push(Leaf { depth, address, verdict });
    }
    Ok(Adapted { region, split, leaves })
}

/// The certificate of a cell, or the first part that has none. Parts in order of dimension.
fn certify(form: &Bernstein, parts: &[Part]) -> Result<Verdict, Part> {
    if let Some(sign) = form.sign(Part::WHOLE) {
        return Ok(Verdict::Empty(sign));
    }
    let monotone = |part: Part| part.axes().find(|&axis| form.slope(part, axis).is_some());
    if let Some(part) = parts.iter().find(|part| form.sign(**part).is_none() && monotone(**part).is_none()) {
        return Err(*part);
    }
    let axis = monotone(Part::WHOLE).ok_or(Part::WHOLE)?;
    let above = |c: &Corner| form.sign(Part::corner(*c)) == Some(Sign::Positive);
    Ok(match Corner::ALL.iter().filter(|c| above(c)).fold(0, |set, c| set | c.bit()) {
        0 => Verdict::Empty(Sign::Negative),
        0xff => Verdict::Empty(Sign::Positive),
        positive => Verdict::Simple { positive, axis },
    })
}

impl Leaf {
    /// Whether the disk meets a part of the cell that is no corner: iff its corners have two signs.
    fn meets(&self, part: Part) -> bool {
        match self.verdict {
            Verdict::Empty(_) | Verdict::Uncertified(_) => false,
            Verdict::Simple { positive, .. } => positive & part.corners() != 0 && !positive & part.corners() != 0,
        }
    }

    /// Whether a face lies on the border of the box.
    fn on_border(&self, face: Face) -> bool {
        self.address[face.axis()] == if face.side() == 0 { 0 } else { (1 << self.depth) - 1 }
    }
}

fn face_part(face: Face) -> Part {
    let mut part = Part::WHOLE;
    part.0[face.axis()] = if face.side() == 0 { Extent::Low } else { Extent::High };
    part
}

fn edge_part(edge: Edge) -> Part {
    let mut part = Part::corner(edge.corners()[0]);
    part.0[edge.axis()] = Extent::Across;
    part
}

impl Adapted {
    /// The leaves.
    pub fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    /// The cell of a leaf.
    pub fn cell(&self, leaf: &Leaf) -> Region {
        (0..leaf.depth).rev().fold(self.region.clone(), |region, bit| {
            let [x, y, z] = leaf.address.map(|a| (a >> bit & 1) as u8);
            region.child(Corner::at(x, y, z), &self.split)
        })
    }

    /// The leaves and their volumes by verdict; the volumes add up to that of the box.
    pub fn census(&self) -> Census {
        let mut census = Census::default();
        for leaf in &self.leaves {
            let tally = match leaf.verdict {
                Verdict::Empty(_) => &mut census.empty,
                Verdict::Simple { .. } => &mut census.simple,
                Verdict::Uncertified(_) => &mut census.uncertified,
            };
            tally.leaves += 1;
            tally.volume += self.cell(leaf).volume();
        }
        census
    }

    /// The components of {f = c} in the closed box, sorted, with their Euler characteristic and their boundary
    /// loops on the box's border; `None` iff a leaf is uncertified.
    ///
    /// χ is additive over the half-open cells, which partition the box whatever sizes meet: an open disk
    /// counts 1, an open arc −1, a point 1.
    pub fn topology(&self) -> Option<Vec<SurfaceComponent>> {
        if self.leaves.iter().any(|leaf| matches!(leaf.verdict, Verdict::Uncertified(_))) {
            return None;
        }
        let places: HashMap<(u32, [u32; 3]), usize> =
            self.leaves.iter().enumerate().map(|(i, leaf)| ((leaf.depth, leaf.address), i)).collect();
        let mut disks = Partition::new(self.leaves.len());
        let mut arcs = Partition::new(6 * self.leaves.len());
        for (i, leaf) in self.leaves.iter().enumerate() {
            for face in Face::ALL.into_iter().filter(|face| leaf.meets(face_part(*face))) {
                if !leaf.on_border(face) {
                    if let Some(neighbour) = not_smaller(&places, leaf, face) {
                        disks.join(i, neighbour);
                    }
                    continue;
                }
                // An arc on the border goes on across each crossed edge of its face.
                for edge in Edge::ALL.into_iter().filter(|e| e.in_face(face) && leaf.meets(edge_part(*e))) {
                    let other = Face::ALL.into_iter().find(|g| *g != face && edge.in_face(*g));
                    let other = other.expect("an edge lies in two faces");
                    if leaf.on_border(other) {
                        arcs.join(6 * i + face.index(), 6 * i + other.index());
                    } else if let Some(neighbour) = not_smaller(&places, leaf, other) {
                        arcs.join(6 * i + face.index(), 6 * neighbour + face.index());
                    }
                }
            }
        }
        let mut totals: BTreeMap<usize, SurfaceComponent> = BTreeMap::new();
        for (i, leaf) in self.leaves.iter().enumerate().filter(|(_, leaf)| leaf.meets(Part::WHOLE)) {
            let none = SurfaceComponent { chi: 0, boundary_loops: 0, genus: 0 };
            let total = totals.entry(disks.find(i)).or_insert(none);
            total.chi += chi(leaf);
            let loops = Face::ALL.into_iter().filter(|face| leaf.on_border(*face) && leaf.meets(face_part(*face)));
            total.boundary_loops += loops.filter(|f| arcs.find(6 * i + f.index()) == 6 * i + f.index()).count() as i64;
        }
        let mut components: Vec<_> = totals.into_values().collect();
        for component in &mut components {
            component.genus = (2 - component.chi - component.boundary_loops) / 2;
        }
        components.sort();
        Some(components)
    }

    /// The Euler characteristic of {f = c} in the closed box; `None` iff a leaf is uncertified.
    pub fn chi(&self) -> Option<i64> {
        Some(self.topology()?.iter().map(|component| component.chi).sum())
    }
}

/// The leaf across a face inside the box, unless it is smaller.
fn not_smaller(places: &HashMap<(u32, [u32; 3]), usize>, leaf: &Leaf, face: Face) -> Option<usize> {
    let mut address = leaf.address;
    let along = &mut address[face.axis()];
    *along = if face.side() == 0 { *along - 1 } else { *along + 1 };
    (0..=leaf.depth).find_map(|up| places.get(&(leaf.depth - up, address.map(|a| a >> up))).copied())
}

/// χ of the surface in the half-open cell: with its low parts, and the high ones on the border of the box.
fn chi(leaf: &Leaf) -> i64 {
    let counted = |part: &Part| {
        (0..3).all(|axis| match part.0[axis] {
            Extent::Low | Extent::Across => true,
            Extent::High => leaf.on_border(Face::new(axis, 1)),
        })
    };
    let faces = Face::ALL.map(face_part).into_iter().filter(|part| counted(part) && leaf.meets(*part)).count() as i64;
    let edges = Edge::ALL.map(edge_part).into_iter().filter(|part| counted(part) && leaf.meets(*part)).count() as i64;
    1 - faces + edges
}

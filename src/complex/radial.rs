//! Radial subdivision: topological tetrahedra cut into slices around an edge, so that none is glued to itself.

use super::refine::MAX_TETRAHEDRA;
use super::triangulation::{TriangleGluing, Triangulation};
use super::{permutation::Perm4, tetrahedra};
use thiserror::Error;

/// The edge of a topological tetrahedron that is split; the slices lie around the other one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// The edge e, corners 0 and 1: slices around the dual edge f′.
    Primal,
    /// The dual edge f′, corners 2 and 3: slices around e, as in 000, figure 5.
    Dual,
}

impl Axis {
    /// Its two corners.
    pub fn corners(self) -> [usize; 2] {
        match self {
            Axis::Primal => tetrahedra::PRIMAL,
            Axis::Dual => tetrahedra::DUAL,
        }
    }
}

/// Why tetrahedra cannot be cut into slices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum SliceError {
    /// A gluing does not lay {0, 1} on {0, 1}.
    #[error("triangle {triangle} of tetrahedron {tetrahedron} is glued with an end of e at an end of f′")]
    NotPaired {
        /// The tetrahedron.
        tetrahedron: usize,
        /// The triangle.
        triangle: usize,
    },
    /// There is not one number of slices for each tetrahedron.
    #[error("{slices} numbers of slices for {tetrahedra} tetrahedra")]
    Length {
        /// How many numbers.
        slices: usize,
        /// How many tetrahedra.
        tetrahedra: usize,
    },
    /// A tetrahedron is cut into 0 slices.
    #[error("tetrahedron {0} is cut into 0 slices; there is at least 1")]
    NoSlice(usize),
    /// Two tetrahedra at an edge that is split have different numbers of slices.
    #[error("tetrahedra {0} and {1} have the edge that is split in common, and different numbers of slices")]
    Different(usize, usize),
    /// There would be more than 2²⁷ tetrahedra.
    #[error("there would be more than 2²⁷ tetrahedra")]
    TooLarge,
}

/// A radial subdivision, and into how many slices each tetrahedron was cut around e, and then each of those around f′.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Radial {
    /// The slices, glued. They are topological tetrahedra again: corners 0 and 1 on an edge e, 2 and 3 on an edge f′.
    pub triangulation: Triangulation,
    /// By tetrahedron: how many slices around e.
    pub around_primal: Vec<u32>,
    /// By tetrahedron: how many slices around f′ each of those has.
    pub around_dual: Vec<u32>,
}

/// The triangulation with the edges of an axis split: tetrahedron i is cut into `slices[i]` by triangles that have the other edge
/// and a point of the axis, slice s lying between its points s and s + 1 counted from its corner of smaller number.
///
/// All tetrahedra around an edge that is split are cut, for they have its new points too. The space is the same; the edge
/// opposite gets as many tetrahedra as there are slices, in all, of those around it.
///
/// # Errors
/// Iff a gluing does not keep {0, 1} | {2, 3}, the list is of another length, a number is 0 or another one than that of a neighbour with the
/// same axis, or there would be more than 2²⁷ tetrahedra.
#[doc(alias = "CX-50")]
pub fn slice(base: &Triangulation, axis: Axis, slices: &[u32]) -> Result<Triangulation, SliceError> {
    let [low, high] = axis.corners();
    let starts = starts(base, axis, slices)?;
    let mut gluings = Vec::with_capacity(starts[base.len()] as usize);
    for (tetrahedron, outer) in base.gluings().iter().enumerate() {
        let last = slices[tetrahedron] - 1;
        for s in 0..=last {
            gluings.push([0, 1, 2, 3].map(|triangle| {
                let next =
                    |s: u32| TriangleGluing { tetrahedron: starts[tetrahedron] + s, corners: transposition(low, high) };
                let TriangleGluing { tetrahedron: other, corners } = outer[triangle];
                let image = corners.image(triangle);
                // The triangle opposite the high corner is at the low end of the slice.
                let place = match triangle {
                    _ if triangle == high && s > 0 => return next(s - 1),
                    _ if triangle == low && s < last => return next(s + 1),
                    _ if triangle == high || triangle == low => {
                        if image == high {
                            0
                        } else {
                            slices[other as usize] - 1
                        }
                    }
                    _ => {
                        if corners.image(low) == low {
                            s
                        } else {
                            last - s
                        }
                    }
                };
                TriangleGluing { tetrahedron: starts[other as usize] + place, corners }
            }));
        }
    }
    Ok(Triangulation::new(gluings).expect("what is glued to a slice is glued back"))
}

/// The first slice of each tetrahedron, and the number of all.
fn starts(base: &Triangulation, axis: Axis, slices: &[u32]) -> Result<Vec<u32>, SliceError> {
    if slices.len() != base.len() {
        return Err(SliceError::Length { slices: slices.len(), tetrahedra: base.len() });
    }
    let mut starts = vec![0_u32];
    for (tetrahedron, gluings) in base.gluings().iter().enumerate() {
        for (triangle, gluing) in gluings.iter().enumerate() {
            if !keeps_pairing(gluing.corners) {
                return Err(SliceError::NotPaired { tetrahedron, triangle });
            }
            let has_axis = !axis.corners().contains(&triangle);
            if has_axis && slices[tetrahedron] != slices[gluing.tetrahedron as usize] {
                return Err(SliceError::Different(tetrahedron, gluing.tetrahedron as usize));
            }
        }
        let end = starts[tetrahedron].checked_add(slices[tetrahedron]).filter(|n| *n <= MAX_TETRAHEDRA as u32);
        match slices[tetrahedron] {
            0 => return Err(SliceError::NoSlice(tetrahedron)),
            _ => starts.push(end.ok_or(SliceError::TooLarge)?),
        }
    }
    Ok(starts)
}

/// Whether it takes {0, 1} to itself.
pub fn keeps_pairing(corners: Perm4) -> bool {
    corners.image(0) / 2 == 0 && corners.image(1) / 2 == 0
}

fn transposition(i: usize, j: usize) -> Perm4 {
    let mut images = [0, 1, 2, 3];
    images.swap(i, j);
    Perm4::new(images).expect("a permutation")
}

/// The radial subdivision (000, section 5.2, figure 5), in primal and then in dual space: the fewest slices, edge by edge, with which at
/// least three tetrahedra stand around each edge e, and then around each dual edge f′. No tetrahedron is glued to itself then.
///
/// A tetrahedron alone around e, aFnext = a, is cut into 3: of 2 each has the other's triangles on both sides, and so its four vertices
/// (CX-51). Where all rings have three already, nothing changes.
///
/// # Errors
/// Iff a gluing does not keep {0, 1} | {2, 3} or there would be more than 2²⁷ tetrahedra.
#[doc(alias = "CX-35")]
#[doc(alias = "CX-51")]
#[doc(alias = "CX-52")]
pub fn radial(base: &Triangulation) -> Result<Radial, SliceError> {
    let skeleton = base.skeleton();
    let classes = |edge: usize| -> Vec<usize> { skeleton.edges.iter().map(|edges| edges[edge] as usize).collect() };
    // Edge 01 of a tetrahedron and edge 23.
    let [primal, dual] = [classes(0), classes(5)];
    let around_primal = slices_for_rings(&primal, &dual, skeleton.counts[1]);
    let around_dual = slices_for_rings(&dual, &primal, skeleton.counts[1]);
    let cut = slice(base, Axis::Dual, &around_primal)?;
    let repeated = around_dual.iter().zip(&around_primal).flat_map(|(n, times)| vec![*n; *times as usize]);
    let triangulation = slice(&cut, Axis::Primal, &repeated.collect::<Vec<_>>())?;
    Ok(Radial { triangulation, around_primal, around_dual })
}

/// For each tetrahedron a number of slices, the same for all with one split edge, such that each ring has three or more.
fn slices_for_rings(ring_of: &[usize], split_of: &[usize], edges: usize) -> Vec<u32> {
    let mut slices = vec![1_u32; edges];
    let mut rings: Vec<Vec<usize>> = vec![Vec::new(); edges];
    ring_of.iter().zip(split_of).for_each(|(ring, split)| rings[*ring].push(*split));
    for ring in rings.iter().filter(|ring| !ring.is_empty()) {
        while ring.iter().map(|split| slices[*split]).sum::<u32>() < 3 {
            slices[ring[0]] += 1;
        }
    }
    split_of.iter().map(|split| slices[*split]).collect()
}

//! The fast twin of `cell`, `mesh` and `topology` for whole volumes: the same meaning.
//!
//! Integer volumes are decided by machine integers, others by enclosures and, where these leave a sign open, by the
//! exact rationals of the plain version; the triangles come from the frozen table. Most cells of a volume are uniform and are passed over by
//! their signs alone.

use super::cell::{Decisions, decide, decide_below};
use super::cube::{Corner, Face};
use super::interior;
use super::mesh::{Mesh, Vertex, push};
use super::patch::PatchVertex;
use super::table::Table;
use super::topology::{GridTopology, gather};
use super::volume::{DegenerateCell, Level, small_differences};
use crate::number::{F64Interval, Sign, Word};
use thiserror::Error;

/// The corners of the ambiguous faces of each of the 256 sign configurations.
struct Ambiguity {
    faces: Vec<Vec<(Face, [usize; 4], bool)>>,
}

impl Ambiguity {
    fn new() -> Ambiguity {
        let ambiguous = |positive: u8| {
            Face::ALL
                .into_iter()
                .filter_map(|face| {
                    let corners = face.cycle();
                    let [p, q, r, s] = corners.map(|c| positive & c.bit() != 0);
                    (p == r && q == s && p != q).then_some((face, corners.map(Corner::index), p))
                })
                .collect()
        };
        Ambiguity { faces: (0..=255).map(ambiguous).collect() }
    }
}

/// Whether each sample of a level is outside, f > c; a tie is.
pub fn outside(level: &Level) -> Vec<bool> {
    sides(level, small_differences(level).as_deref()).into_iter().map(|side| side != Sign::Negative).collect()
}

/// The sign of f − c at each sample.
fn sides(level: &Level, small: Option<&[i32]>) -> Vec<Sign> {
    match small {
        Some(differences) => differences.iter().map(|d| Sign::of(d.cmp(&0))).collect(),
        None => (0..level.volume.len()).map(|i| level.side(i)).collect(),
    }
}

/// The first cell of which c is a critical value, if there is one.
///
/// # Errors
/// That cell.
pub fn regular(level: &Level) -> Result<(), DegenerateCell> {
    let decider = Decider::new(level);
    level.volume.cells().try_for_each(|cell| decider.decisions(cell).map(drop))
}

/// Decides the cells of a level, and knows their triangles.
pub struct Decider<'a, 'b> {
    level: &'a Level<'b>,
    table: Table,
    ambiguity: Ambiguity,
    /// The samples less c, where they are small integers.
    small: Option<Vec<i32>>,
    /// The sign of f − c at each sample.
    sides: Vec<Sign>,
    /// The numbers of a cell's corners, less that of its lowest.
    offsets: [usize; 8],
}

impl<'a, 'b> Decider<'a, 'b> {
    /// Prepares a level.
    pub fn new(level: &'a Level<'b>) -> Decider<'a, 'b> {
        let small = small_differences(level);
        let sides = sides(level, small.as_deref());
        let offsets = Corner::ALL.map(|c| level.volume.corner_index([0; 3], c));
        Decider { level, table: Table::frozen(), ambiguity: Ambiguity::new(), small, sides, offsets }
    }

    /// The table.
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// The set of the corners of a cell that are outside.
    pub fn signs(&self, cell: [usize; 3]) -> u8 {
        let low = self.level.volume.index(cell);
        (0..8).fold(0, |set, c| set | u8::from(self.sides[low + self.offsets[c]] != Sign::Negative) << c)
    }

    /// The decisions of a cell; equal to [`Level::decisions`].
    pub fn decisions(&self, cell: [usize; 3]) -> Result<Decisions, DegenerateCell> {
        let Some(differences) = &self.small else { return self.decide_exact(cell) };
        let low = self.level.volume.index(cell);
        let values = self.offsets.map(|offset| i64::from(differences[low + offset]));
        match self.decide_small(&values) {
            Some(decisions) => Ok(decisions),
            // A tie: the plain version says where, or breaks it.
            None if self.level.tie == super::cell::Tie::Below => Ok(decide_below(&values.map(|v| Word(i128::from(v))))),
            None => self.level.decisions(cell),
        }
    }

    /// By the signs of the samples where they agree, by enclosures where these settle it, else by rationals.
    fn decide_exact(&self, cell: [usize; 3]) -> Result<Decisions, DegenerateCell> {
        let low = self.level.volume.index(cell);
        let is_tied = self.offsets.iter().any(|offset| self.sides[low + offset] == Sign::Zero);
        match self.signs(cell) {
            positive @ (0 | 255) if !is_tied => Ok(Decisions { positive, faces: [0; 6], tunnel: None }),
            _ => {
                let difference = |offset| self.level.volume.sample(low + offset) - &self.level.isovalue;
                let enclosures = self.offsets.map(|offset| F64Interval::from_rational(&difference(offset)));
                decide(&enclosures).or_else(|_| self.level.decisions(cell))
            }
        }
    }

    #[doc(alias = "IS-93")]
    fn decide_small(&self, values: &[i64; 8]) -> Option<Decisions> {
        if values.contains(&0) {
            return None;
        }
        let positive = (0..8).fold(0u8, |set, c| set | u8::from(values[c] > 0) << c);
        let mut decisions = Decisions { positive, faces: [0; 6], tunnel: None };
        let mut joining = 0;
        for (face, [p, q, r, s], p_is_positive) in &self.ambiguity.faces[usize::from(positive)] {
            let determinant = values[*p] * values[*r] - values[*q] * values[*s];
            if determinant == 0 {
                return None;
            }
            let joins_positive = (determinant > 0) == *p_is_positive;
            decisions.faces[face.index()] = if joins_positive { 1 } else { -1 };
            joining |= u8::from(joins_positive) << face.index();
        }
        // Where no tunnel can be, no critical point inside can be at the isovalue either (IS-93).
        if !self.table.entry(positive, joining).tunnels.is_empty() {
            let join = interior::join(&values.map(|v| Word(i128::from(v)))).ok()?;
            decisions.tunnel = join.and_then(|join| decisions.as_tunnel(join));
        }
        Some(decisions)
    }
}

/// The mesh of a level; equal to [`mesh::extract`](super::mesh::extract), vertex for vertex.
pub fn extract(level: &Level) -> Result<Mesh, DegenerateCell> {
    extract_with(level, |_| {})
}

/// The same; `progress` is told the number of each layer of cells that is done.
pub fn extract_with(level: &Level, mut progress: impl FnMut(usize)) -> Result<Mesh, DegenerateCell> {
    const NONE: u32 = u32::MAX;
    let decider = Decider::new(level);
    let mut mesh = Mesh::default();
    let mut numbers = vec![NONE; 3 * level.volume.len()];
    let mut layer = 0;
    for cell in level.volume.cells() {
        if cell[2] != layer {
            progress(layer);
            layer = cell[2];
        }
        if matches!(decider.signs(cell), 0 | 255) && level.tie == super::cell::Tie::Below {
            continue;
        }
        let decisions = decider.decisions(cell)?;
        let patch = decider.table.patch(&decisions);
        let first_inner = mesh.vertices.len() as u32;
        for rim in &patch.inner {
            let edges = rim.iter().map(|edge| level.grid_edge(cell, *edge)).collect();
            push(&mut mesh.vertices, Vertex::Inner(edges));
        }
        for triangle in &patch.triangles {
            mesh.triangles.push(triangle.map(|vertex| match vertex {
                PatchVertex::Inner(i) => first_inner + u32::from(i),
                PatchVertex::Crossing(edge) => {
                    let edge = level.grid_edge(cell, edge);
                    let number = &mut numbers[3 * edge.low as usize + usize::from(edge.axis)];
                    if *number == NONE {
                        *number = push(&mut mesh.vertices, Vertex::Crossing(edge));
                    }
                    *number
                }
            }));
        }
    }
    progress(layer);
    Ok(mesh)
}

/// A cell that the fast and the plain version decide differently: a bug.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("cell {cell:?}: the fast version decides {fast:?}, the plain one {plain:?}; please report this")]
pub struct Mismatch {
    /// The lowest grid point of the cell.
    pub cell: [usize; 3],
    /// The fast version's decisions.
    pub fast: Box<Result<Decisions, DegenerateCell>>,
    /// The plain version's.
    pub plain: Box<Result<Decisions, DegenerateCell>>,
}

/// Decides about one in `every` of the cells by the plain version too, the ones that a hash of their number and `seed`
/// chooses, and tells how many those were.
///
/// # Errors
/// The first cell that the two decide differently.
pub fn audit(level: &Level, every: u64, seed: u64) -> Result<usize, Mismatch> {
    let decider = Decider::new(level);
    let chosen = level
        .volume
        .cells()
        .filter(|cell| hash(level.volume.index(*cell) as u64 ^ seed.rotate_left(32)).is_multiple_of(every.max(1)));
    let mut audited = 0;
    for cell in chosen {
        let (fast, plain) = (decider.decisions(cell), level.decisions(cell));
        if fast != plain {
            return Err(Mismatch { cell, fast: Box::new(fast), plain: Box::new(plain) });
        }
        audited += 1;
    }
    Ok(audited)
}

/// The finaliser of SplitMix64: every bit of the result depends on every bit of x.
const fn hash(x: u64) -> u64 {
    let x = x.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let x = (x ^ x >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let x = (x ^ x >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
    x ^ x >> 31
}

/// The topology of a level; equal to [`topology::topology`](super::topology::topology).
pub fn topology(level: &Level) -> Result<GridTopology, DegenerateCell> {
    let decider = Decider::new(level);
    gather(level, |cell| decider.decisions(cell))
}

//! The topology of a whole piecewise trilinear isosurface (IS-62).

use super::boundary::arcs;
use super::cell::{Decisions, assemble};
use super::cube::{Corner, Edge, Face};
use super::volume::{DegenerateCell, GridEdge, Level};
use crate::partition::Partition;
use std::collections::{BTreeMap, HashMap};

/// One component of an isosurface, ordered by its Euler characteristic, then its loops.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SurfaceComponent {
    /// Its Euler characteristic.
    pub chi: i64,
    /// How many boundary loops it has, all on the border of the grid.
    pub boundary_loops: i64,
    /// Its genus: χ = 2 − 2·genus − loops, for a surface between two regions is orientable.
    pub genus: i64,
}

/// The topology of a whole isosurface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GridTopology {
    /// Its components, sorted.
    pub components: Vec<SurfaceComponent>,
    /// How many components {f ≤ c} has in the grid's box.
    pub b0_negative: usize,
    /// How many components {f ≥ c} has.
    pub b0_positive: usize,
    /// How many edges of the grid it crosses.
    pub edge_crossings: usize,
}

impl GridTopology {
    /// The Euler characteristic of the whole.
    pub fn chi(&self) -> i64 {
        self.components.iter().map(|c| c.chi).sum()
    }

    /// How many boundary loops there are.
    pub fn boundary_loops(&self) -> i64 {
        self.components.iter().map(|c| c.boundary_loops).sum()
    }
}

/// What the cells say, gathered: which samples and which crossings are connected, and what each cell adds
/// to χ.
struct Gathering<'a, 'b> {
    level: &'a Level<'b>,
    samples: Partition,
    crossings: Partition,
    numbers: HashMap<GridEdge, usize>,
    /// χ of the pieces inside cells less the arcs between them, by a crossing of the piece.
    chi: Vec<(usize, i64)>,
    /// Arcs on the border of the grid, by their ends.
    border: Vec<[usize; 2]>,
}

impl Gathering<'_, '_> {
    fn number(&mut self, cell: [usize; 3], edge: Edge) -> usize {
        let next = self.numbers.len();
        *self.numbers.entry(self.level.grid_edge(cell, edge)).or_insert(next)
    }

    fn add(&mut self, cell: [usize; 3], decisions: &Decisions) {
        let sample = |c: usize| self.level.volume.corner_index(cell, Corner::ALL[c]);
        if matches!(decisions.positive, 0 | 255) {
            for c in 1..8 {
                self.samples.join(sample(0), sample(c));
            }
            return;
        }
        let mut parts = decisions.parts();
        for c in 0..8 {
            self.samples.join(sample(c), sample(parts.find(c)));
        }
        let topology = assemble(*decisions);
        for component in &topology.components {
            let first = self.number(cell, topology.loops[component.loops[0]][0]);
            for edge in component.loops.iter().flat_map(|&l| &topology.loops[l]) {
                let number = self.number(cell, *edge);
                self.crossings.join(first, number);
            }
            self.chi.push((first, component.chi));
        }
        for face in Face::ALL {
            let last = self.level.volume.shape()[face.axis()] - 2;
            let on_border = cell[face.axis()] == if face.side() == 0 { 0 } else { last };
            // A face inside the grid is seen twice; the cell above it counts its arcs.
            if face.side() == 1 && !on_border {
                continue;
            }
            for [from, to] in arcs(decisions, face) {
                let ends = [self.number(cell, from), self.number(cell, to)];
                self.chi.push((ends[0], -1));
                if on_border {
                    self.border.push(ends);
                }
            }
        }
    }

    fn totals(mut self) -> GridTopology {
        let mut totals: BTreeMap<usize, SurfaceComponent> = BTreeMap::new();
        let mut component = |partition: &mut Partition, crossing: usize, chi: i64, boundary_loops: i64| {
            let zero = SurfaceComponent { chi: 0, boundary_loops: 0, genus: 0 };
            let total = totals.entry(partition.find(crossing)).or_insert(zero);
            total.chi += chi;
            total.boundary_loops += boundary_loops;
        };
        let edge_crossings = self.numbers.len();
        for crossing in 0..edge_crossings {
            component(&mut self.crossings, crossing, 1, 0);
        }
        for &(crossing, chi) in &self.chi {
            component(&mut self.crossings, crossing, chi, 0);
        }
        // Arcs on the border make closed curves: as many as there are arcs that close one.
        let mut curves = Partition::new(edge_crossings);
        for &[a, b] in &self.border {
            if !curves.join(a, b) {
                component(&mut self.crossings, a, 0, 1);
            }
        }
        let mut components: Vec<_> = totals.into_values().collect();
        for component in &mut components {
            component.genus = (2 - component.chi - component.boundary_loops) / 2;
        }
        components.sort();
        let mut b0 = [0, 0];
        for index in 0..self.level.volume.len() {
            if self.samples.find(index) == index {
                b0[usize::from(self.level.is_outside(index))] += 1;
            }
        }
        GridTopology { components, b0_negative: b0[0], b0_positive: b0[1], edge_crossings }
    }
}

/// The topology of {f = c}, f piecewise trilinear: χ = crossings − arcs on faces + Σ χ of the pieces in
/// the cells, over each component (IS-62).
///
/// Whether it converges to that of the sampled surface under refinement is left open (IS-70); it need not agree with
/// the total curvature of the samples' cubic spline (IS-73).
///
/// Errors: a cell of which c is a critical value, unless ties are broken.
#[doc(alias = "IS-70")]
#[doc(alias = "IS-73")]
pub fn topology(level: &Level) -> Result<GridTopology, DegenerateCell> {
    gather(level, |cell| level.decisions(cell))
}

/// The same from given decisions.
pub(super) fn gather(
    level: &Level,
    mut decisions: impl FnMut([usize; 3]) -> Result<Decisions, DegenerateCell>,
) -> Result<GridTopology, DegenerateCell> {
    let samples = level.volume.len();
    let mut gathering = Gathering {
        level,
        samples: Partition::new(samples),
        crossings: Partition::new(3 * samples),
        numbers: HashMap::new(),
        chi: Vec::new(),
        border: Vec::new(),
    };
    for cell in level.volume.cells() {
        gathering.add(cell, &decisions(cell)?);
    }
    Ok(gathering.totals())
}

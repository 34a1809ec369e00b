//! A sampled function on a grid, exactly, and a level of it.

use super::cell::{self, Decisions, Degenerate, Tie};
use super::cube::{Corner, Edge};
use crate::number::binary::exact_f64;
use crate::number::{Integer, Rational, Sign};
use thiserror::Error;

/// Samples on the grid points (i, j, k), 0 ≤ i < nx and so on, x fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    shape: [usize; 3],
    samples: Samples,
}

/// The samples as they came; each stands for itself, exactly.
#[derive(Clone, Debug, PartialEq)]
enum Samples {
    Integers(Vec<i32>),
    Floats(Vec<f64>),
    Rationals(Vec<Rational>),
}

/// Why numbers are not a volume.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum VolumeError {
    /// An axis without a cell.
    #[error("shape[{axis}]: a grid needs at least 2 samples along each axis, not {samples}")]
    TooThin {
        /// 0, 1 or 2.
        axis: usize,
        /// How many samples it has.
        samples: usize,
    },
    /// More samples than can be numbered.
    #[error("shape: {0:?} has 2³¹ samples or more")]
    TooLarge([usize; 3]),
    /// Another number of values than the shape asks for.
    #[error("values: the shape asks for {expected} of them, and there are {found}")]
    WrongCount {
        /// nx·ny·nz.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A NaN or an infinity.
    #[error("values[{0}]: not a finite number")]
    NotFinite(usize),
}

impl Volume {
    fn new(shape: [usize; 3], count: usize, samples: Samples) -> Result<Volume, VolumeError> {
        if let Some(axis) = (0..3).find(|&axis| shape[axis] < 2) {
            return Err(VolumeError::TooThin { axis, samples: shape[axis] });
        }
        let expected = shape.iter().try_fold(1usize, |n, &side| n.checked_mul(side)).filter(|&n| n < 1 << 31);
        match expected {
            None => Err(VolumeError::TooLarge(shape)),
            Some(expected) if expected != count => Err(VolumeError::WrongCount { expected, found: count }),
            Some(_) => Ok(Volume { shape, samples }),
        }
    }

    /// A volume of rationals.
    ///
    /// Errors: iff an axis has fewer than 2 samples, or the values are not nx·ny·nz < 2³¹ in number.
    pub fn rationals(shape: [usize; 3], values: Vec<Rational>) -> Result<Volume, VolumeError> {
        Volume::new(shape, values.len(), Samples::Rationals(values))
    }

    /// A volume of integers; errors as [`Volume::rationals`].
    pub fn integers(shape: [usize; 3], values: Vec<i32>) -> Result<Volume, VolumeError> {
        Volume::new(shape, values.len(), Samples::Integers(values))
    }

    /// A volume of binary64 numbers, each taken exactly; errors as [`Volume::rationals`], or iff one is not finite.
    pub fn floats(shape: [usize; 3], values: Vec<f64>) -> Result<Volume, VolumeError> {
        match values.iter().position(|v| !v.is_finite()) {
            Some(i) => Err(VolumeError::NotFinite(i)),
            None => Volume::new(shape, values.len(), Samples::Floats(values)),
        }
    }

    /// [nx, ny, nz], each at least 2.
    pub fn shape(&self) -> [usize; 3] {
        self.shape
    }

    /// How many samples there are.
    pub fn len(&self) -> usize {
        self.shape.iter().product()
    }

    /// Never: a volume has at least 8 samples.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The number of the grid point: i + nx·j + nx·ny·k.
    pub fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        i + self.shape[0] * (j + self.shape[1] * k)
    }

    /// The grid point of that number.
    pub fn point(&self, index: usize) -> [usize; 3] {
        let [nx, ny, _] = self.shape;
        [index % nx, index / nx % ny, index / nx / ny]
    }

    /// The sample of that number.
    pub fn sample(&self, index: usize) -> Rational {
        match &self.samples {
            Samples::Integers(values) => Rational::from(values[index]),
            Samples::Floats(values) => Rational::from_f64(values[index]).expect("samples are finite"),
            Samples::Rationals(values) => values[index].clone(),
        }
    }

    /// The samples as binary64 numbers, x fastest; `None` where one is no such number.
    pub fn binary64s(&self) -> Option<Vec<f64>> {
        match &self.samples {
            Samples::Integers(values) => Some(values.iter().map(|&value| f64::from(value)).collect()),
            Samples::Floats(values) => Some(values.clone()),
            Samples::Rationals(values) => values.iter().map(exact_f64).collect(),
        }
    }

    /// The volume of −f.
    pub fn negated(&self) -> Volume {
        let samples = match &self.samples {
            // −2³¹ has no negative among these integers.
            Samples::Integers(values) if !values.contains(&i32::MIN) => {
                Samples::Integers(values.iter().map(|v| -v).collect())
            }
            Samples::Floats(values) => Samples::Floats(values.iter().map(|v| -v).collect()),
            Samples::Integers(_) | Samples::Rationals(_) => {
                Samples::Rationals((0..self.len()).map(|i| -self.sample(i)).collect())
            }
        };
        Volume { shape: self.shape, samples }
    }

    /// The part of the volume between two grid points, both included.
    pub fn crop(&self, low: [usize; 3], high: [usize; 3]) -> Result<Volume, VolumeError> {
        let shape = [0, 1, 2].map(|a| (high[a] + 1).saturating_sub(low[a]));
        let [nx, ny, nz] = shape;
        let points = (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])));
        let values = points.map(|p| self.sample(self.index([0, 1, 2].map(|a| p[a] + low[a])))).collect();
        Volume::rationals(shape, values)
    }

    /// The samples as integers, where they came as integers.
    pub(super) fn as_integers(&self) -> Option<&[i32]> {
        match &self.samples {
            Samples::Integers(values) => Some(values),
            Samples::Floats(_) | Samples::Rationals(_) => None,
        }
    }

    /// The lowest grid point of each cell, x fastest.
    pub fn cells(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [nx, ny, nz] = self.shape.map(|n| n - 1);
        (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])))
    }

    /// The number of a corner of a cell.
    pub fn corner_index(&self, cell: [usize; 3], corner: Corner) -> usize {
        let offset = corner.position();
        self.index([0, 1, 2].map(|a| cell[a] + usize::from(offset[a])))
    }

    /// The values at the corners of a cell.
    pub fn corner_values(&self, cell: [usize; 3]) -> [Rational; 8] {
        Corner::ALL.map(|c| self.sample(self.corner_index(cell, c)))
    }
}

/// An edge of the grid: its lower grid point's number, and its axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct GridEdge {
    /// The number of the lower end.
    pub low: u32,
    /// 0, 1 or 2.
    pub axis: u8,
}

/// Where in a grid the isovalue is a critical value.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("cell [{}, {}, {}]: {degenerate}", .cell[0], .cell[1], .cell[2])]
pub struct DegenerateCell {
    /// The lowest grid point of the cell.
    pub cell: [usize; 3],
    /// The critical point, in coordinates of the cell.
    pub degenerate: Degenerate,
}

/// The level set {f = c} of a volume: what every algorithm of this room is asked about.
#[derive(Clone, Debug)]
pub struct Level<'a> {
    /// The samples.
    pub volume: &'a Volume,
    /// c.
    pub isovalue: Rational,
    /// What to do when c is a critical value.
    pub tie: Tie,
}

impl Level<'_> {
    /// The decisions of one cell.
    pub fn decisions(&self, cell: [usize; 3]) -> Result<Decisions, DegenerateCell> {
        cell::decisions(&self.volume.corner_values(cell), &self.isovalue, self.tie)
            .map_err(|degenerate| DegenerateCell { cell, degenerate })
    }

    /// An edge of a cell as an edge of the grid.
    pub fn grid_edge(&self, cell: [usize; 3], edge: Edge) -> GridEdge {
        let [low, _] = edge.corners();
        let low = u32::try_from(self.volume.corner_index(cell, low)).expect("a volume has fewer than 2³¹ samples");
        GridEdge { low, axis: edge.axis() as u8 }
    }

    /// The number of the upper end of an edge of the grid.
    pub fn high(&self, edge: GridEdge) -> usize {
        let [nx, ny, _] = self.volume.shape();
        edge.low as usize + [1, nx, nx * ny][usize::from(edge.axis)]
    }

    /// Where the surface crosses an edge of the grid, as a share of the edge: eq (22),
    /// t = (c − g₀) / (g₁ − g₀). Only asked for crossed edges; for a tie, the limit.
    pub fn crossing(&self, edge: GridEdge) -> Rational {
        let (g0, g1) = (self.volume.sample(edge.low as usize), self.volume.sample(self.high(edge)));
        Rational::from(&self.isovalue - &g0) / (g1 - &g0)
    }

    /// The position of the crossing on an edge of the grid.
    pub fn crossing_position(&self, edge: GridEdge) -> [Rational; 3] {
        let mut position = self.volume.point(edge.low as usize).map(Rational::from);
        position[usize::from(edge.axis)] += self.crossing(edge);
        position
    }

    /// The sign of f − c at a sample.
    pub fn side(&self, index: usize) -> Sign {
        Sign::of(self.volume.sample(index).cmp(&self.isovalue))
    }

    /// Whether a sample is outside, f > c; a tie that is broken is.
    pub fn is_outside(&self, index: usize) -> bool {
        self.side(index) != Sign::Negative
    }
}

/// The samples less c, times a positive integer, as machine integers small enough for every decision:
/// |v| ≤ 2²⁶ keeps the discriminant of a cell (degree 4) within 128 bits.
pub(super) fn small_differences(level: &Level) -> Option<Vec<i32>> {
    let values = level.volume.as_integers()?;
    let (numer, denom) = (level.isovalue.numer().to_i64()?, level.isovalue.denom().to_i64()?);
    values
        .iter()
        .map(|&v| {
            let difference = Integer::from(v) * denom - numer;
            difference.to_i32().filter(|d| d.unsigned_abs() <= 1 << 26)
        })
        .collect()
}

//! Contours of a whole sampled plane: marching squares over a grid.

use super::cell::Tie;
use super::square::{DegenerateSquare, contour};
use crate::number::{Rational, Sign};
use std::collections::HashMap;
use thiserror::Error;

/// Samples on the grid points (i, j), 0 ≤ i < nx, 0 ≤ j < ny, x fastest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster {
    shape: [usize; 2],
    values: Vec<Rational>,
}

/// Why numbers are not a raster.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum RasterError {
    /// An axis without a cell.
    #[error("shape[{axis}]: a grid needs at least 2 samples along each axis, not {samples}")]
    TooThin {
        /// 0 or 1.
        axis: usize,
        /// How many samples it has.
        samples: usize,
    },
    /// More samples than can be numbered.
    #[error("shape: {0:?} has 2³⁰ samples or more")]
    TooLarge([usize; 2]),
    /// Another number of values than the shape asks for.
    #[error("values: the shape asks for {expected} of them, and there are {found}")]
    WrongCount {
        /// nx·ny.
        expected: usize,
        /// How many there are.
        found: usize,
    },
}

impl Raster {
    /// A raster of rationals.
    ///
    /// Errors: iff an axis has fewer than 2 samples, or the values are not nx·ny < 2³⁰ in number.
    pub fn new(shape: [usize; 2], values: Vec<Rational>) -> Result<Raster, RasterError> {
        if let Some(axis) = (0..2).find(|&axis| shape[axis] < 2) {
            return Err(RasterError::TooThin { axis, samples: shape[axis] });
        }
        match shape[0].checked_mul(shape[1]).filter(|&n| n < 1 << 30) {
            None => Err(RasterError::TooLarge(shape)),
            Some(expected) if expected != values.len() => {
                Err(RasterError::WrongCount { expected, found: values.len() })
            }
            Some(_) => Ok(Raster { shape, values }),
        }
    }

    /// [nx, ny], each at least 2.
    pub fn shape(&self) -> [usize; 2] {
        self.shape
    }

    /// The sample at a grid point.
    ///
    /// # Panics
    /// Iff the point is not on the grid.
    pub fn sample(&self, [i, j]: [usize; 2]) -> &Rational {
        assert!(i < self.shape[0], "the grid has {} samples along x", self.shape[0]);
        &self.values[i + self.shape[0] * j]
    }

    /// The lowest grid point of each square, x fastest.
    pub fn squares(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        let [nx, ny] = self.shape.map(|n| n - 1);
        (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j]))
    }

    /// The grid point where a sample equals c, the first of them.
    pub(super) fn sample_at(&self, isovalue: &Rational) -> Option<[usize; 2]> {
        let index = self.values.iter().position(|v| v == isovalue)?;
        Some([index % self.shape[0], index / self.shape[0]])
    }
}

/// A contour: vertices on edges, each shared by the squares that it belongs to, and segments between them with
/// f > c on the left where x runs to the right and y up.
///
/// Each vertex is the start of at most one segment and the end of at most one; it misses one only on the
/// border of the grid (IS-46). With broken ties, vertices of different edges may lie in one point.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
#[doc(alias = "IS-46")]
pub struct Polyline {
    /// Positions; grid point (i, j) lies at (i, j).
    pub vertices: Vec<[Rational; 2]>,
    /// Pairs of vertex numbers, from start to end.
    pub segments: Vec<[u32; 2]>,
}

/// A degenerate square of a grid.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("square [{}, {}]: {degenerate}", .square[0], .square[1])]
pub struct DegenerateGridSquare {
    /// The lowest grid point of the square.
    pub square: [usize; 2],
    /// What is degenerate about it, in coordinates of the square.
    pub degenerate: DegenerateSquare,
}

/// The contour {f = c} by marching squares: f piecewise bilinear, ambiguous squares by their determinant
/// (IS-45); it draws any implicit curve (IS-35). Its polygon follows the topology, not the curvature, of an interpolant (IS-50).
///
/// Errors: a square of which c is a critical value, unless ties are broken. Samples equal to c may spoil the manifold
/// (IS-49), and need not (IS-48).
#[doc(alias = "IS-35")]
#[doc(alias = "IS-45")]
#[doc(alias = "IS-48")]
#[doc(alias = "IS-49")]
#[doc(alias = "IS-50")]
pub fn squares(raster: &Raster, isovalue: &Rational, tie: Tie) -> Result<Polyline, DegenerateGridSquare> {
    let mut drawing = Drawing::new(raster, isovalue);
    for square in raster.squares() {
        let [i, j] = square;
        let points = [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]];
        let contour = contour(&points.map(|p| raster.sample(p).clone()), isovalue, tie)
            .map_err(|degenerate| DegenerateGridSquare { square, degenerate })?;
        for segment in &contour.segments {
            drawing.segment(segment.map(|edge| edge.corners().map(|c| points[c.index()])));
        }
    }
    Ok(drawing.polyline)
}

/// A polyline in the making. A vertex is known by the grid points that it lies between.
pub(super) struct Drawing<'a> {
    raster: &'a Raster,
    isovalue: &'a Rational,
    numbers: HashMap<[[usize; 2]; 2], u32>,
    pub(super) polyline: Polyline,
}

impl<'a> Drawing<'a> {
    pub(super) fn new(raster: &'a Raster, isovalue: &'a Rational) -> Drawing<'a> {
        Drawing { raster, isovalue, numbers: HashMap::new(), polyline: Polyline::default() }
    }

    /// Whether a sample is outside; one at c is, as c − ε is meant.
    pub(super) fn is_outside(&self, point: [usize; 2]) -> bool {
        Sign::of(self.raster.sample(point).cmp(self.isovalue)) != Sign::Negative
    }

    /// A segment between the crossings of two edges, each given by its ends.
    pub(super) fn segment(&mut self, edges: [[[usize; 2]; 2]; 2]) {
        let segment = edges.map(|edge| self.vertex(edge));
        self.polyline.segments.push(segment);
    }

    fn vertex(&mut self, mut ends: [[usize; 2]; 2]) -> u32 {
        ends.sort();
        if let Some(&number) = self.numbers.get(&ends) {
            return number;
        }
        let [a, b] = ends;
        let (ga, gb) = (self.raster.sample(a), self.raster.sample(b));
        let t = Rational::from(self.isovalue - ga) / Rational::from(gb - ga);
        // a ≤ b in every coordinate, for edges and the diagonal from (0,0) to (1,1) alike.
        let position = [0, 1].map(|axis| Rational::from(b[axis] - a[axis]) * &t + Rational::from(a[axis]));
        let number = u32::try_from(self.polyline.vertices.len()).expect("a grid of < 2³⁰ samples has < 2³² edges");
        self.polyline.vertices.push(position);
        self.numbers.insert(ends, number);
        number
    }
}

//! Points of ℝⁿ by their binary64 coordinates, each of which is a dyadic rational.

use crate::number::Rational;
use thiserror::Error;

/// Finite points of one dimension n ≥ 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    dimension: usize,
    /// Point after point.
    coordinates: Vec<f64>,
}

/// Why numbers are no points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum PointsError {
    /// Dimension 0, or a point that is cut off.
    #[error("{coordinates} coordinates are no points of dimension {dimension}")]
    Shape {
        /// The dimension.
        dimension: usize,
        /// How many coordinates there are.
        coordinates: usize,
    },
    /// A coordinate that is no number, or infinite.
    #[error("coordinate {axis} of point {point} is not finite")]
    NotFinite {
        /// The point.
        point: usize,
        /// The coordinate.
        axis: usize,
    },
}

impl Points {
    /// The points of that dimension with these coordinates, point after point.
    ///
    /// # Errors
    /// Iff the dimension is 0 or does not divide the number of coordinates, or a coordinate is not finite.
    pub fn new(dimension: usize, coordinates: Vec<f64>) -> Result<Points, PointsError> {
        if dimension == 0 || !coordinates.len().is_multiple_of(dimension) {
            return Err(PointsError::Shape { dimension, coordinates: coordinates.len() });
        }
        match coordinates.iter().position(|x| !x.is_finite()) {
            Some(i) => Err(PointsError::NotFinite { point: i / dimension, axis: i % dimension }),
            None => Ok(Points { dimension, coordinates }),
        }
    }

    /// n.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        self.coordinates.len() / self.dimension
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.coordinates.is_empty()
    }

    /// The point i.
    pub fn at(&self, i: usize) -> &[f64] {
        &self.coordinates[i * self.dimension..(i + 1) * self.dimension]
    }

    /// All coordinates, point after point.
    pub fn coordinates(&self) -> &[f64] {
        &self.coordinates
    }

    /// All coordinates, exactly.
    pub fn exact(&self) -> Vec<Rational> {
        self.coordinates.iter().map(|x| Rational::from_f64(*x).expect("coordinates are finite")).collect()
    }

    /// Each point.
    pub fn iter(&self) -> impl Iterator<Item = &[f64]> {
        self.coordinates.chunks_exact(self.dimension)
    }
}

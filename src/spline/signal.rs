//! Finite signals with a boundary rule.

use crate::number::binary::from_f64;
use crate::number::text::NumberError;
use crate::number::{Integer, Rational};
use thiserror::Error;

/// How a finite signal is extended to all integers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Boundary {
    /// Whole-sample symmetric: c[−k] = c\[k] = c[2n − 2 − k], so that the period is 2n − 2.
    Mirror,
    /// c\[k + n] = c\[k].
    Periodic,
}

impl Boundary {
    /// The index in 0 … n − 1 of the sample that stands at the integer k; n ≥ 2.
    pub fn index(self, k: &Integer, n: usize) -> usize {
        let period = self.period(n);
        let folded =
            Integer::from(k).modulo(&Integer::from(period)).to_usize().expect("a remainder is below the period");
        if folded < n { folded } else { period - folded }
    }

    /// The least period that every signal of n samples has: 2n − 2 or n.
    pub fn period(self, n: usize) -> usize {
        match self {
            Boundary::Mirror => 2 * n - 2,
            Boundary::Periodic => n,
        }
    }
}

/// Why samples do not make a signal. The message begins with the name of the field.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SignalError {
    /// An axis has fewer than two samples.
    #[error("shape[{axis}]: a signal needs at least 2 samples along each axis, found {n}")]
    Side {
        /// The axis.
        axis: usize,
        /// How many there are.
        n: usize,
    },
    /// The shape asks for more samples than can be addressed.
    #[error("values: the shape needs more samples than can be counted")]
    TooLarge,
    /// A sample is NaN or infinite.
    #[error("values[{index}]: {error}")]
    Sample {
        /// Its place among the values.
        index: usize,
        /// What it is.
        error: NumberError,
    },
    /// The shape asks for another number of samples.
    #[error("values: the shape needs {expected} samples, found {found}")]
    Values {
        /// The product of the shape.
        expected: usize,
        /// How many there are.
        found: usize,
    },
}

/// Samples on a grid of N axes, the first axis fastest, with a boundary rule; at least 2 along each axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signal<const N: usize> {
    shape: [usize; N],
    values: Vec<Rational>,
    boundary: Boundary,
}

impl<const N: usize> Signal<N> {
    /// # Errors
    /// iff an axis has fewer than 2 samples, or the number of values is not the product of the shape.
    pub fn new(shape: [usize; N], values: Vec<Rational>, boundary: Boundary) -> Result<Signal<N>, SignalError> {
        check_shape(&shape, values.len())?;
        Ok(Signal { shape, values, boundary })
    }

    /// From binary64, each taken exactly. SP-75.
    ///
    /// # Errors
    /// As [`Signal::new`], or iff a value is NaN or infinite.
    #[doc(alias = "SP-75")]
    pub fn of_f64s(shape: [usize; N], values: &[f64], boundary: Boundary) -> Result<Signal<N>, SignalError> {
        check_shape(&shape, values.len())?;
        let exact = |(index, x): (usize, &f64)| from_f64(*x).map_err(|error| SignalError::Sample { index, error });
        Signal::new(shape, values.iter().enumerate().map(exact).collect::<Result<_, _>>()?, boundary)
    }

    /// The number of samples along each axis.
    pub fn shape(&self) -> [usize; N] {
        self.shape
    }

    /// The samples, the first axis fastest.
    pub fn values(&self) -> &[Rational] {
        &self.values
    }

    /// The boundary rule.
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }

    /// The sample at a grid point, which may lie outside: the boundary rule extends the signal.
    pub fn sample(&self, at: &[Integer; N]) -> &Rational {
        &self.values[self.offset(at)]
    }

    /// The place in [`Signal::values`] of the sample that stands at a grid point.
    pub fn offset(&self, at: &[Integer; N]) -> usize {
        (0..N)
            .rev()
            .fold(0, |offset, axis| offset * self.shape[axis] + self.boundary.index(&at[axis], self.shape[axis]))
    }

    /// The same grid with other values.
    ///
    /// # Panics
    /// Iff their number is another.
    pub(crate) fn with_values(&self, values: Vec<Rational>) -> Signal<N> {
        assert_eq!(values.len(), self.values.len(), "a value a sample");
        Signal { values, ..*self }
    }
}

/// Whether a number of values fills a shape that a signal can have.
///
/// One sample along an axis is refused: its mirrored signal would have the period 2·1 − 2 = 0. SP-74.
///
/// # Errors
/// As [`Signal::new`].
#[doc(alias = "SP-74")]
pub fn check_shape(shape: &[usize], values: usize) -> Result<(), SignalError> {
    if let Some((axis, &n)) = shape.iter().enumerate().find(|(_, n)| **n < 2) {
        return Err(SignalError::Side { axis, n });
    }
    let product = shape.iter().try_fold(1_usize, |product, &n| product.checked_mul(n));
    match product.ok_or(SignalError::TooLarge)? {
        expected if expected == values => Ok(()),
        expected => Err(SignalError::Values { expected, found: values }),
    }
}

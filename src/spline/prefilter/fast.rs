//! The coefficients of large volumes, correctly rounded: the fast twin of [`interpolate`](super::interpolate).
//!
//! What is returned is `nearest_f64` of the exact coefficient, always. Doubled numbers with a running error bound decide nearly every
//! rounding, for whole blocks of lines at a time (SP-79, SP-80); what they leave in doubt, ties and zeros among it, is worked
//! out as an integer over a known denominator (SP-81). So the answer depends on no instruction set, only the speed.
//!
//! Time is linear in the volume, but for what is left in doubt: one such coefficient costs a pass over the volume with integers of about
//! 1.9 bits for each sample of an axis, all together a few such passes. Memory is 24 bytes a sample, a block of up to 32 lines, and 8 bytes and
//! the bits of a plane's integers more where there are doubts. It runs on one thread.

mod doubled;
mod exact;
mod points;
mod rounding;

pub use points::{JetError, LevelSurface64};

use crate::number::Rational;
use crate::spline::signal::{Boundary, SignalError, check_shape};
use doubled::{Block, Line, Scale, Solve};
use exact::Exact;
use pulp::{Arch, Scalar, WithSimd};
use std::ops::Range;
use thiserror::Error;

/// How many lines are solved side by side.
const WIDTH: usize = 32;

/// The exponent that the largest sample is scaled to: products stay far from 2¹⁰²⁴, and tiny ones far from 2⁻¹⁰⁷⁴.
const LARGEST_EXPONENT: i32 = 900;

/// More than scaling down by underflow, times the gain, can add to the error: 2 halves of 2⁻¹⁰⁷⁴, times 216.
const SCALING: f64 = f64::from_bits(1 << 10);

/// A number whose value a binary64 has exactly.
pub trait Sample: Copy {
    /// That value.
    fn value(self) -> f64;
}

impl Sample for f64 {
    fn value(self) -> f64 {
        self
    }
}

/// Each of these types goes into a binary64 without rounding.
macro_rules! exact_samples {
    ($($t:ty)*) => { $(impl Sample for $t { fn value(self) -> f64 { f64::from(self) } })* };
}
exact_samples!(f32 i8 u8 i16 u16 i32 u32);

/// Why there are no coefficients. The message begins with the name of the field.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FastError {
    /// The samples make no signal.
    #[error(transparent)]
    Signal(#[from] SignalError),
    /// A sample is NaN or infinite.
    #[error("values[{index}]: {value} is not a number here")]
    NotFinite {
        /// Its index.
        index: usize,
        /// NaN, ∞ or −∞.
        value: f64,
    },
    /// A result rounds to an infinity: its absolute value is at least 2¹⁰²⁴ − 2⁹⁷⁰.
    #[error("coefficients[{index}]: too large for a binary64")]
    Overflow {
        /// The index of the first such coefficient.
        index: usize,
    },
}

/// The coefficients of the interpolant, each the binary64 nearest to the exact one, ties to even; an exact 0 is +0. SP-82.
///
/// Samples with the first axis fastest, 1 to 3 axes, as [`Signal::new`](crate::spline::signal::Signal::new) has them.
///
/// # Errors
/// `Signal` iff an axis has fewer than 2 samples, or their number is not the product of the shape; `NotFinite` iff a sample is not
/// finite; `Overflow` iff a rounded coefficient is not.
#[doc(alias = "SP-82")]
pub fn coefficients<T: Sample, const N: usize>(
    samples: &[T],
    shape: [usize; N],
    boundary: Boundary,
) -> Result<Vec<f64>, FastError> {
    Enclosed::new(samples, shape, boundary)?.into_coefficients()
}

/// Samples with every coefficient of their interpolant enclosed: 2^scale·c within hi + lo ± err. SP-80.
#[derive(Debug)]
#[doc(alias = "SP-80")]
pub struct Enclosed<'a, T, const N: usize> {
    samples: &'a [T],
    shape: [usize; N],
    boundary: Boundary,
    scale: i32,
    hi: Vec<f64>,
    lo: Vec<f64>,
    err: Vec<f64>,
}

impl<'a, T: Sample, const N: usize> Enclosed<'a, T, N> {
    /// The enclosures, one axis after the other.
    ///
    /// # Errors
    /// As [`coefficients`], but for `Overflow`.
    pub fn new(samples: &'a [T], shape: [usize; N], boundary: Boundary) -> Result<Enclosed<'a, T, N>, FastError> {
        const { assert!(N >= 1 && N <= 3, "one to three axes") };
        check_shape(&shape, samples.len())?;
        let largest = largest(samples)?;
        let scale = if largest == 0.0 { 0 } else { LARGEST_EXPONENT - exponent(largest) };
        let zeros = || vec![0.0; samples.len()];
        let (hi, lo, err) = (zeros(), zeros(), zeros());
        let mut enclosed = Enclosed { samples, shape, boundary, scale, hi, lo, err };
        // A volume of zeros has coefficients 0 ± 0.
        if largest != 0.0 {
            for axis in 0..N {
                enclosed.solve_axis(axis);
            }
        }
        Ok(enclosed)
    }

    fn solve_axis(&mut self, axis: usize) {
        let n = self.shape[axis];
        let count = self.samples.len() / n;
        let line = Line::new(n, self.boundary);
        // A single line is a chain of operations that no lane beside it makes longer.
        let width = if count == 1 { 1 } else { count.next_multiple_of(8).min(WIDTH) };
        let mut block = Block::new(n, width);
        let arch = Arch::new();
        let mut first = 0;
        while first < count {
            let lines = self.lines(axis, first, width);
            if axis == 0 {
                for (lane, line) in lines.lines(self.samples, n).enumerate() {
                    for (row, g) in block.hi.chunks_exact_mut(width).zip(line) {
                        row[lane] = g.value();
                    }
                }
                let gain = [6.0, 36.0, 216.0][N - 1];
                run(arch, width, Scale { block: &mut block, powers: powers(self.scale), gain, err: SCALING });
            } else {
                for (k, from) in lines.rows(n).enumerate() {
                    let to = k * width..k * width + from.len();
                    block.hi[to.clone()].copy_from_slice(&self.hi[from.clone()]);
                    block.lo[to.clone()].copy_from_slice(&self.lo[from.clone()]);
                    block.err[to].copy_from_slice(&self.err[from]);
                }
            }
            run(arch, width, Solve { block: &mut block, line: &line });
            for (from, to) in [(&block.hi, &mut self.hi), (&block.lo, &mut self.lo), (&block.err, &mut self.err)] {
                if axis == 0 {
                    for (lane, line) in to[lines.base..][..lines.count * n].chunks_exact_mut(n).enumerate() {
                        for (x, row) in line.iter_mut().zip(from.chunks_exact(width)) {
                            *x = row[lane];
                        }
                    }
                } else {
                    for (k, to_row) in lines.rows(n).enumerate() {
                        let length = to_row.len();
                        to[to_row].copy_from_slice(&from[k * width..][..length]);
                    }
                }
            }
            first += lines.count;
        }
    }

    /// The lines along an axis from a number on, at most so many, that lie side by side; of the first axis, one after the other.
    fn lines(&self, axis: usize, first: usize, most: usize) -> Lines {
        let (n, stride) = (self.shape[axis], self.shape[..axis].iter().product::<usize>());
        if axis == 0 {
            return Lines { base: first * n, count: most.min(self.samples.len() / n - first), stride };
        }
        let within = first % stride;
        Lines { base: (first - within) * n + within, count: most.min(stride - within), stride }
    }

    /// The coefficients, correctly rounded.
    ///
    /// # Errors
    /// `Overflow` iff one of them is not finite.
    pub fn into_coefficients(mut self) -> Result<Vec<f64>, FastError> {
        let scale = rounding::Scale::new(self.scale);
        let mut open = Vec::new();
        let mut settled = Vec::new();
        for i in self.doubtful(&scale) {
            let (lo, hi) = self.bounds(i);
            match rounding::nearest_within(&lo, &hi) {
                Some(x) => settled.push((i, x)),
                None => open.push(i),
            }
        }
        for x in &mut self.hi {
            *x = scale.unscaled(*x);
        }
        for (i, x) in settled {
            self.hi[i] = x;
        }
        if !open.is_empty() {
            let exact = Exact::new(self.samples, &self.shape, self.boundary);
            exact.each(&open, &mut |i, p| {
                self.hi[i] = rounding::nearest_quotient(p, &exact.denominator, exact.exponent);
            });
        }
        match self.hi.iter().position(|x| x.is_infinite()) {
            Some(index) => Err(FastError::Overflow { index }),
            None => Ok(self.hi),
        }
    }

    /// The places of the coefficients whose rounding hi + lo ± err does not show at once.
    fn doubtful(&self, scale: &rounding::Scale) -> Vec<usize> {
        const PART: usize = 64;
        let mut doubtful = Vec::new();
        let parts = self.hi.chunks(PART).zip(self.lo.chunks(PART)).zip(self.err.chunks(PART));
        for (part, ((hi, lo), err)) in parts.enumerate() {
            let decided = || hi.iter().zip(lo).zip(err).map(|((hi, lo), err)| scale.decides(*hi, *lo, *err));
            // All of them, without a branch, so that they are looked at several at a time.
            if !decided().fold(true, |all, one| all & one) {
                let doubts = decided().enumerate().filter(|(_, is_decided)| !is_decided);
                doubtful.extend(doubts.map(|(i, _)| part * PART + i));
            }
        }
        doubtful
    }

    /// lo ≤ c ≤ hi of the coefficient at a place.
    ///
    /// # Panics
    /// Iff there is no such place.
    pub fn bounds(&self, i: usize) -> (Rational, Rational) {
        let finite = |x: f64| Rational::from_f64(x).expect("what the recursion makes is finite");
        let (middle, err) = (finite(self.hi[i]) + finite(self.lo[i]), finite(self.err[i]));
        let unscaled =
            |x: Rational| if self.scale < 0 { x << self.scale.unsigned_abs() } else { x >> self.scale.unsigned_abs() };
        (unscaled(Rational::from(&middle - &err)), unscaled(middle + err))
    }
}

/// Lines of one axis: the first sample of the first one, how many there are, and the distance of samples along them.
struct Lines {
    base: usize,
    count: usize,
    stride: usize,
}

impl Lines {
    /// Each line of the first axis.
    fn lines<'s, T>(&self, samples: &'s [T], n: usize) -> impl Iterator<Item = &'s [T]> + use<'s, T> {
        samples[self.base..][..self.count * n].chunks_exact(n)
    }

    /// The places of the samples k = 0 … n − 1 of all these lines.
    fn rows(&self, n: usize) -> impl Iterator<Item = Range<usize>> {
        let (base, count, stride) = (self.base, self.count, self.stride);
        (0..n).map(move |k| base + k * stride..base + k * stride + count)
    }
}

/// With the widest vectors that there are; a single line number by number.
fn run(arch: Arch, width: usize, operation: impl WithSimd<Output = ()>) {
    if width == 1 { operation.with_simd(Scalar::new()) } else { arch.dispatch(operation) }
}

/// 2^s as a product of two numbers.
fn powers(s: i32) -> [f64; 2] {
    [power_of_two(s / 2), power_of_two(s - s / 2)]
}

/// 2^s, |s| ≤ 1022.
fn power_of_two(s: i32) -> f64 {
    f64::from_bits(u64::try_from(s + 1023).expect("a normal exponent") << 52)
}

/// ⌊log₂ x⌋ for x > 0.
fn exponent(x: f64) -> i32 {
    let field = (x.to_bits() >> 52) as i32;
    if field == 0 { -1011 - x.to_bits().leading_zeros() as i32 } else { field - 1023 }
}

/// The largest absolute value.
fn largest<T: Sample>(samples: &[T]) -> Result<f64, FastError> {
    // The maximum of the bits without their sign is that of the absolute values, and beyond those of ∞ for a NaN.
    let bits = samples.iter().fold(0, |most, g| (g.value().to_bits() & (u64::MAX >> 1)).max(most));
    if bits < f64::INFINITY.to_bits() {
        return Ok(f64::from_bits(bits));
    }
    let index = samples.iter().position(|g| !g.value().is_finite()).expect("one of them has those bits");
    Err(FastError::NotFinite { index, value: samples[index].value() })
}

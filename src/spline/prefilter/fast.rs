//! The coefficients of large volumes, correctly rounded: the fast twin of [`interpolate`](super::interpolate).
//!
//! What is returned is `nearest_f64` of the exact coefficient, always. Doubled numbers with a running error bound decide nearly every
//! rounding, for whole blocks of lines at a time (SP-301, SP-302); what they leave in doubt, ties and zeros among it, is worked
//! out as an integer over a known denominator (SP-303). So the answer depends on no instruction set, only the speed.
//!
//! Time is linear in the volume, but for the doubtful coefficients: one of them costs a pass of integers of about 1.9 bits a sample
//! of each axis over the volume, all of them together not much more. Memory is 24 bytes a sample. One thread.

mod doubled;
mod exact;
mod points;
mod rounding;

pub use points::{JetError, LevelSurface64};

use crate::number::Rational;
use crate::spline::signal::{Boundary, SignalError, check_shape};
use doubled::{Block, INFLATION, Line, Scale, Solve};
use pulp::{Arch, WithSimd};
use thiserror::Error;

/// How many lines are solved side by side.
const WIDTH: usize = 32;

/// The exponent that the largest sample is scaled to: products stay far from 2¹⁰²⁴, and tiny ones far from 2⁻¹⁰⁷⁴.
const LARGEST_EXPONENT: i32 = 900;

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

/// The coefficients of the interpolant, each the binary64 nearest to the exact one, ties to even; an exact 0 is +0. SP-304.
///
/// Samples with the first axis fastest, 1 to 3 axes, as [`Signal::new`](crate::spline::signal::Signal::new) has them.
///
/// # Errors
/// `Signal` iff an axis has fewer than 2 samples, or their number is not the product of the shape; `NotFinite` iff a sample is not
/// finite; `Overflow` iff a rounded coefficient is not.
#[doc(alias = "SP-304")]
pub fn coefficients<T: Sample, const N: usize>(
    samples: &[T],
    shape: [usize; N],
    boundary: Boundary,
) -> Result<Vec<f64>, FastError> {
    Enclosed::new(samples, shape, boundary)?.into_coefficients()
}

/// Samples with every coefficient of their interpolant enclosed: 2^scale·c within hi + lo ± err. SP-302.
#[derive(Debug)]
#[doc(alias = "SP-302")]
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
        let stride: usize = self.shape[..axis].iter().product();
        let count = self.samples.len() / n;
        let line = Line::new(n, self.boundary);
        // A single line is a chain of operations that no lane beside it makes longer.
        let mut block = Block::new(n, if count == 1 { 1 } else { count.next_multiple_of(8).min(WIDTH) });
        let arch = Arch::new();
        let mut first = 0;
        while first < count {
            // Lines whose samples lie side by side; of the first axis, lines one after the other.
            let (base, step, next) = match axis {
                0 => (first * n, n, 1),
                _ => (first / stride * stride * n + first % stride, 1, stride),
            };
            let lines = (if axis == 0 { count - first } else { stride - first % stride }).min(block.width());
            let place = |k: usize, lane: usize| base + lane * step + k * next;
            if axis == 0 {
                let width = block.width();
                for lane in 0..lines {
                    let line = &self.samples[base + lane * n..][..n];
                    for (row, g) in block.hi.chunks_exact_mut(width).zip(line) {
                        row[lane] = g.value();
                    }
                }
                let gain = [6.0, 36.0, 216.0][N - 1];
                run(arch, Scale { block: &mut block, powers: powers(self.scale), gain, err: SCALING });
            } else {
                let width = block.width();
                for k in 0..n {
                    let from = place(k, 0)..place(k, lines);
                    let to = k * width..k * width + lines;
                    block.hi[to.clone()].copy_from_slice(&self.hi[from.clone()]);
                    block.lo[to.clone()].copy_from_slice(&self.lo[from.clone()]);
                    block.err[to].copy_from_slice(&self.err[from]);
                }
            }
            run(arch, Solve { block: &mut block, line: &line });
            let width = block.width();
            if axis == 0 {
                for (from, to) in [(&block.hi, &mut self.hi), (&block.lo, &mut self.lo), (&block.err, &mut self.err)] {
                    for lane in 0..lines {
                        let line = &mut to[base + lane * n..][..n];
                        for (x, row) in line.iter_mut().zip(from.chunks_exact(width)) {
                            *x = row[lane];
                        }
                    }
                }
            } else {
                for k in 0..n {
                    let (from, to) = (k * width..k * width + lines, place(k, 0)..place(k, lines));
                    self.hi[to.clone()].copy_from_slice(&block.hi[from.clone()]);
                    self.lo[to.clone()].copy_from_slice(&block.lo[from.clone()]);
                    self.err[to].copy_from_slice(&block.err[from]);
                }
            }
            first += lines;
        }
    }

    /// The coefficients, correctly rounded.
    ///
    /// # Errors
    /// `Overflow` iff one of them is not finite.
    pub fn into_coefficients(mut self) -> Result<Vec<f64>, FastError> {
        let scale = rounding::Scale::new(self.scale);
        let mut doubtful = Vec::new();
        const PART: usize = 64;
        for first in (0..self.hi.len()).step_by(PART) {
            let part = first..(first + PART).min(self.hi.len());
            let (hi, lo, err) = (&self.hi[part.clone()], &self.lo[part.clone()], &self.err[part.clone()]);
            let doubts =
                hi.iter().zip(lo).zip(err).fold(0_u32, |n, ((h, l), e)| n + u32::from(!scale.decides(*h, *l, *e)));
            if doubts != 0 {
                doubtful.extend(part.clone().filter(|&i| !scale.decides(self.hi[i], self.lo[i], self.err[i])));
            }
            // The enclosures of the doubtful ones are needed once more.
        }
        let settled: Vec<(usize, Option<f64>)> = doubtful
            .into_iter()
            .map(|i| {
                let (lo, hi) = self.enclosure(i);
                (i, rounding::nearest_within(&lo, &hi))
            })
            .collect();
        for x in &mut self.hi {
            *x = scale.unscaled(*x);
        }
        let open: Vec<usize> = settled.iter().filter(|(_, x)| x.is_none()).map(|(i, _)| *i).collect();
        for (i, x) in settled {
            if let Some(x) = x {
                self.hi[i] = x;
            }
        }
        if !open.is_empty() {
            let exact = exact::coefficients(self.samples, &self.shape, self.boundary, &open);
            for (p, &i) in exact.numerators.iter().zip(&open) {
                self.hi[i] = rounding::nearest_quotient(p, &exact.denominator, exact.exponent);
            }
        }
        match self.hi.iter().position(|x| x.is_infinite()) {
            Some(index) => Err(FastError::Overflow { index }),
            None => Ok(self.hi),
        }
    }

    /// Bounds of a coefficient.
    fn enclosure(&self, i: usize) -> (Rational, Rational) {
        let finite = |x: f64| Rational::from_f64(x).expect("what the recursion makes is finite");
        let (middle, err) = (finite(self.hi[i]) + finite(self.lo[i]), finite(self.err[i]));
        let unscaled =
            |x: Rational| if self.scale < 0 { x << self.scale.unsigned_abs() } else { x >> self.scale.unsigned_abs() };
        (unscaled(Rational::from(&middle - &err)), unscaled(middle + err))
    }
}

/// What scaling down may add to the error, with the gain: a few halves of 2⁻¹⁰⁷⁴ times 216.
const SCALING: f64 = f64::from_bits(1 << 10);

fn run<Op: WithSimd<Output = ()> + Narrow>(arch: Arch, operation: Op) {
    if operation.is_narrow() {
        operation.with_simd(pulp::Scalar::new());
    } else {
        arch.dispatch(operation);
    }
}

/// Whether the rows are single numbers, which no vector holds.
trait Narrow {
    fn is_narrow(&self) -> bool;
}

impl Narrow for Scale<'_> {
    fn is_narrow(&self) -> bool {
        self.block.width() == 1
    }
}

impl Narrow for Solve<'_> {
    fn is_narrow(&self) -> bool {
        self.block.width() == 1
    }
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

const _: () = assert!(INFLATION > 1.0);

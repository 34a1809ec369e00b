//! The fast twin of [`prefilter`](super::prefilter) and of evaluation: integers over one denominator, and indices folded once.

use super::basis::{cubics, split};
use super::inverse::{convergent, numerators};
use super::signal::{Boundary, Signal};
use super::tensor::Spline;
use crate::curvature::jet::Jet;
use crate::linear::{Matrix, Vector};
use crate::number::{Integer, Rational};
use rayon::prelude::*;

/// [`prefilter::interpolate`](super::prefilter::interpolate), the same spline. SP-72.
#[doc(alias = "SP-72")]
pub fn interpolate<const N: usize>(signal: &Signal<N>) -> Spline<N> {
    IntegerSpline::interpolate(signal).spline()
}

/// A tensor-product spline whose coefficients are integers over one common denominator. SP-72.
///
/// The denominator is the product of the samples' least common one and of B_(2n−2), mirror, or Bₙ, periodic, for each axis of n
/// samples ([`inverse`](super::inverse)).
#[derive(Clone, Debug)]
pub struct IntegerSpline<const N: usize> {
    /// The first axis fastest.
    numerators: Vec<Integer>,
    denominator: Integer,
    shape: [usize; N],
    boundary: Boundary,
    /// At m + 1 the offset along an axis of the coefficient that stands at m = −1, …, period + 1.
    offsets: [Vec<usize>; N],
}

impl<const N: usize> IntegerSpline<N> {
    /// The only spline of the signal's shape and boundary rule that takes the signal's values. SP-72.
    pub fn interpolate(signal: &Signal<N>) -> IntegerSpline<N> {
        let mut spline = IntegerSpline::new(signal);
        let mut stride = 1;
        for n in signal.shape() {
            let axis = Axis::new(n, signal.boundary());
            axis.solve_lines(&mut spline.numerators, stride);
            spline.denominator *= &axis.denominator;
            stride *= n;
        }
        spline
    }

    /// The spline with these coefficients.
    pub fn new(coefficients: &Signal<N>) -> IntegerSpline<N> {
        let values = coefficients.values();
        let denominator = values.iter().fold(Integer::from(1), |lcm, c| lcm.lcm(c.denom()));
        let numerator = |c: &Rational| Integer::from(denominator.div_exact_ref(c.denom())) * c.numer();
        let shape = coefficients.shape();
        let offsets = std::array::from_fn(|axis| {
            let stride: usize = shape[..axis].iter().product();
            let index = |m: usize| coefficients.boundary().index(&(Integer::from(m) - 1_u32), shape[axis]);
            (0..coefficients.boundary().period(shape[axis]) + 3).map(|m| index(m) * stride).collect()
        });
        let numerators = values.iter().map(numerator).collect();
        IntegerSpline { numerators, denominator, shape, boundary: coefficients.boundary(), offsets }
    }

    /// The same spline with rational coefficients.
    pub fn spline(&self) -> Spline<N> {
        let rational = |c: &Integer| Rational::from((c.clone(), self.denominator.clone()));
        let values = self.numerators.par_iter().map(rational).collect();
        Spline::new(
            Signal::new(self.shape, values, self.boundary).expect("the shape of the signal that it was made from"),
        )
    }

    /// ∂ⁿf, as [`Spline::derivative`].
    ///
    /// # Panics
    /// Iff an order is above 2.
    pub fn derivative(&self, at: &[Rational; N], orders: [u32; N]) -> Rational {
        Place::new(self, at).derivative(orders)
    }

    /// f at any real point.
    pub fn value(&self, at: &[Rational; N]) -> Rational {
        self.derivative(at, [0; N])
    }

    /// f at many points. SP-77.
    #[doc(alias = "SP-77")]
    pub fn values(&self, points: &[[Rational; N]]) -> Vec<Rational> {
        points.par_iter().map(|at| self.value(at)).collect()
    }

    /// f, ∇f and the Hessian, as [`Spline::jet`].
    pub fn jet(&self, at: &[Rational; N]) -> Jet<Rational, N> {
        let place = Place::new(self, at);
        let orders = |axes: &[usize]| std::array::from_fn(|a| axes.iter().filter(|&&axis| axis == a).count() as u32);
        let hessian: Matrix<Rational, N, N> =
            Matrix::from_fn(|i, j| if i <= j { place.derivative(orders(&[i, j])) } else { Rational::new() });
        Jet {
            value: place.derivative([0; N]),
            gradient: Vector(std::array::from_fn(|i| place.derivative(orders(&[i])))),
            hessian: Matrix::from_fn(|i, j| hessian.0[i.min(j)][i.max(j)].clone()),
        }
    }

    /// Jets at many points. SP-77.
    pub fn jets(&self, points: &[[Rational; N]]) -> Vec<Jet<Rational, N>> {
        points.par_iter().map(|at| self.jet(at)).collect()
    }
}

/// The system of an axis, solved in integers: with D the denominator of A⁻¹, the numbers C\[k] = D·c\[k] are integers.
struct Axis {
    boundary: Boundary,
    /// D.
    denominator: Integer,
    /// D times the first row of A⁻¹.
    first_row: Vec<Integer>,
}

impl Axis {
    fn new(n: usize, boundary: Boundary) -> Axis {
        let period = boundary.period(n);
        let a = numerators(period);
        let word = u32::try_from(period).expect("an axis of more than 2³¹ samples has no inverse in any memory");
        let entry = |d: usize| {
            let e = d.min(period - d);
            let numerator = a[period - 2 * e].clone();
            let weight = match boundary {
                // Both images of the sample, but where it is an end and so its own image.
                Boundary::Mirror if d > 0 && d < n - 1 => 2,
                Boundary::Mirror | Boundary::Periodic => 1,
            };
            numerator * if e.is_multiple_of(2) { weight } else { -weight }
        };
        Axis { boundary, denominator: convergent(word).1, first_row: (0..n).map(entry).collect() }
    }

    /// C in place of g on each line of this axis.
    fn solve_lines(&self, values: &mut [Integer], stride: usize) {
        let n = self.first_row.len();
        let first = |line: usize| line / stride * stride * n + line % stride;
        let mut lines: Vec<Vec<Integer>> = (0..values.len() / n)
            .map(|line| (0..n).map(|k| std::mem::take(&mut values[first(line) + k * stride])).collect())
            .collect();
        lines.par_iter_mut().for_each(|line| self.solve(line));
        for (line, solved) in lines.into_iter().enumerate() {
            for (k, c) in solved.into_iter().enumerate() {
                values[first(line) + k * stride] = c;
            }
        }
    }

    /// C\[0], and C\[1] for periodic, from the rows of A⁻¹; the others by C\[k+1] = 6D·g\[k] − 4C\[k] − C\[k−1], which loses nothing.
    fn solve(&self, line: &mut [Integer]) {
        let n = line.len();
        let mut before = self.row(line, 0);
        let six_g = |g: &Integer| Integer::from(g * &self.denominator) * 6;
        let mut c = match self.boundary {
            // 6g[0] = 4c[0] + 2c[1]
            Boundary::Mirror => (six_g(&line[0]) - Integer::from(&before * 4)) / 2,
            Boundary::Periodic => self.row(line, n - 1),
        };
        line[0] = before.clone();
        for g in &mut line[1..] {
            let next = six_g(g) - Integer::from(&c * 4) - &before;
            *g = c.clone();
            (before, c) = (c, next);
        }
    }

    /// D times the row of A⁻¹, moved along by a number of samples, on g: the periodic inverse is circulant.
    fn row(&self, g: &[Integer], moved: usize) -> Integer {
        let mut sum = Integer::new();
        for (k, g) in g.iter().enumerate() {
            sum += &self.first_row[(k + moved) % self.first_row.len()] * g;
        }
        sum
    }
}

/// What a point sees of a spline: offsets of 4 coefficients along each axis, and the fractions.
struct Place<'a, const N: usize> {
    spline: &'a IntegerSpline<N>,
    four: [&'a [usize]; N],
    fractions: [Rational; N],
}

impl<'a, const N: usize> Place<'a, N> {
    fn new(spline: &'a IntegerSpline<N>, at: &[Rational; N]) -> Place<'a, N> {
        let places = at.each_ref().map(split);
        let four = std::array::from_fn(|axis| {
            let offsets = &spline.offsets[axis];
            let period = Integer::from(offsets.len() - 3);
            let i = Integer::from(places[axis].0.modulo_ref(&period)).to_usize().expect("a remainder");
            &offsets[i..i + 4]
        });
        Place { spline, four, fractions: places.map(|(_, t)| t) }
    }

    /// Sums over the axes, the last one first, of integers: a single fraction is reduced at the end.
    fn derivative(&self, orders: [u32; N]) -> Rational {
        let mut denominator = self.spline.denominator.clone();
        let weights: [[Integer; 4]; N] = std::array::from_fn(|axis| {
            let (numerators, scale) = integer_weights(&self.fractions[axis], orders[axis]);
            denominator *= scale;
            numerators
        });
        Rational::from((self.sum(&weights, N, 0), denominator))
    }

    /// Σ over the axes below `axes` of the coefficients at the offset.
    fn sum(&self, weights: &[[Integer; 4]; N], axes: usize, offset: usize) -> Integer {
        let Some(axis) = axes.checked_sub(1) else { return self.spline.numerators[offset].clone() };
        let mut sum = Integer::new();
        for (weight, step) in weights[axis].iter().zip(self.four[axis]) {
            if !weight.is_zero() {
                sum += weight * self.sum(weights, axis, offset + step);
            }
        }
        sum
    }
}

/// 6q³ times the four weights at t = p/q, and 6q³: Σ a_m pᵐ q^(3−m).
fn integer_weights(t: &Rational, n: u32) -> ([Integer; 4], Integer) {
    let (p, q) = (t.numer(), t.denom());
    let powers = |x: &Integer| {
        let square = Integer::from(x * x);
        [Integer::from(1), x.clone(), square.clone(), square * x]
    };
    let (p, q) = (powers(p), powers(q));
    let terms: [Integer; 4] = std::array::from_fn(|m| Integer::from(&p[m] * &q[3 - m]));
    let weight = |cubic: [i32; 4]| {
        cubic.iter().zip(&terms).fold(Integer::new(), |sum, (a, term)| sum + Integer::from(term * *a))
    };
    (cubics(n).map(weight), Integer::from(&q[3] * 6))
}

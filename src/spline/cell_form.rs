//! A spline on a cell, and on parts of it, in Bernstein form: coefficients, enclosed in binary64, that bound it.
//!
//! f = Σ b\[i,j,k] Bᵢ(u) Bⱼ(v) B_k(w) on a box, (u, v, w) its coordinates from 0 to 1. The Bᵢ are not negative and sum up to 1, so f lies
//! in the hull of the b; so does each derivative in that of its own coefficients, which are differences of the b.

use super::enclosure::{exactly, hull};
use super::signal::{Boundary, Signal};
use super::tensor::Spline;
use crate::curvature::jet::Jet;
use crate::linear::{Matrix, Vector};
use crate::number::{F64Interval, Integer, Rational, Ring};

/// f − c for a spline f, its coefficients enclosed in binary64; 3-D.
#[derive(Clone, Debug)]
pub struct EnclosedSpline {
    shape: [usize; 3],
    boundary: Boundary,
    coefficients: Vec<F64Interval>,
}

impl EnclosedSpline {
    /// f − c: all B-splines sum up to 1, so its coefficients are those of f less c.
    pub fn new(spline: &Spline<3>, isovalue: &Rational) -> EnclosedSpline {
        let signal: &Signal<3> = spline.coefficients();
        let values = signal.values().iter();
        let coefficients = values.map(|c| F64Interval::from_rational(&Rational::from(c - isovalue))).collect();
        EnclosedSpline { shape: signal.shape(), boundary: signal.boundary(), coefficients }
    }

    /// The cells that make up its domain, by their lowest grid points: those of the grid's box for a mirror boundary, those of a
    /// whole period, one more along each axis, for a periodic one.
    pub fn cells(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [nx, ny, nz] = self.shape.map(|n| match self.boundary {
            Boundary::Mirror => n - 1,
            Boundary::Periodic => n,
        });
        (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])))
    }

    /// The Bernstein form on a cell; `None` where the B-splines' coefficients, which bound it too, all have one strict sign.
    pub fn cell(&self, cell: [usize; 3]) -> Option<CellForm> {
        let index =
            |axis: usize, m: usize| self.boundary.index(&(Integer::from(cell[axis]) + m - 1_u32), self.shape[axis]);
        let indices: [[usize; 4]; 3] = std::array::from_fn(|axis| std::array::from_fn(|m| index(axis, m)));
        let mut form = CellForm {
            coefficients: std::array::from_fn(|m| {
                let [i, j, k] = [indices[0][m & 3], indices[1][m >> 2 & 3], indices[2][m >> 4]];
                self.coefficients[i + self.shape[0] * (j + self.shape[1] * k)]
            }),
        };
        if !may_vanish(form.range()) {
            return None;
        }
        let sixth = F64Interval::from_rational(&Rational::from((1, 6)));
        let times = |x: F64Interval, n: i64| x * &F64Interval::integer(n);
        for axis in 0..3 {
            form.map_fibres(axis, |[a, b, c, d]| {
                let ends = [a + &times(b, 4) + &c, b + &times(c, 4) + &d];
                [ends[0], times(b, 4) + &times(c, 2), times(b, 2) + &times(c, 4), ends[1]].map(|x| x * &sixth)
            });
        }
        Some(form)
    }
}

/// Whether 0 lies in an interval.
pub fn may_vanish(x: F64Interval) -> bool {
    x.lo() <= 0.0 && 0.0 <= x.hi()
}

/// A tricubic polynomial on a box: its 64 Bernstein coefficients, the first axis fastest.
#[derive(Clone, Debug)]
pub struct CellForm {
    coefficients: [F64Interval; 64],
}

/// Every place of a fibre along an axis in an array of 4×4×4, by the place of its first entry.
fn fibres(axis: usize) -> ([usize; 16], usize) {
    let stride = 1 << (2 * axis);
    (std::array::from_fn(|m| m % stride + m / stride * 4 * stride), stride)
}

impl CellForm {
    fn map_fibres(&mut self, axis: usize, map: impl Fn([F64Interval; 4]) -> [F64Interval; 4]) {
        let (firsts, stride) = fibres(axis);
        for first in firsts {
            let fibre = map(std::array::from_fn(|m| self.coefficients[first + m * stride]));
            for (m, b) in fibre.into_iter().enumerate() {
                self.coefficients[first + m * stride] = b;
            }
        }
    }

    /// Around f on the box.
    pub fn range(&self) -> F64Interval {
        hull(self.coefficients.iter().copied())
    }

    /// The halves of the box along an axis, by de Casteljau's algorithm.
    pub fn split(&self, axis: usize) -> [CellForm; 2] {
        let half = exactly(0.5);
        let mean = |a: F64Interval, b: &F64Interval| (a + b) * &half;
        let lower = |[a, b, c, d]: [F64Interval; 4]| {
            let [ab, bc, cd] = [mean(a, &b), mean(b, &c), mean(c, &d)];
            let [abc, bcd] = [mean(ab, &bc), mean(bc, &cd)];
            [a, ab, abc, mean(abc, &bcd)]
        };
        let mut halves = [self.clone(), self.clone()];
        halves[0].map_fibres(axis, lower);
        halves[1].map_fibres(axis, |[a, b, c, d]| {
            let [d, c, b, a] = lower([d, c, b, a]);
            [a, b, c, d]
        });
        halves
    }

    /// The coefficients on the low (0) or high (1) face across an axis, the lower of the other axes fastest.
    pub fn face(&self, axis: usize, side: usize) -> [F64Interval; 16] {
        let (firsts, stride) = fibres(axis);
        firsts.map(|first| self.coefficients[first + 3 * side * stride])
    }

    /// The coefficients along the edge of the box that lies along an axis, at the low or high sides of the other two, the lower first.
    pub fn edge(&self, axis: usize, sides: [usize; 2]) -> [F64Interval; 4] {
        let (firsts, stride) = fibres(axis);
        let first = firsts[3 * sides[0] + 12 * sides[1]];
        std::array::from_fn(|m| self.coefficients[first + m * stride])
    }

    /// The coefficients of a derivative in the box's coordinates, but for the factor 3, 6, 6 of each axis' order, and how many there are.
    fn differences(&self, orders: [usize; 3]) -> ([F64Interval; 64], [usize; 3]) {
        let (mut b, mut lengths) = (self.coefficients, [4; 3]);
        for (axis, order) in orders.into_iter().enumerate() {
            for _ in 0..order {
                difference(&mut b, &mut lengths, axis);
            }
        }
        (b, lengths)
    }

    /// Around a derivative on the box, in the box's coordinates; at most 3 times along each axis.
    pub fn derivative(&self, orders: [usize; 3]) -> F64Interval {
        let (b, lengths) = self.differences(orders);
        hull(places(lengths).map(|place| b[place])) * &factor(orders)
    }

    /// Around all derivatives up to the third order on the box, in the box's coordinates, by how often each axis is taken; 0 for those
    /// above.
    pub fn derivatives(&self) -> [[[F64Interval; 4]; 4]; 4] {
        let mut table = [[[F64Interval::integer(0); 4]; 4]; 4];
        let mut x = (self.coefficients, [4; 3]);
        for (i, table) in table.iter_mut().enumerate() {
            let mut xy = x;
            for (j, table) in table[..4 - i].iter_mut().enumerate() {
                let mut xyz = xy;
                for (k, entry) in table[..4 - i - j].iter_mut().enumerate() {
                    *entry = hull(places(xyz.1).map(|place| xyz.0[place])) * &factor([i, j, k]);
                    difference(&mut xyz.0, &mut xyz.1, 2);
                }
                difference(&mut xy.0, &mut xy.1, 1);
            }
            difference(&mut x.0, &mut x.1, 0);
        }
        table
    }

    /// Around a derivative at a point of the box, in the box's coordinates.
    pub fn derivative_at(&self, at: &[F64Interval; 3], orders: [usize; 3]) -> F64Interval {
        let (mut b, lengths) = self.differences(orders);
        for axis in 0..3 {
            let (firsts, stride) = fibres(axis);
            let rest = F64Interval::integer(1) - &at[axis];
            for first in firsts {
                for length in (1..lengths[axis]).rev() {
                    for place in (0..length).map(|m| first + m * stride) {
                        b[place] = b[place] * &rest + &(b[place + stride] * &at[axis]);
                    }
                }
            }
        }
        b[0] * &factor(orders)
    }

    /// Around f, ∇f and the Hessian on the box, in units of the grid, for a box of these sides.
    pub fn jet(&self, sides: &[f64; 3]) -> Jet<F64Interval, 3> {
        jet_of(|orders| self.derivative(orders), sides)
    }

    /// The same at a point of the box.
    pub fn jet_at(&self, at: &[F64Interval; 3], sides: &[f64; 3]) -> Jet<F64Interval, 3> {
        jet_of(|orders| self.derivative_at(at, orders), sides)
    }

    /// Σ q\[a] ∂ₐf as a tricubic polynomial again, in the box's coordinates.
    pub fn directional(&self, q: [i64; 3]) -> CellForm {
        let mut sum = CellForm { coefficients: [F64Interval::integer(0); 64] };
        for (axis, q) in q.into_iter().enumerate().filter(|(_, q)| *q != 0) {
            let mut derivative = self.clone();
            derivative.map_fibres(axis, |[a, b, c, d]| {
                // Three differences, as coefficients of degree 3: 3d₀, d₀ + 2d₁, 2d₁ + d₂, 3d₂.
                let [first, second, third] = [b - &a, c - &b, d - &c];
                let times = |x: F64Interval, n: i64| x * &F64Interval::integer(n * q);
                [
                    times(first, 3),
                    times(first, 1) + &times(second, 2),
                    times(second, 2) + &times(third, 1),
                    times(third, 3),
                ]
            });
            for (sum, b) in sum.coefficients.iter_mut().zip(&derivative.coefficients) {
                *sum = *sum + b;
            }
        }
        sum
    }
}

/// The places of an array of 4×4×4 whose coordinates are below these lengths.
fn places([nx, ny, nz]: [usize; 3]) -> impl Iterator<Item = usize> {
    (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| i + 4 * j + 16 * k)))
}

/// Differences along an axis, one less than there were entries; none of one entry.
fn difference(b: &mut [F64Interval; 64], lengths: &mut [usize; 3], axis: usize) {
    lengths[axis] -= 1;
    for place in places(*lengths) {
        b[place] = b[place + (1 << (2 * axis))] - &b[place];
    }
}

/// n·(n − 1)…, from n = 3, for each axis' order.
fn factor(orders: [usize; 3]) -> F64Interval {
    F64Interval::integer(orders.into_iter().map(|order| [1, 3, 6, 6][order]).product())
}

/// The orders of a derivative along these axes.
pub(super) fn orders(axes: &[usize]) -> [usize; 3] {
    std::array::from_fn(|a| axes.iter().filter(|&&axis| axis == a).count())
}

/// What turns a derivative in the coordinates of a box into one in units of the grid: 1/side along each of its axes.
pub(super) fn scale(sides: &[f64; 3], axes: &[usize]) -> F64Interval {
    // Sides are powers of two, so that their inverses are exact.
    axes.iter().fold(F64Interval::integer(1), |product, &axis| product * &exactly(1.0 / sides[axis]))
}

fn jet_of(derivative: impl Fn([usize; 3]) -> F64Interval, sides: &[f64; 3]) -> Jet<F64Interval, 3> {
    let entry = |axes: &[usize]| derivative(orders(axes)) * &scale(sides, axes);
    let upper: [[F64Interval; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| if i <= j { entry(&[i, j]) } else { exactly(0.0) }));
    Jet {
        value: derivative([0; 3]),
        gradient: Vector(std::array::from_fn(|i| entry(&[i]))),
        hessian: Matrix::from_fn(|i, j| upper[i.min(j)][i.max(j)]),
    }
}

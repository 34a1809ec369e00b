//! ∫ K dA over a spline's isosurface, enclosed by quadrature.
//!
//! Cells are cut into boxes on each of which f ≠ c, or a partial derivative f_w is not 0. In such a box S = {f = c} is a graph over (u, v), and
//! ∫ K dA = ∫_D g du dv with g = K|∇f|/|f_w| and D = {(u, v): f(u, v, low) and f(u, v, high) of different signs}. Boxes are cut
//! further across u and v into columns until each is enclosed narrowly enough.

use super::cell_form::{CellForm, EnclosedSpline, may_vanish, orders, scale};
use super::enclosure::{Dual, between, exactly, hull, largest, quotient, smallest};
use super::half_plane::share;
use super::tensor::Spline;
use crate::curvature::implicit_surface::gaussian_numerator;
use crate::curvature::jet::Jet;
use crate::linear::{Matrix, Vector};
use crate::number::{Enclosure, F64Interval, Rational, Ring, Sign};
use thiserror::Error;

/// How deep a cell is cut, in halvings of each of its sides, before it is given up.
const DEEPEST: u32 = 24;

/// A place where binary64 cannot tell a regular isosurface from a singular one, or a point on a face of a box from one beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("cell [{}, {}, {}]: the isosurface cannot be told from a singular one there", .cell[0], .cell[1], .cell[2])]
pub struct Unresolved {
    /// The lowest grid point of the cell.
    pub cell: [usize; 3],
}

/// How much a quadrature is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// A column is cut while its enclosure is wider than this, a unit of its base.
    pub width: f64,
    /// But no further than to sides of 2^−depth.
    pub depth: u32,
}

/// An integral by quadrature.
#[derive(Clone, Copy, Debug)]
pub struct Quadrature {
    /// Around the integral.
    pub integral: F64Interval,
    /// Of how many columns it is the sum.
    pub columns: usize,
}

/// ∫ K dA over {f = c} within the grid's box, or within a period where the boundary is periodic: every bound is proved. SP-89.
///
/// # Errors
/// iff some box of sides 2^−24 may hold a point with f = c and ∇f = 0.
#[doc(alias = "SP-89")]
pub fn by_quadrature(spline: &Spline<3>, isovalue: &Rational, effort: Effort) -> Result<Quadrature, Unresolved> {
    let f = EnclosedSpline::new(spline, isovalue);
    let mut sum = Quadrature { integral: F64Interval::integer(0), columns: 0 };
    for cell in f.cells() {
        if let Some(form) = f.cell(cell) {
            add_cell(&mut sum, form, effort).map_err(|Singular| Unresolved { cell })?;
        }
    }
    Ok(sum)
}

/// A part of a cell, with its sides: powers of two.
#[derive(Clone)]
struct Part {
    form: CellForm,
    sides: [f64; 3],
}

impl Part {
    fn halves(&self, axis: usize) -> [Part; 2] {
        let mut sides = self.sides;
        sides[axis] /= 2.0;
        self.form.split(axis).map(|form| Part { form, sides })
    }

    /// Around a partial derivative, in units of the grid.
    fn derivative(&self, axes: &[usize]) -> F64Interval {
        self.form.derivative(orders(axes)) * &scale(&self.sides, axes)
    }
}

/// No partial derivative is seen not to vanish.
struct Singular;

fn add_cell(sum: &mut Quadrature, form: CellForm, effort: Effort) -> Result<(), Singular> {
    let mut pending = vec![(Part { form, sides: [1.0; 3] }, 0)];
    while let Some((part, depth)) = pending.pop() {
        if !may_vanish(part.form.range()) {
            continue;
        }
        let gradient = [0, 1, 2].map(|axis| part.derivative(&[axis]));
        // The axis along which f changes most, for certain.
        let axis = (0..3).max_by(|&a, &b| smallest(gradient[a]).total_cmp(&smallest(gradient[b]))).expect("three axes");
        let steepest = gradient.iter().fold(0.0, |m, g| largest(*g).max(m));
        // A graph that is nearly upright somewhere is one all the same, but its integrand varies much.
        let is_flat = smallest(gradient[axis]) * 3.0 > steepest;
        match gradient[axis].known_sign() {
            Some(sign @ (Sign::Positive | Sign::Negative)) if is_flat || depth >= 3 * 3 => {
                add_column(sum, Column { part, axis, sign }, effort);
            }
            Some(Sign::Zero) | None if depth == 3 * DEEPEST => return Err(Singular),
            Some(Sign::Positive | Sign::Zero | Sign::Negative) | None => {
                pending.extend(part.halves((depth % 3) as usize).map(|half| (half, depth + 1)));
            }
        }
    }
    Ok(())
}

/// A part of a cell on which f_w has one strict sign; w is the axis.
struct Column {
    part: Part,
    axis: usize,
    sign: Sign,
}

impl Column {
    /// The axes of its base.
    fn base(&self) -> [usize; 2] {
        [[1, 2], [0, 2], [0, 1]][self.axis]
    }

    /// ±f at the low and the high end, with the sign with which it rises from one to the other.
    fn ends(&self) -> [[F64Interval; 16]; 2] {
        [0, 1].map(|side| {
            let face = self.part.form.face(self.axis, side);
            if self.sign == Sign::Negative { face.map(|b| -b) } else { face }
        })
    }
}

/// Whether ±f is negative on all of an end, or nowhere; `None` where that is not seen.
fn is_below(end: &[F64Interval; 16]) -> Option<bool> {
    let range = hull(end.iter().copied());
    match (range.hi() < 0.0, range.lo() >= 0.0) {
        (true, _) => Some(true),
        (_, true) => Some(false),
        (false, false) => None,
    }
}

fn add_column(sum: &mut Quadrature, column: Column, effort: Effort) {
    let least = 0.5_f64.powi(effort.depth.min(DEEPEST) as i32);
    let mut pending = vec![column];
    while let Some(column) = pending.pop() {
        let [u, v] = column.base();
        let sides = column.part.sides;
        let Some(mean) = mean_curvature_over_base(&column) else { continue };
        let is_last = sides[u].max(sides[v]) <= least;
        if is_last || mean.hi() - mean.lo() <= effort.width {
            sum.integral = sum.integral + &(mean * &exactly(sides[u] * sides[v]));
            sum.columns += 1;
        } else {
            let wider = if sides[u] >= sides[v] { u } else { v };
            pending.extend(column.part.halves(wider).map(|part| Column { part, ..column }));
        }
    }
}

/// Around ∫ g over D, a unit of the base; `None` where S does not pass.
fn mean_curvature_over_base(column: &Column) -> Option<F64Interval> {
    // A point of S on a common end of two boxes belongs to the lower one: f(low) < 0 ≤ f(high), where f rises.
    let ends = column.ends();
    let shares = match ends.each_ref().map(is_below) {
        [Some(false), _] | [_, Some(true)] => return None,
        [Some(true), Some(false)] => None,
        [Some(true) | None, None] | [None, Some(false)] => Some(ends.each_ref().map(share)),
    };
    let short = narrowed(column);
    let mean = match shares {
        None => mean_over(&short),
        // {low < 0 ≤ high} is {low < 0} without its part {high < 0}.
        Some([low, high]) => integrand(&short).map(|g| {
            let part = low - &high;
            g.value * &between(part.lo().clamp(0.0, 1.0), part.hi().clamp(0.0, 1.0))
        }),
    };
    // f_w has a strict sign, so that |∇f| does not vanish and there is a mean, but for overflows.
    Some(mean.unwrap_or(between(f64::NEG_INFINITY, f64::INFINITY)))
}

/// The same column, shortened while all of S in it lies in one half.
fn narrowed(column: &Column) -> Column {
    let mut part = column.part.clone();
    let [u, v] = column.base();
    // Much shorter than broad is of no use, and binary64 has little to say of it.
    while part.sides[column.axis] * 8.0 > part.sides[u].max(part.sides[v]) {
        let [low, high] = part.halves(column.axis);
        match is_below(&Column { part: low.clone(), ..*column }.ends()[1]) {
            Some(true) => part = high,
            Some(false) => part = low,
            None => break,
        }
    }
    Column { part, ..*column }
}

/// Around the mean over the base of g, where S passes through the whole column.
///
/// With g₀ the value in the middle, g − g₀ is within G₁ u + G₂ v, |u| and |v| at most half a side. A slope in [a, b] adds to the mean what is in
/// ±(b − a)/8 sides.
fn mean_over(column: &Column) -> Option<F64Interval> {
    let [u, v] = column.base();
    let over = integrand(column)?;
    let at = middle(column);
    let derivative = |axes: &[usize]| {
        let local = column.part.form.derivative_at(&at, orders(axes));
        Dual { value: local * &scale(&column.part.sides, axes), slopes: [F64Interval::integer(0); 2] }
    };
    let mut mean = curvature_over_base(derivative, column)?.value;
    for (slope, axis) in over.slopes.into_iter().zip([u, v]) {
        let spread = (exactly(slope.hi()) - &exactly(slope.lo())) * &exactly(column.part.sides[axis] / 8.0);
        mean = mean + &between(-spread.hi(), spread.hi());
    }
    // Both enclose it.
    let (lo, hi) = (mean.lo().max(over.value.lo()), mean.hi().min(over.value.hi()));
    Some(between(lo, hi))
}

/// Where the line over the middle of the base meets S, in the box's coordinates.
fn middle(column: &Column) -> [F64Interval; 3] {
    let mut along = orders(&[]);
    along[column.axis] = 1;
    let slope = column.part.form.derivative(along);
    let at = |w: F64Interval| std::array::from_fn(|axis| if axis == column.axis { w } else { exactly(0.5) });
    let (mut lo, mut hi) = (0.0, 1.0);
    for _ in 0..48 {
        let w = f64::midpoint(lo, hi);
        let f = column.part.form.derivative_at(&at(exactly(w)), [0; 3]);
        match f.known_sign().map(|sign| sign * column.sign) {
            Some(Sign::Negative) => lo = w,
            Some(Sign::Positive) => hi = w,
            Some(Sign::Zero) | None => {
                // Newton's step, by the mean value theorem.
                if let Some(step) = quotient(f, slope) {
                    let root = exactly(w) - &step;
                    (lo, hi) = (root.lo().max(lo), root.hi().min(hi));
                }
                break;
            }
        }
    }
    at(between(lo, hi))
}

/// g on S over the column, with its slopes along the base: on S, d/du = ∂ᵤ − (f_u/f_w) ∂_w.
fn integrand(column: &Column) -> Option<Dual> {
    let [u, v] = column.base();
    let w = column.axis;
    let table = column.part.form.derivatives();
    let at = |axes: &[usize]| {
        let [a, b, c] = orders(axes);
        table[a][b][c] * &scale(&column.part.sides, axes)
    };
    let [tilt_u, tilt_v] = [quotient(-at(&[u]), at(&[w]))?, quotient(-at(&[v]), at(&[w]))?];
    let derivative = |axes: &[usize]| {
        let along = |axis: usize| at(&[axes, &[axis]].concat());
        let up = along(w);
        Dual { value: at(axes), slopes: [along(u) + &(up * &tilt_u), along(v) + &(up * &tilt_v)] }
    };
    curvature_over_base(derivative, column)
}

/// K|∇f|/|f_w| = ∇fᵀ adj(Hess f) ∇f/(|∇f|³ |f_w|).
fn curvature_over_base(derivative: impl Fn(&[usize]) -> Dual, column: &Column) -> Option<Dual> {
    let upper: [[Dual; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| if i <= j { derivative(&[i, j]) } else { Dual::integer(0) }));
    let jet = Jet {
        value: Dual::integer(0),
        gradient: Vector(std::array::from_fn(|i| derivative(&[i]))),
        hessian: Matrix::from_fn(|i, j| upper[i.min(j)][i.max(j)]),
    };
    let norm_squared = jet.gradient.0.iter().fold(Dual::integer(0), |sum, x| sum + &x.square());
    let norm = norm_squared.root()?;
    let rise = jet.gradient[column.axis].square().root()?;
    Some(gaussian_numerator(&jet) * &(norm_squared * &norm * &rise).reciprocal()?)
}

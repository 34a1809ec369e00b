//! ∫ K dA over a spline's isosurface by the degree of its Gauss map: a count of points, each proved.

use super::cell_form::{CellForm, EnclosedSpline, may_vanish};
use super::enclosure::exactly;
use super::tensor::Spline;
use super::total_curvature::Unresolved;
use crate::curvature::implicit_surface::gaussian_numerator;
use crate::linear::{Matrix, Vector};
use crate::number::{Enclosure, F64Interval, Rational, Ring, Sign};
use thiserror::Error;

/// How often a cell is halved, over all axes, before it is given up.
const DEEPEST: u32 = 3 * 36;

/// Directions without a coordinate 0, tried one after the other until no point with that normal is degenerate or unlucky.
const DIRECTIONS: [[i64; 3]; 4] = [[43, 61, 37], [29, 31, 71], [97, 53, 41], [13, 17, 11]];

/// A point of {f = c} with the normal ±p.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NormalPoint {
    /// A box that it lies in, by two corners; no other point with the normal ±p does.
    pub within: [[Rational; 3]; 2],
    /// The sign of K: never 0.
    pub curvature: Sign,
}

/// A direction without three coordinates that are not 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("direction: needs three coordinates that are not 0, and of magnitude at most 1000")]
pub struct FlatDirection;

/// A direction p = (p₁, p₂, p₃), no pᵢ being 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Direction([i64; 3]);

impl Direction {
    /// # Errors
    /// iff a coordinate is 0, or above 1000 in magnitude.
    pub fn new(p: [i64; 3]) -> Result<Direction, FlatDirection> {
        if p.iter().all(|x| (1..=1000).contains(&x.unsigned_abs())) { Ok(Direction(p)) } else { Err(FlatDirection) }
    }

    /// The four (p₁, ±p₂, ±p₃): with their opposites all that the three mirrors make of p.
    pub fn mirrored(self) -> [Direction; 4] {
        let [a, b, c] = self.0;
        [[a, b, c], [a, -b, c], [a, b, -c], [a, -b, -c]].map(Direction)
    }

    /// Two vectors that span the plane across p: (p₂, −p₁, 0) and (0, p₃, −p₂).
    fn across(self) -> [[i64; 3]; 2] {
        let [a, b, c] = self.0;
        [[b, -a, 0], [0, c, -b]]
    }
}

/// The points of {f = c} with the normal ±p, all of them, in the grid's box or in a period. SP-88.
///
/// They solve f = c, ⟨q₁, ∇f⟩ = 0, ⟨q₂, ∇f⟩ = 0 with q₁, q₂ across p. A box is discarded where one of the three is proved not to vanish, halved,
/// or kept where Krawczyk's operator proves that they have exactly one common zero, inside of it, and ∇fᵀ adj(Hess f) ∇f = K|∇f|⁴ has a strict
/// sign on all of the box. A singular point, ∇f = 0 = f − c, would solve all three and have K|∇f|⁴ = 0: so there is none on
/// {f = c}.
///
/// # Errors
/// iff some box stays undecided after 36 halvings of each side: a singular point, one with K = 0, or one on a common face of boxes.
#[doc(alias = "SP-88")]
pub fn normal_points(
    spline: &Spline<3>,
    isovalue: &Rational,
    direction: Direction,
) -> Result<Vec<NormalPoint>, Unresolved> {
    let f = EnclosedSpline::new(spline, isovalue);
    let mut points = Vec::new();
    for cell in f.cells() {
        let Some(form) = f.cell(cell) else { continue };
        let across = direction.across().map(|q| form.directional(q));
        let [first, second] = across;
        let part = Part { forms: [form, first, second], low: cell.map(|i| i as f64), sides: [1.0; 3] };
        if !search(&mut points, part) {
            return Err(Unresolved { cell });
        }
    }
    Ok(points)
}

/// ∫ K dA over {f = c} within the grid's box or within a period, in units of π/2: an integer. SP-86, SP-87.
///
/// It is the sum of the signs of K over the points whose normal is one of the eight (±p₁, ±p₂, ±p₃), whatever p is. With a mirror boundary it
/// is 4χ − (crossings of {f = c} with the box's edges), with a periodic one 4χ of the surface in the torus.
///
/// # Errors
/// As [`normal_points`], for each of four directions p.
#[doc(alias = "SP-86")]
#[doc(alias = "SP-87")]
pub fn quarter_turns(spline: &Spline<3>, isovalue: &Rational) -> Result<i64, Unresolved> {
    let mut last = Ok(0);
    for p in DIRECTIONS {
        last = quarter_turns_by(spline, isovalue, Direction(p));
        if last.is_ok() {
            break;
        }
    }
    last
}

/// [`quarter_turns`] by one direction.
///
/// # Errors
/// As [`normal_points`].
pub fn quarter_turns_by(spline: &Spline<3>, isovalue: &Rational, direction: Direction) -> Result<i64, Unresolved> {
    let mut sum = 0;
    for p in direction.mirrored() {
        let points = normal_points(spline, isovalue, p)?;
        sum += points.iter().map(|point| i64::from(point.curvature.value())).sum::<i64>();
    }
    Ok(sum)
}

/// f − c, ⟨q₁, ∇f⟩ and ⟨q₂, ∇f⟩ on a part of a cell.
struct Part {
    forms: [CellForm; 3],
    low: [f64; 3],
    sides: [f64; 3],
}

/// Whether all the points in a part of a cell were found.
fn search(points: &mut Vec<NormalPoint>, part: Part) -> bool {
    // The last box is taken first, so that what cannot be resolved is met soon; a list, for recursion would be too deep for a stack.
    let mut pending = vec![(part, 0)];
    while let Some((part, depth)) = pending.pop() {
        match certified(&part) {
            Certificate::NoPoint => {}
            Certificate::OnePoint(curvature) => points.push(NormalPoint { within: part.corners(), curvature }),
            Certificate::Missing if depth == DEEPEST => return false,
            Certificate::Missing => {
                pending.extend(part.halves((depth % 3) as usize).map(|half| (half, depth + 1)));
            }
        }
    }
    true
}

/// What is proved of a box.
enum Certificate {
    NoPoint,
    /// There is one, with that sign of K.
    OnePoint(Sign),
    Missing,
}

fn certified(part: &Part) -> Certificate {
    if !part.forms.iter().all(|form| may_vanish(form.range())) {
        return Certificate::NoPoint;
    }
    match zeros(&part.forms) {
        Zeros::None => Certificate::NoPoint,
        Zeros::One => match gaussian_numerator(&part.forms[0].jet(&part.sides)).known_sign() {
            Some(curvature @ (Sign::Positive | Sign::Negative)) => Certificate::OnePoint(curvature),
            Some(Sign::Zero) | None => Certificate::Missing,
        },
        Zeros::Unknown => Certificate::Missing,
    }
}

impl Part {
    fn halves(self, axis: usize) -> [Part; 2] {
        let mut sides = self.sides;
        sides[axis] /= 2.0;
        let mut high = self.low;
        high[axis] += sides[axis];
        let [[a, d], [b, e], [c, f]] = self.forms.each_ref().map(|form| form.split(axis));
        [Part { forms: [a, b, c], low: self.low, sides }, Part { forms: [d, e, f], low: high, sides }]
    }

    fn corners(&self) -> [[Rational; 3]; 2] {
        // Both are dyadic with few digits.
        let corner = |share: f64| {
            std::array::from_fn(|a| {
                let exact = |x: f64| Rational::from_f64(x).expect("a finite coordinate");
                exact(self.low[a]) + exact(self.sides[a] * share)
            })
        };
        [corner(0.0), corner(1.0)]
    }
}

/// How many common zeros three functions have in a closed box.
enum Zeros {
    None,
    /// One, inside.
    One,
    Unknown,
}

/// Krawczyk's operator: K(X) = m − Y F(m) + (I − Y F′(X))(X − m), m the middle of X and Y near F′(m)⁻¹. Every zero of F in X is in K(X);
/// if K(X) lies inside of X, there is exactly one.
fn zeros(forms: &[CellForm; 3]) -> Zeros {
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let jacobian = Matrix::from_fn(|i, j| forms[i].derivative(axes[j]));
    let Some(inverse) = near_inverse(&jacobian) else { return Zeros::Unknown };
    let half = exactly(0.5);
    let at_middle = Vector(forms.each_ref().map(|form| form.derivative_at(&[half; 3], [0; 3])));
    let product = inverse.times(&jacobian);
    let rest = Matrix::from_fn(|i, j| F64Interval::integer(i64::from(i == j)) - &product.0[i][j]);
    let radius = F64Interval::between(-0.5, 0.5).expect("both are finite");
    let image = -inverse.apply(&at_middle) + &rest.apply(&Vector([radius; 3]));
    match (image.0.iter().all(|x| -0.5 < x.lo() && x.hi() < 0.5), image.0.iter().any(|x| x.lo() > 0.5 || x.hi() < -0.5))
    {
        (true, _) => Zeros::One,
        (false, true) => Zeros::None,
        (false, false) => Zeros::Unknown,
    }
}

/// The inverse of the matrix of the middles, by its adjugate, in plain binary64: any matrix would be sound.
fn near_inverse(Matrix(a): &Matrix<F64Interval, 3, 3>) -> Option<Matrix<F64Interval, 3, 3>> {
    let m = a.map(|row| row.map(|x| f64::midpoint(x.lo(), x.hi())));
    let cofactor = |i: usize, j: usize| {
        let (p, q, r, s) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        m[p][r] * m[q][s] - m[p][s] * m[q][r]
    };
    let determinant: f64 = (0..3).map(|j| m[0][j] * cofactor(0, j)).sum();
    let entry = |i: usize, j: usize| cofactor(j, i) / determinant;
    let is_finite = (0..9).all(|k| entry(k / 3, k % 3).is_finite());
    is_finite.then(|| Matrix::from_fn(|i, j| exactly(entry(i, j))))
}

//! Values, derivatives and curvatures of the interpolant at points, correctly rounded.

use super::exact::Exact;
use super::{Enclosed, Sample, rounding};
use crate::curvature::implicit_surface::{curvature, gaussian_numerator, mean_numerator};
use crate::curvature::jet::Jet;
use crate::linear::{Matrix, Vector};
use crate::number::binary::nearest_f64;
use crate::number::{Integer, Interval, Rational, Ring, Sign, Surd};
use crate::spline::basis::{split, weights};
use std::cmp::Ordering;
use thiserror::Error;

/// The precision of the first enclosures: that of doubled numbers and some more.
const BITS: u32 = 128;

/// A level surface of the interpolant at a point; every number is the binary64 nearest to the exact one. SP-84.
///
/// N = +∇f/|∇f|, the principal curvatures k₁ ≥ k₂ are the eigenvalues of −dN, K = k₁k₂, H = (k₁ + k₂)/2: on a sphere
/// x² + y² + z² = r², H = −1/r.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelSurface64 {
    /// f, ∇f and the Hessian.
    pub jet: Jet<f64, 3>,
    /// K.
    pub gaussian: f64,
    /// H.
    pub mean: f64,
    /// k₁, k₂.
    pub principal: [f64; 2],
}

/// Why there is no answer at a point.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum JetError {
    /// ∇f = 0: the level set has no normal.
    #[error("points[{point}]: a singular point: the gradient is zero")]
    Singular {
        /// The index of the point.
        point: usize,
    },
    /// A result rounds to an infinity.
    #[error("points[{point}]: too large for a binary64")]
    Overflow {
        /// The index of the point.
        point: usize,
    },
}

impl<T: Sample, const N: usize> Enclosed<'_, T, N> {
    /// f, ∇f and the Hessian of the exact interpolant at any real points, each number correctly rounded; an exact 0 is +0. SP-83.
    ///
    /// # Errors
    /// `Overflow` for a point iff one of its numbers is not finite.
    #[doc(alias = "SP-83")]
    pub fn jets(&self, points: &[[Rational; N]]) -> Vec<Result<Jet<f64, N>, JetError>> {
        let answered = self.answered(points, &|jet| rounded_jet(jet, nearest), &|jet| {
            rounded_jet(jet, |x| Some(nearest_f64(x))).expect("a rational is rounded")
        });
        let checked = answered
            .into_iter()
            .enumerate()
            .map(|(point, jet)| if is_finite(&jet) { Ok(jet) } else { Err(JetError::Overflow { point }) });
        checked.collect()
    }

    /// What the enclosing function says of each point's enclosed jet, or, where that is `None`, the exact one of its exact jet.
    fn answered<A>(
        &self,
        points: &[[Rational; N]],
        enclosing: &dyn Fn(&Jet<Interval, N>) -> Option<A>,
        exactly: &dyn Fn(&Jet<Rational, N>) -> A,
    ) -> Vec<A> {
        let places: Vec<Place<N>> = points.iter().map(|x| Place::new(self, x)).collect();
        let first: Vec<Option<A>> = places.iter().map(|place| enclosing(&self.enclosed_jet(place))).collect();
        // All doubtful points together need one exact solution, of their neighbourhoods alone.
        let mut near: Vec<usize> =
            places.iter().zip(&first).filter(|(_, a)| a.is_none()).flat_map(|(p, _)| p.neighbours.clone()).collect();
        near.sort_unstable();
        near.dedup();
        let solved = if near.is_empty() {
            Vec::new()
        } else {
            Exact::new(self.samples, &self.shape, self.boundary).rationals(&near)
        };
        let exact_jet = |place: &Place<N>| {
            let c = |i: &usize| solved[near.binary_search(i).expect("it was asked for")].clone();
            place.jet(place.neighbours.iter().map(c).collect(), Rational::clone)
        };
        first.into_iter().zip(&places).map(|(a, place)| a.unwrap_or_else(|| exactly(&exact_jet(place)))).collect()
    }

    fn enclosed_jet(&self, place: &Place<N>) -> Jet<Interval, N> {
        let coefficient = |&i: &usize| {
            let (lo, hi) = self.bounds(i);
            Interval::between(&lo, &hi, BITS).expect("in order")
        };
        place.jet(place.neighbours.iter().map(coefficient).collect(), |w| Interval::from_rational(w, BITS))
    }
}

impl<T: Sample> Enclosed<'_, T, 3> {
    /// The jets with K, H, k₁ and k₂ of the level surfaces through the points, each number correctly rounded. SP-84.
    ///
    /// # Errors
    /// `Singular` for a point iff ∇f = 0 there, `Overflow` iff one of its numbers is not finite; the other points are answered.
    #[doc(alias = "SP-84")]
    pub fn level_surfaces(&self, points: &[[Rational; 3]]) -> Vec<Result<LevelSurface64, JetError>> {
        let answered = self.answered(points, &|jet| enclosed_surface(jet).map(Some), &exact_surface);
        let checked = answered.into_iter().enumerate().map(|(point, surface)| {
            let surface = surface.ok_or(JetError::Singular { point })?;
            let numbers = [surface.gaussian, surface.mean, surface.principal[0], surface.principal[1]];
            let is_sound = is_finite(&surface.jet) && numbers.iter().all(|x| x.is_finite());
            if is_sound { Ok(surface) } else { Err(JetError::Overflow { point }) }
        });
        checked.collect()
    }
}

/// Where a point lies: the 4ᴺ coefficients around it, the first axis fastest, and their weights for each axis and order.
struct Place<const N: usize> {
    neighbours: Vec<usize>,
    weights: [[[Rational; 4]; 3]; N],
}

impl<const N: usize> Place<N> {
    fn new<T: Sample>(volume: &Enclosed<'_, T, N>, x: &[Rational; N]) -> Place<N> {
        let split = x.each_ref().map(split);
        let index =
            |axis: usize, m: usize| volume.boundary.index(&(Integer::from(&split[axis].0 + m) - 1), volume.shape[axis]);
        let indices: [[usize; 4]; N] = std::array::from_fn(|axis| std::array::from_fn(|m| index(axis, m)));
        let place = |m: usize| {
            (0..N).rev().fold(0, |sum, axis| sum * volume.shape[axis] + indices[axis][(m >> (2 * axis)) & 3])
        };
        let weights = std::array::from_fn(|axis| std::array::from_fn(|order| weights(&split[axis].1, order as u32)));
        Place { neighbours: (0..1 << (2 * N)).map(place).collect(), weights }
    }

    /// The jet from the coefficients, over any ring that the weights go into.
    fn jet<K: Ring>(&self, coefficients: Vec<K>, from: impl Fn(&Rational) -> K) -> Jet<K, N> {
        let weights = self.weights.each_ref().map(|axis| axis.each_ref().map(|order| order.each_ref().map(&from)));
        let mut jet = Jet::constant(K::integer(0));
        contract(&coefficients, &weights, &mut Vec::new(), &mut |axes, value| match *axes {
            [] => jet.value = value,
            [i] => jet.gradient.0[i] = value,
            [i, j, ..] => {
                jet.hessian.0[i][j] = value.clone();
                jet.hessian.0[j][i] = value;
            }
        });
        jet
    }
}

/// All derivatives of order up to 2, each with the axes that it is along; the last axis, the slowest, is summed up first.
fn contract<K: Ring>(values: &[K], weights: &[[[K; 4]; 3]], axes: &mut Vec<usize>, found: &mut dyn FnMut(&[usize], K)) {
    let Some((last, rest)) = weights.split_last() else { return found(axes, values[0].clone()) };
    let quarter = values.len() / 4;
    for (order, w) in last.iter().enumerate().take(3 - axes.len()) {
        let sum = |i: usize| {
            (1..4).fold(w[0].clone() * &values[i], |sum, m| sum + &(w[m].clone() * &values[i + m * quarter]))
        };
        let sums: Vec<K> = (0..quarter).map(sum).collect();
        let before = axes.len();
        axes.extend(std::iter::repeat_n(rest.len(), order));
        contract(&sums, rest, axes, found);
        axes.truncate(before);
    }
}

/// The binary64 nearest to all numbers of an interval; `None` where there is no such one.
fn nearest(x: &Interval) -> Option<f64> {
    let (lo, hi) = x.bounds()?;
    rounding::nearest_within(&lo, &hi)
}

/// Each number of a jet, rounded.
fn rounded_jet<K: Ring, const N: usize>(jet: &Jet<K, N>, nearest: impl Fn(&K) -> Option<f64>) -> Option<Jet<f64, N>> {
    let mut rounded = Jet { value: nearest(&jet.value)?, gradient: Vector([0.0; N]), hessian: Matrix([[0.0; N]; N]) };
    for i in 0..N {
        rounded.gradient.0[i] = nearest(&jet.gradient[i])?;
        for j in 0..N {
            rounded.hessian.0[i][j] = nearest(&jet.hessian.0[i][j])?;
        }
    }
    Some(rounded)
}

fn is_finite<const N: usize>(jet: &Jet<f64, N>) -> bool {
    let rows = jet.hessian.0.iter().flatten();
    rows.chain(&jet.gradient.0).chain([&jet.value]).all(|x| x.is_finite())
}

fn enclosed_surface(jet: &Jet<Interval, 3>) -> Option<LevelSurface64> {
    let rounded = rounded_jet(jet, nearest)?;
    let w = jet.gradient.norm_squared();
    let gaussian = gaussian_numerator(jet).checked_div(&(w.clone() * &w))?;
    let mean = (-mean_numerator(jet)).checked_div(&(w.sqrt()? * &w * &Interval::integer(2)))?;
    let spread = (mean.clone() * &mean - &gaussian).sqrt()?;
    let principal = [nearest(&(mean.clone() + &spread))?, nearest(&(mean.clone() - &spread))?];
    Some(LevelSurface64 { jet: rounded, gaussian: nearest(&gaussian)?, mean: nearest(&mean)?, principal })
}

/// `None` iff ∇f = 0.
fn exact_surface(jet: &Jet<Rational, 3>) -> Option<LevelSurface64> {
    let surface = curvature(jet).ok()?;
    let (mean, spread) = ((surface.mean_sign, &surface.mean_squared), &surface.discriminant());
    Some(LevelSurface64 {
        jet: rounded_jet(jet, |x| Some(nearest_f64(x))).expect("a rational is rounded"),
        gaussian: nearest_f64(&surface.gaussian),
        mean: nearest_of_roots(mean, (Sign::Zero, spread)),
        principal: [Sign::Positive, Sign::Negative].map(|sign| nearest_of_roots(mean, (sign, spread))),
    })
}

/// The binary64 nearest to s√x + t√y, x and y ≥ 0, each root with its sign. SP-84.
///
/// Square factors are only looked for in the radicands where enclosures settle nothing: where the sum is 0, or a tie.
fn nearest_of_roots((s, x): (Sign, &Rational), (t, y): (Sign, &Rational)) -> f64 {
    let (s, t) = (if x.is_zero() { Sign::Zero } else { s }, if y.is_zero() { Sign::Zero } else { t });
    if s == -t && (s == Sign::Zero || x == y) {
        return 0.0;
    }
    let root = |sign: Sign, x: &Rational, bits| {
        let root = Interval::from_rational(x, bits).sqrt().expect("it is not negative");
        root * &Interval::integer(sign.value().into())
    };
    let enclosure = |bits| nearest(&(root(s, x, bits) + &root(t, y, bits)));
    enclosure(BITS).or_else(|| enclosure(8 * BITS)).unwrap_or_else(|| {
        let surd = |sign: Sign, x: &Rational| {
            Surd::new(Rational::new(), Rational::from(sign.value()), x).expect("it is not negative")
        };
        nearest_sum(&surd(s, x), &surd(t, y))
    })
}

/// The binary64 nearest to a + b. SP-84.
///
/// The enclosure narrows until its ends round to the same, or to two neighbours: then the exact order of a + b and of the number
/// half-way decides. It narrows that far, for a number that is not 0 has a width of roundings around it.
fn nearest_sum(a: &Surd, b: &Surd) -> f64 {
    if *a == -b.clone() {
        return 0.0;
    }
    let mut bits = BITS;
    loop {
        let (lo, hi) = (a.enclosure(bits) + &b.enclosure(bits)).bounds().expect("within the exponents of MPFR");
        if let Some(x) = rounding::nearest_within(&lo, &hi) {
            return x;
        }
        let (x, y) = (nearest_f64(&lo), nearest_f64(&hi));
        if lo.cmp0() == hi.cmp0() && x.next_up() == y {
            let middle = (value(x) + value(y)) / 2_u32;
            // a + b against m is a against m − b: each is in one field.
            return match a.cmp(&(Surd::from(middle.clone()) - b)) {
                Ordering::Less => x,
                Ordering::Equal => nearest_f64(&middle),
                Ordering::Greater => y,
            };
        }
        bits *= 2;
    }
}

/// x, where ±∞ stands for ±2¹⁰²⁴, the number after the largest one were there no limit.
fn value(x: f64) -> Rational {
    Rational::from_f64(x).unwrap_or_else(|| (Rational::from(1) << 1024_u32) * if x > 0.0 { 1 } else { -1 })
}

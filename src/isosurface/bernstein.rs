//! A polynomial on a box in Bernstein form, up to a positive factor: its coefficients bound it.
//!
//! f = Σ b_{ijk} B_i(u) B_j(v) B_k(w) with B_i(u) = C(n,i) uⁱ (1−u)ⁿ⁻ⁱ ≥ 0 and Σ B_i = 1, (u, v, w) the
//! coordinates of the box. So a strict sign of all b is the sign of f. A face of the box has the coefficients of the
//! same face of the array, and the derivative along an axis has, up to n/width > 0, their differences.

use super::cube::Corner;
use crate::number::Trivariate;
use crate::number::{Integer, Rational, Sign};

/// A box with corners of rational coordinates, low < high along each axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Region {
    low: [Rational; 3],
    high: [Rational; 3],
}

impl Region {
    /// The box between two corners; `None` unless low < high along each axis.
    pub fn new(low: [Rational; 3], high: [Rational; 3]) -> Option<Region> {
        low.iter().zip(&high).all(|(low, high)| low < high).then_some(Region { low, high })
    }

    /// The corner of the least coordinates.
    pub fn low(&self) -> &[Rational; 3] {
        &self.low
    }

    /// The corner of the greatest coordinates.
    pub fn high(&self) -> &[Rational; 3] {
        &self.high
    }

    /// Its volume.
    pub fn volume(&self) -> Rational {
        (0..3).fold(Rational::from(1), |product, i| product * Rational::from(&self.high[i] - &self.low[i]))
    }

    /// The point with these coordinates, from 0 to 1 within the box.
    pub fn point(&self, shares: &[Rational; 3]) -> [Rational; 3] {
        [0, 1, 2].map(|i| Rational::from(&self.high[i] - &self.low[i]) * &shares[i] + &self.low[i])
    }

    /// One of its corners.
    pub fn corner(&self, c: Corner) -> [Rational; 3] {
        self.point(&c.position().map(Rational::from))
    }

    /// The part of the box at a corner, when each axis is cut at this share.
    pub fn child(&self, c: Corner, share: &Rational) -> Region {
        let cut = self.point(&[share.clone(), share.clone(), share.clone()]);
        let mut child = self.clone();
        for (axis, cut) in cut.into_iter().enumerate() {
            if c.position()[axis] == 0 { child.high[axis] = cut } else { child.low[axis] = cut }
        }
        child
    }
}

/// How a part of a cell extends along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Extent {
    /// At the low end.
    Low,
    /// At the high end.
    High,
    /// From end to end.
    Across,
}

/// One of the 27 parts of a closed cell: 8 corners, 12 edges, 6 faces, and the cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Part(pub [Extent; 3]);

impl Part {
    /// The whole cell.
    pub const WHOLE: Part = Part([Extent::Across; 3]);

    /// All 27, by dimension.
    pub fn all() -> Vec<Part> {
        const EXTENTS: [Extent; 3] = [Extent::Low, Extent::High, Extent::Across];
        let mut all: Vec<Part> = (0..27).map(|n| Part([n % 3, n / 3 % 3, n / 9].map(|i| EXTENTS[i]))).collect();
        all.sort_by_key(|part| part.dimension());
        all
    }

    /// A corner.
    pub fn corner(c: Corner) -> Part {
        Part(c.position().map(|x| if x == 0 { Extent::Low } else { Extent::High }))
    }

    /// 0 for a corner, … 3 for the cell.
    pub fn dimension(self) -> usize {
        self.axes().count()
    }

    /// The axes along which it extends.
    pub fn axes(self) -> impl Iterator<Item = usize> {
        (0..3).filter(move |&axis| self.0[axis] == Extent::Across)
    }

    /// The set of its corners.
    pub fn corners(self) -> u8 {
        let holds = |c: &Corner| {
            (0..3).all(|axis| match self.0[axis] {
                Extent::Low => c.position()[axis] == 0,
                Extent::High => c.position()[axis] == 1,
                Extent::Across => true,
            })
        };
        Corner::ALL.iter().filter(|c| holds(c)).fold(0, |set, c| set | c.bit())
    }
}

/// The coefficients of a polynomial on a box, times a positive number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bernstein {
    degrees: [usize; 3],
    /// b_{ijk}, i fastest.
    coefficients: Vec<Integer>,
}

impl Bernstein {
    /// The Bernstein form of a polynomial on a box (IS-69).
    #[doc(alias = "IS-69")]
    pub fn of(f: &Trivariate, region: &Region) -> Bernstein {
        let degrees = f.degrees().map(|n| n as usize);
        let mut coefficients = vec![Rational::new(); degrees.iter().map(|n| n + 1).product()];
        for ([i, j, k], coefficient) in f.terms() {
            let [i, j, k] = [i, j, k].map(|n| n as usize);
            coefficients[i + (degrees[0] + 1) * (j + (degrees[1] + 1) * k)] = coefficient.clone();
        }
        for axis in 0..3 {
            let width = Rational::from(&region.high[axis] - &region.low[axis]);
            map_fibres(&mut coefficients, degrees, axis, |power| bernstein_1(power, &region.low[axis], &width));
        }
        let denominator = coefficients.iter().fold(Integer::from(1), |lcm, b| lcm.lcm(b.denom()));
        let coefficients = coefficients.iter().map(|b| Integer::from(&denominator / b.denom()) * b.numer()).collect();
        Bernstein { degrees, coefficients }
    }

    /// The strict sign that all coefficients of a part have; then f has it there. At a corner it is the sign of f.
    pub fn sign(&self, part: Part) -> Option<Sign> {
        common(self.indices(part, None).map(|[i, j, k]| Sign::of(self.at([i, j, k]).cmp0())))
    }

    /// The strict sign of the derivative along one of a part's own axes, where all its coefficients on the part
    /// have it.
    pub fn slope(&self, part: Part, axis: usize) -> Option<Sign> {
        common(self.indices(part, Some(axis)).map(|index| {
            let mut next = index;
            next[axis] += 1;
            Sign::of(self.at(next).cmp(self.at(index)))
        }))
    }

    /// The eight forms on the parts of the box when each axis is cut at the share p/q, 0 < p < q, by corner.
    pub fn split(&self, p: &Integer, q: &Integer) -> [Bernstein; 8] {
        let halves = |form: Bernstein, axis: usize| {
            let mut halves = [form.clone(), form];
            for (side, half) in halves.iter_mut().enumerate() {
                map_fibres(&mut half.coefficients, self.degrees, axis, |b| half_1(b, p, q, side));
            }
            halves
        };
        // The last axis first, so that x is fastest, as in the order of corners.
        let quarters = halves(self.clone(), 2).map(|half| halves(half, 1));
        let [[a, b], [c, d]] = quarters.map(|pair| pair.map(|quarter| halves(quarter, 0)));
        let ([a, e], [b, g], [c, h], [d, i]) = (a, b, c, d);
        [a, e, b, g, c, h, d, i]
    }

    fn at(&self, [i, j, k]: [usize; 3]) -> &Integer {
        &self.coefficients[i + (self.degrees[0] + 1) * (j + (self.degrees[1] + 1) * k)]
    }

    /// The places of a part's coefficients, without the last along `short`; none if that is not its own axis.
    fn indices(&self, part: Part, short: Option<usize>) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let n = self.degrees[axis];
            match part.0[axis] {
                Extent::Low | Extent::High if short == Some(axis) => 0..0,
                Extent::Low => 0..1,
                Extent::High => n..n + 1,
                Extent::Across if short == Some(axis) => 0..n,
                Extent::Across => 0..n + 1,
            }
        });
        z.flat_map(move |k| {
            let x = x.clone();
            y.clone().flat_map(move |j| x.clone().map(move |i| [i, j, k]))
        })
    }
}

/// The sign that all have, if it is one strict sign; none have none.
fn common(mut signs: impl Iterator<Item = Sign>) -> Option<Sign> {
    let first = signs.next().filter(|sign| *sign != Sign::Zero)?;
    signs.all(|sign| sign == first).then_some(first)
}

/// Replaces each row of coefficients along an axis.
fn map_fibres<T: Clone>(coefficients: &mut [T], degrees: [usize; 3], axis: usize, map: impl Fn(Vec<T>) -> Vec<T>) {
    let stride: usize = degrees[..axis].iter().map(|n| n + 1).product();
    let length = degrees[axis] + 1;
    for start in (0..coefficients.len()).filter(|i| (*i / stride).is_multiple_of(length)) {
        let fibre = (0..length).map(|i| coefficients[start + i * stride].clone()).collect();
        for (i, value) in map(fibre).into_iter().enumerate() {
            coefficients[start + i * stride] = value;
        }
    }
}

/// From Σ cₖ xᵏ to Bernstein coefficients on [low, low + width].
fn bernstein_1(mut power: Vec<Rational>, low: &Rational, width: &Rational) -> Vec<Rational> {
    let n = power.len() - 1;
    // Taylor coefficients at low, by repeated synthetic division.
    for from in 0..n {
        for k in (from..n).rev() {
            let carried = Rational::from(&power[k + 1] * low);
            power[k] += carried;
        }
    }
    let mut scale = Rational::from(1);
    for coefficient in &mut power {
        *coefficient *= &scale;
        scale *= width;
    }
    // tᵏ = Σ_{i ≥ k} C(i,k) / C(n,k) · B_i(t).
    let choose = |n: usize, k: usize| Integer::from(n).binomial(k as u32);
    let term = |i: usize, k: usize| Rational::from((choose(i, k), choose(n, k))) * &power[k];
    (0..=n).map(|i| (0..=i).fold(Rational::new(), |sum, k| sum + term(i, k))).collect()
}

/// De Casteljau's coefficients on [0, p/q] (side 0) or [p/q, 1] (side 1), times qⁿ.
fn half_1(mut b: Vec<Integer>, p: &Integer, q: &Integer, side: usize) -> Vec<Integer> {
    let n = b.len() - 1;
    let rest = Integer::from(q - p);
    let mut half = vec![Integer::new(); n + 1];
    let mut missing = (0..n).fold(Integer::from(1), |power, _| power * q);
    for step in 0..=n {
        // After so many steps the row is n − step + 1 long and times q^step.
        let (place, value) = if side == 0 { (step, &b[0]) } else { (n - step, &b[n - step]) };
        half[place] = Integer::from(value * &missing);
        missing /= q;
        for i in 0..n - step {
            b[i] = Integer::from(&b[i] * &rest) + Integer::from(&b[i + 1] * p);
        }
    }
    half
}

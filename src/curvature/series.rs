//! Truncated power series over intervals: the Taylor coefficients of a function, enclosed.

use crate::number::{Enclosure, Interval, Polynomial, Rational, Ring, Sign};
use std::ops::{Add, Mul, Neg, Sub};

/// The Taylor coefficients ∂ᵏf/k! of a function of D variables, for all multi-indices k with |k| ≤ N, each within an interval. CU-129.
///
/// Around a point they are those at the point; around a box, from [`Series::variables`] at intervals, the one interval holds
/// the coefficient of every point of the box. A formula over [`Ring`], evaluated at series, gives the coefficients of its value.
#[derive(Clone, Debug)]
#[doc(alias = "CU-129")]
pub struct Series<const D: usize, const N: usize> {
    /// By [`index`].
    coefficients: Vec<Interval>,
}

/// n over k.
fn binomial(n: usize, k: usize) -> usize {
    (0..k).fold(1, |product, i| product * (n - i) / (i + 1))
}

/// The place of a multi-index: those of a smaller degree come first.
fn index<const D: usize>(k: &[usize; D]) -> usize {
    // Of the degree s of the entries from i on, and all smaller degrees, Σ C(s + D − 1 − i, D − i) multi-indices come before.
    (0..D)
        .map(|i| {
            let (degree, left) = (k[i..].iter().sum::<usize>(), D - i);
            if degree == 0 { 0 } else { binomial(degree + left - 1, left) }
        })
        .sum()
}

/// All multi-indices of degree ≤ N, in the order of their places.
pub fn multi_indices<const D: usize, const N: usize>() -> Vec<[usize; D]> {
    let mut all = vec![[0; D]];
    for axis in 0..D {
        let longer = |k: [usize; D]| {
            let rest = N - k.iter().sum::<usize>();
            (0..=rest).map(move |n| {
                let mut k = k;
                k[axis] = n;
                k
            })
        };
        all = all.into_iter().flat_map(longer).collect();
    }
    all.sort_by_key(index);
    all
}

/// a − b where that is a multi-index.
fn minus<const D: usize>(a: &[usize; D], b: &[usize; D]) -> Option<[usize; D]> {
    let mut difference = [0; D];
    for i in 0..D {
        difference[i] = a[i].checked_sub(b[i])?;
    }
    Some(difference)
}

impl<const D: usize, const N: usize> Series<D, N> {
    /// A constant function.
    pub fn constant(value: Interval) -> Series<D, N> {
        let mut coefficients = vec![Interval::integer(0); binomial(N + D, D)];
        coefficients[0] = value;
        Series { coefficients }
    }

    /// A rational constant.
    pub fn rational(value: &Rational, precision: u32) -> Series<D, N> {
        Series::constant(Interval::from_rational(value, precision))
    }

    /// The functions xᵢ + hᵢτᵢ of τ: the variables of a box around x, of the half sides h, brought to −1 ≤ τᵢ ≤ 1.
    ///
    /// # Panics
    /// Iff N = 0.
    pub fn variables(x: &[Interval; D], h: &[Interval; D]) -> [Series<D, N>; D] {
        std::array::from_fn(|axis| {
            let mut series = Series::constant(x[axis].clone());
            let mut k = [0; D];
            k[axis] = 1;
            series.coefficients[index(&k)] = h[axis].clone();
            series
        })
    }

    /// The coefficient ∂ᵏf/k!.
    ///
    /// # Panics
    /// Iff |k| > N.
    pub fn coefficient(&self, k: &[usize; D]) -> &Interval {
        &self.coefficients[index(k)]
    }

    /// Whether the value is known to be negative.
    pub fn value_is_negative(&self) -> bool {
        self.coefficients[0].known_sign() == Some(Sign::Negative)
    }

    /// The polynomial's series, by Horner's rule.
    pub fn of_polynomial(p: &Polynomial, x: &Series<D, N>, precision: u32) -> Series<D, N> {
        let zero = Series::constant(Interval::integer(0));
        p.coefficients().iter().rev().fold(zero, |value, a| value * x + &Series::rational(a, precision))
    }

    /// The most bits that a coefficient has.
    pub fn precision(&self) -> u32 {
        self.coefficients.iter().map(Interval::precision).max().unwrap_or(2)
    }

    /// f²: as the product, but for its value, which is not negative. CU-129.
    pub fn square(&self) -> Series<D, N> {
        let mut product = self.clone() * self;
        product.coefficients[0] = self.coefficients[0].square();
        product
    }

    /// 1/f; `None` where the interval of the value has 0 in it. From f·q = 1: q₀ = 1/f₀, qₙ = −(Σ fₖqₙ₋ₖ over k ≠ 0)/f₀. CU-129.
    pub fn inverse(&self) -> Option<Series<D, N>> {
        let first = Interval::integer(1).checked_div(&self.coefficients[0])?;
        Some(self.solved(first.clone(), |sum, _| -sum * &first, |f, _, k, rest| f.coefficient(k).clone() * rest))
    }

    /// √f, where f is known to be nowhere negative; `None` where its value's interval is below 0.
    ///
    /// From r² = f: r₀ = √f₀, rₙ = (fₙ − Σ rₖrₙ₋ₖ)/(2r₀), the sum over 0 < k < n. Where f may be 0 the derivatives of
    /// the root may be anything. CU-129.
    pub fn sqrt(&self) -> Option<Series<D, N>> {
        let root = self.coefficients[0].not_negative()?.sqrt()?;
        let twice = root.clone() + &root;
        let Some(half) = Interval::integer(1).checked_div(&twice) else {
            let everything = Interval::everything(self.precision());
            let mut coefficients = vec![everything; self.coefficients.len()];
            coefficients[0] = root;
            return Some(Series { coefficients });
        };
        let next = |sum: Interval, n: &[usize; D]| (self.coefficient(n).clone() - &sum) * &half;
        Some(self.solved(root, next, |_, r: &[Interval], k, rest| {
            // r itself: rₙ is not known yet, and stands on neither side of the sum.
            if index(k) < r.len() { r[index(k)].clone() * rest } else { Interval::integer(0) }
        }))
    }

    /// The series whose value is `first`, and each further coefficient n is `next` of the sum over 0 ≠ k ≤ n of
    /// `term(self, known, k, coefficient n − k)`, n − k ≠ n; a coefficient not known yet does not count.
    fn solved(
        &self,
        first: Interval,
        next: impl Fn(Interval, &[usize; D]) -> Interval,
        term: impl Fn(&Series<D, N>, &[Interval], &[usize; D], &Interval) -> Interval,
    ) -> Series<D, N> {
        let all = multi_indices::<D, N>();
        let mut known = vec![first];
        for n in &all[1..] {
            let parts = all[1..].iter().filter_map(|k| Some((k, minus(n, k)?)));
            let sum =
                parts.fold(Interval::integer(0), |sum, (k, rest)| sum + &term(self, &known, k, &known[index(&rest)]));
            known.push(next(sum, n));
        }
        Series { coefficients: known }
    }

    /// (sin f, cos f). From s′ = f′c and c′ = −f′s along an axis i with nᵢ > 0: nᵢsₙ = Σ kᵢfₖcₙ₋ₖ, nᵢcₙ = −Σ kᵢfₖsₙ₋ₖ. CU-129.
    pub fn sin_cos(&self) -> (Series<D, N>, Series<D, N>) {
        let all = multi_indices::<D, N>();
        let (mut s, mut c) = (vec![self.coefficients[0].sin()], vec![self.coefficients[0].cos()]);
        for n in &all[1..] {
            let axis = (0..D).find(|&i| n[i] > 0).expect("n is not 0");
            let whole = Interval::integer(n[axis] as i64);
            let sum = |of: &[Interval]| {
                let parts = all[1..].iter().filter(|k| k[axis] > 0).filter_map(|k| Some((k, minus(n, k)?)));
                let sum = parts.fold(Interval::integer(0), |sum, (k, rest)| {
                    sum + &(self.coefficient(k).clone() * &Interval::integer(k[axis] as i64) * &of[index(&rest)])
                });
                sum.checked_div(&whole).expect("nᵢ > 0")
            };
            let (next_s, next_c) = (sum(&c), -sum(&s));
            s.push(next_s);
            c.push(next_c);
        }
        (Series { coefficients: s }, Series { coefficients: c })
    }

    fn entrywise(&self, other: &Series<D, N>, combine: impl Fn(Interval, &Interval) -> Interval) -> Series<D, N> {
        let entries = self.coefficients.iter().zip(&other.coefficients);
        Series { coefficients: entries.map(|(a, b)| combine(a.clone(), b)).collect() }
    }
}

impl<const D: usize, const N: usize> Add<&Series<D, N>> for Series<D, N> {
    type Output = Series<D, N>;
    fn add(self, other: &Series<D, N>) -> Series<D, N> {
        self.entrywise(other, |a, b| a + b)
    }
}

impl<const D: usize, const N: usize> Sub<&Series<D, N>> for Series<D, N> {
    type Output = Series<D, N>;
    fn sub(self, other: &Series<D, N>) -> Series<D, N> {
        self.entrywise(other, |a, b| a - b)
    }
}

impl<const D: usize, const N: usize> Mul<&Series<D, N>> for Series<D, N> {
    type Output = Series<D, N>;
    fn mul(self, other: &Series<D, N>) -> Series<D, N> {
        let all = multi_indices::<D, N>();
        let mut product = vec![Interval::integer(0); all.len()];
        for (a, x) in all.iter().zip(&self.coefficients).filter(|(_, x)| !x.is_zero()) {
            let degree = a.iter().sum::<usize>();
            let few = all.iter().take_while(|b| degree + b.iter().sum::<usize>() <= N);
            for (b, y) in few.zip(&other.coefficients).filter(|(_, y)| !y.is_zero()) {
                let sum = std::array::from_fn(|i| a[i] + b[i]);
                let entry = &mut product[index::<D>(&sum)];
                *entry = entry.clone() + &(x.clone() * y);
            }
        }
        Series { coefficients: product }
    }
}

impl<const D: usize, const N: usize> Neg for Series<D, N> {
    type Output = Series<D, N>;
    fn neg(self) -> Series<D, N> {
        Series { coefficients: self.coefficients.into_iter().map(Interval::neg).collect() }
    }
}

impl<const D: usize, const N: usize> Ring for Series<D, N> {
    fn integer(n: i64) -> Series<D, N> {
        Series::constant(Interval::integer(n))
    }
}

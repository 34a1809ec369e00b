//! Doubled numbers hi + lo with a running bound of their error, and the elimination of [1 4 1] in them, many lines at a time.
//!
//! u = 2⁻⁵³. What is represented lies within hi + lo ± err; |lo| ≤ u|hi| always, for each operation ends with an exact sum. The
//! bounds of each operation are proven at SP-80.

use crate::spline::signal::Boundary;
use pulp::{Simd, WithSimd};
use rug::Float;

/// u² = 2⁻¹⁰⁶.
const U2: f64 = 1.0 / (1_u128 << 106) as f64;

/// The error of a product by a constant, relative to the product.
const PRODUCT: f64 = 16.0 * U2;

/// The error of a difference, relative to |x| + |y|.
const DIFFERENCE: f64 = 4.0 * U2;

/// More than what underflow adds to the error of a product: a few halves of 2⁻¹⁰⁷⁴.
const UNDERFLOW: f64 = f64::from_bits(1 << 4);

/// What a bound is multiplied by, so that its own roundings cannot make it too small.
pub(super) const INFLATION: f64 = 1.0 + 1.0 / (1_u64 << 40) as f64;

/// The precision at which constants are worked out before they are cut to doubled numbers.
const CONSTANT_BITS: u32 = 256;

/// From this row on the elimination's factors are 2 − √3 up to 2⁻¹⁵⁰.
const ROWS_TO_LIMIT: usize = 40;

/// A real number m: |m − (hi + lo)| ≤ 2u²|m|, |m| ≤ bound.
#[derive(Clone, Copy, Debug)]
struct Constant {
    hi: f64,
    lo: f64,
    bound: f64,
}

impl Constant {
    fn new(m: &Float) -> Constant {
        let hi = m.to_f64();
        Constant { hi, lo: Float::with_val(CONSTANT_BITS, m - hi).to_f64(), bound: hi.abs() * INFLATION }
    }
}

/// The constants of the elimination of one line of n samples. SP-79.
#[doc(alias = "SP-79")]
#[derive(Clone, Debug)]
pub(super) struct Line {
    boundary: Boundary,
    /// What the first row is divided by: 1/4, or (2 − √3)/(1 − zⁿ).
    first: Constant,
    /// s\[k]; the last one stands for all that follow.
    factors: Vec<Constant>,
    /// What the last row is divided by: 1/(4 − 2s\[n − 2]), or 1/(1 − zⁿ).
    last: Constant,
}

impl Line {
    pub(super) fn new(n: usize, boundary: Boundary) -> Line {
        let float = |x: u32| Float::with_val(CONSTANT_BITS, x);
        match boundary {
            Boundary::Mirror => {
                let mut factors = vec![float(1) / 2_u32];
                while factors.len() < (n - 1).min(ROWS_TO_LIMIT) {
                    let next = 1_u32 / (4_u32 - factors[factors.len() - 1].clone());
                    factors.push(next);
                }
                let last = 1_u32 / (4_u32 - factors[factors.len() - 1].clone() * 2_u32);
                Line {
                    boundary,
                    first: Constant::new(&(float(1) / 4_u32)),
                    factors: factors.iter().map(Constant::new).collect(),
                    last: Constant::new(&last),
                }
            }
            Boundary::Periodic => {
                let s = 2_u32 - float(3).sqrt();
                // Beyond 2²⁰ the power is 0 to the last bit anyway.
                let exponent = u32::try_from(n.min(1 << 20)).expect("at most 2²⁰");
                let power = rug::ops::Pow::pow(s.clone(), exponent);
                let closing: Float =
                    if n.is_multiple_of(2) { 1_u32 / (1_u32 - power) } else { 1_u32 / (power + 1_u32) };
                let first = Constant::new(&(s.clone() * &closing));
                Line { boundary, first, factors: vec![Constant::new(&s)], last: Constant::new(&closing) }
            }
        }
    }

    fn factor(&self, k: usize) -> Constant {
        self.factors[k.min(self.factors.len() - 1)]
    }
}

/// n rows of `width` numbers each: a line is a column.
#[derive(Debug)]
pub(super) struct Block {
    n: usize,
    pub(super) hi: Vec<f64>,
    pub(super) lo: Vec<f64>,
    pub(super) err: Vec<f64>,
}

impl Block {
    pub(super) fn new(n: usize, width: usize) -> Block {
        let zeros = || vec![0.0; n * width];
        Block { n, hi: zeros(), lo: zeros(), err: zeros() }
    }
}

/// g ↦ gain·2^s·g for the samples in `hi`, with 2^s as a product of two numbers. SP-80.
pub(super) struct Scale<'a> {
    pub(super) block: &'a mut Block,
    pub(super) powers: [f64; 2],
    pub(super) gain: f64,
    /// What the scaling's own underflow may add.
    pub(super) err: f64,
}

impl WithSimd for Scale<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let mut rows = Rows::<S>::new(simd, self.block);
        let [p, q, gain, err] = [self.powers[0], self.powers[1], self.gain, self.err].map(|x| simd.splat_f64s(x));
        for i in 0..rows.hi.len() {
            let scaled = simd.mul_f64s(simd.mul_f64s(rows.hi[i], p), q);
            let (hi, lo) = two_product(simd, gain, scaled);
            rows.set(i, Doubled { hi, lo, err });
        }
    }
}

/// Solves c\[k−1] + 4c\[k] + c\[k+1] = b\[k] for each column b. SP-79.
pub(super) struct Solve<'a> {
    pub(super) block: &'a mut Block,
    pub(super) line: &'a Line,
}

impl WithSimd for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let n = self.block.n;
        let mut rows = Rows::<S>::new(simd, self.block);
        let w = rows.hi.len() / n;
        let line = self.line;
        let [first, last] = [line.first, line.last].map(|m| Factor::new(simd, m));
        match line.boundary {
            // y[0] = b[0]/4, y[k] = s[k](b[k] − y[k−1]), c[n−1] = (b[n−1] − 2y[n−2])/(4 − 2s[n−2]), c[k] = y[k] − s[k]c[k+1]
            Boundary::Mirror => {
                for i in 0..w {
                    rows.set(i, times(simd, rows.get(i), first));
                }
                rows.eliminate(w, 1..n - 1, line);
                let two = simd.splat_f64s(2.0);
                for i in (n - 1) * w..n * w {
                    let above = rows.get(i - w).scaled(simd, two);
                    rows.set(i, times(simd, minus(simd, rows.get(i), above), last));
                }
            }
            // y[0] = s/(1 − zⁿ)·Σ zⁱ b[−i], y[k] = s(b[k] − y[k−1]), c[n−1] = 1/(1 − zⁿ)·Σ zⁱ y[n−1+i], c[k] = y[k] − s·c[k+1], s = −z
            Boundary::Periodic => {
                let s = Factor::new(simd, line.factor(0));
                for i in 0..w {
                    let mut sum = rows.get(w + i);
                    for k in (2..n).chain([0]) {
                        sum = minus(simd, rows.get(k * w + i), times(simd, sum, s));
                    }
                    rows.set(i, times(simd, sum, first));
                }
                rows.eliminate(w, 1..n, line);
                for i in 0..w {
                    let mut sum = rows.get((n - 2) * w + i);
                    for k in (0..n - 2).rev().chain([n - 1]) {
                        sum = minus(simd, rows.get(k * w + i), times(simd, sum, s));
                    }
                    rows.set((n - 1) * w + i, times(simd, sum, last));
                }
            }
        }
        for k in (0..n - 1).rev() {
            let s = Factor::new(simd, line.factor(k));
            for i in k * w..(k + 1) * w {
                rows.set(i, minus(simd, rows.get(i), times(simd, rows.get(i + w), s)));
            }
        }
    }
}

/// The rows of a block, as vectors.
struct Rows<'a, S: Simd> {
    simd: S,
    hi: &'a mut [S::f64s],
    lo: &'a mut [S::f64s],
    err: &'a mut [S::f64s],
}

impl<'a, S: Simd> Rows<'a, S> {
    #[inline(always)]
    fn new(simd: S, block: &'a mut Block) -> Rows<'a, S> {
        let vectors = |x: &'a mut [f64]| {
            let (vectors, rest) = S::as_mut_simd_f64s(x);
            assert!(rest.is_empty(), "a row is a whole number of vectors");
            vectors
        };
        Rows { simd, hi: vectors(&mut block.hi), lo: vectors(&mut block.lo), err: vectors(&mut block.err) }
    }

    #[inline(always)]
    fn get(&self, i: usize) -> Doubled<S> {
        Doubled { hi: self.hi[i], lo: self.lo[i], err: self.err[i] }
    }

    #[inline(always)]
    fn set(&mut self, i: usize, x: Doubled<S>) {
        (self.hi[i], self.lo[i], self.err[i]) = (x.hi, x.lo, x.err);
    }

    /// y[k] = s[k](b[k] − y[k−1]).
    #[inline(always)]
    fn eliminate(&mut self, w: usize, rows: std::ops::Range<usize>, line: &Line) {
        for k in rows {
            let s = Factor::new(self.simd, line.factor(k));
            for i in k * w..(k + 1) * w {
                self.set(i, times(self.simd, minus(self.simd, self.get(i), self.get(i - w)), s));
            }
        }
    }
}

/// A [`Constant`] in every lane.
struct Factor<S: Simd> {
    hi: S::f64s,
    lo: S::f64s,
    bound: S::f64s,
}

impl<S: Simd> Clone for Factor<S> {
    #[inline(always)]
    fn clone(&self) -> Factor<S> {
        *self
    }
}

impl<S: Simd> Copy for Factor<S> {}

impl<S: Simd> Factor<S> {
    #[inline(always)]
    fn new(simd: S, m: Constant) -> Factor<S> {
        Factor { hi: simd.splat_f64s(m.hi), lo: simd.splat_f64s(m.lo), bound: simd.splat_f64s(m.bound) }
    }
}

/// hi + lo ± err in every lane; |lo| ≤ u|hi|.
struct Doubled<S: Simd> {
    hi: S::f64s,
    lo: S::f64s,
    err: S::f64s,
}

impl<S: Simd> Doubled<S> {
    /// By a power of two.
    #[inline(always)]
    fn scaled(self, simd: S, power: S::f64s) -> Doubled<S> {
        let by = |x| simd.mul_f64s(x, power);
        Doubled { hi: by(self.hi), lo: by(self.lo), err: by(self.err) }
    }
}

/// x·m. SP-80.
#[inline(always)]
fn times<S: Simd>(simd: S, x: Doubled<S>, m: Factor<S>) -> Doubled<S> {
    let (p, e) = two_product(simd, m.hi, x.hi);
    let e = simd.mul_add_e_f64s(m.hi, x.lo, e);
    let e = simd.mul_add_e_f64s(m.lo, x.hi, e);
    let (hi, lo) = two_sum(simd, p, e);
    let own = simd.mul_add_e_f64s(simd.splat_f64s(PRODUCT), simd.abs_f64s(p), simd.splat_f64s(UNDERFLOW));
    Doubled { hi, lo, err: simd.mul_add_e_f64s(m.bound, x.err, own) }
}

/// x − y. SP-80.
#[inline(always)]
fn minus<S: Simd>(simd: S, x: Doubled<S>, y: Doubled<S>) -> Doubled<S> {
    let (s, e) = two_sum(simd, x.hi, simd.neg_f64s(y.hi));
    let e = simd.add_f64s(e, simd.sub_f64s(x.lo, y.lo));
    let (hi, lo) = two_sum(simd, s, e);
    let size = simd.add_f64s(simd.abs_f64s(x.hi), simd.abs_f64s(y.hi));
    let own = simd.mul_f64s(simd.splat_f64s(DIFFERENCE), size);
    Doubled { hi, lo, err: simd.mul_add_e_f64s(simd.splat_f64s(INFLATION), simd.add_f64s(x.err, y.err), own) }
}

/// (s, e) with s = fl(a + b) and s + e = a + b exactly (Knuth).
#[inline(always)]
fn two_sum<S: Simd>(simd: S, a: S::f64s, b: S::f64s) -> (S::f64s, S::f64s) {
    let s = simd.add_f64s(a, b);
    let b_part = simd.sub_f64s(s, a);
    let a_part = simd.sub_f64s(s, b_part);
    (s, simd.add_f64s(simd.sub_f64s(a, a_part), simd.sub_f64s(b, b_part)))
}

/// (p, e) with p = fl(ab) and p + e = ab, exactly but for underflow: with a fused product where there is one, else Dekker's.
#[inline(always)]
fn two_product<S: Simd>(simd: S, a: S::f64s, b: S::f64s) -> (S::f64s, S::f64s) {
    let p = simd.mul_f64s(a, b);
    if S::F64_LANES > 1 && cfg!(any(target_arch = "x86_64", target_arch = "aarch64")) {
        return (p, simd.mul_add_f64s(a, b, simd.neg_f64s(p)));
    }
    let split = |x: S::f64s| {
        let t = simd.mul_f64s(x, simd.splat_f64s(134_217_729.0));
        let top = simd.sub_f64s(t, simd.sub_f64s(t, x));
        (top, simd.sub_f64s(x, top))
    };
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    let product = |x, y| simd.mul_f64s(x, y);
    let e = simd.sub_f64s(product(a1, b1), p);
    let e = simd.add_f64s(simd.add_f64s(e, product(a1, b2)), product(a2, b1));
    (p, simd.add_f64s(e, product(a2, b2)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;
    use pulp::Scalar;

    fn exactly(x: f64) -> Rational {
        Rational::from_f64(x).expect("finite")
    }

    fn value(x: &Doubled<Scalar>) -> Rational {
        exactly(x.hi) + exactly(x.lo)
    }

    /// |x − exact| ≤ err, and |lo| ≤ u|hi|. Whether err could be as small as 0 there.
    fn assert_bounded(x: &Doubled<Scalar>, exact: &Rational) -> bool {
        let error = (value(x) - exact).abs();
        assert!(error <= exactly(x.err));
        assert!(x.lo.abs() <= x.hi.abs() * 2_f64.powi(-53));
        error == 0
    }

    /// Each operation by itself, so that no bound hides behind the slack of another.
    #[test]
    fn every_operation_keeps_its_bound() {
        let mut seed = 1_u64;
        let mut fraction = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed as i64 >> 11) as f64 * 2_f64.powi(-52)
        };
        let simd = Scalar::new();
        let mut inexact = [0; 2];
        for i in 0..4000 {
            let mut number = |err: f64| {
                let (hi, lo) = two_sum(simd, fraction(), fraction() * 2_f64.powi(-54 - i % 3));
                Doubled::<Scalar> { hi, lo, err }
            };
            // y is shorter, so that its last bits lie below those of x.
            let (x, y) = (number(0.0), number(0.0).scaled(simd, 2_f64.powi(-i % 40)));
            let m = Float::with_val(CONSTANT_BITS, 1_u32) / (4_u32 + i.unsigned_abs());
            let product = times(simd, Doubled { ..x }, Factor::new(simd, Constant::new(&m)));
            inexact[0] += u32::from(!assert_bounded(&product, &(value(&x) / (4 + i))));
            let (exact, err) = (value(&x) - value(&y), 2_f64.powi(-70));
            let difference = minus(simd, Doubled { ..x }, Doubled { ..y });
            inexact[1] += u32::from(!assert_bounded(&difference, &exact));
            // An error of an operand goes on: the whole of it in the difference, m times in the product.
            let moved = Doubled::<Scalar> { err, ..x };
            let by = exactly(err);
            assert_bounded(&minus(simd, Doubled { ..moved }, Doubled { ..y }), &Rational::from(&exact + &by));
            assert_bounded(&minus(simd, Doubled { ..y }, Doubled { ..moved }), &-(exact + &by));
            let product = times(simd, moved, Factor::new(simd, Constant::new(&m)));
            assert_bounded(&product, &((value(&x) + by) / (4 + i)));
        }
        assert!(inexact.iter().all(|n| *n > 1000), "there are roundings to bound: {inexact:?}");
    }

    #[test]
    fn underflow_is_within_the_bounds() {
        let simd = Scalar::new();
        let third = Constant::new(&(Float::with_val(CONSTANT_BITS, 1_u32) / 3_u32));
        let mut inexact = 0;
        for i in 0..500_u64 {
            // A few units of 2⁻¹⁰⁷⁴: a third of it is no multiple of that.
            let x = Doubled::<Scalar> { hi: f64::from_bits(1 + 7 * i), lo: 0.0, err: 0.0 };
            let exact = value(&x) / 3_u32;
            inexact += u32::from(!assert_bounded(&times(simd, x, Factor::new(simd, third)), &exact));
            // Scaling down to there, in two steps.
            let mut block = Block::new(1, 1);
            let g = f64::from_bits((1_u64 << 52) * 40 + 0x000F_1234_5678_9ABC + i);
            block.hi[0] = g;
            let powers = [2_f64.powi(-31), 2_f64.powi(-31)];
            Scale { block: &mut block, powers, gain: 216.0, err: super::super::SCALING }.with_simd(simd);
            let scaled = Doubled::<Scalar> { hi: block.hi[0], lo: block.lo[0], err: block.err[0] };
            inexact += u32::from(!assert_bounded(&scaled, &((exactly(g) * 216_u32) >> 62_u32)));
        }
        assert!(inexact > 700, "{inexact}");
    }
}

//! Single coefficients of a volume, exactly: integers over a known denominator.

use super::Sample;
use crate::number::{Integer, Rational};
use crate::spline::signal::Boundary;

/// How many numbers of an intermediate plane are held at once.
const HELD: usize = 1 << 19;

/// A volume of integers times 2^q, whose coefficients are integers over D times 2^q. SP-81.
#[doc(alias = "SP-81")]
pub(super) struct Exact<'a, T> {
    samples: &'a [T],
    lines: Vec<ExactLine>,
    /// D > 0.
    pub(super) denominator: Integer,
    /// q.
    pub(super) exponent: i32,
}

impl<'a, T: Sample> Exact<'a, T> {
    pub(super) fn new(samples: &'a [T], shape: &[usize], boundary: Boundary) -> Exact<'a, T> {
        let exponents = samples.iter().map(|g| dyadic(g.value())).filter(|(m, _)| *m != 0).map(|(_, q)| q);
        let lines: Vec<ExactLine> = shape.iter().map(|&n| ExactLine::new(n, boundary)).collect();
        let denominator = lines.iter().fold(Integer::from(1), |product, line| product * &line.denominator);
        Exact { samples, denominator, exponent: exponents.min().unwrap_or(0), lines }
    }

    /// The numerators of the coefficients at these places, which ascend, one after the other.
    pub(super) fn each(&self, wanted: &[usize], found: &mut dyn FnMut(usize, &Integer)) {
        let sample = |i: usize| {
            let (m, q) = dyadic(self.samples[i].value());
            if m == 0 { Integer::new() } else { Integer::from(m) << (q - self.exponent).unsigned_abs() }
        };
        solve(&sample, &self.lines, wanted, &mut |i, p| found(i, p));
    }

    /// The coefficients at these places, which ascend.
    pub(super) fn rationals(&self, wanted: &[usize]) -> Vec<Rational> {
        let mut all = Vec::with_capacity(wanted.len());
        let q = self.exponent.unsigned_abs();
        self.each(wanted, &mut |_, p| {
            let x = Rational::from((p.clone(), self.denominator.clone()));
            all.push(if self.exponent < 0 { x >> q } else { x << q });
        });
        all
    }
}

/// The last axis first, and of it the wanted planes alone; a found number with its place in the volume of these axes.
fn solve(g: &dyn Fn(usize) -> Integer, lines: &[ExactLine], wanted: &[usize], found: &mut dyn FnMut(usize, &Integer)) {
    let (line, rest) = lines.split_last().expect("there is an axis");
    let stride: usize = rest.iter().map(|line| line.n).product();
    let planes: Vec<&[usize]> = wanted.chunk_by(|i, j| i / stride == j / stride).collect();
    for chunk in planes.chunks((HELD / stride).max(1)) {
        let numbers: Vec<usize> = chunk.iter().map(|plane| plane[0] / stride).collect();
        let mut held = vec![Integer::new(); chunk.len() * stride];
        for i in 0..stride {
            let column: Vec<Integer> = (0..line.n).map(|k| g(i + k * stride)).collect();
            line.solve(&column, &numbers, |place, c| held[place * stride + i] = c);
        }
        for ((plane, k), wanted) in held.chunks(stride).zip(numbers).zip(chunk) {
            if rest.is_empty() {
                found(k, &plane[0]);
            } else {
                let here: Vec<usize> = wanted.iter().map(|i| i % stride).collect();
                solve(&|i| plane[i].clone(), rest, &here, &mut |i, p| found(k * stride + i, p));
            }
        }
    }
}

/// A line of n samples: D and the first row of D·6·[1 4 1]⁻¹. SP-81.
struct ExactLine {
    n: usize,
    boundary: Boundary,
    denominator: Integer,
    /// The first two of a sequence with v\[j+1] = −4v\[j] − v\[j−1].
    row: [Integer; 2],
}

impl ExactLine {
    fn new(n: usize, boundary: Boundary) -> ExactLine {
        match boundary {
            // v[j] = (−1)^j T[n−1−j](2), D = U[n−2](2)
            Boundary::Mirror => {
                let (mut t, mut u) = ([Integer::from(1), Integer::from(2)], [Integer::new(), Integer::from(1)]);
                for _ in 0..n - 2 {
                    t = stepped(t, 4);
                    u = stepped(u, 4);
                }
                let ([before, t], [_, u]) = (t, u);
                ExactLine { n, boundary, denominator: u, row: [t, -before] }
            }
            // a[0] = 0, a[1] = 1, a[j+1] = −4a[j] − a[j−1]; v[j] = 3(a[j] + a[n−j]), D = 2a[n] + a[n−1] + 1, of either sign
            Boundary::Periodic => {
                let mut a = [Integer::new(), Integer::from(1)];
                for _ in 0..n - 1 {
                    a = stepped(a, -4);
                }
                let [before, a] = a;
                let denominator = Integer::from(&a * 2_u32) + &before + 1_u32;
                let sign = if denominator < 0 { -3 } else { 3 };
                ExactLine { n, boundary, denominator: denominator.abs(), row: [a * sign, (before + 1_u32) * sign] }
            }
        }
    }

    /// D·c\[k] for the k in `wanted`, which ascend, with their places there.
    ///
    /// D·c\[0] is a row of the inverse, and c\[k+1] = 6g\[k] − 4c\[k] − c\[k−1] gives all others, without a division.
    fn solve(&self, g: &[Integer], wanted: &[usize], mut found: impl FnMut(usize, Integer)) {
        if g.iter().all(Integer::is_zero) {
            return;
        }
        let six_d = Integer::from(&self.denominator * 6_u32);
        let (mut first, mut second) = (Integer::new(), Integer::new());
        let mut row = self.row.clone();
        for j in 0..self.n {
            match self.boundary {
                Boundary::Mirror if j == 0 || j == self.n - 1 => first += &row[0] * &g[j],
                Boundary::Mirror => first += Integer::from(&row[0] * &g[j]) << 1_u32,
                Boundary::Periodic => {
                    first += &row[0] * &g[j];
                    // The row of c[1] is that of c[0], one further on.
                    second += &row[0] * &g[(j + 1) % self.n];
                }
            }
            row = stepped(row, -4);
        }
        if self.boundary == Boundary::Mirror {
            second = (Integer::from(&six_d * &g[0]) >> 1_u32) - Integer::from(&first << 1_u32);
        }
        let mut c = [first, second];
        let mut places = wanted.iter().enumerate().peekable();
        for k in 0..self.n {
            if let Some((place, _)) = places.next_if(|(_, w)| **w == k) {
                found(place, c[0].clone());
            }
            let [before, at] = c;
            let mut next = Integer::from(&six_d * &g[(k + 1) % self.n]) - before;
            next -= Integer::from(&at << 2_u32);
            c = [at, next];
        }
    }
}

/// (x, y) ↦ (y, f·y − x).
fn stepped([x, y]: [Integer; 2], f: i32) -> [Integer; 2] {
    let next = Integer::from(&y * f) - x;
    [y, next]
}

/// x = m·2^q, m odd or 0.
fn dyadic(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (field, fraction) = ((bits >> 52 & 0x7FF) as i32, (bits & ((1 << 52) - 1)) as i64);
    let (m, q) = if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
    if m == 0 {
        return (0, 0);
    }
    let zeros = m.trailing_zeros();
    let m = m >> zeros;
    (if x < 0.0 { -m } else { m }, q + zeros as i32)
}

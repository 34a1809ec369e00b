//! Interpolation: the coefficients c with (c\[k−1] + 4c\[k] + c\[k+1])/6 = g\[k] at every sample.

pub mod fast;

use super::signal::{Boundary, Signal};
use super::tensor::Spline;
use crate::number::{Integer, Rational};

/// The only spline of the signal's shape and boundary rule that takes the signal's values. SP-2.
///
/// One axis after the other, in any order (SP-51), for the tensor product is solved so. `prefilter_fast_exact` is its fast twin.
#[doc(alias = "SP-2")]
#[doc(alias = "SP-51")]
pub fn interpolate<const N: usize>(signal: &Signal<N>) -> Spline<N> {
    let mut values = signal.values().to_vec();
    let mut stride = 1;
    for n in signal.shape() {
        for first in (0..values.len()).filter(|i| (i / stride) % n == 0) {
            let line: Vec<Rational> = (0..n).map(|k| values[first + k * stride].clone()).collect();
            for (k, c) in solve(&line, signal.boundary()).into_iter().enumerate() {
                values[first + k * stride] = c;
            }
        }
        stride *= n;
    }
    Spline::new(signal.with_values(values))
}

/// The coefficients of a line of n ≥ 2 samples. SP-2.
///
/// The recursion c\[k+1] = 6g\[k] − 4c\[k] − c\[k−1] is run from unknown starting values: every c\[k] = a + b·p + d·q is affine in
/// p = c\[0] and q = c\[1], and what the boundary rule says of the last two fixes p and q. Rounded, this recursion is useless, for it
/// multiplies errors by 2 + √3 a step; exactly, it is the shortest.
///
/// # Panics
/// Iff n < 2: a [`Signal`] has at least two samples along each axis.
pub fn solve(g: &[Rational], boundary: Boundary) -> Vec<Rational> {
    let n = g.len();
    assert!(n >= 2, "a line has at least 2 samples");
    let mut c = vec![Affine::integers(0, 1, 0), Affine::integers(0, 0, 1)];
    for k in 1..=n {
        let six_g = Affine::constant(Rational::from(&g[k % n] * 6_u32));
        c.push(six_g.minus(&c[k].times(4)).minus(&c[k - 1]));
    }
    let conditions = match boundary {
        // 4c[0] + 2c[1] = 6g[0], for c[−1] = c[1]; c[n] = c[n − 2]
        Boundary::Mirror => {
            let six_g = Affine::constant(Rational::from(&g[0] * 6_u32));
            [Affine::integers(0, 4, 2).minus(&six_g), c[n].clone().minus(&c[n - 2])]
        }
        // c[n] = c[0] and c[n + 1] = c[1]
        Boundary::Periodic => [c[n].clone().minus(&c[0]), c[n + 1].clone().minus(&c[1])],
    };
    let [p, q] = Affine::common_zero(&conditions);
    c[..n].iter().map(|c| c.at(&p, &q)).collect()
}

/// a + b·p + d·q.
#[derive(Clone, Debug)]
struct Affine {
    a: Rational,
    b: Integer,
    d: Integer,
}

impl Affine {
    fn integers(a: i32, b: i32, d: i32) -> Affine {
        Affine { a: Rational::from(a), b: Integer::from(b), d: Integer::from(d) }
    }

    fn constant(a: Rational) -> Affine {
        Affine { a, ..Affine::integers(0, 0, 0) }
    }

    fn times(&self, n: i32) -> Affine {
        Affine { a: Rational::from(&self.a * n), b: Integer::from(&self.b * n), d: Integer::from(&self.d * n) }
    }

    fn minus(self, other: &Affine) -> Affine {
        Affine { a: self.a - &other.a, b: self.b - &other.b, d: self.d - &other.d }
    }

    fn at(&self, p: &Rational, q: &Rational) -> Rational {
        Rational::from(p * &self.b) + Rational::from(q * &self.d) + &self.a
    }

    /// The p, q where both are 0, by Cramer's rule.
    fn common_zero([f, g]: &[Affine; 2]) -> [Rational; 2] {
        let determinant = Integer::from(&f.b * &g.d) - Integer::from(&f.d * &g.b);
        let minor = |s: &Integer, t: &Integer| Rational::from(&g.a * s) - Rational::from(&f.a * t);
        // The matrix [1 4 1]/6 of either boundary rule is strictly diagonally dominant, so it is regular.
        [minor(&f.d, &g.d) / &determinant, -(minor(&f.b, &g.b) / &determinant)]
    }
}

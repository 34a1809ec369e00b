//! Jets: a function's value, gradient and Hessian at a point, by forward differentiation over any ring.

use crate::linear::{Matrix, Vector};
use crate::number::{Multivariate, OrderedField, Rational, Ring};
use std::ops::{Add, Mul, Neg, Sub};

/// The 2-jet of a function of N variables at a point: f, ∇f and the Hessian (∂ᵢ∂ⱼf).
///
/// Jets are a ring: the sum is that of the entries, and ∇(fg) = f∇g + g∇f, ∂ᵢ∂ⱼ(fg) = f·∂ᵢ∂ⱼg + ∂ᵢf·∂ⱼg + ∂ⱼf·∂ᵢg + g·∂ᵢ∂ⱼf.
/// So a formula over [`Ring`], evaluated at jets, differentiates itself: exactly over an exact ring, enclosed over
/// intervals. CU-1.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-1")]
pub struct Jet<K, const N: usize> {
    /// f.
    pub value: K,
    /// (∂₁f, …).
    pub gradient: Vector<K, N>,
    /// (∂ᵢ∂ⱼf), symmetric.
    pub hessian: Matrix<K, N, N>,
}

impl<K: Ring, const N: usize> Jet<K, N> {
    /// A constant function.
    pub fn constant(value: K) -> Jet<K, N> {
        Jet { value, gradient: Vector::zero(), hessian: Matrix::from_fn(|_, _| K::integer(0)) }
    }

    /// The coordinate function of an axis, where its value is `at`.
    pub fn variable(axis: usize, at: K) -> Jet<K, N> {
        let gradient = Vector(std::array::from_fn(|i| K::integer(i64::from(i == axis))));
        Jet { gradient, ..Jet::constant(at) }
    }

    /// The coordinate functions at a point.
    pub fn variables(at: &[K; N]) -> [Jet<K, N>; N] {
        std::array::from_fn(|axis| Jet::variable(axis, at[axis].clone()))
    }

    /// φ∘f by the chain rule, from φ, φ′ and φ″ at f's value:
    /// ∇(φ∘f) = φ′∇f, ∂ᵢ∂ⱼ(φ∘f) = φ″·∂ᵢf·∂ⱼf + φ′·∂ᵢ∂ⱼf. CU-1.
    pub fn composed(&self, [value, first, second]: &[K; 3]) -> Jet<K, N> {
        let product = |i: usize, j: usize| self.gradient[i].clone() * &self.gradient[j];
        let hessian = |i: usize, j: usize| product(i, j) * second + &(self.hessian.0[i][j].clone() * first);
        Jet { value: value.clone(), gradient: self.gradient.scaled(first), hessian: Matrix::from_fn(hessian) }
    }
}

impl<K: OrderedField, const N: usize> Jet<K, N> {
    /// 1/f, by φ(y) = 1/y; `None` iff f is 0 at the point. CU-1.
    pub fn reciprocal(&self) -> Option<Jet<K, N>> {
        let first = self.value.inverse()?;
        let square = first.clone() * &first;
        let cube = square.clone() * &first;
        Some(self.composed(&[first, -square, cube * &K::integer(2)]))
    }
}

impl<const N: usize> Jet<Rational, N> {
    /// The jet of a polynomial.
    pub fn of_polynomial(f: &Multivariate<N>, at: &[Rational; N]) -> Jet<Rational, N> {
        f.evaluate_in(&Jet::variables(at), |coefficient| Jet::constant(coefficient.clone()))
    }
}

impl<K: Ring, const N: usize> Jet<K, N> {
    /// Leibniz' rule, once and twice.
    fn product(&self, other: &Jet<K, N>) -> Jet<K, N> {
        let (Jet { value: f, gradient: df, hessian: ddf }, Jet { value: g, gradient: dg, hessian: ddg }) =
            (self, other);
        let times = |a: &K, b: &K| a.clone() * b;
        let second = |i: usize, j: usize| {
            let mixed = times(&df[i], &dg[j]) + &times(&df[j], &dg[i]);
            times(f, &ddg.0[i][j]) + &mixed + &times(g, &ddf.0[i][j])
        };
        Jet { value: times(f, g), gradient: dg.scaled(f) + &df.scaled(g), hessian: Matrix::from_fn(second) }
    }

    /// The jet with these entries, each from the same entry of two.
    fn entrywise(&self, other: &Jet<K, N>, combine: impl Fn(K, &K) -> K) -> Jet<K, N> {
        let entry = |a: &K, b: &K| combine(a.clone(), b);
        Jet {
            value: entry(&self.value, &other.value),
            gradient: Vector(std::array::from_fn(|i| entry(&self.gradient[i], &other.gradient[i]))),
            hessian: Matrix::from_fn(|i, j| entry(&self.hessian.0[i][j], &other.hessian.0[i][j])),
        }
    }
}

impl<K: Ring, const N: usize> Add<&Jet<K, N>> for Jet<K, N> {
    type Output = Jet<K, N>;
    fn add(self, other: &Jet<K, N>) -> Jet<K, N> {
        self.entrywise(other, |a, b| a + b)
    }
}

impl<K: Ring, const N: usize> Sub<&Jet<K, N>> for Jet<K, N> {
    type Output = Jet<K, N>;
    fn sub(self, other: &Jet<K, N>) -> Jet<K, N> {
        self.entrywise(other, |a, b| a - b)
    }
}

impl<K: Ring, const N: usize> Mul<&Jet<K, N>> for Jet<K, N> {
    type Output = Jet<K, N>;
    fn mul(self, other: &Jet<K, N>) -> Jet<K, N> {
        self.product(other)
    }
}

impl<K: Ring, const N: usize> Neg for Jet<K, N> {
    type Output = Jet<K, N>;
    fn neg(self) -> Jet<K, N> {
        let Jet { value, gradient, hessian } = self;
        Jet { value: -value, gradient: -gradient, hessian: Matrix(hessian.0.map(|row| row.map(K::neg))) }
    }
}

impl<K: Ring, const N: usize> Ring for Jet<K, N> {
    fn integer(n: i64) -> Jet<K, N> {
        Jet::constant(K::integer(n))
    }
}

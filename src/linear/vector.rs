//! Points and vectors of a fixed dimension.

use crate::number::Ring;
use std::ops::{Add, Index, Neg, Sub};

/// A vector of Kᴺ, or a point by its coordinates.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Vector<K, const N: usize>(pub [K; N]);

impl<K: Ring, const N: usize> Vector<K, N> {
    /// 0.
    pub fn zero() -> Vector<K, N> {
        Vector(std::array::from_fn(|_| K::integer(0)))
    }

    /// The image under a map of the coordinates, such as the passage to another number.
    pub fn map<L>(&self, f: impl FnMut(&K) -> L) -> Vector<L, N> {
        Vector(self.0.each_ref().map(f))
    }

    /// k·v.
    pub fn scaled(&self, k: &K) -> Vector<K, N> {
        self.map(|x| x.clone() * k)
    }

    /// ⟨a, b⟩ = Σ aᵢbᵢ.
    pub fn dot(&self, other: &Vector<K, N>) -> K {
        self.0.iter().zip(&other.0).fold(K::integer(0), |sum, (a, b)| sum + &(a.clone() * b))
    }

    /// |v|² = ⟨v, v⟩.
    pub fn norm_squared(&self) -> K {
        self.dot(self)
    }
}

impl<K: Ring> Vector<K, 3> {
    /// a × b, right-handed: e₁ × e₂ = e₃. NU-19.
    #[doc(alias = "NU-19")]
    pub fn cross(&self, other: &Vector<K, 3>) -> Vector<K, 3> {
        let (Vector([a1, a2, a3]), Vector([b1, b2, b3])) = (self, other);
        let minor = |a: &K, b: &K, c: &K, d: &K| a.clone() * d - &(b.clone() * c);
        Vector([minor(a2, a3, b2, b3), minor(a3, a1, b3, b1), minor(a1, a2, b1, b2)])
    }
}

impl<K, const N: usize> Index<usize> for Vector<K, N> {
    type Output = K;
    fn index(&self, i: usize) -> &K {
        &self.0[i]
    }
}

impl<K: Ring, const N: usize> Add<&Vector<K, N>> for Vector<K, N> {
    type Output = Vector<K, N>;
    fn add(self, other: &Vector<K, N>) -> Vector<K, N> {
        Vector(std::array::from_fn(|i| self.0[i].clone() + &other.0[i]))
    }
}

impl<K: Ring, const N: usize> Sub<&Vector<K, N>> for Vector<K, N> {
    type Output = Vector<K, N>;
    fn sub(self, other: &Vector<K, N>) -> Vector<K, N> {
        Vector(std::array::from_fn(|i| self.0[i].clone() - &other.0[i]))
    }
}

impl<K: Ring, const N: usize> Neg for Vector<K, N> {
    type Output = Vector<K, N>;
    fn neg(self) -> Vector<K, N> {
        Vector(self.0.map(K::neg))
    }
}

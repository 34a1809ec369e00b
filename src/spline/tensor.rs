//! Tensor-product cubic splines: values, derivatives, jets.

use super::basis::{split, weights};
use super::signal::Signal;
use crate::curvature::jet::Jet;
use crate::linear::{Matrix, Vector};
use crate::number::{Integer, Rational};

/// f(x) = Σ c\[k] B₃(x₁ − k₁) … B₃(x_N − k_N), k in ℤᴺ, where the boundary rule extends the coefficients. SP-3.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "SP-3")]
pub struct Spline<const N: usize> {
    coefficients: Signal<N>,
}

impl<const N: usize> Spline<N> {
    /// The spline with these coefficients.
    pub fn new(coefficients: Signal<N>) -> Spline<N> {
        Spline { coefficients }
    }

    /// c, with its shape and boundary rule.
    pub fn coefficients(&self) -> &Signal<N> {
        &self.coefficients
    }

    /// ∂ⁿf at any real point, n\[axis] times along each axis: Σ c\[k] Π B₃⁽ⁿ⁾(x − k) over 4ᴺ terms. SP-3, SP-40.
    ///
    /// In one variable, at an integer: f′(k) = (c\[k+1] − c\[k−1])/2, f″(k) = c\[k−1] − 2c\[k] + c\[k+1] (SP-46).
    #[doc(alias = "SP-40")]
    #[doc(alias = "SP-46")]
    ///
    /// # Panics
    /// Iff an order is above 2.
    pub fn derivative(&self, at: &[Rational; N], orders: [u32; N]) -> Rational {
        Neighbourhood::new(self, at).derivative(orders)
    }

    /// f at any real point.
    pub fn value(&self, at: &[Rational; N]) -> Rational {
        self.derivative(at, [0; N])
    }

    /// Whether ∇f ≠ 0: there the level set through the point has a tangent plane. SP-48.
    #[doc(alias = "SP-48")]
    pub fn is_regular(&self, at: &[Rational; N]) -> bool {
        self.jet(at).gradient != Vector::zero()
    }

    /// f, ∇f and the Hessian at any real point; they are continuous (SP-49), and the Hessian is symmetric (SP-62).
    #[doc(alias = "SP-49")]
    #[doc(alias = "SP-62")]
    #[doc(alias = "SP-63")]
    pub fn jet(&self, at: &[Rational; N]) -> Jet<Rational, N> {
        let near = Neighbourhood::new(self, at);
        let orders = |axes: &[usize]| std::array::from_fn(|a| axes.iter().filter(|&&axis| axis == a).count() as u32);
        let hessian: Matrix<Rational, N, N> =
            Matrix::from_fn(|i, j| if i <= j { near.derivative(orders(&[i, j])) } else { Rational::new() });
        Jet {
            value: near.derivative([0; N]),
            gradient: Vector(std::array::from_fn(|i| near.derivative(orders(&[i])))),
            hessian: Matrix::from_fn(|i, j| hessian.0[i.min(j)][i.max(j)].clone()),
        }
    }
}

/// What a point sees of a spline: the 4ᴺ coefficients around it, the first axis fastest, and where it lies among them.
struct Neighbourhood<const N: usize> {
    coefficients: Vec<Rational>,
    fractions: [Rational; N],
}

impl<const N: usize> Neighbourhood<N> {
    fn new(spline: &Spline<N>, at: &[Rational; N]) -> Neighbourhood<N> {
        let places = at.each_ref().map(split);
        let coefficients = (0..1 << (2 * N)).map(|m: usize| {
            let k: [Integer; N] =
                std::array::from_fn(|axis| Integer::from(&places[axis].0 + ((m >> (2 * axis)) & 3)) - 1);
            spline.coefficients.sample(&k).clone()
        });
        Neighbourhood { coefficients: coefficients.collect(), fractions: places.map(|(_, t)| t) }
    }

    fn derivative(&self, orders: [u32; N]) -> Rational {
        // The last axis is the slowest: it is summed up first.
        let mut values = self.coefficients.clone();
        for axis in (0..N).rev() {
            let weights = weights(&self.fractions[axis], orders[axis]);
            let quarter = values.len() / 4;
            let sum = |i: usize| {
                (0..4).fold(Rational::new(), |sum, m| sum + Rational::from(&weights[m] * &values[i + m * quarter]))
            };
            values = (0..quarter).map(sum).collect();
        }
        values.swap_remove(0)
    }
}

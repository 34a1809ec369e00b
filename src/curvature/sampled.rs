//! Derivatives estimated from samples on the integer grid, and what rotation does to them.

use super::jet::Jet;
use super::motion::Affine;
use crate::linear::{Matrix, Vector};
use crate::number::{Rational, Trivariate};

/// The jet by central differences of the samples g\[i, j, k] around a grid point: exact for polynomials of degree 2, and
/// for no others in general. CU-212.
///
/// ∂ᵢ ≈ (g[+eᵢ] − g[−eᵢ])/2, ∂ᵢᵢ ≈ g[+eᵢ] − 2g\[0] + g[−eᵢ], ∂ᵢⱼ ≈ (g[+eᵢ+eⱼ] − g[+eᵢ−eⱼ] − g[−eᵢ+eⱼ] + g[−eᵢ−eⱼ])/4.
#[doc(alias = "CU-212")]
pub fn central_jet(samples: impl Fn([i64; 3]) -> Rational, at: [i64; 3]) -> Jet<Rational, 3> {
    let sample = |offset: [i64; 3]| samples(std::array::from_fn(|i| at[i] + offset[i]));
    let step = |i: usize, a: i64| std::array::from_fn(|k| if k == i { a } else { 0 });
    let both = |(i, a): (usize, i64), (j, b): (usize, i64)| {
        let [first, second]: [[i64; 3]; 2] = [step(i, a), step(j, b)];
        sample(std::array::from_fn(|k| first[k] + second[k]))
    };
    let value = sample([0; 3]);
    let first = |i: usize| (sample(step(i, 1)) - sample(step(i, -1))) / 2_u32;
    let second = |i: usize, j: usize| {
        if i == j {
            return sample(step(i, 1)) - Rational::from(&value * 2_u32) + sample(step(i, -1));
        }
        let [a, b] = [1, -1].map(|a| both((i, a), (j, 1)) - both((i, a), (j, -1)));
        (a - b) / 4_u32
    };
    Jet { gradient: Vector(std::array::from_fn(first)), hessian: Matrix::from_fn(second), value }
}

/// The central jet of the samples that f∘T⁻¹ has on the grid: what is measured of the moved object. CU-212.
pub fn moved_central_jet(f: &Trivariate, motion: &Affine, at: [i64; 3]) -> Jet<Rational, 3> {
    let moved = motion.moved(f);
    central_jet(|point| moved.evaluate(&point.map(Rational::from)), at)
}

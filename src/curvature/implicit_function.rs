//! The implicit function theorem with its neighbourhoods: a box in which a level set is the graph of one function.

use super::implicit_curve::SingularPoint;
use super::implicit_graph::GraphError;
use super::jet::Jet;
use crate::number::{Algebraic, Multivariate, OrderedField, Polynomial, Rational, Sign, real_roots};

/// A box V × W around a point p of {f = a}, W along one axis, in which the level set is the graph of a function g: V → W. CU-143, CU-145.
///
/// V is |xᵢ − pᵢ| ≤ δ for the other axes, W is |x − p| < ε along this one. On the box the derivative along the axis has one sign, and
/// f − a has opposite signs at the two ends of W over each point of V.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "CU-143")]
#[doc(alias = "CU-145")]
pub struct GraphBox<const N: usize> {
    /// f − a.
    function: Multivariate<N>,
    point: [Rational; N],
    axis: usize,
    delta: Rational,
    epsilon: Rational,
}

/// The largest that |h| can be where |hᵢ| ≤ radiusᵢ, by the sum of the terms' sizes.
fn bound<const N: usize>(h: &Multivariate<N>, radius: &[Rational; N]) -> Rational {
    h.terms().fold(Rational::new(), |sum, (exponents, c)| {
        let size = Rational::from(c.abs_ref());
        let powers = exponents.iter().zip(radius).flat_map(|(&n, r)| (0..n).map(move |_| r));
        sum + powers.fold(size, |product, r| product * r)
    })
}

/// A box around p for the level set of f through p, as a graph along an axis. CU-143, CU-144.
///
/// # Errors
/// `Singular` iff ∇f(p) = 0, `Vertical` iff only the derivative along the axis is 0.
///
/// # Panics
/// Iff there is no such axis.
#[doc(alias = "CU-144")]
pub fn graph_box<const N: usize>(
    f: &Multivariate<N>,
    point: &[Rational; N],
    axis: usize,
) -> Result<GraphBox<N>, GraphError> {
    let jet = Jet::of_polynomial(f, point);
    let slope = Rational::from(jet.gradient[axis].abs_ref());
    match (slope.sign(), jet.gradient.norm_squared().sign()) {
        (Sign::Zero, Sign::Zero) => return Err(GraphError::Singular),
        (Sign::Zero, Sign::Negative | Sign::Positive) => return Err(GraphError::Vertical),
        (Sign::Negative | Sign::Positive, _) => {}
    }
    let half = Rational::from(&slope / 2_u32);
    let function = f.clone() - &Multivariate::constant(jet.value);
    // In h with x = p + h: the derivative varies by at most half of its value at p, f − a over V by less than that times ε.
    let shifted = |i: usize| Multivariate::variable(i) + &Multivariate::constant(point[i].clone());
    let at_point = function.evaluate_in(&std::array::from_fn(shifted), |c| Multivariate::constant(c.clone()));
    let derivative = at_point.derivative(axis);
    let varying = derivative.terms().filter(|(n, _)| *n != [0; N]).map(|(n, c)| (n, c.clone()));
    let varying = Multivariate::new(varying);
    let across = at_point.terms().filter(|(n, _)| n[axis] == 0).map(|(n, c)| (n, c.clone()));
    let across = Multivariate::new(across);
    let mut epsilon = Rational::from(1);
    while bound(&varying, &std::array::from_fn(|_| epsilon.clone())) > half {
        epsilon /= 2_u32;
    }
    let mut delta = epsilon.clone();
    while bound(&across, &std::array::from_fn(|_| delta.clone())) >= Rational::from(&half * &epsilon) {
        delta /= 2_u32;
    }
    Ok(GraphBox { function, point: point.clone(), axis, delta, epsilon })
}

/// A box around p along the axis of the largest derivative: a level set of a regular value is a graph around each of its points.
/// CU-147, CU-153.
///
/// # Errors
/// iff ∇f(p) = 0.
#[doc(alias = "CU-147")]
#[doc(alias = "CU-153")]
pub fn chart<const N: usize>(f: &Multivariate<N>, point: &[Rational; N]) -> Result<GraphBox<N>, SingularPoint> {
    let gradient = Jet::of_polynomial(f, point).gradient;
    let size = |axis: &usize| Rational::from(gradient[*axis].abs_ref());
    let axis = (0..N).max_by_key(size).ok_or(SingularPoint)?;
    graph_box(f, point, axis).map_err(|_| SingularPoint)
}

impl<const N: usize> GraphBox<N> {
    /// The axis along which the level set is a graph.
    pub fn axis(&self) -> usize {
        self.axis
    }

    /// δ: V is |xᵢ − pᵢ| ≤ δ for all axes but this one.
    pub fn base_radius(&self) -> &Rational {
        &self.delta
    }

    /// ε: W is |x − p| < ε along the axis.
    pub fn height_radius(&self) -> &Rational {
        &self.epsilon
    }

    /// g over a point, whose coordinate along the axis is not looked at; `None` iff it is not over V. CU-145.
    pub fn height(&self, over: &[Rational; N]) -> Option<Algebraic> {
        let off = |i: usize| Rational::from(&over[i] - &self.point[i]).abs();
        if (0..N).any(|i| i != self.axis && off(i) > self.delta) {
            return None;
        }
        let along = |i: usize| match i == self.axis {
            true => Polynomial::new(vec![Rational::new(), Rational::from(1)]),
            false => Polynomial::new(vec![over[i].clone()]),
        };
        let restricted = self.function.evaluate_in(&std::array::from_fn(along), |c| Polynomial::new(vec![c.clone()]));
        let roots = real_roots(&restricted).expect("its derivative is not zero in W");
        let centre = &self.point[self.axis];
        let [lo, hi] = [Rational::from(centre - &self.epsilon), Rational::from(centre + &self.epsilon)];
        let [lo, hi] = [lo, hi].map(Algebraic::from);
        Some(roots.into_iter().find(|root| lo < *root && *root < hi).expect("f − a changes its sign over W"))
    }
}

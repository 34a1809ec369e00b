//! The first fundamental form of rational surfaces: lengths of curves on them, and areas.

use super::quadrature::{Goal, Integral, QuadratureError, integral};
use super::rational_curve::{RationalCurve, ZeroDenominator};
use super::series::Series;
use crate::linear::Vector;
use crate::number::{Multivariate, Polynomial, Rational, Ring};

/// The order of the series for integrals over an interval, and over a rectangle.
const ORDER: usize = 14;
const AREA_ORDER: usize = 8;

/// A surface σ = (p₁, p₂, p₃)/q by polynomials of u and v.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RationalSurface {
    numerators: [Multivariate<2>; 3],
    denominator: Multivariate<2>,
}

/// A polynomial of u and v.
type Function = Multivariate<2>;

impl RationalSurface {
    /// (p₁, p₂, p₃)/q.
    ///
    /// # Errors
    /// iff q is the zero polynomial.
    pub fn new(numerators: [Function; 3], denominator: Function) -> Result<RationalSurface, ZeroDenominator> {
        if denominator.is_zero() { Err(ZeroDenominator) } else { Ok(RationalSurface { numerators, denominator }) }
    }

    /// p₁, p₂, p₃.
    pub fn numerators(&self) -> &[Function; 3] {
        &self.numerators
    }

    /// q.
    pub fn denominator(&self) -> &Function {
        &self.denominator
    }

    /// q²·∂σ/∂u and q²·∂σ/∂v: p_u q − p q_u and so on.
    pub fn tangent_numerators(&self) -> [Vector<Function, 3>; 2] {
        let q = &self.denominator;
        [0, 1].map(|axis| {
            let slope = q.derivative(axis);
            Vector(self.numerators.each_ref().map(|p| p.derivative(axis) * q - &(p.clone() * &slope)))
        })
    }

    /// q⁴E, q⁴F, q⁴G. CU-122.
    #[doc(alias = "CU-122")]
    pub fn first_form_numerators(&self) -> [Function; 3] {
        let [u, v] = self.tangent_numerators();
        [u.dot(&u), u.dot(&v), v.dot(&v)]
    }

    /// q⁸(EG − F²). CU-123.
    #[doc(alias = "CU-123")]
    pub fn w_squared_numerator(&self) -> Function {
        let [e, f, g] = self.first_form_numerators();
        e * &g - &(f.clone() * &f)
    }

    /// q³·(σᵤ × σᵥ) = q·pᵤ × pᵥ − q_v·pᵤ × p − q_u·p × pᵥ: the terms of (pᵤq − pq_u) × (pᵥq − pq_v) have a factor q. CU-123.
    pub fn normal_numerator(&self) -> Vector<Function, 3> {
        let (p, q) = (Vector(self.numerators.clone()), &self.denominator);
        let [pu, pv] = [0, 1].map(|axis| Vector(self.numerators.each_ref().map(|p| p.derivative(axis))));
        let negative = pu.cross(&p).scaled(&q.derivative(1)) + &p.cross(&pv).scaled(&q.derivative(0));
        pu.cross(&pv).scaled(q) + &-negative
    }

    /// The area of σ over a rectangle of the (u, v)-plane, ∫∫ |σᵤ × σᵥ| du dv; parts that are covered twice count twice. CU-124, CU-126.
    ///
    /// Near a pole nothing is known: its outcome is `Limit`, with infinite bounds.
    ///
    /// # Errors
    /// `Reversed` iff a lower bound is above its upper one; `Width` iff the width is ≤ 0.
    #[doc(alias = "CU-124")]
    #[doc(alias = "CU-125")]
    #[doc(alias = "CU-126")]
    pub fn area(&self, domain: &[(Rational, Rational); 2], goal: &Goal) -> Result<Integral, QuadratureError> {
        let normal = self.normal_numerator();
        let area = |at: &[Series<2, AREA_ORDER>; 2], precision: u32| {
            let squared = normal.0.iter().map(|n| at_series(n, at, precision).square()).reduce(|sum, n| sum + &n)?;
            self.over_power(squared.sqrt()?, 3, at, precision)
        };
        integral(area, domain, goal)
    }

    /// The same by ∫∫ √(EG − F²) du dv. CU-123.
    ///
    /// # Errors
    /// As [`RationalSurface::area`].
    pub fn area_by_first_form(
        &self,
        domain: &[(Rational, Rational); 2],
        goal: &Goal,
    ) -> Result<Integral, QuadratureError> {
        let tangents = self.tangent_numerators();
        let area = |at: &[Series<2, AREA_ORDER>; 2], precision: u32| {
            let [e, f, g] = first_form(&tangents, at, precision);
            self.over_power((e * &g - &f.square()).sqrt()?, 4, at, precision)
        };
        integral(area, domain, goal)
    }

    /// f/|q|ⁿ; `None` where q may be 0.
    fn over_power<const D: usize, const N: usize>(
        &self,
        f: Series<D, N>,
        n: usize,
        at: &[Series<D, N>; 2],
        precision: u32,
    ) -> Option<Series<D, N>> {
        if self.denominator == Function::integer(1) {
            return Some(f);
        }
        let q = at_series(&self.denominator, at, precision);
        let inverse = if q.value_is_negative() { (-q).inverse()? } else { q.inverse()? };
        Some((0..n).fold(f, |product, _| product * &inverse))
    }

    /// The length of the curve σ(u(t), v(t)), by ∫ √(Eu′² + 2Fu′v′ + Gv′²) dt. CU-121, CU-122.
    ///
    /// Near a pole of σ nothing is known: its outcome is `Limit`, with infinite bounds.
    ///
    /// # Errors
    /// `Pole` iff the path has one; `Reversed` iff from > to; `Width` iff the width is ≤ 0.
    #[doc(alias = "CU-121")]
    pub fn path_length(
        &self,
        path: &RationalCurve<2>,
        [from, to]: [&Rational; 2],
        goal: &Goal,
    ) -> Result<Integral, QuadratureError> {
        if !path.is_defined_on(from, to) {
            return Err(QuadratureError::Pole);
        }
        let tangents = self.tangent_numerators();
        let speed = |[t]: &[Series<1, ORDER>; 1], precision: u32| {
            let of = |p: &Polynomial| Series::of_polynomial(p, t, precision);
            let inverse = of(path.denominator()).inverse()?;
            let at = path.numerators().each_ref().map(|p| of(p) * &inverse);
            let square = inverse.square();
            let [du, dv] = path.velocity_numerators().map(|p| of(&p) * &square);
            let [e, f, g] = first_form(&tangents, &at, precision);
            let mixed = f * &du * &dv;
            let squared = e * &du.square() + &mixed + &mixed + &(g * &dv.square());
            self.over_power(squared.sqrt()?, 2, &at, precision)
        };
        integral(speed, &[(from.clone(), to.clone())], goal)
    }

    /// The curve σ(u(t), v(t)). CU-122.
    ///
    /// # Errors
    /// iff σ has a pole at every point of the path.
    pub fn along(&self, path: &RationalCurve<2>) -> Result<RationalCurve<3>, ZeroDenominator> {
        let functions = self.numerators.iter().chain([&self.denominator]);
        let degree = functions.flat_map(|f| f.terms().map(|(e, _)| e[0] + e[1])).max().unwrap_or(0);
        let [u, v] = path.numerators();
        let power = |x: &Polynomial, n: u32| (0..n).fold(Polynomial::integer(1), |product, _| product * x);
        // dⁿ f(u/d, v/d), n the largest degree
        let homogeneous = |f: &Function| {
            f.terms().fold(Polynomial::integer(0), |sum, ([i, j], a)| {
                let rest = power(path.denominator(), degree - i - j) * &Polynomial::new(vec![a.clone()]);
                sum + &(power(u, i) * &power(v, j) * &rest)
            })
        };
        RationalCurve::new(self.numerators.each_ref().map(homogeneous), homogeneous(&self.denominator))
    }

    /// σ∘h for polynomials h = (u(a, b), v(a, b)). CU-125.
    ///
    /// # Errors
    /// iff σ has a pole at every point of h.
    pub fn reparametrised(&self, h: &[Function; 2]) -> Result<RationalSurface, ZeroDenominator> {
        let composed = |f: &Function| f.evaluate_in(h, |a| Function::constant(a.clone()));
        RationalSurface::new(self.numerators.each_ref().map(composed), composed(&self.denominator))
    }
}

fn at_series<const D: usize, const N: usize>(f: &Function, at: &[Series<D, N>; 2], precision: u32) -> Series<D, N> {
    f.evaluate_in(at, |a| Series::rational(a, precision))
}

/// E, F and G of these tangent vectors, squares as such.
fn first_form<const D: usize, const N: usize>(
    tangents: &[Vector<Function, 3>; 2],
    at: &[Series<D, N>; 2],
    precision: u32,
) -> [Series<D, N>; 3] {
    let [u, v] = tangents.each_ref().map(|w| w.map(|p| at_series(p, at, precision)));
    let squared = |w: &Vector<Series<D, N>, 3>| w.0.iter().fold(Series::integer(0), |sum, x| sum + &x.square());
    [squared(&u), u.dot(&v), squared(&v)]
}

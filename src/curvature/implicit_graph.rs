//! Level surfaces as graphs over the coordinate planes: equations (6), (7), (8) of the text and what follows from them.
//!
//! Over the plane of x and y the surface f = a is the graph z = g(x, y) near a point with f_z ≠ 0. The other two planes are
//! met by turning the variables cyclically, which keeps the sense of a frame.

use super::jet::Jet;
use crate::linear::{Matrix, Vector, determinant3};
use crate::number::{OrderedField, Rational, Ring, Sign, Surd};
use thiserror::Error;

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

impl Axis {
    /// All three.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// Its number, from 0.
    pub const fn index(self) -> usize {
        match self {
            Axis::X => 0,
            Axis::Y => 1,
            Axis::Z => 2,
        }
    }
}

/// Why a level set is no graph along an axis, as far as its gradient tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum GraphError {
    /// ∇f = 0.
    #[error("a singular point: the gradient is zero")]
    Singular,
    /// The derivative along the axis is 0, the gradient is not.
    #[error("the tangent plane contains the axis, so that the level set is no graph along it there")]
    Vertical,
}

/// The jet of the same function with its variables turned cyclically until that axis is the last: for X the variables
/// are y, z, x, for Y they are z, x, y.
pub fn turned<K: Ring>(jet: &Jet<K, 3>, axis: Axis) -> Jet<K, 3> {
    let from = |i: usize| (axis.index() + 1 + i) % 3;
    Jet {
        value: jet.value.clone(),
        gradient: Vector(std::array::from_fn(|i| jet.gradient[from(i)].clone())),
        hessian: Matrix::from_fn(|i, j| jet.hessian.0[from(i)][from(j)].clone()),
    }
}

/// The graph z = g(x, y) that a level surface is near a point: g's derivatives to the second order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graph {
    /// g_x = −f_x/f_z, g_y = −f_y/f_z.
    pub first: [Rational; 2],
    /// g_xx, g_xy, g_yy.
    pub second: [Rational; 3],
}

/// The derivatives of the implicit function z = g(x, y), the text's (6). CU-154, CU-155.
///
/// g_xx = −f_xx/f_z + 2 f_xz f_x/f_z² − f_zz f_x²/f_z³,
/// g_xy = −f_xy/f_z + (f_yz f_x + f_y f_xz)/f_z² − f_y f_zz f_x/f_z³, and g_yy as g_xx.
///
/// # Errors
/// iff f_z = 0.
#[doc(alias = "CU-154")]
#[doc(alias = "CU-155")]
pub fn graph(jet: &Jet<Rational, 3>) -> Result<Graph, GraphError> {
    let ([fx, fy, _], [[fxx, fxy, fxz], [_, fyy, fyz], [_, _, fzz]]) = (&jet.gradient.0, &jet.hessian.0);
    // r = 1/f_z
    let r = &reciprocal_of_last(jet)?;
    let gxx = -product([fxx, r]) + product([fxz, fx, r, r]) * 2_u32 - product([fzz, fx, fx, r, r, r]);
    let gxy =
        -product([fxy, r]) + product([fyz, fx, r, r]) + product([fy, fxz, r, r]) - product([fy, fzz, fx, r, r, r]);
    let gyy = -product([fyy, r]) + product([fyz, fy, r, r]) * 2_u32 - product([fzz, fy, fy, r, r, r]);
    Ok(Graph { first: [-product([fx, r]), -product([fy, r])], second: [gxx, gxy, gyy] })
}

impl Graph {
    /// g as a jet, to which only its value is wanting: `height`.
    pub fn jet(&self, height: Rational) -> Jet<Rational, 2> {
        let [gxx, gxy, gyy] = self.second.clone();
        let hessian = Matrix([[gxx, gxy.clone()], [gxy, gyy]]);
        Jet { value: height, gradient: Vector(self.first.clone()), hessian }
    }

    /// The upward unit normal (−g_x, −g_y, 1)/√(g_x² + g_y² + 1) of the graph: sign(f_z)·∇f/|∇f|. CU-158.
    #[doc(alias = "CU-158")]
    pub fn upward_normal(&self) -> Vector<Surd, 3> {
        let [gx, gy] = self.first.clone();
        unit(&Vector([-gx, -gy, Rational::from(1)]))
    }
}

/// v/|v| for v ≠ 0.
pub(super) fn unit(v: &Vector<Rational, 3>) -> Vector<Surd, 3> {
    let w = v.norm_squared();
    v.map(|x| over_root(x, &w))
}

/// x/√w for w > 0.
pub(super) fn over_root(x: &Rational, w: &Rational) -> Surd {
    Surd::new(Rational::new(), Rational::from(x / w), w).expect("a sum of squares is not negative")
}

/// The product of some numbers.
pub(super) fn product<K: Ring, const N: usize>(factors: [&K; N]) -> K {
    factors.into_iter().fold(K::integer(1), |product, factor| product * factor)
}

/// 1/f_z.
fn reciprocal_of_last(jet: &Jet<Rational, 3>) -> Result<Rational, GraphError> {
    match (jet.gradient[2].inverse(), jet.gradient.norm_squared().sign()) {
        (Some(r), _) => Ok(r),
        (None, Sign::Zero) => Err(GraphError::Singular),
        (None, Sign::Positive | Sign::Negative) => Err(GraphError::Vertical),
    }
}

/// A₁, A₂, A₃: bordered 2×2 parts of the Hessian. CU-162.
#[doc(alias = "CU-162")]
pub fn bordered<K: Ring>(jet: &Jet<K, 3>) -> [Matrix<K, 3, 3>; 3] {
    let ([fx, fy, fz], [[fxx, fxy, fxz], [_, fyy, fyz], [_, _, fzz]]) = (&jet.gradient.0, &jet.hessian.0);
    let zero = &K::integer(0);
    [
        [[fxx, fxz, fx], [fxz, fzz, fz], [fx, fz, zero]],
        [[fxy, fyz, fy], [fxz, fzz, fz], [fx, fz, zero]],
        [[fyy, fyz, fy], [fyz, fzz, fz], [fy, fz, zero]],
    ]
    .map(|rows| Matrix(rows.map(|row| row.map(K::clone))))
}

/// det A₁, det A₂, det A₃: f_z²|∇f| times e, f, g. CU-159, CU-160, CU-161.
#[doc(alias = "CU-159")]
#[doc(alias = "CU-160")]
#[doc(alias = "CU-161")]
pub fn second_form_numerators<K: Ring>(jet: &Jet<K, 3>) -> [K; 3] {
    bordered(jet).map(|a| determinant3(&a))
}

/// The fundamental forms of a level surface as a graph, with N = +∇f/|∇f|.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LevelForms {
    /// E = (f_z² + f_x²)/f_z², F = f_x f_y/f_z², G = (f_z² + f_y²)/f_z².
    pub first: [Rational; 3],
    /// |∇f|e, |∇f|f, |∇f|g: det Aᵢ/f_z².
    pub second_w: [Rational; 3],
    /// |∇f|² > 0.
    pub gradient_squared: Rational,
}

/// The fundamental forms in the coordinates x, y: the text's (7), and e, f, g by determinants. CU-156.
///
/// # Errors
/// iff f_z = 0.
#[doc(alias = "CU-156")]
pub fn forms(jet: &Jet<Rational, 3>) -> Result<LevelForms, GraphError> {
    let r = &reciprocal_of_last(jet)?;
    let [fx, fy, fz] = &jet.gradient.0;
    let over = |x: Rational| product([&x, r, r]);
    let square = |x: &Rational| Rational::from(x.square_ref());
    let first = [over(square(fz) + square(fx)), over(Rational::from(fx * fy)), over(square(fz) + square(fy))];
    let second_w = second_form_numerators(jet).map(over);
    Ok(LevelForms { first, second_w, gradient_squared: jet.gradient.norm_squared() })
}

/// The fundamental forms over the plane across an axis, in the coordinates y, z for X, z, x for Y, x, y for Z. CU-170.
///
/// # Errors
/// iff the derivative along the axis is 0.
#[doc(alias = "CU-170")]
pub fn forms_along(jet: &Jet<Rational, 3>, axis: Axis) -> Result<LevelForms, GraphError> {
    forms(&turned(jet, axis))
}

/// |∇f|e, |∇f|f, |∇f|g for the graph's upward normal: |f_z| times g_xx, g_xy, g_yy, which is sign(f_z) times those of [`forms`]. CU-163.
///
/// # Errors
/// iff f_z = 0.
#[doc(alias = "CU-163")]
pub fn upward_second_w(jet: &Jet<Rational, 3>) -> Result<[Rational; 3], GraphError> {
    Ok(graph(jet)?.second.map(|x| x * Rational::from(jet.gradient[2].abs_ref())))
}

impl LevelForms {
    /// EG − F² = |∇f|²/f_z².
    pub fn area_squared(&self) -> Rational {
        let [e, f, g] = &self.first;
        Rational::from(e * g) - Rational::from(f.square_ref())
    }

    /// K = (eg − f²)/(EG − F²).
    pub fn gaussian(&self) -> Rational {
        let [e, f, g] = &self.second_w;
        (Rational::from(e * g) - Rational::from(f.square_ref())) / self.area_squared() / &self.gradient_squared
    }

    /// |∇f|H = |∇f|(eG − 2fF + gE)/(2(EG − F²)).
    pub fn mean_w(&self) -> Rational {
        let ([big_e, big_f, big_g], [e, f, g]) = (&self.first, &self.second_w);
        let numerator = Rational::from(e * big_g) - Rational::from(f * big_f) * 2_u32 + Rational::from(g * big_e);
        numerator / (self.area_squared() * 2_u32)
    }
}

/// K = (det A₁ det A₃ − det A₂²)/(f_z²|∇f|⁴). CU-164.
///
/// # Errors
/// iff f_z = 0.
#[doc(alias = "CU-164")]
pub fn gaussian_by_determinants(jet: &Jet<Rational, 3>) -> Result<Rational, GraphError> {
    let r = &reciprocal_of_last(jet)?;
    let [a1, a2, a3] = &second_form_numerators(jet);
    let w = jet.gradient.norm_squared();
    Ok((product([a1, a3, r, r]) - product([a2, a2, r, r])) / Rational::from(w.square_ref()))
}

/// |∇f|⁴K in full: the text's sum, term by term. It needs no f_z ≠ 0: det A₁ det A₃ − det A₂² is f_z² times it. CU-165, CU-169.
#[doc(alias = "CU-165")]
#[doc(alias = "CU-169")]
pub fn gaussian_numerator_expanded<K: Ring>(jet: &Jet<K, 3>) -> K {
    let ([fx, fy, fz], [[fxx, fxy, fxz], [_, fyy, fyz], [_, _, fzz]]) = (&jet.gradient.0, &jet.hessian.0);
    let two = &K::integer(2);
    let minor = |a: &K, b: &K, c: &K, d: &K| product([a, b]) - &product([c, d]);
    minor(fzz, fyy, fyz, fyz) * fx * fx
        + &(minor(fxz, fyz, fxy, fzz) * two * fy * fx)
        + &(minor(fxy, fyz, fxz, fyy) * two * fx * fz)
        + &(minor(fxx, fzz, fxz, fxz) * fy * fy)
        - &(minor(fxx, fyz, fxz, fxy) * two * fy * fz)
        + &(minor(fxx, fyy, fxy, fxy) * fz * fz)
}

/// |∇f|H = (det A₁(1 + f_y²/f_z²) − 2 det A₂(f_x f_y/f_z²) + det A₃(1 + f_x²/f_z²))/(2|∇f|²). CU-166.
///
/// # Errors
/// iff f_z = 0.
#[doc(alias = "CU-166")]
pub fn mean_w_by_determinants(jet: &Jet<Rational, 3>) -> Result<Rational, GraphError> {
    let r = &reciprocal_of_last(jet)?;
    let [fx, fy, _] = &jet.gradient.0;
    let [a1, a2, a3] = second_form_numerators(jet);
    let sum = a1 * (product([fy, fy, r, r]) + 1_u32) - a2 * product([fx, fy, r, r]) * 2_u32
        + a3 * (product([fx, fx, r, r]) + 1_u32);
    Ok(sum / (jet.gradient.norm_squared() * 2_u32))
}

/// 2|∇f|³H in full, in the convention N = +∇f/|∇f|: minus the text's sum. CU-167.
#[doc(alias = "CU-167")]
pub fn mean_numerator_expanded<K: Ring>(jet: &Jet<K, 3>) -> K {
    -super::implicit_printed::printed_mean_numerator(jet)
}

/// The bordered Hessian (Hess f, ∇f; ∇fᵀ, 0): its determinant is −|∇f|⁴K. CU-172.
#[doc(alias = "CU-172")]
pub fn bordered_hessian<K: Ring>(jet: &Jet<K, 3>) -> Matrix<K, 4, 4> {
    Matrix::from_fn(|i, j| match (i, j) {
        (3, 3) => K::integer(0),
        (3, k) | (k, 3) => jet.gradient[k].clone(),
        (i, j) => jet.hessian.0[i][j].clone(),
    })
}

/// The same of a level curve: its determinant is κ|∇f|³. CU-173.
#[doc(alias = "CU-173")]
pub fn bordered_hessian_of_curve<K: Ring>(jet: &Jet<K, 2>) -> Matrix<K, 3, 3> {
    Matrix::from_fn(|i, j| match (i, j) {
        (2, 2) => K::integer(0),
        (2, k) | (k, 2) => jet.gradient[k].clone(),
        (i, j) => jet.hessian.0[i][j].clone(),
    })
}

/// A basis of the tangent plane ker(df): the graph's (1, 0, g_x), (0, 1, g_y) along the axis, in the order in which their
/// cross product is ∇f over its part along the axis. CU-151.
///
/// # Errors
/// iff the derivative along the axis is 0.
#[doc(alias = "CU-151")]
#[doc(alias = "CU-157")]
pub fn tangent_basis(jet: &Jet<Rational, 3>, axis: Axis) -> Result<[Vector<Rational, 3>; 2], GraphError> {
    let Graph { first: [gu, gv], .. } = graph(&turned(jet, axis))?;
    let back = |[u, v, w]: [Rational; 3]| {
        let mut at = Vector::zero();
        for (i, x) in [u, v, w].into_iter().enumerate() {
            at.0[(axis.index() + 1 + i) % 3] = x;
        }
        at
    };
    let integer = |n: u32| Rational::from(n);
    Ok([back([integer(1), integer(0), gu]), back([integer(0), integer(1), gv])])
}

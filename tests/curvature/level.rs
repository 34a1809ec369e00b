//! Jets of level surfaces: random ones, and ones with a planted kind of point, or next to one.

use super::q;
use isoracle::curvature::jet::Jet;
use isoracle::linear::{Matrix, Vector};
use isoracle::number::{Integer, Multivariate, Rational, Ring};
use proptest::prelude::*;

/// f with these derivatives at the origin: f_x, f_y, f_z and f_xx, f_xy, f_xz, f_yy, f_yz, f_zz.
pub fn jet_of(gradient: [Rational; 3], second: [Rational; 6]) -> Jet<Rational, 3> {
    let [xx, xy, xz, yy, yz, zz] = second;
    let rows = [[xx, xy.clone(), xz.clone()], [xy, yy, yz.clone()], [xz, yz, zz]];
    Jet { value: q(0, 1), gradient: Vector(gradient), hessian: Matrix(rows) }
}

/// The same, from integers.
pub fn jet(gradient: [i64; 3], second: [i64; 6]) -> Jet<Rational, 3> {
    jet_of(gradient.map(Rational::from), second.map(Rational::from))
}

/// All nine derivatives as variables: what holds of this jet holds of every one.
pub fn generic_jet() -> Jet<Multivariate<9>, 3> {
    let index = [[3, 4, 5], [4, 6, 7], [5, 7, 8]];
    Jet {
        value: Multivariate::integer(0),
        gradient: Vector(std::array::from_fn(Multivariate::variable)),
        hessian: Matrix::from_fn(|i, j| Multivariate::variable(index[i][j])),
    }
}

pub fn small() -> impl Strategy<Value = Rational> {
    prop_oneof![3 => (-3..=3_i64).prop_map(Rational::from), 1 => (-5..=5_i64, 1..=4_i64).prop_map(|(n, d)| q(n, d))]
}

/// Gradients: random, along an axis, in a coordinate plane, tiny; 0 seldom.
pub fn gradient() -> impl Strategy<Value = Vector<Rational, 3>> {
    let any = prop::array::uniform3(small()).prop_map(Vector);
    let axis =
        (0..3_usize, -3..=3_i64).prop_map(|(axis, n)| Vector([0, 1, 2].map(|i| q(if i == axis { n } else { 0 }, 1))));
    let tiny = (prop::array::uniform3(small()), 1..80_u32)
        .prop_map(|(v, bits)| Vector(v).scaled(&Rational::from((Integer::from(1), Integer::from(1) << bits))));
    // Of rational length, so that N is rational.
    let rational = prop::sample::select(vec![[1, 2, 2], [-2, 3, 6], [0, 3, -4], [4, 4, -7], [2, 0, 0]])
        .prop_map(|v| Vector(v.map(Rational::from)));
    prop_oneof![4 => any, 2 => axis, 1 => tiny, 2 => rational]
}

/// A Hessian that has λ₁, λ₂ along two tangent directions, and anything along the normal: aaᵀλ₁ + bbᵀλ₂ + nuᵀ + unᵀ.
fn planted_hessian(n: &Vector<Rational, 3>, sizes: [Rational; 2], u: &Vector<Rational, 3>) -> Matrix<Rational, 3, 3> {
    let axes = [0, 1, 2].map(|axis| Vector([0, 1, 2].map(|i| q(i64::from(i == axis), 1))));
    let crossed = axes.iter().map(|axis| n.cross(axis)).find(|a| !a.norm_squared().is_zero());
    let a = crossed.unwrap_or_else(|| axes[0].clone());
    let b = n.cross(&a);
    let over = |x: &Rational, v: &Vector<Rational, 3>| {
        let square = v.norm_squared();
        if square.is_zero() { q(0, 1) } else { Rational::from(x / &square) }
    };
    let weights = [over(&sizes[0], &a), over(&sizes[1], &b)];
    let outer = |v: &Vector<Rational, 3>, w: &Vector<Rational, 3>, i: usize, j: usize| Rational::from(&v[i] * &w[j]);
    Matrix::from_fn(|i, j| {
        outer(&a, &a, i, j) * &weights[0] + outer(&b, &b, i, j) * &weights[1] + outer(n, u, i, j) + outer(u, n, i, j)
    })
}

/// Jets of level surfaces: umbilics, planar points, cylinders and points a hair from these among random ones.
pub fn any_jet() -> impl Strategy<Value = Jet<Rational, 3>> {
    let random = (gradient(), prop::array::uniform6(small())).prop_map(|(gradient, second)| jet_of(gradient.0, second));
    let hair = prop_oneof![2 => Just(0_u32), 1 => 1..100_u32];
    let planted =
        (gradient(), small(), 0..4_u8, prop::array::uniform3(small()), hair).prop_map(|(n, size, kind, u, bits)| {
            let sizes = match kind {
                0 => [size.clone(), size],
                1 => [q(0, 1), size],
                2 => [Rational::from(-&size), size],
                _ => [q(0, 1), q(0, 1)],
            };
            let mut hessian = planted_hessian(&n, sizes, &Vector(u));
            if bits > 0 {
                hessian.0[0][0] += Rational::from((Integer::from(1), Integer::from(1) << bits));
            }
            Jet { value: q(0, 1), gradient: n, hessian }
        });
    prop_oneof![random, planted]
}

/// The same, with ∇f ≠ 0.
pub fn regular_jet() -> impl Strategy<Value = Jet<Rational, 3>> {
    any_jet().prop_filter("regular", |jet| !jet.gradient.norm_squared().is_zero())
}

/// Polynomials of degree at most 2 in each variable.
pub fn polynomial() -> impl Strategy<Value = Multivariate<3>> {
    let term = (prop::array::uniform3(0..=2_u32), -4..=4_i32);
    prop::collection::vec(term, 1..7).prop_map(|terms| Multivariate::new(terms.into_iter().map(|(n, c)| (n, c.into()))))
}

pub fn point() -> impl Strategy<Value = [Rational; 3]> {
    prop::array::uniform3(small())
}

/// A polynomial in x, y, z, by its terms.
pub fn terms<const N: usize>(terms: &[([u32; N], i64)]) -> Multivariate<N> {
    Multivariate::new(terms.iter().map(|(n, c)| (*n, Rational::from(*c))))
}

/// x² + y² + z².
pub fn sphere() -> Multivariate<3> {
    terms(&[([2, 0, 0], 1), ([0, 2, 0], 1), ([0, 0, 2], 1)])
}

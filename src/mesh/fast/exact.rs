//! Exact decisions on points of binary64: filtered first, then machine integers, then integers of any size.

use super::Point;
use crate::linear::{Matrix, Vector, determinant3};
use crate::number::{Enclosure, Integer, Ring, Sign, Word};

/// 2⁻⁵³, half a unit in the last place of 1.
const EPSILON: f64 = f64::EPSILON / 2.0;

/// Whether (b − a) × (c − a) = 0: the three points lie on one line. ME-145.
///
/// In each coordinate, with rounded differences u, v and p = u₁v₂, q = u₂v₁, the rounded p − q differs from the exact
/// value by at most 4ε(|p| + |q|) + 2⁻¹⁰²², ε = 2⁻⁵³; beyond that it is not 0.
#[doc(alias = "ME-145")]
pub fn collinear(a: &Point, b: &Point, c: &Point) -> bool {
    !(0..3).any(|axis| orientation_filter(axis, a, b, c).is_some())
        && exactly([a, b, c], 61, |points| is_zero(&normal(&points)), |points| is_zero(&normal(&points)))
}

/// The sign of the coordinate `axis` of (b − a) × (c − a): the turn of a, b, c as seen along that axis. ME-145.
pub fn orientation(axis: usize, a: &Point, b: &Point, c: &Point) -> Sign {
    orientation_filter(axis, a, b, c).unwrap_or_else(|| {
        exactly([a, b, c], 61, |points| sign(&normal(&points).0[axis]), |points| sign(&normal(&points).0[axis]))
    })
}

/// The sign, where rounded arithmetic proves that it is not zero.
fn orientation_filter(axis: usize, a: &Point, b: &Point, c: &Point) -> Option<Sign> {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    // Each rounded difference is (1 + δ) times the exact one, |δ| ≤ ε, and so is each product of two, but for an underflow
    // of at most 2⁻¹⁰⁷⁵; the difference of the products adds the third factor. (1 + ε)³ − 1 and the rounding of
    // the bound itself are within 4ε. An overflow makes the bound infinite or NaN, which proves nothing.
    let p = (b[j] - a[j]) * (c[k] - a[k]);
    let q = (b[k] - a[k]) * (c[j] - a[j]);
    beyond(p - q, 4.0 * EPSILON * (p.abs() + q.abs()) + f64::MIN_POSITIVE)
}

/// The sign of |b − a, c − a, d − a|: on which side of the plane abc is d. ME-146.
///
/// The filter's bound is 8ε times the permanent, as in Shewchuk's static bound (7 + 56ε)ε, + 2⁻⁸⁰⁰ for underflows, where all
/// differences are below 2²⁰⁰.
#[doc(alias = "ME-146")]
pub fn side_of_plane(a: &Point, b: &Point, c: &Point, d: &Point) -> Sign {
    side_filter(a, b, c, d)
        .unwrap_or_else(|| exactly([a, b, c, d], 40, |points| sign(&volume(&points)), |points| sign(&volume(&points))))
}

fn side_filter(a: &Point, b: &Point, c: &Point, d: &Point) -> Option<Sign> {
    let minus_a = |p: &Point| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (u, v, w) = (minus_a(b), minus_a(c), minus_a(d));
    let moderate = u.iter().chain(&v).chain(&w).all(|x| x.abs() < 2_f64.powi(200));
    if !moderate {
        return None;
    }
    let (mut value, mut permanent) = (0.0, 0.0);
    for (i, u) in u.iter().enumerate() {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (p, q) = (v[j] * w[k], v[k] * w[j]);
        value += u * (p - q);
        permanent += u.abs() * (p.abs() + q.abs());
    }
    beyond(value, 8.0 * EPSILON * permanent + 2_f64.powi(-800))
}

fn beyond(value: f64, bound: f64) -> Option<Sign> {
    match (value > bound, value < -bound) {
        (true, _) => Some(Sign::Positive),
        (_, true) => Some(Sign::Negative),
        (false, false) => None,
    }
}

/// Whether v lies strictly between a and b on their segment: it is within the closed box of a and b, on their line,
/// and neither of them. ME-147.
#[doc(alias = "ME-147")]
pub fn strictly_between(v: &Point, a: &Point, b: &Point) -> bool {
    (0..3).all(|i| a[i].min(b[i]) <= v[i] && v[i] <= a[i].max(b[i])) && v != a && v != b && collinear(a, b, v)
}

/// Whether the closed segments ab and cd cross in one point inside both, as seen along an axis.
pub fn cross_properly(axis: usize, [a, b]: [&Point; 2], [c, d]: [&Point; 2]) -> bool {
    orientation(axis, a, b, c) * orientation(axis, a, b, d) == Sign::Negative
        && orientation(axis, c, d, a) * orientation(axis, c, d, b) == Sign::Negative
}

fn normal<K: Ring>([a, b, c]: &[Vector<K, 3>; 3]) -> Vector<K, 3> {
    difference(b, a).cross(&difference(c, a))
}

fn volume<K: Ring>([a, b, c, d]: &[Vector<K, 3>; 4]) -> K {
    determinant3(&Matrix([b, c, d].map(|p| difference(p, a).0)))
}

fn difference<K: Ring>(a: &Vector<K, 3>, b: &Vector<K, 3>) -> Vector<K, 3> {
    Vector(std::array::from_fn(|i| a.0[i].clone() - &b.0[i]))
}

fn is_zero<K: Enclosure>(v: &Vector<K, 3>) -> bool {
    v.0.iter().all(|x| sign(x) == Sign::Zero)
}

fn sign<K: Enclosure>(x: &K) -> Sign {
    x.known_sign().expect("an integer has a sign")
}

/// Decides a homogeneous question about points whose coordinates are scaled by one power of two to integers: in machine
/// words where the integers are below 2^bits.
fn exactly<const N: usize, T>(
    points: [&Point; N],
    bits: i32,
    words: impl Fn([Vector<Word, 3>; N]) -> T,
    integers: impl Fn([Vector<Integer, 3>; N]) -> T,
) -> T {
    let dyadic = points.map(|p| p.map(Dyadic::of));
    let least = Dyadic::least_exponent(dyadic.iter().flatten().copied());
    let top = dyadic.iter().flatten().map(|x| x.top()).max().unwrap_or(0);
    if top - least <= bits {
        words(dyadic.map(|p| Vector(p.map(|x| Word(i128::from(x.mantissa) << x.shift(least))))))
    } else {
        integers(dyadic.map(|p| Vector(p.map(|x| Integer::from(x.mantissa) << x.shift(least)))))
    }
}

/// A finite binary64 as mantissa · 2^exponent, the mantissa odd; 0 as 0 · 2^0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dyadic {
    /// Odd, |mantissa| < 2⁵³; or 0.
    pub mantissa: i64,
    /// From −1074 to 1023.
    pub exponent: i32,
}

impl Dyadic {
    /// The exact value of a finite binary64. ME-148.
    #[doc(alias = "ME-148")]
    pub fn of(x: f64) -> Dyadic {
        let bits = x.to_bits();
        let field = (bits >> 52 & 0x7FF) as i32;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        // Subnormals have the exponent of the least normals, and no leading one.
        let (mantissa, exponent) = if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
        if mantissa == 0 {
            return Dyadic { mantissa: 0, exponent: 0 };
        }
        let zeros = mantissa.trailing_zeros();
        let odd = mantissa >> zeros;
        Dyadic { mantissa: if x < 0.0 { -odd } else { odd }, exponent: exponent + zeros as i32 }
    }

    /// The least exponent of those that are not 0; 0 where all are.
    pub fn least_exponent(numbers: impl Iterator<Item = Dyadic>) -> i32 {
        numbers.filter(|x| x.mantissa != 0).map(|x| x.exponent).min().unwrap_or(0)
    }

    /// |x| < 2^top; least for 0.
    pub fn top(self) -> i32 {
        if self.mantissa == 0 {
            return i32::MIN / 2;
        }
        self.exponent + (64 - self.mantissa.unsigned_abs().leading_zeros() as i32)
    }

    /// How far the mantissa is shifted for the unit 2^least, which is at most the exponent; 0 for 0.
    pub fn shift(self, least: i32) -> u32 {
        if self.mantissa == 0 { 0 } else { (self.exponent - least) as u32 }
    }
}

//! Multilinear interpolation between the corners of a cell (IS-16 … IS-34).
//!
//! Corner values are numbered as corners are: c = u + 2v + 4w. The formulas hold for every ring, so that
//! they run on rationals, on intervals and on numbers with an infinitesimal part.

use crate::number::{Integer, Rational, Ring, Sign};

fn complement<K: Ring>(u: &K) -> K {
    K::integer(1) - u
}

/// Linear interpolation: f(u) = (1 − u)·g₀ + u·g₁, for every u; f(0) = g₀, f(1) = g₁ (IS-18, IS-19).
#[doc(alias = "IS-18")]
#[doc(alias = "IS-19")]
pub fn linear<K: Ring>([g0, g1]: &[K; 2], u: &K) -> K {
    complement(u) * g0 + &(u.clone() * g1)
}

/// Bilinear interpolation: f(u,v) = (1−u)(1−v)·g₀₀ + u(1−v)·g₁₀ + (1−u)v·g₀₁ + uv·g₁₁ (IS-25).
///
/// It has the corner values (IS-26), is linear along every line parallel to an axis (IS-28), and is the only such
/// function, though not the only quadric with these values (IS-27). Neighbours share the linear function of their edge, so that
/// f is continuous (IS-29).
#[doc(alias = "IS-25")]
#[doc(alias = "IS-26")]
#[doc(alias = "IS-27")]
#[doc(alias = "IS-28")]
#[doc(alias = "IS-29")]
pub fn bilinear<K: Ring>([g00, g10, g01, g11]: &[K; 4], [u, v]: &[K; 2]) -> K {
    let (ou, ov) = (complement(u), complement(v));
    ou.clone() * &ov * g00 + &(u.clone() * &ov * g10) + &(ou * v * g01) + &(u.clone() * v * g11)
}

/// Trilinear interpolation: the sum over the corners of g_c times the product of u or 1 − u, v or 1 − v,
/// w or 1 − w, as the corner's coordinate is 1 or 0 (IS-31).
///
/// It is the only function with these corner values that is linear along every line parallel to an axis, though not the only
/// cubic (IS-32). Over the whole grid f is continuous, and smooth in each cell (IS-34).
#[doc(alias = "IS-31")]
#[doc(alias = "IS-32")]
#[doc(alias = "IS-34")]
pub fn trilinear<K: Ring>(g: &[K; 8], [u, v, w]: &[K; 3]) -> K {
    let (ou, ov, ow) = (complement(u), complement(v), complement(w));
    let weights = [
        [&ou, &ov, &ow],
        [u, &ov, &ow],
        [&ou, v, &ow],
        [u, v, &ow],
        [&ou, &ov, w],
        [u, &ov, w],
        [&ou, v, w],
        [u, v, w],
    ];
    g.iter().zip(weights).fold(K::integer(0), |sum, (g, [u, v, w])| sum + &(u.clone() * v * w * g))
}

/// The gradient of the bilinear function: f_u is linear in v between the differences g₁₀ − g₀₀ and g₁₁ − g₀₁,
/// f_v likewise in u.
pub fn bilinear_gradient<K: Ring>([g00, g10, g01, g11]: &[K; 4], [u, v]: &[K; 2]) -> [K; 2] {
    let difference = |high: &K, low: &K| high.clone() - low;
    [linear(&[difference(g10, g00), difference(g11, g01)], v), linear(&[difference(g01, g00), difference(g11, g10)], u)]
}

/// The gradient of the trilinear function: each derivative is bilinear in the two other coordinates, between
/// the differences along the four edges of its axis.
pub fn trilinear_gradient<K: Ring>(g: &[K; 8], [u, v, w]: &[K; 3]) -> [K; 3] {
    let along = |axis: usize, at: [&K; 2]| {
        let differences = lines(axis).map(|[low, high]| g[high].clone() - &g[low]);
        bilinear(&differences, &at.map(K::clone))
    };
    [along(0, [v, w]), along(1, [u, w]), along(2, [u, v])]
}

/// The ends of the four edges along an axis, by the two other coordinates, the lower one fastest.
fn lines(axis: usize) -> [[usize; 2]; 4] {
    let (a, b) = [(2, 4), (1, 4), (1, 2)][axis];
    [0, a, b, a + b].map(|low| [low, low + (1 << axis)])
}

/// The values at both ends of the line through the cell along `axis`, at the two other coordinates `at`: f is
/// linear between them (IS-33).
///
/// # Panics
/// Iff the axis is none of 0, 1, 2.
#[doc(alias = "IS-33")]
pub fn on_line<K: Ring>(g: &[K; 8], axis: usize, at: &[K; 2]) -> [K; 2] {
    [0, 1].map(|end| bilinear(&lines(axis).map(|line| g[line[end]].clone()), at))
}

/// Piecewise linear interpolation of a signal on the integers (IS-20):
/// f(x) = (1 − x + ⌊x⌋)·g[⌊x⌋] + (x − ⌊x⌋)·g[⌊x⌋ + 1].
///
/// At an integer x the weight of g[x + 1] is zero, but the signal is asked for it. The cell is that of
/// the floor, below 0 as well (IS-17); as each piece is continuous and meets its ends, f is continuous (IS-16).
#[doc(alias = "IS-16")]
#[doc(alias = "IS-17")]
#[doc(alias = "IS-20")]
pub fn piecewise_linear(g: impl Fn(&Integer) -> Rational, x: &Rational) -> Rational {
    let (u, i) = x.clone().fract_floor(Integer::new());
    linear(&[g(&i), g(&(i.clone() + 1))], &u)
}

/// Where a linear interpolant vanishes on [0, 1]: nowhere between two values of one strict sign (IS-21), once if the
/// signs are opposite or just one value is 0 (IS-22).
#[doc(alias = "IS-21")]
#[doc(alias = "IS-22")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LinearZero {
    /// Both ends have one strict sign.
    None,
    /// In one point.
    At(Rational),
    /// Both ends are zero. (The text's "one of the two is zero" must be read as exactly one.)
    Everywhere,
}

/// The zero of the linear interpolant on [0, 1]: u₀ = g₀ / (g₀ − g₁) where the ends have opposite signs or one of
/// them is zero (IS-23). Where they are opposite, 0 < u₀ < 1 (IS-24). Sampling is not invariant under rigid motions: what
/// lies between two samples of one sign is missed (IS-71).
#[doc(alias = "IS-23")]
#[doc(alias = "IS-24")]
#[doc(alias = "IS-71")]
pub fn linear_zero([g0, g1]: &[Rational; 2]) -> LinearZero {
    match (Sign::of(g0.cmp0()), Sign::of(g1.cmp0())) {
        (Sign::Zero, Sign::Zero) => LinearZero::Everywhere,
        (Sign::Positive, Sign::Positive) | (Sign::Negative, Sign::Negative) => LinearZero::None,
        (Sign::Zero, Sign::Negative | Sign::Positive)
        | (Sign::Negative, Sign::Zero | Sign::Positive)
        | (Sign::Positive, Sign::Zero | Sign::Negative) => LinearZero::At(g0.clone() / (g0.clone() - g1)),
    }
}

/// Where the trilinear function vanishes on the line through the cell along `axis`, at the two other
/// coordinates `at`, as a share of the line; on the grid's own edges, where eq (22) says (IS-30).
/// Unless f vanishes all along it, it changes sign there at most once (IS-62).
///
/// # Panics
/// Iff the axis is none of 0, 1, 2.
#[doc(alias = "IS-30")]
#[doc(alias = "IS-62")]
pub fn zero_on_line(g: &[Rational; 8], axis: usize, at: &[Rational; 2]) -> LinearZero {
    linear_zero(&on_line(g, axis, at))
}

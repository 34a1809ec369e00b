//! The area of a mesh: a sum of square roots, enclosed by integers.

use super::Point;
use super::exact::Dyadic;
use super::polygons::Polygons;
use super::sum::DyadicSum;
use crate::number::{Integer, Rational};

/// lo ≤ area ≤ hi, proven. The area is rational iff lo = hi: a sum of positive roots of rationals is rational iff each of them is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Area {
    /// The lower bound.
    pub lo: Rational,
    /// The upper bound.
    pub hi: Rational,
}

/// The least number of bits of a root: those that a machine word has.
pub const WORD_BITS: u32 = 62;

/// Σ ½|Σ vᵢ × vᵢ₊₁| over the faces, each root with at least `bits` bits, so that hi − lo ≤ 2^(1−bits)·area. ME-152.
///
/// That is a face's area where it is planar and does not cross itself; of any other it is the area of its largest projection.
#[doc(alias = "ME-152")]
pub fn area(mesh: &Polygons, bits: u32) -> Area {
    let (mut lo, mut slack) = (DyadicSum::default(), DyadicSum::default());
    let mut points = Vec::new();
    for face in mesh.loops() {
        points.clear();
        points.extend(face.iter().map(|&v| mesh.vertices()[v as usize]));
        if points.len() >= 3 {
            add_face(&mut lo, &mut slack, &points, bits);
        }
    }
    let lo = lo.total();
    Area { hi: &lo + slack.total(), lo }
}

/// Adds ½√(n·n) for n = Σ (vᵢ − v₀) × (vᵢ₊₁ − v₀), an integer vector in units of the square of the coordinates' unit 2^q.
fn add_face(lo: &mut DyadicSum, slack: &mut DyadicSum, points: &[Point], bits: u32) {
    let dyadic = |p: &Point| p.map(Dyadic::of);
    let least = Dyadic::least_exponent(points.iter().flat_map(dyadic));
    if bits <= WORD_BITS
        && let Some(square) = word_square(points, least)
    {
        // √N ∈ [s, s + 1]·2^−k for s = ⌊√(4^k·N)⌋, with 4^k·N of 125 or 126 bits.
        let k = (square.leading_zeros() as i32 - 2).max(0) / 2;
        let shifted = square << (2 * k);
        let root = shifted.isqrt();
        lo.add(root as i128, 2 * least - 1 - k);
        slack.add(i128::from(root * root != shifted), 2 * least - 1 - k);
        return;
    }
    let integers: Vec<[Integer; 3]> =
        points.iter().map(|p| dyadic(p).map(|x| Integer::from(x.mantissa) << x.shift(least))).collect();
    let mut n = [Integer::new(), Integer::new(), Integer::new()];
    for pair in integers[1..].windows(2) {
        let [u, v] = [&pair[0], &pair[1]]
            .map(|p| -> [Integer; 3] { std::array::from_fn(|i| Integer::from(&p[i] - &integers[0][i])) });
        for (i, n) in n.iter_mut().enumerate() {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            *n += &u[j] * &v[k];
            *n -= &u[k] * &v[j];
        }
    }
    let square = n.into_iter().fold(Integer::new(), |sum, x| sum + x.square());
    if square.is_perfect_square() {
        return lo.add_integer(square.sqrt(), 2 * least - 1);
    }
    let k = (bits as i32 - square.significant_bits() as i32 / 2).max(0);
    // The sum's exponents have a floor; no binary64 asks for a root below it.
    let root = (square << (2 * k) as u32).sqrt();
    lo.add_integer(root, 2 * least - 1 - k);
    slack.add_integer(Integer::from(1), 2 * least - 1 - k);
}

/// n·n for n = Σ (vᵢ − v₀) × (vᵢ₊₁ − v₀) in the unit 2^least, where all of it stays within machine words.
fn word_square(points: &[Point], least: i32) -> Option<u128> {
    let word = |x: f64| {
        let x = Dyadic::of(x);
        (x.top() - least <= 62).then(|| x.mantissa << x.shift(least))
    };
    let at = |p: &Point| Some([word(p[0])?, word(p[1])?, word(p[2])?]);
    let first = at(&points[0])?;
    let from_first = |p: &Point| at(p).map(|p| -> [i128; 3] { std::array::from_fn(|i| i128::from(p[i] - first[i])) });
    let mut n = [0_i128; 3];
    let mut u = from_first(&points[1])?;
    for p in &points[2..] {
        let v = from_first(p)?;
        for (i, n) in n.iter_mut().enumerate() {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            *n = n.checked_add(u[j].checked_mul(v[k])?.checked_sub(u[k].checked_mul(v[j])?)?)?;
        }
        u = v;
    }
    let small = n.iter().all(|x| x.unsigned_abs() < 1 << 62);
    small.then(|| n.iter().map(|x| x.unsigned_abs().pow(2)).sum())
}

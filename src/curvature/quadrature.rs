//! Verified quadrature: integrals over intervals and rectangles, within intervals as narrow as asked for.

use super::series::{Series, multi_indices};
use crate::number::{Integer, Interval, Rational, Ring};
use thiserror::Error;

/// How often a part of which nothing is known is halved before it is taken for one with a pole.
const DEEPEST: u32 = 48;

/// What is asked of an integral.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Goal {
    /// The width of the answer's interval.
    pub width: Rational,
    /// The number of parts of the domain beyond which the answer is given as it is.
    pub cells: usize,
}

impl Goal {
    /// 10^−digits, with at most 2¹² parts.
    pub fn digits(digits: u32) -> Goal {
        Goal { width: Rational::from((1, Integer::u_pow_u(10, digits))), cells: 1 << 12 }
    }
}

/// Whether an integral is as narrow as was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// The interval's width is at most what was asked.
    Reached,
    /// The number of parts was used up, or a part seems to have a pole: the interval holds the integral, if there is one, but is wider.
    Limit,
}

/// An integral.
#[derive(Clone, Debug)]
pub struct Integral {
    /// Around the integral, whatever the outcome; its bounds are infinite where nothing is known.
    pub value: Interval,
    /// Whether it is narrow enough.
    pub outcome: Outcome,
    /// In how many parts the domain was cut.
    pub cells: usize,
}

/// Why there is no such integral.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum QuadratureError {
    /// No interval of rounded numbers need have the width 0.
    #[error("expected a width above 0, found {0}")]
    Width(Rational),
    /// The domain's bounds are not in order.
    #[error("the domain runs from {from} down to {to}")]
    Reversed {
        /// The lower bound.
        from: Rational,
        /// The upper bound, which is less.
        to: Rational,
    },
    /// The integrand is not defined everywhere in the domain.
    #[error("the integrand has a pole in the domain")]
    Pole,
}

/// A part of the domain.
struct Cell<const D: usize> {
    domain: [(Rational, Rational); D],
    /// How often it was halved.
    depth: u32,
    integral: Interval,
    /// Its integral's width; `None` is infinite.
    width: Option<Rational>,
}

/// ∫ f over the box, the integrand being Taylor's polynomial of degree N − 1 around the middle of each part, and Lagrange's remainder,
/// whose coefficients are enclosed over the part. CU-127, CU-128.
///
/// The integrand takes the series of the variables to its own; `None` where it is not known to be defined. Parts are halved along each
/// axis until the sum of their intervals is as narrow as asked for. The intervals are right for every integrand that is N times
/// continuously differentiable in the box, and where it is not so, at a zero of a root, for every continuous one that is so elsewhere:
/// there the range of the values alone is used.
///
/// # Errors
/// `Width` iff the width is ≤ 0; `Reversed` iff a lower bound is above its upper one.
#[doc(alias = "CU-127")]
#[doc(alias = "CU-128")]
pub fn integral<const D: usize, const N: usize>(
    integrand: impl Fn(&[Series<D, N>; D], u32) -> Option<Series<D, N>>,
    domain: &[(Rational, Rational); D],
    goal: &Goal,
) -> Result<Integral, QuadratureError> {
    if goal.width <= 0 {
        return Err(QuadratureError::Width(goal.width.clone()));
    }
    if let Some((from, to)) = domain.iter().find(|(from, to)| from > to) {
        return Err(QuadratureError::Reversed { from: from.clone(), to: to.clone() });
    }
    let precision = first_precision(&integrand, domain, &goal.width);
    let new = |domain: [(Rational, Rational); D], depth: u32| {
        // Halved further, a part is to gain more by its smaller sides than is lost by rounding.
        let integral = over_cell(&integrand, &domain, precision.saturating_add(4 * depth));
        let width = integral.width();
        Cell { domain, depth, integral, width }
    };
    let mut cells = vec![new(domain.clone(), 0)];
    loop {
        let value = cells.iter().fold(Interval::integer(0), |sum, cell| sum + &cell.integral);
        let outcome = match value.width() {
            Some(width) if width <= goal.width => Outcome::Reached,
            Some(_) | None if cells.len() >= goal.cells => Outcome::Limit,
            None if cells.iter().any(|cell| cell.width.is_none() && cell.depth >= DEEPEST) => Outcome::Limit,
            Some(_) | None => {
                cells = halved(cells, goal, new);
                continue;
            }
        };
        return Ok(Integral { value, outcome, cells: cells.len() });
    }
}

/// The parts, with those halved of which nothing is known; where there are none, those that are wider than half of their share of
/// the width. Only the widest ones where there is no room for all.
fn halved<const D: usize>(
    mut cells: Vec<Cell<D>>,
    goal: &Goal,
    new: impl Fn([(Rational, Rational); D], u32) -> Cell<D>,
) -> Vec<Cell<D>> {
    let share = Rational::from(&goal.width / Integer::from(2 * cells.len()));
    // The widest first; an infinite width is the largest.
    cells.sort_by(|a, b| (b.width.is_none(), &b.width).cmp(&(a.width.is_none(), &a.width)));
    let unknown = cells.iter().take_while(|cell| cell.width.is_none()).count();
    let wide = match unknown {
        0 => cells.iter().take_while(|cell| cell.width.as_ref().is_none_or(|width| *width > share)).count(),
        _ => unknown,
    };
    let room = (goal.cells.saturating_sub(cells.len()) >> D).max(1);
    // Rounding in the sum alone may have made it too wide: then halve the widest part, which is computed with more bits.
    let kept = cells.split_off(wide.clamp(1, room));
    let halves = cells.into_iter().flat_map(|cell| parts(&cell.domain).into_iter().map(move |d| (d, cell.depth + 1)));
    halves.map(|(domain, depth)| new(domain, depth)).chain(kept).collect()
}

/// The 2ᴰ halves along each axis.
fn parts<const D: usize>(domain: &[(Rational, Rational); D]) -> Vec<[(Rational, Rational); D]> {
    let middle: [Rational; D] = std::array::from_fn(|i| middle(&domain[i]));
    let half = |of: usize| {
        std::array::from_fn(|i| match of >> i & 1 {
            0 => (domain[i].0.clone(), middle[i].clone()),
            _ => (middle[i].clone(), domain[i].1.clone()),
        })
    };
    (0..1 << D).map(half).collect()
}

fn middle((from, to): &(Rational, Rational)) -> Rational {
    Rational::from(from + to) / 2_u32
}

/// Bits enough for the width, by the size of the integral over the whole domain where that is known.
fn first_precision<const D: usize, const N: usize>(
    integrand: &impl Fn(&[Series<D, N>; D], u32) -> Option<Series<D, N>>,
    domain: &[(Rational, Rational); D],
    width: &Rational,
) -> u32 {
    let size = over_cell(integrand, domain, 64).abs().bounds().map_or_else(|| Rational::from(1), |(_, hi)| hi);
    let ratio = (size.max(Rational::from(1)) / width).ceil().into_numer_denom().0;
    64_u32.saturating_add(ratio.significant_bits())
}

/// Around the integral over a part.
fn over_cell<const D: usize, const N: usize>(
    integrand: &impl Fn(&[Series<D, N>; D], u32) -> Option<Series<D, N>>,
    domain: &[(Rational, Rational); D],
    precision: u32,
) -> Interval {
    let number = |x: &Rational| Interval::from_rational(x, precision);
    let middles = domain.each_ref().map(|side| number(&middle(side)));
    let halves = domain.each_ref().map(|(from, to)| number(&(Rational::from(to - from) / 2_u32)));
    let ranges = domain.each_ref().map(|(from, to)| Interval::between(from, to, precision).expect("in order"));
    let volume = halves.iter().fold(Interval::integer(1), |product, h| product * h);
    let Some(around) = integrand(&Series::variables(&ranges, &halves), precision) else {
        return Interval::everything(precision);
    };
    // ∫ 1 over −1 ≤ τᵢ ≤ 1 is 2ᴰ.
    let by_range = around.coefficient(&[0; D]).clone() * &Interval::integer(1 << D);
    let at_middle = integrand(&Series::variables(&middles, &halves), precision);
    let by_taylor = at_middle.map(|at_middle| taylor(&at_middle, &around, precision));
    let smaller = by_taylor.and_then(|taylor| taylor.intersection(&by_range)).unwrap_or(by_range);
    smaller * &volume
}

/// Σ fₖ(0) ∫τᵏ over |k| < N, and Σ fₖ(ξ) τᵏ over |k| = N integrated, where ξ depends on τ: fₖ(ξ)·τᵏ lies between the bounds of fₖ times
/// τᵏ where that is never negative, and within ± the largest |fₖ| times |τᵏ| elsewhere. All over −1 ≤ τᵢ ≤ 1.
fn taylor<const D: usize, const N: usize>(at_middle: &Series<D, N>, around: &Series<D, N>, precision: u32) -> Interval {
    multi_indices::<D, N>().iter().fold(Interval::integer(0), |sum, k| {
        let is_even = k.iter().all(|n| n % 2 == 0);
        // ∫ |τᵏ|
        let moment = k.iter().fold(Rational::from(1), |product, n| product * Rational::from((2, *n as u64 + 1)));
        let moment = Interval::from_rational(&moment, precision);
        match (k.iter().sum::<usize>() < N, is_even) {
            (true, true) => sum + &(at_middle.coefficient(k).clone() * &moment),
            (true, false) => sum,
            (false, true) => sum + &(around.coefficient(k).clone() * &moment),
            (false, false) => {
                let largest = around.coefficient(k).abs() * &moment;
                sum + &largest.hull(&-largest.clone())
            }
        }
    })
}

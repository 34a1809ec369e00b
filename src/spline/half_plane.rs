//! How much of a square a bicubic polynomial is negative on.

use super::enclosure::{between, exactly, quotient, square};
use crate::number::{F64Interval, Ring};

/// Around the area of {f < 0} in the unit square, for a bicubic f with these Bernstein coefficients, the first coordinate fastest.
///
/// f is a linear function l plus a remainder; l has the coefficients l(i/3, j/3), so the remainder lies in the hull of the differences, [e, E].
/// So {l < −E} ⊂ {f < 0} ⊂ {l < −e}, and the strip between has the width of the remainder, which is of second order.
pub fn share(b: &[F64Interval; 16]) -> F64Interval {
    let middle = |x: F64Interval| f64::midpoint(x.lo(), x.hi());
    let [low, right, up, far] = [b[0], b[3], b[12], b[15]].map(middle);
    // Any slopes will do; these are those of the corners.
    let slopes = [(right - low + far - up) / 2.0, (up - low + far - right) / 2.0];
    if !slopes.iter().all(|slope| slope.is_finite()) {
        return between(0.0, 1.0);
    }
    let rest = b.iter().enumerate().map(|(m, b)| *b - &linear(slopes, [m % 4, m / 4]));
    let (lo, hi) = rest.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), r| (lo.min(r.lo()), hi.max(r.hi())));
    // {s·x < −E}, and {s·x < −e}.
    between(below(slopes, -hi).lo(), below(slopes, -lo).hi())
}

/// s₁ i/3 + s₂ j/3.
fn linear(slopes: [f64; 2], place: [usize; 2]) -> F64Interval {
    let third = |n: usize| match n {
        0 | 3 => exactly(n as f64 / 3.0),
        n => between((n as f64 / 3.0).next_down(), (n as f64 / 3.0).next_up()),
    };
    exactly(slopes[0]) * &third(place[0]) + &(exactly(slopes[1]) * &third(place[1]))
}

/// Around the area of {(x, y) in the unit square: s₁x + s₂y < t}.
fn below([a, b]: [f64; 2], t: f64) -> F64Interval {
    // x ↦ 1 − x turns a slope's sign: s₁(1 − x) < t iff −s₁x < t − s₁.
    let mut t = exactly(t);
    for slope in [a, b].into_iter().filter(|slope| *slope < 0.0) {
        t = t - &exactly(slope);
    }
    let (small, large) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
    if large == 0.0 {
        // 0 < t, everywhere or nowhere.
        return between(f64::from(u8::from(t.lo() > 0.0)), f64::from(u8::from(t.hi() > 0.0)));
    }
    // The area rises with t.
    between(cut_off(small, large, t.lo()).lo(), cut_off(small, large, t.hi()).hi())
}

/// Around the area of {small·x + large·y < t}, 0 ≤ small ≤ large > 0.
fn cut_off(small: f64, large: f64, t: f64) -> F64Interval {
    let [zero, one, two] = [0, 1, 2].map(F64Interval::integer);
    let (s, l, x) = (exactly(small), exactly(large), exactly(t));
    let ratio = |x: F64Interval, y: F64Interval| quotient(x, y).unwrap_or(between(0.0, 1.0));
    let area = if t <= 0.0 {
        zero
    } else if t < small {
        // A triangle with the sides t/small and t/large.
        ratio(square(x), s * &l * &two)
    } else if t <= large {
        // A trapezium of heights t/large and (t − small)/large.
        ratio(x + &(x - &s), l * &two)
    } else {
        // All but a triangle at (1, 1), or all.
        let rest = s + &l - &x;
        if rest.hi() <= 0.0 { one } else { one - &ratio(square(rest), s * &l * &two) }
    };
    between(area.lo().clamp(0.0, 1.0), area.hi().clamp(0.0, 1.0))
}

//! Which sums of angles are rational multiples of π: decided exactly, whatever their radicands.

use super::direction::CornerAngle;
use crate::number::{Rational, Sign};

/// The sum of the angles divided by π, where that is rational; `None` iff it is irrational. What is rational is a
/// multiple of 1/12, and one angle alone is π/6, π/4, π/3, π/2, 2π/3, 3π/4 or 5π/6 (ME-123, ME-124).
///
/// It takes one pass a class of radicands whose sum is a multiple, and one that finds a class whose sum is none.
///
/// # Panics
/// Iff some N ≤ 0: that is no angle.
#[doc(alias = "ME-123")]
#[doc(alias = "ME-124")]
pub fn multiple_of_pi(angles: &[CornerAngle]) -> Option<Rational> {
    // Let two radicands be of one class if their quotient is the square of a rational; a class is a field ℚ(√−N). If
    // Θ, the sum of the class's angles, is a rational multiple of π for each class, so is the sum of all. The converse:
    //
    // U = exp(2iΘ) = w/w̄ is in the field of its class, w being a product of directions, and |U| = 1. Suppose that the
    // product of U₁, …, U_k, of different fields, is a root of unity ζ. Let G be the Galois group over ℚ of the field of
    // all √−Nⱼ. It maps √−Nⱼ to εⱼ(σ)√−Nⱼ, εⱼ(σ) = ±1, so Uⱼ to itself or to its conjugate: to Uⱼ^εⱼ(σ). Hence
    //     Π_j Uⱼ^εⱼ(σ) = σ(ζ)   for each σ in G,
    //     Π_σ Π_j Uⱼ^(εⱼ(σ)ε₁(σ)) = U₁^|G|,
    // for different fields have different characters εⱼ, and these are orthogonal: Σ_σ εⱼ(σ)ε₁(σ) is 0 for j ≠ 1. The
    // left side is a product of σ(ζ)^±1, so U₁ is a root of unity, and so is every Uⱼ. QED.
    //
    // A quadratic field ℚ(√−N) has the roots of unity ±1, with ±i if N is a square, and those of order 6 if 3N is:
    // Θ is a multiple of π/2, of π/4, of π/6.
    assert!(angles.iter().all(|angle| angle.n > 0), "the direction of an angle in (0, π) has N > 0");
    let mut rest: Vec<&CornerAngle> = angles.iter().collect();
    let mut sum = Rational::new();
    while let Some(first) = rest.first() {
        let n = &first.n;
        let mut of_class = Vec::new();
        rest.retain(|angle| match square_root(&Rational::from(&angle.n / n)) {
            // x + √(r²N) i has the direction of x/r + √N i.
            Some(r) => {
                of_class.push(&angle.x / r);
                false
            }
            None => true,
        });
        sum += AngleSum::of(&of_class, n).over_pi(n)?;
    }
    Some(sum)
}

/// The sum half_turns·π + θ, 0 ≤ θ < π, of angles of directions x + √N i with one N.
struct AngleSum {
    half_turns: i64,
    theta: Theta,
}

/// An angle in [0, π).
enum Theta {
    Zero,
    /// That of the direction c + √N i: c = √N cot θ.
    Over(Rational),
}

impl AngleSum {
    /// The sum of the angles of x + √N i, by halves: many numbers of one size cost less than one that grows.
    fn of(directions: &[Rational], n: &Rational) -> AngleSum {
        match directions {
            [] => AngleSum { half_turns: 0, theta: Theta::Zero },
            [x] => AngleSum { half_turns: 0, theta: Theta::Over(x.clone()) },
            _ => {
                let (left, right) = directions.split_at(directions.len() / 2);
                AngleSum::of(left, n).plus(AngleSum::of(right, n), n)
            }
        }
    }

    fn plus(self, other: AngleSum, n: &Rational) -> AngleSum {
        let half_turns = self.half_turns + other.half_turns;
        let (c, d) = match (self.theta, other.theta) {
            (Theta::Zero, theta) | (theta, Theta::Zero) => return AngleSum { half_turns, theta },
            (Theta::Over(c), Theta::Over(d)) => (c, d),
        };
        // (c + √N i)(d + √N i) = cd − N + (c + d)√N i, of an argument between 0 and 2π.
        let (re, im) = (Rational::from(&c * &d) - n, c + d);
        match Sign::of(im.cmp0()) {
            Sign::Positive => AngleSum { half_turns, theta: Theta::Over(re / im) },
            Sign::Zero => AngleSum { half_turns: half_turns + 1, theta: Theta::Zero },
            Sign::Negative => AngleSum { half_turns: half_turns + 1, theta: Theta::Over(re / im) },
        }
    }

    /// The sum divided by π; `None` iff that is irrational.
    fn over_pi(&self, n: &Rational) -> Option<Rational> {
        let theta = match &self.theta {
            Theta::Zero => Rational::new(),
            Theta::Over(c) => {
                let acute = acute_over_pi(&Rational::from(c.square_ref()), n)?;
                if *c < 0 { Rational::from(1) - acute } else { acute }
            }
        };
        Some(theta + self.half_turns)
    }
}

/// The angle θ in (0, π/2] with cot²θ = c²/N, divided by π; `None` iff that is irrational.
fn acute_over_pi(c_squared: &Rational, n: &Rational) -> Option<Rational> {
    let known = |p: i64, q: i64| Rational::from((p, q));
    // cot² is 0, 1/3, 1 or 3.
    if c_squared.is_zero() {
        Some(known(1, 2))
    } else if Rational::from(c_squared * 3) == *n {
        Some(known(1, 3))
    } else if c_squared == n {
        Some(known(1, 4))
    } else if *c_squared == Rational::from(n * 3) {
        Some(known(1, 6))
    } else {
        None
    }
}

/// √q, where that is rational.
fn square_root(q: &Rational) -> Option<Rational> {
    let (numerator, denominator) = (q.numer(), q.denom());
    let is_square = numerator.is_perfect_square() && denominator.is_perfect_square();
    is_square.then(|| Rational::from((numerator.clone().sqrt(), denominator.clone().sqrt())))
}

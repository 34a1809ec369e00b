//! The angle of a triangle's corner as a direction over ℚ(√−N).

use crate::number::{Interval, Rational, Sign};

/// The angle of a triangle's corner, in (0, π): that of the direction x + √N i. Not ordered, nor compared: the same
/// angle has many directions.
#[derive(Clone, Debug)]
pub struct CornerAngle {
    /// x = ⟨p,q⟩ for the sides p, q from the corner.
    pub x: Rational,
    /// N = |p×q|² > 0.
    pub n: Rational,
}

impl CornerAngle {
    /// The sign of the cosine, that of x: positive for an acute angle.
    pub fn cos_sign(&self) -> Sign {
        Sign::of(self.x.cmp0())
    }

    /// cos² = x²/(x² + N), for |p|²|q|² = ⟨p,q⟩² + |p×q|².
    pub fn cos_squared(&self) -> Rational {
        let x_squared = Rational::from(self.x.square_ref());
        let product_of_squared_sides = Rational::from(&x_squared + &self.n);
        x_squared / product_of_squared_sides
    }

    /// An enclosure of the angle in radians, of that many bits.
    pub fn enclosure(&self, precision: u32) -> Interval {
        let y = Interval::from_rational(&self.n, precision).sqrt().expect("N > 0");
        Interval::argument(&Interval::from_rational(&self.x, precision), &y).expect("√N > 0")
    }
}

/// What the three angles of a triangle sum up to, as a number of half turns π: it is 1, and this proves it for the
/// triangle. `None` iff the angles, not being those of a triangle, sum up to no multiple of π. ME-122.
///
/// With xᵢ + √N i for the angles, the product is x₀x₁x₂ − N(x₀+x₁+x₂) + (x₀x₁ + x₁x₂ + x₂x₀ − N)√N i. It is real iff
/// the sum is a multiple of π; each angle is in (0, π), so the sum is π if it is negative, 2π if it is positive.
///
/// # Panics
/// Iff the three N are not equal.
#[doc(alias = "ME-122")]
pub fn half_turns([a, b, c]: &[CornerAngle; 3]) -> Option<i64> {
    assert!(a.n == b.n && b.n == c.n, "the corners of one triangle have one N");
    let (x0, x1, x2, n) = (&a.x, &b.x, &c.x, &a.n);
    let product = |x: &Rational, y: &Rational| Rational::from(x * y);
    let imaginary = product(x0, x1) + product(x1, x2) + product(x2, x0) - n;
    let real = product(x0, x1) * x2 - (Rational::from(x0 + x1) + x2) * n;
    match (Sign::of(imaginary.cmp0()), Sign::of(real.cmp0())) {
        (Sign::Zero, Sign::Negative) => Some(1),
        (Sign::Zero, Sign::Positive) => Some(2),
        (Sign::Zero, Sign::Zero) => unreachable!("no factor of the product is 0"),
        (Sign::Negative | Sign::Positive, _) => None,
    }
}

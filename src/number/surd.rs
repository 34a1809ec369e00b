//! ℚ(√d): the numbers a + b√d, exactly ordered, whatever their radicands.

use super::decimal::{DecimalEnclosure, Digits};
use super::radicand::Radicand;
use super::{Enclosure, Integer, Interval, OrderedField, Rational, Ring, Sign};
use std::cmp::Ordering;
use std::fmt::{self, Display, Formatter};
use std::ops::{Add, Mul, Neg, Sub};
use thiserror::Error;

/// A real number a + b√d with rational a, b and an integer d ≥ 1.
///
/// Normal form: d is 1 iff b = 0, else d is no perfect square, and square-free as far as
/// [`Surd::radicand_is_proven_square_free`] says. Equality and order are those of the real numbers, for any
/// two radicands, and rest on d being no perfect square alone (NU-10).
///
/// The operators `+ - *` are defined for two numbers of the same field, or where one is rational. For numbers
/// of different fields, whose sum is in neither, use the `checked_…` functions: the operators panic on them.
#[derive(Clone, Debug)]
#[doc(alias = "NU-10")]
pub struct Surd {
    a: Rational,
    b: Rational,
    d: Radicand,
}

/// Why there is no such element of ℚ(√d).
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SurdError {
    /// √ of a negative number.
    #[error("the radicand {radicand} is negative")]
    NegativeRadicand {
        /// The negative number.
        radicand: Rational,
    },
    /// The two numbers lie in different quadratic fields.
    #[error("√{left} and √{right} are of different fields")]
    DifferentFields {
        /// The radicand of the left operand.
        left: Integer,
        /// The radicand of the right operand.
        right: Integer,
    },
    /// Division by zero.
    #[error("division by zero")]
    DivisionByZero,
}

impl Surd {
    /// a + b√r, in normal form: √(p/q) = √(pq)/q, and squares leave the root. NU-11.
    ///
    /// # Errors
    /// `NegativeRadicand` iff r < 0.
    #[doc(alias = "NU-11")]
    pub fn new(a: Rational, b: Rational, r: &Rational) -> Result<Surd, SurdError> {
        let (s, d) = Radicand::of_root(r).ok_or_else(|| SurdError::NegativeRadicand { radicand: r.clone() })?;
        Ok(if d.is_one() { Surd::from(a + b * s) } else { Surd::normal(a, b * s, d) })
    }

    /// √r. NU-11.
    ///
    /// # Errors
    /// `NegativeRadicand` iff r < 0.
    pub fn sqrt(r: &Rational) -> Result<Surd, SurdError> {
        Surd::new(Rational::new(), Rational::from(1), r)
    }

    /// (a, b, d): the number is a + b√d.
    pub fn parts(&self) -> (&Rational, &Rational, &Integer) {
        (&self.a, &self.b, self.d.value())
    }

    /// The number, where it is rational.
    pub fn rational(&self) -> Option<&Rational> {
        (self.d.is_one()).then_some(&self.a)
    }

    /// Whether d is known to have no square factor. Squares of primes up to 2¹⁶ always leave the root; with
    /// them gone, the numerator's and the denominator's rests are certified below 2⁴⁸ each. A `false` means
    /// "not known": it changes no comparison, only whether d is the least possible one.
    pub fn radicand_is_proven_square_free(&self) -> bool {
        self.d.is_proven_square_free()
    }

    /// a − b√d.
    pub fn conjugate(&self) -> Surd {
        Surd { a: self.a.clone(), b: Rational::from(-&self.b), d: self.d.clone() }
    }

    /// (a + b√d)(a − b√d) = a² − b²d. NU-12.
    pub fn norm(&self) -> Rational {
        Rational::from(self.a.square_ref()) - self.square_of_irrational_part()
    }

    /// The sum. NU-12.
    ///
    /// # Errors
    /// `DifferentFields`.
    #[doc(alias = "NU-12")]
    pub fn checked_add(&self, other: &Surd) -> Result<Surd, SurdError> {
        let (b, c, d) = self.aligned(other)?;
        Ok(Surd::normal(Rational::from(&self.a + &other.a), b + c, d))
    }

    /// The difference. NU-12.
    ///
    /// # Errors
    /// `DifferentFields`.
    pub fn checked_sub(&self, other: &Surd) -> Result<Surd, SurdError> {
        let (b, c, d) = self.aligned(other)?;
        Ok(Surd::normal(Rational::from(&self.a - &other.a), b - c, d))
    }

    /// The product (a₁ + b₁√d)(a₂ + b₂√d) = (a₁a₂ + b₁b₂d) + (a₁b₂ + b₁a₂)√d. NU-12.
    ///
    /// # Errors
    /// `DifferentFields`.
    pub fn checked_mul(&self, other: &Surd) -> Result<Surd, SurdError> {
        let (b, c, d) = self.aligned(other)?;
        let a = Rational::from(&self.a * &other.a) + Rational::from(&b * &c) * d.value();
        Ok(Surd::normal(a, Rational::from(&self.a * &c) + b * &other.a, d))
    }

    /// The quotient. NU-12.
    ///
    /// # Errors
    /// `DivisionByZero`, `DifferentFields`.
    pub fn checked_div(&self, other: &Surd) -> Result<Surd, SurdError> {
        self.checked_mul(&other.inverse().ok_or(SurdError::DivisionByZero)?)
    }

    /// An enclosure of the number, of that many bits: a + b·√d with each step rounded outward.
    pub fn enclosure(&self, precision: u32) -> Interval {
        let part = |x: &Rational| Interval::from_rational(x, precision);
        let root = Interval::from_integer(self.d.value(), precision).sqrt().expect("a radicand is positive");
        part(&self.a) + &(part(&self.b) * &root)
    }

    /// Decimal strings around the number, as narrow as asked for.
    pub fn decimals(&self, digits: Digits) -> DecimalEnclosure {
        // Each doubling halves the width at least, so one precision is enough in the end.
        let mut precision = 64 + 4 * digits.count();
        loop {
            match self.enclosure(precision).decimals(digits) {
                Some(enclosure) => return enclosure,
                None => precision *= 2,
            }
        }
    }

    fn normal(a: Rational, b: Rational, d: Radicand) -> Surd {
        let d = if b.is_zero() { Radicand::one() } else { d };
        Surd { a, b, d }
    }

    /// The two irrational parts over one radicand: b√d and c√d.
    fn aligned(&self, other: &Surd) -> Result<(Rational, Rational, Radicand), SurdError> {
        let (b, c) = (self.b.clone(), other.b.clone());
        if other.d.is_one() || self.d == other.d {
            return Ok((b, c, self.d.clone()));
        }
        if self.d.is_one() {
            return Ok((b, c, other.d.clone()));
        }
        match self.d.root_ratio(&other.d) {
            // √(other.d) = ratio·√(self.d)
            Some(ratio) => Ok((b, c * ratio, self.d.clone())),
            None => Err(SurdError::DifferentFields { left: self.d.value().clone(), right: other.d.value().clone() }),
        }
    }

    /// b²d.
    fn square_of_irrational_part(&self) -> Rational {
        Rational::from(self.b.square_ref()) * self.d.value()
    }
}

/// The sign of x + y, by the signs of x and y and, where they are opposite, that of x² − y².
fn sign_of_sum(x: Sign, y: Sign, of_squares: impl FnOnce() -> Sign) -> Sign {
    match (x, y) {
        (Sign::Zero, y) => y,
        (x, Sign::Zero) => x,
        (Sign::Negative, Sign::Negative) | (Sign::Positive, Sign::Positive) => x,
        (Sign::Negative, Sign::Positive) | (Sign::Positive, Sign::Negative) => x * of_squares(),
    }
}

impl Enclosure for Surd {
    fn known_sign(&self) -> Option<Sign> {
        Some(sign_of_sum(Sign::of(self.a.cmp0()), Sign::of(self.b.cmp0()), || Sign::of(self.norm().cmp0())))
    }
}

impl OrderedField for Surd {
    fn inverse(&self) -> Option<Surd> {
        // 1/(a + b√d) = (a − b√d)/(a² − b²d); the norm is 0 for 0 alone, since √d is irrational.
        let n = self.norm();
        (!n.is_zero())
            .then(|| Surd::normal(Rational::from(&self.a / &n), -Rational::from(&self.b / &n), self.d.clone()))
    }
}

impl Ord for Surd {
    fn cmp(&self, other: &Surd) -> Ordering {
        // self − other = x + y with x = (a₁ − a₂) + b₁√d₁ and y = −b₂√d₂: y² is rational, so x² − y² is in ℚ(√d₁).
        let x = Surd { a: Rational::from(&self.a - &other.a), b: self.b.clone(), d: self.d.clone() };
        let y = -Sign::of(other.b.cmp0());
        let squares = || (x.clone() * &x - &Surd::from(other.square_of_irrational_part())).sign();
        sign_of_sum(x.sign(), y, squares).value().cmp(&0)
    }
}

impl PartialOrd for Surd {
    fn partial_cmp(&self, other: &Surd) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Surd {
    fn eq(&self, other: &Surd) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Surd {}

impl From<Rational> for Surd {
    fn from(a: Rational) -> Surd {
        Surd { a, b: Rational::new(), d: Radicand::one() }
    }
}

impl Ring for Surd {
    fn integer(n: i64) -> Surd {
        Surd::from(Rational::from(n))
    }
}

const SAME_FIELD: &str = "the operators are defined within one quadratic field; use the checked ones across two";

/// # Panics
/// Where the operands lie in different fields.
impl Add<&Surd> for Surd {
    type Output = Surd;
    fn add(self, other: &Surd) -> Surd {
        self.checked_add(other).expect(SAME_FIELD)
    }
}

/// # Panics
/// Where the operands lie in different fields.
impl Sub<&Surd> for Surd {
    type Output = Surd;
    fn sub(self, other: &Surd) -> Surd {
        self.checked_sub(other).expect(SAME_FIELD)
    }
}

/// # Panics
/// Where the operands lie in different fields.
impl Mul<&Surd> for Surd {
    type Output = Surd;
    fn mul(self, other: &Surd) -> Surd {
        self.checked_mul(other).expect(SAME_FIELD)
    }
}

impl Neg for Surd {
    type Output = Surd;
    fn neg(self) -> Surd {
        Surd { a: -self.a, b: -self.b, d: self.d }
    }
}

/// `7/3 - 2/5·√2`; no zero terms, and no factor 1.
impl Display for Surd {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.d.is_one() {
            return write!(f, "{}", self.a);
        }
        match (self.a.is_zero(), self.b.cmp0()) {
            (true, Ordering::Less) => write!(f, "-")?,
            (true, Ordering::Equal | Ordering::Greater) => {}
            (false, Ordering::Less) => write!(f, "{} - ", self.a)?,
            (false, Ordering::Equal | Ordering::Greater) => write!(f, "{} + ", self.a)?,
        }
        let b = Rational::from(self.b.abs_ref());
        if b != 1 {
            write!(f, "{b}·")?;
        }
        write!(f, "√{}", self.d.value())
    }
}

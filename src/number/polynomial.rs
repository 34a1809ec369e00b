//! Polynomials in one variable over the rationals.

use super::{Integer, Rational, Ring};
use std::fmt::{self, Display, Formatter};
use std::ops::{Add, Mul, Neg, Sub};

/// a₀ + a₁x + … + aₙxⁿ with rational coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial {
    /// The constant first, the last one not 0; empty is the zero polynomial.
    coefficients: Vec<Rational>,
}

impl Polynomial {
    /// From its coefficients, the constant first; zeros at the end are dropped.
    pub fn new(mut coefficients: Vec<Rational>) -> Polynomial {
        while coefficients.last().is_some_and(Rational::is_zero) {
            coefficients.pop();
        }
        Polynomial { coefficients }
    }

    /// x − r.
    pub fn with_root(r: &Rational) -> Polynomial {
        Polynomial::new(vec![Rational::from(-r), Rational::from(1)])
    }

    /// The coefficients, the constant first, the last one not 0; none for the zero polynomial.
    pub fn coefficients(&self) -> &[Rational] {
        &self.coefficients
    }

    /// The degree; `None` for the zero polynomial.
    pub fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// Whether it is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The value at x, by Horner's rule.
    pub fn evaluate(&self, x: &Rational) -> Rational {
        self.coefficients.iter().rev().fold(Rational::new(), |value, a| value * x + a)
    }

    /// The derivative a₁ + 2a₂x + … + naₙxⁿ⁻¹.
    pub fn derivative(&self) -> Polynomial {
        let of_powers = self.coefficients.iter().enumerate().skip(1);
        Polynomial { coefficients: of_powers.map(|(k, a)| Rational::from(a * Integer::from(k))).collect() }
    }

    /// (q, r) with self = q·divisor + r and r of smaller degree than the divisor; `None` iff that is zero.
    pub fn divide(&self, divisor: &Polynomial) -> Option<(Polynomial, Polynomial)> {
        let leading = divisor.coefficients.last()?;
        let mut rest = self.coefficients.clone();
        let mut quotient = Vec::new();
        while rest.len() >= divisor.coefficients.len() {
            let factor = rest.pop().expect("not shorter than the divisor, which is not empty") / leading;
            let shift = rest.len() + 1 - divisor.coefficients.len();
            for (a, b) in rest.iter_mut().skip(shift).zip(&divisor.coefficients) {
                *a -= Rational::from(&factor * b);
            }
            quotient.push(factor);
        }
        quotient.reverse();
        Some((Polynomial::new(quotient), Polynomial::new(rest)))
    }

    /// The multiple by a positive rational whose coefficients are integers without a common factor.
    pub fn primitive(&self) -> Polynomial {
        let denominators = self.coefficients.iter().fold(Integer::from(1), |l, a| l.lcm(a.denom()));
        let numerators = self.coefficients.iter().fold(Integer::new(), |g, a| g.gcd(a.numer()));
        if numerators.is_zero() {
            return self.clone();
        }
        // gcd(aᵢ) = gcd(numerators)/lcm(denominators), as each aᵢ is in lowest terms.
        let content = Rational::from((numerators, denominators));
        Polynomial { coefficients: self.coefficients.iter().map(|a| Rational::from(a / &content)).collect() }
    }

    /// The greatest common divisor, primitive with a positive leading coefficient; 0 iff both are 0. NU-14.
    #[doc(alias = "NU-14")]
    pub fn gcd(&self, other: &Polynomial) -> Polynomial {
        let (mut a, mut b) = (self.primitive(), other.primitive());
        while let Some((_, remainder)) = a.divide(&b) {
            // Euclid; only the remainder's multiples matter, and primitive ones stay small.
            (a, b) = (b, remainder.primitive());
        }
        match a.coefficients.last() {
            Some(leading) if leading.cmp0().is_lt() => -a,
            Some(_) | None => a,
        }
    }

    /// p / gcd(p, p′), primitive: the same complex roots, each of them simple. 0 for 0. NU-14.
    pub fn square_free(&self) -> Polynomial {
        match self.divide(&self.gcd(&self.derivative())) {
            Some((quotient, _)) => quotient.primitive(),
            None => self.clone(),
        }
    }

    /// A power of two B such that every complex root z has |z| < B: Cauchy's 1 + max |aᵢ/aₙ|, rounded up. NU-16.
    pub fn root_bound(&self) -> Rational {
        let Some((leading, others)) = self.coefficients.split_last() else { return Rational::from(1) };
        let largest = others.iter().map(|a| Rational::from(a / leading).abs()).max().unwrap_or_default();
        let bound = (largest + 1_u32).ceil().into_numer_denom().0;
        // 2^bits(n) > n
        Rational::from(Integer::from(1) << bound.significant_bits())
    }
}

impl Add<&Polynomial> for Polynomial {
    type Output = Polynomial;
    fn add(mut self, other: &Polynomial) -> Polynomial {
        let length = self.coefficients.len().max(other.coefficients.len());
        self.coefficients.resize(length, Rational::new());
        for (a, b) in self.coefficients.iter_mut().zip(&other.coefficients) {
            *a += b;
        }
        Polynomial::new(self.coefficients)
    }
}

impl Sub<&Polynomial> for Polynomial {
    type Output = Polynomial;
    fn sub(self, other: &Polynomial) -> Polynomial {
        -(-self + other)
    }
}

impl Mul<&Polynomial> for Polynomial {
    type Output = Polynomial;
    fn mul(self, other: &Polynomial) -> Polynomial {
        let mut product = vec![Rational::new(); self.coefficients.len() + other.coefficients.len()];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (j, b) in other.coefficients.iter().enumerate() {
                product[i + j] += Rational::from(a * b);
            }
        }
        Polynomial::new(product)
    }
}

impl Neg for Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        Polynomial { coefficients: self.coefficients.into_iter().map(|a| -a).collect() }
    }
}

impl Ring for Polynomial {
    fn integer(n: i64) -> Polynomial {
        Polynomial::new(vec![Rational::from(n)])
    }
}

/// `1/2 + 3·x - x^2`; the zero polynomial is `0`.
impl Display for Polynomial {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut is_first = true;
        for (k, a) in self.coefficients.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
            let sign = match (is_first, a.cmp0().is_lt()) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            };
            let power = match k {
                0 => String::new(),
                1 => "x".to_string(),
                _ => format!("x^{k}"),
            };
            let a = Rational::from(a.abs_ref());
            match (k, a == 1) {
                (0, _) => write!(f, "{sign}{a}")?,
                (_, true) => write!(f, "{sign}{power}")?,
                (_, false) => write!(f, "{sign}{a}·{power}")?,
            }
            is_first = false;
        }
        if is_first { write!(f, "0") } else { Ok(()) }
    }
}

//! Piecewise polynomials on the line, over ℚ and with exact breakpoints.

use crate::number::{Integer, Polynomial, Rational};
use std::ops::{Add, Sub};
use thiserror::Error;

/// A function that is a polynomial on each of (−∞, b₁], (b₁, b₂], …, (b_m, ∞).
///
/// At a breakpoint it takes the value from the left, as the box of (−½, ½] does. Breakpoints at which the polynomial does
/// not change are left out, so that equal functions are equal records. SP-20.
#[derive(Clone, Debug, PartialEq, Eq)]
#[doc(alias = "SP-20")]
pub struct Piecewise {
    breaks: Vec<Rational>,
    /// One more than breakpoints.
    pieces: Vec<Polynomial>,
}

/// How often a piecewise polynomial is continuously differentiable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Smoothness {
    /// Some piece does not meet the next one.
    Discontinuous,
    /// C^r, and not C^(r+1).
    Times(usize),
    /// One polynomial.
    Infinite,
}

/// Why there is no such piecewise polynomial.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum PiecewiseError {
    /// The pieces are not one more than the breakpoints.
    #[error("{breaks} breakpoints separate {} pieces, found {pieces}", breaks + 1)]
    Pieces {
        /// How many breakpoints there are.
        breaks: usize,
        /// How many pieces.
        pieces: usize,
    },
    /// The breakpoints do not increase.
    #[error("breaks[{index}]: {found} is not above the breakpoint before it")]
    Unordered {
        /// Which one.
        index: usize,
        /// The breakpoint.
        found: Rational,
    },
    /// A factor of a convolution has no first breakpoint before which it is 0.
    #[error("the convolution is defined for functions that are 0 far to the left")]
    Unbounded,
}

impl Piecewise {
    /// # Errors
    /// `Pieces`, `Unordered`: iff the pieces are not one more than the breakpoints, or these do not increase.
    pub fn new(breaks: Vec<Rational>, pieces: Vec<Polynomial>) -> Result<Piecewise, PiecewiseError> {
        if pieces.len() != breaks.len() + 1 {
            return Err(PiecewiseError::Pieces { breaks: breaks.len(), pieces: pieces.len() });
        }
        match (1..breaks.len()).find(|&i| breaks[i - 1] >= breaks[i]) {
            Some(index) => Err(PiecewiseError::Unordered { index, found: breaks[index].clone() }),
            None => Ok(Piecewise::normal(breaks, pieces)),
        }
    }

    /// One polynomial everywhere.
    pub fn polynomial(p: Polynomial) -> Piecewise {
        Piecewise { breaks: Vec::new(), pieces: vec![p] }
    }

    /// 0.
    pub fn zero() -> Piecewise {
        Piecewise::polynomial(Polynomial::new(Vec::new()))
    }

    /// (x − at)ⁿ₊: the power for x > at, else 0.
    pub fn truncated_power(at: &Rational, n: usize) -> Piecewise {
        let power =
            (0..n).fold(Polynomial::new(vec![Rational::from(1)]), |power, _| power * &Polynomial::with_root(at));
        Piecewise { breaks: vec![at.clone()], pieces: vec![Polynomial::new(Vec::new()), power] }
    }

    /// The breakpoints, increasing; at each the polynomial changes.
    pub fn breaks(&self) -> &[Rational] {
        &self.breaks
    }

    /// The polynomials, from left to right.
    pub fn pieces(&self) -> &[Polynomial] {
        &self.pieces
    }

    /// The polynomial to the left of x, and at x.
    pub fn piece_at(&self, x: &Rational) -> &Polynomial {
        &self.pieces[self.breaks.partition_point(|b| b < x)]
    }

    /// f(x); at a breakpoint, the value from the left.
    pub fn evaluate(&self, x: &Rational) -> Rational {
        self.piece_at(x).evaluate(x)
    }

    /// x ↦ f(x − a).
    pub fn shifted(&self, a: &Rational) -> Piecewise {
        Piecewise {
            breaks: self.breaks.iter().map(|b| Rational::from(b + a)).collect(),
            pieces: self.pieces.iter().map(|p| shifted(p, a)).collect(),
        }
    }

    /// p·f.
    pub fn times(&self, p: &Polynomial) -> Piecewise {
        Piecewise::normal(self.breaks.clone(), self.pieces.iter().map(|piece| piece.clone() * p).collect())
    }

    /// k·f.
    pub fn scaled(&self, k: &Rational) -> Piecewise {
        self.times(&Polynomial::new(vec![k.clone()]))
    }

    /// f′ where f has a derivative; at a breakpoint, the derivative from the left.
    pub fn derivative(&self) -> Piecewise {
        Piecewise::normal(self.breaks.clone(), self.pieces.iter().map(Polynomial::derivative).collect())
    }

    /// The continuous function whose derivative is f off the breakpoints, and whose first piece has no constant term.
    pub fn antiderivative(&self) -> Piecewise {
        let mut pieces: Vec<Polynomial> = Vec::with_capacity(self.pieces.len());
        for (i, piece) in self.pieces.iter().enumerate() {
            let integral = integral(piece);
            // The constant that joins it to the piece before.
            let step = i.checked_sub(1).map_or_else(Rational::new, |left| {
                pieces[left].evaluate(&self.breaks[left]) - integral.evaluate(&self.breaks[left])
            });
            pieces.push(integral + &Polynomial::new(vec![step]));
        }
        Piecewise::normal(self.breaks.clone(), pieces)
    }

    /// f ⋆ B₀ (x) = ∫ f(t)B₀(x − t) dt = F(x + ½) − F(x − ½), F′ = f, for the box B₀ of (−½, ½]. SP-19.
    #[doc(alias = "SP-19")]
    pub fn averaged(&self) -> Piecewise {
        let (integral, half) = (self.antiderivative(), Rational::from((1, 2)));
        integral.shifted(&Rational::from(-&half)) - &integral.shifted(&half)
    }

    /// f ⋆ g (x) = ∫ f(t)g(x − t) dt of two functions that are 0 far to the left. SP-20.
    ///
    /// Each is a sum of truncated powers, and (x − a)ᵐ₊ ⋆ (x − b)ⁿ₊ = m! n!/(m + n + 1)! · (x − a − b)ᵐ⁺ⁿ⁺¹₊ (Euler's beta
    /// integral).
    ///
    /// # Errors
    /// `Unbounded`.
    pub fn convolve(&self, other: &Piecewise) -> Result<Piecewise, PiecewiseError> {
        let (left, right) = (self.truncated_powers(), other.truncated_powers());
        let (left, right) = (left.ok_or(PiecewiseError::Unbounded)?, right.ok_or(PiecewiseError::Unbounded)?);
        let mut sum = Piecewise::zero();
        for (a, m, alpha) in &left {
            for (b, n, beta) in &right {
                let numerator = factorial(*m) * factorial(*n);
                let factor = Rational::from((numerator, factorial(m + n + 1))) * alpha * beta;
                sum = sum + &Piecewise::truncated_power(&Rational::from(a + b), m + n + 1).scaled(&factor);
            }
        }
        Ok(sum)
    }

    /// The (b, n, a) with f = Σ a(x − b)ⁿ₊, a ≠ 0; `None` iff f is not 0 far to the left.
    pub fn truncated_powers(&self) -> Option<Vec<(Rational, usize, Rational)>> {
        if !self.pieces[0].is_zero() {
            return None;
        }
        let terms = (0..self.breaks.len()).flat_map(|i| {
            let jump = self.jump(i);
            let terms = jump.coefficients().iter().enumerate().filter(|(_, a)| !a.is_zero());
            terms.map(|(n, a)| (self.breaks[i].clone(), n, a.clone())).collect::<Vec<_>>()
        });
        Some(terms.collect())
    }

    /// How often f is continuously differentiable: at a breakpoint where the polynomial changes by a(x − b)ⁿ + …, a ≠ 0, it is
    /// n − 1 times. SP-8, SP-24, SP-50.
    #[doc(alias = "SP-8")]
    #[doc(alias = "SP-24")]
    #[doc(alias = "SP-50")]
    pub fn smoothness(&self) -> Smoothness {
        let order = |i| self.jump(i).coefficients().iter().take_while(|a| a.is_zero()).count();
        match (0..self.breaks.len()).map(order).min() {
            None => Smoothness::Infinite,
            Some(0) => Smoothness::Discontinuous,
            Some(order) => Smoothness::Times(order - 1),
        }
    }

    /// The least closed interval that f is 0 outside of; `None` iff it is not 0 on both sides, or 0 everywhere. SP-26.
    #[doc(alias = "SP-26")]
    pub fn support(&self) -> Option<(&Rational, &Rational)> {
        let ends_in_zero = self.pieces[0].is_zero() && self.pieces[self.pieces.len() - 1].is_zero();
        ends_in_zero.then_some(self.breaks.first().zip(self.breaks.last())).flatten()
    }

    /// ∫ f over ℝ; `None` iff f is not 0 on both sides.
    pub fn integral(&self) -> Option<Rational> {
        let Some((first, last)) = self.support() else {
            return (*self == Piecewise::zero()).then(Rational::new);
        };
        let integral = self.antiderivative();
        Some(integral.evaluate(last) - integral.evaluate(first))
    }

    /// How the polynomial changes at a breakpoint b: right less left, in powers of x − b.
    fn jump(&self, i: usize) -> Polynomial {
        shifted(&(self.pieces[i + 1].clone() - &self.pieces[i]), &Rational::from(-&self.breaks[i]))
    }

    fn normal(breaks: Vec<Rational>, pieces: Vec<Polynomial>) -> Piecewise {
        let mut pieces = pieces.into_iter();
        let first = pieces.next().expect("one more piece than breakpoints");
        let mut normal = Piecewise::polynomial(first);
        for (b, piece) in breaks.into_iter().zip(pieces) {
            if normal.pieces.last() != Some(&piece) {
                normal.breaks.push(b);
                normal.pieces.push(piece);
            }
        }
        normal
    }

    fn piecewise(&self, other: &Piecewise, combine: impl Fn(Polynomial, &Polynomial) -> Polynomial) -> Piecewise {
        let mut breaks: Vec<Rational> = self.breaks.iter().chain(&other.breaks).cloned().collect();
        breaks.sort();
        breaks.dedup();
        let last = |f: &Piecewise| f.pieces[f.pieces.len() - 1].clone();
        let mut pieces: Vec<Polynomial> =
            breaks.iter().map(|b| combine(self.piece_at(b).clone(), other.piece_at(b))).collect();
        pieces.push(combine(last(self), &last(other)));
        Piecewise::normal(breaks, pieces)
    }
}

impl Add<&Piecewise> for Piecewise {
    type Output = Piecewise;
    fn add(self, other: &Piecewise) -> Piecewise {
        self.piecewise(other, |a, b| a + b)
    }
}

impl Sub<&Piecewise> for Piecewise {
    type Output = Piecewise;
    fn sub(self, other: &Piecewise) -> Piecewise {
        self.piecewise(other, |a, b| a - b)
    }
}

/// p(x − a), by Horner's rule.
fn shifted(p: &Polynomial, a: &Rational) -> Polynomial {
    let x = Polynomial::with_root(a);
    let of = |a: &Rational| Polynomial::new(vec![a.clone()]);
    p.coefficients().iter().rev().fold(Polynomial::new(Vec::new()), |value, a| value * &x + &of(a))
}

/// ∫₀ˣ p.
fn integral(p: &Polynomial) -> Polynomial {
    let powers = p.coefficients().iter().enumerate().map(|(k, a)| Rational::from(a / Integer::from(k + 1)));
    Polynomial::new(std::iter::once(Rational::new()).chain(powers).collect())
}

pub(super) fn factorial(n: usize) -> Integer {
    (1..=n).fold(Integer::from(1), |product, k| product * Integer::from(k))
}

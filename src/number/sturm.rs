//! Sturm's theorem: how many real roots a polynomial has in an interval.

use super::{Polynomial, Rational, Sign};

/// The Sturm chain of a polynomial's square-free part: p₀ = p, p₁ = p′, pᵢ₊₁ = −(pᵢ₋₁ mod pᵢ), up to positive factors.
///
/// With V(x) the number of changes of sign in p₀(x), p₁(x), …, zeros left out, V(a) − V(b) is the number of different
/// roots in a < x ≤ b (NU-15). Since p is square-free, a and b may be roots themselves.
#[derive(Clone, Debug)]
#[doc(alias = "NU-15")]
pub struct SturmChain {
    chain: Vec<Polynomial>,
}

impl SturmChain {
    /// The chain of p's square-free part; `None` iff p is the zero polynomial, where every number is a root.
    pub fn new(p: &Polynomial) -> Option<SturmChain> {
        if p.is_zero() {
            return None;
        }
        let first = p.square_free();
        let mut next = first.derivative().primitive();
        let mut chain = vec![first];
        while !next.is_zero() {
            let previous = chain.last().expect("the chain begins with p");
            let (_, remainder) = previous.divide(&next).expect("the divisor is not zero");
            chain.push(next);
            next = (-remainder).primitive();
        }
        Some(SturmChain { chain })
    }

    /// The square-free part whose chain this is.
    pub fn polynomial(&self) -> &Polynomial {
        &self.chain[0]
    }

    /// The number of different real roots in from < x ≤ to; 0 where from ≥ to. NU-15.
    pub fn count(&self, from: &Rational, to: &Rational) -> usize {
        if from >= to {
            return 0;
        }
        let variations = |x: &Rational| changes(self.chain.iter().map(|p| Sign::of(p.evaluate(x).cmp0())));
        variations(from) - variations(to)
    }

    /// The number of different real roots. NU-15.
    pub fn count_all(&self) -> usize {
        // Beyond every root the leading terms give the signs.
        let at_plus_infinity =
            |p: &Polynomial| Sign::of(p.coefficients().last().map_or(std::cmp::Ordering::Equal, Rational::cmp0));
        let at_minus_infinity = |p: &Polynomial| match p.degree() {
            Some(n) if n % 2 == 1 => -at_plus_infinity(p),
            Some(_) | None => at_plus_infinity(p),
        };
        changes(self.chain.iter().map(at_minus_infinity)) - changes(self.chain.iter().map(at_plus_infinity))
    }
}

/// The number of changes of sign, zeros left out.
fn changes(signs: impl Iterator<Item = Sign>) -> usize {
    let signs: Vec<Sign> = signs.filter(|&s| s != Sign::Zero).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

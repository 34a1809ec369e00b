//! Real algebraic numbers: a polynomial, and an interval in which it has one root.

use super::decimal::{DecimalEnclosure, Digits};
use super::sturm::SturmChain;
use super::{Integer, Polynomial, Rational, Sign};
use std::cmp::Ordering;

/// A real root of a rational polynomial, isolated. Ordered and compared as the real number that it is (NU-18).
#[derive(Clone, Debug)]
#[doc(alias = "NU-18")]
pub struct Algebraic {
    /// Square-free and primitive.
    polynomial: Polynomial,
    location: Location,
}

#[derive(Clone, Debug)]
enum Location {
    Point(Rational),
    /// The only root in lo < x < hi, and neither end is a root: the polynomial's signs there are opposite.
    Between {
        lo: Rational,
        hi: Rational,
    },
}

/// The different real roots of p, in increasing order, in open intervals that do not overlap; a rational root is a
/// point always, so that an interval means an irrational root. `None` iff p is the zero polynomial. NU-16.
#[doc(alias = "NU-16")]
pub fn real_roots(p: &Polynomial) -> Option<Vec<Algebraic>> {
    let chain = SturmChain::new(p)?;
    let bound = p.root_bound();
    let mut roots = Vec::with_capacity(chain.count_all());
    // Half-open parts lo < x ≤ hi of the line, the leftmost on top.
    let mut parts = vec![(Rational::from(-&bound), bound)];
    while let Some((lo, hi)) = parts.pop() {
        match chain.count(&lo, &hi) {
            0 => {}
            1 => {
                let polynomial = chain.polynomial().clone();
                let location = rational_made_point(&polynomial, separated(&chain, lo, hi));
                roots.push(Algebraic { polynomial, location });
            }
            _ => {
                let middle = midpoint(&lo, &hi);
                parts.push((middle.clone(), hi));
                parts.push((lo, middle));
            }
        }
    }
    Some(roots)
}

/// The only root in lo < x ≤ hi, with neither end a root.
fn separated(chain: &SturmChain, mut lo: Rational, mut hi: Rational) -> Location {
    let p = chain.polynomial();
    loop {
        if p.evaluate(&hi).is_zero() {
            return Location::Point(hi);
        }
        if !p.evaluate(&lo).is_zero() {
            return Location::Between { lo, hi };
        }
        // lo is the root to the left: move off it.
        let middle = midpoint(&lo, &hi);
        match chain.count(&lo, &middle) {
            0 => lo = middle,
            _ => hi = middle,
        }
    }
}

/// A rational root of an integer polynomial has a denominator that divides the leading coefficient c: it is a multiple of
/// 1/c, and an open interval no wider than 1/c holds at most one of these.
fn rational_made_point(primitive: &Polynomial, mut location: Location) -> Location {
    let c = primitive.coefficients().last().map(|a| Integer::from(a.numer().abs_ref())).expect("p has a root");
    let step = Rational::from((Integer::from(1), c.clone()));
    while location.width() > step {
        location = location.bisected(primitive);
    }
    match location {
        Location::Point(_) => location,
        Location::Between { lo, hi } => {
            let candidate = (Rational::from(&lo * &c).floor() + 1_u32) / c;
            let is_root = candidate < hi && primitive.evaluate(&candidate).is_zero();
            if is_root { Location::Point(candidate) } else { Location::Between { lo, hi } }
        }
    }
}

impl Location {
    fn width(&self) -> Rational {
        match self {
            Location::Point(_) => Rational::new(),
            Location::Between { lo, hi } => Rational::from(hi - lo),
        }
    }

    /// The half with the root.
    fn bisected(self, p: &Polynomial) -> Location {
        match self {
            Location::Point(_) => self,
            Location::Between { lo, hi } => {
                let middle = midpoint(&lo, &hi);
                match Sign::of(p.evaluate(&middle).cmp0()) {
                    Sign::Zero => Location::Point(middle),
                    s if s == Sign::of(p.evaluate(&lo).cmp0()) => Location::Between { lo: middle, hi },
                    Sign::Negative | Sign::Positive => Location::Between { lo, hi: middle },
                }
            }
        }
    }
}

impl Algebraic {
    /// A square-free polynomial with this root.
    pub fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }

    /// The number, where it is rational.
    pub fn rational(&self) -> Option<&Rational> {
        match &self.location {
            Location::Point(x) => Some(x),
            Location::Between { .. } => None,
        }
    }

    /// (lo, hi) with lo = x = hi where the number is rational, else lo < x < hi and no other root of
    /// [`Algebraic::polynomial`] there.
    pub fn bounds(&self) -> (&Rational, &Rational) {
        match &self.location {
            Location::Point(x) => (x, x),
            Location::Between { lo, hi } => (lo, hi),
        }
    }

    /// The same number with hi − lo ≤ 2^−bits, by bisection.
    pub fn refined(&self, bits: u32) -> Algebraic {
        let width = Rational::from((Integer::from(1), Integer::from(1) << bits));
        let mut root = self.clone();
        while root.location.width() > width {
            root = root.bisected();
        }
        root
    }

    /// The sign of q at this number, exactly. NU-17.
    #[doc(alias = "NU-17")]
    pub fn sign_of(&self, q: &Polynomial) -> Sign {
        let Some(chain) = SturmChain::new(q) else { return Sign::Zero };
        let mut root = self.clone();
        if root.is_root_of_divisor(&self.polynomial.gcd(q)) {
            return Sign::Zero;
        }
        loop {
            let (lo, hi) = root.bounds();
            // Without a root in lo < x ≤ hi, q has one sign there.
            if chain.count(lo, hi) == 0 {
                return Sign::of(q.evaluate(hi).cmp0());
            }
            root = root.bisected();
        }
    }

    /// Decimal strings around the number, as narrow as asked for.
    pub fn decimals(&self, digits: Digits) -> DecimalEnclosure {
        // 2^(4n+4) > 10^(n+1): a tenth of the width.
        let root = self.refined(4 * digits.count() + 4);
        let (lo, hi) = root.bounds();
        DecimalEnclosure::around(lo, hi, digits).expect("narrower than 8/10 of what is asked for")
    }

    fn bisected(self) -> Algebraic {
        Algebraic { location: self.location.bisected(&self.polynomial), polynomial: self.polynomial }
    }

    /// Whether this is a root of g, a divisor of the polynomial: g has no other root between the bounds, none at
    /// them, and no multiple one, so it is one iff g's signs at them are opposite.
    fn is_root_of_divisor(&self, g: &Polynomial) -> bool {
        match &self.location {
            Location::Point(x) => g.evaluate(x).is_zero(),
            Location::Between { lo, hi } => changes_sign(g, lo, hi),
        }
    }
}

impl From<Rational> for Algebraic {
    fn from(x: Rational) -> Algebraic {
        Algebraic { polynomial: Polynomial::with_root(&x).primitive(), location: Location::Point(x) }
    }
}

impl Ord for Algebraic {
    fn cmp(&self, other: &Algebraic) -> Ordering {
        let (mut x, mut y) = (self.clone(), other.clone());
        if are_equal(&x, &y) {
            return Ordering::Equal;
        }
        // Different numbers: their intervals part in the end.
        loop {
            let ((a, b), (c, d)) = (x.bounds(), y.bounds());
            if b <= c {
                return Ordering::Less;
            }
            if d <= a {
                return Ordering::Greater;
            }
            (x, y) = (x.bisected(), y.bisected());
        }
    }
}

/// Two numbers are equal iff they are one common root of their polynomials, in both intervals.
fn are_equal(x: &Algebraic, y: &Algebraic) -> bool {
    match (&x.location, &y.location) {
        (Location::Point(x), Location::Point(y)) => x == y,
        // An interval means an irrational number, but this needs no such promise.
        (Location::Point(r), Location::Between { lo, hi }) => lo < r && r < hi && y.polynomial.evaluate(r).is_zero(),
        (Location::Between { .. }, Location::Point(_)) => are_equal(y, x),
        (Location::Between { lo: a, hi: b }, Location::Between { lo: c, hi: d }) => {
            let (lo, hi) = (a.max(c), b.min(d));
            // Each end is no root of one of the two, hence none of their divisor; a root of it in here is both numbers.
            lo < hi && changes_sign(&x.polynomial.gcd(&y.polynomial), lo, hi)
        }
    }
}

fn changes_sign(p: &Polynomial, lo: &Rational, hi: &Rational) -> bool {
    let at = |x| Sign::of(p.evaluate(x).cmp0());
    at(lo) * at(hi) == Sign::Negative
}

fn midpoint(lo: &Rational, hi: &Rational) -> Rational {
    Rational::from(lo + hi) / 2_u32
}

impl PartialOrd for Algebraic {
    fn partial_cmp(&self, other: &Algebraic) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Algebraic {
    fn eq(&self, other: &Algebraic) -> bool {
        are_equal(self, other)
    }
}

impl Eq for Algebraic {}

//! Quickcheck's `Arbitrary` for the numbers of this crate.

use super::{F64Interval, Integer, Interval, Rational, Sign, Surd};
use quickcheck::{Arbitrary, Gen};

/// A rational for quickcheck, which may implement its trait for our own types alone: small, dyadic or large.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ArbitraryRational(pub Rational);

impl Arbitrary for ArbitraryRational {
    fn arbitrary(g: &mut Gen) -> ArbitraryRational {
        let (p, q) = (i64::arbitrary(g), i64::arbitrary(g));
        ArbitraryRational(match u8::arbitrary(g) % 3 {
            0 => Rational::from((p % 10, q.rem_euclid(9) + 1)),
            1 => Rational::from((Integer::from(p), Integer::from(1) << (q.rem_euclid(64) as u32))),
            _ => Rational::from((p, q.checked_abs().unwrap_or(1).max(1))),
        })
    }

    /// The integers on both sides, and halfway to zero.
    fn shrink(&self) -> Box<dyn Iterator<Item = ArbitraryRational>> {
        let ArbitraryRational(x) = self;
        let simpler = [Rational::new(), x.clone().trunc(), x.clone().floor(), x.clone().ceil()];
        let halves = x.is_integer().then(|| (x.clone() / 2_u32).trunc());
        let x = x.clone();
        let candidates = simpler.into_iter().filter(|_| !x.is_integer()).chain(halves);
        let shrunk: Vec<_> = candidates.filter(|y| *y != x).map(ArbitraryRational).collect();
        Box::new(shrunk.into_iter())
    }
}

impl Arbitrary for Sign {
    fn arbitrary(g: &mut Gen) -> Sign {
        *g.choose(&[Sign::Negative, Sign::Zero, Sign::Positive]).expect("there are three signs")
    }
}

/// Radicands 0 … 50.
impl Arbitrary for Surd {
    fn arbitrary(g: &mut Gen) -> Surd {
        let (a, b) = (ArbitraryRational::arbitrary(g), ArbitraryRational::arbitrary(g));
        let d = Rational::from(u8::arbitrary(g) % 51);
        Surd::new(a.0, b.0, &d).expect("the radicand is not negative")
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Surd>> {
        let (a, b, d) = self.parts();
        let (a, b, d) = (ArbitraryRational(a.clone()), ArbitraryRational(b.clone()), Rational::from(d));
        let of_parts = (a, b).shrink();
        Box::new(of_parts.map(move |(a, b)| Surd::new(a.0, b.0, &d).expect("the radicand is positive")))
    }
}

/// Finite bounds.
impl Arbitrary for F64Interval {
    fn arbitrary(g: &mut Gen) -> F64Interval {
        let mut finite = || {
            let x = f64::arbitrary(g);
            if x.is_finite() { x } else { 0.0 }
        };
        let lo = finite();
        let hi = finite();
        F64Interval::between(lo, hi).expect("the bounds are finite")
    }
}

/// 2 to 129 bits.
impl Arbitrary for Interval {
    fn arbitrary(g: &mut Gen) -> Interval {
        let (a, b) = (ArbitraryRational::arbitrary(g), ArbitraryRational::arbitrary(g));
        let precision = 2 + u32::from(u8::arbitrary(g) % 128);
        let (lo, hi) = (a.clone().min(b.clone()), a.max(b));
        Interval::between(&lo.0, &hi.0, precision).expect("the bounds are in order")
    }
}

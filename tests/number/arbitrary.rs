//! Quickcheck's generators give sound numbers, and their shrinking ends.

use isoracle::number::{ArbitraryRational, Enclosure, F64Interval, Interval, OrderedField, Sign, Surd};
use quickcheck::{Arbitrary, quickcheck};

/// Always the last simpler value: the longest way down.
fn shrinks_to_an_end<T: Arbitrary>(x: T) -> bool {
    std::iter::successors(Some(x), |x| x.shrink().last()).take(2000).count() < 2000
}

quickcheck! {
    fn rationals_shrink_to_an_end(x: ArbitraryRational) -> bool {
        shrinks_to_an_end(x)
    }

    fn surds_shrink_to_an_end(x: Surd) -> bool {
        shrinks_to_an_end(x)
    }

    fn a_surd_times_its_sign_is_not_negative(x: Surd) -> bool {
        let negative = x.sign() == Sign::Negative;
        (if negative { -x } else { x }).sign() != Sign::Negative
    }

    fn bounds_are_in_order(a: F64Interval, b: Interval, s: Sign) -> bool {
        a.lo() <= a.hi() && b.lo() <= b.hi() && (s * s != Sign::Negative) && a.known_sign() == (-(-a)).known_sign()
    }
}

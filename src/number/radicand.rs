//! What stands under a square root: squares are taken out of it, as far as bounded trial division finds them.

use super::{Integer, Rational};
use std::cmp::Ordering;

/// Primes up to this are divided out.
const TRIAL_BOUND: u32 = 1 << 16;

/// 1, or an integer > 1 that is no perfect square and has no factor p² with a prime p ≤ [`TRIAL_BOUND`].
#[derive(Clone, Debug)]
pub(super) struct Radicand {
    value: Integer,
    proven_square_free: bool,
}

/// By value.
impl PartialEq for Radicand {
    fn eq(&self, other: &Radicand) -> bool {
        self.value == other.value
    }
}

impl Radicand {
    pub(super) fn one() -> Radicand {
        Radicand { value: Integer::from(1), proven_square_free: true }
    }

    /// (s, d) with √r = s√d; `None` iff r < 0. √0 is 0·√1.
    pub(super) fn of_root(r: &Rational) -> Option<(Rational, Radicand)> {
        match r.cmp0() {
            Ordering::Less => None,
            Ordering::Equal => Some((Rational::new(), Radicand::one())),
            Ordering::Greater => {
                // √(p/q) = s√d / (t√e) = s/(te)·√(de), and d, e have no common factor, as p, q have none.
                let ((s, d), (t, e)) = (without_squares(r.numer()), without_squares(r.denom()));
                let factor = Rational::from((s, t * &e.value));
                let proven_square_free = d.proven_square_free && e.proven_square_free;
                Some((factor, Radicand { value: d.value * e.value, proven_square_free }))
            }
        }
    }

    pub(super) fn value(&self) -> &Integer {
        &self.value
    }

    pub(super) fn is_one(&self) -> bool {
        self.value == 1
    }

    pub(super) fn is_proven_square_free(&self) -> bool {
        self.proven_square_free
    }

    /// √e/√d for the other radicand e, where that is rational: iff de is a perfect square, for √e/√d = √(de)/d.
    pub(super) fn root_ratio(&self, other: &Radicand) -> Option<Rational> {
        let product = Integer::from(&self.value * &other.value);
        product.is_perfect_square().then(|| Rational::from((product.sqrt(), self.value.clone())))
    }
}

/// (s, d) with n = s²d, for n > 0.
fn without_squares(n: &Integer) -> (Integer, Radicand) {
    // Invariant: n = s²·d·rest, d is square-free and prime to rest, no prime < p divides rest.
    let (mut s, mut d, mut rest) = (Integer::from(1), Integer::from(1), n.clone());
    let mut divide = |rest: &mut Integer, p: u32| {
        let (without, exponent) = rest.clone().remove_factor(&Integer::from(p));
        *rest = without;
        s *= Integer::from(Integer::u_pow_u(p, exponent / 2));
        if exponent % 2 == 1 {
            d *= p;
        }
    };
    divide(&mut rest, 2);
    let mut p = 3;
    while p <= TRIAL_BOUND && rest >= cube(p) {
        if rest.is_divisible_u(p) {
            divide(&mut rest, p);
        }
        p += 2;
    }
    // Every prime factor of rest is at least p. Below p³ there are at most two of them, so rest is 1, a prime,
    // a product of two different primes, or the square of one.
    let proven_square_free = rest < cube(p);
    if rest.is_perfect_square() {
        let root = rest.sqrt();
        // A large root is taken out whole; then nothing is left under the root that is unproven.
        (s * root, Radicand { value: d, proven_square_free: true })
    } else {
        (s, Radicand { value: d * rest, proven_square_free })
    }
}

fn cube(p: u32) -> Integer {
    Integer::from(Integer::u_pow_u(p, 3))
}

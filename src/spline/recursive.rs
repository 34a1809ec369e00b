//! The recursive filter: a causal and an anticausal pass of one multiplication each, with exact starting values.

use super::impulse::pole;
use super::signal::{Boundary, SignalError, check_shape};
use crate::number::{OrderedField, Rational, Ring, Surd};

/// The coefficients of a line of samples by the recursive filter of M. Unser, A. Aldroubi and M. Eden (1991), exactly, in
/// ℚ(√3). SP-70.
///
/// c⁺\[k] = 6g\[k] + z·c⁺\[k−1], then c\[k] = z(c\[k+1] − c⁺\[k]). The starting values are the sums of the infinitely many
/// samples before, by geometric series. Mirror, m = n − 1: c⁺\[0] = 6(g\[0] + zᵐg\[m] + Σ (zᵏ + z^(2m−k))g\[k])/(1 − z²ᵐ) over
/// 0 < k < m, and c\[m] = z/(z² − 1)·(c⁺\[m] + z·c⁺\[m−1]). Periodic: c⁺\[0] = 6·Σ zᵏg[−k]/(1 − zⁿ) and c\[n−1] = −z·Σ
/// zᵏc⁺\[n−1+k]/(1 − zⁿ), 0 ≤ k < n.
///
/// # Errors
/// `Side` iff there are fewer than two samples.
#[doc(alias = "SP-70")]
pub fn solve(g: &[Rational], boundary: Boundary) -> Result<Vec<Rational>, SignalError> {
    check_shape(&[g.len()], g.len())?;
    let z = pole();
    let samples: Vec<Surd> = g.iter().map(|g| Surd::from(Rational::from(g * 6))).collect();
    let mut causal = vec![first_causal(&samples, &z, boundary)];
    for k in 1..g.len() {
        causal.push(samples[k].clone() + &(z.clone() * &causal[k - 1]));
    }
    let mut c = vec![last(&causal, &z, boundary)];
    for k in (0..g.len() - 1).rev() {
        let next = (c[c.len() - 1].clone() - &causal[k]) * &z;
        c.push(next);
    }
    let rational = |c: Surd| c.rational().expect("the system and the samples are rational").clone();
    Ok(c.into_iter().rev().map(rational).collect())
}

/// c⁺\[0] = Σ zᵏ g[−k] over all k ≥ 0, as a sum over one period.
fn first_causal(g: &[Surd], z: &Surd, boundary: Boundary) -> Surd {
    let (n, period) = (g.len(), boundary.period(g.len()));
    // g[−k] for k = 0, …, period − 1.
    let before = |k: usize| match boundary {
        Boundary::Mirror => &g[k.min(period - k)],
        Boundary::Periodic => &g[(n - k) % n],
    };
    geometric(z, (0..period).map(before))
}

/// c\[n−1], from c\[k] = −Σ z^(j+1) c⁺\[k+j] over all j ≥ 0.
fn last(causal: &[Surd], z: &Surd, boundary: Boundary) -> Surd {
    let m = causal.len() - 1;
    match boundary {
        Boundary::Mirror => {
            let factor = (z.clone() * z - &Surd::integer(1)).inverse().expect("|z| < 1");
            (causal[m].clone() + &(z.clone() * &causal[m - 1])) * z * &factor
        }
        Boundary::Periodic => {
            let after = std::iter::once(&causal[m]).chain(&causal[..m]);
            -(geometric(z, after) * z)
        }
    }
}

/// Σ zᵏ a\[k] over all k ≥ 0, a of the period that is given: Σ zᵏ a\[k]/(1 − zᵖ) over one period.
fn geometric<'a>(z: &Surd, period: impl Iterator<Item = &'a Surd>) -> Surd {
    let (sum, power) =
        period.fold((Surd::integer(0), Surd::integer(1)), |(sum, power), a| (sum + &(power.clone() * a), power * z));
    sum * &(Surd::integer(1) - &power).inverse().expect("|z| < 1")
}

//! The inverse of the interpolation problem of a finite signal, written out: by images of the infinite inverse, and in
//! integers.
//!
//! With A the n×n matrix of (12) under a boundary rule, c = A⁻¹g. Everything is expressed by the convergents A_k/B_k of √3.

use super::impulse::{inverse_filter, pole};
use super::signal::{Boundary, SignalError, check_shape};
use crate::number::{Integer, OrderedField, Rational, Ring, Surd};

/// The k-th convergent A/B of √3 = [1; 1, 2, 1, 2, …]: 1/0, 1/1, 2/1, 5/3, 7/4, 19/11, 26/15, … SP-73.
///
/// (2 + √3)ᵐ = A₂ₘ + B₂ₘ√3; A² − 3B² is 1 for even k and −2 for odd k.
#[doc(alias = "SP-73")]
pub fn convergent(k: u32) -> (Integer, Integer) {
    // (A + B√3)·(2 + √3)ᵐ by squaring; for odd k it begins with A₁ + B₁√3 = 1 + √3.
    let times = |(a, b): &(Integer, Integer), (c, d): &(Integer, Integer)| {
        (Integer::from(a * c) + Integer::from(b * d) * 3, Integer::from(a * d) + Integer::from(b * c))
    };
    let m = k / 2;
    let two_and_root = (Integer::from(2), Integer::from(1));
    let power = (0..u32::BITS - m.leading_zeros()).rev().fold((Integer::from(1), Integer::new()), |power, bit| {
        let square = times(&power, &power);
        if m >> bit & 1 == 1 { times(&square, &two_and_root) } else { square }
    });
    if k.is_multiple_of(2) { power } else { times(&power, &(Integer::from(1), Integer::from(1))) }
}

/// The numerators A₀, …, A_k, by A_(k+4) = 4A_(k+2) − A_k. SP-73.
pub fn numerators(k: usize) -> Vec<Integer> {
    let mut a: Vec<Integer> = [1, 1, 2, 5].map(Integer::from).to_vec();
    (4..=k).for_each(|i| a.push(Integer::from(&a[i - 2] * 4) - &a[i - 4]));
    a.truncate(k + 1);
    a
}

/// Σ h\[d + mp] over all integers m, the period p ≥ 1: √3(z^e + z^(p−e))/(1 − zᵖ) with e = d mod p, by geometric series. SP-64.
///
/// # Panics
/// Iff p = 0.
#[doc(alias = "SP-64")]
pub fn images(d: u32, period: u32) -> Surd {
    let e = d % period;
    let of_period = z_power(period);
    let denominator = (Surd::integer(1) - &of_period).inverse().expect("|z| < 1");
    (inverse_filter(e) + &inverse_filter(period - e)) * &denominator
}

/// zᵏ = h\[k]/√3.
fn z_power(k: u32) -> Surd {
    inverse_filter(k) * &inverse_filter(0).inverse().expect("√3 is not 0")
}

/// The entry (i, j) of A⁻¹ as a sum over the images of sample j, in ℚ(√3); it is rational. SP-64.
///
/// Periodic: Σ h[i − j + mn]. Mirror: Σ h[i − j + mp] + Σ h[i + j + mp], p = 2n − 2, but one of the two sums where j is an end.
///
/// # Panics
/// Iff n < 2, or i or j is not below n.
pub fn entry_by_images(n: usize, boundary: Boundary, i: usize, j: usize) -> Surd {
    check_entry(n, i, j);
    let period = word(boundary.period(n));
    let direct = images(word(i.abs_diff(j)), period);
    match boundary {
        Boundary::Mirror if j > 0 && j < n - 1 => direct + &images(word(i + j), period),
        Boundary::Mirror | Boundary::Periodic => direct,
    }
}

/// The entry (i, j) of A⁻¹. SP-66, SP-67.
///
/// Mirror, m = n − 1: (−1)^(i+j) w A_(2·min(i, j)) A_(2(m − max(i, j)))/B₂ₘ, where w is 1 for j = 0 and j = m, else 2.
/// Periodic, e = min(|i − j|, n − |i − j|): (−1)ᵉ A_(n − 2e)/Bₙ.
///
/// # Panics
/// Iff n < 2, or i or j is not below n.
#[doc(alias = "SP-66")]
#[doc(alias = "SP-67")]
pub fn entry(n: usize, boundary: Boundary, i: usize, j: usize) -> Rational {
    check_entry(n, i, j);
    match boundary {
        Boundary::Mirror => {
            let m = n - 1;
            let weight = if j == 0 || j == m { 1 } else { 2 };
            let numerator = convergent(word(2 * i.min(j))).0 * convergent(word(2 * (m - i.max(j)))).0 * weight;
            Rational::from((alternating(i + j, numerator), convergent(word(2 * m)).1))
        }
        Boundary::Periodic => {
            let d = i.abs_diff(j);
            let e = d.min(n - d);
            Rational::from((alternating(e, convergent(word(n - 2 * e)).0), convergent(word(n)).1))
        }
    }
}

/// The coefficients A⁻¹g of a line. SP-65.
///
/// # Errors
/// `Side` iff there are fewer than two samples.
#[doc(alias = "SP-65")]
pub fn solve(g: &[Rational], boundary: Boundary) -> Result<Vec<Rational>, SignalError> {
    check_shape(&[g.len()], g.len())?;
    let row = |i| (0..g.len()).fold(Rational::new(), |sum, j| sum + entry(g.len(), boundary, i, j) * &g[j]);
    Ok((0..g.len()).map(row).collect())
}

/// 6A: row k has 4 in column k, and 1 at each of the places that k − 1 and k + 1 are folded to.
///
/// # Panics
/// Iff n < 2.
pub fn matrix(n: usize, boundary: Boundary) -> Vec<Vec<Integer>> {
    assert!(n >= 2, "a signal has at least 2 samples");
    let row = |k: usize| {
        let mut row = vec![Integer::new(); n];
        row[k] += 4;
        for step in [-1, 1] {
            row[boundary.index(&(Integer::from(k) + step), n)] += 1;
        }
        row
    };
    (0..n).map(row).collect()
}

/// det 6A: 12B_(2n−2) for mirror, 2A₂ₙ − 2(−1)ⁿ for periodic. SP-68.
///
/// # Panics
/// Iff n < 2.
#[doc(alias = "SP-68")]
pub fn determinant(n: usize, boundary: Boundary) -> Integer {
    assert!(n >= 2, "a signal has at least 2 samples");
    match boundary {
        Boundary::Mirror => convergent(word(2 * n - 2)).1 * 12,
        Boundary::Periodic => convergent(word(2 * n)).0 * 2 - alternating(n, Integer::from(2)),
    }
}

/// det of the n×n matrix [1 4 1] without a boundary rule: B_(2n+2). SP-68.
pub fn interior_determinant(n: usize) -> Integer {
    convergent(word(2 * n + 2)).1
}

/// By how much the periodic inverse of period n is above the infinite one at the distance d ≤ n: √3(z^(n−d) + z^(n+d))/(1 −
/// zⁿ). SP-71.
///
/// In absolute value it is at most 2√3·|z|^(n−d)/(1 − |z|ⁿ).
///
/// # Panics
/// Iff n = 0 or d > n.
#[doc(alias = "SP-71")]
pub fn periodic_excess(n: u32, d: u32) -> Surd {
    let denominator = (Surd::integer(1) - &z_power(n)).inverse().expect("|z| < 1");
    (inverse_filter(n - d) + &inverse_filter(n + d)) * &denominator
}

/// The bound of [`periodic_excess`]: 2√3·|z|^(n−d)/(1 − |z|ⁿ). SP-71.
///
/// # Panics
/// Iff n = 0 or d > n.
pub fn periodic_excess_bound(n: u32, d: u32) -> Surd {
    let modulus = -pole();
    let power = |k: u32| (0..k).fold(Surd::integer(1), |power, _| power * &modulus);
    let denominator = (Surd::integer(1) - &power(n)).inverse().expect("|z| < 1");
    inverse_filter(0) * &Surd::integer(2) * &power(n - d) * &denominator
}

/// The 2n − 2 samples of a period of the mirrored signal: g\[0], …, g\[n−1], g\[n−2], …, g\[1]. SP-69.
///
/// # Errors
/// `Side` iff there are fewer than two samples.
#[doc(alias = "SP-69")]
pub fn mirrored_period(g: &[Rational]) -> Result<Vec<Rational>, SignalError> {
    check_shape(&[g.len()], g.len())?;
    Ok(g.iter().chain(g[1..g.len() - 1].iter().rev()).cloned().collect())
}

fn alternating(k: usize, n: Integer) -> Integer {
    if k.is_multiple_of(2) { n } else { -n }
}

fn check_entry(n: usize, i: usize, j: usize) {
    assert!(n >= 2 && i < n && j < n, "the matrix has {n} rows and columns, at least 2");
}

fn word(n: usize) -> u32 {
    u32::try_from(n).expect("a matrix of more than 2³² rows is not asked for")
}

//! The orientation of r + 1 points in r of their coordinates, exactly.

use crate::number::{Rational, Sign};

/// More coordinates than this are evaluated in rationals at once: the filter's bound is for as many at most.
const MOST: usize = 6;

/// Coordinates beyond this could overflow the filter's products.
const LARGEST: f64 = 1e30;

/// The sign of |p₁ − p₀, …, p_r − p₀|, each difference restricted to the r given coordinates; + for r = 0.
///
/// First in binary64: with the determinant D expanded column by column over sets of rows, and P the same expansion of the
/// absolute values, the sign of fl(D) is right if |fl(D)| > 2⁻⁴⁷·fl(P) + 2⁻³⁰⁰. Otherwise in rationals.
#[doc(alias = "CX-84")]
pub fn orientation(points: &[&[f64]], coordinates: &[usize]) -> Sign {
    filtered(points, coordinates).unwrap_or_else(|| exact(points, coordinates))
}

/// The sign, where the filter is sure of it.
pub fn filtered(points: &[&[f64]], coordinates: &[usize]) -> Option<Sign> {
    let r = coordinates.len();
    if r > MOST {
        return None;
    }
    let mut rows = [[0.0; MOST]; MOST];
    for (row, point) in rows.iter_mut().zip(&points[1..=r]) {
        for (entry, i) in row.iter_mut().zip(coordinates) {
            *entry = point[*i] - points[0][*i];
            // NaN cannot be, for coordinates are finite; what is not small is not for the filter.
            if entry.abs() > LARGEST {
                return None;
            }
        }
    }
    // minors[S]: the determinant of the rows of S and the first |S| columns; and the sum of the terms' absolute values.
    let mut minors = [(0.0_f64, 0.0_f64); 1 << MOST];
    minors[0] = (1.0, 1.0);
    for set in 1_usize..1 << r {
        let column = set.count_ones() as usize - 1;
        let (mut sum, mut sizes) = (0.0, 0.0);
        for (row, entries) in rows.iter().enumerate().take(r).filter(|(row, _)| set >> row & 1 == 1) {
            let (minor, size) = minors[set & !(1 << row)];
            let term = entries[column] * minor;
            // The rows of the set below this one are those that it passes to become the last.
            let passes = (set >> (row + 1)).count_ones();
            sum += if passes.is_multiple_of(2) { term } else { -term };
            sizes += entries[column].abs() * size;
        }
        minors[set] = (sum, sizes);
    }
    let (determinant, size) = minors[(1 << r) - 1];
    let bound = size * 2.0_f64.powi(-47) + 2.0_f64.powi(-300);
    match determinant {
        d if d > bound => Some(Sign::Positive),
        d if d < -bound => Some(Sign::Negative),
        _ => None,
    }
}

/// The sign, by elimination in rationals.
pub fn exact(points: &[&[f64]], coordinates: &[usize]) -> Sign {
    Sign::of(determinant(points, coordinates).cmp0())
}

/// |p₁ − p₀, …, p_r − p₀| in these coordinates.
pub fn determinant(points: &[&[f64]], coordinates: &[usize]) -> Rational {
    let r = coordinates.len();
    let value = |p: &[f64], i: usize| Rational::from_f64(p[i]).expect("coordinates are finite");
    let row = |p: &[f64]| coordinates.iter().map(|i| value(p, *i) - value(points[0], *i)).collect();
    let mut rows: Vec<Vec<Rational>> = points[1..=r].iter().map(|p| row(p)).collect();
    let mut product = Rational::from(1);
    for column in 0..r {
        let Some(pivot) = (column..r).find(|i| !rows[*i][column].is_zero()) else { return Rational::new() };
        if pivot != column {
            rows.swap(pivot, column);
            product = -product;
        }
        let pivot = rows[column].clone();
        product *= &pivot[column];
        for row in &mut rows[column + 1..] {
            let factor = Rational::from(&row[column] / &pivot[column]);
            row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= Rational::from(&factor * p));
        }
    }
    product
}

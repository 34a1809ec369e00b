//! Cubic splines: each entry of spec/spline.md against a second derivation.

mod bsplines;
mod coherence;
mod coherence_of_a_scan;
mod convergence;
mod degree_one;
mod derivatives;
mod domain;
mod fast;
mod fast_exact;
mod fast_points;
mod ground;
mod infinite;
mod inverse;
mod spaces;

use isoracle::number::{Integer, Rational, Surd};
use isoracle::spline::signal::{Boundary, Signal};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// n/d.
fn q(n: i64, d: i64) -> Rational {
    Rational::from((n, d))
}

/// Both boundary rules.
const RULES: [Boundary; 2] = [Boundary::Mirror, Boundary::Periodic];

fn boundary() -> impl Strategy<Value = Boundary> {
    prop_oneof![Just(Boundary::Mirror), Just(Boundary::Periodic)]
}

/// Small fractions, in which coincidences are common, and some large ones.
fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        4 => (-9..=9_i64).prop_map(|n| q(n, 1)),
        2 => (-40..=40_i64, 1..=8_i64).prop_map(|(n, d)| q(n, d)),
        1 => (any::<i64>(), 1..i64::MAX).prop_map(|(n, d)| q(n, d)),
    ]
}

/// A signal on ℤ that is 0 but at −5, …, 5.
fn few() -> impl Strategy<Value = BTreeMap<Integer, Rational>> {
    prop::collection::vec(number(), 11)
        .prop_map(|values| values.into_iter().enumerate().map(|(i, g)| (Integer::from(i) - 5, g)).collect())
}

/// What stands at k.
fn at(g: &BTreeMap<Integer, Rational>, k: &Integer) -> Rational {
    g.get(k).cloned().unwrap_or_default()
}

/// a + b√3.
fn root3(a: i64, b: i64) -> Surd {
    Surd::new(q(a, 1), q(b, 1), &q(3, 1)).expect("3 is not negative")
}

fn sum<'a>(numbers: impl IntoIterator<Item = &'a Rational>) -> Rational {
    numbers.into_iter().fold(Rational::new(), |sum, x| sum + x)
}

fn signal<const N: usize>(shape: [usize; N], values: &[Rational], boundary: Boundary) -> Signal<N> {
    let count = shape.iter().product();
    Signal::new(shape, values[..count].to_vec(), boundary).expect("the shape fits")
}

/// The number of pivots of a matrix, and their product with the sign of the exchanges of rows, by elimination.
fn pivots(mut rows: Vec<Vec<Rational>>) -> (usize, Rational) {
    let (mut rank, mut product) = (0, q(1, 1));
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(pivot) = (rank..rows.len()).find(|&r| rows[r][column] != 0) else { continue };
        if pivot != rank {
            rows.swap(rank, pivot);
            product = -product;
        }
        let (above, below) = rows.split_at_mut(rank + 1);
        let pivot_row = &above[rank];
        product *= &pivot_row[column];
        for row in below {
            let factor = Rational::from(&row[column] / &pivot_row[column]);
            row.iter_mut().zip(pivot_row).for_each(|(a, p)| *a -= Rational::from(&factor * p));
        }
        rank += 1;
    }
    (rank, product)
}

/// The rank of a matrix.
fn rank(rows: Vec<Vec<Rational>>) -> usize {
    pivots(rows).0
}

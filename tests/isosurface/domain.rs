//! The cells that claims are tested on: all of a few values, one of each class, and those near a degenerate one.

use isoracle::isosurface::cases::Case;
use isoracle::isosurface::cell::{Decisions, decide};
use isoracle::isosurface::cube::Symmetry;
use isoracle::isosurface::witness::smallest;
use isoracle::number::{Integer, Rational, Word};
use proptest::prelude::*;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Values for exhaustive tests. With 1 and 2 there are many ties and near misses, and no tunnel; the others meet all six
/// cases that have one.
pub const SETS: [[i64; 4]; 4] = [[-2, -1, 1, 2], [-9, -1, 1, 9], [-7, -3, 2, 5], [-4, -1, 2, 3]];

/// Whether the long form of a test is asked for: the environment has `ISORACLE_LONG=1`. The short form tests the same
/// on a smaller domain.
pub fn is_long() -> bool {
    std::env::var("ISORACLE_LONG").is_ok_and(|value| value == "1")
}

pub fn rationals<const N: usize>(values: &[i64; N]) -> [Rational; N] {
    values.map(Rational::from)
}

pub fn words(values: &[i64; 8]) -> [Word; 8] {
    values.map(|v| Word(v.into()))
}

pub fn q(numerator: i64, denominator: i64) -> Rational {
    Rational::from((numerator, denominator))
}

/// Every choice of values in the set, in parallel.
pub fn all<const N: usize>(set: &[i64]) -> impl IndexedParallelIterator<Item = [i64; N]> + '_ {
    let n = set.len();
    (0..n.pow(N as u32)).into_par_iter().map(move |code| std::array::from_fn(|i| set[code / n.pow(i as u32) % n]))
}

/// A cell of each labelled class: the smallest cells of the cases, turned, reflected and negated.
pub fn class_witnesses() -> BTreeMap<Decisions, [i64; 8]> {
    let mut witnesses = BTreeMap::new();
    for &case in Case::ALL {
        for symmetry in Symmetry::all() {
            for sign in [1, -1] {
                let cell = symmetry.carry(&smallest(case).map(|v| i64::from(sign * v)));
                let decisions = decide(&words(&cell)).expect("no witness is degenerate");
                witnesses.entry(decisions).or_insert(cell);
            }
        }
    }
    witnesses
}

/// A cell with a face saddle or a critical point inside the cell at 0, or near the border or corners of it.
pub fn critical() -> impl Strategy<Value = [i64; 8]> {
    let value = || prop_oneof![-9..=-1i64, 1..=9i64];
    // g00·g11 = g10·g01 with alternating signs on one face.
    let face = (prop::array::uniform4(1..=5i64), any::<bool>(), prop::array::uniform4(value()), 0..48usize).prop_map(
        |([p, q, r, s], negative, rest, turn)| {
            let face = [p * q, -p * r, -q * s, r * s].map(|v| if negative { -v } else { v });
            let cell: [i64; 8] = std::array::from_fn(|i| if i < 4 { face[i] } else { rest[i - 4] });
            Symmetry::all()[turn].carry(&cell)
        },
    );
    // n³f = k·XYZ + n(a·YZ + b·XZ + c·XY) in X = nx − x₀ and so on: value and gradient vanish at (x₀, y₀, z₀)/n.
    let inside = (2..=6i64).prop_flat_map(|n| {
        let coefficient = -3..=3i64;
        let coefficients = (coefficient.clone(), coefficient.clone(), coefficient.clone(), coefficient);
        (Just(n), prop::array::uniform3(1..n), coefficients).prop_map(|(n, at, (k, a, b, c))| {
            std::array::from_fn(|corner| {
                let [x, y, z] = [0, 1, 2].map(|i| if corner >> i & 1 == 1 { n - at[i] } else { -at[i] });
                k * x * y * z + n * (a * y * z + b * x * z + c * x * y)
            })
        })
    });
    prop_oneof![face, inside]
}

/// A critical cell, magnified and with its values moved by at most 1.
pub fn near_critical() -> impl Strategy<Value = [i64; 8]> {
    (critical(), 4..=20u32, prop::array::uniform8(-1..=1i64))
        .prop_map(|(cell, bits, nudge)| std::array::from_fn(|i| (cell[i] << bits) + nudge[i]))
}

pub fn integers(values: &[i64; 8]) -> [Integer; 8] {
    values.map(Integer::from)
}

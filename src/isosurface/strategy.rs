//! Proptest strategies for cells and volumes, biased to where implementations go wrong: small integers, in which the
//! rare cases are common, and values that a tie is near.

use super::cases::Case;
use super::cell::Tie;
use super::cube::{Corner, Edge, Face, Symmetry};
use super::volume::Volume;
use super::witness::smallest;
use crate::number::Rational;
use proptest::prelude::*;

/// Each corner as often.
pub fn corner() -> impl Strategy<Value = Corner> {
    prop::sample::select(Corner::ALL.to_vec())
}

/// Each edge as often.
pub fn edge() -> impl Strategy<Value = Edge> {
    prop::sample::select(Edge::ALL.to_vec())
}

/// Each face as often.
pub fn face() -> impl Strategy<Value = Face> {
    prop::sample::select(Face::ALL.to_vec())
}

/// Each of the 48 symmetries as often.
pub fn symmetry() -> impl Strategy<Value = Symmetry> {
    prop::sample::select(Symmetry::all())
}

/// Each of the 33 cases as often.
pub fn case() -> impl Strategy<Value = Case> {
    prop::sample::select(Case::ALL.to_vec())
}

/// Either way to treat a tie.
pub fn tie() -> impl Strategy<Value = Tie> {
    prop_oneof![Just(Tie::Degenerate), Just(Tie::Below)]
}

/// Corner values of a cell in a given case, or its mirror image's, at isovalue 0: the smallest such cell, turned,
/// and scaled by a positive number.
pub fn cell_of(case: Case) -> impl Strategy<Value = [Rational; 8]> {
    (symmetry(), 1..50_i32, 1..50_i32).prop_map(move |(symmetry, p, q)| {
        let scale = Rational::from((p, q));
        symmetry.carry(&smallest(case)).map(|v| Rational::from(v) * &scale)
    })
}

/// Integer corner values without zeros, −9 … 9: about one in four has an ambiguous face.
pub fn small_cell() -> impl Strategy<Value = [i32; 8]> {
    prop::array::uniform8(prop_oneof![-9..=-1_i32, 1..=9_i32])
}

/// Integer corner values of which ties are common: −1 … 1, or ±1, or −3 … 3.
pub fn tied_cell() -> impl Strategy<Value = [i32; 8]> {
    let two = prop_oneof![Just(-1), Just(1)];
    prop_oneof![prop::array::uniform8(-1..=1_i32), prop::array::uniform8(two), prop::array::uniform8(-3..=3_i32),]
}

/// A cell that a tie is near: one of small integers, scaled by a power of two up to 2²⁰, each value moved by at most 1.
pub fn nearly_degenerate_cell() -> impl Strategy<Value = [i32; 8]> {
    let nudges = prop::array::uniform8(-1..=1_i32);
    (tied_cell(), 4..=20_u32, nudges)
        .prop_map(|(values, bits, nudges)| std::array::from_fn(|i| (values[i] << bits) + nudges[i]))
}

/// Small integer volumes, 2 to `most` samples along each axis.
pub fn volume(most: usize) -> impl Strategy<Value = Volume> {
    let shape = prop::array::uniform3(2..=most.max(2));
    let most_value = prop::sample::select(vec![1, 3, 9, 1000]);
    (shape, most_value).prop_flat_map(|(shape, most_value)| {
        prop::collection::vec(-most_value..=most_value, shape.iter().product::<usize>())
            .prop_map(move |values| Volume::integers(shape, values).expect("the shape has as many samples"))
    })
}

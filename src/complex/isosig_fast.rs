//! The fast twin of [`isosig`](super::isosig): a word is given up at the first digit that is greater than that of the least so far.

use super::isosig::{Walk, before_actions, beginnings, of_components, three};
use super::triangulation::Triangulation;
use std::cmp::Ordering;

/// The signature of a triangulation, as [`isosig::signature`](super::isosig::signature) gives it. Of a triangulation without
/// symmetries most words end after a few digits; where all words are alike it takes as long.
#[doc(alias = "CX-93")]
pub fn signature(triangulation: &Triangulation) -> String {
    of_components(triangulation, |component| {
        let before = before_actions(component.len());
        let mut least = String::new();
        for (begin, labels) in beginnings(component) {
            // How the word compares with the least one, as far as its digits are known.
            let mut so_far = if least.is_empty() { Ordering::Less } else { Ordering::Equal };
            let walk = Walk::so_long_as(triangulation, begin, labels, |actions| {
                if so_far == Ordering::Equal && actions.len().is_multiple_of(3) {
                    let digit = three(&actions[actions.len() - 3..]);
                    so_far = digit.cmp(&char::from(least.as_bytes()[before + actions.len() / 3 - 1]));
                }
                so_far != Ordering::Greater
            });
            let word = walk.map(|walk| walk.word());
            if let Some(word) = word.filter(|word| least.is_empty() || *word < least) {
                least = word;
            }
        }
        least
    })
}

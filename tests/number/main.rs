//! The numbers: each claim of spec/numbers.md against a second derivation.

mod elementary;
mod filter;
mod interval;
mod perturbed;
mod polynomial;
mod surd;
mod text;

#[cfg(feature = "quickcheck")]
mod arbitrary;

// The strategies belong to a feature of the crate. The tests take their source, so that they run without it too.
#[path = "../../src/number/strategy.rs"]
mod strategy;
mod number {
    pub use isoracle::number::*;
}

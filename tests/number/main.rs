//! The numbers: each claim of spec/numbers.md against a second derivation.

mod text;

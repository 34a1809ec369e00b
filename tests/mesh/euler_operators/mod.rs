//! Euler operators: on all small boundaries, on random ones, and for the meshes that everybody knows.

mod building;
mod canonical;
mod claims;
mod meshes;
mod random;
mod small;
mod states;
mod words;

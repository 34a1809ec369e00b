//! The exact answer that geometry code is checked against.
//!
//! | room | what it holds |
//! |---|---|
//! | [`number`] | exact numbers and enclosures: rational, ℚ(√d), intervals, polynomials, infinitesimals |
//! | [`linear`] | points, vectors, matrices, determinants |
//! | [`partition`] | disjoint sets |
//! | [`isosurface`] | multilinear interpolation, marching squares, triangles, cubes, tetrahedra |
//! | [`mesh`] | facts about any polygon mesh |
//! | [`complex`] | closed 3-complexes: polyhedra glued face to face, and their tetrahedra |
//! | [`curvature`] | jets; curvature of plane curves and surfaces, parametric and implicit |
//! | [`spline`] | cubic B-splines: interpolation, derivatives, curvature of what they interpolate |
//! | [`format`](mod@format) | bytes ↔ unchecked records |
//! | [`picture`] | realised complexes drawn: a still, a turning page, files for other programs |
//! | [`answer`] | the question-and-answer protocol |
//! | [`judge`] | the harness that judges a candidate |
//! | [`spec`] | the formulas that are checked, each with its verdict |
//!
//! ```
//! use isoracle::isosurface::cell::{Tie, topology};
//! use isoracle::number::Rational;
//!
//! let values = [-3, 1, 1, 1, 1, 1, 1, -4].map(Rational::from);
//! let truth = topology(&values, &Rational::new(), Tie::Degenerate)?;
//! assert_eq!(truth.case.name(), "4.2"); // two corners, joined by a tunnel through the cell
//! assert_eq!(truth.chi(), 0); // an annulus
//! # Ok::<(), isoracle::isosurface::cell::Degenerate>(())
//! ```
#![forbid(unsafe_code)]

#[cfg(feature = "cli")]
pub mod answer;
pub mod complex;
pub mod curvature;
#[cfg(feature = "cli")]
pub mod format;
pub mod isosurface;
#[cfg(feature = "cli")]
pub mod judge;
pub mod linear;
pub mod mesh;
pub mod number;
pub mod partition;
#[cfg(feature = "cli")]
pub mod picture;
#[cfg(feature = "cli")]
pub mod spec;
pub mod spline;

//! Placing tetrahedra in ℝⁿ: the energy against exact differences, intersections against linear programs.

mod circles;
mod domain;
mod energy;
mod intersections;
mod program;

//! Cubic B-splines: interpolation of sampled signals in one to three dimensions, exactly (002, 4(a) and 4(b)).
//!
//! Sample k stands at the point k. A finite signal of n samples is extended to all integers by its boundary rule: `mirror` is whole-sample
//! symmetric, c[−k] = c\[k] = c[2n − 2 − k], `periodic` is c\[k + n] = c\[k]. The interpolant f(x) = Σ c\[k] B₃(x − k), in several
//! dimensions the tensor product, is defined at every real point, and is C².

pub mod basis;
pub mod bspline;
pub mod cell_form;
pub mod coherence;
pub mod coherence_counterexamples;
pub mod convergence;
pub mod degree_one;
mod enclosure;
pub mod half_plane;
pub mod impulse;
pub mod infinite;
pub mod inverse;
pub mod normal_count;
pub mod partial;
pub mod piecewise;
pub mod prefilter;
pub mod prefilter_fast_exact;
pub mod printed;
pub mod recursive;
pub mod signal;
pub mod space;
pub mod specimen;
pub mod tensor;
pub mod total_curvature;

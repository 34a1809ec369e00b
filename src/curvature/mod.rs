//! Curvature: of plane curves and of surfaces, given by a parametrisation or as a level set (002, chapters 2 and 3).
//!
//! One convention, kept everywhere. A level set of f has the unit normal N = +∇f/|∇f|, toward larger f; a parametrised
//! surface N = (σᵤ × σᵥ)/|σᵤ × σᵥ|. The principal curvatures k₁ ≥ k₂ are the eigenvalues of −dN on the tangent plane,
//! K = k₁k₂, H = (k₁ + k₂)/2. So the sphere x² + y² + z² = r², as a level set, has k₁ = k₂ = H = −1/r, and K = 1/r² either way.
//! A plane curve has the unit tangent t, the normal n = Jt, J turning by +90°, and κ = ⟨dt/ds, n⟩; on a level curve
//! t = (f_y, −f_x)/|∇f|, so that n = +∇f/|∇f| too.
//!
//! Everything here is computed from [`Jet`](jet::Jet)s, exactly. What is irrational leaves as a number of ℚ(√d), as a rational
//! square with a sign, or as an enclosure.

pub mod angle_surfaces;
pub mod arc_length;
pub mod area;
pub mod chart;
pub mod circle_polynomial;
pub mod crossing;
pub mod curve_printed;
pub mod finite_topology;
pub mod frame;
pub mod gauss_map;
pub mod gradient;
pub mod graph;
pub mod implicit_curve;
pub mod implicit_function;
pub mod implicit_graph;
pub mod implicit_printed;
pub mod implicit_surface;
pub mod jet;
pub mod line_set;
pub mod motion;
pub mod normalize;
pub mod normalize_derivative;
pub mod parametric_curve;
pub mod parametric_surface;
pub mod point_kind;
pub mod principal;
pub mod principal_direction;
pub mod quadrature;
pub mod rational_curve;
pub mod regular_value;
pub mod sampled;
pub mod series;
pub mod shape_operator;
pub mod surface_geometry;
pub mod surface_printed;
pub mod tangent;
pub mod topology;
pub mod trigonometric;

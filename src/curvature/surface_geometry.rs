//! The text's exercise: tangent vectors, normal, K and H of a surface, given either way.

use super::implicit_curve::SingularPoint;
use super::implicit_graph::{Axis, tangent_basis, unit};
use super::implicit_surface;
use super::jet::Jet;
use super::parametric_surface::{self, SurfaceError};
use crate::linear::Vector;
use crate::number::{Rational, Surd};

/// What the program of exercise 3.12 finds at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SurfaceGeometry {
    /// Two tangent vectors, linearly independent: σᵤ, σᵥ, or those of a graph over a coordinate plane.
    pub tangents: [Vector<Rational, 3>; 2],
    /// N, in ℚ(√d).
    pub normal: Vector<Surd, 3>,
    /// K.
    pub gaussian: Rational,
    /// H, in ℚ(√d).
    pub mean: Surd,
}

/// Of a level surface, with N = +∇f/|∇f|. CU-171.
///
/// # Errors
/// iff ∇f = 0.
#[doc(alias = "CU-171")]
pub fn of_level(jet: &Jet<Rational, 3>) -> Result<SurfaceGeometry, SingularPoint> {
    let level = implicit_surface::curvature(jet)?;
    let tangents = Axis::ALL.iter().find_map(|&axis| tangent_basis(jet, axis).ok());
    let tangents = tangents.expect("∇f ≠ 0");
    let mean = level.principal().mean();
    Ok(SurfaceGeometry { tangents, normal: level.unit_normal(), gaussian: level.gaussian, mean })
}

/// Of a parametrised surface, with N = σᵤ × σᵥ/|σᵤ × σᵥ|. CU-171.
///
/// # Errors
/// `Singular` iff σᵤ × σᵥ = 0.
pub fn of_parametrisation(surface: &[Jet<Rational, 2>; 3]) -> Result<SurfaceGeometry, SurfaceError> {
    let curvature = parametric_surface::curvature(surface)?;
    let tangents = [0, 1].map(|i| Vector(surface.each_ref().map(|x| x.gradient[i].clone())));
    let (normal, mean) = (unit(&curvature.forms.normal_w), curvature.principal().mean());
    Ok(SurfaceGeometry { tangents, normal, gaussian: curvature.gaussian, mean })
}

//! A level curve as the graph of a function g, by the implicit function theorem: the way of 002, 3(b).

use super::implicit_curve::{SingularPoint, kappa_numerator};
use super::jet::Jet;
use crate::linear::Vector;
use crate::number::{OrderedField, Rational, Sign, Surd};
use thiserror::Error;

/// Which axis the level curve is a graph over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// y = g(x), where f_y ≠ 0.
    X,
    /// x = g(y), where f_x ≠ 0.
    Y,
}

/// The level curve is no graph over that axis: the derivative along the other one is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("no graph over this axis: the derivative along the other one is zero")]
pub struct NoGraph;

/// A graph y = g(x) at a point: g_x and g_xx.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graph {
    /// g_x.
    pub slope: Rational,
    /// g_xx.
    pub second: Rational,
}

/// Unit tangent, unit normal and curvature of a plane curve at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CurveElements {
    /// t.
    pub tangent: Vector<Surd, 2>,
    /// n = Jt.
    pub normal: Vector<Surd, 2>,
    /// κ = ⟨dt/ds, n⟩.
    pub kappa: Surd,
}

/// g_x = −f_x/f_y and g_xx = −f_xx/f_y + 2f_xy f_x/f_y² − f_yy f_x²/f_y³, for the level curve as y = g(x); with x and y exchanged for x = g(y). CU-132.
///
/// # Errors
/// iff f_y = 0, or f_x for the other axis: the theorem promises no graph.
#[doc(alias = "CU-130")]
#[doc(alias = "CU-132")]
pub fn graph(jet: &Jet<Rational, 2>, over: Axis) -> Result<Graph, NoGraph> {
    let ([fx, fy], [[fxx, fxy], [_, fyy]]) = (&jet.gradient.0, &jet.hessian.0);
    let (fx, fy, fxx, fyy) = match over {
        Axis::X => (fx, fy, fxx, fyy),
        Axis::Y => (fy, fx, fyy, fxx),
    };
    let inverse = fy.inverse().ok_or(NoGraph)?;
    let ratio = Rational::from(fx * &inverse);
    let mixed = Rational::from(fxy * &ratio) * 2_u32;
    let square = Rational::from(ratio.square_ref());
    let second = (mixed - fxx - Rational::from(fyy * &square)) * &inverse;
    Ok(Graph { slope: -ratio, second })
}

impl Graph {
    /// t = (1, g_x)/√(1 + g_x²), n = (−g_x, 1)/√(1 + g_x²), κ = g_xx/√(1 + g_x²)³: of the graph over x, run through in the direction of
    /// growing x. CU-131.
    #[doc(alias = "CU-131")]
    #[doc(alias = "CU-135")]
    pub fn elements(&self) -> CurveElements {
        let w = Rational::from(self.slope.square_ref()) + 1_u32;
        let one = Rational::from(1);
        CurveElements {
            tangent: Vector([over_root(&one, &w), over_root(&self.slope, &w)]),
            normal: Vector([over_root(&-self.slope.clone(), &w), over_root(&one, &w)]),
            kappa: over_root(&Rational::from(&self.second / &w), &w),
        }
    }
}

/// x/√w.
fn over_root(x: &Rational, w: &Rational) -> Surd {
    Surd::new(Rational::new(), Rational::from(x / w), w).expect("w is a sum of squares")
}

/// t = (f_y, −f_x)/|∇f|, n = (f_x, f_y)/|∇f|, κ = −(f_xx f_y² − 2f_xy f_x f_y + f_yy f_x²)/|∇f|³. CU-133, CU-134.
///
/// Where f_y > 0 they are those of the graph over x; where f_y < 0 the curve is run through the other way, and all three have the other sign.
///
/// # Errors
/// iff ∇f = 0.
#[doc(alias = "CU-133")]
#[doc(alias = "CU-134")]
#[doc(alias = "CU-136")]
#[doc(alias = "CU-137")]
#[doc(alias = "CU-138")]
pub fn level_elements(jet: &Jet<Rational, 2>) -> Result<CurveElements, SingularPoint> {
    let w = jet.gradient.norm_squared();
    if w.sign() == Sign::Zero {
        return Err(SingularPoint);
    }
    let [fx, fy] = &jet.gradient.0;
    Ok(CurveElements {
        tangent: Vector([over_root(fy, &w), over_root(&-fx.clone(), &w)]),
        normal: Vector([over_root(fx, &w), over_root(fy, &w)]),
        kappa: over_root(&-(kappa_numerator(jet) / &w), &w),
    })
}

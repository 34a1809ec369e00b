//! The moving frame of a plane curve, its curvature as a number, and its osculating circle.

use super::crossing::multiplicity;
use super::jet::Jet;
use super::parametric_curve::{CurveError, kappa_numerator};
use super::rational_curve::RationalCurve;
use crate::linear::Vector;
use crate::number::{Polynomial, Rational, Surd};
use thiserror::Error;

/// J: by +90°. CU-32.
#[doc(alias = "CU-32")]
#[doc(alias = "CU-33")]
pub fn quarter_turn(Vector([x, y]): &Vector<Rational, 2>) -> Vector<Rational, 2> {
    Vector([-y.clone(), x.clone()])
}

/// A regular plane curve at a parameter, up to its second derivative; every derivative by the arc length is rational, but for κ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// α′ ≠ 0.
    velocity: Vector<Rational, 2>,
    /// α″.
    acceleration: Vector<Rational, 2>,
    /// det(α′, α″).
    determinant: Rational,
}

impl Frame {
    /// Of the curve's 2-jets.
    ///
    /// # Errors
    /// `Singular` iff α′ = 0.
    pub fn new(curve: &[Jet<Rational, 1>; 2]) -> Result<Frame, CurveError> {
        let velocity = Vector(curve.each_ref().map(|f| f.gradient[0].clone()));
        let acceleration = Vector(curve.each_ref().map(|f| f.hessian.0[0][0].clone()));
        if velocity.norm_squared().is_zero() {
            return Err(CurveError::Singular);
        }
        Ok(Frame { velocity, acceleration, determinant: kappa_numerator(curve) })
    }

    /// |α′|².
    pub fn speed_squared(&self) -> Rational {
        self.velocity.norm_squared()
    }

    /// t = α′/|α′|, in ℚ(√|α′|²). CU-13.
    #[doc(alias = "CU-13")]
    pub fn tangent(&self) -> Vector<Surd, 2> {
        self.unit(&self.velocity)
    }

    /// n = Jt. CU-32.
    pub fn normal(&self) -> Vector<Surd, 2> {
        self.unit(&quarter_turn(&self.velocity))
    }

    /// v/|α′|.
    fn unit(&self, v: &Vector<Rational, 2>) -> Vector<Surd, 2> {
        let w = self.speed_squared();
        let over_root = |x: &Rational| Surd::new(Rational::new(), Rational::from(x / &w), &w);
        v.map(|x| over_root(x).expect("a sum of squares is not negative"))
    }

    /// κ = det(α′, α″)/|α′|³, in ℚ(√|α′|²). CU-47, CU-39.
    #[doc(alias = "CU-47")]
    #[doc(alias = "CU-48")]
    #[doc(alias = "CU-35")]
    #[doc(alias = "CU-39")]
    pub fn kappa(&self) -> Surd {
        let w = self.speed_squared();
        let factor = Rational::from(&self.determinant / &w) / &w;
        Surd::new(Rational::new(), factor, &w).expect("a sum of squares is not negative")
    }

    /// d²α/ds² = dt/ds = (α″ − ⟨α″, t⟩t)/|α′|², by the quotient rule. CU-34, CU-36, CU-37.
    #[doc(alias = "CU-34")]
    #[doc(alias = "CU-37")]
    pub fn tangent_derivative(&self) -> Vector<Rational, 2> {
        let w = self.speed_squared();
        let along = self.velocity.dot(&self.acceleration) / &w;
        let across = self.acceleration.clone() + &-self.velocity.scaled(&along);
        across.map(|x| Rational::from(x / &w))
    }

    /// κn = det(α′, α″)Jα′/|α′|⁴, to which dt/ds is equal (Frenet). CU-36.
    #[doc(alias = "CU-36")]
    pub fn kappa_normal(&self) -> Vector<Rational, 2> {
        let w = self.speed_squared();
        quarter_turn(&self.velocity).map(|x| Rational::from(x * &self.determinant) / &w / &w)
    }

    /// −κt = −det(α′, α″)α′/|α′|⁴, to which dn/ds is equal (Frenet). CU-36.
    pub fn minus_kappa_tangent(&self) -> Vector<Rational, 2> {
        let w = self.speed_squared();
        self.velocity.map(|x| -(Rational::from(x * &self.determinant) / &w / &w))
    }

    /// ⟨α″, Jα′⟩: det(α′, α″) for every curve, and κ for one of unit speed. CU-38.
    #[doc(alias = "CU-38")]
    pub fn acceleration_across(&self) -> Rational {
        self.acceleration.dot(&quarter_turn(&self.velocity))
    }
}

/// A circle by its centre and the square of its radius.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Circle {
    /// c.
    pub centre: Vector<Rational, 2>,
    /// R² > 0.
    pub radius_squared: Rational,
}

/// Why there is no osculating circle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum OsculationError {
    /// The curve is not defined or not regular there.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// κ = 0: it is the tangent line that comes closest.
    #[error("no circle: the curvature is zero")]
    Flat,
}

/// The circle that meets the curve at t to the second order at least: c = α + (|α′|²/det(α′, α″))Jα′, R² = |α′|⁶/det(α′, α″)². CU-41.
///
/// # Errors
/// `Curve` iff α has a pole at t or α′ = 0; `Flat` iff κ = 0.
#[doc(alias = "CU-41")]
#[doc(alias = "CU-42")]
#[doc(alias = "CU-43")]
pub fn osculating_circle(curve: &RationalCurve<2>, t: &Rational) -> Result<Circle, OsculationError> {
    let jets = curve.jets(t).ok_or(CurveError::Pole)?;
    let frame = Frame::new(&jets)?;
    if frame.determinant.is_zero() {
        return Err(OsculationError::Flat);
    }
    let w = frame.speed_squared();
    let factor = Rational::from(&w / &frame.determinant);
    let point = Vector(jets.each_ref().map(|f| f.value.clone()));
    let centre = point + &quarter_turn(&frame.velocity).scaled(&factor);
    Ok(Circle { centre, radius_squared: factor.square() * w })
}

/// How often a curve meets a circle at t: the multiplicity of the root t of |α − c|² − R², the order of contact and 1; 0 off the circle.
/// `None` where the curve lies on the circle throughout, or has a pole at t. CU-41.
pub fn contact(curve: &RationalCurve<2>, circle: &Circle, t: &Rational) -> Option<usize> {
    curve.point(t)?;
    let constant = |x: &Rational| Polynomial::new(vec![x.clone()]);
    let q = curve.denominator();
    let terms = curve.numerators().iter().zip(&circle.centre.0).map(|(p, c)| p.clone() - &(q.clone() * &constant(c)));
    let radius = q.clone() * q * &-constant(&circle.radius_squared);
    let difference = terms.fold(radius, |sum, x| sum + &(x.clone() * &x));
    multiplicity(&difference, t)
}

/// How often a curve meets its tangent at t, as [`contact`]; `None` where it lies on the tangent throughout. It is 2 where κ ≠ 0, more where
/// κ = 0, and the curve crosses its tangent iff it is odd: at an inflection. CU-40.
///
/// # Errors
/// iff α has a pole at t or α′ = 0.
#[doc(alias = "CU-40")]
pub fn tangent_contact(curve: &RationalCurve<2>, t: &Rational) -> Result<Option<usize>, CurveError> {
    let jets = curve.jets(t).ok_or(CurveError::Pole)?;
    let Vector([a, b]) = quarter_turn(&Frame::new(&jets)?.velocity);
    let constant = |x: Rational| Polynomial::new(vec![x]);
    let offset = Rational::from(&a * &jets[0].value) + Rational::from(&b * &jets[1].value);
    let [x, y] = curve.numerators();
    let line = x.clone() * &constant(a) + &(y.clone() * &constant(b));
    let difference = line - &(curve.denominator().clone() * &constant(offset));
    Ok(multiplicity(&difference, t))
}

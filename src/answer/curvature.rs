//! The operations of the family `curvature`, but `curvature.spline`.

use super::message::{Out, Refusal};
use super::value::{self, EnclosureOut, Exact, InvalidField, Object, Problem, Step};
use crate::curvature::implicit_curve::{self, LevelCurve, SingularPoint};
use crate::curvature::implicit_surface::{self, LevelSurface};
use crate::curvature::jet::Jet;
use crate::curvature::normalize;
use crate::curvature::parametric_curve::{self, CurveError, PlaneCurve};
use crate::curvature::parametric_surface::{self, ParametricSurface, SurfaceError};
use crate::number::decimal::Digits;
use crate::number::{Multivariate, Rational};
use serde::Serialize;
use serde_json::Value;

/// The largest exponent that a term may have.
pub const MAX_POWER: u32 = 1000;

/// What is said of a level curve.
#[derive(Serialize)]
pub struct LevelCurveOut {
    value: Exact,
    gradient: [Exact; 2],
    kappa_squared: Exact,
    kappa_sign: i8,
}

impl LevelCurveOut {
    /// What is said of the level curve through a point.
    ///
    /// # Errors
    /// iff the gradient is zero there.
    pub fn new(jet: &Jet<Rational, 2>) -> Result<LevelCurveOut, SingularPoint> {
        let LevelCurve { value, gradient, kappa_squared, kappa_sign } = implicit_curve::curvature(jet)?;
        let (gradient, kappa_sign) = (gradient.0.map(Exact), kappa_sign.value());
        Ok(LevelCurveOut { value: Exact(value), gradient, kappa_squared: Exact(kappa_squared), kappa_sign })
    }
}

/// What is said of a level surface.
#[derive(Serialize)]
pub struct LevelSurfaceOut {
    value: Exact,
    gradient: [Exact; 3],
    hessian: [[Exact; 3]; 3],
    gaussian: Exact,
    mean_squared: Exact,
    mean_sign: i8,
    discriminant: Exact,
    principal: [EnclosureOut; 2],
}

impl LevelSurfaceOut {
    /// What is said of the level surface through a point.
    ///
    /// # Errors
    /// iff the gradient is zero there.
    pub fn new(jet: &Jet<Rational, 3>, digits: Digits) -> Result<LevelSurfaceOut, SingularPoint> {
        let surface = implicit_surface::curvature(jet)?;
        let (discriminant, principal) = (surface.discriminant(), surface.principal());
        let LevelSurface { value, gradient, hessian, gaussian, mean_squared, mean_sign } = surface;
        Ok(LevelSurfaceOut {
            value: Exact(value),
            gradient: gradient.0.map(Exact),
            hessian: hessian.0.map(|row| row.map(Exact)),
            gaussian: Exact(gaussian),
            mean_squared: Exact(mean_squared),
            mean_sign: mean_sign.value(),
            discriminant: Exact(discriminant),
            principal: principal.decimals(digits).map(EnclosureOut::from),
        })
    }
}

#[derive(Serialize)]
struct ParametricCurveOut {
    point: [Exact; 2],
    speed_squared: Exact,
    kappa_squared: Exact,
    kappa_sign: i8,
}

#[derive(Serialize)]
struct ParametricSurfaceOut {
    #[serde(rename = "E")]
    e: Exact,
    #[serde(rename = "F")]
    f: Exact,
    #[serde(rename = "G")]
    g: Exact,
    w_squared: Exact,
    w_e: Exact,
    w_f: Exact,
    w_g: Exact,
    gaussian: Exact,
    mean_squared: Exact,
    mean_sign: i8,
    weingarten_w: [[Exact; 2]; 2],
    principal: [EnclosureOut; 2],
}

#[derive(Serialize)]
struct NormalizeOut {
    value: EnclosureOut,
}

/// `curvature.implicit_curve` in `{polynomial:[[coef,i,j],…], point}`.
pub fn implicit_curve(input: &Object) -> Result<Out, Refusal> {
    let polynomial = value::field(input, "polynomial", polynomial::<2>)?;
    let point = value::field(input, "point", value::numbers)?;
    let curve = LevelCurveOut::new(&Jet::of_polynomial(&polynomial, &point));
    curve.map(|out| Out::new(&out)).map_err(|error| Refusal::SingularPoint { field: "point", index: None, error })
}

/// `curvature.implicit_surface` in `{polynomial:[[coef,i,j,k],…], point, digits?}`.
pub fn implicit_surface(input: &Object) -> Result<Out, Refusal> {
    let polynomial = value::field(input, "polynomial", polynomial::<3>)?;
    let point = value::field(input, "point", value::numbers)?;
    let digits = value::optional(input, "digits", value::digits)?.unwrap_or_default();
    let surface = LevelSurfaceOut::new(&Jet::of_polynomial(&polynomial, &point), digits);
    surface.map(|out| Out::new(&out)).map_err(|error| Refusal::SingularPoint { field: "point", index: None, error })
}

/// `curvature.parametric_curve` in `{numerators:[poly,poly], denominator:poly, t}`.
pub fn parametric_curve(input: &Object) -> Result<Out, Refusal> {
    let numerators: [Multivariate<1>; 2] = value::field(input, "numerators", |n| value::exactly(n, polynomial))?;
    let denominator = value::field(input, "denominator", polynomial)?;
    let t = value::field(input, "t", value::number)?;
    let curve = quotients(&numerators, &denominator, &[t]).ok_or(CurveError::Pole)?;
    let PlaneCurve { point, speed_squared, kappa_squared, kappa_sign } = parametric_curve::curvature(&curve)?;
    Ok(Out::new(&ParametricCurveOut {
        point: point.0.map(Exact),
        speed_squared: Exact(speed_squared),
        kappa_squared: Exact(kappa_squared),
        kappa_sign: kappa_sign.value(),
    }))
}

/// `curvature.parametric_surface` in `{numerators:[poly,poly,poly], denominator:poly, point:[u,v], digits?}`.
pub fn parametric_surface(input: &Object) -> Result<Out, Refusal> {
    let numerators: [Multivariate<2>; 3] = value::field(input, "numerators", |n| value::exactly(n, polynomial))?;
    let denominator = value::field(input, "denominator", polynomial)?;
    let point = value::field(input, "point", value::numbers)?;
    let digits = value::optional(input, "digits", value::digits)?.unwrap_or_default();
    let surface = quotients(&numerators, &denominator, &point).ok_or(SurfaceError::Pole)?;
    let surface = parametric_surface::curvature(&surface)?;
    let (weingarten, principal) = (surface.weingarten_w(), surface.principal().decimals(digits));
    let ParametricSurface { forms, w_squared, gaussian, mean_squared, mean_sign } = surface;
    let ([e, f, g], [w_e, w_f, w_g]) = (forms.first.map(Exact), forms.second_w.map(Exact));
    Ok(Out::new(&ParametricSurfaceOut {
        e,
        f,
        g,
        w_squared: Exact(w_squared),
        w_e,
        w_f,
        w_g,
        gaussian: Exact(gaussian),
        mean_squared: Exact(mean_squared),
        mean_sign: mean_sign.value(),
        weingarten_w: weingarten.0.map(|row| row.map(Exact)),
        principal: principal.map(EnclosureOut::from),
    }))
}

/// `curvature.normalize` in `{lambda, x, digits?}`.
pub fn normalize(input: &Object) -> Result<Out, Refusal> {
    let slope = value::field(input, "lambda", value::number)?;
    let x = value::field(input, "x", value::number)?;
    let digits = value::optional(input, "digits", value::digits)?.unwrap_or_default();
    let value = normalize::decimals(&slope, &x, digits);
    let value = value.map_err(|error| InvalidField::here(Problem::Slope(error)).within(Step::Field("lambda")))?;
    Ok(Out::new(&NormalizeOut { value: value.into() }))
}

/// A polynomial in N variables: `[[coef, i, j, …], …]`, coefficient and exponents; terms of the same exponents are added up.
pub fn polynomial<const N: usize>(value: &Value) -> Result<Multivariate<N>, InvalidField> {
    Ok(Multivariate::new(value::items(value, term)?))
}

fn term<const N: usize>(value: &Value) -> Result<([u32; N], Rational), InvalidField> {
    let items = value::list(value)?;
    if items.len() != N + 1 {
        return Err(InvalidField::here(Problem::Length { expected: N + 1, found: items.len() }));
    }
    let at = |i: usize| move |error: InvalidField| error.within(Step::Item(i));
    let coefficient = value::number(&items[0]).map_err(at(0))?;
    let mut exponents = [0; N];
    for (axis, exponent) in exponents.iter_mut().enumerate() {
        *exponent = power(&items[axis + 1]).map_err(at(axis + 1))?;
    }
    Ok((exponents, coefficient))
}

fn power(value: &Value) -> Result<u32, InvalidField> {
    match value::number(value)? {
        n if n.is_integer() && n >= 0 => n.numer().to_u32().filter(|n| *n <= MAX_POWER).ok_or(n),
        n => return Err(InvalidField::here(Problem::Exponent(n))),
    }
    .map_err(|n| InvalidField::here(Problem::LargeExponent { found: n, limit: MAX_POWER }))
}

/// The jets of quotients; `None` where the denominator is zero.
fn quotients<const N: usize, const C: usize>(
    numerators: &[Multivariate<N>; C],
    denominator: &Multivariate<N>,
    at: &[Rational; N],
) -> Option<[Jet<Rational, N>; C]> {
    let reciprocal = Jet::of_polynomial(denominator, at).reciprocal()?;
    Some(numerators.each_ref().map(|numerator| Jet::of_polynomial(numerator, at) * &reciprocal))
}

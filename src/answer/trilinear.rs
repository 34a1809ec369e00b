//! The operations of the family `trilinear`.

use super::message::{Out, Refusal};
use super::value::{self, Exact, Object};
use crate::isosurface::multilinear;
use crate::number::Rational;
use serde::Serialize;

#[derive(Serialize)]
struct EvaluateOut {
    values: Vec<Exact>,
    gradients: Vec<[Exact; 3]>,
}

/// `trilinear.evaluate` in `{values:[8], points:[[u,v,w],…]}`, any real points: the polynomial is not cut off at
/// the cell.
pub fn evaluate(input: &Object) -> Result<Out, Refusal> {
    let corners: [Rational; 8] = value::field(input, "values", value::numbers)?;
    let points: Vec<[Rational; 3]> = value::field(input, "points", |points| value::items(points, value::numbers))?;
    Ok(Out::new(&EvaluateOut {
        values: points.iter().map(|point| Exact(multilinear::trilinear(&corners, point))).collect(),
        gradients: points.iter().map(|point| multilinear::trilinear_gradient(&corners, point).map(Exact)).collect(),
    }))
}

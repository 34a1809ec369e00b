//! How large the terms are that an answer is a sum of: what its error is relative to.

use super::real::{Real, largest};
use crate::answer::curvature::polynomial;
use crate::answer::value;
use crate::judge::fault::truth;
use crate::number::text::parse;
use crate::number::{Integer, Rational};
use crate::spline::impulse::{Samples, coefficient};
use serde_json::Value;

/// Of splines the largest coefficient, of polynomials the largest term at the point; `None` for other operations, and for questions
/// without an answer.
pub fn of(operation: &str, input: &Value) -> Option<Real> {
    match operation {
        "spline.evaluate" | "curvature.spline" => {
            let out = truth("spline.coefficients", input).ok()?;
            let numbers = value::items(&out["coefficients"], value::number).ok()?;
            largest_of(numbers.into_iter().map(Real::from).collect())
        }
        "spline.impulse" => largest_coefficient(input),
        "curvature.implicit_curve" => largest_term::<2>(input),
        "curvature.implicit_surface" => largest_term::<3>(input),
        _ => None,
    }
}

fn largest_of(mut numbers: Vec<Real>) -> Option<Real> {
    let index = largest(&numbers);
    (index < numbers.len()).then(|| numbers.swap_remove(index))
}

/// The largest coefficient on all of ℤ stands at a sample: at every other place c\[k−1] + 4c\[k] + c\[k+1] = 0, so that |c\[k]| is at most
/// half of its larger neighbour, and beyond the samples they fall by 2 − √3 a step.
fn largest_coefficient(input: &Value) -> Option<Real> {
    let mut samples = Samples::new();
    for (key, sample) in input["samples"].as_object()? {
        let k: Integer = parse(key).ok()?.into_numer_denom().0;
        samples.insert(k, value::number(sample).ok()?);
    }
    let coefficients: Option<Vec<Real>> = samples.keys().map(|k| coefficient(&samples, k).map(Real::Surd)).collect();
    Some(largest_of(coefficients?).unwrap_or_else(|| Real::from(Rational::new())))
}

fn largest_term<const N: usize>(input: &Value) -> Option<Real> {
    let terms = polynomial::<N>(&input["polynomial"]).ok()?;
    let point: [Rational; N] = value::numbers(&input["point"]).ok()?;
    let term = |(exponents, coefficient): ([u32; N], &Rational)| {
        let powers = exponents.iter().zip(&point).map(|(n, x)| (0..*n).fold(Rational::from(1), |power, _| power * x));
        powers.fold(coefficient.clone(), |product, power| product * power)
    };
    let terms: Vec<Real> = terms.terms().map(term).map(Real::from).collect();
    Some(largest_of(terms).unwrap_or_else(|| Real::from(Rational::new())))
}

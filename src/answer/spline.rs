//! The operations of the family `spline`, and `curvature.spline`.

use super::curvature::{LevelCurveOut, LevelSurfaceOut};
use super::message::{Out, Refusal};
use super::value::{self, Exact, InvalidField, Object, Problem, Step};
use crate::curvature::jet::Jet;
use crate::number::{Integer, Rational, Surd};
use crate::spline::impulse::{self, Samples};
use crate::spline::prefilter;
use crate::spline::signal::{Boundary, Signal, check_shape};
use crate::spline::tensor::Spline;
use serde::Serialize;
use serde_json::Value;

/// The most samples of a signal whose coefficients are worked out exactly.
pub const MAX_EXACT_SAMPLES: usize = 1 << 19;

/// How far apart samples, coefficients and points of `spline.impulse` may be.
pub const MAX_DISTANCE: u32 = 10_000;

/// A signal of one, two or three axes.
enum AnySignal {
    One(Signal<1>),
    Two(Signal<2>),
    Three(Signal<3>),
}

#[derive(Serialize)]
struct CoefficientsOut {
    coefficients: Vec<Exact>,
}

#[derive(Serialize)]
struct EvaluateOut {
    values: Vec<Vec<Exact>>,
}

#[derive(Serialize)]
struct CurvatureOut<T> {
    points: Vec<T>,
}

#[derive(Serialize)]
struct ImpulseOut {
    coefficients: Vec<RootThreeOut>,
    values: Vec<RootThreeOut>,
    d1: Vec<RootThreeOut>,
    d2: Vec<RootThreeOut>,
}

/// a + b√3, its d written even where b = 0.
#[derive(Serialize)]
struct RootThreeOut {
    a: Exact,
    b: Exact,
    d: u8,
}

impl From<Surd> for RootThreeOut {
    fn from(x: Surd) -> RootThreeOut {
        let (a, b, _) = x.parts();
        RootThreeOut { a: Exact(a.clone()), b: Exact(b.clone()), d: 3 }
    }
}

/// `spline.coefficients` in `{values, shape, boundary}`.
pub fn coefficients(input: &Object) -> Result<Out, Refusal> {
    fn of<const N: usize>(signal: &Signal<N>) -> Out {
        let coefficients = prefilter::interpolate(signal).coefficients().values().iter().cloned().map(Exact).collect();
        Out::new(&CoefficientsOut { coefficients })
    }
    Ok(match signal(input)? {
        AnySignal::One(signal) => of(&signal),
        AnySignal::Two(signal) => of(&signal),
        AnySignal::Three(signal) => of(&signal),
    })
}

/// `spline.evaluate` in `{values, shape, boundary, points, derivatives?}`; without `derivatives` the value alone.
///
/// A derivative is a word of the letters x, y, z, each at most twice and in any order: `""`, `"x"`, `"xy"`, `"zz"`.
pub fn evaluate(input: &Object) -> Result<Out, Refusal> {
    fn of<const N: usize>(input: &Object, signal: &Signal<N>) -> Result<Out, Refusal> {
        let points = value::field(input, "points", |points| value::items(points, value::numbers::<N>))?;
        let orders = value::optional(input, "derivatives", |words| value::items(words, orders::<N>))?;
        let orders = orders.unwrap_or_else(|| vec![[0; N]]);
        let spline = prefilter::interpolate(signal);
        let at = |point: &_| orders.iter().map(|n| Exact(spline.derivative(point, *n))).collect();
        Ok(Out::new(&EvaluateOut { values: points.iter().map(at).collect() }))
    }
    match signal(input)? {
        AnySignal::One(signal) => of(input, &signal),
        AnySignal::Two(signal) => of(input, &signal),
        AnySignal::Three(signal) => of(input, &signal),
    }
}

/// `spline.impulse` in `{samples:{"k":g,…}, k_from, k_to, points}`.
pub fn impulse(input: &Object) -> Result<Out, Refusal> {
    let samples = value::field(input, "samples", samples)?;
    let place = |k: &_| place(k, &samples);
    let k_from = value::field(input, "k_from", |k| place(&integer(k)?))?;
    let k_to = value::field(input, "k_to", |k| place(&integer(k)?))?;
    let count: Integer = Integer::from(&k_to - &k_from) + 1;
    let count = count.to_u32().ok_or_else(|| InvalidField::here(Problem::EmptyRange).within(Step::Field("k_to")))?;
    let points = value::field(input, "points", |points| {
        value::items(points, |point| {
            let x = value::number(point)?;
            place(&x.clone().floor().into_numer_denom().0).map(|_| x)
        })
    })?;
    let near = "every distance is within the limit";
    let coefficients =
        (0..count).map(|k| impulse::coefficient(&samples, &Integer::from(&k_from + k)).expect(near).into());
    let [values, d1, d2] =
        [0, 1, 2].map(|n| points.iter().map(|x| impulse::derivative(&samples, x, n).expect(near).into()).collect());
    Ok(Out::new(&ImpulseOut { coefficients: coefficients.collect(), values, d1, d2 }))
}

/// `curvature.spline` in `{values, shape, boundary, points, digits?}`, in two or three dimensions.
pub fn curvature(input: &Object) -> Result<Out, Refusal> {
    let digits = value::optional(input, "digits", value::digits)?.unwrap_or_default();
    let singular = |index| move |error| Refusal::SingularPoint { field: "points", index: Some(index), error };
    match signal(input)? {
        AnySignal::One(_) => Err(InvalidField::here(Problem::NoCurvature).within(Step::Field("shape")).into()),
        AnySignal::Two(signal) => {
            let jets = jets(input, &signal)?;
            let points = jets.iter().enumerate().map(|(i, jet)| LevelCurveOut::new(jet).map_err(singular(i)));
            Ok(Out::new(&CurvatureOut { points: points.collect::<Result<Vec<_>, _>>()? }))
        }
        AnySignal::Three(signal) => {
            let jets = jets(input, &signal)?;
            let points = jets.iter().enumerate().map(|(i, jet)| LevelSurfaceOut::new(jet, digits).map_err(singular(i)));
            Ok(Out::new(&CurvatureOut { points: points.collect::<Result<Vec<_>, _>>()? }))
        }
    }
}

/// The jets of the signal's spline at the `points`.
fn jets<const N: usize>(input: &Object, signal: &Signal<N>) -> Result<Vec<Jet<Rational, N>>, InvalidField> {
    let points = value::field(input, "points", |points| value::items(points, value::numbers::<N>))?;
    let spline: Spline<N> = prefilter::interpolate(signal);
    Ok(points.iter().map(|point| spline.jet(point)).collect())
}

/// `{values, shape, boundary}`.
fn signal(input: &Object) -> Result<AnySignal, InvalidField> {
    let boundary = value::field(input, "boundary", |word| {
        value::word(
            word,
            "\"mirror\" or \"periodic\"",
            &[("mirror", Boundary::Mirror), ("periodic", Boundary::Periodic)],
        )
    })?;
    let shape = value::field(input, "shape", |shape| match value::items(shape, side)? {
        shape if (1..=3).contains(&shape.len()) => Ok(shape),
        shape => Err(InvalidField::here(Problem::Axes { found: shape.len() })),
    })?;
    let values = value::field(input, "values", |values| value::items(values, value::number))?;
    check_shape(&shape, values.len()).map_err(|error| InvalidField::here(Problem::Signal(error)))?;
    if values.len() > MAX_EXACT_SAMPLES {
        return Err(InvalidField::here(Problem::LongSignal { limit: MAX_EXACT_SAMPLES }).within(Step::Field("values")));
    }
    let checked = "the shape and the number of values were checked";
    match *shape.as_slice() {
        [n] => Ok(AnySignal::One(Signal::new([n], values, boundary).expect(checked))),
        [nx, ny] => Ok(AnySignal::Two(Signal::new([nx, ny], values, boundary).expect(checked))),
        [nx, ny, nz] => Ok(AnySignal::Three(Signal::new([nx, ny, nz], values, boundary).expect(checked))),
        _ => unreachable!("the number of axes was checked"),
    }
}

/// A number of samples. One beyond any address is the greatest there is, which no list fills.
fn side(value: &Value) -> Result<usize, InvalidField> {
    match value::number(value)? {
        n if n.is_integer() && n >= 2 => Ok(n.numer().to_usize().unwrap_or(usize::MAX)),
        n => Err(InvalidField::here(Problem::Side(n))),
    }
}

/// How often a derivative is taken along each axis.
fn orders<const N: usize>(word: &Value) -> Result<[u32; N], InvalidField> {
    let text = value::string(word)?;
    let unknown = || InvalidField::here(Problem::Derivative { found: text.chars().take(40).collect(), axes: N });
    let mut orders = [0; N];
    for letter in text.chars() {
        let axis = "xyz".find(letter).filter(|axis| *axis < N).ok_or_else(unknown)?;
        orders[axis] += 1;
        if orders[axis] > 2 {
            return Err(unknown());
        }
    }
    Ok(orders)
}

/// `{"k":g,…}`, k an integer.
fn samples(value: &Value) -> Result<Samples, InvalidField> {
    let mut samples = Samples::new();
    for (key, sample) in value::object(value)? {
        let k = integer(&Value::String(key.clone())).map_err(|error| error.within(Step::Name(key.clone())))?;
        let sample = value::number(sample).map_err(|error| error.within(Step::Name(key.clone())))?;
        if samples.insert(k, sample).is_some() {
            return Err(InvalidField::here(Problem::SampleTwice).within(Step::Name(key.clone())));
        }
    }
    Ok(samples)
}

fn integer(value: &Value) -> Result<Integer, InvalidField> {
    match value::number(value)? {
        n if n.is_integer() => Ok(n.into_numer_denom().0),
        n => Err(InvalidField::here(Problem::Integer(n))),
    }
}

/// A place on ℤ that is within the limit of every sample and of 0.
fn place(k: &Integer, samples: &Samples) -> Result<Integer, InvalidField> {
    let origin = Integer::new();
    let far = samples.keys().chain([&origin]).any(|j| Integer::from(k - j).abs() > MAX_DISTANCE);
    if far { Err(InvalidField::here(Problem::Far { limit: MAX_DISTANCE })) } else { Ok(k.clone()) }
}

//! The questions of the suite `spline`.

use super::question::{Question, any, eighth, integer, nonzero, power_of_two, texts};
use crate::number::Rational;
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use serde_json::{Map, Value, json};

/// Ordinary questions: the number of axes with the boundary rule; 2 samples along an axis, hundreds of samples, constant signals,
/// one sample that is not 0; values and derivatives at points inside, at the samples, halfway between them, and where the boundary
/// rule extends the signal; signals on all of ℤ.
pub const ROWS: [&str; 17] = [
    "1d-mirror",
    "1d-periodic",
    "2d-mirror",
    "2d-periodic",
    "3d-mirror",
    "3d-periodic",
    "two-samples",
    "long-lines",
    "constants",
    "single-samples",
    "values-1d",
    "values-2d",
    "values-3d",
    "knots",
    "half-integers",
    "outside",
    "bounded-on-z",
];

/// Samples from 2⁻³⁰⁰ to 2³⁰⁰; questions that are ill-posed.
pub const GROUPS: [&str; 2] = ["huge-range", "broken"];

/// The boundary rules.
const BOUNDARIES: [&str; 2] = ["mirror", "periodic"];

/// A question of a row, the `number`th.
pub fn question(random: &mut ChaCha8Rng, row: &'static str, number: usize) -> Question {
    let boundary = BOUNDARIES[number % 2];
    let coefficients = |shape: &[usize], values: &[Rational], boundary: &str| Question {
        row,
        operation: "spline.coefficients",
        input: signal(shape, values, boundary),
    };
    match row {
        "1d-mirror" | "2d-mirror" | "3d-mirror" | "1d-periodic" | "2d-periodic" | "3d-periodic" => {
            let axes = usize::from(row.as_bytes()[0] - b'0');
            let shape = shape(random, axes, 2);
            let values = samples(random, &shape);
            coefficients(&shape, &values, row.split_once('-').expect("the boundary rule comes last").1)
        }
        "two-samples" => {
            let mut shape = shape(random, 1 + number / 2 % 3, 2);
            let axis = random.random_range(0..shape.len());
            shape[axis] = 2;
            let values = samples(random, &shape);
            coefficients(&shape, &values, boundary)
        }
        "long-lines" => {
            let n = random.random_range(100..250);
            let values = samples(random, &[n]);
            coefficients(&[n], &values, boundary)
        }
        "constants" => {
            let shape = shape(random, 1 + number / 2 % 3, 2);
            let value = any(random, 100);
            coefficients(&shape, &vec![value; shape.iter().product()], boundary)
        }
        "single-samples" => {
            let shape = shape(random, 1 + number / 2 % 3, 2);
            let mut values = vec![Rational::new(); shape.iter().product()];
            let place = random.random_range(0..values.len());
            values[place] = nonzero(random, 9);
            coefficients(&shape, &values, boundary)
        }
        "values-1d" | "values-2d" | "values-3d" => {
            let axes = usize::from(row.as_bytes()[7] - b'0');
            evaluation(random, row, axes, boundary, |random, n| (integer(random, 8 * n) / 8_u32).abs())
        }
        "knots" => evaluation(random, row, 1 + number / 2 % 3, boundary, |random, n| integer(random, n).abs()),
        "half-integers" => evaluation(random, row, 1 + number / 2 % 3, boundary, |random, n| {
            integer(random, n - 1).abs() + Rational::from((1, 2))
        }),
        "outside" => evaluation(random, row, 1 + number / 2 % 3, boundary, |random, n| eighth(random, 4 * n)),
        "bounded-on-z" => impulse(random, row),
        "huge-range" => {
            let shape = shape(random, 1 + number / 2 % 3, 2);
            let sample = |random: &mut ChaCha8Rng| nonzero(random, 9) * power_of_two(random.random_range(-300..=300));
            let values: Vec<Rational> = (0..shape.iter().product()).map(|_| sample(random)).collect();
            coefficients(&shape, &values, boundary)
        }
        "broken" => broken(random, row, number),
        other => unreachable!("no row {other}"),
    }
}

/// Random sides, for about 60 samples at most.
fn shape(random: &mut ChaCha8Rng, axes: usize, least: usize) -> Vec<usize> {
    let most = [13, 7, 5][axes - 1];
    (0..axes).map(|_| random.random_range(least..most)).collect()
}

fn samples(random: &mut ChaCha8Rng, shape: &[usize]) -> Vec<Rational> {
    (0..shape.iter().product()).map(|_| any(random, 100)).collect()
}

/// `{shape, values, boundary}`.
pub fn signal(shape: &[usize], values: &[Rational], boundary: &str) -> Value {
    json!({"shape": shape, "values": texts(values), "boundary": boundary})
}

/// Values and derivatives at a few points, each coordinate of which is drawn for the last sample's number.
fn evaluation(
    random: &mut ChaCha8Rng,
    row: &'static str,
    axes: usize,
    boundary: &str,
    coordinate: impl Fn(&mut ChaCha8Rng, i32) -> Rational,
) -> Question {
    let shape = shape(random, axes, 3);
    let values = samples(random, &shape);
    let mut input = signal(&shape, &values, boundary);
    let last = |axis: usize| i32::try_from(shape[axis] - 1).expect("few samples");
    let point = |random: &mut ChaCha8Rng| {
        let coordinates: Vec<Rational> = (0..axes).map(|axis| coordinate(random, last(axis))).collect();
        texts(&coordinates)
    };
    input["points"] = (0..random.random_range(1..5)).map(|_| point(random)).collect();
    // Without `derivatives`, the value alone is asked.
    if random.random_range(0..4) > 0 {
        input["derivatives"] = json!(WORDS[axes - 1]);
    }
    Question { row, operation: "spline.evaluate", input }
}

/// All derivatives up to the second.
const WORDS: [&[&str]; 3] =
    [&["", "x", "xx"], &["", "x", "y", "xx", "xy", "yy"], &["", "x", "y", "z", "xx", "xy", "xz", "yy", "yz", "zz"]];

fn impulse(random: &mut ChaCha8Rng, row: &'static str) -> Question {
    let count = random.random_range(1..5);
    let samples: Map<String, Value> = (0..count)
        .map(|_| (random.random_range(-9..10).to_string(), super::question::text(&nonzero(random, 9))))
        .collect();
    let from: i32 = random.random_range(-20..10);
    let points: Vec<Rational> = (0..random.random_range(0..5)).map(|_| eighth(random, 20)).collect();
    let input = json!({"samples": samples, "k_from": from, "k_to": from + random.random_range(0..20), "points": texts(&points)});
    Question { row, operation: "spline.impulse", input }
}

/// Ill-posed questions: each a good one, but for one field.
fn broken(random: &mut ChaCha8Rng, row: &'static str, number: usize) -> Question {
    let values = samples(random, &[4]);
    let mut input = signal(&[4], &values, BOUNDARIES[number % 2]);
    input["points"] = json!([["1/2"]]);
    let mut operation = "spline.coefficients";
    let faults: [(&str, &str, Value); 17] = [
        (operation, "shape", json!([5])),
        (operation, "shape", json!([2, 2, 2])),
        (operation, "shape", json!([1])),
        (operation, "shape", json!([])),
        (operation, "shape", json!([1, 4])),
        (operation, "shape", json!([2, 1, 2, 1])),
        (operation, "shape", json!("4")),
        (operation, "boundary", json!("clamped")),
        (operation, "boundary", Value::Null),
        (operation, "values", json!([1, 2, "NaN", 4])),
        (operation, "values", json!([1, 2, "1/0", 4])),
        (operation, "values", json!([1, 2, null, 4])),
        ("spline.evaluate", "points", json!([["1/2", "1/2"]])),
        ("spline.evaluate", "points", json!([["Infinity"]])),
        ("spline.evaluate", "derivatives", json!(["", "xxx"])),
        ("spline.evaluate", "derivatives", json!(["y"])),
        ("spline.impulse", "k_to", json!(-2)),
    ];
    let (asked, field, value) = faults[number % faults.len()].clone();
    if asked == "spline.impulse" {
        input = json!({"samples": {"0": "1"}, "k_from": 0, "k_to": 3, "points": []});
    }
    operation = asked;
    input[field] = value;
    if input[field].is_null() {
        input.as_object_mut().expect("it is one").remove(field);
    }
    Question { row, operation, input }
}

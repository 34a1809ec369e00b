//! Smaller questions of a row: fewer points, samples and terms, plainer numbers.

use super::Family;
use super::conditioning::{each_number, is_well_conditioned};
use super::curvature::is_of_row;
use super::question::Question;
use crate::number::Rational;
use serde_json::{Value, json};

/// How large a question is: its numbers and words, then the length of its text.
pub fn size(question: &Question) -> (usize, usize) {
    (leaves(&question.input), question.input.to_string().len())
}

fn leaves(value: &Value) -> usize {
    match value {
        Value::Array(items) => items.iter().map(leaves).sum(),
        Value::Object(fields) => fields.values().map(leaves).sum(),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => 1,
    }
}

/// Smaller questions of the same row, whose answers are of the same kind: one with an answer stays so, stays what its row's name
/// says, and well-conditioned if it was;
/// one that is degenerate stays degenerate. Ill-posed ones are as small as they are.
pub fn smaller(question: &Question) -> impl Iterator<Item = Question> {
    let (most, kind) = (size(question), question.truth().map(drop));
    let [ordinary, _] = Family::of(question.operation).rows();
    let is_ordinary = ordinary.contains(&question.row) && is_well_conditioned(question);
    let inputs = if question.row == "broken" { Vec::new() } else { inputs(&question.input) };
    let with = |input: Value, question: &Question| Question { input, ..question.clone() };
    let question = question.clone();
    inputs.into_iter().map(move |input| with(input, &question)).filter(move |smaller| {
        let truth = smaller.truth();
        size(smaller) < most
            && truth.as_ref().map_or(true, |out| is_of_row(smaller.row, out))
            && truth.map(drop) == kind
            && (!is_ordinary || is_well_conditioned(smaller))
    })
}

fn inputs(input: &Value) -> Vec<Value> {
    let mut all = Vec::new();
    for field in ["points", "derivatives", "polynomial", "denominator"] {
        all.extend(with_fewer(input, &format!("/{field}")));
    }
    for i in 0..3 {
        all.extend(with_fewer(input, &format!("/numerators/{i}")));
    }
    all.extend(samples_off(input));
    all.extend(slices_off(input));
    all.extend(shorter_range(input));
    all.extend(plainer(input));
    all
}

/// Without half of a list, or one item of it; never without any.
fn with_fewer(input: &Value, list: &str) -> Vec<Value> {
    let count = input.pointer(list).and_then(Value::as_array).map_or(0, Vec::len);
    let without = |range: std::ops::Range<usize>| {
        let mut smaller = input.clone();
        if let Some(Value::Array(items)) = smaller.pointer_mut(list) {
            items.drain(range);
        }
        smaller
    };
    let halves = if count > 3 { vec![without(0..count / 2), without(count / 2..count)] } else { Vec::new() };
    let ones = (0..count).filter(|_| count > 1).map(|i| without(i..i + 1));
    halves.into_iter().chain(ones).collect()
}

/// Without one of the samples of `spline.impulse`.
fn samples_off(input: &Value) -> Vec<Value> {
    let Some(samples) = input.get("samples").and_then(Value::as_object) else { return Vec::new() };
    let without = |key: &String| {
        let mut smaller = input.clone();
        smaller["samples"].as_object_mut().expect("it is one").remove(key);
        smaller
    };
    samples.keys().filter(|_| samples.len() > 1).map(without).collect()
}

/// Without the second half of the samples along an axis, or without the last.
fn slices_off(input: &Value) -> Vec<Value> {
    let sides = input.get("shape").and_then(Value::as_array);
    let shape: Option<Vec<usize>> =
        sides.and_then(|sides| sides.iter().map(|n| usize::try_from(n.as_u64()?).ok()).collect());
    let (Some(shape), Some(values)) = (shape, input.get("values").and_then(Value::as_array)) else {
        return Vec::new();
    };
    if shape.iter().product::<usize>() != values.len() {
        return Vec::new();
    }
    let mut all = Vec::new();
    for (axis, &n) in shape.iter().enumerate() {
        let stride: usize = shape[..axis].iter().product();
        for kept in [n / 2, n - 1].into_iter().filter(|kept| *kept >= 2 && *kept < n) {
            let stays = |i: &usize| i / stride % n < kept;
            let mut smaller = input.clone();
            smaller["values"] = (0..values.len()).filter(stays).map(|i| values[i].clone()).collect();
            smaller["shape"][axis] = json!(kept);
            all.push(smaller);
        }
    }
    all
}

/// One coefficient less is asked of `spline.impulse`.
fn shorter_range(input: &Value) -> Vec<Value> {
    let [Some(from), Some(to)] = ["k_from", "k_to"].map(|name| input.get(name).and_then(Value::as_i64)) else {
        return Vec::new();
    };
    let with = |name: &str, k: i64| {
        let mut smaller = input.clone();
        smaller[name] = json!(k);
        smaller
    };
    let middle = from + (to - from) / 2;
    let all = [with("k_to", middle), with("k_from", middle), with("k_to", to - 1), with("k_from", from + 1)];
    if to > from { all.into() } else { Vec::new() }
}

/// All numbers rounded to integers; then one number 0, 1, an integer, or halved towards 0.
fn plainer(input: &Value) -> Vec<Value> {
    let changes: [fn(Rational) -> Rational; 4] =
        [|_| Rational::new(), |_| Rational::from(1), Rational::round, |x| (x / 2_u32).trunc()];
    let mut count = 0;
    let mut rounded = input.clone();
    each_number(&mut rounded, &mut |x| {
        count += 1;
        x.round()
    });
    let one = |place: usize, change: fn(Rational) -> Rational| {
        let (mut smaller, mut seen) = (input.clone(), 0);
        each_number(&mut smaller, &mut |x| {
            seen += 1;
            if seen == place + 1 { change(x) } else { x }
        });
        smaller
    };
    let ones = (0..count).flat_map(|place| changes.map(|change| one(place, change)));
    std::iter::once(rounded).chain(ones).collect()
}

//! Whether a question can be answered by rounded arithmetic at all.

use super::MaxError;
use super::compare::compare;
use super::question::{Question, power_of_two, text};
use crate::answer::value;
use crate::number::Rational;
use crate::number::binary::nearest_f64;
use crate::number::text::parse;
use serde_json::{Value, json};

/// Whether relative errors of 2⁻⁴⁰ in the question's numbers change the numbers of the answer by at most 64 times as much, normwise,
/// and no sign: found by trying three patterns of errors, so that it is a choice of questions, and no proof.
pub fn is_well_conditioned(question: &Question) -> bool {
    const ERROR: i32 = -40;
    const MOST: f64 = 64.0;
    let Ok(truth) = question.truth() else { return false };
    let most = MaxError { units: MOST * 2_f64.powi(52 + ERROR), componentwise: false };
    (0..3).all(|pattern| {
        let mut input = question.input.clone();
        let mut bits = 0_u32;
        each_number(&mut input, &mut |x| {
            // Leading bits of the multiples of an odd number, as good as random.
            bits = bits.wrapping_add(0x9E37_79B9);
            let up = (bits >> (29 - pattern)) & 1 == 1;
            let error = power_of_two(ERROR);
            x * (if up { 1 + error } else { 1 - error })
        });
        let moved = Question { input, ..question.clone() };
        moved.truth().is_ok_and(|moved| {
            compare(question.operation, &question.input, &truth, &rounded(&moved), most).faults.is_empty()
        })
    })
}

/// Changes every number that is written as a string.
pub fn each_number(value: &mut Value, change: &mut impl FnMut(Rational) -> Rational) {
    match value {
        Value::String(written) => {
            if let Ok(x) = parse(written) {
                *value = text(&change(x));
            }
        }
        Value::Array(items) => items.iter_mut().for_each(|item| each_number(item, change)),
        Value::Object(fields) => fields.values_mut().for_each(|field| each_number(field, change)),
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}

/// An answer in plain numbers.
fn rounded(answer: &Value) -> Value {
    match answer {
        Value::String(written) => parse(written).map_or(Value::Null, |x| json!(nearest_f64(&x))),
        Value::Array(items) => items.iter().map(rounded).collect(),
        Value::Object(fields) => match fields.get("lo").map(value::number) {
            Some(lo) => lo.map_or(Value::Null, |x| json!(nearest_f64(&x))),
            None => Value::Object(fields.iter().map(|(name, field)| (name.clone(), rounded(field))).collect()),
        },
        Value::Null | Value::Bool(_) | Value::Number(_) => answer.clone(),
    }
}

//! A candidate's answer beside the true one, number by number. What it leaves out is not judged, and named.
//!
//! A plain JSON number is measured, and wrong where it is farther off, normwise, than the candidate may be. An exact number (a string,
//! or a + b√d) has to be the true one. An enclosure has to hold the true one, and to be as narrow as the
//! protocol asks, or its ends count as plain numbers. Signs are exact.
//! M, the size that normwise errors are relative to, is the largest number of the same list: of a gradient, a Hessian, of E, F, G, of
//! the two principal curvatures, and of K, H² and H² − K, which are of one degree. But the values and derivatives of a spline are
//! relative to its largest coefficient, and f(p) of a polynomial f to its largest term at p: what they are sums of.

use super::deviation::{Unit, is_at_most, magnitude};
use super::real::{Real, largest};
use super::{MaxError, scale};
use crate::answer::value;
use crate::curvature::principal::Principal;
use crate::judge::accuracy::{Measured, short_units};
use crate::judge::fault::{Comparison, Fault};
use crate::number::text::parse;
use crate::number::{Integer, Rational, Sign, Surd};
use rug::ops::Pow;
use serde_json::Value;

/// Fields whose numbers are one list, each with the name of its fault.
struct List {
    fields: &'static [(&'static str, &'static str)],
    formula: &'static str,
    /// Whether the list is relative to what the answer is a sum of, not to its own largest number.
    is_sum: bool,
}

const fn list(fields: &'static [(&'static str, &'static str)], formula: &'static str) -> List {
    List { fields, formula, is_sum: false }
}

const fn sum(fields: &'static [(&'static str, &'static str)], formula: &'static str) -> List {
    List { fields, formula, is_sum: true }
}

const KAPPA: List = list(&[("kappa_squared", "wrong-curvature")], "CU-2");

const LEVEL_CURVE: &[List] =
    &[KAPPA, list(&[("gradient", "wrong-gradient")], "CU-1"), sum(&[("value", "wrong-value")], "CU-1")];

const SECOND_DEGREE: List = list(
    &[("gaussian", "wrong-gaussian"), ("mean_squared", "wrong-mean"), ("discriminant", "wrong-discriminant")],
    "CU-3",
);

const PRINCIPAL: List = list(&[("principal", "wrong-principal")], "CU-4");

const LEVEL_SURFACE: &[List] = &[
    SECOND_DEGREE,
    PRINCIPAL,
    list(&[("gradient", "wrong-gradient")], "CU-1"),
    list(&[("hessian", "wrong-hessian")], "CU-1"),
    sum(&[("value", "wrong-value")], "CU-1"),
];

const PLANE_CURVE: &[List] = &[
    list(&[("kappa_squared", "wrong-curvature")], "CU-5"),
    list(&[("speed_squared", "wrong-speed")], "CU-5"),
    list(&[("point", "wrong-point")], "CU-5"),
];

const PARAMETRIC_SURFACE: &[List] = &[
    list(&[("gaussian", "wrong-gaussian"), ("mean_squared", "wrong-mean")], "CU-6"),
    PRINCIPAL,
    list(&[("E", "wrong-first-form"), ("F", "wrong-first-form"), ("G", "wrong-first-form")], "CU-6"),
    list(&[("w_squared", "wrong-first-form")], "CU-6"),
    list(&[("w_e", "wrong-second-form"), ("w_f", "wrong-second-form"), ("w_g", "wrong-second-form")], "CU-6"),
    list(&[("weingarten_w", "wrong-weingarten")], "CU-6"),
];

const IMPULSE: &[List] = &[
    sum(&[("coefficients", "wrong-coefficients")], "SP-4"),
    sum(&[("values", "wrong-values")], "SP-4"),
    sum(&[("d1", "wrong-derivatives")], "SP-4"),
    sum(&[("d2", "wrong-derivatives")], "SP-4"),
];

/// Fields that are −1, 0 or 1.
const SIGNS: [&str; 2] = ["kappa_sign", "mean_sign"];

/// The spec entry of an operation as a whole.
pub fn whole(operation: &str) -> &'static str {
    match operation {
        "spline.coefficients" => "SP-2",
        "spline.evaluate" => "SP-3",
        "spline.impulse" => "SP-4",
        "curvature.implicit_curve" => "CU-2",
        "curvature.parametric_curve" => "CU-5",
        "curvature.parametric_surface" => "CU-6",
        "curvature.normalize" => "CU-7",
        _ => "CU-3",
    }
}

/// The faults of an answer, the weightiest first, the fields that it leaves out, and the errors of its plain numbers.
pub fn compare(operation: &str, input: &Value, truth: &Value, found: &Value, most: MaxError) -> Comparison {
    let formula = whole(operation);
    let digits = input.get("digits").and_then(|digits| value::digits(digits).ok()).unwrap_or_default().count();
    let mut comparing = Comparing { comparison: Comparison::default(), said: 0, most, digits, formula };
    let scale = scale::of(operation, input);
    let scale = scale.as_ref();
    match operation {
        "spline.coefficients" => {
            let lists = &[list(&[("coefficients", "wrong-coefficients")], "SP-2")];
            comparing.lists(lists, None, "", truth, found);
        }
        "spline.evaluate" => {
            comparing.lists(&[sum(&[("values", "wrong-values")], "SP-3")], scale, "", truth, found);
        }
        "spline.impulse" => comparing.lists(IMPULSE, scale, "", truth, found),
        "curvature.implicit_curve" => comparing.lists(LEVEL_CURVE, scale, "", truth, found),
        "curvature.implicit_surface" => comparing.lists(LEVEL_SURFACE, scale, "", truth, found),
        "curvature.parametric_curve" => comparing.lists(PLANE_CURVE, None, "", truth, found),
        "curvature.parametric_surface" => comparing.lists(PARAMETRIC_SURFACE, None, "", truth, found),
        "curvature.normalize" => comparing.normalized(input, found),
        "curvature.spline" => comparing.points(scale, truth, found),
        other => unreachable!("no operation {other} of splines or curvatures"),
    }
    let Comparing { mut comparison, said, .. } = comparing;
    if said == 0 && comparison.faults.is_empty() {
        comparison.faults = vec![Fault::new("says-nothing", formula, "answer", &truth.to_string(), &found.to_string())];
        comparison.left_out.clear();
    }
    comparison
}

struct Comparing {
    comparison: Comparison,
    said: usize,
    most: MaxError,
    /// How many digits the question wants of an enclosure.
    digits: u32,
    formula: &'static str,
}

/// A true number, where it stands in its field, and what the candidate says there.
struct Part<'a> {
    name: String,
    truth: Real,
    found: &'a Value,
    fault: &'static str,
}

impl Comparing {
    /// The points of `curvature.spline`.
    fn points(&mut self, scale: Option<&Real>, truth: &Value, found: &Value) {
        let expected = truth["points"].as_array().map_or(&[][..], Vec::as_slice);
        match found.get("points").map(Value::as_array) {
            None => self.comparison.left_out.push("points".to_owned()),
            Some(Some(given)) if given.len() == expected.len() => {
                // Without points there is nothing more to say.
                self.said += usize::from(expected.is_empty());
                for (i, (expected, given)) in expected.iter().zip(given).enumerate() {
                    let lists = if expected.get("gaussian").is_some() { LEVEL_SURFACE } else { LEVEL_CURVE };
                    self.lists(lists, scale, &format!("points[{i}]."), expected, given);
                }
            }
            Some(_) => self.wrong_shape("points", &truth["points"], &found["points"]),
        }
    }

    fn normalized(&mut self, input: &Value, found: &Value) {
        let number = |name: &str| value::number(&input[name]).expect("the question has an answer");
        let truth = Real::normalized(number("lambda"), number("x"));
        match found.get("value") {
            None => self.comparison.left_out.push("value".to_owned()),
            Some(found) => {
                let part = Part { name: "value".to_owned(), truth, found, fault: "wrong-value" };
                self.parts(vec![part], None, "CU-7");
            }
        }
    }

    /// The lists of an object, then its signs. `place` is where the object stands in the answer.
    fn lists(&mut self, lists: &[List], scale: Option<&Real>, place: &str, truth: &Value, found: &Value) {
        for sign in SIGNS.iter().filter(|sign| truth.get(**sign).is_some()) {
            self.sign(sign, place, &truth[sign], found.get(sign));
        }
        for List { fields, formula, is_sum } in lists {
            let mut parts = Vec::new();
            // What is left out still counts for how large the list is.
            let mut unsaid = Vec::new();
            for (field, fault) in fields.iter().filter(|(field, _)| truth.get(*field).is_some()) {
                let mut numbers = reals(field, truth).into_iter();
                let Some(given) = found.get(*field) else {
                    self.left_out(field);
                    unsaid.extend(numbers);
                    continue;
                };
                let mut leaves = Vec::new();
                if !paired(&truth[field], given, format!("{place}{field}"), &mut leaves) {
                    self.wrong_shape(&format!("{place}{field}"), &truth[field], given);
                    unsaid.extend(numbers);
                    continue;
                }
                // An empty list is an answer.
                self.said += usize::from(leaves.is_empty());
                parts.extend(leaves.into_iter().map(|(name, found)| {
                    let truth = numbers.next().expect("a real number a leaf");
                    Part { name, truth, found, fault }
                }));
            }
            let scale = if *is_sum { scale.cloned() } else { None };
            match scale {
                Some(scale) => self.parts(parts, Some(scale), formula),
                None => self.own_list(parts, unsaid, formula),
            }
        }
    }

    /// Numbers relative to the largest of them, and of others of their list.
    fn own_list(&mut self, parts: Vec<Part>, unsaid: Vec<Real>, formula: &'static str) {
        let of_others = largest(&unsaid);
        let own = parts.iter().map(|part| part.truth.clone());
        let all: Vec<Real> = own.chain(unsaid.get(of_others).cloned()).collect();
        let index = largest(&all);
        let scale = (index >= parts.len()).then(|| all.get(index).cloned()).flatten();
        self.parts(parts, scale, formula);
    }

    /// Numbers relative to `scale`, or to the largest of them.
    fn parts(&mut self, parts: Vec<Part>, scale: Option<Real>, formula: &'static str) {
        let numbers: Vec<Real> = parts.iter().map(|part| part.truth.clone()).collect();
        let own = largest(&numbers);
        for (i, part) in parts.iter().enumerate() {
            let unit = match &scale {
                Some(scale) => Unit::Relative { largest: scale, is_own: false },
                None => Unit::Relative { largest: &numbers[own], is_own: i == own },
            };
            self.said += 1;
            self.number(part, unit, formula);
        }
    }

    fn number(&mut self, Part { name, truth, found, fault }: &Part, unit: Unit, formula: &'static str) {
        let expected = truth.to_string();
        let wrong = match Said::read(found) {
            None => {
                let fault = Fault::new("no-number", formula, name, &expected, &found.to_string());
                return self.comparison.faults.push(fault);
            }
            Some(Said::Exact(x)) => (Real::Surd(x) != *truth).then(|| format!("{found}, as an exact number")),
            Some(Said::Between(lo, hi)) => {
                let is_far = |end: &Rational| !self.most.allows(end, truth, unit);
                if truth.cmp_rational(&lo).is_lt() || truth.cmp_rational(&hi).is_gt() {
                    Some(format!("{found}, where it is not"))
                } else if !self.is_narrow(&lo, &hi) && (is_far(&lo) || is_far(&hi)) {
                    Some(format!("{found}, which is too wide"))
                } else {
                    None
                }
            }
            Some(Said::Plain(x)) => {
                let (componentwise, normwise) = (magnitude(&x, truth, Unit::LastPlace), magnitude(&x, truth, unit));
                let [ulp, units] = [componentwise, normwise].map(|error| short_units(error.units));
                let (field, expected) = (name.clone(), expected.clone());
                let measured = Measured { field, expected, found: found.to_string(), componentwise, normwise };
                self.comparison.measured.push(measured);
                let is_wrong = !self.most.allows(&x, truth, unit);
                is_wrong.then(|| format!("{found}, {ulp} ulp off; normwise {units}"))
            }
        };
        if let Some(found) = wrong {
            self.comparison.faults.push(Fault::new(fault, formula, name, &expected, &found));
        }
    }

    /// Whether an enclosure is as narrow as the question wants the oracle's: hi − lo ≤ 10^−digits·max(1, |x|) for every x in it.
    fn is_narrow(&self, lo: &Rational, hi: &Rational) -> bool {
        let has_zero = *lo <= 0 && *hi >= 0;
        let least = if has_zero { Rational::new() } else { lo.clone().abs().min(hi.clone().abs()) };
        Rational::from(hi - lo) * Integer::from(10).pow(self.digits) <= least.max(Rational::from(1))
    }

    fn sign(&mut self, field: &str, place: &str, truth: &Value, found: Option<&Value>) {
        let Some(found) = found else { return self.left_out(field) };
        self.said += 1;
        if value::number(found).ok() != value::number(truth).ok() {
            let name = format!("{place}{field}");
            let fault = Fault::new("wrong-sign", self.formula, &name, &truth.to_string(), &found.to_string());
            self.comparison.faults.push(fault);
        }
    }

    fn wrong_shape(&mut self, field: &str, truth: &Value, found: &Value) {
        let fault = Fault::new("wrong-shape", self.formula, field, &truth.to_string(), &found.to_string());
        self.comparison.faults.push(fault);
    }

    fn left_out(&mut self, field: &str) {
        if !self.comparison.left_out.iter().any(|known| known == field) {
            self.comparison.left_out.push(field.to_owned());
        }
    }
}

/// What a candidate says of a number.
enum Said {
    /// A JSON number: perhaps rounded.
    Plain(Rational),
    /// A string, or a + b√d.
    Exact(Surd),
    /// lo, hi.
    Between(Rational, Rational),
}

impl Said {
    fn read(value: &Value) -> Option<Said> {
        match value {
            Value::Number(_) => value::number(value).ok().map(Said::Plain),
            Value::String(text) => parse(text).ok().map(|x| Said::Exact(Surd::from(x))),
            Value::Object(fields) => {
                let field = |name: &str| fields.get(name).and_then(|x| value::number(x).ok());
                match (field("lo"), field("hi")) {
                    (Some(lo), Some(hi)) => Some(Said::Between(lo, hi)),
                    (_, _) => Surd::new(field("a")?, field("b")?, &field("d")?).ok().map(Said::Exact),
                }
            }
            Value::Null | Value::Bool(_) | Value::Array(_) => None,
        }
    }
}

/// The numbers of a field of the truth, in order.
fn reals(field: &str, truth: &Value) -> Vec<Real> {
    if field == "principal" {
        let number = |name: &str| value::number(&truth[name]).expect("the truth has K and H");
        let sign = Sign::of(number("mean_sign").cmp0());
        return Real::principal(Principal::new(sign, &number("mean_squared"), &number("gaussian"))).into();
    }
    let mut reals = Vec::new();
    leaves(&truth[field], &mut reals);
    reals
}

fn leaves(truth: &Value, reals: &mut Vec<Real>) {
    match truth {
        Value::Array(items) => items.iter().for_each(|item| leaves(item, reals)),
        leaf => match Said::read(leaf) {
            Some(Said::Exact(x)) => reals.push(Real::Surd(x)),
            Some(Said::Plain(_) | Said::Between(..)) | None => unreachable!("the truth is exact: {leaf}"),
        },
    }
}

/// The leaves of the candidate's value, with their places, if it has the lists of the truth.
fn paired<'a>(truth: &Value, found: &'a Value, place: String, leaves: &mut Vec<(String, &'a Value)>) -> bool {
    match (truth, found) {
        (Value::Array(items), Value::Array(given)) => {
            let mut pairs = items.iter().zip(given).enumerate();
            items.len() == given.len()
                && pairs.all(|(i, (item, given))| paired(item, given, format!("{place}[{i}]"), leaves))
        }
        (Value::Array(_), _) | (_, Value::Array(_)) => false,
        (_, _) => {
            leaves.push((place, found));
            true
        }
    }
}

impl MaxError {
    /// Whether a plain number may stand for the true one.
    fn allows(&self, x: &Rational, truth: &Real, unit: Unit) -> bool {
        let units = Rational::from_f64(self.units).unwrap_or_default();
        is_at_most(x, truth, unit, &units) && (!self.componentwise || is_at_most(x, truth, Unit::LastPlace, &units))
    }
}

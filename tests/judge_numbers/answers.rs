//! Wrong answers are rejected for what is wrong with them, right ones in every form are not.

use crate::{FAMILIES, altered, judge, judged, names, suite};
use isoracle::answer::value;
use isoracle::judge::numbers::{Family, MaxError};
use isoracle::judge::report::Outcome;
use isoracle::number::binary::nearest_f64;
use serde_json::{Value, json};
use std::collections::BTreeSet;

const DEFAULT: MaxError = MaxError { units: 4096.0, componentwise: false };

fn rounded(x: &Value) -> f64 {
    nearest_f64(&value::number(x).expect("a number"))
}

/// Every exact number of an answer, changed.
fn each(answer: &mut Value, change: &mut impl FnMut(f64) -> Value) {
    match answer {
        Value::String(_) => *answer = change(rounded(answer)),
        Value::Array(items) => items.iter_mut().for_each(|item| each(item, change)),
        Value::Object(fields) if fields.contains_key("lo") => *answer = change(rounded(&fields["lo"])),
        Value::Object(fields) => fields.values_mut().for_each(|field| each(field, change)),
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}

#[test]
fn the_oracle_passes_everything() {
    for family in FAMILIES {
        let report = judged(family, &mut crate::Altered(|_: &str, _: &Value, out| out));
        assert_eq!(report.verdict, Outcome::Passed, "{:?}", report.total().faults);
        assert!(report.rows().all(|row| row.asked == suite(family).cases && row.passed == row.asked));
        assert!(report.failures.is_empty() && report.left_out.is_empty() && report.accuracy.is_empty());
    }
}

#[test]
fn the_nearest_binary64_pass() {
    for family in FAMILIES {
        let found = altered(family, |op, _, mut out| {
            // a + b√3 is kept as it is.
            if op != "spline.impulse" {
                each(&mut out, &mut |x| json!(x));
            }
            out
        });
        assert!(found.is_empty(), "{found:?}");
    }
}

#[test]
fn relative_errors_of_a_millionth_fail_every_row_with_numbers() {
    for family in FAMILIES {
        let found = altered(family, |op, _, mut out| {
            if op != "spline.impulse" {
                each(&mut out, &mut |x| json!(x * 1.000001));
            }
            out
        });
        let rows: BTreeSet<&str> = found.iter().map(|(row, _)| *row).collect();
        let all =
            family.rows().into_iter().flatten().filter(|row| !["bounded-on-z", "singular", "broken"].contains(row));
        assert_eq!(rows, all.copied().collect());
    }
}

#[test]
fn the_other_boundary_rule_is_wrong() {
    let found = altered(Family::Spline, |op, input, out| {
        if op == "spline.impulse" {
            return out;
        }
        let mut input = input.clone();
        input["boundary"] = json!(if input["boundary"] == "mirror" { "periodic" } else { "mirror" });
        let Value::Object(input) = input else { unreachable!("an object") };
        isoracle::answer::out(op, &input).expect("the same signal").value()
    });
    let rows: BTreeSet<&str> = found.iter().map(|(row, _)| *row).collect();
    for row in [
        "1d-mirror",
        "1d-periodic",
        "2d-mirror",
        "3d-periodic",
        "long-lines",
        "single-samples",
        "outside",
        "huge-range",
    ] {
        assert!(rows.contains(row), "{row}");
    }
    // Where both rules mean the same, there is nothing to be wrong about.
    assert!(!rows.contains("constants") && !rows.contains("bounded-on-z"));
    assert_eq!(names(&found), BTreeSet::from(["wrong-coefficients", "wrong-values"]));
}

#[test]
fn derivatives_are_judged_one_by_one() {
    let found = altered(Family::Spline, |op, input, mut out| {
        if op == "spline.evaluate" && input.get("derivatives").is_some() {
            let last = &mut out["values"][0][1];
            *last = json!(-rounded(last) - 1e-6);
        }
        out
    });
    assert_eq!(names(&found), BTreeSet::from(["wrong-values"]));
    let found = altered(Family::Spline, |op, _, mut out| {
        if op == "spline.impulse" && out["d2"][0].is_object() {
            out["d2"][0]["b"] = json!("1/7");
        }
        out
    });
    assert_eq!(found, BTreeSet::from([("bounded-on-z", "wrong-derivatives")]));
}

#[test]
fn signs_are_exact() {
    for field in ["mean_sign", "kappa_sign"] {
        let found = altered(Family::Curvature, |_, _, mut out| {
            if let Some(sign) = out.get(field).and_then(Value::as_i64) {
                out[field] = json!(if sign == 0 { 1 } else { -sign });
            }
            out
        });
        assert_eq!(names(&found), BTreeSet::from(["wrong-sign"]));
        let row = if field == "mean_sign" { "planes" } else { "inflections" };
        assert!(found.contains(&(row, "wrong-sign")));
    }
}

#[test]
fn each_field_of_a_surface_is_judged() {
    let fields = [
        ("gaussian", "wrong-gaussian"),
        ("mean_squared", "wrong-mean"),
        ("discriminant", "wrong-discriminant"),
        ("value", "wrong-value"),
    ];
    for (field, fault) in fields {
        let found = altered(Family::Curvature, |op, _, mut out| {
            if op == "curvature.implicit_surface" {
                out[field] = json!(rounded(&out[field]) + 1e6);
            }
            out
        });
        assert_eq!(names(&found), BTreeSet::from([fault]));
    }
    for (field, fault) in [("w_f", "wrong-second-form"), ("F", "wrong-first-form"), ("w_squared", "wrong-first-form")] {
        let found = altered(Family::Curvature, |op, _, mut out| {
            if op == "curvature.parametric_surface" {
                out[field] = json!(rounded(&out[field]) + 1e6);
            }
            out
        });
        assert_eq!(found, BTreeSet::from([("parametric-surfaces", fault)]));
    }
    let swapped = altered(Family::Curvature, |op, _, mut out| {
        if op == "curvature.parametric_surface" {
            let matrix = out["weingarten_w"].clone();
            out["weingarten_w"] = json!([[matrix[0][0], matrix[1][0]], [matrix[0][1], matrix[1][1]]]);
        }
        out
    });
    assert_eq!(swapped, BTreeSet::from([("parametric-surfaces", "wrong-weingarten")]));
}

const SPHERE: &str = r#"{"polynomial":[["1",2,0,0],["1",0,2,0],["1",0,0,2]],"point":["1","1","1"]}"#;

fn on_sphere(most: MaxError, answer: Value) -> (Option<&'static str>, Vec<String>) {
    judge(Family::Curvature, most, "curvature.implicit_surface", serde_json::from_str(SPHERE).expect("JSON"), answer)
}

#[test]
fn the_bound_is_met_and_not_exceeded() {
    // K = H² = 1/3, so that the unit is 2⁻⁵²/3; the discriminant is 0.
    let most = |units: f64| MaxError { units, componentwise: false };
    let steps = |n: i32| json!({"discriminant": 2_f64.powi(-52) * f64::from(n)});
    assert_eq!(on_sphere(most(12.0), steps(4)).0, None);
    assert_eq!(on_sphere(most(11.999), steps(4)).0, Some("wrong-discriminant"));
    assert_eq!(on_sphere(most(0.0), steps(0)).0, None);
    assert_eq!(on_sphere(MaxError { units: 12.0, componentwise: true }, steps(4)).0, Some("wrong-discriminant"));
    assert_eq!(on_sphere(MaxError { units: 12.0, componentwise: true }, json!({"gaussian": 1.0 / 3.0})).0, None);
}

#[test]
fn what_is_left_out_counts_for_the_size_of_the_list() {
    // As above, whether K and H² are said or not.
    let answer = json!({"discriminant": 4e-16, "gaussian": "1/3", "mean_squared": "1/3"});
    assert_eq!(on_sphere(DEFAULT, answer).0, None);
    let (fault, left_out) = on_sphere(DEFAULT, json!({"discriminant": 4e-16}));
    assert_eq!(fault, None);
    assert!(left_out.contains(&"gaussian".to_owned()) && left_out.contains(&"mean_sign".to_owned()));
    assert!(!left_out.contains(&"discriminant".to_owned()));
}

#[test]
fn sums_are_relative_to_what_they_are_sums_of() {
    // The coefficients are ±3000, and the spline is 0 halfway.
    let signal = json!({"shape": [3], "values": [1000, -1000, 1000], "boundary": "mirror", "points": [["1/2"]]});
    let said = |x: f64| judge(Family::Spline, DEFAULT, "spline.evaluate", signal.clone(), json!({"values": [[x]]})).0;
    assert_eq!([said(1e-10), said(-2e-9), said(4e-9)], [None, None, Some("wrong-values")]);
    // 1 + 1000x − 1001y.
    let line = json!({"polynomial": [["1", 0, 0], ["1000", 1, 0], ["-1001", 0, 1]], "point": ["1", "1"]});
    let said =
        |x: f64| judge(Family::Curvature, DEFAULT, "curvature.implicit_curve", line.clone(), json!({"value": x})).0;
    assert_eq!([said(1e-10), said(8e-10), said(1e-9)], [None, None, Some("wrong-value")]);
    // The largest of all coefficients is √3·8, at the sample 8, and not in the answer.
    let impulse = json!({"samples": {"0": "1", "30": "8"}, "k_from": 0, "k_to": 0, "points": []});
    let said =
        |x: f64| judge(Family::Spline, DEFAULT, "spline.impulse", impulse.clone(), json!({"coefficients": [x]})).0;
    let root = 3_f64.sqrt();
    assert_eq!([said(root + 1e-11), said(root - 2e-11)], [None, Some("wrong-coefficients")]);
}

#[test]
fn exact_numbers_are_exact_and_enclosures_enclose() {
    let third = 1.0 / 3.0;
    let root = |b: &str| json!({"principal": [{"a": "0", "b": b, "d": 3}, {"a": "0", "b": b, "d": 3}]});
    for (answer, fault) in [
        (json!({"gaussian": "1/3"}), None),
        (json!({"gaussian": "2/6"}), None),
        (json!({"gaussian": "0.3333333333333333333333"}), Some("wrong-gaussian")),
        (json!({"gaussian": third}), None),
        (json!({"gaussian": {"a": "1/3", "b": "0", "d": 2}}), None),
        (json!({"gaussian": {"lo": "1/3", "hi": "1/3"}}), None),
        (json!({"gaussian": {"lo": 0.333, "hi": 0.334}}), Some("wrong-gaussian")),
        (json!({"gaussian": {"lo": "0.33333333333333", "hi": "0.33333333333334"}}), None),
        (json!({"gaussian": {"lo": "0.34", "hi": "0.35"}}), Some("wrong-gaussian")),
        // Close to 1/3, and not around it.
        (json!({"gaussian": {"lo": "0.333333333333333334", "hi": "0.333333333333333335"}}), Some("wrong-gaussian")),
        (json!({"gaussian": {"lo": "0.333333333333333331", "hi": "0.333333333333333332"}}), Some("wrong-gaussian")),
        (json!({"gaussian": {"lo": "0.33333333333334", "hi": "0.33333333333333"}}), Some("wrong-gaussian")),
        // k = −√3/3.
        (root("-1/3"), None),
        (root("1/3"), Some("wrong-principal")),
        (json!({"principal": [-0.5773502691896257, -0.5773502691896258]}), None),
        (json!({"principal": ["-0.5773502691896257", "-0.5773502691896258"]}), Some("wrong-principal")),
        (json!({"gaussian": null}), Some("no-number")),
        (json!({"gaussian": true}), Some("no-number")),
        (json!({"gaussian": "NaN"}), Some("no-number")),
        (json!({"gaussian": {"lo": 0}}), Some("no-number")),
        (json!({"gaussian": [third]}), Some("wrong-shape")),
        (json!({"gradient": [2, 2]}), Some("wrong-shape")),
        (json!({"gradient": 2}), Some("wrong-shape")),
        (json!({"gradient": [2, 2.0, "2"]}), None),
        (json!({"gradient": [2, 2, 3]}), Some("wrong-gradient")),
        (json!({}), Some("says-nothing")),
        (json!({"k": 1}), Some("says-nothing")),
    ] {
        assert_eq!(on_sphere(DEFAULT, answer.clone()).0, fault, "{answer}");
    }
}

#[test]
fn an_enclosure_as_narrow_as_the_protocol_asks_is_right_however_small_the_number() {
    let input = json!({"lambda": "1", "x": "-500"});
    let said = |hi: &str| {
        let answer = json!({"value": {"lo": "0", "hi": hi}});
        judge(Family::Curvature, DEFAULT, "curvature.normalize", input.clone(), answer).0
    };
    assert_eq!(said("1e-30"), None);
    assert_eq!(said("1.1e-30"), Some("wrong-value"));
}

#[test]
fn an_answer_to_a_question_without_one_is_wrong_and_so_is_refusing() {
    let plane = json!({"polynomial": [["1", 1, 0, 0]], "point": ["0", "0", "0"]});
    let mut candidate = Refusing;
    let suite = suite(Family::Curvature);
    let question = |input: Value| isoracle::judge::numbers::question::Question {
        row: "planes",
        operation: "curvature.implicit_surface",
        input,
    };
    use isoracle::judge::suite::{Judgement, Suite};
    let judged = suite.ask(&mut candidate, &question(plane));
    assert!(matches!(judged, Judgement::Wrong { fault: "refused", .. }));
    let singular = question(json!({"polynomial": [["1", 2, 0, 0]], "point": ["0", "0", "0"]}));
    assert!(matches!(suite.ask(&mut candidate, &singular), Judgement::Right { .. }));
    let ill_posed = question(json!({"polynomial": [["1", 2, 0, 0]], "point": ["0", "0"]}));
    assert!(matches!(suite.ask(&mut candidate, &ill_posed), Judgement::Wrong { fault: "refused", .. }));
    let mut answering = Answering;
    assert!(matches!(suite.ask(&mut answering, &singular), Judgement::Wrong { fault: "answered", .. }));
}

struct Refusing;

impl isoracle::judge::candidate::Candidate for Refusing {
    fn ask(&mut self, _: &str, _: &Value) -> isoracle::judge::candidate::Reply {
        isoracle::judge::candidate::Reply::Error { kind: "degenerate".into(), message: "no".into() }
    }
    fn command(&self) -> &[String] {
        &[]
    }
}

struct Answering;

impl isoracle::judge::candidate::Candidate for Answering {
    fn ask(&mut self, _: &str, _: &Value) -> isoracle::judge::candidate::Reply {
        isoracle::judge::candidate::Reply::Out(json!({"gaussian": 0.0}))
    }
    fn command(&self) -> &[String] {
        &[]
    }
}

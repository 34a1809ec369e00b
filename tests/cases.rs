//! The answered questions of tests/cases/, asked through the protocol; its README says what conforms.
#![cfg(feature = "cli")]

use isoracle::answer::serve;
use isoracle::number::text::parse;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// An answer in a form in which answers that mean the same are equal.
fn canonical(op: &str, out: &Value) -> Value {
    match op {
        "isosurface.cell" => canonical_cell(out),
        "isosurface.topology" => {
            let mut out = out.clone();
            out["component_list"] = sorted(list(&out["component_list"]).to_vec());
            out
        }
        "mesh.check" => canonical_check(out),
        "complex.glue" => canonical_glue(out),
        "complex.refine" => {
            pick(out, &["V", "E", "F", "T", "simplicial", "degenerate_tetrahedra", "duplicate_tetrahedra"])
        }
        _ => panic!("no file here asks {op}"),
    }
}

fn canonical_cell(out: &Value) -> Value {
    let loops: Vec<Value> = list(&out["loops"]).iter().map(canonical_cycle).collect();
    let components = list(&out["components"]).iter().map(|component| {
        let bounding = list(&component["loops"]).iter().map(|index| loops[integer(index) as usize].clone()).collect();
        json!([sorted(bounding), component["chi"], component["genus"]])
    });
    let parts = |side: &str| sorted(list(&out[side]).iter().map(|part| sorted(list(part).to_vec())).collect());
    let mut canonical = json!({
        "components": sorted(components.collect()),
        "neg_parts": parts("neg_parts"),
        "pos_parts": parts("pos_parts"),
    });
    for field in ["case", "faces", "chi", "b0_neg", "b0_pos", "b1_neg", "b1_pos"] {
        canonical[field] = out[field].clone();
    }
    canonical["loops"] = sorted(loops);
    canonical
}

/// Defects are sets.
fn canonical_check(out: &Value) -> Value {
    let mut out = out.clone();
    let defects = out["defects"].as_object_mut().expect("defects by category");
    defects.values_mut().for_each(|elements| *elements = sorted(list(elements).to_vec()));
    out
}

/// Of an invalid scheme the reason alone; rings and sides are bags, torsion the orders of its primary cyclic parts.
fn canonical_glue(out: &Value) -> Value {
    if out["valid"] == json!(false) {
        return pick(out, &["valid", "reason"]);
    }
    let numbers =
        ["valid", "cells", "chi", "facet_edge_pairs", "components", "orientable", "tetrahedra", "barycentric"];
    let mut canonical = pick(out, &numbers);
    for field in ["edge_ring_sizes", "face_degrees"] {
        canonical[field] = sorted(list(&out[field]).to_vec());
    }
    let h1 = &out["homology"]["h1"];
    let parts = list(&h1["torsion"]).iter().flat_map(|n| primary_parts(integer(n))).map(Value::from);
    canonical["h1"] = json!([h1["rank"], sorted(parts.collect())]);
    canonical
}

/// The prime powers whose product is n, each prime once.
fn primary_parts(n: u64) -> Vec<u64> {
    let mut parts = Vec::new();
    let mut left = n;
    for p in 2..=n {
        let mut power = 1;
        while left.is_multiple_of(p) {
            left /= p;
            power *= p;
        }
        parts.extend(Some(power).filter(|power| *power > 1));
    }
    parts
}

/// Some of the fields; one that is missing is null.
fn pick(out: &Value, fields: &[&str]) -> Value {
    fields.iter().map(|field| ((*field).to_owned(), out[*field].clone())).collect()
}

/// Whether an answer says all that is expected, and perhaps more; a real number lies in its enclosure to 24 places.
fn says(found: &Value, expected: &Value) -> bool {
    match (found, expected) {
        (Value::Object(found), Value::Object(expected)) => {
            expected.iter().all(|(name, value)| found.get(name).is_some_and(|found| says(found, value)))
        }
        (Value::Array(found), Value::Array(expected)) => {
            found.len() == expected.len() && found.iter().zip(expected).all(|(found, expected)| says(found, expected))
        }
        (Value::Object(enclosure), Value::String(expected)) => {
            let number = |text: &str| parse(text).expect("a number");
            let bound = |name: &str| enclosure.get(name).and_then(Value::as_str).map(number);
            let (Some(lo), Some(hi)) = (bound("lo"), bound("hi")) else { return false };
            let (x, slack) = (number(expected), number("1e-24"));
            lo - &slack <= x && x <= hi + slack
        }
        (found, expected) => found == expected,
    }
}

/// A cycle of edges, the least of all its rotations in both directions.
fn canonical_cycle(cycle: &Value) -> Value {
    let forward: Vec<Value> = list(cycle).iter().map(|edge| sorted(list(edge).to_vec())).collect();
    let backward: Vec<Value> = forward.iter().rev().cloned().collect();
    let rotations = [forward, backward]
        .into_iter()
        .flat_map(|cycle| (0..cycle.len()).map(move |i| Value::from([&cycle[i..], &cycle[..i]].concat())));
    rotations.min_by_key(key).expect("a loop crosses edges")
}

/// The same list, as a set.
fn sorted(mut list: Vec<Value>) -> Value {
    list.sort_by_key(key);
    Value::from(list)
}

/// Any total order does.
fn key(value: &Value) -> String {
    value.to_string()
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is a list"))
}

fn integer(value: &Value) -> u64 {
    value.as_u64().unwrap_or_else(|| panic!("{value} is a count"))
}

/// The cases of a file.
fn cases(file: &str) -> Vec<Value> {
    let path = format!("{}/tests/cases/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("the cases are in the repository");
    text.lines().map(|line| serde_json::from_str(line).expect("a case is JSON")).collect()
}

/// The answers to the questions of some cases, all asked at once.
fn answers(cases: &[Value]) -> Vec<Value> {
    let questions: String = cases
        .iter()
        .map(|case| format!("{}\n", json!({"id": case["case"], "op": case["op"], "in": case["in"]})))
        .collect();
    let mut answers = Vec::new();
    serve(questions.as_bytes(), &mut answers).expect("memory can be read and written");
    let answers = String::from_utf8(answers).expect("answers are UTF-8");
    assert_eq!(answers.lines().count(), cases.len());
    answers.lines().map(|line| serde_json::from_str(line).expect("an answer is JSON")).collect()
}

/// Asks every question of a file, and compares every answer; `counts` are the questions by operation.
fn all_conform(file: &str, counts: &[(&str, usize)]) {
    conform(file, |_| true, counts);
}

/// The same for those questions of a file that ask one of some operations.
fn conform(file: &str, is_asked: impl Fn(&str) -> bool, counts: &[(&str, usize)]) {
    let cases: Vec<Value> = cases(file).into_iter().filter(|case| case["op"].as_str().is_some_and(&is_asked)).collect();
    let mut asked = BTreeMap::new();
    for (case, answer) in cases.iter().zip(answers(&cases)) {
        let op = case["op"].as_str().expect("a case names its operation");
        assert_eq!(answer["id"], case["case"]);
        assert!(answer["out"].is_object(), "{answer}");
        match op.split('.').next() {
            Some("curvature" | "spline" | "trilinear") => {
                assert!(says(&answer["out"], &case["out"]), "{}: {answer}", case["case"]);
            }
            _ => assert_eq!(canonical(op, &answer["out"]), canonical(op, &case["out"]), "{}", case["case"]),
        }
        *asked.entry(op).or_insert(0) += 1;
    }
    assert_eq!(asked.into_iter().collect::<Vec<_>>(), counts);
}

#[test]
fn cells_conform() {
    all_conform("isosurface_cell.jsonl", &[("isosurface.cell", 198)]);
}

#[test]
fn topologies_of_volumes_conform() {
    all_conform("isosurface_topology.jsonl", &[("isosurface.topology", 70)]);
}

#[test]
fn broken_ties_conform() {
    all_conform("isosurface_ties.jsonl", &[("isosurface.cell", 94), ("isosurface.topology", 6)]);
}

#[test]
fn checks_of_meshes_conform() {
    conform("mesh.jsonl", |op| op == "mesh.check", &[("mesh.check", 7)]);
}

#[test]
fn gluing_schemes_conform() {
    all_conform("complex.jsonl", &[("complex.glue", 12), ("complex.refine", 59)]);
    all_conform("complex_derived.jsonl", &[("complex.glue", 608), ("complex.refine", 546)]);
}

#[test]
fn curvatures_conform() {
    let counts = [
        ("curvature.implicit_curve", 2),
        ("curvature.implicit_surface", 5),
        ("curvature.normalize", 1),
        ("curvature.parametric_curve", 2),
        ("curvature.parametric_surface", 2),
        ("curvature.spline", 2),
    ];
    all_conform("curvature.jsonl", &counts);
    let counts = [
        ("curvature.implicit_curve", 45),
        ("curvature.implicit_surface", 99),
        ("curvature.normalize", 27),
        ("curvature.parametric_curve", 42),
        ("curvature.parametric_surface", 45),
        ("curvature.spline", 55),
    ];
    all_conform("curvature_derived.jsonl", &counts);
}

#[test]
fn splines_conform() {
    let counts = [("spline.coefficients", 6), ("spline.evaluate", 6), ("spline.impulse", 1), ("trilinear.evaluate", 2)];
    all_conform("spline.jsonl", &counts);
    let counts = [("spline.coefficients", 89), ("spline.evaluate", 114), ("spline.impulse", 40)];
    all_conform("spline_derived.jsonl", &counts);
}

#[test]
fn broken_questions_are_refused_for_what_they_are() {
    let cases = cases("curvature_spline_errors.jsonl");
    assert_eq!(cases.len(), 321);
    for (case, answer) in cases.iter().zip(answers(&cases)) {
        assert_eq!(answer["error"]["kind"], case["kind"], "{}: {answer}", case["case"]);
    }
}

#[test]
fn an_answer_may_say_more_but_nothing_else() {
    let expected = json!({"a": ["1/2", "0.5"]});
    assert!(says(&json!({"b": 1, "a": ["1/2", {"lo": "0.4", "hi": "0.5"}]}), &expected));
    for other in [
        json!({}),
        json!({"a": ["1/2"]}),
        json!({"a": ["1/3", "0.5"]}),
        json!({"a": ["1/2", {"lo": "0.6", "hi": "0.7"}]}),
    ] {
        assert!(!says(&other, &expected), "{other}");
    }
}

#[test]
fn cycles_are_compared_in_either_direction_and_as_cycles() {
    let cycle = json!([[0, 1], [0, 2], [4, 0]]);
    for same in [json!([[0, 2], [0, 4], [1, 0]]), json!([[0, 1], [0, 4], [2, 0]])] {
        assert_eq!(canonical_cycle(&cycle), canonical_cycle(&same));
    }
    assert_ne!(canonical_cycle(&cycle), canonical_cycle(&json!([[0, 1], [0, 2], [1, 5]])));
}

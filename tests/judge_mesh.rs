//! The suite of polygon meshes: it passes the oracle, and rejects each wrong answer for what is wrong with it.
#![cfg(feature = "cli")]
#![allow(missing_docs)]

use isoracle::judge::candidate::{Candidate, Reply};
use isoracle::judge::isosurface::place::Tolerance;
use isoracle::judge::mesh::Mesh;
use isoracle::judge::mesh::questions::{CATEGORIES, Row, questions};
use isoracle::judge::report::{Outcome, QuestionRecord, Report};
use isoracle::judge::run::run;
use isoracle::judge::suite::{Judgement, Suite};
use serde_json::{Value, json};
use std::collections::BTreeSet;

const SUITE: Mesh = Mesh { seed: 7, cases: 4, tolerance: Tolerance(64.0) };

/// The oracle, its answers altered.
struct Altered<F>(F);

impl<F: FnMut(&str, &Value, Value) -> Value> Candidate for Altered<F> {
    fn ask(&mut self, op: &str, input: &Value) -> Reply {
        let line = json!({"id": 1, "op": op, "in": input}).to_string();
        let mut message: Value = serde_json::from_str(&isoracle::answer::answer(line.as_bytes())).unwrap();
        match message.get_mut("out") {
            Some(out) => Reply::Out((self.0)(op, input, out.take())),
            None => {
                let text = |name: &str| message["error"][name].as_str().unwrap().to_owned();
                Reply::Error { kind: text("kind"), message: text("message") }
            }
        }
    }
    fn command(&self) -> &[String] {
        &[]
    }
}

fn judged(alter: impl FnMut(&str, &Value, Value) -> Value) -> Report {
    run(&mut Altered(alter), &SUITE, |_, _| {}).unwrap()
}

/// The faults of altered answers, by the rows that show them; nothing is shrunk.
fn asked(alter: impl FnMut(&str, &Value, Value) -> Value) -> BTreeSet<(&'static str, &'static str)> {
    let mut candidate = Altered(alter);
    let faults = questions(7, 3).into_iter().filter_map(|question| match SUITE.ask(&mut candidate, &question) {
        Judgement::Right { .. } => None,
        Judgement::Wrong { fault, .. } => Some((question.row.name(), fault)),
        Judgement::Unsupported(why) => panic!("{why}"),
        Judgement::Broken(why) => panic!("{why}"),
    });
    faults.collect()
}

fn faults(found: &BTreeSet<(&'static str, &'static str)>) -> BTreeSet<&'static str> {
    found.iter().map(|(_, fault)| *fault).collect()
}

#[test]
fn the_oracle_passes_everything() {
    let report = judged(|_, _, out| out);
    assert_eq!(report.verdict, Outcome::Passed, "{:?}", report.total().faults);
    assert!(report.rows().all(|row| row.asked == SUITE.cases && row.passed == row.asked));
    assert!(report.failures.is_empty() && report.left_out.is_empty());
}

#[test]
fn the_questions_depend_on_the_seed_alone_and_have_what_their_rows_say() {
    let asked = questions(3, 3);
    assert_eq!(asked, questions(3, 3));
    assert_ne!(asked, questions(4, 3));
    for question in &asked {
        let Value::Object(input) = question.input() else { panic!("an object") };
        let out = isoracle::answer::out(question.row.operation(), &input);
        match question.row {
            Row::Sound => assert_eq!(out.unwrap().value()["defects"], json!({})),
            Row::Defect(category) => assert!(!out.unwrap().value()["defects"][category].is_null(), "{category}"),
            Row::Random | Row::Planes | Row::Angles => {}
        }
    }
}

#[test]
fn a_category_that_is_not_seen_fails_its_row() {
    for category in CATEGORIES {
        let found = asked(|_, _, mut out| {
            if let Some(defects) = out.get_mut("defects").and_then(Value::as_object_mut) {
                defects.remove(category);
            }
            out
        });
        assert!(found.contains(&(category, "wrong-defects")), "{category}: {found:?}");
        assert_eq!(faults(&found), BTreeSet::from(["wrong-defects"]), "{category}");
    }
}

#[test]
fn a_category_that_is_not_there_fails_too() {
    let report = judged(|op, _, mut out| {
        if op == "mesh.check" && out["defects"] == json!({}) {
            out["defects"]["boundary_edge"] = json!([[0, 1]]);
        }
        out
    });
    assert!(report.rows().all(|row| (row.name == "sound") == (row.wrong > 0)));
    let failure = &report.failures[0];
    assert_eq!((failure.row.as_str(), failure.fault.as_str()), ("sound", "wrong-defects"));
    // The smallest closed mesh without defects that is found: nothing smaller than a tetrahedron is one.
    let QuestionRecord::Other { op, input } = &failure.question else { panic!("not about a volume") };
    assert_eq!(op, "mesh.check");
    assert_eq!(input["faces"].as_array().unwrap().len(), 4);
}

#[test]
fn what_is_shrunk_keeps_the_defect_of_its_row_and_gets_no_other() {
    let report = judged(|op, _, mut out| {
        if op == "mesh.check" && out["counts"].is_object() {
            out["counts"]["closed"] = json!(!out["counts"]["closed"].as_bool().unwrap());
        }
        out
    });
    let categories = |input: &Value| -> BTreeSet<String> {
        let Value::Object(input) = input else { panic!("an object") };
        let out = isoracle::answer::out("mesh.check", input).unwrap().value();
        out["defects"].as_object().unwrap().keys().cloned().collect()
    };
    let mut shrunk = 0;
    for failure in report.failures.iter().filter(|failure| CATEGORIES.contains(&failure.row.as_str())) {
        let QuestionRecord::Other { input, .. } = &failure.question else { panic!("not about a volume") };
        assert!(categories(input).contains(&failure.row), "{}: {input}", failure.row);
        shrunk += 1;
    }
    // All but that of index_out_of_range, which has no counts.
    assert_eq!(shrunk, CATEGORIES.len() - 1);
    let sound = report.failures.iter().find(|failure| failure.row == "sound").unwrap();
    let QuestionRecord::Other { input, .. } = &sound.question else { panic!("not about a volume") };
    assert!(categories(input).is_empty());
}

#[test]
fn counts_and_properties_are_judged_one_by_one() {
    for (name, fault) in [
        ("V", "wrong-counts"),
        ("E", "wrong-counts"),
        ("H", "wrong-counts"),
        ("C", "wrong-counts"),
        ("chi", "wrong-counts"),
    ] {
        let found = asked(|op, _, mut out| {
            if op == "mesh.check" && out["counts"].is_object() {
                out["counts"][name] = json!(out["counts"][name].as_i64().unwrap() + 1);
            }
            out
        });
        assert_eq!(faults(&found), BTreeSet::from([fault]), "{name}");
    }
    for name in ["closed", "orientable", "manifold"] {
        let found = asked(|op, _, mut out| {
            if op == "mesh.check" && out["counts"].is_object() {
                out["counts"][name] = json!(!out["counts"][name].as_bool().unwrap());
            }
            out
        });
        assert_eq!(faults(&found), BTreeSet::from(["wrong-property"]), "{name}");
    }
}

#[test]
fn a_volume_may_be_rounded_but_not_wrong() {
    let rounded = |factor: f64| {
        asked(move |op, _, mut out| {
            if op == "mesh.check" && out["counts"]["volume"].is_string() {
                let text = out["counts"]["volume"].as_str().unwrap();
                let volume = isoracle::number::text::parse(text).unwrap().to_f64();
                if volume != 0.0 && volume.fract() != 0.0 {
                    out["counts"]["volume"] = json!(volume * factor);
                }
            }
            out
        })
    };
    assert!(rounded(1.0).is_empty());
    assert!(rounded(1.0 + 1e-7).is_empty());
    assert_eq!(faults(&rounded(1.0 + 1e-5)), BTreeSet::from(["wrong-volume"]));
    // A string is exact, and has to be.
    let found = asked(|op, _, mut out| {
        if op == "mesh.check" && out["counts"]["volume"].is_string() {
            out["counts"]["volume"] = json!(format!("{}.000001", out["counts"]["volume"].as_str().unwrap()));
        }
        out
    });
    assert!(faults(&found).contains("wrong-volume"));
}

#[test]
fn a_plane_is_judged_up_to_the_length_of_its_normal() {
    let scaled = |factor: f64, tilt: f64| {
        asked(move |op, _, mut out| {
            if op == "mesh.plane" {
                let real = |value: &Value| isoracle::number::text::parse(value.as_str().unwrap()).unwrap().to_f64();
                let mut normal: Vec<f64> = out["normal"].as_array().unwrap().iter().map(real).collect();
                let offset = real(&out["offset"]) * factor;
                normal.iter_mut().for_each(|x| *x *= factor);
                let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
                normal[0] += tilt * length;
                out["normal"] = json!(normal);
                out["offset"] = json!(offset);
            }
            out
        })
    };
    assert!(scaled(0.125, 0.0).is_empty());
    assert!(scaled(1.0 / 3.0, 0.0).is_empty());
    assert_eq!(faults(&scaled(-1.0, 0.0)), BTreeSet::from(["wrong-normal"]));
    assert!(faults(&scaled(1.0, 1e-3)).contains("wrong-normal"));
    // An exact answer has to be exact, whatever the length of its normal.
    let exactly = |tilt: &'static str, push: &'static str| {
        asked(move |op, _, mut out| {
            if op == "mesh.plane" {
                let real = |value: &Value| isoracle::number::text::parse(value.as_str().unwrap()).unwrap();
                let third = |x: isoracle::number::Rational| (x / 3u32).to_string();
                let add = |text: &str| isoracle::number::text::parse(text).unwrap();
                let normal: Vec<_> = out["normal"].as_array().unwrap().iter().map(real).collect();
                let length: isoracle::number::Rational = normal.iter().map(|x| x.clone().abs()).sum();
                let offset = real(&out["offset"]) + add(push);
                let tilted = normal
                    .iter()
                    .enumerate()
                    .map(|(i, x)| if i == 0 { x + length.clone() * add(tilt) } else { x.clone() });
                out["normal"] = json!(tilted.map(third).collect::<Vec<_>>());
                out["offset"] = json!(third(offset));
            }
            out
        })
    };
    assert!(exactly("0", "0").is_empty());
    assert!(faults(&exactly("1/1000000000", "0")).contains("wrong-normal"));
    assert_eq!(faults(&exactly("0", "1/1000000000")), BTreeSet::from(["wrong-offset"]));
    let found = asked(|op, _, mut out| {
        if op == "mesh.plane" {
            out["planar"] = json!(!out["planar"].as_bool().unwrap());
        }
        out
    });
    assert_eq!(faults(&found), BTreeSet::from(["wrong-planarity"]));
}

#[test]
fn deficits_are_judged_by_their_enclosures() {
    let found = asked(|op, _, mut out| {
        if op == "mesh.angle_deficits" {
            let wide = json!({"lo": "-100", "hi": "100"});
            out["deficits"].as_array_mut().unwrap().iter_mut().for_each(|deficit| *deficit = wide.clone());
        }
        out
    });
    assert!(found.is_empty(), "{found:?}");
    let found = asked(|op, _, mut out| {
        if op == "mesh.angle_deficits" {
            out["deficits"][0] = json!({"lo": "7", "hi": "8"});
        }
        out
    });
    assert_eq!(faults(&found), BTreeSet::from(["wrong-deficit"]));
    let found = asked(|op, _, mut out| {
        if op == "mesh.angle_deficits" {
            out["total_over_pi"] = json!("1/2");
        }
        out
    });
    assert_eq!(faults(&found), BTreeSet::from(["wrong-total"]));
}

#[test]
fn what_is_left_out_is_named_and_saying_nothing_is_wrong() {
    let report = judged(|op, _, out| match op {
        "mesh.check" if out["counts"].is_object() => json!({"counts": {"closed": out["counts"]["closed"]}}),
        _ => out,
    });
    assert_eq!(report.verdict, Outcome::Passed);
    assert!(report.left_out.contains(&"defects".to_owned()) && report.left_out.contains(&"counts.chi".to_owned()));
    assert!(!report.left_out.contains(&"counts.closed".to_owned()));
    let found = asked(|op, _, out| if op == "mesh.check" { json!({}) } else { out });
    assert_eq!(faults(&found), BTreeSet::from(["says-nothing"]));
}

#[test]
fn a_question_is_read_as_it_is_quoted() {
    for question in questions(5, 2) {
        let Value::Object(text) = SUITE.text(&question) else { panic!("an object") };
        let read = SUITE.parse(&text).unwrap();
        assert_eq!(SUITE.text(&read), SUITE.text(&question));
        assert!(matches!(SUITE.ask(&mut Altered(|_: &str, _: &Value, out| out), &read), Judgement::Right { .. }));
    }
}

//! Histograms in every form of the report.

use crate::{Altered, FAMILIES, Plain, judged, suite};
use isoracle::judge::accuracy::ALL_DIGITS_WRONG;
use isoracle::judge::html::page;
use isoracle::judge::junit::junit;
use isoracle::judge::numbers::Family;
use isoracle::judge::numbers::builtin::Formulas;
use isoracle::judge::report::{Report, json};
use isoracle::judge::text::text;
use serde_json::{Value, json};

fn of_formulas(family: Family) -> Report {
    judged(family, &mut Plain(Formulas::Corrected, |_: &str, _: &Value, out: Value| out))
}

#[test]
fn every_number_is_in_one_bucket_and_the_worst_is_shown() {
    for family in FAMILIES {
        let report = of_formulas(family);
        let operations: Vec<&str> = report.accuracy.iter().map(|accuracy| accuracy.operation.as_str()).collect();
        let mut expected = family.operations().to_vec();
        expected.sort_unstable();
        assert_eq!(operations, expected);
        for accuracy in &report.accuracy {
            assert_eq!(accuracy.componentwise.numbers, accuracy.normwise.numbers);
            for histogram in [&accuracy.componentwise, &accuracy.normwise] {
                let counted: usize = histogram.buckets.iter().map(|bucket| bucket.count).sum();
                assert_eq!(counted, histogram.numbers);
                assert_eq!(histogram.between(0, ALL_DIGITS_WRONG + 1), histogram.numbers);
                assert_eq!(histogram.buckets[0].count, histogram.correctly_rounded);
                let worst = histogram.worst.as_ref().expect("there are numbers");
                let last = histogram.buckets.last().expect("there are numbers");
                let bound: f64 = match last.up_to.as_str() {
                    "1/2" => 0.5,
                    "all digits wrong" => f64::MAX,
                    bound => bound.parse().expect("a power of two"),
                };
                assert!(
                    last.count > 0 && worst.units <= bound && (bound < 2.0 || worst.units * 2.0 >= bound.min(2e16))
                );
                assert_eq!(worst.question["op"], accuracy.operation.as_str());
            }
            // It passes, so nothing is farther off than it may be.
            assert!(accuracy.normwise.worst.as_ref().expect("there are numbers").units <= 4096.0);
        }
    }
}

#[test]
fn a_number_in_each_bucket_is_counted_there() {
    // 1 + 2⁻⁵²·2ⁱ for the true 1: i steps up the buckets.
    let mut step = 0;
    let report = judged(
        Family::Spline,
        &mut Altered(|op: &str, _: &Value, mut out: Value| {
            if op == "spline.coefficients" && out["coefficients"][0] == "1" {
                step += 1;
                out["coefficients"][0] = json!(1.0 + 2_f64.powi(-52) * 4.0);
            }
            out
        }),
    );
    let of = |report: &Report| report.accuracy.first().map(|accuracy| accuracy.componentwise.clone());
    match (step, of(&report)) {
        (0, None) => {}
        (_, Some(histogram)) => {
            assert_eq!((histogram.buckets.len(), histogram.buckets[3].up_to.as_str()), (4, "4"));
            assert_eq!(histogram.buckets[3].count, histogram.numbers);
        }
        (_, None) => panic!("numbers were said"),
    }
}

#[test]
fn the_forms_of_the_report_show_the_histograms() {
    let report = of_formulas(Family::Curvature);
    let read: Value = serde_json::from_str(&json(&report)).expect("JSON");
    assert_eq!(read["accuracy"][0]["operation"], "curvature.implicit_curve");
    assert_eq!(read["accuracy"][0]["normwise"]["buckets"][0]["up_to"], "1/2");
    let terminal = text(&report, false);
    assert!(terminal.contains("how far off") && terminal.contains("curvature.parametric_surface\n"));
    assert!(terminal.lines().all(|line| line.chars().count() <= 80), "{terminal}");
    let page = page(&report, &[]);
    assert_eq!(page.matches("<svg class=\"histogram\"").count(), 2 * report.accuracy.len());
    assert!(page.contains("correctly rounded") && page.contains("its question"));
    // JUnit is about verdicts.
    assert!(!junit(&report).contains("correctly rounded"));
}

#[test]
fn a_report_without_measured_numbers_is_as_ever() {
    for family in FAMILIES {
        let report = judged(family, &mut Altered(|_: &str, _: &Value, out| out));
        let read: Value = serde_json::from_str(&json(&report)).expect("JSON");
        assert!(read.get("accuracy").is_none());
        assert!(!text(&report, false).contains("how far off") && !page(&report, &[]).contains("id=\"accuracy\""));
        assert_eq!(read["suite"], if family == Family::Spline { "spline" } else { "curvature" });
    }
}

#[test]
fn a_failure_is_small_and_names_its_formula() {
    // c₀ is too large by one in a million.
    let report = judged(
        Family::Spline,
        &mut Altered(|op: &str, input: &Value, mut out: Value| {
            if op == "spline.coefficients" && input["shape"][2].is_number() && out["coefficients"][0] != "0" {
                let number = isoracle::answer::value::number(&out["coefficients"][0]).expect("a number");
                out["coefficients"][0] = json!(number.to_f64() * 1.000_001);
            }
            out
        }),
    );
    let failure = report.failures.iter().find(|failure| failure.row == "3d-mirror").expect("it fails");
    assert_eq!((failure.fault.as_str(), failure.formula.as_str()), ("wrong-coefficients", "SP-2"));
    let isoracle::judge::report::QuestionRecord::Other { input, .. } = &failure.question else { panic!("no volume") };
    assert_eq!(input["shape"], json!([2, 2, 2]));
    let values = input["values"].as_array().expect("values");
    assert_eq!(values.iter().filter(|value| *value != "0").count(), 1, "{values:?}");
    assert!(failure.command.contains("--suite spline --question"));
    // What is wrong is measured as what is right.
    let worst = report.accuracy[0].normwise.worst.as_ref().expect("a number was said");
    assert!(worst.units > suite(Family::Spline).most.units && worst.question["in"]["shape"][2].is_number());
}

//! The questions are what their rows say.

use crate::{Altered, FAMILIES, suite};
use isoracle::answer::value;
use isoracle::judge::numbers::Family;
use isoracle::judge::numbers::curvature::is_of_row;
use isoracle::judge::suite::{Judgement, Suite};
use isoracle::number::Rational;
use serde_json::{Value, json};
use std::collections::BTreeSet;

fn number(x: &Value) -> Rational {
    value::number(x).expect("a number")
}

#[test]
fn the_same_seed_asks_the_same_questions() {
    for family in FAMILIES {
        assert_eq!(family.questions(3, 2), family.questions(3, 2));
        assert_ne!(family.questions(3, 2), family.questions(4, 2));
        let rows: BTreeSet<&str> = family.questions(3, 1).iter().map(|question| question.row).collect();
        assert_eq!(rows, family.rows().into_iter().flatten().copied().collect());
    }
}

#[test]
fn every_operation_is_asked() {
    for family in FAMILIES {
        let asked: BTreeSet<&str> = family.questions(3, 6).iter().map(|question| question.operation).collect();
        assert_eq!(asked, family.operations().iter().copied().collect());
    }
}

#[test]
fn broken_questions_are_ill_posed_and_singular_ones_degenerate() {
    for family in FAMILIES {
        for question in family.questions(5, 20) {
            let kind = question.truth().map(drop);
            let expected = match question.row {
                "broken" => Err("invalid-input"),
                "singular" => Err("degenerate"),
                _ => Ok(()),
            };
            assert_eq!(kind, expected, "{}: {}", question.row, question.input);
        }
    }
}

#[test]
fn level_sets_are_what_the_names_of_their_rows_say() {
    for question in Family::Curvature.questions(11, 8) {
        let Ok(out) = question.truth() else { continue };
        assert!(is_of_row(question.row, &out), "{}: {}", question.row, question.input);
    }
}

#[test]
fn a_row_is_not_what_another_row_is() {
    let truth = |polynomial: Value, point: Value| {
        let input = json!({"polynomial": polynomial, "point": point});
        let Value::Object(input) = input else { unreachable!("an object") };
        isoracle::answer::out("curvature.implicit_surface", &input).expect("regular").value()
    };
    let sphere = truth(json!([[1, 2, 0, 0], [1, 0, 2, 0], [1, 0, 0, 2]]), json!([0, 3, 4]));
    let cylinder = truth(json!([[1, 2, 0, 0], [1, 0, 2, 0]]), json!([3, 4, 0]));
    let plane = truth(json!([[1, 1, 0, 0], [2, 0, 0, 1]]), json!([1, 1, 1]));
    let saddle = truth(json!([[1, 1, 1, 0], [1, 0, 0, 1]]), json!([1, 1, 1]));
    let kinds = [("spheres", &sphere), ("cylinders", &cylinder), ("planes", &plane), ("saddles", &saddle)];
    for (row, (name, out)) in
        ["spheres", "cylinders", "planes", "saddles"].into_iter().flat_map(|row| kinds.map(|k| (row, k)))
    {
        assert_eq!(is_of_row(row, out), row == name, "{name} as {row}");
    }
    assert!(is_of_row("fz-zero", &cylinder) && !is_of_row("fz-zero", &sphere));
    assert!(is_of_row("near-umbilics", &sphere) && !is_of_row("near-umbilics", &saddle));
    assert!(!is_of_row("near-singular", &sphere));
}

#[test]
fn both_boundary_rules_and_two_samples_and_all_places_are_asked() {
    let asked = Family::Spline.questions(2, 6);
    for row in ["two-samples", "long-lines", "constants", "single-samples", "values-3d", "outside", "huge-range"] {
        let boundaries: BTreeSet<String> =
            asked.iter().filter(|q| q.row == row).map(|q| q.input["boundary"].to_string()).collect();
        assert_eq!(boundaries.len(), 2, "{row}");
    }
    for question in &asked {
        let sides = || question.input["shape"].as_array().expect("a shape").iter();
        let coordinates = || {
            let points = question.input["points"].as_array().expect("points").iter();
            points.flat_map(|point| point.as_array().expect("a point")).map(number)
        };
        match question.row {
            "two-samples" => assert!(sides().any(|n| n == 2)),
            "long-lines" => assert!(sides().any(|n| n.as_u64() >= Some(100))),
            "knots" => assert!(coordinates().all(|x| x.is_integer())),
            "half-integers" => assert!(coordinates().all(|x| *x.denom() == 2)),
            _ => {}
        }
    }
    let outside = asked.iter().filter(|q| q.row == "outside");
    assert!(outside.flat_map(|q| q.input["points"].as_array().expect("points")).any(|p| number(&p[0]) < 0));
}

#[test]
fn a_question_is_read_as_it_is_quoted() {
    for family in FAMILIES {
        let suite = suite(family);
        for question in family.questions(5, 1) {
            let Value::Object(text) = suite.text(&question) else { panic!("an object") };
            let read = suite.parse(&text).expect("it is one");
            assert_eq!(suite.text(&read), suite.text(&question));
            let judgement = suite.ask(&mut Altered(|_: &str, _: &Value, out| out), &read);
            assert!(matches!(judgement, Judgement::Right { .. }));
        }
    }
}

#[test]
fn smaller_questions_are_smaller_and_of_the_same_kind() {
    for family in FAMILIES {
        let suite = suite(family);
        for question in family.questions(9, 1) {
            let kind = question.truth().map(drop);
            for smaller in suite.smaller(&question).take(6) {
                assert!(suite.size(&smaller) < suite.size(&question));
                let truth = smaller.truth();
                assert!(
                    truth.as_ref().map_or(true, |out| is_of_row(question.row, out)),
                    "{}: {}",
                    smaller.row,
                    smaller.input
                );
                assert_eq!((smaller.row, truth.map(drop)), (question.row, kind));
            }
        }
    }
}

//! The text's formulas in binary64: right as corrected, and rejected as printed.

use crate::{FAMILIES, Plain, faults_in, judged, names, suite};
use isoracle::judge::numbers::builtin::Formulas;
use isoracle::judge::numbers::question::Question;
use isoracle::judge::numbers::{Family, Numbers};
use isoracle::judge::report::Outcome;
use isoracle::judge::suite::{Judgement, Suite};
use serde_json::Value;
use std::collections::BTreeSet;

fn as_it_is(_: &str, _: &Value, out: Value) -> Value {
    out
}

fn found(which: Formulas) -> BTreeSet<(&'static str, &'static str)> {
    faults_in(&suite(Family::Curvature), &mut Plain(which, as_it_is))
}

#[test]
fn the_corrected_formulas_pass() {
    for family in FAMILIES {
        let report = judged(family, &mut Plain(Formulas::Corrected, as_it_is));
        assert_eq!(report.verdict, Outcome::Passed, "{:?}", report.failures.first());
        assert!(report.left_out.is_empty(), "{:?}", report.left_out);
    }
}

#[test]
fn the_corrected_formulas_pass_whatever_the_seed() {
    let seeds = if std::env::var_os("ISORACLE_LONG").is_some() { 100..140 } else { 100..101 };
    for (family, seed) in FAMILIES.into_iter().flat_map(|family| seeds.clone().map(move |seed| (family, seed))) {
        let suite = Numbers { seed, cases: 4, ..suite(family) };
        let faults = faults_in(&suite, &mut Plain(Formulas::Corrected, as_it_is));
        assert!(faults.is_empty(), "seed {seed}: {faults:?}");
    }
}

#[test]
fn the_printed_numerator_of_a_level_curve_is_rejected() {
    let found = found(Formulas::PrintedKappa);
    assert!(found.contains(&("cubic-curves", "wrong-curvature")) || found.contains(&("cubic-curves", "wrong-sign")));
    assert!(found.iter().all(|(row, _)| !["spheres", "parametric-curves", "normalize"].contains(row)));
}

#[test]
fn the_printed_sign_of_h_is_rejected() {
    let found = found(Formulas::PrintedMean);
    assert_eq!(names(&found), BTreeSet::from(["wrong-sign"]));
    assert!(found.contains(&("spheres", "wrong-sign")) && found.contains(&("spline-3d", "wrong-sign")));
    // H = 0 has no sign to be wrong.
    assert!(!found.contains(&("planes", "wrong-sign")));
}

#[test]
fn the_frobenius_norm_of_ph_is_rejected() {
    let found = found(Formulas::PrintedFrobenius);
    assert!(found.contains(&("cubic-surfaces", "wrong-principal")), "{found:?}");
    assert!(found.contains(&("spline-3d", "wrong-principal")) || found.contains(&("spline-3d", "no-number")));
    assert!(names(&found).is_subset(&BTreeSet::from(["wrong-principal", "no-number"])));
}

#[test]
fn determinants_over_fz_are_rejected_where_fz_is_0() {
    let found = found(Formulas::PrintedDeterminants);
    let rows: BTreeSet<&str> = found.iter().map(|(row, _)| *row).collect();
    assert!(rows.contains("fz-zero"), "{found:?}");
    // Other surfaces may have an f_z near 0 too, but not these.
    let others = ["planes", "circles", "cubic-curves", "parametric-surfaces", "spline-2d", "normalize"];
    assert!(rows.is_disjoint(&BTreeSet::from(others)), "{found:?}");
}

#[test]
fn every_printed_form_fails_the_suite_and_is_shown_by_a_small_question() {
    let suite = Numbers { cases: 1, ..suite(Family::Curvature) };
    for which in Formulas::ALL.into_iter().filter(|which| *which != Formulas::Corrected) {
        let candidate = &mut Plain(which, as_it_is);
        let mut fault_of = |question: &Question| match suite.ask(candidate, question) {
            Judgement::Wrong { fault, .. } => Some(fault),
            Judgement::Right { .. } | Judgement::Unsupported(_) | Judgement::Broken(_) => None,
        };
        let mut smallest = suite.questions().into_iter().find(|q| fault_of(q).is_some()).expect("it fails");
        let fault = fault_of(&smallest);
        loop {
            let next = suite.smaller(&smallest).find(|q| fault_of(q) == fault);
            match next {
                Some(smaller) => smallest = smaller,
                None => break,
            }
        }
        assert!(suite.text(&smallest).to_string().len() < 200, "{}: {}", which.name(), smallest.input);
    }
}

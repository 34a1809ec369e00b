//! Asking a candidate a whole suite, and gathering what it got wrong.

use super::accuracy::Accuracy;
use super::candidate::{Breakdown, Candidate, Reply};
use super::report::{CandidateInfo, Failure, Outcome, PositionError, Report, Row, Seconds};
use super::shrink::shrink;
use super::suite::{Judgement, Suite};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::time::Instant;

/// What the candidate says of itself.
///
/// # Errors
/// It does not speak the protocol, or lists its operations and none of these is among them.
pub fn hello(candidate: &mut dyn Candidate, operations: &[&str]) -> Result<CandidateInfo, Breakdown> {
    let command = candidate.command().to_vec();
    match candidate.ask("hello", &json!({"protocol": 1})) {
        Reply::Out(out) => {
            let text = |name: &str| out.get(name).and_then(Value::as_str).unwrap_or("?").to_owned();
            let ops = out.get("ops").and_then(Value::as_array);
            if ops.is_some_and(|ops| !operations.iter().any(|op| ops.contains(&json!(op)))) {
                let operations = operations.join(" or ");
                return Err(Breakdown::Nonsense(format!("its hello does not list the operation {operations}")));
            }
            Ok(CandidateInfo { name: text("name"), version: text("version"), command })
        }
        // A candidate may have no name; it is judged all the same.
        Reply::Unsupported(_) | Reply::Error { .. } => {
            Ok(CandidateInfo { name: "unnamed".into(), version: "?".into(), command })
        }
        Reply::Broken(breakdown) => Err(breakdown),
    }
}

/// The counts of one row, and the smallest failing question for each fault.
struct Tally<Q> {
    asked: usize,
    passed: usize,
    wrong: usize,
    broken: usize,
    unsupported: usize,
    faults: BTreeMap<&'static str, usize>,
    smallest: BTreeMap<&'static str, Q>,
}

impl<Q> Default for Tally<Q> {
    fn default() -> Tally<Q> {
        let (faults, smallest) = (BTreeMap::new(), BTreeMap::new());
        Tally { asked: 0, passed: 0, wrong: 0, broken: 0, unsupported: 0, faults, smallest }
    }
}

/// Runs a suite; `progress` is told after each question how many are done, of how many.
///
/// # Errors
/// The candidate does not even say hello.
pub fn run<S: Suite>(
    candidate: &mut dyn Candidate,
    suite: &S,
    mut progress: impl FnMut(usize, usize),
) -> Result<Report, Breakdown> {
    let start = Instant::now();
    let info = hello(candidate, suite.operations())?;
    let mut seconds = Seconds::default();
    let mut position_error = PositionError::default();
    let mut accuracy: BTreeMap<&'static str, Accuracy> = BTreeMap::new();
    let mut all_left_out = BTreeSet::new();
    let mut tallies: BTreeMap<String, Tally<S::Question>> = BTreeMap::new();
    let questions = suite.questions();
    for (done, question) in questions.iter().enumerate() {
        let tally = tallies.entry(suite.row(question)).or_default();
        let asked = Instant::now();
        let judgement = suite.ask(candidate, question);
        seconds.candidate += asked.elapsed().as_secs_f64();
        let answered = Instant::now();
        suite.answer(question);
        seconds.oracle += answered.elapsed().as_secs_f64();
        tally.asked += 1;
        if let Judgement::Right { measured, .. } | Judgement::Wrong { measured, .. } = &judgement {
            for number in measured {
                let operation = suite.operation(question);
                let of = accuracy.entry(operation).or_insert_with(|| Accuracy::new(operation));
                of.note(number, || suite.text(question));
            }
        }
        match judgement {
            Judgement::Right { error, left_out, .. } => {
                tally.passed += 1;
                position_error.widen(error);
                all_left_out.extend(left_out);
            }
            Judgement::Unsupported(_) => tally.unsupported += 1,
            Judgement::Broken(_) => {
                tally.broken += 1;
                tally.note(suite, "broken", question);
            }
            Judgement::Wrong { fault, error, .. } => {
                tally.wrong += 1;
                position_error.widen(error);
                tally.note(suite, fault, question);
            }
        }
        progress(done + 1, questions.len());
    }
    let [cases, groups] = suite.rows();
    let mut failures = Vec::new();
    for name in cases.iter().chain(&groups) {
        for (fault, question) in tallies.get(name).into_iter().flat_map(|tally| &tally.smallest) {
            let question = shrink(suite, candidate, question, fault);
            failures.extend(failure(suite, candidate, &question, fault, &info));
        }
    }
    let row = |name: &String| tallies.get(name).map_or_else(|| Tally::<()>::default().row(name), |t| t.row(name));
    let cases: Vec<Row> = cases.iter().map(row).collect();
    let groups: Vec<Row> = groups.iter().map(row).collect();
    let rows = || cases.iter().chain(&groups);
    let verdict = if rows().any(|row| row.wrong > 0) {
        Outcome::Wrong
    } else if rows().any(|row| row.broken > 0) {
        Outcome::Broken
    } else {
        Outcome::Passed
    };
    seconds.total = start.elapsed().as_secs_f64();
    Ok(Report {
        report: 1,
        candidate: info,
        suite: suite.name().into(),
        seed: suite.seed(),
        verdict,
        cases,
        groups,
        failures,
        left_out: all_left_out.into_iter().collect(),
        position_error,
        accuracy: accuracy.into_values().collect(),
        seconds,
    })
}

impl<Q: Clone> Tally<Q> {
    fn note<S: Suite<Question = Q>>(&mut self, suite: &S, fault: &'static str, question: &Q) {
        *self.faults.entry(fault).or_default() += 1;
        let known = self.smallest.entry(fault).or_insert_with(|| question.clone());
        if suite.size(question) < suite.size(known) {
            *known = question.clone();
        }
    }
}

impl<Q> Tally<Q> {
    fn row(&self, name: &str) -> Row {
        Row {
            name: name.to_owned(),
            asked: self.asked,
            passed: self.passed,
            wrong: self.wrong,
            broken: self.broken,
            unsupported: self.unsupported,
            faults: self.faults.iter().map(|(name, count)| ((*name).to_owned(), *count)).collect(),
        }
    }
}

/// The record of a failing question; `None` if it does not fail any more.
pub fn failure<S: Suite>(
    suite: &S,
    candidate: &mut dyn Candidate,
    question: &S::Question,
    fault: &str,
    info: &CandidateInfo,
) -> Option<Failure> {
    let (evidence, breakdown) = match suite.ask(candidate, question) {
        Judgement::Right { .. } | Judgement::Unsupported(_) => return None,
        Judgement::Broken(breakdown) => (None, Some(breakdown)),
        Judgement::Wrong { evidence, .. } => (Some(evidence), None),
    };
    let mut failure = suite.failure(question, evidence);
    failure.row = suite.row(question);
    failure.fault = fault.to_owned();
    failure.messages.extend(breakdown.map(|breakdown| breakdown.to_string()));
    let suite_option = if suite.name() == "isosurface" { String::new() } else { format!("--suite {} ", suite.name()) };
    let command: Vec<String> = info.command.iter().map(|word| quoted(word)).collect();
    let text = quoted(&suite.text(question).to_string());
    failure.command = format!("isoracle judge {suite_option}--question {text} -- {}", command.join(" "));
    Some(failure)
}

/// A word as a shell reads it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=:,+@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

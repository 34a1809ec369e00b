//! The suites `spline` and `curvature`: they pass the oracle and a good implementation in binary64, and reject each wrong answer
//! for what is wrong with it.
#![cfg(feature = "cli")]
#![allow(missing_docs)]

mod answers;
mod builtin;
mod deviation;
mod questions;
mod reports;

use isoracle::judge::builtin::{Builtin, serve};
use isoracle::judge::candidate::{Candidate, Reply};
use isoracle::judge::numbers::builtin::Formulas;
use isoracle::judge::numbers::question::Question;
use isoracle::judge::numbers::{Family, MaxError, Numbers};
use isoracle::judge::report::Report;
use isoracle::judge::run::run;
use isoracle::judge::suite::{Judgement, Suite};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::sync::OnceLock;

pub fn suite(family: Family) -> Numbers {
    Numbers { family, seed: 7, cases: 6, most: MaxError::default() }
}

pub const FAMILIES: [Family; 2] = [Family::Spline, Family::Curvature];

fn reply(line: &[u8]) -> Reply {
    let mut message: Value = serde_json::from_slice(line).expect("a message");
    if let Some(why) = message.get("unsupported") {
        return Reply::Unsupported(why.to_string());
    }
    match message.get_mut("out") {
        Some(out) => Reply::Out(out.take()),
        None => {
            let text = |name: &str| message["error"][name].as_str().expect("an error has texts").to_owned();
            Reply::Error { kind: text("kind"), message: text("message") }
        }
    }
}

/// The oracle, its answers altered.
pub struct Altered<F>(pub F);

impl<F: FnMut(&str, &Value, Value) -> Value> Candidate for Altered<F> {
    fn ask(&mut self, op: &str, input: &Value) -> Reply {
        let line = json!({"id": 1, "op": op, "in": input}).to_string();
        match reply(isoracle::answer::answer(line.as_bytes()).as_bytes()) {
            Reply::Out(out) => Reply::Out((self.0)(op, input, out)),
            other => other,
        }
    }
    fn command(&self) -> &[String] {
        &[]
    }
}

/// The text's formulas, their answers altered.
pub struct Plain<F>(pub Formulas, pub F);

impl<F: FnMut(&str, &Value, Value) -> Value> Candidate for Plain<F> {
    fn ask(&mut self, op: &str, input: &Value) -> Reply {
        let line = json!({"id": 1, "op": op, "in": input}).to_string();
        let mut out = Vec::new();
        serve(Builtin::Formulas(self.0), line.as_bytes(), &mut out).expect("memory can be written");
        match reply(&out) {
            Reply::Out(out) => Reply::Out((self.1)(op, input, out)),
            other => other,
        }
    }
    fn command(&self) -> &[String] {
        &[]
    }
}

pub fn judged(family: Family, candidate: &mut dyn Candidate) -> Report {
    run(candidate, &suite(family), |_, _| {}).expect("it says hello")
}

/// The rows and faults of wrong answers; nothing is shrunk.
pub fn faults_in(suite: &Numbers, candidate: &mut dyn Candidate) -> BTreeSet<(&'static str, &'static str)> {
    static ASKED: [OnceLock<Vec<Question>>; 2] = [OnceLock::new(), OnceLock::new()];
    let cell = &ASKED[usize::from(suite.family == Family::Curvature)];
    let own = Numbers { family: suite.family, ..self::suite(suite.family) };
    let is_own = (suite.seed, suite.cases) == (own.seed, own.cases);
    let drawn = if is_own { cell.get_or_init(|| own.questions()).clone() } else { suite.questions() };
    let faults = drawn.into_iter().filter_map(|question| match suite.ask(candidate, &question) {
        Judgement::Right { .. } => None,
        Judgement::Wrong { fault, .. } => Some((question.row, fault)),
        Judgement::Unsupported(why) => panic!("{why}"),
        Judgement::Broken(why) => panic!("{why}"),
    });
    faults.collect()
}

/// The oracle's altered answers, judged.
pub fn altered(
    family: Family,
    alter: impl FnMut(&str, &Value, Value) -> Value,
) -> BTreeSet<(&'static str, &'static str)> {
    faults_in(&suite(family), &mut Altered(alter))
}

pub fn names(found: &BTreeSet<(&'static str, &'static str)>) -> BTreeSet<&'static str> {
    found.iter().map(|(_, fault)| *fault).collect()
}

/// The judgement of one answer to one question.
pub fn judge(
    family: Family,
    most: MaxError,
    op: &'static str,
    input: Value,
    answer: Value,
) -> (Option<&'static str>, Vec<String>) {
    let suite = Numbers { most, ..suite(family) };
    let question = Question { row: family.rows()[0][0], operation: op, input };
    match suite.ask(&mut Altered(|_: &str, _: &Value, _: Value| answer.clone()), &question) {
        Judgement::Right { left_out, .. } => (None, left_out),
        Judgement::Wrong { fault, .. } => (Some(fault), Vec::new()),
        Judgement::Unsupported(why) => panic!("{why}"),
        Judgement::Broken(why) => panic!("{why}"),
    }
}

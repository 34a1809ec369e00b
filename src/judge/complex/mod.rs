//! The suite `complex`: gluing schemes of closed 3-manifolds and of what is none, and refinements of them.

mod bases;
mod compare;
mod disguise;
mod plant;
pub mod questions;
mod smaller;

pub use disguise::disguised;

use super::candidate::{Candidate, Reply};
use super::fault::{self, Evidence, failure};
use super::report::Failure;
use super::suite::{Judgement, Suite};
use crate::answer::value::{InvalidField, Object};
use crate::complex::closed_complex::ClosedComplex;
use crate::complex::manifold::Manifold3;
use crate::complex::scheme::{GluingScheme, Reason, SchemeDefect};
use questions::{Question, Row, questions};
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// The suite, with how to run it.
#[derive(Clone, Copy, Debug)]
pub struct Complex {
    /// The seed of the random questions.
    pub seed: u64,
    /// How many questions of each row.
    pub cases: usize,
}

/// The kinds of error that a scheme may be refused with that is no manifold.
const REFUSALS: [&str; 2] = ["invalid-input", "degenerate"];

/// Judges a reply. A scheme that is no manifold may be refused for either reason, and one that is none at all be refused
/// where the oracle answers with its reasons.
fn judge(question: &Question, reply: Reply) -> Judgement<Evidence> {
    let truth = truth(question);
    match (&truth, &reply) {
        // Whether a scheme is ill-posed or only no manifold is told apart by the reasons of `complex.glue`.
        (Err(_), Reply::Error { kind, .. }) if REFUSALS.contains(&&kind[..]) => return Judgement::right(),
        (Ok(truth), Reply::Error { kind, .. }) if kind == "invalid-input" && is_ill_posed(truth) => {
            return Judgement::right();
        }
        (_, _) => {}
    }
    fault::judge(compare::formula("answer"), truth, reply, |truth, found| {
        compare::compare(question.operation(), truth, found)
    })
}

/// Whether the truth is that the scheme is no scheme at all: nothing can be glued.
fn is_ill_posed(truth: &Value) -> bool {
    let glued = ["edge-reversed", "vertex-link"];
    truth["valid"] == false && !compare::reasons(truth).iter().any(|reason| glued.contains(reason))
}

/// The oracle's answer, or the kind of error that the question is.
fn truth(question: &Question) -> Result<Value, &'static str> {
    fault::truth(question.operation(), &question.input())
}

/// The reasons for which a scheme is no manifold, none iff it is one.
fn reasons(scheme: &GluingScheme) -> BTreeSet<Reason> {
    let manifold = ClosedComplex::new(scheme.clone()).and_then(Manifold3::of);
    manifold.err().unwrap_or_default().iter().map(SchemeDefect::reason).collect()
}

impl Suite for Complex {
    type Question = Question;
    type Evidence = Evidence;

    fn name(&self) -> &'static str {
        "complex"
    }

    fn operations(&self) -> &'static [&'static str] {
        &["complex.glue", "complex.refine"]
    }

    fn rows(&self) -> [Vec<String>; 2] {
        let names = |rows: &[Row]| rows.iter().map(|row| row.name().to_owned()).collect();
        [names(&Row::CASES), names(&Row::groups())]
    }

    fn seed(&self) -> u64 {
        self.seed
    }

    fn questions(&self) -> Vec<Question> {
        questions(self.seed, self.cases)
    }

    fn row(&self, question: &Question) -> String {
        question.row.name().to_owned()
    }

    fn operation(&self, question: &Question) -> &'static str {
        question.operation()
    }

    fn ask(&self, candidate: &mut dyn Candidate, question: &Question) -> Judgement<Evidence> {
        let reply = candidate.ask(question.operation(), &question.input());
        judge(question, reply)
    }

    fn answer(&self, question: &Question) {
        let own = truth(question);
        debug_assert!(own != Err("unsupported"));
    }

    fn size(&self, question: &Question) -> impl Ord {
        smaller::size(question)
    }

    fn smaller(&self, question: &Question) -> impl Iterator<Item = Question> {
        smaller::smaller(question)
    }

    fn failure(&self, question: &Question, evidence: Option<Evidence>) -> Failure {
        let faults = evidence.map_or(Vec::new(), |evidence| evidence.0);
        failure(faults, question.row.name(), question.operation(), question.input(), None)
    }

    fn text(&self, question: &Question) -> Value {
        json!({"op": question.operation(), "in": question.input()})
    }

    fn parse(&self, text: &Object) -> Result<Question, InvalidField> {
        Question::parse(text)
    }
}

//! What is wrong with an answer, field by field, and the failure that a report makes of it.

use super::accuracy::Measured;
use super::candidate::Reply;
use super::report::{Difference, Failure, PositionError, QuestionRecord, SurfaceRecord};
use super::suite::Judgement;
use crate::answer;
use serde_json::Value;

/// One way in which an answer is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Its short name, by which failures are told apart.
    pub name: &'static str,
    /// The spec entry of the truth that it breaks.
    pub formula: &'static str,
    /// One sentence.
    pub message: String,
    /// What differs.
    pub invariant: String,
    /// The truth.
    pub expected: String,
    /// The candidate's.
    pub found: String,
}

impl Fault {
    /// A field that differs from the truth.
    pub fn new(name: &'static str, formula: &'static str, invariant: &str, expected: &str, found: &str) -> Fault {
        let message = format!("{invariant}: expected {expected}, found {found}");
        let [invariant, expected, found] = [invariant, expected, found].map(str::to_owned);
        Fault { name, formula, message, invariant, expected, found }
    }

    /// An error where there is an answer, or another error than the question is.
    pub fn refused(formula: &'static str, expected: &str, found: &str) -> Fault {
        Fault::new("refused", formula, "kind of answer", expected, found)
    }

    /// An answer where the question has none.
    pub fn answered(formula: &'static str, kind: &str, out: &Value) -> Fault {
        Fault::new("answered", formula, "kind of answer", &format!("an error: {kind}"), &out.to_string())
    }
}

/// What shows that an answer is wrong: the weightiest first.
#[derive(Clone, Debug)]
pub struct Evidence(pub Vec<Fault>);

/// An answer beside the true one.
#[derive(Clone, Debug, Default)]
pub struct Comparison {
    /// What is wrong, the weightiest first.
    pub faults: Vec<Fault>,
    /// The fields that it leaves out.
    pub left_out: Vec<String>,
    /// The errors of its plain numbers, where they are measured.
    pub measured: Vec<Measured>,
}

/// The oracle's answer, or the kind of error that the question is.
///
/// # Panics
/// Where `input` is no object.
pub fn truth(operation: &str, input: &Value) -> Result<Value, &'static str> {
    let Value::Object(input) = input else { unreachable!("a question's `in` is an object") };
    match answer::out(operation, input) {
        Ok(out) => Ok(out.value()),
        Err(refusal) => Err(refusal.kind().map_or("unsupported", |kind| kind.name())),
    }
}

/// Judges a reply: an answer by `compare`, an error by whether the question is one of that kind. `formula` is the spec entry of
/// the operation as a whole.
pub fn judge(
    formula: &'static str,
    truth: Result<Value, &'static str>,
    reply: Reply,
    compare: impl FnOnce(&Value, &Value) -> Comparison,
) -> Judgement<Evidence> {
    let refused = |expected: &str, kind: &str, message: &str| {
        let faults = vec![Fault::refused(formula, expected, &format!("{kind}: {message}"))];
        Comparison { faults, ..Comparison::default() }
    };
    let Comparison { faults, left_out, measured } = match (truth, reply) {
        (_, Reply::Broken(breakdown)) => return Judgement::Broken(breakdown),
        (_, Reply::Unsupported(why)) => return Judgement::Unsupported(why),
        (_, Reply::Error { kind, message }) if kind == "limit" => return Judgement::Unsupported(message),
        (Err(kind), Reply::Error { kind: found, .. }) if found == kind => return Judgement::right(),
        (Err(kind), Reply::Error { kind: found, message }) => refused(kind, &found, &message),
        (Err(kind), Reply::Out(out)) => {
            Comparison { faults: vec![Fault::answered(formula, kind, &out)], ..Comparison::default() }
        }
        (Ok(_), Reply::Error { kind, message }) => refused("an answer", &kind, &message),
        (Ok(truth), Reply::Out(out)) => compare(&truth, &out),
    };
    let error = PositionError::default();
    match faults.first().map(|fault| fault.name) {
        None => Judgement::Right { error, left_out, measured },
        Some(fault) => Judgement::Wrong { fault, error, measured, evidence: Evidence(faults) },
    }
}

/// The failure of a question of that row, the weightiest fault first.
pub fn failure(faults: Vec<Fault>, row: &str, op: &str, input: Value, expected: Option<SurfaceRecord>) -> Failure {
    let difference =
        |fault: Fault| Difference { invariant: fault.invariant, expected: fault.expected, found: fault.found };
    Failure {
        row: String::new(),
        case: row.to_owned(),
        fault: String::new(),
        formula: faults.first().map_or("", |fault| fault.formula).to_owned(),
        messages: faults.iter().take(8).map(|fault| fault.message.clone()).collect(),
        question: QuestionRecord::Other { op: op.to_owned(), input },
        differences: faults.into_iter().take(4).map(difference).collect(),
        expected,
        found: None,
        command: String::new(),
    }
}

//! What is wrong with an answer, field by field, and the failure that a report makes of it.

use super::report::{Difference, Failure, QuestionRecord, SurfaceRecord};
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

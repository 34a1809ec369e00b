//! The suites `spline` and `curvature`: numbers, each judged by how far it is from the exact one.

pub mod builtin;
pub mod compare;
mod conditioning;
pub mod curvature;
pub mod deviation;
mod plain;
pub mod question;
pub mod real;
mod scale;
mod smaller;
pub mod spline;

use super::candidate::Candidate;
use super::fault::{self, Evidence, failure};
use super::report::Failure;
use super::suite::{Judgement, Suite};
use crate::answer::value::{InvalidField, Object};
use question::Question;
use serde_json::{Value, json};

/// What the questions are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Cubic splines: coefficients, values and derivatives.
    Spline,
    /// Curvatures: of level sets, parametrised curves and surfaces, and splines.
    Curvature,
}

/// How far off a plain number may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxError {
    /// In units of 2⁻⁵² of the largest number of its list ([`super::accuracy`]).
    pub units: f64,
    /// Whether it may be no more than that many units in its last place off, either.
    pub componentwise: bool,
}

impl Default for MaxError {
    /// 4096 units: 9·10⁻¹³ of the largest number. Questions of ordinary rows are so well-conditioned that the plain formulas in
    /// binary64 stay below it.
    fn default() -> MaxError {
        MaxError { units: 4096.0, componentwise: false }
    }
}

/// A suite of either family, with how to run it.
#[derive(Clone, Copy, Debug)]
pub struct Numbers {
    /// What it asks about.
    pub family: Family,
    /// The seed of the random questions.
    pub seed: u64,
    /// How many questions of each row.
    pub cases: usize,
    /// How far off plain numbers may be.
    pub most: MaxError,
}

impl Family {
    /// The family of one of its operations.
    fn of(operation: &str) -> Family {
        if operation.starts_with("spline.") { Family::Spline } else { Family::Curvature }
    }

    /// The rows: those of ordinary questions, then those of hard, degenerate and broken ones.
    pub const fn rows(self) -> [&'static [&'static str]; 2] {
        match self {
            Family::Spline => [&spline::ROWS, &spline::GROUPS],
            Family::Curvature => [&curvature::ROWS, &curvature::GROUPS],
        }
    }

    /// The operations, each with the row that a question on the command line belongs to.
    pub const fn operations(self) -> &'static [&'static str] {
        match self {
            Family::Spline => &["spline.coefficients", "spline.evaluate", "spline.impulse"],
            Family::Curvature => &[
                "curvature.implicit_curve",
                "curvature.implicit_surface",
                "curvature.parametric_curve",
                "curvature.parametric_surface",
                "curvature.spline",
                "curvature.normalize",
            ],
        }
    }

    /// The questions, `cases` of each row.
    pub fn questions(self, seed: u64, cases: usize) -> Vec<Question> {
        match self {
            Family::Spline => question::questions(self, seed, cases, spline::question),
            Family::Curvature => question::questions(self, seed, cases, curvature::question),
        }
    }
}

impl Suite for Numbers {
    type Question = Question;
    type Evidence = Evidence;

    fn name(&self) -> &'static str {
        match self.family {
            Family::Spline => "spline",
            Family::Curvature => "curvature",
        }
    }

    fn operations(&self) -> &'static [&'static str] {
        self.family.operations()
    }

    fn rows(&self) -> [Vec<String>; 2] {
        self.family.rows().map(|rows| rows.iter().map(|row| (*row).to_owned()).collect())
    }

    fn seed(&self) -> u64 {
        self.seed
    }

    fn questions(&self) -> Vec<Question> {
        self.family.questions(self.seed, self.cases)
    }

    fn row(&self, question: &Question) -> String {
        question.row.to_owned()
    }

    fn operation(&self, question: &Question) -> &'static str {
        question.operation
    }

    fn ask(&self, candidate: &mut dyn Candidate, question: &Question) -> Judgement<Evidence> {
        let Question { operation, input, .. } = question;
        let reply = candidate.ask(operation, input);
        fault::judge(compare::whole(operation), question.truth(), reply, |truth, found| {
            compare::compare(operation, input, truth, found, self.most)
        })
    }

    fn answer(&self, question: &Question) {
        let own = question.truth();
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
        failure(faults, question.row, question.operation, question.input.clone(), None)
    }

    fn text(&self, question: &Question) -> Value {
        json!({"op": question.operation, "in": question.input})
    }

    fn parse(&self, text: &Object) -> Result<Question, InvalidField> {
        Question::parse(self.family, text)
    }
}

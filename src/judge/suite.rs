//! What a suite is: questions, each of a row of the report's table, and how answers to them are judged.

use super::accuracy::Measured;
use super::candidate::{Breakdown, Candidate};
use super::report::{Failure, PositionError};
use crate::answer::value::{InvalidField, Object};
use serde_json::Value;

/// What became of one question.
#[derive(Clone, Debug)]
pub enum Judgement<E> {
    /// The answer is right.
    Right {
        /// How far its positions are off, where there are any.
        error: PositionError,
        /// What the answer does not say, though the question asks for it.
        left_out: Vec<String>,
        /// The errors of its plain numbers, where they are measured.
        measured: Vec<Measured>,
    },
    /// It is wrong.
    Wrong {
        /// The weightiest fault's name.
        fault: &'static str,
        /// How far its positions are off, where there are any.
        error: PositionError,
        /// The errors of its plain numbers, where they are measured.
        measured: Vec<Measured>,
        /// What shows it.
        evidence: E,
    },
    /// The candidate declined.
    Unsupported(String),
    /// It broke.
    Broken(Breakdown),
}

impl<E> Judgement<E> {
    /// Right, with nothing more to say.
    pub fn right() -> Judgement<E> {
        Judgement::Right { error: PositionError::default(), left_out: Vec::new(), measured: Vec::new() }
    }
}

/// A suite of questions.
pub trait Suite {
    /// A question with all that is needed to judge its answer.
    type Question: Clone;
    /// What shows that an answer is wrong.
    type Evidence;

    /// Its name, as `--suite` has it.
    fn name(&self) -> &'static str;
    /// The operations that it asks; a candidate that lists its operations must list one of them.
    fn operations(&self) -> &'static [&'static str];
    /// The names of the table's rows: the cases, then the other groups.
    fn rows(&self) -> [Vec<String>; 2];
    /// The seed of its random questions.
    fn seed(&self) -> u64;
    /// The questions: the same seed, the same questions.
    fn questions(&self) -> Vec<Self::Question>;
    /// The row that a question belongs to.
    fn row(&self, question: &Self::Question) -> String;
    /// The operation that a question asks.
    fn operation(&self, question: &Self::Question) -> &'static str;
    /// Asks a question and judges the answer.
    fn ask(&self, candidate: &mut dyn Candidate, question: &Self::Question) -> Judgement<Self::Evidence>;
    /// Works out the oracle's own answer, to be timed.
    fn answer(&self, question: &Self::Question);
    /// How large a question is.
    fn size(&self, question: &Self::Question) -> impl Ord;
    /// Questions of the same row that are a little smaller, the most promising first.
    fn smaller(&self, question: &Self::Question) -> impl Iterator<Item = Self::Question>;
    /// The record of a wrong answer; the row, the fault and the end of the command are filled in by [`super::run`].
    fn failure(&self, question: &Self::Question, evidence: Option<Self::Evidence>) -> Failure;
    /// A question as `--question` takes it.
    fn text(&self, question: &Self::Question) -> Value;
    /// A question from what `--question` takes.
    ///
    /// # Errors
    /// The field that cannot be read.
    fn parse(&self, text: &Object) -> Result<Self::Question, InvalidField>;
}

//! Asking a candidate the whole suite, and gathering what it got wrong.

use super::candidate::{self, Breakdown, Candidate, Reply};
use super::fault::Fault;
use super::place::{CandidateMesh, Tolerance};
use super::report::{
    CandidateInfo, Failure, Outcome, PositionError, QuestionRecord, Report, Row as TableRow, Seconds, SurfaceRecord,
};
use super::shrink::shrink;
use super::suite::{Question, Row, questions};
use super::tie::judge_tied;
use super::verdict::{self, Verdict};
use crate::isosurface::cases::Case;
use crate::isosurface::cell::Tie;
use crate::isosurface::{fast, mesh};
use crate::number::binary::nearest_f64;
use crate::number::text::exact_text;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::time::Instant;

/// How to run the suite.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The seed of the random questions.
    pub seed: u64,
    /// How many questions of each group beside the single cells.
    pub cases: usize,
    /// How far vertices may be from the true crossings.
    pub tolerance: Tolerance,
}

/// What became of one question.
#[derive(Clone, Debug)]
pub enum Judgement {
    /// The answer is right.
    Right(PositionError),
    /// It is wrong.
    Wrong {
        /// What is wrong, the weightiest first.
        faults: Vec<Fault>,
        /// The answer, where it is a mesh.
        mesh: Option<CandidateMesh>,
        /// Its position errors.
        error: PositionError,
    },
    /// The candidate declined.
    Unsupported(String),
    /// It broke.
    Broken(Breakdown),
}

/// The question's `in`.
pub fn input(question: &Question) -> Value {
    let volume = &question.volume;
    let number = |x: &crate::number::Rational| match (x.is_integer(), x.numer().to_i64()) {
        (true, Some(n)) => json!(n),
        _ => json!(exact_text(x)),
    };
    let values: Vec<Value> = (0..volume.len()).map(|i| number(&volume.sample(i))).collect();
    let mut input =
        json!({"volume": {"shape": volume.shape(), "values": values}, "isovalue": number(&question.isovalue)});
    if question.row == Row::Ties {
        input["tie"] = json!("below");
    }
    input
}

/// Asks one question and judges the answer.
pub fn ask(candidate: &mut dyn Candidate, question: &Question, tolerance: Tolerance) -> Judgement {
    match candidate.ask("isosurface.mesh", &input(question)) {
        Reply::Broken(breakdown) => Judgement::Broken(breakdown),
        Reply::Unsupported(why) => Judgement::Unsupported(why),
        Reply::Error { kind, message } if kind == "limit" || (kind == "degenerate" && question.row == Row::Ties) => {
            Judgement::Unsupported(message)
        }
        Reply::Error { kind, message } => Judgement::Wrong {
            faults: vec![Fault::Refused { kind, message }],
            mesh: None,
            error: PositionError::default(),
        },
        Reply::Out(out) => match candidate::mesh(&out) {
            Err(field) => Judgement::Broken(Breakdown::Nonsense(field.to_string())),
            Ok(mesh) => {
                let Verdict { faults, error, .. } = judge(question, &mesh, tolerance);
                if faults.is_empty() {
                    Judgement::Right(error)
                } else {
                    Judgement::Wrong { faults, mesh: Some(mesh), error }
                }
            }
        },
    }
}

fn judge(question: &Question, mesh: &CandidateMesh, tolerance: Tolerance) -> Verdict {
    match question.row {
        Row::Ties => judge_tied(&question.volume, &question.isovalue, mesh, tolerance),
        Row::Cell(_) | Row::Pairs | Row::Grids | Row::NearDegenerate => {
            verdict::judge(&question.level(Tie::Degenerate), mesh, tolerance)
        }
    }
    .expect("questions outside the ties are not degenerate, and ties are broken")
}

/// What the candidate says of itself.
///
/// # Errors
/// It does not speak the protocol, or not of isosurfaces.
pub fn hello(candidate: &mut dyn Candidate) -> Result<CandidateInfo, Breakdown> {
    let command = candidate.command().to_vec();
    match candidate.ask("hello", &json!({"protocol": 1})) {
        Reply::Out(out) => {
            let text = |name: &str| out.get(name).and_then(Value::as_str).unwrap_or("?").to_owned();
            let ops = out.get("ops").and_then(Value::as_array);
            if ops.is_some_and(|ops| !ops.contains(&json!("isosurface.mesh"))) {
                return Err(Breakdown::Nonsense("its hello does not list the operation isosurface.mesh".into()));
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
#[derive(Default)]
struct Tally {
    asked: usize,
    passed: usize,
    wrong: usize,
    broken: usize,
    unsupported: usize,
    faults: BTreeMap<&'static str, usize>,
    smallest: BTreeMap<&'static str, Question>,
}

/// How large a question is: samples first, then the size of its values.
pub(super) fn size(question: &Question) -> (usize, crate::number::Rational) {
    let volume = &question.volume;
    let total = (0..volume.len()).fold(crate::number::Rational::new(), |sum, i| sum + volume.sample(i).abs());
    (volume.len(), total)
}

/// Runs the suite; `progress` is told after each question how many are done, of how many.
///
/// # Errors
/// The candidate does not even say hello.
pub fn run(
    candidate: &mut dyn Candidate,
    settings: &Settings,
    mut progress: impl FnMut(usize, usize),
) -> Result<Report, Breakdown> {
    let start = Instant::now();
    let info = hello(candidate)?;
    let mut seconds = Seconds::default();
    let mut position_error = PositionError::default();
    let mut tallies: BTreeMap<Row, Tally> = BTreeMap::new();
    let questions = questions(settings.seed, settings.cases);
    for (done, question) in questions.iter().enumerate() {
        let tally = tallies.entry(question.row).or_default();
        let asked = Instant::now();
        let judgement = ask(candidate, question, settings.tolerance);
        seconds.candidate += asked.elapsed().as_secs_f64();
        let answered = Instant::now();
        let own = mesh::extract(&question.level(Tie::Below));
        seconds.oracle += answered.elapsed().as_secs_f64();
        debug_assert!(own.is_ok());
        tally.asked += 1;
        match judgement {
            Judgement::Right(error) => {
                tally.passed += 1;
                widen(&mut position_error, error);
            }
            Judgement::Unsupported(_) => tally.unsupported += 1,
            Judgement::Broken(_) => {
                tally.broken += 1;
                tally.note("broken", question);
            }
            Judgement::Wrong { faults, error, .. } => {
                tally.wrong += 1;
                widen(&mut position_error, error);
                tally.note(faults[0].name(), question);
            }
        }
        progress(done + 1, questions.len());
    }
    let mut failures = Vec::new();
    for (row, tally) in &tallies {
        for (fault, question) in &tally.smallest {
            let question = shrink(candidate, question, fault, settings.tolerance);
            failures.extend(failure(candidate, *row, fault, &question, &info, settings.tolerance));
        }
    }
    let row = |row: Row| tallies.get(&row).map_or_else(|| Tally::default().row(row), |tally| tally.row(row));
    let cases: Vec<TableRow> = Case::ALL.iter().map(|case| row(Row::Cell(*case))).collect();
    let groups: Vec<TableRow> = Row::GROUPS.into_iter().map(row).collect();
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
        suite: "isosurface".into(),
        seed: settings.seed,
        verdict,
        cases,
        groups,
        failures,
        position_error,
        seconds,
    })
}

fn widen(known: &mut PositionError, more: PositionError) {
    known.binary64_ulp = known.binary64_ulp.max(more.binary64_ulp);
    known.binary32_ulp = known.binary32_ulp.max(more.binary32_ulp);
}

impl Tally {
    fn note(&mut self, fault: &'static str, question: &Question) {
        *self.faults.entry(fault).or_default() += 1;
        let known = self.smallest.entry(fault).or_insert_with(|| question.clone());
        if size(question) < size(known) {
            *known = question.clone();
        }
    }

    fn row(&self, row: Row) -> TableRow {
        TableRow {
            name: row.name().into(),
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
pub fn failure(
    candidate: &mut dyn Candidate,
    row: Row,
    fault: &str,
    question: &Question,
    info: &CandidateInfo,
    tolerance: Tolerance,
) -> Option<Failure> {
    let (messages, differences, formula, found, cell) = match ask(candidate, question, tolerance) {
        Judgement::Right(_) | Judgement::Unsupported(_) => return None,
        Judgement::Broken(breakdown) => (vec![breakdown.to_string()], Vec::new(), "", None, None),
        Judgement::Wrong { faults, mesh, .. } => {
            let mut messages: Vec<String> = faults.iter().map(Fault::to_string).collect();
            messages.truncate(8);
            let differences = faults.iter().filter_map(Fault::difference).take(4).cloned().collect();
            let cell = faults.iter().find_map(Fault::cell);
            (messages, differences, faults[0].formula(), mesh, cell)
        }
    };
    let level = question.level(Tie::Below);
    let case = match (row, cell) {
        (Row::Cell(case), _) => case.name().to_owned(),
        (_, Some((_, case))) => case.name().to_owned(),
        (_, None) => String::new(),
    };
    let expected = fast::extract(&level).ok().map(|mesh| SurfaceRecord {
        vertices: mesh.vertices.iter().map(|v| level.position(v).map(|x| nearest_f64(&x))).collect(),
        faces: mesh.triangles,
    });
    let volume = &question.volume;
    let command: Vec<String> = info.command.iter().map(|word| quoted(word)).collect();
    Some(Failure {
        row: row.name().into(),
        case,
        fault: fault.into(),
        formula: formula.into(),
        messages,
        question: QuestionRecord {
            op: "isosurface.mesh".into(),
            shape: volume.shape(),
            values: (0..volume.len()).map(|i| exact_text(&volume.sample(i))).collect(),
            isovalue: exact_text(&question.isovalue),
        },
        differences,
        expected,
        found: found.map(|mesh| SurfaceRecord {
            vertices: (0..mesh.positions.len()).map(|v| mesh.positions.rounded(v)).collect(),
            faces: mesh.triangles,
        }),
        command: format!("isoracle judge --question '{}' -- {}", input(question), command.join(" ")),
    })
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

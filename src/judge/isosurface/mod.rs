//! The suite `isosurface`: meshes of small volumes, cell by cell and as wholes.

pub mod builtin;
pub mod candidate_mesh;
pub mod fault;
pub mod place;
pub mod questions;
mod smaller;
pub mod tie;
pub mod verdict;

use super::candidate::{Breakdown, Candidate, Reply};
use super::report::{Failure, PositionError, QuestionRecord, SurfaceRecord, VolumeQuestion};
use super::suite::{Judgement, Suite};
use crate::answer::value::{self, InvalidField, Object};
use crate::answer::volume;
use crate::isosurface::cases::Case;
use crate::isosurface::cell::Tie;
use crate::isosurface::{fast, mesh};
use crate::number::Rational;
use crate::number::binary::nearest_f64;
use crate::number::text::exact_text;
use candidate_mesh::CandidateMesh;
use fault::Fault;
use place::Tolerance;
use questions::{Question, Row, questions};
use serde_json::{Value, json};
use tie::judge_tied;
use verdict::Verdict;

/// The suite, with how to run it.
#[derive(Clone, Copy, Debug)]
pub struct Isosurface {
    /// The seed of the random questions.
    pub seed: u64,
    /// How many questions of each group beside the single cells.
    pub cases: usize,
    /// How far vertices may be from the true crossings.
    pub tolerance: Tolerance,
}

/// What shows that an answer is wrong.
#[derive(Clone, Debug)]
pub struct Evidence {
    /// What is wrong, the weightiest first.
    pub faults: Vec<Fault>,
    /// The answer, where it is a mesh.
    pub mesh: Option<CandidateMesh>,
}

fn wrong(faults: Vec<Fault>, mesh: Option<CandidateMesh>, error: PositionError) -> Judgement<Evidence> {
    let fault = faults[0].name();
    Judgement::Wrong { fault, error, measured: Vec::new(), evidence: Evidence { faults, mesh } }
}

impl Suite for Isosurface {
    type Question = Question;
    type Evidence = Evidence;

    fn name(&self) -> &'static str {
        "isosurface"
    }

    fn operations(&self) -> &'static [&'static str] {
        &["isosurface.mesh"]
    }

    fn rows(&self) -> [Vec<String>; 2] {
        let cases = Case::ALL.iter().map(|case| case.name().to_owned()).collect();
        [cases, Row::GROUPS.iter().map(|row| row.name().to_owned()).collect()]
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

    fn operation(&self, _: &Question) -> &'static str {
        "isosurface.mesh"
    }

    fn ask(&self, candidate: &mut dyn Candidate, question: &Question) -> Judgement<Evidence> {
        let is_tie = question.row == Row::Ties;
        match candidate.ask("isosurface.mesh", &input(question)) {
            Reply::Broken(breakdown) => Judgement::Broken(breakdown),
            Reply::Unsupported(why) => Judgement::Unsupported(why),
            Reply::Error { kind, message } if kind == "limit" || (kind == "degenerate" && is_tie) => {
                Judgement::Unsupported(message)
            }
            Reply::Error { kind, message } => {
                wrong(vec![Fault::Refused { kind, message }], None, PositionError::default())
            }
            Reply::Out(out) => match candidate_mesh::mesh(&out) {
                Err(field) => Judgement::Broken(Breakdown::Nonsense(field.to_string())),
                Ok(mesh) => {
                    let Verdict { faults, error, .. } = judge(question, &mesh, self.tolerance);
                    if faults.is_empty() {
                        Judgement::Right { error, left_out: Vec::new(), measured: Vec::new() }
                    } else {
                        wrong(faults, Some(mesh), error)
                    }
                }
            },
        }
    }

    fn answer(&self, question: &Question) {
        let own = mesh::extract(&question.level(Tie::Below));
        debug_assert!(own.is_ok());
    }

    /// Samples first, then the size of their values.
    fn size(&self, question: &Question) -> impl Ord {
        smaller::size(question)
    }

    fn smaller(&self, question: &Question) -> impl Iterator<Item = Question> {
        smaller::smaller(question)
    }

    fn failure(&self, question: &Question, evidence: Option<Evidence>) -> Failure {
        let (faults, found) = evidence.map_or((Vec::new(), None), |evidence| (evidence.faults, evidence.mesh));
        let case = match (question.row, faults.iter().find_map(Fault::cell)) {
            (Row::Cell(case), _) | (_, Some((_, case))) => case.name().to_owned(),
            (_, None) => String::new(),
        };
        let level = question.level(Tie::Below);
        let expected = fast::extract(&level).ok().map(|mesh| SurfaceRecord {
            vertices: mesh.vertices.iter().map(|v| level.position(v).map(|x| nearest_f64(&x))).collect(),
            faces: mesh.triangles,
        });
        let volume = &question.volume;
        Failure {
            row: String::new(),
            case,
            fault: String::new(),
            formula: faults.first().map_or("", Fault::formula).to_owned(),
            messages: faults.iter().take(8).map(Fault::to_string).collect(),
            question: QuestionRecord::Volume(VolumeQuestion {
                op: "isosurface.mesh".into(),
                shape: volume.shape(),
                values: (0..volume.len()).map(|i| exact_text(&volume.sample(i))).collect(),
                isovalue: exact_text(&question.isovalue),
            }),
            differences: faults.iter().filter_map(Fault::difference).take(4).cloned().collect(),
            expected,
            found: found.map(|mesh| SurfaceRecord {
                vertices: (0..mesh.positions.len()).map(|v| mesh.positions.rounded(v)).collect(),
                faces: mesh.triangles,
            }),
            command: String::new(),
        }
    }

    /// Its `in`.
    fn text(&self, question: &Question) -> Value {
        input(question)
    }

    fn parse(&self, text: &Object) -> Result<Question, InvalidField> {
        let volume = value::field(text, "volume", volume::read)?;
        let isovalue = value::field(text, "isovalue", value::number)?;
        let mut question = Question { row: Row::Ties, volume, isovalue };
        if !question.is_tied() {
            question.row = Row::Grids;
        }
        Ok(question)
    }
}

/// The question's `in`.
fn input(question: &Question) -> Value {
    let volume = &question.volume;
    let number = |x: &Rational| match (x.is_integer(), x.numer().to_i64()) {
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

fn judge(question: &Question, mesh: &CandidateMesh, tolerance: Tolerance) -> Verdict {
    match question.row {
        Row::Ties => judge_tied(&question.volume, &question.isovalue, mesh, tolerance),
        Row::Cell(_) | Row::Pairs | Row::Grids | Row::NearDegenerate => {
            verdict::judge(&question.level(Tie::Degenerate), mesh, tolerance)
        }
    }
    .expect("questions outside the ties are not degenerate, and ties are broken")
}

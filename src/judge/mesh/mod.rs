//! The suite `mesh`: sound and broken polygon meshes, planes of polygons, angle deficits of triangle meshes.

mod bases;
mod compare;
mod plant;
pub mod questions;
mod smaller;

use super::candidate::Candidate;
use super::fault::{self, Evidence, failure};
use super::isosurface::place::Tolerance;
use super::report::{Failure, SurfaceRecord};
use super::suite::{Judgement, Suite};
use crate::answer::value::{InvalidField, Object};
use crate::number::binary::nearest_f64;
use questions::{Question, Row, questions};
use serde_json::{Value, json};

/// The suite, with how to run it.
#[derive(Clone, Copy, Debug)]
pub struct Mesh {
    /// The seed of the random questions.
    pub seed: u64,
    /// How many questions of each row.
    pub cases: usize,
    /// How far an answered real number that is no exact one may be from the true one.
    pub tolerance: Tolerance,
}

/// The oracle's answer, or the kind of error that the question is.
fn truth(question: &Question) -> Result<Value, &'static str> {
    fault::truth(question.row.operation(), &question.input())
}

/// Whether the truth has a defect of that category.
fn has_defect(question: &Question, category: &str) -> bool {
    truth(question).is_ok_and(|truth| truth["defects"].get(category).is_some())
}

impl Suite for Mesh {
    type Question = Question;
    type Evidence = Evidence;

    fn name(&self) -> &'static str {
        "mesh"
    }

    fn operations(&self) -> &'static [&'static str] {
        &["mesh.check", "mesh.plane", "mesh.angle_deficits"]
    }

    fn rows(&self) -> [Vec<String>; 2] {
        let cases = Row::CASES.map(|row| row.name().to_owned());
        [cases.to_vec(), Row::GROUPS.map(|row| row.name().to_owned()).to_vec()]
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
        question.row.operation()
    }

    fn ask(&self, candidate: &mut dyn Candidate, question: &Question) -> Judgement<Evidence> {
        let operation = question.row.operation();
        let reply = candidate.ask(operation, &question.input());
        fault::judge(compare::whole(operation), truth(question), reply, |truth, found| {
            compare::compare(operation, truth, found, self.tolerance)
        })
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
        failure(faults, question.row.name(), question.row.operation(), question.input(), Some(picture(question)))
    }

    fn text(&self, question: &Question) -> Value {
        json!({"op": question.row.operation(), "in": question.input()})
    }

    fn parse(&self, text: &Object) -> Result<Question, InvalidField> {
        Question::parse(text)
    }
}

/// The mesh of the question, each loop as a fan from its first vertex.
fn picture(question: &Question) -> SurfaceRecord {
    let count = question.mesh.vertices.len() as u32;
    let loops = question.mesh.faces.iter().flat_map(|face| face.loops());
    let fans = loops.flat_map(|l| (1..l.len().saturating_sub(1)).map(|i| [l[0], l[i], l[i + 1]]));
    SurfaceRecord {
        vertices: question.mesh.vertices.iter().map(|v| v.0.each_ref().map(nearest_f64)).collect(),
        faces: fans.filter(|[a, b, c]| a != b && b != c && c != a && a.max(b).max(c) < &count).collect(),
    }
}

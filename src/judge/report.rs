//! What a run of the judge found: the record behind every form of report.

use super::accuracy::Accuracy;
use serde::Serialize;

/// A whole run.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The version of this record's layout.
    pub report: u32,
    /// What the candidate said of itself, and how it was started.
    pub candidate: CandidateInfo,
    /// The suite: "isosurface", "mesh", "complex", "spline" or "curvature".
    pub suite: String,
    /// The seed of the random questions; the same seed asks the same questions.
    pub seed: u64,
    /// The verdict in one word.
    pub verdict: Outcome,
    /// The suite's cases: of isosurfaces the 33 of single cells, in Chernyaev's order; of meshes and
    /// gluing schemes the kinds of defects; of splines and curvatures the kinds of questions.
    pub cases: Vec<Row>,
    /// The other groups: of isosurfaces pairs, grids, near-degenerate, ties.
    pub groups: Vec<Row>,
    /// For each way of failing in each row, the smallest question found.
    pub failures: Vec<Failure>,
    /// What right answers left unsaid.
    pub left_out: Vec<String>,
    /// The largest position error on a grid edge, in units in the last place of binary64 and of binary32.
    pub position_error: PositionError,
    /// Of each operation whose plain numbers were measured, how far these are off; absent where none were.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub accuracy: Vec<Accuracy>,
    /// Seconds that the candidate took for its answers, and the oracle for its own.
    pub seconds: Seconds,
}

/// How the run ended for the candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// Every answer is right.
    Passed,
    /// At least one answer is wrong.
    Wrong,
    /// At least once it crashed, hung or spoke nonsense.
    Broken,
}

/// A candidate, as it presents itself.
#[derive(Clone, Debug, Serialize)]
pub struct CandidateInfo {
    /// From its hello.
    pub name: String,
    /// From its hello.
    pub version: String,
    /// The command that starts it.
    pub command: Vec<String>,
}

/// One line of the table.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// A case's name ("6.1.2") or a group's ("pairs").
    pub name: String,
    /// How many questions were asked.
    pub asked: usize,
    /// How many were answered rightly.
    pub passed: usize,
    /// How many were answered wrongly.
    pub wrong: usize,
    /// How many ended in a crash, a hang or nonsense.
    pub broken: usize,
    /// How many the candidate declined.
    pub unsupported: usize,
    /// The faults found, by name, with how many questions show each.
    pub faults: Vec<(String, usize)>,
}

/// The smallest question that shows one way of failing.
#[derive(Clone, Debug, Serialize)]
pub struct Failure {
    /// The row that it belongs to.
    pub row: String,
    /// The case of the first wrong cell.
    pub case: String,
    /// The fault's name, such as "wrong-components".
    pub fault: String,
    /// The spec entry of the truth that is broken.
    pub formula: String,
    /// One sentence for each fault of this answer.
    pub messages: Vec<String>,
    /// The question.
    pub question: QuestionRecord,
    /// The invariants that differ: (what, expected, found).
    pub differences: Vec<Difference>,
    /// The true surface.
    pub expected: Option<SurfaceRecord>,
    /// The candidate's, where it answered with a mesh.
    pub found: Option<SurfaceRecord>,
    /// A command that shows it again.
    pub command: String,
}

/// A question, as it was asked.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum QuestionRecord {
    /// About a level of a volume.
    Volume(VolumeQuestion),
    /// About anything else.
    Other {
        /// The operation: "mesh.check".
        op: String,
        /// Its `in`.
        #[serde(rename = "in")]
        input: serde_json::Value,
    },
}

/// A question about a level of a volume.
#[derive(Clone, Debug, Serialize)]
pub struct VolumeQuestion {
    /// The operation: "isosurface.mesh".
    pub op: String,
    /// The volume's shape.
    pub shape: [usize; 3],
    /// Its values, x fastest, exactly.
    pub values: Vec<String>,
    /// The isovalue, exactly.
    pub isovalue: String,
}

/// An exact invariant that differs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// What it is: "loops of cell [0, 0, 0]", "χ", "components", …
    pub invariant: String,
    /// The truth.
    pub expected: String,
    /// The candidate's.
    pub found: String,
}

/// A triangle mesh for pictures.
#[derive(Clone, Debug, Serialize)]
pub struct SurfaceRecord {
    /// Positions in grid coordinates, rounded.
    pub vertices: Vec<[f64; 3]>,
    /// Triangles.
    pub faces: Vec<[u32; 3]>,
}

/// The largest position error on a grid edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PositionError {
    /// In units in the last place of binary64.
    pub binary64_ulp: f64,
    /// In units in the last place of binary32.
    pub binary32_ulp: f64,
}

/// Where the time went.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Seconds {
    /// Waiting for the candidate.
    pub candidate: f64,
    /// The oracle's plain answers to the same questions.
    pub oracle: f64,
    /// The whole run.
    pub total: f64,
}

/// The record as JSON, indented: every other form of report can be made from it.
pub fn json(report: &Report) -> String {
    serde_json::to_string_pretty(report).expect("a report has text keys and no number that JSON lacks a form for")
}

impl Outcome {
    /// The verdict in one word.
    pub const fn word(self) -> &'static str {
        match self {
            Outcome::Passed => "passed",
            Outcome::Wrong => "wrong",
            Outcome::Broken => "broken",
        }
    }
}

impl Row {
    /// The share of the questions answered rightly, in percent, rounded down to a tenth: "100" only where
    /// all are; "–" where none was asked.
    pub fn pass_rate(&self) -> String {
        percent(self.passed, self.asked)
    }
}

impl Report {
    /// Every line of the table: the cases, then the groups.
    pub fn rows(&self) -> impl Iterator<Item = &Row> {
        self.cases.iter().chain(&self.groups)
    }

    /// The sum of all rows.
    pub fn total(&self) -> Row {
        let sum = |count: fn(&Row) -> usize| self.rows().map(count).sum();
        let mut faults: Vec<(String, usize)> = Vec::new();
        for (name, count) in self.rows().flat_map(|row| &row.faults) {
            match faults.iter_mut().find(|(known, _)| known == name) {
                Some((_, total)) => *total += count,
                None => faults.push((name.clone(), *count)),
            }
        }
        Row {
            name: "all".to_owned(),
            asked: sum(|row| row.asked),
            passed: sum(|row| row.passed),
            wrong: sum(|row| row.wrong),
            broken: sum(|row| row.broken),
            unsupported: sum(|row| row.unsupported),
            faults,
        }
    }

    /// The verdict in one sentence.
    pub fn verdict_sentence(&self) -> String {
        let Row { asked, passed, wrong, broken, unsupported, .. } = self.total();
        let of = format!("of {} questions", grouped(asked));
        let declined = match unsupported {
            0 => String::new(),
            n => format!(" It declined {}.", grouped(n)),
        };
        let answers = |n: usize| {
            if n == 1 { "1 answer is wrong".to_owned() } else { format!("{} answers are wrong", grouped(n)) }
        };
        match self.verdict {
            Outcome::Passed => format!("Every answer is right: {} {of}.{declined}", grouped(passed)),
            Outcome::Wrong => format!("{}, {of}.{declined}", answers(wrong)),
            Outcome::Broken => {
                let others = if wrong == 0 { String::new() } else { format!(", and {}", answers(wrong)) };
                format!("It crashed, hung or spoke nonsense on {} {of}{others}.{declined}", grouped(broken))
            }
        }
    }
}

impl QuestionRecord {
    /// The question about a volume, if it is one.
    pub fn volume(&self) -> Option<&VolumeQuestion> {
        match self {
            QuestionRecord::Volume(question) => Some(question),
            QuestionRecord::Other { .. } => None,
        }
    }

    /// The question in the protocol's form, as one line: `{"op":…,"in":…}`.
    pub fn json(&self) -> String {
        match self {
            QuestionRecord::Volume(VolumeQuestion { op, shape, values, isovalue }) => {
                let volume = serde_json::json!({"shape": shape, "values": values});
                serde_json::json!({"op": op, "in": {"volume": volume, "isovalue": isovalue}}).to_string()
            }
            QuestionRecord::Other { op, input } => serde_json::json!({"op": op, "in": input}).to_string(),
        }
    }
}

impl PositionError {
    /// The larger of two errors, in either unit.
    pub fn widen(&mut self, more: PositionError) {
        self.binary64_ulp = self.binary64_ulp.max(more.binary64_ulp);
        self.binary32_ulp = self.binary32_ulp.max(more.binary32_ulp);
    }
}

/// A share in percent, rounded down to a tenth: "100" only of all, "–" of none.
pub fn percent(part: usize, whole: usize) -> String {
    match (part * 1000).checked_div(whole) {
        None => "–".to_owned(),
        Some(1000) => "100".to_owned(),
        Some(tenths) => format!("{}.{}", tenths / 10, tenths % 10),
    }
}

/// A count with its thousands set apart: "12,345".
pub fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

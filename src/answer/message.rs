//! The frames of the protocol: a question in, an answer or a refusal out, one line each.

use super::value::{InvalidField, Object};
use crate::complex::scheme::SchemeDefect;
use crate::curvature::implicit_curve::SingularPoint;
use crate::curvature::parametric_curve::CurveError;
use crate::curvature::parametric_surface::SurfaceError;
use crate::isosurface::cell::Degenerate;
use crate::isosurface::polyline::DegenerateGridSquare;
use crate::isosurface::square::DegenerateSquare;
use crate::isosurface::tetrahedra::DegenerateSample;
use crate::isosurface::triangle::DegeneratePoint;
use crate::isosurface::volume::DegenerateCell;
use crate::mesh::angle_deficit::AngleError;
use crate::mesh::plane::NoPlane;
use crate::number::Rational;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::borrow::Cow;
use std::str::Utf8Error;
use thiserror::Error;

/// The version of the protocol.
pub const PROTOCOL: u32 = 1;

/// A question: `{"id":…,"op":"…","in":{…}}`; further fields are ignored.
///
/// A missing `id` is null, a missing `in` is `{}`. `id`, `op` and `in` may stand once; of other fields that
/// stand twice in one object the last one counts.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Question {
    /// Any JSON value; the answer carries it again.
    #[serde(default)]
    pub id: Value,
    /// The name of the operation.
    pub op: String,
    /// What it is asked about; [`Question::input`] wants an object.
    #[serde(default = "nothing", rename = "in")]
    given: Value,
}

fn nothing() -> Value {
    Value::Object(Object::new())
}

/// Why there is no answer. Its text is the message of the answering line.
#[derive(Debug, Error)]
pub enum Refusal {
    /// The line is not UTF-8.
    #[error("not UTF-8: {0}")]
    NotUtf8(#[from] Utf8Error),
    /// The line is not JSON, or an object without `op`.
    #[error("not a message: {0}")]
    NotAMessage(#[from] serde_json::Error),
    /// The line is JSON, perhaps, but no object.
    #[error("not a message: expected an object with `id`, `op` and `in`")]
    NotAnObject,
    /// The line is longer than the limit.
    #[error("a line may have at most {0} bytes")]
    LineTooLong(usize),
    /// No operation has this name.
    #[error("no operation {0:?}; `hello` lists them")]
    NoSuchOperation(String),
    /// Another version of the protocol.
    #[error("no protocol {0}, this is protocol {PROTOCOL}")]
    NoSuchProtocol(Rational),
    /// A field of the question cannot be read.
    #[error(transparent)]
    InvalidField(#[from] InvalidField),
    /// The isovalue is a critical value of the cell.
    #[error("{0}")]
    Degenerate(Box<Degenerate>),
    /// The isovalue is a critical value of a cell of the volume.
    #[error("{0}")]
    DegenerateCell(Box<DegenerateCell>),
    /// The isovalue is a critical value of the square.
    #[error("{0}")]
    DegenerateSquare(Box<DegenerateSquare>),
    /// The isovalue is a critical value of a square of the raster.
    #[error("{0}")]
    DegenerateGridSquare(Box<DegenerateGridSquare>),
    /// A sample of the raster equals the isovalue.
    #[error("{0}")]
    DegeneratePoint(#[from] DegeneratePoint),
    /// A sample of the volume equals the isovalue.
    #[error("{0}")]
    DegenerateSample(#[from] DegenerateSample),
    /// The polygon has no plane.
    #[error("polygon: {0}")]
    NoPlane(#[from] NoPlane),
    /// A triangle of the mesh has no angles.
    #[error("{0}")]
    DegenerateTriangle(AngleError),
    /// Polyhedra or pairings have a defect by themselves.
    #[error("{0}")]
    InvalidScheme(Box<SchemeDefect>),
    /// What a scheme glues is no manifold.
    #[error("{0}")]
    NoManifold(Box<SchemeDefect>),
    /// A refinement with more tetrahedra than the limit.
    #[error("order: a refinement may have at most {limit} tetrahedra; of order k it has {pairs}·k³")]
    TooManyTetrahedra {
        /// How many face-edge pairs there are.
        pairs: u64,
        /// The limit.
        limit: u64,
    },
    /// A point where the gradient is zero.
    #[error("{field}{}: {error}", .index.map_or(String::new(), |i| format!("[{i}]")))]
    SingularPoint {
        /// The field that gives the point.
        field: &'static str,
        /// Which of its items.
        index: Option<usize>,
        /// That it is singular.
        error: SingularPoint,
    },
    /// A parameter where a curve has no curvature.
    #[error("t: {0}")]
    CurveError(#[from] CurveError),
    /// A parameter where a surface has no curvature.
    #[error("point: {0}")]
    SurfaceError(#[from] SurfaceError),
    /// An operation panicked: our fault.
    #[error("a bug in the oracle: {0}")]
    Panic(String),
}

macro_rules! boxed {
    ($($error:ident)*) => {
        $(impl From<$error> for Refusal {
            fn from(error: $error) -> Refusal {
                Refusal::$error(Box::new(error))
            }
        })*
    };
}

boxed!(Degenerate DegenerateCell DegenerateSquare DegenerateGridSquare);

/// The kinds of errors that the protocol knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Not JSON, or not a message.
    Malformed,
    /// The question is ill-posed.
    InvalidInput,
    /// Well-posed, but outside the domain of the operation.
    Degenerate,
    /// Beyond a stated limit.
    Limit,
    /// A bug in the oracle.
    Internal,
}

impl Kind {
    /// As it stands in a message.
    pub const fn name(self) -> &'static str {
        match self {
            Kind::Malformed => "malformed",
            Kind::InvalidInput => "invalid-input",
            Kind::Degenerate => "degenerate",
            Kind::Limit => "limit",
            Kind::Internal => "internal",
        }
    }
}

impl Refusal {
    /// The kind of the error, or `None` where the question is not supported, which is no error.
    pub fn kind(&self) -> Option<Kind> {
        match self {
            Refusal::NotUtf8(_) | Refusal::NotAMessage(_) | Refusal::NotAnObject => Some(Kind::Malformed),
            Refusal::LineTooLong(_) | Refusal::TooManyTetrahedra { .. } => Some(Kind::Limit),
            Refusal::NoSuchOperation(_) | Refusal::NoSuchProtocol(_) => None,
            Refusal::InvalidField(error) if error.is_limit() => Some(Kind::Limit),
            Refusal::InvalidField(_) | Refusal::InvalidScheme(_) => Some(Kind::InvalidInput),
            Refusal::Degenerate(_)
            | Refusal::DegenerateCell(_)
            | Refusal::DegenerateSquare(_)
            | Refusal::DegenerateGridSquare(_)
            | Refusal::DegeneratePoint(_)
            | Refusal::DegenerateSample(_)
            | Refusal::NoPlane(_)
            | Refusal::DegenerateTriangle(_)
            | Refusal::NoManifold(_)
            | Refusal::SingularPoint { .. }
            | Refusal::CurveError(_)
            | Refusal::SurfaceError(_) => Some(Kind::Degenerate),
            Refusal::Panic(_) => Some(Kind::Internal),
        }
    }

    /// The line that says so, without its newline.
    pub fn line(&self, id: &Value) -> String {
        let message = self.to_string();
        match self.kind() {
            None => json!({"id": id, "unsupported": message}),
            Some(kind) => json!({"id": id, "error": {"kind": kind, "message": message}}),
        }
        .to_string()
    }
}

/// What an operation answers, as JSON text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Out(String);

impl Out {
    /// The JSON text of an answer.
    pub fn new(answer: &impl Serialize) -> Out {
        Out(serde_json::to_string(answer).expect("answers are plain objects, lists and strings"))
    }

    /// The line that says so, without its newline.
    pub fn line(&self, id: &Value) -> String {
        format!("{{\"id\":{id},\"out\":{}}}", self.0)
    }

    /// The answer as a candidate's would be read.
    pub fn value(&self) -> Value {
        serde_json::from_str(&self.0).expect("an answer is JSON")
    }
}

impl Question {
    /// Reads a line.
    ///
    /// Python writes NaN and infinities as bare words, which are not JSON. Such a line is read as if the words
    /// stood in quotes: where a number is wanted, they are then refused as what they are, and the answer
    /// carries the question's id.
    ///
    /// # Errors
    /// `NotUtf8`, `NotAnObject`, `NotAMessage`.
    pub fn parse(line: &[u8]) -> Result<Question, Refusal> {
        let text = str::from_utf8(line)?;
        // A sequence of three would pass for a struct.
        if !text.trim_start().starts_with('{') {
            return Err(Refusal::NotAnObject);
        }
        serde_json::from_str(text).or_else(|error| match quote_non_numbers(text) {
            Cow::Owned(quoted) => serde_json::from_str(&quoted).map_err(|_| error.into()),
            Cow::Borrowed(_) => Err(error.into()),
        })
    }

    /// What the operation is asked about.
    ///
    /// # Errors
    /// iff `in` is not an object.
    pub fn input(&self) -> Result<&Object, InvalidField> {
        super::value::object(&self.given).map_err(|error| error.within(super::value::Step::Field("in")))
    }
}

/// The words that Python writes for numbers that JSON does not have.
const NON_NUMBERS: [&str; 3] = ["-Infinity", "Infinity", "NaN"];

/// The line with those words in quotes, where they stand outside of strings.
fn quote_non_numbers(line: &str) -> Cow<'_, str> {
    let mut quoted = String::new();
    let (mut copied, mut at, mut in_string) = (0, 0, false);
    let bytes = line.as_bytes();
    while at < bytes.len() {
        match bytes[at] {
            b'"' => in_string = !in_string,
            b'\\' if in_string => at += 1,
            b'-' | b'I' | b'N' if !in_string => {
                if let Some(word) = NON_NUMBERS.iter().find(|word| line[at..].starts_with(**word)) {
                    quoted.push_str(&line[copied..at]);
                    quoted.extend(["\"", word, "\""]);
                    at += word.len();
                    copied = at;
                    continue;
                }
            }
            _ => {}
        }
        at += 1;
    }
    if copied == 0 {
        return Cow::Borrowed(line);
    }
    quoted.push_str(&line[copied..]);
    Cow::Owned(quoted)
}

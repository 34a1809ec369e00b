//! JSON ↔ exact numbers: the fields of a question, each read with the place where it goes wrong.

use crate::curvature::normalize::SlopeError;
use crate::format::FormatError;
use crate::isosurface::polyline::RasterError;
use crate::isosurface::volume::VolumeError;
use crate::mesh::angle_deficit::AngleError;
use crate::number::Rational;
use crate::number::decimal::{DecimalEnclosure, Digits};
use crate::number::text::{self, NumberError};
use crate::spline::signal::SignalError;
use serde::{Serialize, Serializer};
use serde_json::{Map, Value};
use std::fmt::{self, Display, Formatter};
use thiserror::Error;

/// A JSON object.
pub type Object = Map<String, Value>;

/// The most samples that a volume of a question, in line or in a file, may have.
pub const MAX_SAMPLES: usize = 1 << 28;

/// One step into a question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// Into the field of this name.
    Field(&'static str),
    /// Into the item of this index.
    Item(usize),
    /// Into the field that is named by this number.
    Key(usize),
    /// Into the field of this name, which the question has chosen.
    Name(String),
}

/// A field of a question that cannot be read: where it is, such as `volume.shape[1]`, and what is wrong.
#[derive(Debug)]
pub struct InvalidField {
    /// The way to it, its last step first.
    steps: Vec<Step>,
    problem: Problem,
}

/// What is wrong with a field.
#[derive(Debug, Error)]
pub enum Problem {
    /// The field is not there.
    #[error("missing")]
    Missing,
    /// It is of another type.
    #[error("expected {expected}, found {found}")]
    Type {
        /// What it should be.
        expected: &'static str,
        /// What it is.
        found: &'static str,
    },
    /// It is a list of another length.
    #[error("expected {expected} items, found {found}")]
    Length {
        /// How many items there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// It is none of the words that it could be.
    #[error("expected {expected}, found {found:?}")]
    Word {
        /// The words.
        expected: &'static str,
        /// The word, or its first 40 characters.
        found: String,
    },
    /// It is no exact number, or one too large.
    #[error("{0}")]
    Number(#[from] NumberError),
    /// It is not a number of samples.
    #[error("expected an integer, at least 2: a grid needs 2 samples along each axis, found {0}")]
    Side(Rational),
    /// The shape asks for too many samples.
    #[error("more than the limit of 2²⁸ samples")]
    TooManySamples,
    /// It is no integer.
    #[error("expected an integer, found {0}")]
    Integer(Rational),
    /// Holes of a face that does not exist.
    #[error("there is no such face; there are {faces}")]
    NoSuchFace {
        /// How many faces there are.
        faces: usize,
    },
    /// A vertex in a file has a coordinate that is no number.
    #[error("vertex {vertex} has a coordinate that is NaN or infinite")]
    NotFinite {
        /// The vertex.
        vertex: usize,
    },
    /// It is no polygon.
    #[error("a polygon has at least 3 vertices, found {found}")]
    FewVertices {
        /// How many there are.
        found: usize,
    },
    /// A volume or a mesh that is given in line and by a file.
    #[error("stands beside `file`; one of the two gives the data")]
    BesideFile,
    /// Shape and values do not make a volume; its message names the field.
    #[error("{0}")]
    Volume(VolumeError),
    /// Shape and values do not make a raster; its message names the field.
    #[error("{0}")]
    Raster(RasterError),
    /// It is not the number of a vertex.
    #[error("expected the number of a vertex, an integer from 0 on, found {0}")]
    VertexNumber(Rational),
    /// It is no index.
    #[error("expected an index, an integer from 0 on, found {0}")]
    Index(Rational),
    /// A triangle is not one of the mesh.
    #[error("{0}")]
    Triangle(AngleError),
    /// It is no integer, or one too large to be counted.
    #[error("expected an integer of at most {bits} bits, found {found}")]
    Bits {
        /// How many bits it may have, with its sign.
        bits: u32,
        /// What it is.
        found: Rational,
    },
    /// It is not a number of digits.
    #[error("expected a number of digits, an integer from 0 on, found {0}")]
    Digits(Rational),
    /// It is no order of refinement.
    #[error("expected an order, an integer from 1 on, found {0}")]
    Order(Rational),
    /// It is no exponent.
    #[error("expected an exponent, an integer from 0 on, found {0}")]
    Exponent(Rational),
    /// An exponent beyond the limit.
    #[error("an exponent may be at most {limit}, found {found}")]
    LargeExponent {
        /// What it is.
        found: Rational,
        /// The limit.
        limit: u32,
    },
    /// It is no slope of n_λ.
    #[error("{0}")]
    Slope(SlopeError),
    /// Shape and values do not make a signal; its message names the field.
    #[error("{0}")]
    Signal(SignalError),
    /// A signal with more samples than are worked out exactly.
    #[error("at most {limit} samples are interpolated exactly")]
    LongSignal {
        /// The limit.
        limit: usize,
    },
    /// A signal of no axis, or of more than three.
    #[error("expected 1 to 3 axes, found {found}")]
    Axes {
        /// How many there are.
        found: usize,
    },
    /// A signal whose level sets are points.
    #[error("a signal of one axis has no curvature; expected 2 or 3 axes")]
    NoCurvature,
    /// It names no derivative.
    #[error("expected a word of the first {axes} of the letters x, y, z, each at most twice, found {found:?}")]
    Derivative {
        /// The word, or its first 40 characters.
        found: String,
        /// How many axes there are.
        axes: usize,
    },
    /// Two samples at one place.
    #[error("there is a sample at this place already")]
    SampleTwice,
    /// A range that ends before it begins.
    #[error("before k_from")]
    EmptyRange,
    /// Places that are far apart.
    #[error("more than the limit of {limit} away from a sample or from 0")]
    Far {
        /// The limit.
        limit: u32,
    },
    /// What is in the file does not make a volume.
    #[error("{0}")]
    VolumeFile(VolumeError),
    /// The file cannot be read.
    #[error("{0}")]
    File(Box<FormatError>),
}

impl InvalidField {
    /// A problem with the value at hand; [`InvalidField::within`] says later where that is.
    pub fn here(problem: impl Into<Problem>) -> InvalidField {
        InvalidField { steps: Vec::new(), problem: problem.into() }
    }

    /// The same problem, seen from one level further out.
    pub fn within(mut self, step: Step) -> InvalidField {
        self.steps.push(step);
        self
    }

    /// What is wrong.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Whether a stated limit is what stands against it, not an ill-posed question.
    pub fn is_limit(&self) -> bool {
        match &self.problem {
            Problem::TooManySamples
            | Problem::LargeExponent { .. }
            | Problem::LongSignal { .. }
            | Problem::Far { .. }
            | Problem::Volume(VolumeError::TooLarge(_))
            | Problem::VolumeFile(VolumeError::TooLarge(_))
            | Problem::Raster(RasterError::TooLarge(_)) => true,
            Problem::Number(error) => {
                matches!(
                    error,
                    NumberError::TooLong { .. } | NumberError::ExponentTooLarge | NumberError::TooManyDigits { .. }
                )
            }
            Problem::File(error) => matches!(error.problem, crate::format::Problem::TooLarge { .. }),
            Problem::Missing
            | Problem::Type { .. }
            | Problem::Length { .. }
            | Problem::Word { .. }
            | Problem::Side(_)
            | Problem::Integer(_)
            | Problem::VertexNumber(_)
            | Problem::NoSuchFace { .. }
            | Problem::NotFinite { .. }
            | Problem::FewVertices { .. }
            | Problem::Triangle(_)
            | Problem::Index(_)
            | Problem::Bits { .. }
            | Problem::Digits(_)
            | Problem::Order(_)
            | Problem::BesideFile
            | Problem::Volume(_)
            | Problem::VolumeFile(_)
            | Problem::Exponent(_)
            | Problem::Slope(_)
            | Problem::Signal(_)
            | Problem::Axes { .. }
            | Problem::NoCurvature
            | Problem::Derivative { .. }
            | Problem::SampleTwice
            | Problem::EmptyRange
            | Problem::Raster(_) => false,
        }
    }
}

impl Display for InvalidField {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for (depth, step) in self.steps.iter().rev().enumerate() {
            match step {
                Step::Field(name) if depth == 0 => write!(f, "{name}")?,
                Step::Field(name) => write!(f, ".{name}")?,
                Step::Item(index) => write!(f, "[{index}]")?,
                Step::Key(number) => write!(f, ".{number}")?,
                Step::Name(name) => write!(f, "[{:?}]", name.chars().take(40).collect::<String>())?,
            }
        }
        let separator = match &self.problem {
            _ if self.steps.is_empty() => "",
            // Its message begins with the name of one more field.
            Problem::Volume(_) | Problem::Raster(_) => ".",
            _ => ": ",
        };
        write!(f, "{separator}{}", self.problem)
    }
}

impl std::error::Error for InvalidField {}

/// A field that must be there.
pub fn field<T>(
    object: &Object,
    name: &'static str,
    read: impl FnOnce(&Value) -> Result<T, InvalidField>,
) -> Result<T, InvalidField> {
    let value = object.get(name).ok_or_else(|| InvalidField::here(Problem::Missing));
    value.and_then(read).map_err(|error| error.within(Step::Field(name)))
}

/// A field that may be there.
pub fn optional<T>(
    object: &Object,
    name: &'static str,
    read: impl FnOnce(&Value) -> Result<T, InvalidField>,
) -> Result<Option<T>, InvalidField> {
    object.get(name).map(read).transpose().map_err(|error| error.within(Step::Field(name)))
}

/// A list, its items as they are.
pub fn list(value: &Value) -> Result<&[Value], InvalidField> {
    value.as_array().map(Vec::as_slice).ok_or_else(|| wrong_type("an array", value))
}

/// A list of any length.
pub fn items<T>(value: &Value, read: impl Fn(&Value) -> Result<T, InvalidField>) -> Result<Vec<T>, InvalidField> {
    list(value)?.iter().enumerate().map(|(i, item)| read(item).map_err(|error| error.within(Step::Item(i)))).collect()
}

/// A list of a given length.
pub fn exactly<T, const N: usize>(
    value: &Value,
    read: impl Fn(&Value) -> Result<T, InvalidField>,
) -> Result<[T; N], InvalidField> {
    if let Value::Array(list) = value
        && list.len() != N
    {
        return Err(InvalidField::here(Problem::Length { expected: N, found: list.len() }));
    }
    let list = items(value, read)?;
    Ok(list.try_into().unwrap_or_else(|_| unreachable!("the length was checked")))
}

/// A number, exactly: a JSON integer and a string are themselves, any other JSON number is the binary64
/// nearest to it.
pub fn number(value: &Value) -> Result<Rational, InvalidField> {
    match value {
        Value::Number(n) => text::json_number(n.as_str()),
        Value::String(s) => text::parse(s),
        Value::Null | Value::Bool(_) | Value::Array(_) | Value::Object(_) => return Err(wrong_type("a number", value)),
    }
    .map_err(InvalidField::here)
}

/// A list of a given number of numbers.
pub fn numbers<const N: usize>(value: &Value) -> Result<[Rational; N], InvalidField> {
    exactly(value, number)
}

/// A text.
pub fn string(value: &Value) -> Result<&str, InvalidField> {
    value.as_str().ok_or_else(|| wrong_type("a string", value))
}

/// An object.
pub fn object(value: &Value) -> Result<&Object, InvalidField> {
    value.as_object().ok_or_else(|| wrong_type("an object", value))
}

/// One of a few words, given with what they mean; `expected` lists them.
pub fn word<T: Copy>(value: &Value, expected: &'static str, words: &[(&str, T)]) -> Result<T, InvalidField> {
    let found = string(value)?;
    match words.iter().find(|(word, _)| *word == found) {
        Some((_, meaning)) => Ok(*meaning),
        None => Err(InvalidField::here(Problem::Word { expected, found: found.chars().take(40).collect() })),
    }
}

/// The shape of a grid: integers of at least 2, whose product is within [`MAX_SAMPLES`].
pub fn shape<const N: usize>(value: &Value) -> Result<[usize; N], InvalidField> {
    let sides = exactly(value, |side| match number(side)? {
        n if n.is_integer() && n >= 2 => Ok(n.into_numer_denom().0.to_usize()),
        n => Err(InvalidField::here(Problem::Side(n))),
    })?;
    // A side beyond any address is beyond the limit.
    let sides = sides.map(|side| side.unwrap_or(usize::MAX));
    match sides.iter().try_fold(1_usize, |n, &side| n.checked_mul(side)) {
        Some(samples) if samples <= MAX_SAMPLES => Ok(sides),
        Some(_) | None => Err(InvalidField::here(Problem::TooManySamples)),
    }
}

/// The number of a vertex. One beyond 32 bits is the greatest there is, which no vertex has.
pub fn vertex_number(value: &Value) -> Result<u32, InvalidField> {
    match number(value)? {
        n if n.is_integer() && n >= 0 => Ok(n.numer().to_u32().unwrap_or(u32::MAX)),
        n => Err(InvalidField::here(Problem::VertexNumber(n))),
    }
}

/// An integer of 32 bits, with its sign.
pub fn int32(value: &Value) -> Result<i32, InvalidField> {
    let n = number(value)?;
    let small = n.is_integer().then(|| n.numer().to_i32()).flatten();
    small.ok_or_else(|| InvalidField::here(Problem::Bits { bits: 32, found: n }))
}

/// An index, counted from 0. One beyond any list is the greatest there is, which no item has.
pub fn index(value: &Value) -> Result<usize, InvalidField> {
    match number(value)? {
        n if n.is_integer() && n >= 0 => Ok(n.numer().to_usize().unwrap_or(usize::MAX)),
        n => Err(InvalidField::here(Problem::Index(n))),
    }
}

/// How narrow an enclosure is to be.
pub fn digits(value: &Value) -> Result<Digits, InvalidField> {
    match number(value)? {
        n if n.is_integer() && n >= 0 => {
            Digits::new(n.numer().to_u32().unwrap_or(u32::MAX)).map_err(InvalidField::here)
        }
        n => Err(InvalidField::here(Problem::Digits(n))),
    }
}

fn wrong_type(expected: &'static str, value: &Value) -> InvalidField {
    let found = match value {
        Value::Null => "null",
        Value::Bool(_) => "a boolean",
        Value::Number(_) => "a number",
        Value::String(_) => "a string",
        Value::Array(_) => "an array",
        Value::Object(_) => "an object",
    };
    InvalidField::here(Problem::Type { expected, found })
}

/// A rational as it leaves: the string `p/q` in lowest terms, `p` where q = 1.
pub struct Exact(pub Rational);

impl Serialize for Exact {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&text::exact_text(&self.0))
    }
}

/// A real number as it leaves that is given by decimal strings around it.
#[derive(Serialize)]
pub struct EnclosureOut {
    lo: String,
    hi: String,
}

impl From<DecimalEnclosure> for EnclosureOut {
    fn from(DecimalEnclosure { lo, hi }: DecimalEnclosure) -> EnclosureOut {
        EnclosureOut { lo, hi }
    }
}

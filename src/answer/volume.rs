//! Volumes of a question: in line or in a file, each sample exactly what was written.

use super::value::{self, InvalidField, MAX_SAMPLES, Object, Problem, Step};
use crate::format::{self, Limits, Samples, VolumeRecord};
use crate::isosurface::volume::{Volume, VolumeError};
use crate::number::Rational;
use serde_json::Value;
use std::path::Path;

/// A volume: `{"shape":[nx,ny,nz],"values":[…]}`, x fastest, or `{"file":"v.npy"}`, `{"file":"v.nrrd"}`.
///
/// # Errors
/// The field that is not as it should be; the shape is checked before anything of its size is allocated.
pub fn read(value: &Value) -> Result<Volume, InvalidField> {
    let volume = value::object(value)?;
    match value::optional(volume, "file", |file| value::string(file).map(str::to_owned))? {
        Some(_) if volume.contains_key("values") => {
            Err(InvalidField::here(Problem::BesideFile).within(Step::Field("values")))
        }
        Some(file) => from_file(Path::new(&file)).map_err(|error| error.within(Step::Field("file"))),
        None => in_line(volume),
    }
}

/// The volume in a `.npy`, `.nrrd` or `.nhdr` file.
///
/// # Errors
/// The file cannot be read, has more than 2²⁸ samples or fewer than 2 along an axis, or a sample that is no number.
pub fn from_file(path: &Path) -> Result<Volume, InvalidField> {
    let record = format::read_volume(path, &Limits { samples: MAX_SAMPLES })
        .map_err(|error| InvalidField::here(Problem::File(Box::new(error))))?;
    Volume::try_from(record).map_err(|error| InvalidField::here(Problem::VolumeFile(error)))
}

fn in_line(volume: &Object) -> Result<Volume, InvalidField> {
    let shape = value::field(volume, "shape", value::shape)?;
    value::field(volume, "values", |values| {
        let list = value::list(values)?;
        // Most volumes are all of small integers, or all of binary64 numbers; both are kept as such.
        if let Some(integers) = list.iter().map(small_integer).collect() {
            Ok(Volume::integers(shape, integers))
        } else if let Some(floats) = list.iter().map(binary64).collect() {
            Ok(Volume::floats(shape, floats))
        } else {
            value::items(values, value::number).map(|rationals| Volume::rationals(shape, rationals))
        }
    })?
    .map_err(|error| InvalidField::here(Problem::Volume(error)))
}

fn small_integer(value: &Value) -> Option<i32> {
    match value {
        Value::Number(n) => n.as_str().parse().ok(),
        Value::Null | Value::Bool(_) | Value::String(_) | Value::Array(_) | Value::Object(_) => None,
    }
}

/// The value of a JSON number, where a binary64 holds it: any that is not an integer, and small integers.
fn binary64(value: &Value) -> Option<f64> {
    match value {
        Value::Number(n) if n.as_str().contains(['.', 'e']) => n.as_str().parse().ok().filter(|x: &f64| x.is_finite()),
        Value::Number(_) => small_integer(value).map(f64::from),
        Value::Null | Value::Bool(_) | Value::String(_) | Value::Array(_) | Value::Object(_) => None,
    }
}

impl TryFrom<VolumeRecord> for Volume {
    type Error = VolumeError;

    /// The same samples, each exactly.
    ///
    /// Errors: iff an axis has fewer than 2 samples, their number is not nx·ny·nz < 2³¹, or one is NaN or infinite.
    fn try_from(VolumeRecord { shape, samples }: VolumeRecord) -> Result<Volume, VolumeError> {
        match samples {
            Samples::U8(values) => integers(shape, &values),
            Samples::I8(values) => integers(shape, &values),
            Samples::U16(values) => integers(shape, &values),
            Samples::I16(values) => integers(shape, &values),
            Samples::U32(values) => integers(shape, &values),
            Samples::I32(values) => Volume::integers(shape, values),
            Samples::U64(values) => integers(shape, &values),
            Samples::I64(values) => integers(shape, &values),
            Samples::F32(values) => Volume::floats(shape, values.into_iter().map(f64::from).collect()),
            Samples::F64(values) => Volume::floats(shape, values),
        }
    }
}

fn integers<T>(shape: [usize; 3], values: &[T]) -> Result<Volume, VolumeError>
where
    T: Copy + TryInto<i32>,
    Rational: From<T>,
{
    match values.iter().map(|&v| v.try_into().ok()).collect() {
        Some(small) => Volume::integers(shape, small),
        None => Volume::rationals(shape, values.iter().map(|&v| Rational::from(v)).collect()),
    }
}

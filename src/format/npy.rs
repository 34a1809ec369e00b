//! NPY, numpy's array file, through `ndarray-npy`.
//!
//! The first index of the array is x, so a C-ordered array (x slowest) is transposed to x fastest, and a
//! Fortran-ordered one is not.

use super::{GridRecord, Limits, Problem, Samples, VolumeRecord, excerpt, reserved, sample_count, with_samples};
use ndarray::{ArrayView, IxDyn, ShapeBuilder};
use ndarray_npy::npy::header::{Header, Layout};
use ndarray_npy::{ReadDataError, ReadableElement, WritableElement, WriteNpyError, WriteNpyExt};
use std::io::{self, Cursor, Read, Write};

/// Reads a three-dimensional array of integers, floats or booleans.
///
/// Errors: another format, another number of axes, another element type; more samples than the limit; data that ends
/// early or goes on.
pub fn read(mut reader: impl Read, limits: &Limits) -> Result<VolumeRecord, Problem> {
    let header = header(&mut reader)?;
    let [nx, ny, nz] = header.shape[..] else {
        return Err(Problem::NotThreeAxes { field: "shape", sizes: header.shape });
    };
    Ok(VolumeRecord { shape: [nx, ny, nz], samples: samples(reader, header, limits)? })
}

/// Reads an array of one to three axes; errors as [`read`].
pub fn read_grid(mut reader: impl Read, limits: &Limits) -> Result<GridRecord, Problem> {
    let header = header(&mut reader)?;
    if !(1..=3).contains(&header.shape.len()) {
        return Err(Problem::NotAGrid { field: "shape", sizes: header.shape });
    }
    let shape = header.shape.clone();
    Ok(GridRecord { shape, samples: samples(reader, header, limits)? })
}

fn samples(reader: impl Read, header: Header, limits: &Limits) -> Result<Samples, Problem> {
    let array = Array { count: sample_count("shape", &header.shape, limits)?, header };
    let descr = array.header.type_descriptor.as_string().map_or("", String::as_str);
    Ok(match descr.trim_start_matches(['<', '>', '|', '=']) {
        "u1" | "B" => Samples::U8(array.values(reader)?),
        "i1" | "b" => Samples::I8(array.values(reader)?),
        "u2" => Samples::U16(array.values(reader)?),
        "i2" => Samples::I16(array.values(reader)?),
        "u4" => Samples::U32(array.values(reader)?),
        "i4" => Samples::I32(array.values(reader)?),
        "u8" => Samples::U64(array.values(reader)?),
        "i8" => Samples::I64(array.values(reader)?),
        "f4" => Samples::F32(array.values(reader)?),
        "f8" => Samples::F64(array.values(reader)?),
        "b1" => Samples::U8(array.values::<bool>(reader)?.into_iter().map(u8::from).collect()),
        _ => return Err(unknown_type(array.header.type_descriptor.to_string())),
    })
}

/// Writes the samples as they are, in Fortran order.
pub fn write(mut writer: impl Write, volume: &VolumeRecord) -> Result<(), Problem> {
    volume.has_its_shape()?;
    with_samples!(&volume.samples, values => write_values(&mut writer, &volume.shape, values))
}

/// Writes the samples as they are, in Fortran order.
pub fn write_grid(mut writer: impl Write, grid: &GridRecord) -> Result<(), Problem> {
    grid.has_its_shape()?;
    with_samples!(&grid.samples, values => write_values(&mut writer, &grid.shape, values))
}

struct Array {
    header: Header,
    count: usize,
}

impl Array {
    /// The elements, x fastest.
    fn values<T: ReadableElement + Copy>(&self, reader: impl Read) -> Result<Vec<T>, Problem> {
        // The library allocates everything at once and aborts if it cannot: ask first.
        drop(reserved::<T>("shape", &self.header.shape, self.count)?);
        let expected = (self.count * size_of::<T>()) as u64;
        let mut counted = Counted { reader: reader.take(expected.saturating_add(1)), bytes: 0 };
        let stored = T::read_to_end_exact_vec(&mut counted, &self.header.type_descriptor, self.count)
            .map_err(|error| data_problem(error, expected, counted.bytes))?;
        match self.header.layout {
            Layout::Fortran => Ok(stored),
            Layout::Standard => {
                let shape = IxDyn(&self.header.shape);
                let array = ArrayView::from_shape(shape, &stored).expect("as many elements as the shape says");
                Ok(array.reversed_axes().iter().copied().collect())
            }
        }
    }
}

struct Counted<R> {
    reader: R,
    bytes: u64,
}

impl<R: Read> Read for Counted<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let n = self.reader.read(buffer)?;
        self.bytes += n as u64;
        Ok(n)
    }
}

fn data_problem(error: ReadDataError, expected: u64, found: u64) -> Problem {
    let (field, unit) = ("data".to_owned(), "bytes");
    match error {
        ReadDataError::Io(error) if error.kind() != io::ErrorKind::UnexpectedEof => Problem::Io(error),
        ReadDataError::Io(_) | ReadDataError::MissingData => Problem::Truncated { field, unit, expected, found },
        ReadDataError::ExtraBytes(_) => Problem::Overlong { field, unit, expected },
        ReadDataError::WrongDescriptor(found) => unknown_type(found.to_string()),
        ReadDataError::ParseData(source) => Problem::Library { field: "data", source },
    }
}

fn write_values<T: WritableElement>(writer: impl Write, shape: &[usize], values: &[T]) -> Result<(), Problem> {
    let array = ArrayView::from_shape(IxDyn(shape).f(), values).expect("as many samples as the shape says");
    array.write_npy(writer).map_err(|error| match error {
        WriteNpyError::Io(error) => Problem::Io(error),
        WriteNpyError::FormatHeader(error) => Problem::Library { field: "header", source: Box::new(error) },
        WriteNpyError::FormatData(source) => Problem::Library { field: "data", source },
    })
}

fn unknown_type(found: String) -> Problem {
    let expected = "'u1', 'i1', …, 'u8', 'i8', 'f4', 'f8' or 'b1', with '<', '>' or '|' before it";
    Problem::Invalid { field: "descr".to_owned(), expected, found }
}

const LONGEST_HEADER: usize = 1 << 16;
const DEEPEST_NESTING: usize = 16;

/// The header, read whole and looked at before the library parses it: the library would allocate any length that the
/// file states, and its recursive parser would run out of stack on thousands of opening brackets.
fn header(reader: &mut impl Read) -> Result<Header, Problem> {
    let mut bytes = Vec::new();
    let mut more = |bytes: &mut Vec<u8>, expected: usize| -> Result<(), Problem> {
        reader.by_ref().take((expected - bytes.len()) as u64).read_to_end(bytes)?;
        if bytes.len() == expected {
            return Ok(());
        }
        let (expected, found) = (expected as u64, bytes.len() as u64);
        Err(Problem::Truncated { field: "header".to_owned(), unit: "bytes", expected, found })
    };
    more(&mut bytes, 10)?;
    if !bytes.starts_with(b"\x93NUMPY") {
        return Err(Problem::Magic { format: "NPY", found: excerpt(&bytes) });
    }
    let total = if bytes[6] == 1 {
        10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]))
    } else {
        more(&mut bytes, 12)?;
        12_usize.saturating_add(u32::from_le_bytes([bytes[8], bytes[9], bytes[10], bytes[11]]) as usize)
    };
    if total > LONGEST_HEADER {
        return Err(Problem::EndlessHeader { bytes: LONGEST_HEADER });
    }
    more(&mut bytes, total)?;
    if bytes.iter().filter(|byte| b"([{".contains(byte)).count() > DEEPEST_NESTING {
        return Err(unknown_type(excerpt(&bytes[10..])));
    }
    Header::from_reader(&mut Cursor::new(&bytes))
        .map_err(|error| Problem::Library { field: "header", source: Box::new(error) })
}

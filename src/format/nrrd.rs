//! NRRD, "nearly raw raster data" (<https://teem.sourceforge.net/nrrd/format.html>).
//!
//! Read: versions 1 to 5; three axes (further ones of size 1); every scalar type by each of its names; both byte
//! orders; the encodings raw, gzip and ascii; line and byte skips; the data in the same file or in one other.
//! Whatever else a header states (spacings, origin, key/value pairs) is passed over. The first axis is x.

use super::{Limits, Problem, Samples, VolumeRecord, excerpt, reserved, sample_count, with_samples};
use flate2::Compression;
use flate2::bufread::MultiGzDecoder;
use flate2::write::GzEncoder;
use std::collections::BTreeMap;
use std::fmt::Debug;
use std::fs::File;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::str::FromStr;

/// How the samples are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// The bytes as they are.
    Raw,
    /// The bytes compressed.
    Gzip,
    /// Decimal numbers between blanks.
    Ascii,
}

/// Reads an NRRD whose data stands behind its header.
///
/// Errors, each naming its field: no NRRD; a field missing, stated twice or not supported; not three axes; more samples
/// than the limit; data that ends early, goes on, or is no number. A header with a `data file` needs [`read_file`].
pub fn read(reader: impl Read, limits: &Limits) -> Result<VolumeRecord, Problem> {
    let mut reader = BufReader::with_capacity(1 << 16, reader);
    let header = Header::read(&mut reader)?;
    match header.fields.get("data file") {
        None => header.volume(&mut reader, limits),
        Some(name) => Err(Problem::Invalid {
            field: "data file".to_owned(),
            expected: "data behind the header, since no folder is known here",
            found: name.clone(),
        }),
    }
}

/// Reads an NRRD file; a `data file` is sought relative to it. Errors as [`read`].
pub fn read_file(path: &Path, limits: &Limits) -> Result<VolumeRecord, Problem> {
    let mut reader = BufReader::with_capacity(1 << 16, File::open(path)?);
    let header = Header::read(&mut reader)?;
    match header.fields.get("data file") {
        None => header.volume(&mut reader, limits),
        Some(name) => {
            let of_several = name.contains('%') && name.split_whitespace().count() > 1;
            if of_several || name == "LIST" || name.starts_with("LIST ") {
                let (field, expected) = ("data file".to_owned(), "the name of one file");
                return Err(Problem::Invalid { field, expected, found: name.clone() });
            }
            let data = path.parent().unwrap_or(Path::new("")).join(name);
            let data = File::open(&data).map_err(|error| Problem::Invalid {
                field: "data file".to_owned(),
                expected: "a file that can be read",
                found: format!("{} ({error})", data.display()),
            })?;
            header.volume(&mut BufReader::with_capacity(1 << 16, data), limits)
        }
    }
}

/// Writes the samples in their own type, little endian where that matters, behind a header of version 4.
pub fn write(mut writer: impl Write, volume: &VolumeRecord, encoding: Encoding) -> Result<(), Problem> {
    volume.has_its_shape()?;
    let [nx, ny, nz] = volume.shape;
    with_samples!(&volume.samples, values => {
        let name = type_name(values);
        write!(writer, "NRRD0004\ntype: {name}\ndimension: 3\nsizes: {nx} {ny} {nz}\nendian: little\n")?;
        match encoding {
            Encoding::Raw => {
                writer.write_all(b"encoding: raw\n\n")?;
                write_bytes(&mut writer, values)?;
            }
            Encoding::Gzip => {
                writer.write_all(b"encoding: gzip\n\n")?;
                let mut gzip = GzEncoder::new(&mut writer, Compression::best());
                write_bytes(&mut gzip, values)?;
                gzip.finish()?;
            }
            Encoding::Ascii => {
                writer.write_all(b"encoding: ascii\n\n")?;
                for value in values {
                    writeln!(writer, "{value:?}")?;
                }
            }
        }
    });
    Ok(writer.flush()?)
}

fn type_name<T: Sample>(_: &[T]) -> &'static str {
    T::NAME
}

fn write_bytes<T: Sample>(writer: &mut impl Write, values: &[T]) -> Result<(), Problem> {
    let mut bytes = Vec::with_capacity(CHUNK * size_of::<T>());
    for chunk in values.chunks(CHUNK) {
        bytes.clear();
        chunk.iter().for_each(|value| value.push_little(&mut bytes));
        writer.write_all(&bytes)?;
    }
    Ok(())
}

const CHUNK: usize = 1 << 13;
const LONGEST_HEADER: usize = 1 << 20;

/// The fields of a header by name, without those that nothing here depends on.
struct Header {
    fields: BTreeMap<&'static str, String>,
}

impl Header {
    /// Reads up to and including the blank line (or to the end of the file).
    fn read(reader: &mut impl BufRead) -> Result<Header, Problem> {
        let mut reader = reader.take(LONGEST_HEADER as u64);
        let mut line = Vec::new();
        reader.read_until(b'\n', &mut line)?;
        if !matches!(line.trim_ascii_end(), [b'N', b'R', b'R', b'D', b'0', b'0', b'0', b'1'..=b'5']) {
            return Err(Problem::Magic { format: "NRRD", found: excerpt(&line) });
        }
        let mut fields = BTreeMap::new();
        loop {
            line.clear();
            reader.read_until(b'\n', &mut line)?;
            if line.is_empty() && reader.limit() == 0 {
                return Err(Problem::EndlessHeader { bytes: LONGEST_HEADER });
            }
            let text = String::from_utf8_lossy(&line);
            let text = text.trim_end();
            if text.is_empty() {
                return Ok(Header { fields });
            }
            if text.starts_with('#') {
                continue;
            }
            let Some((name, value)) = text.split_once(':') else {
                let expected = "'field: value', 'key:=value' or '# comment'";
                return Err(Problem::Invalid { field: "header".to_owned(), expected, found: excerpt(&line) });
            };
            let field = match name.trim().to_ascii_lowercase().as_str() {
                _ if value.starts_with('=') => continue,
                "type" => "type",
                "dimension" => "dimension",
                "sizes" => "sizes",
                "endian" => "endian",
                "encoding" => "encoding",
                "line skip" | "lineskip" => "line skip",
                "byte skip" | "byteskip" => "byte skip",
                "data file" | "datafile" => "data file",
                _ => continue,
            };
            if fields.insert(field, value.trim().to_owned()).is_some() {
                return Err(Problem::Repeated { field: field.to_owned() });
            }
        }
    }

    fn field(&self, field: &'static str) -> Result<&str, Problem> {
        self.fields.get(field).map(String::as_str).ok_or(Problem::Missing { field })
    }

    fn invalid(&self, field: &'static str, expected: &'static str) -> Problem {
        let found = self.fields.get(field).cloned().unwrap_or_default();
        Problem::Invalid { field: field.to_owned(), expected, found }
    }

    fn number(&self, field: &'static str, otherwise: i64, least: i64, expected: &'static str) -> Result<i64, Problem> {
        match self.fields.get(field).map(|value| value.parse()) {
            None => Ok(otherwise),
            Some(Ok(number)) if number >= least => Ok(number),
            Some(Ok(_) | Err(_)) => Err(self.invalid(field, expected)),
        }
    }

    fn shape(&self, limits: &Limits) -> Result<[usize; 3], Problem> {
        let expected = "whole numbers above 0, as many as the dimension says";
        let sizes = self.field("sizes")?.split_whitespace();
        let sizes: Vec<usize> =
            sizes.map(str::parse).collect::<Result<_, _>>().map_err(|_| self.invalid("sizes", expected))?;
        let dimension: usize =
            self.field("dimension")?.parse().map_err(|_| self.invalid("dimension", "a whole number"))?;
        if sizes.len() != dimension || sizes.contains(&0) {
            return Err(self.invalid("sizes", expected));
        }
        match sizes[..] {
            [nx, ny, nz, ref rest @ ..] if rest.iter().all(|&size| size == 1) => {
                sample_count("sizes", &sizes, limits)?;
                Ok([nx, ny, nz])
            }
            _ => Err(Problem::NotThreeAxes { field: "sizes", sizes }),
        }
    }

    fn encoding(&self) -> Result<Encoding, Problem> {
        match self.field("encoding")?.to_ascii_lowercase().as_str() {
            "raw" => Ok(Encoding::Raw),
            "gzip" | "gz" => Ok(Encoding::Gzip),
            "ascii" | "text" | "txt" => Ok(Encoding::Ascii),
            _ => Err(self.invalid("encoding", "raw, gzip, gz, ascii, text or txt")),
        }
    }

    fn byte_order<T>(&self) -> Result<ByteOrder, Problem> {
        match self.fields.get("endian").map(|endian| endian.to_ascii_lowercase()).as_deref() {
            Some("little") => Ok(ByteOrder::Little),
            Some("big") => Ok(ByteOrder::Big),
            None if size_of::<T>() == 1 => Ok(ByteOrder::Little),
            None => Err(Problem::Missing { field: "endian" }),
            Some(_) => Err(self.invalid("endian", "little or big")),
        }
    }

    fn volume(&self, reader: &mut impl BufRead, limits: &Limits) -> Result<VolumeRecord, Problem> {
        let shape = self.shape(limits)?;
        let samples = match self.field("type")?.to_ascii_lowercase().as_str() {
            "uchar" | "unsigned char" | "uint8" | "uint8_t" => Samples::U8(self.values(shape, reader)?),
            "signed char" | "int8" | "int8_t" => Samples::I8(self.values(shape, reader)?),
            "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => {
                Samples::U16(self.values(shape, reader)?)
            }
            "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => {
                Samples::I16(self.values(shape, reader)?)
            }
            "uint" | "unsigned int" | "uint32" | "uint32_t" => Samples::U32(self.values(shape, reader)?),
            "int" | "signed int" | "int32" | "int32_t" => Samples::I32(self.values(shape, reader)?),
            "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => {
                Samples::U64(self.values(shape, reader)?)
            }
            "longlong"
            | "long long"
            | "long long int"
            | "signed long long"
            | "signed long long int"
            | "int64"
            | "int64_t" => Samples::I64(self.values(shape, reader)?),
            "float" => Samples::F32(self.values(shape, reader)?),
            "double" => Samples::F64(self.values(shape, reader)?),
            // A bare "char" is signed on one machine and not on the next: NRRD does not allow it.
            _ => return Err(self.invalid("type", "a scalar type of NRRD, e.g. uint8, short, float or double")),
        };
        Ok(VolumeRecord { shape, samples })
    }

    /// Lines are skipped in the file, bytes in what comes out of the encoding: before the last sample if −1.
    fn values<T: Sample>(&self, shape: [usize; 3], reader: &mut impl BufRead) -> Result<Vec<T>, Problem> {
        let lines = self.number("line skip", 0, 0, "a whole number")?;
        let bytes = self.number("byte skip", 0, -1, "a whole number or -1")?;
        for skipped in 0..lines {
            if reader.skip_until(b'\n')? == 0 {
                return Err(truncated("line skip", "lines", lines as u64, skipped as u64));
            }
        }
        match self.encoding()? {
            Encoding::Raw if bytes == -1 => last_values(shape, self.byte_order::<T>()?, reader),
            Encoding::Gzip | Encoding::Ascii if bytes == -1 => {
                Err(self.invalid("byte skip", "a whole number: -1 is for the encoding raw"))
            }
            Encoding::Raw => raw_values(shape, self.byte_order::<T>()?, skip(bytes as u64, reader)?),
            Encoding::Gzip => {
                let mut unpacked = BufReader::with_capacity(1 << 16, MultiGzDecoder::new(reader));
                let order = self.byte_order::<T>()?;
                let values = skip(bytes as u64, &mut unpacked).and_then(|reader| raw_values(shape, order, reader));
                values.map_err(|problem| match problem {
                    Problem::Io(error) => Problem::Library { field: "data, gzip", source: Box::new(error) },
                    problem => problem,
                })
            }
            Encoding::Ascii => ascii_values(shape, skip(bytes as u64, reader)?),
        }
    }
}

fn truncated(field: &str, unit: &'static str, expected: u64, found: u64) -> Problem {
    Problem::Truncated { field: field.to_owned(), unit, expected, found }
}

fn skip<R: BufRead>(bytes: u64, reader: &mut R) -> Result<&mut R, Problem> {
    let mut skipped = 0;
    while skipped < bytes {
        let there = reader.fill_buf()?.len();
        if there == 0 {
            return Err(truncated("byte skip", "bytes", bytes, skipped));
        }
        let step = (bytes - skipped).min(there as u64);
        reader.consume(step as usize);
        skipped += step;
    }
    Ok(reader)
}

fn raw_values<T: Sample>(shape: [usize; 3], order: ByteOrder, reader: &mut impl BufRead) -> Result<Vec<T>, Problem> {
    let (count, width) = (shape.iter().product::<usize>(), size_of::<T>());
    let mut values = reserved("sizes", &shape, count)?;
    let mut chunk = Vec::with_capacity(CHUNK * width);
    while values.len() < count {
        let wanted = (count - values.len()).min(CHUNK) * width;
        chunk.clear();
        reader.by_ref().take(wanted as u64).read_to_end(&mut chunk)?;
        if chunk.len() < wanted {
            let found = values.len() * width + chunk.len();
            return Err(truncated("data", "bytes", (count * width) as u64, found as u64));
        }
        values.extend(chunk.chunks_exact(width).map(|bytes| T::from_bytes(bytes, order)));
    }
    // Reading on to the end also makes the decoder compare the checksum.
    match reader.fill_buf()? {
        [] => Ok(values),
        [..] => Err(Problem::Overlong { field: "data".to_owned(), unit: "bytes", expected: (count * width) as u64 }),
    }
}

/// The samples at the end of the file, whatever stands before them.
fn last_values<T: Sample>(shape: [usize; 3], order: ByteOrder, reader: &mut impl BufRead) -> Result<Vec<T>, Problem> {
    let wanted = shape.iter().product::<usize>() * size_of::<T>();
    let mut tail = Vec::new();
    loop {
        let found = reader.by_ref().take(1 << 16).read_to_end(&mut tail)?;
        if found == 0 || tail.len() / 2 > wanted + (1 << 16) {
            tail.drain(..tail.len().saturating_sub(wanted));
        }
        if found == 0 {
            return raw_values(shape, order, &mut &tail[..]);
        }
    }
}

fn ascii_values<T: Sample>(shape: [usize; 3], reader: &mut impl BufRead) -> Result<Vec<T>, Problem> {
    let count = shape.iter().product();
    let mut values: Vec<T> = reserved("sizes", &shape, count)?;
    let mut line = Vec::new();
    while reader.read_until(b'\n', &mut line)? > 0 {
        for word in line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()) {
            if values.len() == count {
                return Err(Problem::Overlong { field: "data".to_owned(), unit: "numbers", expected: count as u64 });
            }
            let number = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok());
            values.push(number.ok_or_else(|| Problem::Invalid {
                field: format!("data, number {}", values.len()),
                expected: T::NAME,
                found: excerpt(word),
            })?);
        }
        line.clear();
    }
    if values.len() < count {
        return Err(truncated("data", "numbers", count as u64, values.len() as u64));
    }
    Ok(values)
}

#[derive(Clone, Copy)]
enum ByteOrder {
    Little,
    Big,
}

/// A scalar type of NRRD.
trait Sample: Copy + Debug + FromStr {
    const NAME: &'static str;
    /// The value of exactly `size_of::<Self>()` bytes.
    fn from_bytes(bytes: &[u8], order: ByteOrder) -> Self;
    fn push_little(self, bytes: &mut Vec<u8>);
}

macro_rules! sample {
    ($($type:ty, $name:literal;)*) => {$(
        impl Sample for $type {
            const NAME: &'static str = $name;

            fn from_bytes(bytes: &[u8], order: ByteOrder) -> $type {
                let bytes = bytes.try_into().expect("as many bytes as the type has");
                match order {
                    ByteOrder::Little => <$type>::from_le_bytes(bytes),
                    ByteOrder::Big => <$type>::from_be_bytes(bytes),
                }
            }

            fn push_little(self, bytes: &mut Vec<u8>) {
                bytes.extend(self.to_le_bytes());
            }
        }
    )*};
}

sample! {
    u8, "uint8"; i8, "int8";
    u16, "uint16"; i16, "int16";
    u32, "uint32"; i32, "int32";
    u64, "uint64"; i64, "int64";
    f32, "float"; f64, "double";
}

//! Bytes ↔ unchecked records; no geometry here.
//!
//! A record says what a file says and no more: a face may name a vertex that is not there, a sample may be NaN.
//! Whoever turns a record into a model checks it.
//!
//! | format | volume | mesh | what is read |
//! |---|---|---|---|
//! | [`nrrd`] | `.nrrd` `.nhdr` | | raw, gzip, ascii; attached or detached |
//! | [`npy`] | `.npy` | | integers, floats, booleans; both byte orders, both memory orders |
//! | [`ply`] | | `.ply` | ascii, binary of both byte orders |
//! | [`stl`] | | `.stl` | ascii, binary |
//! | [`obj`] | | `.obj` | positions and faces |
//! | [`off`] | | `.off` | ascii: positions and faces, colours and normals passed over |
//! | [`vtu`] | | `.vtu` | nothing: tetrahedra and lines are written |
//! | [`msh`] | | `.msh` | nothing: tetrahedra and lines are written |
//! | [`gltf`] | | `.gltf` | nothing: coloured triangles and lines are written |
//!
//! Gluing schemes of 3-complexes have a text format of their own, [`scheme`]; triangulations of 3-manifolds are read and written as
//! [`snappea`] has them.

mod flat;
pub mod gltf;
mod grid;
pub mod msh;
pub mod npy;
pub mod nrrd;
pub mod obj;
pub mod off;
pub mod ply;
mod ply_binary;
pub mod ply_painted;
pub mod scheme;
pub mod snappea;
pub mod stl;
pub mod vtu;

pub use flat::FlatMesh;
pub use grid::{GridRecord, read_grid, write_grid};
use std::fs::File;
use std::io::{self, BufReader, BufWriter, Write};
use std::path::{Path, PathBuf};

/// The samples of a volume in the type they are stored in, x fastest: sample (i, j, k) has index i + nx·j + nx·ny·k.
#[derive(Clone, Debug, PartialEq)]
pub enum Samples {
    /// 8-bit unsigned integers, and booleans as 0 and 1.
    U8(Vec<u8>),
    /// 8-bit signed integers.
    I8(Vec<i8>),
    /// 16-bit unsigned integers.
    U16(Vec<u16>),
    /// 16-bit signed integers.
    I16(Vec<i16>),
    /// 32-bit unsigned integers.
    U32(Vec<u32>),
    /// 32-bit signed integers.
    I32(Vec<i32>),
    /// 64-bit unsigned integers.
    U64(Vec<u64>),
    /// 64-bit signed integers.
    I64(Vec<i64>),
    /// IEEE 754 binary32, NaN and infinities included.
    F32(Vec<f32>),
    /// IEEE 754 binary64, NaN and infinities included.
    F64(Vec<f64>),
}

// The same words for each of the ten types.
macro_rules! with_samples {
    ($samples:expr, $values:ident => $body:expr) => {
        match $samples {
            $crate::format::Samples::U8($values) => $body,
            $crate::format::Samples::I8($values) => $body,
            $crate::format::Samples::U16($values) => $body,
            $crate::format::Samples::I16($values) => $body,
            $crate::format::Samples::U32($values) => $body,
            $crate::format::Samples::I32($values) => $body,
            $crate::format::Samples::U64($values) => $body,
            $crate::format::Samples::I64($values) => $body,
            $crate::format::Samples::F32($values) => $body,
            $crate::format::Samples::F64($values) => $body,
        }
    };
}
use with_samples;

impl Samples {
    /// The number of samples.
    pub fn len(&self) -> usize {
        with_samples!(self, values => values.len())
    }

    /// Whether there is no sample at all.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A volume as a file has it: grid point (i, j, k) lies at (i, j, k), whatever spacing the file states.
#[derive(Clone, Debug, PartialEq)]
pub struct VolumeRecord {
    /// The number of grid points along x, y, z.
    pub shape: [usize; 3],
    /// Their samples; a reader makes exactly nx·ny·nz of them, a writer refuses any other number.
    pub samples: Samples,
}

impl VolumeRecord {
    fn has_its_shape(&self) -> Result<(), Problem> {
        let [nx, ny, nz] = self.shape;
        let expected = nx.checked_mul(ny).and_then(|n| n.checked_mul(nz));
        if expected == Some(self.samples.len()) {
            return Ok(());
        }
        Err(Problem::ShapeMismatch { shape: self.shape, samples: self.samples.len() })
    }
}

/// The width that a file stores positions in. An f64 holds either exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Every coordinate was stored as an IEEE 754 binary32.
    Binary32,
    /// Some coordinate was stored as a binary64, as an integer, or as a decimal (read as the nearest binary64).
    Binary64,
}

/// A mesh as a file has it.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshRecord {
    /// Positions, in the file's order; unused, repeated and non-finite ones are kept.
    pub vertices: Vec<[f64; 3]>,
    /// Polygons as cyclic lists of 0-based vertex indices, of any length and any value.
    pub faces: Vec<Vec<u32>>,
    /// The width of the stored positions.
    pub precision: Precision,
    /// Whether the format has no shared vertices (STL), so that face i has vertices 3i, 3i+1, 3i+2 of its own.
    pub soup: bool,
}

/// Tetrahedra and lines as a file is to have them.
#[derive(Clone, Debug, PartialEq)]
pub struct TetrahedraRecord {
    /// Positions in ℝ³.
    pub vertices: Vec<[f64; 3]>,
    /// The number of coordinates in ℝⁿ.
    pub dimension: usize,
    /// The positions in ℝⁿ, one after another.
    pub coordinates: Vec<f64>,
    /// The corners of each tetrahedron, from 0.
    pub tetrahedra: Vec<[u32; 4]>,
    /// A number for each tetrahedron, such as that of its polyhedron.
    pub groups: Vec<u32>,
    /// The ends of each line.
    pub lines: Vec<[u32; 2]>,
}

/// What a reader may allocate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The greatest number of samples of a volume, checked before anything is allocated for them.
    pub samples: usize,
}

impl Default for Limits {
    /// 2²⁹ samples, a volume of about 812³: 4 GiB as binary64.
    fn default() -> Limits {
        Limits { samples: 1 << 29 }
    }
}

/// A file could not be read or written.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", path.display())]
pub struct FormatError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it; part of this error's own message, so not its source too.
    pub problem: Problem,
}

/// What is wrong with the bytes, or with the record to be written.
#[derive(Debug, thiserror::Error)]
pub enum Problem {
    /// The operating system's answer.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// The file's name does not say a format that this function knows.
    #[error("unknown extension {found:?}, expected one of {expected}")]
    Extension {
        /// The extension, empty if there is none.
        found: String,
        /// Those that are known.
        expected: &'static str,
    },
    /// The file does not begin as its format begins.
    #[error("not a file of the format {format}: it begins with {found:?}")]
    Magic {
        /// The format that was expected.
        format: &'static str,
        /// The first bytes.
        found: String,
    },
    /// A header without end.
    #[error("header: no end within {bytes} bytes")]
    EndlessHeader {
        /// How many bytes were read.
        bytes: usize,
    },
    /// A field that must be there is not.
    #[error("{field}: missing")]
    Missing {
        /// The field.
        field: &'static str,
    },
    /// A field that may be there once is there twice.
    #[error("{field}: stated twice")]
    Repeated {
        /// The field.
        field: String,
    },
    /// A field has a value that cannot be read, or is not supported.
    #[error("{field}: expected {expected}, found {found:?}")]
    Invalid {
        /// The field, with its place in the file where there are many of its kind.
        field: String,
        /// What can be read.
        expected: &'static str,
        /// What is there.
        found: String,
    },
    /// The sizes are not those of a volume.
    #[error("{field}: expected three axes, found {sizes:?}")]
    NotThreeAxes {
        /// The field.
        field: &'static str,
        /// The sizes.
        sizes: Vec<usize>,
    },
    /// The sizes are not those of a grid.
    #[error("{field}: expected one to three axes, found {sizes:?}")]
    NotAGrid {
        /// The field.
        field: &'static str,
        /// The sizes.
        sizes: Vec<usize>,
    },
    /// Another number of items than there should be.
    #[error("{field}: expected {expected}, found {found}")]
    WrongCount {
        /// What there are items of.
        field: &'static str,
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// More samples than the limit allows (or than there are addresses).
    #[error("{field}: {sizes:?} is more than the limit of {limit} samples")]
    TooLarge {
        /// The field.
        field: &'static str,
        /// The sizes.
        sizes: Vec<usize>,
        /// The limit.
        limit: usize,
    },
    /// The file ends early.
    #[error("{field}: truncated, expected {expected} {unit}, found {found}")]
    Truncated {
        /// What is cut.
        field: String,
        /// What `expected` and `found` count.
        unit: &'static str,
        /// How many there should be.
        expected: u64,
        /// How many there are.
        found: u64,
    },
    /// The file goes on after its end.
    #[error("{field}: data goes on after the expected {expected} {unit}")]
    Overlong {
        /// What is too long.
        field: String,
        /// What `expected` counts.
        unit: &'static str,
        /// How many there should be.
        expected: u64,
    },
    /// A volume to be written has not as many samples as its shape says.
    #[error("shape: {shape:?} does not fit {samples} samples")]
    ShapeMismatch {
        /// The shape.
        shape: [usize; 3],
        /// The number of samples.
        samples: usize,
    },
    /// A face cannot be written in this format.
    #[error("face {face}: {problem}")]
    Face {
        /// Its index.
        face: usize,
        /// Why.
        problem: FaceProblem,
    },
    /// A library that reads the format says no.
    #[error("{field}: {source}")]
    Library {
        /// The part of the file that was being read.
        field: &'static str,
        /// What the library says.
        source: Box<dyn std::error::Error + Send + Sync>,
    },
}

/// Why a face cannot be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FaceProblem {
    /// STL has triangles only, and nothing is triangulated here.
    #[error("{0} vertices, but the format has triangles only")]
    NotATriangle(usize),
    /// STL has positions, not indices.
    #[error("vertex index {0} is out of range, and the format stores positions")]
    IndexOutOfRange(u32),
}

/// Reads the volume of a `.nrrd`, `.nhdr` or `.npy` file.
pub fn read_volume(path: &Path, limits: &Limits) -> Result<VolumeRecord, FormatError> {
    at(path, || match extension(path).as_str() {
        "nrrd" | "nhdr" => nrrd::read_file(path, limits),
        "npy" => npy::read(open(path)?, limits),
        _ => Err(unknown_extension(path, "nrrd, nhdr, npy")),
    })
}

/// Writes a volume as `.nrrd` (gzip) or `.npy` (Fortran order).
pub fn write_volume(path: &Path, volume: &VolumeRecord) -> Result<(), FormatError> {
    at(path, || {
        volume.has_its_shape()?;
        match extension(path).as_str() {
            "nrrd" => create(path, |out| nrrd::write(out, volume, nrrd::Encoding::Gzip)),
            "npy" => create(path, |out| npy::write(out, volume)),
            _ => Err(unknown_extension(path, "nrrd, npy")),
        }
    })
}

/// Reads the mesh of a `.ply`, `.stl`, `.obj` or `.off` file.
pub fn read_mesh(path: &Path) -> Result<MeshRecord, FormatError> {
    read_flat_mesh(path).map(MeshRecord::from)
}

/// [`read_mesh`] into flat arrays: no list a face, so that tens of millions of triangles fit.
pub fn read_flat_mesh(path: &Path) -> Result<FlatMesh, FormatError> {
    at(path, || match extension(path).as_str() {
        "ply" => ply::read_flat(open(path)?),
        "stl" => stl::read_flat(open(path)?),
        "obj" => obj::read_flat(open(path)?),
        "off" => off::read_flat(open(path)?),
        _ => Err(unknown_extension(path, MESHES)),
    })
}

const MESHES: &str = "ply, stl, obj, off";

/// Writes a mesh as `.ply` (binary, little endian, double), `.obj` or `.off` (shortest decimals), or `.stl` (binary).
///
/// PLY, OBJ and OFF keep every position exactly; STL rounds each coordinate to the nearest binary32, since it has no other
/// number, and takes triangles only.
pub fn write_mesh(path: &Path, mesh: &MeshRecord) -> Result<(), FormatError> {
    at(path, || match extension(path).as_str() {
        "ply" => create(path, |out| ply::write(out, mesh, ply::Encoding::Binary)),
        "obj" => create(path, |out| obj::write(out, mesh)),
        "off" => create(path, |out| off::write(out, mesh)),
        "stl" => create(path, |out| stl::write(out, mesh)),
        _ => Err(unknown_extension(path, MESHES)),
    })
}

pub(crate) fn at<T>(path: &Path, work: impl FnOnce() -> Result<T, Problem>) -> Result<T, FormatError> {
    work().map_err(|problem| FormatError { path: path.to_path_buf(), problem })
}

pub(crate) fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default()
}

pub(crate) fn unknown_extension(path: &Path, expected: &'static str) -> Problem {
    Problem::Extension { found: extension(path), expected }
}

fn open(path: &Path) -> Result<BufReader<File>, Problem> {
    Ok(BufReader::with_capacity(1 << 16, File::open(path)?))
}

pub(crate) fn create(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> Result<(), Problem>,
) -> Result<(), Problem> {
    let mut out = BufWriter::with_capacity(1 << 16, File::create(path)?);
    write(&mut out)?;
    Ok(out.flush()?)
}

/// nx·ny·nz, if it is within the limit and its bytes can be counted.
fn sample_count(field: &'static str, sizes: &[usize], limits: &Limits) -> Result<usize, Problem> {
    let product = sizes.iter().try_fold(1_usize, |n, &size| n.checked_mul(size));
    // No vector may have more than isize::MAX bytes, and a sample has at most 8.
    product.filter(|&n| n <= limits.samples && n <= isize::MAX as usize / 8).ok_or_else(|| Problem::TooLarge {
        field,
        sizes: sizes.to_vec(),
        limit: limits.samples,
    })
}

/// An empty vector with room for `count` samples; memory that the system will not give is an error, not an abort.
fn reserved<T>(field: &'static str, sizes: &[usize], count: usize) -> Result<Vec<T>, Problem> {
    let mut values = Vec::new();
    match values.try_reserve_exact(count) {
        Ok(()) => Ok(values),
        Err(_) => Err(Problem::TooLarge { field, sizes: sizes.to_vec(), limit: count }),
    }
}

/// The beginning of some bytes as text for a message.
fn excerpt(bytes: &[u8]) -> String {
    String::from_utf8_lossy(&bytes[..bytes.len().min(40)]).trim_end().to_owned()
}

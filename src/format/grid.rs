//! Grids of one to three axes.

use super::{
    FormatError, Limits, Problem, Samples, VolumeRecord, at, create, extension, npy, nrrd, open, unknown_extension,
};
use std::path::Path;

/// Samples on a grid as a file has them: the point k of an axis lies at k, whatever spacing the file states.
#[derive(Clone, Debug, PartialEq)]
pub struct GridRecord {
    /// The number of grid points along each axis, one to three of them.
    pub shape: Vec<usize>,
    /// Their samples, the first axis fastest; a reader makes exactly as many as the shape says, a writer refuses any other number.
    pub samples: Samples,
}

impl GridRecord {
    pub(super) fn has_its_shape(&self) -> Result<(), Problem> {
        match self.shape[..] {
            [_] | [_, _] | [_, _, _] => {}
            _ => return Err(Problem::NotAGrid { field: "shape", sizes: self.shape.clone() }),
        }
        let expected = self.shape.iter().try_fold(1_usize, |n, &side| n.checked_mul(side));
        if expected == Some(self.samples.len()) {
            return Ok(());
        }
        let shape: [usize; 3] = std::array::from_fn(|axis| self.shape.get(axis).copied().unwrap_or(1));
        Err(Problem::ShapeMismatch { shape, samples: self.samples.len() })
    }
}

impl From<VolumeRecord> for GridRecord {
    fn from(VolumeRecord { shape, samples }: VolumeRecord) -> GridRecord {
        GridRecord { shape: shape.to_vec(), samples }
    }
}

/// Reads the samples of a `.npy` file of one to three axes, or of a `.nrrd` or `.nhdr` file of three.
pub fn read_grid(path: &Path, limits: &Limits) -> Result<GridRecord, FormatError> {
    at(path, || match extension(path).as_str() {
        "nrrd" | "nhdr" => nrrd::read_file(path, limits).map(GridRecord::from),
        "npy" => npy::read_grid(open(path)?, limits),
        _ => Err(unknown_extension(path, "npy, nrrd, nhdr")),
    })
}

/// Writes samples as `.npy` (Fortran order), or those of three axes as `.nrrd` (gzip).
pub fn write_grid(path: &Path, grid: &GridRecord) -> Result<(), FormatError> {
    at(path, || {
        grid.has_its_shape()?;
        match (extension(path).as_str(), &grid.shape[..]) {
            ("npy", _) => create(path, |out| npy::write_grid(out, grid)),
            ("nrrd", &[nx, ny, nz]) => {
                let volume = VolumeRecord { shape: [nx, ny, nz], samples: grid.samples.clone() };
                create(path, |out| nrrd::write(out, &volume, nrrd::Encoding::Gzip))
            }
            ("nrrd", sizes) => Err(Problem::NotThreeAxes { field: "shape", sizes: sizes.to_vec() }),
            _ => Err(unknown_extension(path, "npy, nrrd")),
        }
    })
}

//! What several subcommands read.

use clap::ValueEnum;
use isoracle::answer::value::InvalidField;
use isoracle::answer::volume;
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::volume::{DegenerateCell, Volume};
use miette::Diagnostic;
use std::path::Path;
use thiserror::Error;

/// What to do where the isovalue is a critical value, as an option.
#[derive(Clone, Copy, ValueEnum)]
pub enum TieRule {
    Below,
}

impl From<TieRule> for Tie {
    fn from(TieRule::Below: TieRule) -> Tie {
        Tie::Below
    }
}

/// The isovalue is a critical value of the trilinear interpolant.
#[derive(Debug, Error, Diagnostic)]
#[error("--isovalue: {0}")]
#[diagnostic(help(
    "the topology of the isosurface is not defined there; `--tie below` takes an isovalue smaller by an infinitesimal"
))]
pub struct CriticalIsovalue(pub DegenerateCell);

/// The file after `--volume` cannot be used.
#[derive(Debug, Error, Diagnostic)]
#[error("--volume: {0}")]
#[diagnostic(help("a volume is a .npy, .nrrd or .nhdr file of real numbers on three axes, at least 2 samples each"))]
pub struct UnusableVolume(InvalidField);

/// The volume after `--volume`.
pub fn volume(path: &Path) -> Result<Volume, UnusableVolume> {
    volume::from_file(path).map_err(UnusableVolume)
}

//! What several subcommands read.

use clap::ValueEnum;
use isoracle::answer::value::InvalidField;
use isoracle::answer::volume;
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::volume::Volume;
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

/// The file after `--volume` cannot be used.
#[derive(Debug, Error, Diagnostic)]
#[error("--volume: {0}")]
#[diagnostic(help("a volume is a .npy, .nrrd or .nhdr file of real numbers on three axes, at least 2 samples each"))]
pub struct UnusableVolume(InvalidField);

/// The volume after `--volume`.
pub fn volume(path: &Path) -> Result<Volume, UnusableVolume> {
    volume::from_file(path).map_err(UnusableVolume)
}

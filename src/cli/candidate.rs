//! `isoracle candidate`.

use clap::Args;
use isoracle::judge::isosurface::builtin::{self, Builtin};
use miette::IntoDiagnostic;
use std::io;
use std::process::ExitCode;

/// Be one of the built-in candidates: speak the protocol as an implementation that is wrong in one way.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Candidate {
    /// classic (the table of 1987), wrong-face-rule, wrong-interior-rule, flipped-triangle,
    /// duplicated-triangle, hole, edge-in-face, or right.
    name: Builtin,
}

const AFTER_HELP: &str = "\
Examples:
  $ isoracle judge -- isoracle candidate classic
  $ isoracle judge -- isoracle candidate hole";

impl Candidate {
    pub fn run(self) -> miette::Result<ExitCode> {
        builtin::serve(self.name, io::stdin().lock(), io::stdout().lock()).into_diagnostic()?;
        Ok(ExitCode::SUCCESS)
    }
}

//! `isoracle candidate`.

use clap::Args;
use isoracle::judge::builtin::{self, Builtin};
use miette::IntoDiagnostic;
use std::io;
use std::process::ExitCode;

/// Be one of the built-in candidates: speak the protocol as an implementation that is right, or wrong in one way.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Candidate {
    /// Meshers: classic (the table of 1987), wrong-face-rule, wrong-interior-rule, flipped-triangle,
    /// duplicated-triangle, hole, edge-in-face, or right. Splines and curvatures in binary64: formulas, which is
    /// right, or as printed formulas-printed-kappa, formulas-printed-mean, formulas-printed-frobenius,
    /// formulas-printed-determinants.
    name: Builtin,
}

const AFTER_HELP: &str = "\
Examples:
  $ isoracle judge -- isoracle candidate classic
  $ isoracle judge -- isoracle candidate hole
  $ isoracle judge --suite curvature -- isoracle candidate formulas-printed-frobenius";

impl Candidate {
    pub fn run(self) -> miette::Result<ExitCode> {
        builtin::serve(self.name, io::stdin().lock(), io::stdout().lock()).into_diagnostic()?;
        Ok(ExitCode::SUCCESS)
    }
}

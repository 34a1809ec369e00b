//! `isoracle spec`.

use clap::Args;
use isoracle::spec::{self, Entry, Id, SpecError, html};
use miette::{Diagnostic, IntoDiagnostic};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use thiserror::Error;

/// Show the formulas that are checked, each with its source and its verdict.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Spec {
    /// One entry alone, such as NU-4.
    id: Option<Id>,
    /// A JSON list of {id, title, sources, verdict, printed, correct, counterexample, code, tests, snapshots}.
    #[arg(long)]
    json: bool,
    /// Write web pages into this directory, index.html first.
    #[arg(long, value_name = "DIR", conflicts_with = "json")]
    html: Option<PathBuf>,
}

const AFTER_HELP: &str = "\
Examples:
  $ isoracle spec
  $ isoracle spec NU-4
  $ isoracle spec --json | jq '.[] | select(.verdict == \"erratum\")'
  $ isoracle spec --html pages";

#[derive(Debug, Error, Diagnostic)]
enum Failure {
    #[error("no entry {0}")]
    #[diagnostic(help("`isoracle spec` lists them"))]
    NoSuchEntry(Id),
    #[error("the specification cannot be read: {0}")]
    #[diagnostic(help("this is a bug in isoracle"))]
    Unsound(#[from] SpecError),
    #[error("--html: {}: {error}", .path.display())]
    #[diagnostic(help("the directory is created where it is missing; it must be writable"))]
    Write { path: PathBuf, error: io::Error },
}

impl Spec {
    pub fn run(self) -> miette::Result<ExitCode> {
        let mut entries = spec::entries().map_err(Failure::from)?;
        if let Some(id) = &self.id {
            entries.retain(|entry| entry.id == *id);
            if entries.is_empty() {
                return Err(Failure::NoSuchEntry(id.clone()).into());
            }
        }
        if let Some(directory) = &self.html {
            write_pages(directory, &entries)?;
            return Ok(ExitCode::SUCCESS);
        }
        let text = if self.json {
            serde_json::to_string_pretty(&entries).into_diagnostic()? + "\n"
        } else if self.id.is_some() {
            entries.iter().map(Entry::to_string).collect()
        } else {
            entries.iter().map(|entry| format!("{:<6}  {:<21}  {}\n", entry.id, entry.verdict, entry.title)).collect()
        };
        super::to_stdout(io::stdout().write_all(text.as_bytes()))
    }
}

fn write_pages(directory: &Path, entries: &[Entry]) -> Result<(), Failure> {
    let at = |path: &Path| {
        let path = path.to_owned();
        |error| Failure::Write { path, error }
    };
    std::fs::create_dir_all(directory).map_err(at(directory))?;
    for (name, page) in html::pages(entries) {
        let path = directory.join(name);
        std::fs::write(&path, page).map_err(at(&path))?;
    }
    Ok(())
}

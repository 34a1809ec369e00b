//! The command line: a file a subcommand.
//!
//! Exit codes: 0 it is so; 1 it is refuted, or wrong; 2 the command line or a file cannot be used; 3 the
//! candidate broke.

mod answer;
mod candidate;
mod check;
mod check_mesh;
mod complex;
mod complex_page;
mod curvature;
mod curvature_map;
mod demo;
mod input;
mod interpolant;
mod isosurface;
mod judge;
mod points;
mod progress;
mod spec;
mod spline;

use clap::{ArgAction, Parser, Subcommand};
use miette::IntoDiagnostic;
use std::io::{self, IsTerminal};
use std::process::ExitCode;
use tracing_subscriber::filter::{LevelFilter, Targets};
use tracing_subscriber::prelude::*;

/// The exact answer that geometry code is checked against.
#[derive(Parser)]
#[command(name = "isoracle", version, arg_required_else_help = true, after_help = AFTER_HELP)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Say more on stderr; twice, and three times, even more. RUST_LOG has the last word.
    #[arg(short, long, global = true, action = ArgAction::Count)]
    verbose: u8,
}

const AFTER_HELP: &str = "\
Exit codes: 0 it is so, 1 it is refuted, 2 the command line or a file cannot be used, 3 the candidate broke.";

#[derive(Subcommand)]
enum Command {
    Answer(answer::Answer),
    Candidate(candidate::Candidate),
    Check(check::Check),
    Complex(complex::Complex),
    Curvature(curvature::Curvature),
    Demo(demo::Demo),
    Isosurface(isosurface::Isosurface),
    Judge(judge::Judge),
    Spec(spec::Spec),
    Spline(spline::SplineCommand),
}

const UNUSABLE: u8 = 2;

/// Runs the command line of this process.
pub fn main() -> ExitCode {
    let cli = Cli::parse();
    log_to_stderr(cli.verbose);
    let outcome = match cli.command {
        Command::Answer(answer) => answer.run(),
        Command::Candidate(candidate) => candidate.run(),
        Command::Check(check) => check.run(),
        Command::Complex(complex) => complex.run(),
        Command::Curvature(curvature) => curvature.run(),
        Command::Demo(demo) => demo.run(),
        Command::Isosurface(isosurface) => isosurface.run(),
        Command::Judge(judge) => judge.run(),
        Command::Spec(spec) => spec.run(),
        Command::Spline(spline) => spline.run(),
    };
    match outcome {
        Ok(code) => code,
        Err(report) => {
            eprintln!("{report:?}");
            ExitCode::from(UNUSABLE)
        }
    }
}

/// Writing to stdout; whoever stopped reading it has seen enough, which is no failure.
fn to_stdout(outcome: io::Result<()>) -> miette::Result<ExitCode> {
    match outcome {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error).into_diagnostic(),
        Err(_) | Ok(()) => Ok(ExitCode::SUCCESS),
    }
}

fn log_to_stderr(verbose: u8) {
    let level =
        [LevelFilter::WARN, LevelFilter::INFO, LevelFilter::DEBUG, LevelFilter::TRACE][usize::from(verbose.min(3))];
    let asked = std::env::var("RUST_LOG").ok().and_then(|rules| rules.parse::<Targets>().ok());
    let targets = asked.unwrap_or_else(|| Targets::new().with_default(level));
    let lines = tracing_subscriber::fmt::layer().with_writer(io::stderr).with_ansi(io::stderr().is_terminal());
    tracing_subscriber::registry().with(lines.with_filter(targets)).init();
}

//! `isoracle judge`.

use super::progress;
use clap::{Args, ValueEnum};
use isoracle::answer::value::{self, InvalidField};
use isoracle::judge::candidate::{Breakdown, Process};
use isoracle::judge::complex::Complex;
use isoracle::judge::html::{Section, page};
use isoracle::judge::isosurface::Isosurface;
use isoracle::judge::isosurface::place::Tolerance;
use isoracle::judge::junit::junit;
use isoracle::judge::mesh::Mesh;
use isoracle::judge::numbers::{Family, MaxError, Numbers};
use isoracle::judge::report::{Outcome, Report, json};
use isoracle::judge::run;
use isoracle::judge::suite::{self, Judgement};
use isoracle::judge::text::text;
use miette::{Diagnostic, IntoDiagnostic};
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;
use thiserror::Error;

/// Judge an implementation: ask it a suite over the protocol, and compare its answers with the exact truth.
///
/// The candidate is one long-lived process that reads a line of JSON a question and writes one an answer. If it
/// hangs, dies or writes garbage, that costs the question, and it is started anew.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Judge {
    /// The questions to ask.
    #[arg(long, value_enum, default_value_t = Suite::Isosurface)]
    suite: Suite,
    /// The seed of the random questions; the same seed asks the same ones.
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// How many random questions to ask of each group: pairs, grids, near-degenerate ones, ties; of each kind of mesh,
    /// gluing scheme, spline or curvature, a tenth as many.
    #[arg(long, value_name = "N", default_value_t = 200)]
    cases: usize,
    /// Seconds that an answer may take.
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0, value_parser = seconds)]
    limit: f64,
    /// How far a plain number may be off. Isosurfaces and meshes: a vertex from the true crossing, or another real number
    /// from the true one, in units in the last place of binary32 [default: 64]. Splines and curvatures: in units of 2⁻⁵²
    /// (binary64) of the largest number of the same list [default: 4096].
    #[arg(long, value_name = "ULP", value_parser = ulps)]
    max_ulp: Option<f64>,
    /// Splines and curvatures: a number may be no more than --max-ulp off in units in its own last place, either.
    #[arg(long)]
    componentwise: bool,
    /// Where to write report.json, report.html and report.xml (JUnit); nothing is written without it but
    /// report.json in the working folder.
    #[arg(long, value_name = "FOLDER")]
    report: Option<PathBuf>,
    /// Ask this one question instead of the suite, as a report quotes it: the `in` of an isosurface.mesh question, or
    /// {"op":…,"in":…} of the other suites.
    #[arg(long, value_name = "JSON")]
    question: Option<String>,
    /// The candidate: a program and its arguments.
    #[arg(last = true, required = true, value_name = "COMMAND")]
    command: Vec<String>,
}

const AFTER_HELP: &str = "\
Exit codes: 0 every answer is right, 1 the candidate is wrong, 2 usage, 3 it crashed, hung or spoke nonsense.

Examples:
  $ isoracle judge -- isoracle answer
  $ isoracle judge -- isoracle candidate classic
  $ isoracle judge --report report -- python3 examples/candidates/skimage_lewiner.py
  $ isoracle judge --suite curvature -- isoracle candidate formulas";

#[derive(Clone, Copy, ValueEnum)]
enum Suite {
    /// Marching cubes: single cells, pairs, grids, near-degenerate ones, ties.
    Isosurface,
    /// Polygon meshes: what is wrong with them, their planes, their angle deficits.
    Mesh,
    /// Gluing schemes of 3-manifolds: whether they are some, their cells, homology, tetrahedra, refinements.
    Complex,
    /// Cubic splines: coefficients, values, derivatives, with histograms of their errors.
    Spline,
    /// Curvatures of curves, surfaces and splines, with histograms of their errors.
    Curvature,
}

#[derive(Debug, Error, Diagnostic)]
pub enum Failure {
    #[error("the candidate cannot be judged: {0}")]
    #[diagnostic(help(
        "a candidate answers {{\"id\":1,\"op\":\"hello\",\"in\":{{\"protocol\":1}}}} with one line of JSON; examples/candidates/README.md shows how"
    ))]
    NoHello(Breakdown),
    #[error("--question: {0}")]
    #[diagnostic(help(
        "for example {{\"volume\":{{\"shape\":[2,2,2],\"values\":[1,-1,-1,1,-1,1,1,-1]}},\"isovalue\":0}}"
    ))]
    Question(InvalidField),
    #[error("--question: {0}")]
    #[diagnostic(help("the question is one JSON object, in one argument"))]
    QuestionText(serde_json::Error),
}

const WRONG: u8 = 1;
const BROKEN: u8 = 3;

impl Judge {
    pub fn run(self) -> miette::Result<ExitCode> {
        let tolerance = self.max_ulp.map_or_else(Tolerance::default, Tolerance);
        let most =
            MaxError { units: self.max_ulp.unwrap_or(MaxError::default().units), componentwise: self.componentwise };
        let numbers = |family| Numbers { family, seed: self.seed, cases: self.cases.div_ceil(10), most };
        match self.suite {
            Suite::Isosurface => self.run_suite(&Isosurface { seed: self.seed, cases: self.cases, tolerance }),
            Suite::Mesh => self.run_suite(&Mesh { seed: self.seed, cases: self.cases.div_ceil(10), tolerance }),
            Suite::Complex => self.run_suite(&Complex { seed: self.seed, cases: self.cases.div_ceil(10) }),
            Suite::Spline => self.run_suite(&numbers(Family::Spline)),
            Suite::Curvature => self.run_suite(&numbers(Family::Curvature)),
        }
    }

    fn run_suite(&self, suite: &impl suite::Suite) -> miette::Result<ExitCode> {
        let mut candidate = Process::new(self.command.clone(), Duration::from_secs_f64(self.limit));
        if let Some(text) = &self.question {
            return ask_one(suite, &mut candidate, text);
        }
        let bar = progress::bar("judging");
        let report = run::run(&mut candidate, suite, |done, of| {
            bar.set_length(of as u64);
            bar.set_position(done as u64);
        });
        bar.finish_and_clear();
        let report = match report {
            Ok(report) => report,
            Err(breakdown) => {
                eprintln!("{:?}", miette::Report::new(Failure::NoHello(breakdown)));
                return Ok(ExitCode::from(BROKEN));
            }
        };
        match &self.report {
            Some(folder) => write_report(&report, folder, &[])?,
            None => std::fs::write("report.json", json(&report)).into_diagnostic()?,
        }
        print!("{}", text(&report, io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none()));
        Ok(match report.verdict {
            Outcome::Passed => ExitCode::SUCCESS,
            Outcome::Wrong => ExitCode::from(WRONG),
            Outcome::Broken => ExitCode::from(BROKEN),
        })
    }
}

/// Writes every form of a report into a folder.
pub fn write_report(report: &Report, folder: &Path, extra: &[Section]) -> miette::Result<()> {
    std::fs::create_dir_all(folder).into_diagnostic()?;
    let write = |name: &str, text: String| std::fs::write(folder.join(name), text).into_diagnostic();
    write("report.json", json(report))?;
    write("report.html", page(report, extra))?;
    write("report.xml", junit(report))
}

/// Asks a question that a report quotes, and says what is wrong with the answer.
fn ask_one(suite: &impl suite::Suite, candidate: &mut Process, text: &str) -> miette::Result<ExitCode> {
    let object: value::Object = serde_json::from_str(text).map_err(Failure::QuestionText)?;
    let question = suite.parse(&object).map_err(Failure::Question)?;
    Ok(match suite.ask(candidate, &question) {
        Judgement::Right { left_out, .. } if left_out.is_empty() => {
            println!("right");
            ExitCode::SUCCESS
        }
        Judgement::Right { left_out, .. } => {
            println!("right, but for what it leaves out: {}", left_out.join(", "));
            ExitCode::SUCCESS
        }
        Judgement::Unsupported(why) => {
            println!("not supported: {why}");
            ExitCode::SUCCESS
        }
        Judgement::Wrong { fault, evidence, .. } => {
            let failure = suite.failure(&question, Some(evidence));
            println!("wrong: {fault} [{}]", failure.formula);
            for message in &failure.messages {
                println!("  {message}");
            }
            for difference in &failure.differences {
                println!(
                    "    {}\n      expected {}\n      found    {}",
                    difference.invariant, difference.expected, difference.found
                );
            }
            ExitCode::from(WRONG)
        }
        Judgement::Broken(breakdown) => {
            println!("broken: {breakdown}");
            ExitCode::from(BROKEN)
        }
    })
}

#[derive(Debug, Error)]
#[error("a finite number of units, 0 or more")]
struct NotUnits;

fn ulps(text: &str) -> Result<f64, NotUnits> {
    text.parse().ok().filter(|units: &f64| units.is_finite() && *units >= 0.0).ok_or(NotUnits)
}

#[derive(Debug, Error)]
#[error("a number of seconds above 0, at most 86400")]
struct NotSeconds;

fn seconds(text: &str) -> Result<f64, NotSeconds> {
    text.parse().ok().filter(|s: &f64| *s > 0.0 && *s <= 86400.0).ok_or(NotSeconds)
}

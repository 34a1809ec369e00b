//! `isoracle spline`.

use super::interpolant::{self, BoundaryRule, Grid};
use super::{points, progress};
use clap::{Args, Subcommand};
use isoracle::curvature::jet::Jet;
use isoracle::format::{FormatError, GridRecord, Samples, write_grid};
use isoracle::number::text;
use miette::Diagnostic;
use std::io::{self, BufWriter, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use thiserror::Error;

/// Interpolate samples by a cubic spline: its coefficients, and its values and derivatives at points.
///
/// Sample k of an axis stands at k. Each number is the binary64 nearest to the exact one, or with --exact the rational itself.
#[derive(Args)]
#[command(after_help = AFTER_HELP, arg_required_else_help = true)]
pub struct SplineCommand {
    #[command(subcommand)]
    what: What,
}

const AFTER_HELP: &str = "\
Examples:
  $ isoracle spline coefficients signal.npy --out coefficients.npy
  $ isoracle spline coefficients signal.txt --exact --boundary periodic
  $ echo '1/2' | isoracle spline evaluate signal.txt --points - --derivatives ,x,xx";

#[derive(Subcommand)]
enum What {
    Coefficients(Coefficients),
    Evaluate(Evaluate),
}

/// What both are told.
#[derive(Args)]
struct Source {
    /// The samples: a .npy file of one to three axes, a .nrrd or .nhdr file, or a .txt file of numbers for one axis.
    #[arg(value_name = "SIGNAL")]
    signal: PathBuf,
    /// How the samples go on beyond the grid.
    #[arg(long, value_enum, default_value_t = BoundaryRule::Mirror)]
    boundary: BoundaryRule,
    /// Rationals; at most 524,288 samples.
    #[arg(long)]
    exact: bool,
}

/// The coefficients c with f(x) = Σ c[k] B₃(x − k), the first axis fastest.
#[derive(Args)]
struct Coefficients {
    #[command(flatten)]
    source: Source,
    /// Where to write them: a .npy file, or a .nrrd file of three axes; else a line each on stdout.
    #[arg(long, value_name = "FILE", conflicts_with = "exact")]
    out: Option<PathBuf>,
}

/// The value and derivatives at points.
#[derive(Args)]
struct Evaluate {
    #[command(flatten)]
    source: Source,
    /// A file with a point a line, its coordinates between blanks or commas; `-` for stdin.
    #[arg(long, value_name = "FILE")]
    points: PathBuf,
    /// Derivatives, as words of at most two of the letters x, y, z, between commas; the empty word is the value.
    #[arg(long, value_name = "WORDS", default_value = "", value_delimiter = ',')]
    derivatives: Vec<String>,
}

#[derive(Debug, Error, Diagnostic)]
enum Failure {
    #[error("--out: {0}")]
    #[diagnostic(help("the coefficients could not be written"))]
    Out(FormatError),
    #[error("--derivatives: {word:?} is no word of at most two of the first {axes} of the letters x, y, z")]
    #[diagnostic(help("a value, first and second derivatives: `,x,xy,zz`"))]
    Derivative { word: String, axes: usize },
}

impl SplineCommand {
    pub fn run(self) -> miette::Result<ExitCode> {
        match self.what {
            What::Coefficients(command) => command.run(),
            What::Evaluate(command) => command.run(),
        }
    }
}

impl Coefficients {
    fn run(self) -> miette::Result<ExitCode> {
        fn of<const N: usize>(grid: &Grid, command: &Coefficients) -> miette::Result<ExitCode> {
            let spinner = progress::spinner("interpolating".to_owned());
            let boundary = command.source.boundary;
            if command.source.exact {
                let spline = grid.exact::<N>(boundary)?;
                spinner.finish_and_clear();
                return super::to_stdout(lines(spline.coefficients().values().iter().map(text::exact_text)));
            }
            let coefficients = grid.interpolant::<N>(boundary)?.into_coefficients()?;
            spinner.finish_and_clear();
            match &command.out {
                None => super::to_stdout(lines(coefficients.iter().map(f64::to_string))),
                Some(path) => {
                    let count = coefficients.len();
                    let record = GridRecord { shape: grid.shape().to_vec(), samples: Samples::F64(coefficients) };
                    write_grid(path, &record).map_err(Failure::Out)?;
                    eprintln!("{}: {count} coefficients", path.display());
                    Ok(ExitCode::SUCCESS)
                }
            }
        }
        let grid = interpolant::read_grid(&self.source.signal)?;
        match grid.shape().len() {
            1 => of::<1>(&grid, &self),
            2 => of::<2>(&grid, &self),
            _ => of::<3>(&grid, &self),
        }
    }
}

impl Evaluate {
    fn run(self) -> miette::Result<ExitCode> {
        fn of<const N: usize>(grid: &Grid, command: &Evaluate) -> miette::Result<ExitCode> {
            let words = command.derivatives.iter().map(|word| axes::<N>(word)).collect::<Result<Vec<_>, _>>()?;
            let points = points::read::<N>(&command.points)?;
            let spinner = progress::spinner("interpolating".to_owned());
            let boundary = command.source.boundary;
            let rows: Vec<Vec<String>> = if command.source.exact {
                let spline = grid.exact::<N>(boundary)?;
                let jets = points.iter().map(|point| spline.jet(point));
                jets.map(|jet| words.iter().map(|word| text::exact_text(entry(&jet, word))).collect()).collect()
            } else {
                let jets = grid.interpolant::<N>(boundary)?.jets(&points)?;
                jets.iter().map(|jet| words.iter().map(|word| entry(jet, word).to_string()).collect()).collect()
            };
            spinner.finish_and_clear();
            let names = ["x", "y", "z"][..N].iter().map(|axis| (*axis).to_owned());
            let names: Vec<String> = names.chain(command.derivatives.iter().map(|word| format!("f{word}"))).collect();
            let rows = points.iter().zip(&rows).map(|(point, row)| {
                point.iter().map(text::exact_text).chain(row.iter().cloned()).collect::<Vec<_>>().join("\t")
            });
            super::to_stdout(lines(std::iter::once(names.join("\t")).chain(rows)))
        }
        let grid = interpolant::read_grid(&self.source.signal)?;
        match grid.shape().len() {
            1 => of::<1>(&grid, &self),
            2 => of::<2>(&grid, &self),
            _ => of::<3>(&grid, &self),
        }
    }
}

/// The axes of a derivative.
fn axes<const N: usize>(word: &str) -> Result<Vec<usize>, Failure> {
    let axes: Option<Vec<usize>> = word.chars().map(|letter| "xyz"[..N].find(letter)).collect();
    axes.filter(|axes| axes.len() <= 2).ok_or_else(|| Failure::Derivative { word: word.to_owned(), axes: N })
}

/// The value, a first or a second derivative of a jet.
fn entry<'a, K, const N: usize>(jet: &'a Jet<K, N>, axes: &[usize]) -> &'a K {
    match *axes {
        [] => &jet.value,
        [i] => &jet.gradient.0[i],
        [i, j, ..] => &jet.hessian.0[i][j],
    }
}

fn lines(lines: impl Iterator<Item = String>) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    for line in lines {
        writeln!(out, "{line}")?;
    }
    out.flush()
}

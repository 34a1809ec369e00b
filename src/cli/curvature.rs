//! `isoracle curvature`.

use super::curvature_map::{self, Map};
use super::interpolant::{self, BoundaryRule, Curvatures, SurfacePoint, surfaces};
use super::{input, points, progress};
use clap::Args;
use isoracle::answer::curvature::LevelSurfaceOut;
use isoracle::answer::spline::MAX_EXACT_SAMPLES;
use isoracle::curvature::normalize::SlopeError;
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::fast;
use isoracle::isosurface::volume::Level;
use isoracle::number::Rational;
use isoracle::number::decimal::Digits;
use isoracle::number::text;
use isoracle::spline::coherence::{Characteristic, Coherence, CoherenceError, coherence};
use isoracle::spline::prefilter::fast::Enclosed;
use isoracle::spline::prefilter_fast_exact::IntegerSpline;
use isoracle::spline::total_curvature::Effort;
use miette::Diagnostic;
use serde_json::json;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use thiserror::Error;

/// Curvature of the level surfaces of a volume's cubic spline: at points, as the colours of an isosurface, or over a whole one.
///
/// N = +∇f/|∇f|; the principal curvatures k1 ≥ k2 are the eigenvalues of −dN, K = k1·k2, H = (k1 + k2)/2: where f grows outward, a sphere
/// has H < 0. Each number is the binary64 nearest to the exact one. Grid point (i, j, k) lies at (i, j, k).
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Curvature {
    /// The samples: a .npy, .nrrd or .nhdr file.
    #[arg(long, value_name = "FILE")]
    volume: PathBuf,
    /// How the samples go on beyond the grid.
    #[arg(long, value_enum, default_value_t = BoundaryRule::Mirror)]
    boundary: BoundaryRule,
    /// Where: a file with a point a line, its three coordinates between blanks or commas; `-` for stdin.
    #[arg(long, value_name = "FILE", required_unless_present_any = ["map", "total"], conflicts_with_all = ["map", "total"])]
    points: Option<PathBuf>,
    /// Write rationals, and principal curvatures to 30 digits, as `curvature.spline` answers, a line of JSON a point.
    #[arg(long, requires = "points")]
    exact: bool,
    /// c: the isosurface {f = c} that is painted, or whose total curvature is asked for.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, value_parser = text::parse, conflicts_with = "points")]
    isovalue: Option<Rational>,
    /// Compare ∫K dA over the spline's isosurface with 2πχ of the trilinear one, each proved; at most 524,288 samples.
    #[arg(long, requires = "isovalue", conflicts_with = "map")]
    total: bool,
    /// Which curvature the colours stand for: blue is negative, green zero, red positive.
    #[arg(long, value_enum, requires = "isovalue", requires = "out")]
    map: Option<Map>,
    /// The λ of n_λ, which takes curvatures to (0, 1); by default such that the median of |curvature| goes to 3/4 or 1/4.
    #[arg(long, value_name = "NUMBER", value_parser = text::parse, requires = "map")]
    lambda: Option<Rational>,
    /// What to do where c is a critical value: `below` takes c − ε for every small enough ε > 0 instead.
    #[arg(long, value_name = "HOW", requires = "isovalue")]
    tie: Option<input::TieRule>,
    /// Where to write the painted mesh: a .ply file.
    #[arg(long, value_name = "FILE", value_parser = ply_path, requires = "map")]
    out: Option<PathBuf>,
}

const AFTER_HELP: &str = "\
Examples:
  $ printf '10 20 15\\n10.5 20 15\\n' | isoracle curvature --volume head.nrrd --points -
  $ isoracle curvature --volume head.nrrd --points points.txt --exact | jq .gaussian
  $ isoracle curvature --volume head.nrrd --isovalue 60.5 --map gaussian --out head.ply
  $ isoracle curvature --volume crop.npy --isovalue 60.5 --total";

#[derive(Debug, Error, Diagnostic)]
enum Failure {
    #[error("--isovalue: {0}")]
    #[diagnostic(help("the isovalue must be no critical value of either interpolant, nor too near to one"))]
    Total(CoherenceError),
    #[error("--lambda: {0}")]
    #[diagnostic(help("λ is the slope of n_λ, twice that at 0"))]
    Slope(SlopeError),
}

impl Curvature {
    pub fn run(self) -> miette::Result<ExitCode> {
        let spinner = progress::spinner(format!("reading {}", self.volume.display()));
        let volume = input::volume(&self.volume)?;
        let tie = self.tie.map_or(Tie::Degenerate, Tie::from);
        if let (true, Some(isovalue)) = (self.total, &self.isovalue) {
            if volume.len() > MAX_EXACT_SAMPLES {
                return Err(interpolant::Failure::TooManySamples { samples: volume.len() }.into());
            }
            spinner.set_message("integrating");
            let level = Level { volume: &volume, isovalue: isovalue.clone(), tie };
            let effort = Effort { width: 1.0 / 16.0, depth: 4 };
            let found = coherence(&level, self.boundary.into(), effort).map_err(Failure::Total)?;
            spinner.finish_and_clear();
            return super::to_stdout(write_total(&found));
        }
        if let (Some(map), Some(isovalue), Some(out)) = (self.map, &self.isovalue, &self.out) {
            if let Some(slope) = self.lambda.as_ref().filter(|slope| **slope <= 0) {
                let error = SlopeError(slope.clone());
                return Err(Failure::Slope(error).into());
            }
            let level = Level { volume: &volume, isovalue: isovalue.clone(), tie };
            spinner.set_message("meshing");
            let mesh = fast::extract(&level).map_err(input::CriticalIsovalue)?;
            spinner.set_message("working out curvatures");
            let samples = volume.binary64s().ok_or(interpolant::Failure::NotBinary64)?;
            let enclosed =
                Enclosed::new(&samples, volume.shape(), self.boundary.into()).map_err(interpolant::Failure::Fast)?;
            let painted = curvature_map::paint(&level, &mesh, &enclosed, map, self.lambda.as_ref())?;
            painted.write(out)?;
            spinner.finish_and_clear();
            eprintln!("{}: {}", out.display(), painted.summary());
            return Ok(ExitCode::SUCCESS);
        }
        let path = self.points.as_deref().expect("it is required without --map");
        let points = points::read(path)?;
        spinner.set_message("interpolating");
        if self.exact {
            let spline = interpolant::exact(&volume, self.boundary)?;
            spinner.finish_and_clear();
            return super::to_stdout(write_exact(&spline, &points));
        }
        let samples = volume.binary64s().ok_or(interpolant::Failure::NotBinary64)?;
        let enclosed =
            Enclosed::new(&samples, volume.shape(), self.boundary.into()).map_err(interpolant::Failure::Fast)?;
        let surfaces = surfaces(&enclosed, &points)?;
        spinner.finish_and_clear();
        super::to_stdout(write(&points, &surfaces))
    }
}

/// A line a point; where the gradient is zero there are no curvatures.
fn write(points: &[[Rational; 3]], surfaces: &[SurfacePoint]) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    writeln!(out, "x\ty\tz\tf\tfx\tfy\tfz\tK\tH\tk1\tk2")?;
    for (point, SurfacePoint { value, gradient: [fx, fy, fz], curvatures }) in points.iter().zip(surfaces) {
        let [x, y, z] = point.each_ref().map(text::exact_text);
        write!(out, "{x}\t{y}\t{z}\t{value}\t{fx}\t{fy}\t{fz}\t")?;
        match curvatures {
            Some(Curvatures { gaussian, mean, principal: [k1, k2] }) => {
                writeln!(out, "{gaussian}\t{mean}\t{k1}\t{k2}")?
            }
            None => writeln!(out, "singular\tsingular\tsingular\tsingular")?,
        }
    }
    out.flush()
}

/// The three quantities, and whether they agree.
fn write_total(found: &Coherence) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    let turns = |c: &Characteristic| text::exact_text(&Rational::from((c.quarter_turns(), 2)));
    let (spline, trilinear) = (&found.spline, &found.trilinear);
    writeln!(
        out,
        "spline's isosurface      χ = {}, edge crossings {}, ∫K dA = {}π",
        spline.chi,
        spline.edge_crossings,
        turns(spline)
    )?;
    let width = found.quadrature.integral.hi() - found.quadrature.integral.lo();
    // Where the gradient nearly vanishes, K has bounds so far apart that their sum says nothing.
    let quadrature =
        if width < 1000.0 { found.quadrature_text() } else { "an enclosure wider than 1000, of no use".to_owned() };
    writeln!(out, "  by quadrature          {quadrature}")?;
    writeln!(
        out,
        "trilinear isosurface     χ = {}, edge crossings {}, 2πχ less corners = {}π",
        trilinear.chi,
        trilinear.edge_crossings,
        turns(trilinear)
    )?;
    writeln!(out, "  K of the spline on it  {}", found.mesh_sum_text())?;
    writeln!(out, "{}", if found.is_coherent() { "the two agree" } else { "the two differ" })?;
    out.flush()
}

/// What `curvature.spline` answers at each point.
fn write_exact(spline: &IntegerSpline<3>, points: &[[Rational; 3]]) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    for point in points {
        let at = point.each_ref().map(text::exact_text);
        let mut line = json!({"point": at});
        match LevelSurfaceOut::new(&spline.jet(point), Digits::default()) {
            Ok(surface) => {
                let fields = serde_json::to_value(surface)?;
                let fields =
                    fields.as_object().into_iter().flatten().map(|(name, value)| (name.clone(), value.clone()));
                line.as_object_mut().expect("a line is an object").extend(fields);
            }
            Err(singular) => line["error"] = json!({"kind": "degenerate", "message": singular.to_string()}),
        }
        writeln!(out, "{line}")?;
    }
    out.flush()
}

#[derive(Debug, Error)]
#[error("a painted mesh is written as .ply")]
struct NotPly;

/// The extension is checked before the work begins.
fn ply_path(text: &str) -> Result<PathBuf, NotPly> {
    let path = PathBuf::from(text);
    let is_ply = Path::new(text).extension().is_some_and(|extension| extension.eq_ignore_ascii_case("ply"));
    if is_ply { Ok(path) } else { Err(NotPly) }
}

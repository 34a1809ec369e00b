//! `isoracle complex`.

use super::complex_page::Page;
use super::progress;
use clap::{Args, value_parser};
use isoracle::answer::scheme_file::{self, SchemeFileError};
use isoracle::complex::check;
use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::flag::Flag;
use isoracle::complex::gluing_table::GluingTable;
use isoracle::complex::isosig_fast as isosig;
use isoracle::complex::realise::intersections::Intersections;
use isoracle::complex::realise::mesh::{NotSimplicial, TetrahedralMesh};
use isoracle::complex::realise::{self, Options, RealiseError, Realised};
use isoracle::complex::refine::{LatticePoint, RefineError, Refinement, fast, small_tetrahedra};
use isoracle::complex::scheme::GluingScheme;
use isoracle::complex::tetrahedra::DUAL;
use isoracle::complex::triangulation::Triangulation;
use isoracle::complex::zoo;
use isoracle::format::FormatError;
use isoracle::format::snappea::{self, SnapPeaRecord};
use isoracle::picture::scene::COLOURS;
use isoracle::picture::{self, Paint};
use miette::Diagnostic;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use thiserror::Error;

/// Glue polyhedra face to face: every invariant of the closed 3-manifold, or the reason why it is none.
///
/// A scheme is polyhedra by their edges and faces, and which faces are glued how. Its space is cut into topological tetrahedra, one
/// for each pair of a face and an edge of it, and these into k³ each.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Complex {
    /// A file, as text or as the JSON of `complex.glue`; `-` for stdin; or the name of an example, which `--list` shows.
    #[arg(value_name = "SCHEME", required_unless_present = "list")]
    scheme: Option<String>,
    /// List the examples by name, with the space and its H₁.
    #[arg(long)]
    list: bool,
    /// Cut each topological tetrahedron into K³.
    #[arg(long, value_name = "K", value_parser = value_parser!(u32).range(1..))]
    refine: Option<u32>,
    /// Write JSON in the protocol's terms: what `complex.glue` answers, and more.
    #[arg(long)]
    json: bool,
    /// Where to write the tetrahedra: .tri (SnapPea), .isosig, .gluings (a table), .scheme (the scheme itself as text); placed in space
    /// with --realise: .ply .vtu .gltf .msh .svg .html.
    #[arg(long, value_name = "FILE", value_parser = out_path)]
    out: Option<PathBuf>,
    /// Place the vertices in ℝ⁴ so that edges are alike and little is bent, and project them to ℝ³.
    #[arg(long, requires = "out")]
    realise: bool,
    /// The dimension that vertices are placed in.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = value_parser!(u32).range(3..=6), requires = "realise")]
    dimension: u32,
    /// What chooses among equally good starts; the same seed gives the same result.
    #[arg(long, value_name = "N", default_value_t = 1, requires = "realise")]
    seed: u64,
    /// The most steps of the minimisation.
    #[arg(long, value_name = "N", default_value_t = 300, requires = "realise")]
    iterations: usize,
}

const AFTER_HELP: &str = "\
Exit codes: 0 a closed 3-manifold, 1 none, for the reasons given, 2 the file or the command line cannot be used.

Examples:
  $ isoracle complex --list
  $ isoracle complex T3 --refine 4
  $ isoracle complex scheme.txt --json | jq .homology.h1
  $ isoracle complex T3 --out torus.isosig
  $ isoracle complex T3 --refine 6 --realise --out torus.html";

#[derive(Debug, Error, Diagnostic)]
enum Failure {
    #[error("{name}: {error}")]
    #[diagnostic(help("a scheme is a file, or the name of an example; `isoracle complex --list` shows them"))]
    NoSuchScheme { name: String, error: io::Error },
    #[error("{name}: {error}")]
    #[diagnostic(help("`isoracle complex T3 --out t3.scheme` writes an example of the format"))]
    Unreadable { name: String, error: SchemeFileError },
    #[error("--refine: {0}")]
    #[diagnostic(help("each of the t topological tetrahedra is cut into K³"))]
    Refine(RefineError),
    #[error("--realise: {0}")]
    #[diagnostic(help("the vertices could not be placed"))]
    Realise(RealiseError),
    #[error("--out: {0}")]
    #[diagnostic(help("the file could not be written"))]
    Out(FormatError),
    #[error("--out: {}: {error}", .path.display())]
    #[diagnostic(help("the file could not be written"))]
    Write { path: PathBuf, error: io::Error },
    #[error("--out: {}: a .{} file shows the tetrahedra placed in space", .path.display(), .extension)]
    #[diagnostic(help("add --realise; .tri, .isosig, .gluings and .scheme need no places"))]
    NotPlaced { path: PathBuf, extension: &'static str },
    #[error("--out: {}: a .{} file has no places", .path.display(), .extension)]
    #[diagnostic(help("--realise writes .ply, .vtu, .gltf, .msh, .svg or .html"))]
    Placed { path: PathBuf, extension: &'static str },
    #[error(
        "--out: {tetrahedra} tetrahedra are too many for a signature, which takes the square of their number in steps"
    )]
    #[diagnostic(help("at most 20,000; .gluings and .tri have no limit"))]
    TooManyToSign { tetrahedra: usize },
}

/// The most tetrahedra of which a signature is written.
const MAX_SIGNED: usize = 20_000;

/// The files that `--out` writes.
const COMBINATORIAL: [&str; 4] = ["tri", "isosig", "gluings", "scheme"];
const PLACED: [&str; 6] = ["ply", "vtu", "gltf", "msh", "svg", "html"];

impl Complex {
    pub fn run(self) -> miette::Result<ExitCode> {
        if self.list {
            return super::to_stdout(list(io::stdout().lock()));
        }
        let name = self.scheme.as_deref().expect("it is required without --list");
        self.check_out()?;
        let known = if Path::new(name).exists() { None } else { example(name) };
        let (about, scheme) = match known {
            Some((about, scheme)) => (Some(about), scheme),
            None => (None, read(name)?),
        };
        let mut page = Page::of(name.to_owned(), about, scheme);
        if page.defects.is_empty() {
            self.refine(&mut page)?;
        }
        let sound = page.defects.is_empty();
        super::to_stdout(self.write(&page))?;
        if !sound && self.out.is_some() {
            eprintln!("nothing was written: there is no 3-manifold");
        }
        Ok(if sound { ExitCode::SUCCESS } else { ExitCode::from(1) })
    }

    fn write(&self, page: &Page) -> io::Result<()> {
        let mut out = io::BufWriter::new(io::stdout().lock());
        if self.json {
            serde_json::to_writer(&mut out, &page.json())?;
            writeln!(out)?;
        } else {
            page.write_text(&mut out)?;
        }
        out.flush()
    }

    /// What is told about `--out` before the work begins.
    fn check_out(&self) -> Result<(), Failure> {
        let Some(path) = self.out.clone() else { return Ok(()) };
        let known = |names: &[&'static str]| names.iter().copied().find(|name| *name == extension(&path));
        match (known(&PLACED), known(&COMBINATORIAL), self.realise) {
            (Some(extension), _, false) => Err(Failure::NotPlaced { path, extension }),
            (_, Some(extension), true) => Err(Failure::Placed { path, extension }),
            _ => Ok(()),
        }
    }

    /// Refines the manifold on the page, writes what is asked for, and puts down what came of it.
    fn refine(&self, page: &mut Page) -> Result<(), Failure> {
        let Some(complex) = &page.complex else { return Ok(()) };
        let spinner = progress::spinner("refining".to_owned());
        let refined = fast::refine(&complex.tetrahedra(), self.refine.unwrap_or(1)).map_err(Failure::Refine)?;
        if let Some(order) = self.refine {
            spinner.set_message("counting");
            page.refinement = Some((order, check::fast::check(refined.triangulation())));
        }
        if let Some(path) = &self.out {
            if self.realise {
                spinner.set_message("placing the vertices");
                let realised = self.realised(&refined)?;
                picture::write(path, &realised, &paint(&page.name, complex, &refined)).map_err(Failure::Out)?;
                page.more.push(realisation(&realised));
            } else {
                self.write_combinatorial(path, page, refined.triangulation())?;
            }
        }
        spinner.finish_and_clear();
        Ok(())
    }

    fn realised(&self, refined: &Refinement) -> Result<Realised, Failure> {
        let options = Options {
            dimension: self.dimension as usize,
            seed: self.seed,
            iterations: self.iterations,
            ..Options::default()
        };
        realise::realise(&TetrahedralMesh::of(refined.triangulation()), &options).map_err(Failure::Realise)
    }

    fn write_combinatorial(&self, path: &Path, page: &Page, triangulation: &Triangulation) -> Result<(), Failure> {
        let write =
            |text: String| fs::write(path, text).map_err(|error| Failure::Write { path: path.to_owned(), error });
        match extension(path).as_str() {
            "isosig" if triangulation.len() > MAX_SIGNED => {
                Err(Failure::TooManyToSign { tetrahedra: triangulation.len() })
            }
            "isosig" => write(isosig::signature(triangulation) + "\n"),
            "gluings" => write(GluingTable(triangulation).to_string()),
            "scheme" => write(scheme_file::write(&page.scheme)),
            _ => {
                let record = SnapPeaRecord::of_rows(&page.name, triangulation.rows());
                let mut bytes = Vec::new();
                snappea::write(&mut bytes, &record).expect("memory can be written");
                write(String::from_utf8(bytes).expect("the format is text"))
            }
        }
    }
}

/// The example of that name, manifold or not, and what it is.
fn example(name: &str) -> Option<(String, GluingScheme)> {
    let manifold = zoo::get(name).map(|specimen| (format!("{}: {}", specimen.space, specimen.about), specimen.scheme));
    manifold.or_else(|| zoo::invalid::get(name).map(|broken| (broken.about.to_owned(), broken.scheme)))
}

/// A name, the space, H₁; then those that are no manifolds.
fn list(mut out: impl Write) -> io::Result<()> {
    for specimen in zoo::names().into_iter().filter_map(zoo::get) {
        let sides = if specimen.orientable { "orientable" } else { "not orientable" };
        writeln!(out, "{:<28} {}; {sides}, H₁ = {}", specimen.name, specimen.space, specimen.h1)?;
    }
    for broken in zoo::invalid::all() {
        writeln!(out, "{:<28} no manifold, {}; {}", broken.name, broken.defect.reason().name(), broken.about)?;
    }
    out.flush()
}

fn read(name: &str) -> Result<GluingScheme, Failure> {
    let mut bytes = Vec::new();
    match name {
        "-" => io::stdin().lock().read_to_end(&mut bytes).map(drop),
        _ => fs::read(name).map(|read| bytes = read),
    }
    .map_err(|error| Failure::NoSuchScheme { name: name.to_owned(), error })?;
    scheme_file::read(&bytes).map_err(|error| Failure::Unreadable { name: name.to_owned(), error })
}

/// Tetrahedra coloured by the polyhedron that they lie in most, or, of a single polyhedron or of many, by the edge that they stand
/// around; the edges of the complex drawn as lines.
fn paint(name: &str, complex: &ClosedComplex, refined: &Refinement) -> Paint {
    let k = refined.order();
    let flags = complex.tetrahedron_flags();
    let small = small_tetrahedra(k);
    let polyhedra = complex.counts()[3];
    let by_polyhedron = (2..=COLOURS.len()).contains(&polyhedra);
    let group = |flag: Flag, corners: &[LatticePoint; 4]| {
        let weight = |corner: usize| corners.iter().map(|point| point[corner]).sum::<u32>();
        let [on_this_side, beyond] = DUAL.map(weight);
        match by_polyhedron {
            true if on_this_side >= beyond => complex.cell(3, flag),
            true => complex.cell(3, complex.flags().sigma(3, flag)),
            false => complex.cell(1, flag),
        }
    };
    let (what, count) = if by_polyhedron { ("in polyhedron", polyhedra) } else { ("around edge", complex.counts()[1]) };
    let names = (0..count).map(|i| format!("{what} {i}")).collect();
    let point =
        |tetrahedron: usize, i: u32| refined.vertex(tetrahedron, [k - i, i, 0, 0]).expect("a point of the edge");
    let lines = (0..flags.len()).flat_map(|t| (0..k).map(move |i| [point(t, i), point(t, i + 1)]));
    Paint {
        title: format!("{name}, refined to order {k}"),
        groups: flags.iter().flat_map(|flag| small.iter().map(|corners| group(*flag, corners))).collect(),
        // More than there are colours would say nothing.
        names: if count <= COLOURS.len() { names } else { Vec::new() },
        lines: lines.collect::<BTreeSet<_>>().into_iter().collect(),
    }
}

/// What the placement is, as a line of text and as JSON.
fn realisation(realised: &Realised) -> (String, Value) {
    let (n, lengths) = (realised.points.dimension(), realised.lengths);
    let [first, last] = [realised.energies.first(), realised.energies.last()].map(|e| e.copied().unwrap_or(0.0));
    let Intersections { not_simplicial, flat, pairs, .. } = &realised.intersections;
    let embedded = match (not_simplicial, realised.intersections.is_embedded()) {
        (_, true) => "yes: tetrahedra meet in common triangles, edges and vertices only, decided exactly".to_owned(),
        (Some(NotSimplicial::VertexTwice { .. }), false) => {
            "no: a tetrahedron has a vertex twice, so the refinement is no simplicial complex".to_owned()
        }
        (Some(NotSimplicial::SameVertices { .. }), false) => {
            "no: two simplices have the same vertices, so the refinement is no simplicial complex".to_owned()
        }
        (None, false) => {
            format!("no: {pairs} pairs of tetrahedra meet outside their common part, {flat} tetrahedra are flat")
        }
    };
    let text = format!(
        "placed in ℝ{}\n  energy                 {first:.4} to {last:.4} in {} steps\n  lengths of edges       {:.3} to {:.3}, mean {:.3}\n  embedded               {embedded}",
        ["³", "⁴", "⁵", "⁶"].get(n - 3).expect("from 3 to 6"),
        realised.energies.len().saturating_sub(1),
        lengths.min,
        lengths.max,
        lengths.mean,
    );
    let json = json!({"realisation": {
        "dimension": n,
        "energy": [first, last],
        "steps": realised.energies.len().saturating_sub(1),
        "lengths": {"min": lengths.min, "mean": lengths.mean, "max": lengths.max},
        "embedded": realised.intersections.is_embedded(),
        "intersecting_pairs": pairs,
    }});
    (text, json)
}

#[derive(Debug, Error)]
#[error(
    "tetrahedra are written as .tri, .isosig or .gluings, a scheme as .scheme, and with --realise as .ply, .vtu, .gltf, .msh, .svg or .html"
)]
struct NotAnOutput;

/// The extension is checked before the work begins.
fn out_path(text: &str) -> Result<PathBuf, NotAnOutput> {
    let path = PathBuf::from(text);
    let known = COMBINATORIAL.iter().chain(&PLACED).any(|known| *known == extension(&path));
    if known { Ok(path) } else { Err(NotAnOutput) }
}

fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default()
}

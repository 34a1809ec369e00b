//! `isoracle check`.

use super::check_mesh::Mesh;
use super::{input, progress};
use clap::{Args, Subcommand};
use isoracle::format::{self, FormatError};
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::fast;
use isoracle::isosurface::volume::{DegenerateCell, Level, Volume};
use isoracle::judge::isosurface::candidate_mesh::{CandidateMesh, from_record};
use isoracle::judge::isosurface::fault::Fault;
use isoracle::judge::isosurface::place::Tolerance;
use isoracle::judge::isosurface::tie::judge_tied;
use isoracle::judge::isosurface::verdict::{self, Verdict, mesh_components};
use isoracle::number::Rational;
use isoracle::number::text;
use miette::Diagnostic;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;
use thiserror::Error;

/// Check an output file: is it what it is meant to be?
#[derive(Args)]
pub struct Check {
    #[command(subcommand)]
    what: What,
}

#[derive(Subcommand)]
enum What {
    Isosurface(Isosurface),
    Mesh(Mesh),
}

/// Check a mesh as the isosurface {f = c} of a volume, cell by cell and as a whole.
///
/// The first wrong cells are named. Where c is a critical value of the volume, the surfaces of c − ε and c + ε
/// are both right, one of them throughout.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
struct Isosurface {
    /// The samples: a .npy, .nrrd or .nhdr file.
    #[arg(long, value_name = "FILE")]
    volume: PathBuf,
    /// c, exactly: 40, -1/3, 0.1 (one tenth, not the binary64 nearest to it), 0x1.8p-3.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, value_parser = text::parse)]
    isovalue: Rational,
    /// The mesh, in grid coordinates: a .ply, .obj, .stl or .off file.
    #[arg(long, value_name = "FILE")]
    mesh: PathBuf,
    /// How far a vertex may be from the true crossing, in units in the last place of binary32.
    #[arg(long, value_name = "ULP", default_value_t = Tolerance::default().0)]
    max_ulp: f64,
    /// How many faults to name.
    #[arg(long, value_name = "N", default_value_t = 10)]
    show: usize,
}

const AFTER_HELP: &str = "\
Exit codes: 0 the mesh is the isosurface, 1 it is not, 2 a file cannot be used.

Example:
  $ isoracle check isosurface --volume head.nrrd --isovalue 60.5 --mesh theirs.ply";

#[derive(Debug, Error, Diagnostic)]
enum Failure {
    #[error("--mesh: {0}")]
    #[diagnostic(help("a mesh is a .ply, .obj, .stl or .off file"))]
    Mesh(FormatError),
    #[error("--mesh: a face with {0} corners")]
    #[diagnostic(help("an isosurface mesh is made of triangles"))]
    NotTriangles(usize),
}

impl Check {
    pub fn run(self) -> miette::Result<ExitCode> {
        match self.what {
            What::Isosurface(check) => check.run(),
            What::Mesh(check) => check.run(),
        }
    }
}

impl Isosurface {
    fn run(self) -> miette::Result<ExitCode> {
        let start = Instant::now();
        let spinner = progress::spinner(format!("reading {}", self.volume.display()));
        let volume = input::volume(&self.volume)?;
        let record = format::read_mesh(&self.mesh).map_err(Failure::Mesh)?;
        let corners = record.faces.iter().map(Vec::len).find(|&n| n != 3).unwrap_or(3);
        let mesh = from_record(record).map_err(|_| Failure::NotTriangles(corners))?;
        spinner.set_message(format!("checking {} triangles", mesh.triangles.len()));
        let (verdict, tie) = judge(&volume, &self.isovalue, &mesh, Tolerance(self.max_ulp));
        spinner.finish_and_clear();
        self.print(&verdict, tie.as_ref(), &mesh);
        println!("{:.2} s", start.elapsed().as_secs_f64());
        Ok(if verdict.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::from(1) })
    }

    fn print(&self, verdict: &Verdict, tie: Option<&DegenerateCell>, mesh: &CandidateMesh) {
        let components = mesh_components_text(mesh, verdict);
        println!(
            "{}: {} vertices, {} triangles{components}",
            self.mesh.display(),
            mesh.positions.len(),
            mesh.triangles.len()
        );
        if let Some(tie) = tie {
            println!(
                "note: the isovalue is a critical value ({tie}); the surfaces just below and just above are both right"
            );
        }
        if verdict.welded {
            println!("note: vertices at equal positions were taken for one");
        }
        println!(
            "largest position error on a grid edge: {:.3} ulp (binary64), {:.3} ulp (binary32)",
            verdict.error.binary64_ulp, verdict.error.binary32_ulp
        );
        if verdict.faults.is_empty() {
            println!(
                "right: the mesh is the isosurface {{f = {}}} of {}",
                text::exact_text(&self.isovalue),
                self.volume.display()
            );
            return;
        }
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for fault in &verdict.faults {
            *counts.entry(fault.name()).or_default() += 1;
        }
        println!("wrong: {} faults", verdict.faults.len());
        for (name, count) in counts {
            println!("  {count:8} {name}");
        }
        println!("the first of them:");
        for fault in verdict.faults.iter().take(self.show) {
            println!("  [{}] {fault}", fault.formula());
            if let Some(difference) = fault.difference() {
                println!(
                    "      {}: expected {}, found {}",
                    difference.invariant, difference.expected, difference.found
                );
            }
        }
    }
}

/// The verdict, and where the isovalue is a critical value.
fn judge(
    volume: &Volume,
    isovalue: &Rational,
    mesh: &CandidateMesh,
    tolerance: Tolerance,
) -> (Verdict, Option<DegenerateCell>) {
    let level = Level { volume, isovalue: isovalue.clone(), tie: Tie::Degenerate };
    match fast::regular(&level).and_then(|()| verdict::judge(&level, mesh, tolerance)) {
        Ok(verdict) => (verdict, None),
        Err(tie) => {
            let verdict =
                judge_tied(volume, isovalue, mesh, tolerance).expect("both sides of a tie are decided (IS-86)");
            (verdict, Some(tie))
        }
    }
}

fn mesh_components_text(mesh: &CandidateMesh, verdict: &Verdict) -> String {
    if verdict.faults.iter().any(|fault| matches!(fault, Fault::Defect(_))) {
        return String::new();
    }
    let components = mesh_components(mesh);
    let chi: i64 = components.iter().map(|c| c.chi).sum();
    let loops: i64 = components.iter().map(|c| c.boundary_loops).sum();
    format!(", {} components, χ = {chi}, {loops} boundary loops", components.len())
}

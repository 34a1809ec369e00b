//! `isoracle isosurface`.

use super::{input, progress};
use clap::Args;
use isoracle::answer::mesh::record;
use isoracle::format::{self, FormatError};
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::fast::{self, Mismatch};
use isoracle::isosurface::volume::Level;
use isoracle::number::Rational;
use isoracle::number::text;
use miette::Diagnostic;
use std::path::PathBuf;
use std::process::ExitCode;
use thiserror::Error;

/// Mesh the isosurface {f = c} of a volume: homeomorphic to it, vertices on grid edges correctly rounded.
///
/// f is the piecewise trilinear function of the samples. The mesh is a 2-manifold whose boundary lies on the
/// border of the grid, with its normals toward f > c; grid point (i, j, k) lies at (i, j, k).
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Isosurface {
    /// The samples: a .npy, .nrrd or .nhdr file.
    #[arg(long, value_name = "FILE")]
    volume: PathBuf,
    /// c, exactly: 40, -1/3, 0.1 (one tenth, not the binary64 nearest to it), 0x1.8p-3.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, value_parser = text::parse)]
    isovalue: Rational,
    /// Where to write the mesh: a .ply, .obj or .stl file. STL has binary32 positions alone.
    #[arg(long, value_name = "FILE", value_parser = mesh_path)]
    out: PathBuf,
    /// Decide one in N cells a second time, by the plain version, and fail if any differs; 0 for none.
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    audit: u64,
    /// What to do where c is a critical value: `below` takes c − ε for every small enough ε > 0 instead.
    #[arg(long, value_name = "HOW")]
    tie: Option<input::TieRule>,
}

const AFTER_HELP: &str = "\
Examples:
  $ isoracle isosurface --volume head.nrrd --isovalue 60.5 --out head.ply
  $ isoracle isosurface --volume head.nrrd --isovalue 60 --tie below --out head.stl";

#[derive(Debug, Error, Diagnostic)]
enum Failure {
    #[error("audit: {0}")]
    #[diagnostic(help("nothing was written; a mesh that cannot be trusted is worse than none"))]
    Audit(Mismatch),
    #[error("--out: {0}")]
    #[diagnostic(help("the mesh could not be written"))]
    Out(FormatError),
}

impl Isosurface {
    pub fn run(self) -> miette::Result<ExitCode> {
        let spinner = progress::spinner(format!("reading {}", self.volume.display()));
        let volume = input::volume(&self.volume)?;
        tracing::info!(shape = ?volume.shape(), "read {}", self.volume.display());
        let tie = self.tie.map_or(Tie::Degenerate, Tie::from);
        let level = Level { volume: &volume, isovalue: self.isovalue, tie };
        let cells: usize = volume.shape().iter().map(|n| n - 1).product();
        spinner.set_message(format!("meshing {cells} cells"));
        let mesh = fast::extract(&level).map_err(input::CriticalIsovalue)?;
        if self.audit > 0 {
            spinner.set_message("auditing".to_owned());
            let audited = fast::audit(&level, self.audit, mesh.triangles.len() as u64).map_err(Failure::Audit)?;
            tracing::info!(audited, "cells decided twice, alike");
        }
        spinner.set_message(format!("writing {}", self.out.display()));
        let record = record(&mesh, &level);
        format::write_mesh(&self.out, &record).map_err(Failure::Out)?;
        spinner.finish_and_clear();
        let (vertices, triangles) = (record.vertices.len(), record.faces.len());
        eprintln!("{}: {vertices} vertices, {triangles} triangles", self.out.display());
        Ok(ExitCode::SUCCESS)
    }
}

#[derive(Debug, Error)]
#[error("a mesh is written as .ply, .obj or .stl")]
struct NotAMeshFile;

/// The extension is checked before the work begins.
fn mesh_path(text: &str) -> Result<PathBuf, NotAMeshFile> {
    let path = PathBuf::from(text);
    let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
    match extension.as_deref() {
        Some("ply" | "obj" | "stl") => Ok(path),
        Some(_) | None => Err(NotAMeshFile),
    }
}

//! `isoracle demo`.

use super::judge::{self, write_report};
use super::progress;
use clap::Args;
use isoracle::answer::mesh::record;
use isoracle::format::{self, Limits, nrrd};
use isoracle::isosurface::cell::Tie;
use isoracle::isosurface::fast;
use isoracle::isosurface::topology::GridTopology;
use isoracle::isosurface::volume::{Level, Volume};
use isoracle::judge::candidate::Process;
use isoracle::judge::html::{Block, Section};
use isoracle::judge::isosurface::Isosurface;
use isoracle::judge::isosurface::builtin::Builtin;
use isoracle::judge::isosurface::candidate_mesh::{CandidateMesh, Positions, from_record};
use isoracle::judge::isosurface::place::Tolerance;
use isoracle::judge::isosurface::verdict::{self, Verdict, mesh_components};
use isoracle::judge::report::Report;
use isoracle::judge::run;
use isoracle::judge::svg::surface_picture;
use isoracle::number::Rational;
use miette::IntoDiagnostic;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Judge the table of 1987, then mesh and check a real surface: a crop of the MNI152 head, at 127/2.
#[derive(Args)]
pub struct Demo {
    /// Where to write report.html, report.json, report.xml and head.ply.
    #[arg(long, value_name = "FOLDER", default_value = "demo-report")]
    out: PathBuf,
}

const HEAD: &[u8] = include_bytes!("../../data/mni152_crop.nrrd");

impl Demo {
    pub fn run(self) -> miette::Result<ExitCode> {
        let start = Instant::now();
        std::fs::create_dir_all(&self.out).into_diagnostic()?;
        let report = judge_classic()?;
        let (section, sentence) = real_surface(&self.out)?;
        write_report(&report, &self.out, &[section])?;
        let right = report.cases.iter().filter(|row| row.passed == row.asked).count();
        println!(
            "The table of 1987 is right in {right} of the {} cases; {} ways of failing found, each with its smallest cell.",
            report.cases.len(),
            report.failures.len()
        );
        println!("{sentence}");
        println!("Report: {} ({:.1} s)", self.out.join("report.html").display(), start.elapsed().as_secs_f64());
        Ok(ExitCode::SUCCESS)
    }
}

fn judge_classic() -> miette::Result<Report> {
    let own = std::env::current_exe().into_diagnostic()?;
    let command = [own.display().to_string(), "candidate".into(), "classic".into()];
    let mut candidate = Process::new(command.into(), Duration::from_secs(10));
    let suite = Isosurface { seed: 1, cases: 100, tolerance: Tolerance::default() };
    let bar = progress::bar("judging the table of 1987");
    let report = run::run(&mut candidate, &suite, |done, of| {
        bar.set_length(of as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    let mut report = report.map_err(judge::Failure::NoHello)?;
    // Paths of this machine say nothing to whoever reads the report.
    for text in report.failures.iter_mut().map(|f| &mut f.command).chain(&mut report.candidate.command) {
        *text = text.replace(&own.display().to_string(), "isoracle");
    }
    Ok(report)
}

/// Meshes the head, writes the mesh, reads it back and checks it, and the classic one beside it.
fn real_surface(out: &Path) -> miette::Result<(Section, String)> {
    let volume = nrrd::read(HEAD, &Limits::default()).into_diagnostic()?;
    let volume = Volume::try_from(volume).into_diagnostic()?;
    let level = Level { volume: &volume, isovalue: Rational::from((127, 2)), tie: Tie::Below };
    let spinner = progress::spinner("meshing and checking the head".into());
    let start = Instant::now();
    let mesh = fast::extract(&level).into_diagnostic()?;
    let seconds = start.elapsed().as_secs_f64();
    let path = out.join("head.ply");
    format::write_mesh(&path, &record(&mesh, &level)).into_diagnostic()?;
    let ours = from_record(format::read_mesh(&path).into_diagnostic()?).into_diagnostic()?;
    let (positions, triangles) = Builtin::Classic.mesh(&level).into_diagnostic()?;
    let theirs = CandidateMesh { positions: Positions::Floats(positions), triangles };
    let judged = |mesh| verdict::judge(&level, mesh, Tolerance::default()).into_diagnostic();
    let (right, wrong) = (judged(&ours)?, judged(&theirs)?);
    let topology = fast::topology(&level).into_diagnostic()?;
    spinner.finish_and_clear();
    let word = if right.faults.is_empty() { "checked right" } else { "checked WRONG" };
    let sentence = format!(
        "A crop of the MNI152 head at 127/2: {} triangles in {seconds:.2} s, {word} cell by cell; the table of 1987 makes {} faults there.",
        ours.triangles.len(),
        wrong.faults.len()
    );
    Ok((section(&volume, &topology, [(&ours, &right), (&theirs, &wrong)]), sentence))
}

fn section(volume: &Volume, topology: &GridTopology, meshes: [(&CandidateMesh, &Verdict); 2]) -> Section {
    let [nx, ny, nz] = volume.shape();
    let text = format!(
        "The isosurface at 127/2 of {nx} × {ny} × {nz} voxels of the ICBM 2009a Nonlinear Symmetric T1 template \
         (Montreal Neurological Institute): our mesh, written to head.ply, read back and checked cell by cell, and the \
         mesh that the table of 1987 makes of the same voxels."
    );
    let pictures = meshes.into_iter().zip(["The true surface", "The table of 1987"]);
    let figures = pictures.map(|((mesh, _), caption)| {
        let vertices: Vec<[f64; 3]> = (0..mesh.positions.len()).map(|v| mesh.positions.rounded(v)).collect();
        (surface_picture(&vertices, &mesh.triangles, 520), caption.to_owned())
    });
    let row = |name: &str, values: [String; 3]| -> Vec<String> { [vec![name.to_owned()], values.to_vec()].concat() };
    let of = |count: &dyn Fn(&CandidateMesh, &Verdict) -> String| meshes.map(|(mesh, verdict)| count(mesh, verdict));
    let with_truth = |truth: String, [ours, theirs]: [String; 2]| [truth, ours, theirs];
    let chi = |mesh: &CandidateMesh| mesh_components(mesh).iter().map(|c| c.chi).sum::<i64>().to_string();
    let rows = vec![
        row("vertices", with_truth("–".into(), of(&|mesh, _| mesh.positions.len().to_string()))),
        row("triangles", with_truth("–".into(), of(&|mesh, _| mesh.triangles.len().to_string()))),
        row(
            "components",
            with_truth(topology.components.len().to_string(), of(&|mesh, _| mesh_components(mesh).len().to_string())),
        ),
        row("χ", with_truth(topology.chi().to_string(), of(&|mesh, _| chi(mesh)))),
        row("faults", with_truth("0".into(), of(&|_, verdict| verdict.faults.len().to_string()))),
    ];
    let columns = ["", "exactly", "ours", "1987"].map(str::to_owned).to_vec();
    Section {
        title: "A real surface".into(),
        blocks: vec![
            Block::Paragraph(text),
            Block::Figures(figures.collect()),
            Block::Table { caption: "Counts".into(), columns, rows },
        ],
    }
}

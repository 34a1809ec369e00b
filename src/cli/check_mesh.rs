//! `isoracle check mesh`.

use super::progress;
use clap::Args;
use isoracle::answer::mesh_report::{ReportOut, area_digits};
use isoracle::format::{self, FormatError};
use isoracle::mesh::defects::{Category, Counts};
use isoracle::mesh::fast::{self, Component, Elements, Mismatch, Polygons, Report, Unsound};
use isoracle::number::Rational;
use isoracle::number::decimal::{DecimalEnclosure, Digits};
use isoracle::number::text::exact_text;
use miette::Diagnostic;
use std::fmt::Display;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;
use thiserror::Error;

/// Check a polygon mesh as the boundary of a solid: every defect by its kind, the numbers of the surface, volume and area.
///
/// All decisions are exact: each coordinate is taken as the binary32 or binary64 that the file holds. Whether faces cut one
/// another is not checked.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Mesh {
    /// The mesh: a .ply, .obj, .stl or .off file, polygons of any size. Vertices of an STL at one position are taken for one.
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// How many elements of each kind of defect, and how many components, to name. [default: 5; with --json all]
    #[arg(long, value_name = "N")]
    show: Option<usize>,
    /// Write JSON in the protocol's terms: the defects and counts of `mesh.check`, and the area.
    #[arg(long)]
    json: bool,
    /// Decide one in N edges, vertices and faces a second time, by the plain definitions, and fail if any differs; 0 for none.
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    audit: u64,
}

const AFTER_HELP: &str = "\
Exit codes: 0 the mesh is sound, 1 it has defects, 2 the file cannot be used.

Example:
  $ isoracle check mesh bunny.ply
  $ isoracle check mesh --json --show 100 bunny.obj | jq .defects.boundary_edge";

#[derive(Debug, Error, Diagnostic)]
enum Failure {
    #[error("{0}")]
    #[diagnostic(help("a mesh is a .ply, .obj, .stl or .off file"))]
    Unreadable(FormatError),
    #[error("{}: {unsound}", file.display())]
    #[diagnostic(help("nothing can be decided about such a mesh"))]
    Unsound { file: PathBuf, unsound: Unsound },
    #[error("{}: there is no face in it", .0.display())]
    #[diagnostic(help("a mesh has faces; this is an empty file, or a cloud of points"))]
    Empty(PathBuf),
    #[error("audit: {0}")]
    #[diagnostic(help("no verdict is given: this is a mistake of isoracle's, not of the mesh"))]
    Audit(Mismatch),
}

impl Mesh {
    pub fn run(self) -> miette::Result<ExitCode> {
        let start = Instant::now();
        let spinner = progress::spinner(format!("reading {}", self.file.display()));
        let flat = format::read_flat_mesh(&self.file).map_err(Failure::Unreadable)?;
        let soup = flat.soup;
        let unsound = |unsound| Failure::Unsound { file: self.file.clone(), unsound };
        let mut mesh = Polygons::new(flat.vertices, flat.corners, flat.ends).map_err(unsound)?;
        if mesh.faces() == 0 {
            return Err(Failure::Empty(self.file).into());
        }
        let welded_from = soup.then_some(mesh.vertices().len());
        if soup {
            spinner.set_message("welding equal positions");
            mesh = mesh.welded();
        }
        tracing::info!(vertices = mesh.vertices().len(), faces = mesh.faces(), "read {}", self.file.display());
        let report = fast::check(&mesh, |what| {
            tracing::info!(seconds = start.elapsed().as_secs_f64(), "{what}");
            spinner.set_message(what);
        });
        if self.audit > 0 {
            spinner.set_message("auditing");
            let audited = fast::audit(&mesh, &report, self.audit).map_err(Failure::Audit)?;
            tracing::info!(seconds = start.elapsed().as_secs_f64(), audited, "decisions made twice, alike");
        }
        spinner.finish_and_clear();
        let written = if self.json { self.json(&report, welded_from) } else { self.text(&report, welded_from, start) };
        super::to_stdout(written)?;
        Ok(if is_sound(&report) { ExitCode::SUCCESS } else { ExitCode::from(1) })
    }

    fn json(&self, report: &Report, welded_from: Option<usize>) -> io::Result<()> {
        let mut out = io::BufWriter::new(io::stdout().lock());
        let report = ReportOut { report, welded_from, show: self.show.unwrap_or(usize::MAX) };
        serde_json::to_writer(&mut out, &report)?;
        writeln!(out)?;
        out.flush()
    }

    fn text(&self, report: &Report, welded_from: Option<usize>, start: Instant) -> io::Result<()> {
        let mut out = io::BufWriter::new(io::stdout().lock());
        let show = self.show.unwrap_or(5);
        writeln!(out, "{}: {}", self.file.display(), verdict(report))?;
        if let (Some(corners), Some(counts)) = (welded_from, &report.counts) {
            let [corners, vertices] = [corners, counts.vertices].map(grouped);
            writeln!(
                out,
                "note: an STL shares no vertices; its {corners} corners were welded to {vertices} at equal positions"
            )?;
        }
        if let Some(counts) = &report.counts {
            write_counts(&mut out, counts, &report.components, show)?;
        }
        if let Some(area) = &report.area {
            let exact = (area.lo == area.hi).then(|| short(&area.lo)).flatten();
            let area = exact.map_or_else(|| decimal(&area_digits(area)), |exact| format!("{exact} exactly"));
            writeln!(out, "  area     {area}")?;
        }
        for (heading, serious) in [("defects:", true), ("warnings:", false)] {
            let mut defects =
                report.defects.iter().filter(|(category, _)| is_serious(**category) == serious).peekable();
            if defects.peek().is_some() {
                writeln!(out, "{heading}")?;
            }
            for (category, elements) in defects {
                let more = *category == Category::TJunction && !report.all_junctions;
                write_defect(&mut out, *category, elements, show, more)?;
            }
        }
        writeln!(out, "{:.2} s", start.elapsed().as_secs_f64())?;
        out.flush()
    }
}

/// What keeps a mesh from being the boundary of a solid, but for its shape in places.
fn is_serious(category: Category) -> bool {
    !matches!(
        category,
        Category::ZeroLengthEdge
            | Category::IsolatedVertex
            | Category::DuplicateVertexPosition
            | Category::ZeroAreaFace
            | Category::NonplanarFace
    )
}

fn is_sound(report: &Report) -> bool {
    !report.defects.keys().any(|category| is_serious(*category))
}

/// One sentence.
fn verdict(report: &Report) -> &'static str {
    let serious: Vec<Category> = report.defects.keys().copied().filter(|category| is_serious(*category)).collect();
    let with_boundary = serious.iter().all(|category| matches!(category, Category::BoundaryEdge));
    match &report.counts {
        None => "unusable: a face names a vertex that does not exist",
        Some(_) if serious.is_empty() && report.defects.is_empty() => "sound, a closed oriented surface",
        Some(_) if serious.is_empty() => "sound, a closed oriented surface, with warnings",
        Some(_) if with_boundary => "open, a surface with a boundary, so not the boundary of a solid",
        Some(counts) if serious == [Category::InsideOut] && counts.closed => {
            "inside out, a closed surface that looks inward"
        }
        Some(_) => "defective, not the boundary of a solid",
    }
}

fn write_counts(out: &mut impl Write, counts: &Counts, components: &[Component], show: usize) -> io::Result<()> {
    let [v, e, f, c] = [counts.vertices, counts.edges, counts.faces, counts.components].map(grouped);
    writeln!(out, "  V = {v}, E = {e}, F = {f}, H = 0, C = {c}")?;
    let genus = counts.genus.map_or("not defined".to_owned(), |genus| grouped(genus as usize));
    writeln!(out, "  χ = V − E + F − H = {}, genus {genus}", counts.chi)?;
    let is = |name, is| if is { format!("{name} yes") } else { format!("{name} no") };
    let facts = [is("closed", counts.closed), is("orientable", counts.orientable), is("manifold", counts.manifold)];
    writeln!(out, "  {}", facts.join(", "))?;
    let alone = components.len() == 1 && counts.genus.is_some();
    for component in components.iter().take(if alone { 0 } else { show }) {
        let loops = component.boundary_loops;
        let genus = component.genus.map(|genus| format!("genus {genus}, boundary loops {loops}"));
        let genus = genus.unwrap_or("genus not defined".to_owned());
        let faces = grouped(component.faces as usize);
        let plural = if component.faces == 1 { "" } else { "s" };
        writeln!(out, "    component of {faces} face{plural}: {genus}")?;
    }
    if !alone && components.len() > show {
        writeln!(out, "    … and {} more components", grouped(components.len() - show))?;
    }
    if let Some(volume) = &counts.volume {
        let digits = decimal(&DecimalEnclosure::of(volume, Digits::new(20).expect("few digits")));
        match short(volume) {
            Some(exact) if exact == digits => writeln!(out, "  volume   {exact}")?,
            Some(exact) => writeln!(out, "  volume   {exact} = {digits}")?,
            None => writeln!(out, "  volume   {digits} (p/q with --json)")?,
        }
    }
    Ok(())
}

fn write_defect(
    out: &mut impl Write,
    category: Category,
    elements: &Elements,
    show: usize,
    more: bool,
) -> io::Result<()> {
    let at_least = if more { "at least " } else { "" };
    let count = format!("{at_least}{}", grouped(elements.len()));
    writeln!(out, "  {count:>10} {}: {}", category.name(), meaning(category))?;
    let named = match elements {
        Elements::Faces(list) => first("face", list, show),
        Elements::Vertices(list) => first("vertex", list, show),
        Elements::Edges(list) => {
            first("edge", &list.iter().take(show).map(|[a, b]| format!("{a}–{b}")).collect::<Vec<_>>(), show)
        }
        Elements::VertexGroups(list) => first("vertices", &groups(list, show), show),
        Elements::FaceGroups(list) => first("faces", &groups(list, show), show),
        Elements::Junctions(list) => {
            let named = list.iter().take(show).map(|(v, [a, b])| format!("{v} in {a}–{b}"));
            first("vertex", &named.collect::<Vec<_>>(), show)
        }
        Elements::Whole => return Ok(()),
    };
    let dots = if elements.len() > show && show > 0 { ", …" } else { "" };
    if show > 0 { writeln!(out, "             {named}{dots}") } else { Ok(()) }
}

fn first(what: &str, list: &[impl Display], show: usize) -> String {
    let named: Vec<String> = list.iter().take(show).map(ToString::to_string).collect();
    format!("{what} {}", named.join(", "))
}

fn groups(list: &[Vec<u32>], show: usize) -> Vec<String> {
    list.iter().take(show).map(|group| first("", group, 8).trim().replace(", ", " = ")).collect()
}

/// What a kind of defect means, in a few words.
fn meaning(category: Category) -> &'static str {
    match category {
        Category::IndexOutOfRange => "a face names a vertex that does not exist",
        Category::FaceLt3Vertices => "a face of fewer than 3 vertices",
        Category::RepeatedVertexInLoop => "a face visits a vertex twice",
        Category::DegenerateEdgeSameIndex => "a side from a vertex to itself",
        Category::ZeroLengthEdge => "an edge between two vertices at one position",
        Category::BoundaryEdge => "an edge of one face only",
        Category::EdgeUsedGt2 => "an edge used more than twice",
        Category::EdgeOddUse => "an edge used an odd number of times, three or more",
        Category::EdgeTwiceInSameFace => "an edge used twice by one face",
        Category::InconsistentWindingEdge => "two faces run along their edge in the same direction",
        Category::IsolatedVertex => "a vertex that no face uses",
        Category::DuplicateVertexPosition => "different vertices at one position",
        Category::DuplicateFace => "faces with the same loop",
        Category::ZeroAreaFace => "a face whose vertices all lie on one line",
        Category::NonplanarFace => "a face whose vertices are not in one plane",
        Category::ZeroSignedAreaFace => "a planar face whose signed area is zero",
        Category::SelfCrossingLoop => "a planar face two of whose sides cross",
        Category::TJunction => "a vertex inside an edge that does not end there",
        Category::NonmanifoldVertex => "a vertex whose faces are not one fan",
        Category::VertexLt2Edges => "a vertex with fewer than two neighbours",
        Category::NonOrientable => "no choice of sides makes the faces agree",
        Category::InsideOut => "the faces look inward, the volume is negative",
        Category::ZeroVolume => "the surface encloses no volume",
        Category::HoleSameSenseAsOuter => "a hole wound like its face",
        Category::EdgeUnreferenced => "a listed edge that no face uses",
        Category::EdgeMissingFromList => "a used edge that is not listed",
        Category::DuplicateEdgeRecord => "an edge listed twice",
        Category::EdgeFaceNotReciprocal => "an edge whose listed faces are not those that use it",
    }
}

/// p/q, where that is short.
fn short(x: &Rational) -> Option<String> {
    Some(exact_text(x)).filter(|text| text.len() <= 60)
}

/// The digits that both bounds share, with dots where more follow.
fn decimal(DecimalEnclosure { lo, hi }: &DecimalEnclosure) -> String {
    let trimmed = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    if lo == hi {
        return trimmed(lo);
    }
    let shared = lo.bytes().zip(hi.bytes()).take_while(|(a, b)| a == b).count();
    // Only digits behind the point may be left out.
    match lo.find('.') {
        Some(point) if shared > point + 1 && lo.len() == hi.len() => format!("{}…", &lo[..shared]),
        Some(_) | None => format!("between {lo} and {hi}"),
    }
}

/// 12,345,678.
fn grouped(n: usize) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

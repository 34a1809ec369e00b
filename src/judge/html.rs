//! The run as one HTML page that needs nothing else: no script, no other file, no network.

mod accuracy;

use super::report::{Failure, Outcome, QuestionRecord, Report, Row, Seconds, SurfaceRecord, VolumeQuestion, grouped};
use super::svg::{self, Picture};
use super::text::ulp;
use crate::isosurface::cases::Case;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// A further section of the page, after the failures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// Its heading.
    pub title: String,
    /// What stands under it.
    pub blocks: Vec<Block>,
}

/// A part of a section.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Block {
    /// Plain text.
    Paragraph(String),
    /// Pictures side by side, each with its caption.
    Figures(Vec<(Picture, String)>),
    /// A table; numbers in it are set to the right.
    Table {
        /// What it shows.
        caption: String,
        /// The headings of its columns.
        columns: Vec<String>,
        /// Its rows, each as long as `columns`; the first cell is the row's heading.
        rows: Vec<Vec<String>>,
    },
}

/// The page.
pub fn page(report: &Report, extra: &[Section]) -> String {
    let name = &report.candidate.name;
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="generator" content=(concat!("isoracle ", env!("CARGO_PKG_VERSION")));
                title { (name) ": " (report.verdict.word()) " · isoracle judge" }
                style { (PreEscaped(include_str!("style.css"))) }
            }
            body {
                (header(report))
                main {
                    (summary(report))
                    (cases(report))
                    (groups(report))
                    (accuracy::accuracy(&report.accuracy))
                    (faults(report))
                    (failures(report))
                    @for section in extra { (extra_section(section)) }
                }
                (footer(report))
            }
        }
    };
    page.into_string()
}

/// A mark beside the verdict's word, so that the word's colour is never alone.
fn mark(verdict: Outcome) -> &'static str {
    match verdict {
        Outcome::Passed => "✓",
        Outcome::Wrong => "✗",
        Outcome::Broken => "!",
    }
}

fn header(report: &Report) -> Markup {
    let candidate = &report.candidate;
    html! {
        header {
            p.kicker { "isoracle judge · " (report.suite) }
            div.title {
                h1 { (candidate.name) @if !candidate.version.is_empty() { " " span.version { (candidate.version) } } }
                p class={ "verdict " (report.verdict.word()) } {
                    span.mark aria-hidden="true" { (mark(report.verdict)) } " " (report.verdict.word())
                }
            }
            p.command { span.sr { "Started as " } code { (candidate.command.join(" ")) } }
        }
    }
}

fn summary(report: &Report) -> Markup {
    let whole = report.cases.iter().filter(|row| row.asked > 0 && row.passed == row.asked).count();
    let rate = |row: &&Row| (row.passed as f64 / row.asked as f64 * 1e9) as u64;
    let worst = report.rows().filter(|row| row.wrong + row.broken > 0).min_by_key(rate);
    let ways = match report.failures.len() {
        0 => "No way of failing was found.".to_owned(),
        1 => "One way of failing was found; below is the smallest question that shows it.".to_owned(),
        n => format!("{n} ways of failing were found; below is the smallest question that shows each."),
    };
    html! {
        section.summary aria-label="Summary" {
            p.lead { (report.verdict_sentence()) }
            p {
                (whole) " of the " (report.cases.len()) " " (kinds(report)) " are right throughout"
                @if let Some(worst) = worst { "; the weakest row is " strong { (worst.name) } ", " (worst.pass_rate()) " % right" }
                "."
            }
            p { (ways) }
        }
    }
}

/// The share of right, wrong and broken answers, drawn; the numbers stand beside it.
fn bar(row: &Row) -> Markup {
    let share = |n: usize| format!("width:{:.2}%", 100.0 * n as f64 / row.asked.max(1) as f64);
    html! {
        span.bar aria-hidden="true" {
            @if row.passed > 0 { i.right style=(share(row.passed)) {} }
            @if row.wrong > 0 { i.wrong style=(share(row.wrong)) {} }
            @if row.broken > 0 { i.broken style=(share(row.broken)) {} }
        }
    }
}

/// A count, or a dot for none.
fn count(n: usize) -> Markup {
    html! { @if n == 0 { span.none { "0" } } @else { (grouped(n)) } }
}

/// The row's name, linked to its first failure.
fn row_name(report: &Report, row: &Row) -> Markup {
    let first = report.failures.iter().position(|failure| failure.row == row.name);
    html! {
        @if let Some(first) = first { a href={ "#failure-" (first + 1) } { (row.name) } }
        @else { (row.name) }
    }
}

fn row_class(row: &Row) -> &'static str {
    match (row.asked, row.wrong + row.broken) {
        (0, _) => "unasked",
        (_, 0) => "whole",
        (_, _) => "faulty",
    }
}

fn is_about_volumes(report: &Report) -> bool {
    report.suite == "isosurface"
}

/// What the rows of the first table are.
fn kinds(report: &Report) -> &'static str {
    match report.suite.as_str() {
        "isosurface" => "cases",
        "complex" => "kinds of schemes",
        "spline" | "curvature" => "kinds of questions",
        _ => "kinds of meshes",
    }
}

fn cases(report: &Report) -> Markup {
    let declined = report.cases.iter().any(|row| row.unsupported > 0);
    html! {
        section aria-labelledby="cases" {
            h2 #cases { "The " (report.cases.len()) " " (kinds(report)) }
            p.note {
                @if is_about_volumes(report) { "Single cells, by Chernyaev’s names. A filled corner is above the isovalue." }
                @else if report.suite == "complex" {
                    "Gluing schemes of 3-manifolds, or of what is none at least for the reason that the row is named for."
                }
                @else if report.suite != "mesh" { "Questions that any good implementation in binary64 can answer." }
                @else { "Meshes that are sound, or have the defect that the row is named for, perhaps among others." }
                " A name in bold leads to its smallest failure."
            }
            @if !is_about_volumes(report) { (rows_table(report, "kind", &report.cases)) }
            @else { div.columns {
                @for rows in report.cases.chunks(report.cases.len().div_ceil(3).max(1)) {
                    table.cases {
                        thead { tr {
                            th colspan="2" scope="col" { "case" }
                            th.n scope="col" { "asked" } th.n scope="col" { "right" }
                            th.n scope="col" { "wrong" } th.n scope="col" { "broken" }
                            @if declined { th.n scope="col" { "declined" } }
                            th.n scope="col" abbr="percent right" { "%" }
                        } }
                        tbody { @for row in rows {
                            tr class=(row_class(row)) {
                                td.icon { @if let Ok(case) = row.name.parse::<Case>() { (picture(&svg::case_icon(case))) } }
                                th scope="row" { (row_name(report, row)) }
                                td.n { (count(row.asked)) } td.n { (count(row.passed)) }
                                td.n { (count(row.wrong)) } td.n { (count(row.broken)) }
                                @if declined { td.n { (count(row.unsupported)) } }
                                td.n.rate { (row.pass_rate()) (bar(row)) }
                            }
                        } }
                    }
                }
            } }
        }
    }
}

fn groups(report: &Report) -> Markup {
    html! {
        @if !report.groups.is_empty() {
            section aria-labelledby="groups" {
                h2 #groups { "Other questions" }
                (rows_table(report, "group", &report.groups))
            }
        }
    }
}

/// A table of rows, one under the other.
fn rows_table(report: &Report, heading: &str, rows: &[Row]) -> Markup {
    html! {
        div.scroll { table.groups {
            thead { tr {
                th scope="col" { (heading) }
                th.n scope="col" { "asked" } th.n scope="col" { "right" } th.n scope="col" { "wrong" }
                th.n scope="col" { "broken" } th.n scope="col" { "declined" } th.n scope="col" { "% right" }
            } }
            tbody { @for row in rows {
                tr class=(row_class(row)) {
                    th scope="row" { (row_name(report, row)) }
                    td.n { (count(row.asked)) } td.n { (count(row.passed)) } td.n { (count(row.wrong)) }
                    td.n { (count(row.broken)) } td.n { (count(row.unsupported)) }
                    td.n.rate { (row.pass_rate()) (bar(row)) }
                }
            } }
        } }
    }
}

fn faults(report: &Report) -> Markup {
    let faults = report.total().faults;
    let rows_of = |fault: &str| {
        let rows = report.rows().filter_map(|row| Some((row, row.faults.iter().find(|(name, _)| name == fault)?.1)));
        rows.map(|(row, n)| format!("{} ({})", row.name, grouped(n))).collect::<Vec<_>>().join(", ")
    };
    html! {
        @if !faults.is_empty() {
            section aria-labelledby="faults" {
                h2 #faults { "Faults" }
                table.faults {
                    thead { tr {
                        th scope="col" { "fault" } th.n scope="col" { "questions" } th scope="col" { "in (questions)" }
                    } }
                    tbody { @for (name, n) in &faults {
                        tr { th scope="row" { (name) } td.n { (grouped(*n)) } td.rows { (rows_of(name)) } }
                    } }
                }
            }
        }
    }
}

fn failures(report: &Report) -> Markup {
    html! {
        @if !report.failures.is_empty() {
            section aria-labelledby="failures" {
                h2 #failures { "Failures" }
                @if is_about_volumes(report) { p.note {
                    "Corners are numbered as in the question: filled above the isovalue, hollow below. The surface is blue on the side "
                    "toward larger values, ochre and hatched on the other. Bold lines lie on the faces of cells; on an ambiguous "
                    "face, a dotted line joins the corners that the bilinear function joins. An edge that ends the surface "
                    "inside the grid, or has more than two triangles, is red and dashed."
                } }
                @for (i, failure) in report.failures.iter().enumerate() { (failure_card(i + 1, failure)) }
            }
        }
    }
}

fn failure_card(number: usize, failure: &Failure) -> Markup {
    let place = if failure.case == failure.row { String::new() } else { format!(", case {}", failure.case) };
    let title = |whose: &str| format!("{whose}, failure {number}");
    html! {
        article.failure id={ "failure-" (number) } aria-labelledby={ "failure-" (number) "-title" } {
            h3 id={ "failure-" (number) "-title" } {
                span.number { (number) } " " (failure.fault)
                span.where { " in " (failure.row) (place) } " " span.formula { (failure.formula) }
            }
            @for message in &failure.messages { p.message { (message) } }
            @match &failure.question {
                QuestionRecord::Volume(question) => { div.pair {
                    (figure(question, failure.expected.as_ref(), &title("True surface"), "The true surface", "too large to draw"))
                    (figure(question, failure.found.as_ref(), &title("Candidate’s surface"), "The candidate’s", "it gave no mesh"))
                } }
                QuestionRecord::Other { .. } => { @if let Some(mesh) = failure.expected.as_ref().filter(|mesh| !mesh.faces.is_empty()) {
                    div.pair { figure {
                        (picture(&svg::surface_picture(&mesh.vertices, &mesh.faces, 320)))
                        figcaption { "The mesh of the question" }
                    } }
                } }
            }
            @if !failure.differences.is_empty() {
                div.scroll { table.differences {
                    caption { "What differs, exactly" }
                    thead { tr { th scope="col" { "invariant" } th scope="col" { "expected" } th scope="col" { "found" } } }
                    tbody { @for difference in &failure.differences {
                        tr { th scope="row" { (difference.invariant) } td { (difference.expected) } td { (difference.found) } }
                    } }
                } }
            }
            p.label { "The question" }
            pre tabindex="0" aria-label="The question as JSON" { (failure.question.json()) }
            p.label { "See it again" }
            pre tabindex="0" aria-label="The command that shows it again" { (failure.command) }
        }
    }
}

/// The volume with a surface, or without one where there is none.
fn figure(
    question: &VolumeQuestion,
    surface: Option<&SurfaceRecord>,
    title: &str,
    caption: &str,
    absent: &str,
) -> Markup {
    html! {
        figure {
            (picture(&svg::volume_picture(question, surface, title)))
            figcaption { (caption) @if surface.is_none() { " – " (absent) } }
        }
    }
}

fn picture(picture: &Picture) -> Markup {
    PreEscaped(picture.as_str().to_owned())
}

fn extra_section(section: &Section) -> Markup {
    html! {
        section.extra {
            h2 { (section.title) }
            @for block in &section.blocks {
                @match block {
                    Block::Paragraph(text) => { p { (text) } }
                    Block::Figures(figures) => {
                        div.pair { @for (drawn, caption) in figures { figure { (picture(drawn)) figcaption { (caption) } } } }
                    }
                    Block::Table { caption, columns, rows } => { (extra_table(caption, columns, rows)) }
                }
            }
        }
    }
}

fn extra_table(caption: &str, columns: &[String], rows: &[Vec<String>]) -> Markup {
    let is_number = |cell: &str| cell.starts_with(|c: char| c.is_ascii_digit() || "-−–+≈".contains(c));
    let is_numeric = |i: usize| i > 0 && rows.iter().all(|row| row.get(i).is_some_and(|cell| is_number(cell)));
    let class = |i: usize| if is_numeric(i) { "n" } else { "t" };
    html! {
        div.scroll { table {
            caption { (caption) }
            thead { tr { @for (i, column) in columns.iter().enumerate() {
                th class=(class(i)) scope="col" { (column) }
            } } }
            tbody { @for row in rows {
                tr { @for (i, cell) in row.iter().enumerate() {
                    @if i == 0 { th scope="row" { (cell) } } @else { td class=(class(i)) { (cell) } }
                } }
            } }
        } }
    }
}

fn footer(report: &Report) -> Markup {
    let Seconds { candidate, oracle, total } = report.seconds;
    let error = &report.position_error;
    html! {
        footer {
            dl {
                @if is_about_volumes(report) { div { dt { "Largest position error on a grid edge" }
                    dd { (ulp(error.binary64_ulp)) " ulp of binary64, " (ulp(error.binary32_ulp)) " ulp of binary32" } } }
                @if !report.left_out.is_empty() { div { dt { "Not judged" }
                    dd { "Right answers left out " (report.left_out.join(", ")) } } }
                div { dt { "Time" }
                    dd { (format!("{candidate:.2} s for the candidate, {oracle:.2} s for the oracle’s plain answers, {total:.2} s in all")) } }
                div { dt { "Seed" } dd { (report.seed) " – the same seed asks the same questions" } }
            }
            p { "isoracle " (env!("CARGO_PKG_VERSION")) }
        }
    }
}

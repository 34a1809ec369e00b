//! The report for a terminal, 80 columns wide.

mod accuracy;

use super::report::{Failure, Outcome, QuestionRecord, Report, Row, grouped};

/// The most failures that are shown.
const MOST_FAILURES: usize = 10;

/// The width that no line of ours goes beyond, but for names and commands that cannot be shortened.
const WIDTH: usize = 80;

/// The report: the table of cases in two columns, the groups, the first failures, and the verdict last.
/// Control characters in what the candidate said are made visible; with `colour`, ANSI colours are added and
/// nothing else changes.
pub fn text(report: &Report, colour: bool) -> String {
    let ink = Ink { colour };
    let candidate = &report.candidate;
    let mut out = format!("{} {}\n", ink.bold(&plain(&candidate.name)), plain(&candidate.version));
    out += &format!("{}\n\n", ink.faint(&shortened(&plain(&candidate.command.join(" ")), WIDTH)));
    out += &cases(&report.cases, &ink);
    if !report.groups.is_empty() {
        out += "\n";
        out += &table("group", &report.groups, &ink).join("\n");
        out += "\n";
    }
    out += &accuracy::accuracy(&report.accuracy, &ink);
    for (i, failure) in report.failures.iter().take(MOST_FAILURES).enumerate() {
        out += "\n";
        out += &one_failure(i + 1, failure, &ink);
    }
    if let Some(more @ 1..) = report.failures.len().checked_sub(MOST_FAILURES) {
        out += &format!("\n{more} more ways of failing are in the other forms of this report.\n");
    }
    out += "\n";
    if !report.left_out.is_empty() {
        let left_out = format!("Not judged, since right answers left it out: {}.", report.left_out.join(", "));
        out += &(wrapped(&plain(&left_out), WIDTH).join("\n") + "\n");
    }
    if report.suite == "isosurface" {
        out += &format!(
            "Largest position error on an edge: {} ulp of binary64, {} ulp of binary32.\n",
            ulp(report.position_error.binary64_ulp),
            ulp(report.position_error.binary32_ulp)
        );
    }
    let seconds = &report.seconds;
    out += &format!(
        "Seconds: {:.2} for the candidate, {:.2} for the oracle, {:.2} in all. Seed {}.\n",
        seconds.candidate, seconds.oracle, seconds.total, report.seed
    );
    let verdict = report.verdict.word().to_uppercase();
    let lines = wrapped(&report.verdict_sentence(), WIDTH - verdict.len() - 2);
    let indent = " ".repeat(verdict.len() + 2);
    out + &format!("{}  {}\n", ink.verdict(report.verdict, &verdict), lines.join(&format!("\n{indent}")))
}

/// The cases in two columns where two fit, reading down the first and then the second.
fn cases(rows: &[Row], ink: &Ink) -> String {
    let half = rows.len().div_ceil(2);
    let (left, right) = (table("case", &rows[..half], ink), table("case", &rows[half..], ink));
    let fits = |row: &Row| row.asked < 100_000 && row.name.chars().count() <= 6 && row.unsupported == 0;
    if !rows.iter().all(fits) {
        return table("case", rows, ink).join("\n") + "\n";
    }
    let mut lines = Vec::new();
    for (i, line) in left.iter().enumerate() {
        lines.push(match right.get(i).filter(|_| half < rows.len()) {
            Some(other) => format!("{line}    {other}"),
            None => line.clone(),
        });
    }
    lines.join("\n") + "\n"
}

/// Lines of equal width: a heading and a line for each row.
fn table(heading: &str, rows: &[Row], ink: &Ink) -> Vec<String> {
    let name_width = rows.iter().map(|row| row.name.chars().count()).fold(6, usize::max);
    let width = rows.iter().map(|row| row.asked.to_string().len()).fold(5, usize::max);
    let declined = rows.iter().any(|row| row.unsupported > 0);
    let mut head = format!(
        "{heading:name_width$} {:>width$} {:>width$} {:>5} {:>6} {:>6}",
        "asked", "right", "wrong", "broken", "%"
    );
    if declined {
        head += &format!(" {:>8}", "declined");
    }
    let mut lines = vec![ink.faint(&head)];
    for row in rows {
        let number = |n: usize| if n == 0 { "·".to_owned() } else { n.to_string() };
        let mut line = format!(
            "{:name_width$} {:>width$} {:>width$} {:>5} {:>6} {:>6}",
            row.name,
            row.asked,
            row.passed,
            number(row.wrong),
            number(row.broken),
            row.pass_rate()
        );
        if declined {
            line += &format!(" {:>8}", number(row.unsupported));
        }
        lines.push(match (row.wrong, row.broken) {
            (0, 0) => line,
            (_, 0) => ink.red(&line),
            (_, _) => ink.magenta(&line),
        });
    }
    lines
}

fn one_failure(number: usize, failure: &Failure, ink: &Ink) -> String {
    let heading = format!("{number}. {} · {} · {}", failure.row, failure.fault, failure.formula);
    let mut out = ink.bold(&plain(&heading)) + "\n";
    let case = if failure.case == failure.row { String::new() } else { format!("case {}, ", failure.case) };
    let question = match &failure.question {
        QuestionRecord::Volume(question) => {
            let [nx, ny, nz] = question.shape;
            format!("{case}{nx}×{ny}×{nz} at {}: {}", question.isovalue, question.values.join(" "))
        }
        QuestionRecord::Other { op, input } => format!("{op} {input}"),
    };
    let mut lines = vec![question];
    match failure.differences.split_first() {
        None => lines.extend(failure.messages.first().cloned()),
        Some((first, others)) => {
            let more = if others.is_empty() { String::new() } else { format!(" (and {} more)", others.len()) };
            lines.push(format!("{}{more}", first.invariant));
            lines.push(format!("  expected {}", first.expected));
            lines.push(format!("  found    {}", first.found));
        }
    }
    for line in lines {
        out += &format!("   {}\n", shortened(&plain(&line), WIDTH - 3));
    }
    // A command is for copying: it is never shortened.
    out + &format!("   {}\n", ink.faint(&plain(&failure.command)))
}

/// An error in units in the last place, to three significant digits or the whole unit.
pub(super) fn ulp(error: f64) -> String {
    match error {
        e if e >= 100.0 => grouped(e.round() as usize),
        e => format!("{e:.3}"),
    }
}

/// Lines of at most so many characters, but for longer words.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => *line += &format!(" {word}"),
            Some(_) | None => lines.push(word.to_owned()),
        }
    }
    lines
}

/// At most so many characters, the last one then "…".
fn shortened(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return text.to_owned();
    }
    text.chars().take(width - 1).chain(['…']).collect()
}

/// A text of others without characters that would move a terminal's cursor or change its colours.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}

/// ANSI colours, or none.
struct Ink {
    colour: bool,
}

impl Ink {
    fn with(&self, code: &str, text: &str) -> String {
        if self.colour { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_owned() }
    }

    fn bold(&self, text: &str) -> String {
        self.with("1", text)
    }

    fn faint(&self, text: &str) -> String {
        self.with("2", text)
    }

    fn red(&self, text: &str) -> String {
        self.with("31", text)
    }

    fn magenta(&self, text: &str) -> String {
        self.with("35", text)
    }

    fn verdict(&self, verdict: Outcome, text: &str) -> String {
        match verdict {
            Outcome::Passed => self.with("1;32", text),
            Outcome::Wrong => self.with("1;31", text),
            Outcome::Broken => self.with("1;35", text),
        }
    }
}

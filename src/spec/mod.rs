//! The specification: every formula of the four texts that is checked here, with its verdict.
//!
//! The chapters are Markdown files, embedded. An entry begins with its heading, `## CU-7  Title`, and ends with the
//! next one, be it an entry's or a section's, `## (a) Title`. A line that begins with one of the known words and
//! a colon begins a field, which ends with the next field or an empty line; anything else is notes.

pub mod html;
pub mod rich;

use serde::Serialize;
use std::fmt::{self, Display, Formatter};
use std::str::FromStr;
use thiserror::Error;

/// The chapters, in order: file name and text.
pub const CHAPTERS: &[(&str, &str)] = &[
    ("numbers.md", include_str!("../../spec/numbers.md")),
    ("isosurface.md", include_str!("../../spec/isosurface.md")),
    ("mesh.md", include_str!("../../spec/mesh.md")),
    ("complex.md", include_str!("../../spec/complex.md")),
    ("curvature.md", include_str!("../../spec/curvature.md")),
    ("spline.md", include_str!("../../spec/spline.md")),
];

/// What checking a formula has shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// It holds as printed.
    Holds,
    /// It holds under a convention that the entry names.
    HoldsWithConvention,
    /// It is false as printed.
    Erratum,
    /// It claims nothing that can be checked.
    NotCheckable,
}

impl Verdict {
    const ALL: [Verdict; 4] = [Verdict::Holds, Verdict::HoldsWithConvention, Verdict::Erratum, Verdict::NotCheckable];

    /// As it is written in an entry.
    pub const fn name(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::HoldsWithConvention => "holds-with-convention",
            Verdict::Erratum => "erratum",
            Verdict::NotCheckable => "not-checkable",
        }
    }
}

impl Display for Verdict {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The stable name of an entry, such as CU-7.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(into = "String")]
pub struct Id {
    room: String,
    number: u32,
}

impl Id {
    /// The room whose chapter it stands in: `CU`.
    pub fn room(&self) -> &str {
        &self.room
    }

    /// The name of the module that holds its tests: `cu_7`.
    pub fn test_module(&self) -> String {
        self.to_string().to_lowercase().replace('-', "_")
    }
}

impl Display for Id {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.pad(&format!("{}-{}", self.room, self.number))
    }
}

impl From<Id> for String {
    fn from(id: Id) -> String {
        id.to_string()
    }
}

/// A text that is not the name of an entry.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0:?} is not an id; ids are such as CU-7")]
pub struct NotAnId(String);

impl FromStr for Id {
    type Err = NotAnId;

    /// `CU-7`, `cu-7` or `cu_7`.
    fn from_str(text: &str) -> Result<Id, NotAnId> {
        let parts = text.split_once(['-', '_']);
        let id = parts.and_then(|(room, number)| Some((room, number.parse().ok()?)));
        match id {
            Some((room, number)) if room.len() == 2 && room.bytes().all(|b| b.is_ascii_alphabetic()) => {
                Ok(Id { room: room.to_ascii_uppercase(), number })
            }
            Some(_) | None => Err(NotAnId(text.to_owned())),
        }
    }
}

/// An entry of the specification.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Entry {
    /// Its stable name.
    pub id: Id,
    /// Its title.
    pub title: String,
    /// Where it comes from, such as `002 eq (5)`; separated by `;` in the file.
    pub sources: Vec<String>,
    /// What checking it has shown.
    pub verdict: Verdict,
    /// The formula as the text has it.
    pub printed: Option<String>,
    /// The formula as it should be.
    pub correct: Option<String>,
    /// Where the printed one fails.
    pub counterexample: Option<String>,
    /// The path of the code in this crate.
    pub code: Option<String>,
    /// The tests that prove it, by default the module named after its id.
    pub tests: Vec<String>,
    /// Snapshot files, by name.
    pub snapshots: Vec<String>,
    /// Why it holds, where the entry says so.
    #[serde(skip)]
    pub proof: Option<String>,
    /// Domain, unit, sign, number field: the name as written, and what it says.
    #[serde(skip)]
    pub conventions: Vec<(String, String)>,
    /// Further text, its paragraphs separated by an empty line.
    #[serde(skip)]
    pub notes: String,
}

/// Why a chapter cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SpecError {
    /// A heading of an entry without an id.
    #[error("line {line}: {error}")]
    Id {
        /// The line, from 1.
        line: usize,
        /// What is wrong.
        error: NotAnId,
    },
    /// A field stands twice.
    #[error("{id}: `{field}` stands twice")]
    Repeated {
        /// The entry.
        id: Id,
        /// The field.
        field: String,
    },
    /// An id stands twice.
    #[error("{0} stands twice")]
    RepeatedId(Id),
    /// An entry without a verdict, or with an unknown one.
    #[error("{id}: the verdict is {found:?}, none of holds, holds-with-convention, erratum, not-checkable")]
    Verdict {
        /// The entry.
        id: Id,
        /// What stands there.
        found: String,
    },
    /// An erratum without a corrected formula and a counterexample.
    #[error("{0}: an erratum has a corrected formula and a counterexample")]
    BareErratum(Id),
}

/// All entries of the embedded chapters.
///
/// # Errors
/// A chapter cannot be read: a bug in this crate, which its tests exclude.
pub fn entries() -> Result<Vec<Entry>, SpecError> {
    let mut entries: Vec<Entry> = Vec::new();
    for (_, text) in CHAPTERS {
        for entry in parse(text)? {
            if entries.iter().any(|known| known.id == entry.id) {
                return Err(SpecError::RepeatedId(entry.id));
            }
            entries.push(entry);
        }
    }
    Ok(entries)
}

/// The entries of a chapter.
///
/// # Errors
/// See [`SpecError`].
pub fn parse(markdown: &str) -> Result<Vec<Entry>, SpecError> {
    let mut entries = Vec::new();
    let mut draft: Option<Draft> = None;
    for (number, line) in markdown.lines().enumerate() {
        match line.strip_prefix("## ").map(str::trim) {
            Some(heading) => {
                entries.extend(draft.take().map(Draft::finish).transpose()?);
                draft = Draft::of(heading).map_err(|error| SpecError::Id { line: number + 1, error })?;
            }
            None => draft.as_mut().map_or(Ok(()), |draft| draft.line(line))?,
        }
    }
    entries.extend(draft.map(Draft::finish).transpose()?);
    Ok(entries)
}

/// The words that begin a field; those of one convention may stand together: `domain, unit: …`.
const FIELDS: [&str; 9] =
    ["source", "printed", "verdict", "correct", "counterexample", "proof", "code", "tests", "snapshots"];
const CONVENTIONS: [&str; 4] = ["domain", "unit", "sign", "number field"];

/// An entry while its lines are read.
struct Draft {
    id: Id,
    title: String,
    fields: Vec<(String, String)>,
    /// Whether the last field goes on.
    is_open: bool,
    notes: String,
}

fn field(line: &str) -> Option<(&str, &str)> {
    let (name, text) = line.split_once(':')?;
    let is_convention = name.split(',').all(|word| CONVENTIONS.contains(&word.trim()));
    (FIELDS.contains(&name) || is_convention).then_some((name, text.trim()))
}

impl Draft {
    /// The entry with this heading; none where it is the heading of a section, its first word without a digit.
    fn of(heading: &str) -> Result<Option<Draft>, NotAnId> {
        let (id, title) = heading.split_once(char::is_whitespace).unwrap_or((heading, ""));
        if !id.contains(|c: char| c.is_ascii_digit()) {
            return Ok(None);
        }
        let (id, title) = (id.parse()?, title.trim().to_owned());
        Ok(Some(Draft { id, title, fields: Vec::new(), is_open: false, notes: String::new() }))
    }

    fn line(&mut self, line: &str) -> Result<(), SpecError> {
        if let Some((name, text)) = field(line) {
            if self.fields.iter().any(|(known, _)| known == name) {
                return Err(SpecError::Repeated { id: self.id.clone(), field: name.to_owned() });
            }
            self.fields.push((name.to_owned(), text.to_owned()));
            self.is_open = true;
            return Ok(());
        }
        match self.fields.last_mut() {
            Some((_, text)) if self.is_open && line.trim().is_empty() => self.is_open = text.is_empty(),
            Some((_, text)) if self.is_open => {
                let separator = if text.is_empty() { "" } else { "\n" };
                *text = format!("{text}{separator}{}", line.trim());
            }
            Some(_) | None => self.notes = format!("{}\n{line}", self.notes),
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Entry, SpecError> {
        let mut take = |name: &str| {
            let at = self.fields.iter().position(|(known, _)| known == name)?;
            let (_, text) = self.fields.remove(at);
            (!matches!(text.as_str(), "" | "—" | "-")).then_some(text)
        };
        let list = |text: Option<String>, separator: char| -> Vec<String> {
            let text = text.unwrap_or_default();
            text.split(separator).map(|item| item.trim().to_owned()).filter(|item| !item.is_empty()).collect()
        };
        let sources = list(take("source"), ';');
        let word = take("verdict").unwrap_or_default();
        let (printed, correct, counterexample) = (take("printed"), take("correct"), take("counterexample"));
        let (proof, code) = (take("proof"), take("code"));
        let (tests, snapshots) = (list(take("tests"), ','), list(take("snapshots"), ','));
        let tests = if tests.is_empty() { vec![self.id.test_module()] } else { tests };
        let Some(verdict) = Verdict::ALL.into_iter().find(|verdict| verdict.name() == word) else {
            return Err(SpecError::Verdict { id: self.id, found: word });
        };
        if verdict == Verdict::Erratum && (correct.is_none() || counterexample.is_none()) {
            return Err(SpecError::BareErratum(self.id));
        }
        Ok(Entry {
            id: self.id,
            title: self.title,
            sources,
            verdict,
            printed,
            correct,
            counterexample,
            code,
            tests,
            snapshots,
            proof,
            conventions: self.fields,
            notes: self.notes.trim().to_owned(),
        })
    }
}

impl Entry {
    /// Its fields as they are shown, name and text, those that it has.
    pub fn fields(&self) -> Vec<(&str, String)> {
        let mut fields = vec![("source", self.sources.join("; "))];
        fields.push(("printed", self.printed.clone().unwrap_or_default()));
        fields.push(("verdict", self.verdict.to_string()));
        fields.push(("correct", self.correct.clone().unwrap_or_default()));
        fields.push(("counterexample", self.counterexample.clone().unwrap_or_default()));
        fields.extend(self.conventions.iter().map(|(name, text)| (name.as_str(), text.clone())));
        fields.push(("proof", self.proof.clone().unwrap_or_default()));
        fields.push(("code", self.code.clone().unwrap_or_default()));
        fields.push(("tests", self.tests.join(", ")));
        fields.push(("snapshots", self.snapshots.join(", ")));
        fields.retain(|(_, text)| !text.is_empty());
        fields
    }
}

/// The entry as text.
impl Display for Entry {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}  {}", self.id, self.title)?;
        for (name, text) in self.fields() {
            writeln!(f, "  {:<15} {}", format!("{name}:"), text.replace('\n', "\n                  "))?;
        }
        if !self.notes.is_empty() {
            writeln!(f, "\n{}", self.notes)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHAPTER: &str = "# Curvature\n\nIntroduction: not an entry.\n\n## CU-7  Curvature of an implicit curve\n\
        source:  002 eq (5); 003 def 2.1\nprinted: $$ k = a\n  + b $$\nverdict: erratum\ncorrect:\n\n$$ k = a - b $$\n\
        counterexample: a = 1/2\ndomain, unit: |∇f| ≠ 0\ncode: curvature::implicit::curve\n\nA note: why.\n\n\
        ## (b) A section\n\nNot a note.\n\n## CU-8  Another\nverdict: holds\ntests: a, b\n";

    #[test]
    fn an_entry_is_read_field_by_field() {
        let entries = parse(CHAPTER).expect("the chapter is sound");
        let [seven, eight] = &entries[..] else { panic!("two entries") };
        assert_eq!(seven.id.to_string(), "CU-7");
        assert_eq!(seven.title, "Curvature of an implicit curve");
        assert_eq!(seven.sources, ["002 eq (5)", "003 def 2.1"]);
        assert_eq!(seven.printed.as_deref(), Some("$$ k = a\n+ b $$"));
        assert_eq!(seven.correct.as_deref(), Some("$$ k = a - b $$"));
        assert_eq!(seven.verdict, Verdict::Erratum);
        assert_eq!(seven.conventions, [("domain, unit".to_owned(), "|∇f| ≠ 0".to_owned())]);
        assert_eq!(seven.tests, ["cu_7"]);
        assert_eq!(seven.notes, "A note: why.");
        assert_eq!(eight.tests, ["a", "b"]);
        assert_eq!(eight.printed, None);
    }

    #[test]
    fn what_is_wrong_with_a_chapter_is_named() {
        let error = |chapter: &str| parse(chapter).expect_err("the chapter is unsound").to_string();
        assert_eq!(error("\n## 7 x"), "line 2: \"7\" is not an id; ids are such as CU-7");
        assert!(error("## CU-1 x\nverdict: maybe").starts_with("CU-1: the verdict is \"maybe\""));
        assert_eq!(error("## CU-1 x\nverdict: holds\nverdict: holds"), "CU-1: `verdict` stands twice");
        assert_eq!(
            error("## CU-1 x\nverdict: erratum\ncorrect: y"),
            "CU-1: an erratum has a corrected formula and a counterexample"
        );
    }

    #[test]
    fn the_embedded_chapters_are_sound() {
        assert!(!entries().expect("the chapters are sound").is_empty());
    }
}

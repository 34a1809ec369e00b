//! Gluing schemes as text: polyhedra, and which of their faces are glued.
//!
//! ```text
//! # RP³: the two faces of a lens, glued after half a turn.
//! polyhedron lens
//! edges 0>1 1>0
//! face 1 2
//! face -2 -1
//! glue lens.0 lens.1 shift -1 dir -1
//! ```
//!
//! A line is one statement; `#` begins a comment. `polyhedron`, perhaps with a name, begins a polyhedron, which has its number
//! from 0 on. Its faces come in one of two ways, in one line or in several:
//! - `edges tail>head …` and `face ±edge …`: edges have numbers from 1 on, − walks from head to tail;
//! - `faces (0 3 2 1) (4 5 6 7) …`: the cycles of their vertices; two vertices have one edge at most.
//!
//! `glue p.f q.g shift s dir d` glues face f of polyhedron p to face g of polyhedron q, polyhedra by number or name, faces by number from
//! 0 on: corner i to corner s + d·i. Nothing is checked but the writing; a name may be used before it is given.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::str::FromStr;
use thiserror::Error;
use winnow::ascii::{digit1, space0, space1};
use winnow::combinator::{
    alt, cut_err, delimited, eof, fail, not, opt, preceded, repeat, separated, separated_pair, terminated,
};
use winnow::error::{ContextError, StrContext, StrContextValue};
use winnow::prelude::*;
use winnow::token::{one_of, take_while};

/// The most bytes that a text may have: 16 MiB.
pub const MAX_BYTES: usize = 1 << 24;

/// A scheme as a text has it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SchemeRecord {
    /// The polyhedra, by number.
    pub polyhedra: Vec<PolyhedronRecord>,
    /// The statements `glue`.
    pub pairings: Vec<PairingRecord>,
}

/// A polyhedron, in one of two ways.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PolyhedronRecord {
    /// By the cycles of the faces' vertices, one at least.
    Cycles(Vec<Vec<u32>>),
    /// By edges and faces.
    Sides {
        /// Tail and head of each edge.
        edges: Vec<[u32; 2]>,
        /// The sides of each face: ±(1 + the index of an edge).
        faces: Vec<Vec<i32>>,
    },
}

/// A pairing: corner i of face `a` to corner shift + dir · i of face `b`; faces as polyhedron and number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PairingRecord {
    /// One face.
    pub a: [usize; 2],
    /// The other face.
    pub b: [usize; 2],
    /// Where corner 0 goes.
    pub shift: i64,
    /// 1 or −1, if it is right.
    pub dir: i64,
}

/// Why a text is no scheme.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SchemeTextError {
    /// More than [`MAX_BYTES`].
    #[error("the text has {0} bytes, more than {MAX_BYTES}")]
    TooLong(usize),
    /// A line that is not UTF-8.
    #[error("line {0} is not UTF-8")]
    NotUtf8(usize),
    /// Something else stands where something is expected. Lines and columns count from 1, columns in characters.
    #[error("line {line}, column {column}: expected {expected}, found {found}")]
    Syntax {
        /// The line.
        line: usize,
        /// The column.
        column: usize,
        /// What could stand there.
        expected: String,
        /// What stands there.
        found: String,
    },
}

/// Reads a text.
///
/// # Errors
/// Iff it is too long, is not UTF-8, or has a line that is no statement, stands where it may not, or names a polyhedron that is
/// not there or a name twice: the first such line.
pub fn read(bytes: &[u8]) -> Result<SchemeRecord, SchemeTextError> {
    if bytes.len() > MAX_BYTES {
        return Err(SchemeTextError::TooLong(bytes.len()));
    }
    let text = std::str::from_utf8(bytes).map_err(|error| {
        SchemeTextError::NotUtf8(1 + bytes[..error.valid_up_to()].iter().filter(|byte| **byte == b'\n').count())
    })?;
    let mut reader = Reader::default();
    for (number, line) in text.strip_prefix('\u{feff}').unwrap_or(text).lines().enumerate() {
        let place = Place { line: number + 1, text: line };
        let statement = line.split('#').next().unwrap_or_default();
        match whole_line.parse(statement) {
            Ok(None) => {}
            Ok(Some(statement)) => reader.take(statement, place)?,
            Err(error) => return Err(place.error(error.offset(), expected(error.inner()))),
        }
    }
    reader.finish()
}

/// Writes a scheme, a line a statement, that reads back as the same record.
pub fn write(record: &SchemeRecord) -> String {
    let mut text = String::new();
    let mut line = |words: Vec<String>| writeln!(text, "{}", words.join(" ")).expect("a string can be written to");
    let list = |word: &str, items: Vec<String>| [vec![word.to_owned()], items].concat();
    for (number, polyhedron) in record.polyhedra.iter().enumerate() {
        line(vec![if record.polyhedra.len() > 1 { format!("polyhedron # {number}") } else { "polyhedron".to_owned() }]);
        match polyhedron {
            PolyhedronRecord::Cycles(cycles) => {
                line(list("faces", cycles.iter().map(|cycle| format!("({})", words(cycle).join(" "))).collect()));
            }
            PolyhedronRecord::Sides { edges, faces } => {
                if !edges.is_empty() {
                    line(list("edges", edges.iter().map(|[tail, head]| format!("{tail}>{head}")).collect()));
                }
                faces.iter().for_each(|face| line(list("face", words(face))));
            }
        }
    }
    for PairingRecord { a: [p, f], b: [q, g], shift, dir } in &record.pairings {
        line(vec![format!("glue {p}.{f} {q}.{g} shift {shift} dir {dir}")]);
    }
    text
}

fn words<T: ToString>(items: &[T]) -> Vec<String> {
    items.iter().map(T::to_string).collect()
}

/// What a line says.
#[derive(Clone, Debug)]
enum Statement<'a> {
    Polyhedron(Option<&'a str>),
    Edges(Vec<[u32; 2]>),
    Face(Vec<i32>),
    Faces(Vec<Vec<u32>>),
    Glue { a: (Name<'a>, usize), b: (Name<'a>, usize), shift: i64, dir: i64 },
}

/// A polyhedron as `glue` names it.
#[derive(Clone, Copy, Debug)]
enum Name<'a> {
    Number(usize),
    Word(&'a str),
}

#[derive(Clone, Copy, Debug)]
struct Place<'a> {
    line: usize,
    text: &'a str,
}

impl Place<'_> {
    fn error(self, offset: usize, expected: impl Into<String>) -> SchemeTextError {
        let rest = self.text.get(offset..).and_then(|rest| rest.split('#').next()).unwrap_or_default();
        let found = match rest.split_whitespace().next() {
            None => "the end of the line".to_owned(),
            Some(word) => format!("{:?}", word.chars().take(40).collect::<String>()),
        };
        // What stands before is part of a statement, so all of it is ASCII.
        SchemeTextError::Syntax { line: self.line, column: offset + 1, expected: expected.into(), found }
    }

    /// Where the statement begins.
    fn indent(self) -> usize {
        self.text.len() - self.text.trim_start().len()
    }

    /// Where a word begins that is not the first of the statement.
    fn argument(self, word: &str) -> usize {
        let keyword = self.text[self.indent()..].find([' ', '\t']).map_or(0, |length| self.indent() + length);
        keyword + self.text[keyword..].replace('\t', " ").find(word).unwrap_or(0)
    }
}

/// The polyhedra so far, and the pairings with their polyhedra still to be found.
#[derive(Default)]
struct Reader<'a> {
    polyhedra: Vec<PolyhedronRecord>,
    names: BTreeMap<&'a str, usize>,
    pairings: Vec<(Place<'a>, [Name<'a>; 2], PairingRecord)>,
}

impl<'a> Reader<'a> {
    fn take(&mut self, statement: Statement<'a>, place: Place<'a>) -> Result<(), SchemeTextError> {
        use PolyhedronRecord::{Cycles, Sides};
        let bare = |p: &PolyhedronRecord| matches!(p, Sides { edges, faces } if edges.is_empty() && faces.is_empty());
        match (statement, self.polyhedra.last_mut()) {
            (Statement::Polyhedron(name), _) => {
                let twice = name.filter(|name| self.names.insert(name, self.polyhedra.len()).is_some());
                if let Some(name) = twice {
                    return Err(place.error(place.argument(name), "a name that no polyhedron before has"));
                }
                self.polyhedra.push(Sides { edges: Vec::new(), faces: Vec::new() });
            }
            (Statement::Glue { a, b, shift, dir }, _) => {
                let record = PairingRecord { a: [0, a.1], b: [0, b.1], shift, dir };
                self.pairings.push((place, [a.0, b.0], record));
            }
            (Statement::Edges(more), Some(Sides { edges, .. })) => edges.extend(more),
            (Statement::Face(face), Some(Sides { faces, .. })) => faces.push(face),
            (Statement::Faces(more), Some(Cycles(cycles))) => cycles.extend(more),
            (Statement::Faces(cycles), Some(polyhedron)) if bare(polyhedron) => *polyhedron = Cycles(cycles),
            (Statement::Edges(_) | Statement::Face(_), Some(Cycles(_))) => {
                return Err(place.error(place.indent(), "`faces`, as this polyhedron began"));
            }
            (Statement::Faces(_), Some(_)) => {
                return Err(place.error(place.indent(), "`edges` or `face`, as this polyhedron began"));
            }
            (Statement::Edges(_) | Statement::Face(_) | Statement::Faces(_), None) => {
                return Err(place.error(place.indent(), "`polyhedron`, before its edges and faces"));
            }
        }
        Ok(())
    }

    fn finish(self) -> Result<SchemeRecord, SchemeTextError> {
        let number = |name: Name, place: Place| match name {
            Name::Number(number) => Ok(number),
            Name::Word(word) => {
                let unknown = || place.error(place.argument(&format!(" {word}.")) + 1, "the name of a polyhedron");
                self.names.get(word).copied().ok_or_else(unknown)
            }
        };
        let pairings = self.pairings.iter().map(|(place, [p, q], record)| {
            let (a, b) = ([number(*p, *place)?, record.a[1]], [number(*q, *place)?, record.b[1]]);
            Ok(PairingRecord { a, b, ..*record })
        });
        let pairings = pairings.collect::<Result<_, _>>()?;
        Ok(SchemeRecord { polyhedra: self.polyhedra, pairings })
    }
}

fn expected(error: &ContextError) -> String {
    let described = error.context().find_map(|context| match context {
        StrContext::Expected(value) => Some(value.to_string()),
        _ => None,
    });
    described.unwrap_or_else(|| "the end of the line".to_owned())
}

fn what(description: &'static str) -> StrContext {
    StrContext::Expected(StrContextValue::Description(description))
}

fn whole_line<'a>(input: &mut &'a str) -> ModalResult<Option<Statement<'a>>> {
    space0.parse_next(input)?;
    let end = (space0, eof.context(what("a space or the end of the line")));
    let statement = alt((polyhedron, edges, faces, face, glue, fail));
    let statement = statement.context(what("`polyhedron`, `edges`, `face`, `faces` or `glue`"));
    alt((eof.value(None), cut_err(terminated(statement, end)).map(Some))).parse_next(input)
}

fn polyhedron<'a>(input: &mut &'a str) -> ModalResult<Statement<'a>> {
    preceded("polyhedron", opt(preceded((space1, not(eof)), cut_err(name))))
        .map(Statement::Polyhedron)
        .parse_next(input)
}

fn edges<'a>(input: &mut &'a str) -> ModalResult<Statement<'a>> {
    let vertex = || cut_err(number(VERTEX));
    let arrow = cut_err('>'.context(what("`>` and the edge's head")));
    let edge = separated_pair(vertex(), arrow, vertex()).map(|(tail, head)| [tail, head]);
    preceded("edges", items(edge)).map(Statement::Edges).parse_next(input)
}

fn face<'a>(input: &mut &'a str) -> ModalResult<Statement<'a>> {
    let side = cut_err(number("a side, the number of an edge with the sign of its direction"));
    preceded("face", items(side)).map(Statement::Face).parse_next(input)
}

fn faces<'a>(input: &mut &'a str) -> ModalResult<Statement<'a>> {
    let vertices = delimited(space0, separated(0.., number::<u32>(VERTEX), space1), space0);
    let begin = cut_err('('.context(what("a face, as `(0 1 2)`")));
    let end = cut_err(')'.context(what("a vertex or `)`")));
    preceded("faces", items(delimited(begin, vertices, end))).map(Statement::Faces).parse_next(input)
}

fn glue<'a>(input: &mut &'a str) -> ModalResult<Statement<'a>> {
    "glue".parse_next(input)?;
    let mut face = cut_err(preceded(space1, polyhedron_face).context(what("a face, as `0.5` or `cube.5`")));
    let (a, b) = (face.parse_next(input)?, face.parse_next(input)?);
    let shift = preceded((space1, "shift", space1), number("an integer"));
    let shift = cut_err(shift.context(what("`shift` and an integer"))).parse_next(input)?;
    let dir = preceded((space1, "dir", space1), number("1 or -1"));
    let dir = cut_err(dir.context(what("`dir` and 1 or -1"))).parse_next(input)?;
    Ok(Statement::Glue { a, b, shift, dir })
}

fn polyhedron_face<'a>(input: &mut &'a str) -> ModalResult<(Name<'a>, usize)> {
    let polyhedron = alt((number(FACE).map(Name::Number), name.map(Name::Word)));
    separated_pair(polyhedron, '.', number(FACE)).parse_next(input)
}

const VERTEX: &str = "a vertex, a number from 0 on";
const FACE: &str = "a face, as `0.5` or `cube.5`";

fn name<'a>(input: &mut &'a str) -> ModalResult<&'a str> {
    let first = one_of(|c: char| c.is_ascii_alphabetic() || c == '_');
    let rest = take_while(0.., |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    (first, rest).take().context(what("a name: a letter, then letters, digits, `_` and `-`")).parse_next(input)
}

/// Integers of any type; one that the type does not hold is none.
fn number<'a, T: FromStr>(description: &'static str) -> impl ModalParser<&'a str, T, ContextError>
where
    T::Err: std::error::Error + Send + Sync + 'static,
{
    (opt('-'), digit1).take().try_map(|digits: &str| digits.parse()).context(what(description))
}

/// Any number of items, a space before each.
fn items<'a, T>(item: impl ModalParser<&'a str, T, ContextError>) -> impl ModalParser<&'a str, Vec<T>, ContextError> {
    repeat(0.., preceded((space1, not(eof)), item))
}

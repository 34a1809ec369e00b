//! The case table of the mesher: the triangles of each of the 768 labelled classes.
//!
//! `table.txt` holds it, a line a class; [`derive`](derive()) is the rule that it comes from, and a test compares
//! the two.

use super::cell::{Decisions, Join, assemble};
use super::classes::classes;
use super::cube::{Corner, Edge};
use super::patch::{Patch, PatchVertex, patch};
use std::fmt::Write;
use thiserror::Error;

const FROZEN: &str = include_str!("table.txt");

/// What the table knows of one class of signs and face decisions.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Entry {
    /// The triangles where there is no tunnel.
    pub patch: Patch,
    /// The tunnels that the class allows, with the triangles of each.
    pub tunnels: Vec<(Join, Patch)>,
}

/// The case table, by corner signs and face decisions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    entries: Vec<Entry>,
    /// For signs · 2⁶ + (the set of the faces that join their positive pair), the entry.
    index: Vec<u16>,
}

/// A line of a table that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("case table, line {line}: {text:?} is not a class with its triangles")]
pub struct BadLine {
    line: usize,
    text: String,
}

const NONE: u16 = u16::MAX;

fn key(positive: u8, joining: u8) -> usize {
    usize::from(positive) << 6 | usize::from(joining)
}

fn joining(faces: [i8; 6]) -> u8 {
    (0..6).filter(|&f| faces[f] > 0).fold(0, |set, f| set | 1 << f)
}

impl Table {
    /// The frozen table.
    pub fn frozen() -> Table {
        Table::parse(FROZEN).expect("the frozen table is compared with the rule by a test")
    }

    /// The entry for corner signs and the set of the faces that join their positive pair.
    pub fn entry(&self, positive: u8, joining: u8) -> &Entry {
        &self.entries[usize::from(self.index[key(positive, joining)])]
    }

    /// The triangles for a cell's decisions.
    pub fn patch(&self, decisions: &Decisions) -> &Patch {
        let entry = self.entry(decisions.positive, joining(decisions.faces));
        match decisions.tunnel {
            None => &entry.patch,
            Some(tunnel) => {
                let known = entry.tunnels.iter().find(|(join, _)| *join == tunnel);
                &known.expect("the table has every class of cells (IS-80)").1
            }
        }
    }

    /// A table from its text.
    pub fn parse(text: &str) -> Result<Table, BadLine> {
        let mut table = Table { entries: Vec::new(), index: vec![NONE; 1 << 14] };
        for (number, line) in text.lines().enumerate() {
            let bad = || BadLine { line: number + 1, text: line.to_owned() };
            let (decisions, patch) = parse_line(line).ok_or_else(bad)?;
            let slot = &mut table.index[key(decisions.positive, joining(decisions.faces))];
            match decisions.tunnel {
                None => {
                    *slot = table.entries.len() as u16;
                    table.entries.push(Entry { patch, tunnels: Vec::new() });
                }
                // A class without its tunnel stands before the same class with it.
                Some(_) if *slot == NONE => return Err(bad()),
                Some(tunnel) => table.entries[usize::from(*slot)].tunnels.push((tunnel, patch)),
            }
        }
        Ok(table)
    }
}

/// The text of the table, derived from the rule: `signs faces tunnel inner triangles…`. Signs are the set
/// of positive corners in hexadecimal; faces +, −, 0; the tunnel its two corners; an inner vertex the
/// crossings that it is the mean of. Edges are hexadecimal digits, inner vertices p and q.
pub fn derive() -> String {
    let mut text = String::new();
    for decisions in classes() {
        let patch = patch(&assemble(decisions));
        let faces: String = decisions.faces.iter().map(|f| ["-", "0", "+"][(f + 1) as usize]).collect();
        let tunnel =
            decisions.tunnel.map_or("--".into(), |Join { corners: [a, b] }| format!("{}{}", a.index(), b.index()));
        let edge = |e: &Edge| char::from_digit(e.index() as u32, 16).expect("an edge's number is below 16");
        let inner: Vec<String> = patch.inner.iter().map(|rim| rim.iter().map(edge).collect()).collect();
        let inner = if inner.is_empty() { "-".into() } else { inner.join(",") };
        write!(text, "{:02x} {faces} {tunnel} {inner}", decisions.positive).expect("writing to a string succeeds");
        for triangle in &patch.triangles {
            let triangle: String = triangle
                .iter()
                .map(|vertex| match vertex {
                    PatchVertex::Crossing(e) => edge(e),
                    PatchVertex::Inner(i) => char::from(b'p' + i),
                })
                .collect();
            write!(text, " {triangle}").expect("writing to a string succeeds");
        }
        text.push('\n');
    }
    text
}

fn parse_line(line: &str) -> Option<(Decisions, Patch)> {
    let mut words = line.split(' ');
    let positive = u8::from_str_radix(words.next()?, 16).ok()?;
    let mut faces = [0; 6];
    for (face, sign) in faces.iter_mut().zip(words.next()?.chars()) {
        *face = "-0+".find(sign)? as i8 - 1;
    }
    let tunnel = match words.next()? {
        "--" => None,
        pair => {
            let mut corners = pair.chars().map(|c| Some(*Corner::ALL.get(c.to_digit(8)? as usize)?));
            Some(Join { corners: [corners.next()??, corners.next()??] })
        }
    };
    let edge = |c: char| Edge::ALL.get(c.to_digit(16)? as usize).copied();
    let inner = match words.next()? {
        "-" => Vec::new(),
        rims => rims.split(',').map(|rim| rim.chars().map(edge).collect()).collect::<Option<_>>()?,
    };
    let vertex = |c: char| match c {
        'p' | 'q' => Some(PatchVertex::Inner(c as u8 - b'p')),
        c => edge(c).map(PatchVertex::Crossing),
    };
    let triangle = |word: &str| -> Option<[PatchVertex; 3]> {
        word.chars().map(vertex).collect::<Option<Vec<_>>>()?.try_into().ok()
    };
    let triangles = words.map(triangle).collect::<Option<_>>()?;
    Some((Decisions { positive, faces, tunnel }, Patch { inner, triangles }))
}

//! The triangulation files of SnapPea, SnapPy and Regina: ascii, tetrahedra with their neighbours, gluings and cusps.
//!
//! A first line `% Triangulation`, a line with the name, then words: what is known of the hyperbolic structure and its volume, of
//! orientability, of the Chern–Simons invariant; how many cusps are tori and Klein bottles, and each of them with its Dehn
//! filling; how many tetrahedra, and each of them.

use super::{Problem, excerpt};
use std::io::{BufRead, Write};
use std::str::FromStr;

/// A triangulation as a file has it. Nothing says that its gluings fit one another.
#[derive(Clone, Debug, PartialEq)]
pub struct SnapPeaRecord {
    /// One line.
    pub name: String,
    /// What is known of the hyperbolic structure.
    pub solution: Solution,
    /// The volume with that structure.
    pub volume: f64,
    /// What is said of orientability.
    pub orientability: Orientability,
    /// The Chern–Simons invariant, where it is known.
    pub chern_simons: Option<f64>,
    /// The cusps, which tetrahedra name by their places here.
    pub cusps: Vec<Cusp>,
    /// The tetrahedra.
    pub tetrahedra: Vec<TetrahedronRecord>,
}

/// What is known of a hyperbolic structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Solution {
    NotAttempted,
    Geometric,
    Nongeometric,
    Flat,
    Degenerate,
    Other,
    None,
}

const SOLUTIONS: [(&str, Solution); 7] = [
    ("not_attempted", Solution::NotAttempted),
    ("geometric_solution", Solution::Geometric),
    ("nongeometric_solution", Solution::Nongeometric),
    ("flat_solution", Solution::Flat),
    ("degenerate_solution", Solution::Degenerate),
    ("other_solution", Solution::Other),
    ("no_solution", Solution::None),
];

/// What a file says of orientability.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Orientability {
    Oriented,
    Nonorientable,
    Unknown,
}

const ORIENTABILITIES: [(&str, Orientability); 3] = [
    ("oriented_manifold", Orientability::Oriented),
    ("nonorientable_manifold", Orientability::Nonorientable),
    ("unknown_orientability", Orientability::Unknown),
];

/// A vertex that is taken out, or filled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cusp {
    /// The surface around it.
    pub surface: CuspSurface,
    /// The coefficients of meridian and longitude of its Dehn filling; 0, 0 for none.
    pub filling: [f64; 2],
}

/// The surface around a cusp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum CuspSurface {
    Torus,
    KleinBottle,
}

const SURFACES: [(&str, CuspSurface); 2] = [("torus", CuspSurface::Torus), ("Klein", CuspSurface::KleinBottle)];

/// A tetrahedron as a file has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TetrahedronRecord {
    /// The tetrahedra across the triangles opposite corners 0, 1, 2, 3.
    pub neighbours: [u32; 4],
    /// Where the corners 0, 1, 2, 3 go, across each of these triangles; each image is 0, 1, 2 or 3.
    pub gluings: [[u8; 4]; 4],
    /// The cusp at each corner, −1 for a vertex that is none, or of which nothing is said.
    pub cusps: [i32; 4],
    /// How often meridians and longitudes of the cusps run over its corners: of each, on the two sheets of the oriented double
    /// cover, by corner and triangle. All 0 where nothing is said.
    pub peripheral_curves: [[i32; 16]; 4],
    /// Its shape, real and imaginary part; 0, 0 where nothing is said.
    pub shape: [f64; 2],
}

impl SnapPeaRecord {
    /// Gluings alone, as rows (neighbours, gluings); of all else nothing is said.
    #[doc(alias = "CX-96")]
    pub fn of_rows(name: &str, rows: impl IntoIterator<Item = ([u32; 4], [[u8; 4]; 4])>) -> SnapPeaRecord {
        let tetrahedron = |(neighbours, gluings)| TetrahedronRecord {
            neighbours,
            gluings,
            cusps: [-1; 4],
            peripheral_curves: [[0; 16]; 4],
            shape: [0.0; 2],
        };
        SnapPeaRecord {
            name: name.to_owned(),
            solution: Solution::NotAttempted,
            volume: 0.0,
            orientability: Orientability::Unknown,
            chern_simons: None,
            cusps: Vec::new(),
            tetrahedra: rows.into_iter().map(tetrahedron).collect(),
        }
    }

    /// Its rows (neighbours, gluings).
    pub fn rows(&self) -> impl Iterator<Item = ([u32; 4], [[u8; 4]; 4])> + '_ {
        self.tetrahedra.iter().map(|t| (t.neighbours, t.gluings))
    }
}

const MAGIC: &str = "% Triangulation";

/// Reads a file.
///
/// Errors, each naming its line: another first line; a word that is none of those that may stand there; a number that is none, or
/// not finite; an image that is not 0 … 3; tori and Klein bottles other in number than the cusps; a file that ends early or goes on.
pub fn read(mut reader: impl BufRead) -> Result<SnapPeaRecord, Problem> {
    let mut text = String::new();
    reader.read_to_string(&mut text)?;
    let mut lines = text.lines();
    let first = lines.next().unwrap_or_default();
    if first.trim_end() != MAGIC {
        return Err(Problem::Magic { format: "SnapPea", found: excerpt(first.as_bytes()) });
    }
    let name = lines.next().ok_or(Problem::Missing { field: "name" })?.trim().to_owned();
    let words = (3..).zip(lines).flat_map(|(line, text)| text.split_ascii_whitespace().map(move |word| (line, word)));
    let mut words = Words { words, line: 2 };
    let solution = words.one_of("solution", "the kind of a solution", &SOLUTIONS)?;
    let volume = words.real("volume")?;
    let orientability = words.one_of("orientability", "a word on orientability", &ORIENTABILITIES)?;
    let chern_simons =
        match words.one_of("Chern-Simons", "CS_known or CS_unknown", &[("CS_known", true), ("CS_unknown", false)])? {
            true => Some(words.real("Chern-Simons")?),
            false => None,
        };
    let (tori, bottles): (u32, u32) = (words.number("tori", "a count")?, words.number("Klein bottles", "a count")?);
    let mut cusps = Vec::new();
    for _ in 0..u64::from(tori) + u64::from(bottles) {
        let surface = words.one_of("cusp", "torus or Klein", &SURFACES)?;
        cusps.push(Cusp { surface, filling: [words.real("meridian")?, words.real("longitude")?] });
    }
    if count(&cusps, CuspSurface::Torus) != tori as usize {
        return Err(words.invalid(
            "cusps",
            "as many tori as the count says",
            &count(&cusps, CuspSurface::Torus).to_string(),
        ));
    }
    let size: u32 = words.number("tetrahedra", "a count")?;
    let mut tetrahedra = Vec::new();
    for _ in 0..size {
        tetrahedra.push(words.tetrahedron()?);
    }
    match words.words.next() {
        None => Ok(SnapPeaRecord { name, solution, volume, orientability, chern_simons, cusps, tetrahedra }),
        Some((line, _)) => {
            Err(Problem::Overlong { field: format!("line {line}"), expected: u64::from(size), unit: "tetrahedra" })
        }
    }
}

fn count(cusps: &[Cusp], surface: CuspSurface) -> usize {
    cusps.iter().filter(|cusp| cusp.surface == surface).count()
}

/// The words of a file with the lines that they stand on.
struct Words<I> {
    words: I,
    /// The line of the last word.
    line: usize,
}

impl<'a, I: Iterator<Item = (usize, &'a str)>> Words<I> {
    fn next(&mut self, field: &'static str) -> Result<&'a str, Problem> {
        let (line, word) = self.words.next().ok_or(Problem::Missing { field })?;
        self.line = line;
        Ok(word)
    }

    fn invalid(&self, field: &str, expected: &'static str, found: &str) -> Problem {
        let field = format!("line {}: {field}", self.line);
        Problem::Invalid { field, expected, found: excerpt(found.as_bytes()) }
    }

    fn number<T: FromStr>(&mut self, field: &'static str, expected: &'static str) -> Result<T, Problem> {
        let word = self.next(field)?;
        word.parse().map_err(|_| self.invalid(field, expected, word))
    }

    fn real(&mut self, field: &'static str) -> Result<f64, Problem> {
        let word = self.next(field)?;
        let finite = word.parse().ok().filter(|x: &f64| x.is_finite());
        finite.ok_or_else(|| self.invalid(field, "a number", word))
    }

    fn one_of<T: Copy>(
        &mut self,
        field: &'static str,
        expected: &'static str,
        known: &[(&str, T)],
    ) -> Result<T, Problem> {
        let word = self.next(field)?;
        let found = known.iter().find(|(name, _)| *name == word);
        found.map(|(_, value)| *value).ok_or_else(|| self.invalid(field, expected, word))
    }

    fn tetrahedron(&mut self) -> Result<TetrahedronRecord, Problem> {
        let mut record = TetrahedronRecord {
            neighbours: [0; 4],
            gluings: [[0; 4]; 4],
            cusps: [0; 4],
            peripheral_curves: [[0; 16]; 4],
            shape: [0.0; 2],
        };
        for neighbour in &mut record.neighbours {
            *neighbour = self.number("neighbour", "the number of a tetrahedron")?;
        }
        for gluing in &mut record.gluings {
            let word = self.next("gluing")?;
            let images = word.bytes().map(|byte| byte.wrapping_sub(b'0')).collect::<Vec<u8>>();
            let images = <[u8; 4]>::try_from(images).ok().filter(|images| images.iter().all(|i| *i < 4));
            *gluing = images.ok_or_else(|| self.invalid("gluing", "four of the digits 0, 1, 2, 3", word))?;
        }
        for cusp in &mut record.cusps {
            *cusp = self.number("cusp of a corner", "the number of a cusp, or -1")?;
        }
        for curve in record.peripheral_curves.as_flattened_mut() {
            *curve = self.number("peripheral curve", "a whole number")?;
        }
        record.shape = [self.real("shape")?, self.real("shape")?];
        Ok(record)
    }
}

/// Writes a file. Reading it gives the same record, but for spaces around the name.
///
/// Errors: a name of several lines; an image that is not 0 … 3; a number that is not finite.
pub fn write(mut out: impl Write, record: &SnapPeaRecord) -> Result<(), Problem> {
    let invalid =
        |field: String, expected, found: &str| Problem::Invalid { field, expected, found: excerpt(found.as_bytes()) };
    if record.name.contains(['\n', '\r']) {
        return Err(invalid("name".to_owned(), "one line", &record.name));
    }
    let of_cusps = record.cusps.iter().flat_map(|cusp| cusp.filling);
    let of_shapes = record.tetrahedra.iter().flat_map(|t| t.shape);
    let mut numbers = [record.volume].into_iter().chain(record.chern_simons).chain(of_cusps).chain(of_shapes);
    if let Some(stray) = numbers.find(|x| !x.is_finite()) {
        return Err(invalid("number".to_owned(), "a finite one", &stray.to_string()));
    }
    writeln!(out, "{MAGIC}\n{}", record.name)?;
    writeln!(out, "{} {}", word(&SOLUTIONS, record.solution), decimal(record.volume))?;
    writeln!(out, "{}", word(&ORIENTABILITIES, record.orientability))?;
    match record.chern_simons {
        Some(value) => writeln!(out, "CS_known {}", decimal(value))?,
        None => writeln!(out, "CS_unknown")?,
    }
    let counts = [CuspSurface::Torus, CuspSurface::KleinBottle].map(|surface| count(&record.cusps, surface));
    writeln!(out, "{} {}", counts[0], counts[1])?;
    for Cusp { surface, filling: [m, l] } in &record.cusps {
        writeln!(out, "    {} {} {}", word(&SURFACES, *surface), decimal(*m), decimal(*l))?;
    }
    writeln!(out, "{}", record.tetrahedra.len())?;
    for (i, t) in record.tetrahedra.iter().enumerate() {
        let images = t.gluings.map(|images| images.map(|image| image.to_string()).concat());
        if let Some(stray) = t.gluings.iter().position(|images| images.iter().any(|image| *image > 3)) {
            return Err(invalid(format!("tetrahedron {i}"), "images 0, 1, 2, 3", &images[stray]));
        }
        writeln!(out, "{}", padded(&t.neighbours, 4))?;
        writeln!(out, " {}", images.join(" "))?;
        writeln!(out, "{}", padded(&t.cusps, 4))?;
        for curves in &t.peripheral_curves {
            writeln!(out, "{}", padded(curves, 2))?;
        }
        writeln!(out, "{} {}", decimal(t.shape[0]), decimal(t.shape[1]))?;
    }
    Ok(())
}

fn word<T: Copy + PartialEq>(known: &[(&'static str, T)], value: T) -> &'static str {
    known.iter().find(|(_, known)| *known == value).expect("each value has its word").0
}

/// The shortest decimal of the number, with a point.
fn decimal(x: f64) -> String {
    format!("{x:?}")
}

fn padded<T: ToString>(numbers: &[T], width: usize) -> String {
    numbers.iter().map(|n| format!(" {:>width$}", n.to_string())).collect()
}

//! Files of points: one a line, its coordinates between blanks or commas.

use isoracle::number::Rational;
use isoracle::number::text::{self, NumberError};
use miette::Diagnostic;
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The file after `--points` cannot be used.
#[derive(Debug, Error, Diagnostic)]
pub enum UnusablePoints {
    #[error("--points: {}: {error}", .path.display())]
    #[diagnostic(help("`-` reads the points from stdin"))]
    Unreadable { path: PathBuf, error: io::Error },
    #[error("--points: line {line}: expected {expected} coordinates, found {found}")]
    #[diagnostic(help(
        "a line is a point: its coordinates between blanks or commas, such as `1 5/2 0.25`; # begins a comment"
    ))]
    Dimension { line: usize, expected: usize, found: usize },
    #[error("--points: line {line}, coordinate {coordinate}: {error}")]
    #[diagnostic(help("a coordinate is exact: 3, -7/2, 0.1 (one tenth, not the binary64 nearest to it), 0x1.8p-3"))]
    Coordinate { line: usize, coordinate: usize, error: NumberError },
}

/// The points of a file, or of stdin where it is `-`; blank lines, and what follows a `#`, are passed over.
pub fn read<const N: usize>(path: &Path) -> Result<Vec<[Rational; N]>, UnusablePoints> {
    let text = if path == Path::new("-") {
        let mut text = String::new();
        io::stdin().lock().read_to_string(&mut text).map(|_| text)
    } else {
        fs::read_to_string(path)
    };
    parse(&text.map_err(|error| UnusablePoints::Unreadable { path: path.to_owned(), error })?)
}

fn parse<const N: usize>(text: &str) -> Result<Vec<[Rational; N]>, UnusablePoints> {
    let mut points = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let line_number = i + 1;
        let line = line.split('#').next().unwrap_or_default();
        let words: Vec<&str> =
            line.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty()).collect();
        if words.is_empty() {
            continue;
        }
        let mut coordinates = Vec::with_capacity(N);
        for (i, word) in words.iter().enumerate() {
            let number = text::parse(word);
            coordinates.push(number.map_err(|error| UnusablePoints::Coordinate {
                line: line_number,
                coordinate: i + 1,
                error,
            })?);
        }
        let found = coordinates.len();
        let point = coordinates.try_into();
        points.push(point.map_err(|_| UnusablePoints::Dimension { line: line_number, expected: N, found })?);
    }
    Ok(points)
}

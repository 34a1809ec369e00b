//! The built-in candidates of all suites, as processes that speak the protocol.

use super::isosurface::builtin::Builtin as Mesher;
use super::numbers::builtin::Formulas;
use crate::answer::message::{Out, Question, Refusal};
use serde_json::Value;
use std::io::{self, BufRead, Write};
use std::str::FromStr;
use thiserror::Error;

/// A built-in candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Builtin {
    /// One for the suite `isosurface`.
    Mesher(Mesher),
    /// One for the suites `spline` and `curvature`.
    Formulas(Formulas),
}

/// A name that is none of them.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{found:?} is no built-in candidate; there are {}", names().join(", "))]
pub struct UnknownBuiltin {
    found: String,
}

fn all() -> impl Iterator<Item = Builtin> {
    let meshers = Mesher::ALL.into_iter().map(Builtin::Mesher);
    meshers.chain(Formulas::ALL.into_iter().map(Builtin::Formulas))
}

/// The names of all of them.
pub fn names() -> Vec<&'static str> {
    all().map(Builtin::name).collect()
}

impl Builtin {
    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Builtin::Mesher(mesher) => mesher.name(),
            Builtin::Formulas(formulas) => formulas.name(),
        }
    }

    fn answer(self, question: &Question) -> Result<Out, Refusal> {
        match self {
            Builtin::Mesher(mesher) => mesher.answer(question),
            Builtin::Formulas(formulas) => formulas.answer(question),
        }
    }
}

impl FromStr for Builtin {
    type Err = UnknownBuiltin;
    fn from_str(name: &str) -> Result<Builtin, UnknownBuiltin> {
        all().find(|builtin| builtin.name() == name).ok_or_else(|| UnknownBuiltin { found: name.to_owned() })
    }
}

/// Speaks the protocol for a built-in candidate until the input ends.
///
/// # Errors
/// The input or the output failed.
pub fn serve(builtin: Builtin, input: impl BufRead, mut output: impl Write) -> io::Result<()> {
    for line in input.split(b'\n') {
        let line = match Question::parse(&line?) {
            Err(refusal) => refusal.line(&Value::Null),
            Ok(question) => match builtin.answer(&question) {
                Ok(out) => out.line(&question.id),
                Err(refusal) => refusal.line(&question.id),
            },
        };
        output.write_all(line.as_bytes())?;
        output.write_all(b"\n")?;
        output.flush()?;
    }
    Ok(())
}

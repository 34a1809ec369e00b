//! Question → room → answer: the protocol that the oracle speaks and a candidate is judged by.
//!
//! One line of JSON a question, one line an answer, in order. A line that consists of spaces, tabs and
//! carriage returns alone is no question and has no answer. Limits: [`MAX_LINE`] bytes a line,
//! [`MAX_SAMPLES`](value::MAX_SAMPLES) samples a volume,
//! [`MAX_CHARACTERS`](crate::number::text::MAX_CHARACTERS) characters a number, exponents up to
//! [`MAX_EXPONENT`](crate::number::text::MAX_EXPONENT), 127 levels of nesting.

pub mod angle_deficits;
pub mod complex;
pub mod complex_refine;
pub mod curvature;
pub mod isosurface;
pub mod mesh;
pub mod mesh_check;
pub mod mesh_report;
pub mod message;
pub mod scheme_file;
pub mod spline;
pub mod trilinear;
pub mod value;
pub mod volume;

use message::{Out, PROTOCOL, Question, Refusal};
use serde_json::{Value, json};
use std::io::{self, BufRead, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;
use value::Object;

/// The most bytes that a line may have, its newline not counted: 64 MiB.
pub const MAX_LINE: usize = 1 << 26;

/// From this length on a line is answered before the next one is read, so that long ones never pile up.
const LONG_LINE: usize = 1 << 16;

/// How many questions may be under way at once.
const UNDER_WAY: usize = 64;

/// An operation: its fields in, its answer out.
pub type Operation = fn(&Object) -> Result<Out, Refusal>;

/// The operations by their names, but `hello`.
pub const OPERATIONS: &[(&str, Operation)] = &[
    ("isosurface.square", isosurface::square),
    ("isosurface.cell", isosurface::cell),
    ("isosurface.topology", isosurface::topology),
    ("isosurface.mesh", isosurface::mesh),
    ("isosurface.polyline", isosurface::polyline),
    ("isosurface.tetrahedra", isosurface::tetrahedra),
    ("spline.coefficients", spline::coefficients),
    ("spline.evaluate", spline::evaluate),
    ("spline.impulse", spline::impulse),
    ("trilinear.evaluate", trilinear::evaluate),
    ("curvature.implicit_curve", curvature::implicit_curve),
    ("curvature.implicit_surface", curvature::implicit_surface),
    ("curvature.parametric_curve", curvature::parametric_curve),
    ("curvature.parametric_surface", curvature::parametric_surface),
    ("curvature.spline", spline::curvature),
    ("curvature.normalize", curvature::normalize),
    ("mesh.check", mesh_check::check),
    ("mesh.plane", mesh_check::plane),
    ("mesh.angle_deficits", angle_deficits::angle_deficits),
    ("complex.glue", complex::glue),
    ("complex.refine", complex_refine::refine),
];

/// Answers every line of the input, in order, each flushed as soon as it and those before it are known;
/// several are worked on at once. Returns when the input ends.
///
/// # Errors
/// The input or the output failed; `BrokenPipe` where nobody reads the answers any more.
pub fn serve(mut input: impl BufRead, mut output: impl Write + Send) -> io::Result<()> {
    let (queue, answers) = sync_channel::<Receiver<String>>(UNDER_WAY);
    thread::scope(|scope| {
        let writer = scope.spawn(move || {
            for answer in answers {
                let mut line: String = answer.recv().expect("every line is answered, for panics are caught");
                line.push('\n');
                output.write_all(line.as_bytes())?;
                output.flush()?;
            }
            Ok(())
        });
        let end_of_input = ask(&mut input, &queue);
        drop(queue);
        writer.join().expect("the writer does not panic").and(end_of_input)
    })
}

/// Sets the work on each line going, and queues where its answer will come from.
fn ask(input: &mut impl BufRead, queue: &SyncSender<Receiver<String>>) -> io::Result<()> {
    while let Some(line) = Line::read(input, MAX_LINE)? {
        if line.is_blank() {
            continue;
        }
        let is_long = line.is_long();
        let (reply, answer) = sync_channel(1);
        // The answer finds nobody to receive it only where the output has failed, which the writer reports.
        let work = move || drop(reply.send(line.answer()));
        if is_long {
            work();
        } else {
            rayon::spawn(work);
        }
        if queue.send(answer).is_err() {
            break;
        }
    }
    Ok(())
}

/// A line of the input, without its newline.
#[derive(Debug, PartialEq, Eq)]
enum Line {
    Bytes(Vec<u8>),
    TooLong,
}

impl Line {
    /// The next line, or `None` at the end of the input. What goes beyond the limit is read and dropped.
    fn read(input: &mut impl BufRead, limit: usize) -> io::Result<Option<Line>> {
        let (mut line, mut too_long, mut is_end) = (Vec::new(), false, true);
        loop {
            let available = match input.fill_buf() {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                other => other?,
            };
            if available.is_empty() && is_end {
                return Ok(None);
            }
            is_end = false;
            let newline = available.iter().position(|&byte| byte == b'\n');
            let part = &available[..newline.unwrap_or(available.len())];
            too_long |= line.len() + part.len() > limit;
            if too_long {
                line = Vec::new();
            } else {
                line.extend_from_slice(part);
            }
            let used = part.len() + usize::from(newline.is_some());
            input.consume(used);
            if newline.is_some() || used == 0 {
                return Ok(Some(if too_long { Line::TooLong } else { Line::Bytes(line) }));
            }
        }
    }

    fn is_blank(&self) -> bool {
        matches!(self, Line::Bytes(bytes) if bytes.iter().all(|byte| b" \t\r".contains(byte)))
    }

    fn is_long(&self) -> bool {
        matches!(self, Line::Bytes(bytes) if bytes.len() >= LONG_LINE)
    }

    /// The line to answer with, without its newline.
    fn answer(&self) -> String {
        match self {
            Line::Bytes(bytes) => answer(bytes),
            Line::TooLong => Refusal::LineTooLong(MAX_LINE).line(&Value::Null),
        }
    }
}

/// The line that answers a line, both without their newlines.
pub fn answer(line: &[u8]) -> String {
    let question = match Question::parse(line) {
        Ok(question) => question,
        Err(refusal) => return refusal.line(&Value::Null),
    };
    match contained(|| out(&question.op, question.input()?)) {
        Ok(out) => out.line(&question.id),
        Err(refusal) => {
            tracing::debug!(id = %question.id, op = question.op, %refusal);
            refusal.line(&question.id)
        }
    }
}

/// What an operation answers.
///
/// # Errors
/// No such operation, or what the operation says.
pub fn out(op: &str, input: &Object) -> Result<Out, Refusal> {
    if op == "hello" {
        return hello(input);
    }
    match OPERATIONS.iter().find(|(name, _)| *name == op) {
        Some((_, operation)) => operation(input),
        None => Err(Refusal::NoSuchOperation(op.chars().take(100).collect())),
    }
}

/// `hello` in `{protocol?}`.
fn hello(input: &Object) -> Result<Out, Refusal> {
    match value::optional(input, "protocol", value::number)? {
        Some(version) if version != PROTOCOL => Err(Refusal::NoSuchProtocol(version)),
        Some(_) | None => {
            let ops: Vec<&str> = OPERATIONS.iter().map(|(name, _)| *name).collect();
            let (name, version) = (env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION"));
            Ok(Out::new(&json!({"protocol": PROTOCOL, "name": name, "version": version, "ops": ops})))
        }
    }
}

/// The result of some work, a panic being one of them.
fn contained(work: impl FnOnce() -> Result<Out, Refusal>) -> Result<Out, Refusal> {
    // What a panic may leave half done belongs to the question, and is dropped with it.
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
        Err(Refusal::Panic(text.unwrap_or("a panic without a text").to_owned()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{BufReader, Cursor};

    fn lines(input: &[u8], limit: usize, buffer: usize) -> Vec<Line> {
        let mut input = BufReader::with_capacity(buffer, Cursor::new(input));
        std::iter::from_fn(|| Line::read(&mut input, limit).expect("memory can be read")).collect()
    }

    #[test]
    fn lines_are_cut_at_newlines_whatever_the_buffer() {
        let bytes = |text: &str| Line::Bytes(text.as_bytes().to_vec());
        for buffer in 1..12 {
            assert_eq!(lines(b"", 4, buffer), []);
            assert_eq!(lines(b"\n", 4, buffer), [bytes("")]);
            assert_eq!(lines(b"abcd\n\nef", 4, buffer), [bytes("abcd"), bytes(""), bytes("ef")]);
            assert_eq!(lines(b"abcde\nfghi\n", 4, buffer), [Line::TooLong, bytes("fghi")]);
            assert_eq!(lines(b"abcdefghijklm", 4, buffer), [Line::TooLong]);
        }
    }

    #[test]
    fn a_panic_is_an_internal_error() {
        let refusal = contained(|| panic!("at the {}", "disco")).expect_err("it panicked");
        assert_eq!(
            refusal.line(&json!(7)),
            r#"{"id":7,"error":{"kind":"internal","message":"a bug in the oracle: at the disco"}}"#
        );
    }
}

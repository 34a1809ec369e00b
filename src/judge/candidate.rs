//! A candidate: somebody's implementation, asked over the protocol.

use crate::answer::value::Object;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;
use thiserror::Error;

/// What came back for a question.
#[derive(Clone, Debug, PartialEq)]
pub enum Reply {
    /// An answer.
    Out(Value),
    /// The candidate does not do that.
    Unsupported(String),
    /// The candidate says that the question has no answer.
    Error {
        /// The protocol's kind.
        kind: String,
        /// Its message.
        message: String,
    },
    /// It crashed, hung, or spoke nonsense.
    Broken(Breakdown),
}

/// How a candidate failed to answer at all.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Breakdown {
    /// It could not be started.
    #[error("it cannot be started: {0}")]
    NotStarted(String),
    /// It ended, or closed its output, before it answered.
    #[error("it ended before it answered ({0})")]
    Ended(String),
    /// It took too long.
    #[error("no answer within {0:?}")]
    Hung(Duration),
    /// What it said is no message of the protocol.
    #[error("not a message of the protocol: {0}")]
    Nonsense(String),
}

/// Anything that can be asked.
pub trait Candidate {
    /// Asks one question and waits for its answer.
    fn ask(&mut self, op: &str, input: &Value) -> Reply;
    /// The words that start it.
    fn command(&self) -> &[String];
}

/// A process that speaks the protocol; started anew after each breakdown.
pub struct Process {
    command: Vec<String>,
    limit: Duration,
    running: Option<Running>,
    next_id: u64,
}

struct Running {
    child: Child,
    input: ChildStdin,
    lines: Receiver<Vec<u8>>,
}

/// The most that a candidate may say in one line: 256 MiB.
const MAX_LINE: u64 = 1 << 28;

impl Process {
    /// A candidate that `command` starts, with a limit on each answer.
    pub fn new(command: Vec<String>, limit: Duration) -> Process {
        Process { command, limit, running: None, next_id: 0 }
    }

    fn start(&mut self) -> Result<&mut Running, Breakdown> {
        if self.running.is_none() {
            let not_started = |why: String| Breakdown::NotStarted(why);
            let (program, arguments) = self.command.split_first().ok_or_else(|| not_started("no command".into()))?;
            let mut child = Command::new(program)
                .args(arguments)
                .stdin(Stdio::piped())
                .stdout(Stdio::piped())
                .spawn()
                .map_err(|error| not_started(format!("{program}: {error}")))?;
            let input = child.stdin.take().expect("stdin is piped");
            let output = child.stdout.take().expect("stdout is piped");
            let (sender, lines) = channel();
            std::thread::spawn(move || {
                let mut output = BufReader::new(output);
                loop {
                    let mut line = Vec::new();
                    let mut limited = std::io::Read::take(&mut output, MAX_LINE);
                    match limited.read_until(b'\n', &mut line) {
                        Ok(n) if n > 0 && sender.send(line).is_ok() => {}
                        _ => return,
                    }
                }
            });
            self.running = Some(Running { child, input, lines });
        }
        Ok(self.running.as_mut().expect("it was started just now"))
    }

    fn exchange(&mut self, op: &str, input: &Value) -> Result<Reply, Breakdown> {
        self.next_id += 1;
        let (id, limit) = (self.next_id, self.limit);
        let running = self.start()?;
        let mut question = json!({"id": id, "op": op, "in": input}).to_string();
        question.push('\n');
        // A candidate that does not read is one that has ended, or will hang.
        if running.input.write_all(question.as_bytes()).and_then(|()| running.input.flush()).is_err() {
            return Err(Breakdown::Ended(running.status()));
        }
        match running.lines.recv_timeout(limit) {
            Ok(line) => parse_reply(&line, id),
            Err(RecvTimeoutError::Timeout) => Err(Breakdown::Hung(limit)),
            Err(RecvTimeoutError::Disconnected) => Err(Breakdown::Ended(running.status())),
        }
    }
}

impl Running {
    fn status(&mut self) -> String {
        // Its output is closed; it may need a moment to end.
        for _ in 0..20 {
            if let Ok(Some(status)) = self.child.try_wait() {
                return status.to_string();
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        "it closed its output".into()
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Candidate for Process {
    fn ask(&mut self, op: &str, input: &Value) -> Reply {
        self.exchange(op, input).unwrap_or_else(|breakdown| {
            self.running = None;
            Reply::Broken(breakdown)
        })
    }

    fn command(&self) -> &[String] {
        &self.command
    }
}

/// The first characters of what was said, for a message.
fn excerpt(line: &[u8]) -> String {
    let text = String::from_utf8_lossy(line);
    let text = text.trim_end();
    match text.char_indices().nth(120) {
        Some((end, _)) => format!("{:?}…", &text[..end]),
        None => format!("{text:?}"),
    }
}

fn parse_reply(line: &[u8], id: u64) -> Result<Reply, Breakdown> {
    let nonsense = || Breakdown::Nonsense(excerpt(line));
    let message: Object = serde_json::from_slice(line).map_err(|_| nonsense())?;
    if message.get("id").and_then(Value::as_u64) != Some(id) {
        return Err(nonsense());
    }
    if let Some(out) = message.get("out") {
        return Ok(Reply::Out(out.clone()));
    }
    if let Some(why) = message.get("unsupported") {
        return Ok(Reply::Unsupported(why.as_str().unwrap_or_default().to_owned()));
    }
    let error = message.get("error").and_then(Value::as_object).ok_or_else(nonsense)?;
    let text = |name: &str| error.get(name).and_then(Value::as_str).unwrap_or_default().to_owned();
    Ok(Reply::Error { kind: text("kind"), message: text("message") })
}

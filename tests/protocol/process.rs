//! How the service, and the process, end.

use isoracle::answer::serve;
use serde_json::Value;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Command, Stdio};

struct Broken;

impl Write for Broken {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(io::ErrorKind::BrokenPipe.into())
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn nobody_reading_ends_the_service() {
    let questions = BufReader::new(LoopOf(b"{}\n"));
    let error = serve(questions, Broken).expect_err("the output is broken");
    assert_eq!(error.kind(), io::ErrorKind::BrokenPipe);
}

/// The same bytes again and again, without end.
struct LoopOf(&'static [u8]);

impl Read for LoopOf {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.0.len().min(buffer.len());
        buffer[..count].copy_from_slice(&self.0[..count]);
        Ok(count)
    }
}

fn binary() -> Command {
    Command::new(assert_cmd::cargo::cargo_bin!("isoracle"))
}

#[test]
fn the_process_answers_each_line_before_the_next_is_sent_and_ends_with_its_input() {
    let mut process =
        binary().arg("answer").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("the binary starts");
    let mut input = process.stdin.take().expect("stdin is a pipe");
    let mut output = BufReader::new(process.stdout.take().expect("stdout is a pipe"));
    for line in ["nonsense", r#"{"id":1,"op":"hello"}"#, "[]", r#"{"id":2,"op":"nothing"}"#, r#"{"id":3,"op":"hello"}"#]
    {
        writeln!(input, "{line}").expect("the process reads");
        let mut answer = String::new();
        output.read_line(&mut answer).expect("the process answers");
        let answer: Value = serde_json::from_str(&answer).expect("an answer is JSON");
        assert!(["out", "error", "unsupported"].iter().any(|field| answer.get(field).is_some()));
    }
    drop(input);
    let mut rest = String::new();
    output.read_to_string(&mut rest).expect("the process closes its output");
    assert_eq!(rest, "");
    assert_eq!(process.wait().expect("the process ends").code(), Some(0));
}

#[test]
fn the_process_ends_quietly_when_nobody_reads() {
    let mut process = binary()
        .arg("answer")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the binary starts");
    let mut input = process.stdin.take().expect("stdin is a pipe");
    drop(process.stdout.take());
    // It ends at some time while it is written to.
    while input.write_all(b"{\"id\":1,\"op\":\"hello\"}\n").is_ok() {}
    drop(input);
    let output = process.wait_with_output().expect("the process ends");
    assert_eq!((output.status.code(), String::from_utf8_lossy(&output.stderr).as_ref()), (Some(0), ""));
}

//! `isoracle answer`.

use clap::Args;
use std::io;
use std::process::ExitCode;

/// Answer questions, one line of JSON each, from stdin to stdout, until stdin ends.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Answer {}

const AFTER_HELP: &str = r#"Examples:
  $ echo '{"id":1,"op":"hello","in":{"protocol":1}}' | isoracle answer
  $ echo '{"id":2,"op":"isosurface.cell","in":{"values":[1,-1,-1,1,-1,1,1,"-1/3"],"isovalue":0}}' | isoracle answer

A line that is no question, or one without an answer, is answered with an error, and the next line is read."#;

impl Answer {
    pub fn run(self) -> miette::Result<ExitCode> {
        super::to_stdout(isoracle::answer::serve(io::stdin().lock(), io::stdout()))
    }
}

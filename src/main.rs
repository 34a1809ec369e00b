//! The command line, thin.
use std::io;
fn main() -> io::Result<()> {
    isoracle::answer::serve(io::stdin().lock(), io::stdout())
}

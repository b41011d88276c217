//! Shows what the compiler makes of a declaration: its diagnostics, its report, and the Rust source that it emits.
//!
//! `cargo run -p plm-compiler --example dump` takes the manual's double pendulum; a file with the inside of a `mechanism!` call as
//! argument takes that, and `-` the standard input. `--check` gives diagnostics alone, and so does `--message-format json`: an
//! object a line, on the standard output. After an error the exit code is 1.

mod command;

use std::error::Error;
use std::io::{stderr, stdin, stdout};
use std::process::ExitCode;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let has_errors = command::run(std::env::args().skip(1), &mut stdin(), &mut stdout(), &mut stderr())?;
    Ok(if has_errors { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

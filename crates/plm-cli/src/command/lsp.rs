//! `plm lsp`: a language server on standard input and output.

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::server;

pub(super) const COMMAND: Command = Command {
    name: "lsp",
    usage: "",
    title: "serves an editor on standard input and output (language server protocol)",
    // Clients say which way they speak; there is one.
    options: &[("--stdio", "without meaning: standard input and output are the only way")],
    run,
};

fn run(mut words: Words, _: &mut Streams) -> Result<Outcome, Failure> {
    words.takes("--stdio");
    words.nothing()?;
    server::serve().map_err(|failure| failure.to_string())?;
    Ok(Outcome::Good)
}

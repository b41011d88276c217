//! `plm mcp`: a server of the Model Context Protocol on standard input and output.

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::mcp::{self, Limits};

pub(super) const COMMAND: Command = Command {
    name: "mcp",
    usage: "…",
    title: "serves an agent on standard input and output (Model Context Protocol)",
    options: &[
        ("--folder FOLDER", "the only folder whose files calls read and write; without it the present one"),
        ("--seconds SECONDS", "the limit of time of a call (60)"),
        ("--memory MEBIBYTES", "the limit of memory of a call (1024)"),
    ],
    run,
};

fn run(mut words: Words, _: &mut Streams) -> Result<Outcome, Failure> {
    let folder = words.value("--folder").unwrap_or_else(|| ".".to_owned());
    let seconds = positive("--seconds", words.value("--seconds"), 60.0)?;
    let mebibytes = positive("--memory", words.value("--memory"), 1024.0)?.ceil() as u64;
    words.nothing()?;
    mcp::serve(&mcp::Options { folder, limits: Limits { seconds, mebibytes } })?;
    Ok(Outcome::Good)
}

/// The positive number of an option.
fn positive(option: &str, text: Option<String>, usual: f64) -> Result<f64, Failure> {
    let Some(text) = text else { return Ok(usual) };
    let number = text.parse().ok().filter(|number| *number > 0.0 && f64::is_finite(*number));
    Ok(number.ok_or_else(|| format!("{option} wants a positive number, not `{text}`"))?)
}

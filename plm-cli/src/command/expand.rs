//! `plm expand` and `plm report`: the code that the macro emits, and what the compiler found and chose.

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::checked::{Checked, declarations};
use crate::read;

pub(super) const EXPAND: Command = Command {
    name: "expand",
    usage: "FILE",
    title: "shows the Rust code that the macro emits",
    options: &[],
    run: |words, streams| {
        run(words, streams, |checked| checked.expansion.code.as_ref().map(plm_compiler::Code::text))
    },
};

pub(super) const REPORT: Command = Command {
    name: "report",
    usage: "FILE",
    title: "tells bodies, rows, formulation, operations and assembly",
    options: &[],
    run: |words, streams| {
        run(words, streams, |checked| checked.expansion.report.as_ref().map(ToString::to_string))
    },
};

/// Writes something of every declaration of a file without errors; diagnostics go to the messages.
fn run(words: Words, streams: &mut Streams, of: fn(&Checked) -> Option<String>) -> Result<Outcome, Failure> {
    let file = read::file(&words.file()?, streams.input)?;
    let found = declarations(&file.name, &file.text);
    if found.checked.is_empty() && found.left_out.is_empty() && found.bugs.is_empty() {
        return Err(format!("{}: there is no `mechanism!` in it", file.name).into());
    }
    let mut outcome = if found.bugs.is_empty() { Outcome::Good } else { Outcome::Failed };
    for declaration in &found.checked {
        let diagnostics = &declaration.expansion.diagnostics;
        for diagnostic in diagnostics.sorted() {
            writeln!(streams.errors, "{}", diagnostic.render(&declaration.sources))?;
        }
        match of(declaration).filter(|_| !diagnostics.has_errors()) {
            Some(text) => writeln!(streams.output, "{text}")?,
            None => outcome = outcome.max(Outcome::Wrong),
        }
    }
    for what in found.left_out.into_iter().chain(found.bugs) {
        writeln!(streams.errors, "plm: {what}")?;
    }
    Ok(outcome)
}

//! `plm expand` and `plm report`: the code that the macro emits, and what the compiler found and chose.

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::checked::{Checked, Declarations};
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
    let found = Declarations::new(&file.name, &file.text);
    if found.is_empty() {
        return Err(format!("{}: there is no `mechanism!` in it", file.name).into());
    }
    let mut outcome = Outcome::Good;
    for declaration in found.compiled() {
        let declaration = declaration?;
        let diagnostics = &declaration.expansion.diagnostics;
        for diagnostic in diagnostics.sorted() {
            writeln!(streams.errors, "{}", diagnostic.render(&declaration.sources))?;
        }
        match of(&declaration).filter(|_| !diagnostics.has_errors()) {
            Some(text) => writeln!(streams.output, "{text}")?,
            None => outcome = Outcome::Wrong,
        }
    }
    for what in &found.left_out {
        writeln!(streams.errors, "plm: {what}")?;
    }
    Ok(outcome)
}

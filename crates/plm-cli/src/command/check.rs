//! `plm check`: diagnostics of declarations.

use plm_dynamic::Compiled;

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::checked::{Checked, Declarations};
use crate::excerpt::is_rust;
use crate::json;
use crate::quote::too_large;
use crate::read::{self, File};

pub(super) const COMMAND: Command = Command {
    name: "check",
    usage: "FILE… [--json]",
    title: "tells what is wrong, where, and what to do about it",
    options: &[("--json", "an object of JSON a line, on standard output")],
    run,
};

fn run(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let is_json = words.takes("--json");
    let mut outcome = Outcome::Good;
    for name in words.files()? {
        match read::file(&name, streams.input) {
            Ok(file) => outcome = outcome.max(check(&file, is_json, streams)?),
            Err(why) => {
                writeln!(streams.errors, "plm: {why}")?;
                outcome = Outcome::Failed;
            }
        }
    }
    Ok(outcome)
}

fn check(file: &File, is_json: bool, streams: &mut Streams) -> Result<Outcome, Failure> {
    let declarations = Declarations::new(&file.name, &file.text);
    let mut outcome = Outcome::Good;
    for declaration in declarations.checked() {
        let Checked { sources, expansion } = match declaration {
            Ok(declaration) => declaration,
            Err(bug) => {
                writeln!(streams.errors, "plm: {bug}")?;
                outcome = Outcome::Failed;
                continue;
            }
        };
        for diagnostic in expansion.diagnostics.sorted() {
            if is_json {
                writeln!(streams.output, "{}", json::message(diagnostic, &sources, &file.text))?;
            } else {
                writeln!(streams.errors, "{}", diagnostic.render(&sources))?;
            }
        }
        if expansion.diagnostics.has_errors() {
            outcome = outcome.max(Outcome::Wrong);
        } else if !is_rust(&file.name)
            && let Some(lowered) = expansion.lower()
            && let Err(refused) = Compiled::has_room(&file.name, lowered)
        {
            // Of compiled programs it is true no more.
            write!(streams.errors, "{}", too_large(&refused, "warning", file))?;
        }
    }
    for what in &declarations.left_out {
        writeln!(streams.errors, "plm: {what}")?;
    }
    Ok(outcome)
}

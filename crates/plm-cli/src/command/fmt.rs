//! `plm fmt`: declarations in their layout.

use std::path::Path;

use plm_view::replace_file;

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::layout::formatted;
use crate::read;

pub(super) const COMMAND: Command = Command {
    name: "fmt",
    usage: "[--check] FILE…",
    title: "lays declarations out, with comments and line breaks kept",
    options: &[("--check", "names files that have another layout, and changes none")],
    run,
};

fn run(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let is_check = words.takes("--check");
    let mut outcome = Outcome::Good;
    for name in words.files()? {
        let file = match read::file(&name, streams.input) {
            Ok(file) => file,
            Err(why) => {
                writeln!(streams.errors, "plm: {why}")?;
                outcome = Outcome::Failed;
                continue;
            }
        };
        match formatted(&file.name, &file.text) {
            Err(why) => {
                writeln!(streams.errors, "plm: {}: {why}", file.name)?;
                outcome = outcome.max(Outcome::Wrong);
            }
            Ok(made) if is_check => {
                if made != file.text {
                    writeln!(streams.output, "{}", file.name)?;
                    outcome = outcome.max(Outcome::Wrong);
                }
            }
            Ok(made) if name == "-" => write!(streams.output, "{made}")?,
            // A file that is as it should be keeps its time.
            Ok(made) if made != file.text => {
                if let Err(why) = replace_file(Path::new(&name), made.as_bytes()) {
                    writeln!(streams.errors, "plm: {name}: {why}; it is as it was")?;
                    outcome = Outcome::Failed;
                }
            }
            Ok(_) => {}
        }
    }
    Ok(outcome)
}

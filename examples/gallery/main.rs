//! Machines that people know: each a file to copy, with its source and figures that are known from elsewhere.
//!
//! ```console
//! cargo run --release --example gallery                                  # the figures of all of them
//! cargo run --release --example gallery -- watt geneva                   # of these
//! cargo run --release --example gallery -- watt --view watt.html         # one as a page; --help tells what else
//! cargo run --release --example gallery -- watt --live --view watt.html  # with the mechanism itself in it
//! cargo run --release --example gallery -- --pages FOLDER --live         # a page of each, and options for all
//! cargo run --release --example gallery -- --gallery FOLDER              # pages, list of pictures and page of the book
//! ```
//!
//! The program fails if a figure is missed.
#![allow(missing_docs, reason = "the machines declare public modules")]
#![allow(unreachable_pub, reason = "the modules are private to an example")]

mod book;
#[path = "../manual/command.rs"]
mod command;
mod figures;
mod list;
mod machines;
#[allow(dead_code, reason = "demos of the manual have printed figures, too")]
#[path = "../manual/demos/sheet.rs"]
mod sheet;

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

use list::MACHINES;
use plm::view::Options;

fn main() -> ExitCode {
    run().unwrap_or_else(|error| {
        eprintln!("{error}");
        ExitCode::FAILURE
    })
}

fn run() -> Result<ExitCode, Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.as_slice() {
        [option, folder] if option == "--gallery" => {
            pages(Path::new(folder), &[])?;
            book::write(Path::new(folder))?;
        }
        [option, folder, rest @ ..] if option == "--pages" => pages(Path::new(folder), rest)?,
        [name, option, ..] if option.starts_with('-') => {
            let machine = command::find(&MACHINES, |machine| machine.name, name)?;
            machine.program.start(&Options::parse(&words[1..])?)?;
        }
        named => return command::sheets(&MACHINES.map(|machine| (machine.name, machine.sheet)), named),
    }
    Ok(ExitCode::SUCCESS)
}

/// Writes a page of each machine into a folder, with these further options.
fn pages(folder: &Path, rest: &[String]) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    for machine in MACHINES {
        let mut options = Options::parse(rest)?;
        options.view = Some(folder.join(machine.page()));
        machine.program.start(&options)?;
    }
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
#[path = "../../tests/support/beside_text.rs"]
mod beside_text;
#[cfg(test)]
mod tests;

//! The demos of the manual: each runs, and shows what it finds beside what the manual prints.
//!
//! ```console
//! cargo run --release --example manual                             # all of them
//! cargo run --release --example manual -- PLMPIV00 Quadrorhomb     # these
//! cargo run --release --example manual -- PLMPIV00 --view a.html   # one as a page; --help tells what else
//! cargo run --release --example manual -- --gallery FOLDER         # curves, pages and the gallery of the book
//! ```
//!
//! The program fails if a figure is missed. Lines that say `theory` or `independent model` are no figures of the manual:
//! they stand where it prints none.
#![allow(missing_docs, reason = "the demos declare public modules")]
#![allow(unreachable_pub, reason = "the modules are private to an example")]

mod command;
mod demos;
mod gallery;

// They stand beside the other tests; in a program of their own all demos would be compiled twice.
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
#[path = "../../tests/support/beside_text.rs"]
mod beside_text;
#[cfg(test)]
#[macro_use]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
#[path = "../../tests/support/scene.rs"]
mod scene;
#[cfg(test)]
#[path = "../../tests/manual/mod.rs"]
mod tests;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use demos::{DEMOS, sheet};
use gallery::SHOWN;
use plm::view::Options;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    run(&words).unwrap_or_else(|error| {
        eprintln!("{error}");
        ExitCode::FAILURE
    })
}

fn run(words: &[String]) -> Result<ExitCode, Box<dyn Error>> {
    match words {
        [option, folder] if option == "--gallery" => {
            gallery::write(Path::new(folder))?;
            Ok(ExitCode::SUCCESS)
        }
        [name, option, ..] if option.starts_with('-') => {
            let shown = command::find(&SHOWN, |shown| shown.demo, name)?;
            shown.program.start(&Options::parse(&words[1..])?)?;
            Ok(ExitCode::SUCCESS)
        }
        named => command::sheets(&DEMOS, named),
    }
}

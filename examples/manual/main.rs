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

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use demos::{DEMOS, sheet};
use gallery::SHOWN;
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
            gallery::write(Path::new(folder))?;
            Ok(ExitCode::SUCCESS)
        }
        [name, option, ..] if option.starts_with('-') => {
            let shown = command::find(&SHOWN, |shown| shown.demo, name)?;
            (shown.program)(&Options::parse(&words[1..])?)?;
            Ok(ExitCode::SUCCESS)
        }
        named => command::sheets(&DEMOS, named),
    }
}

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

mod demos;
mod gallery;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use demos::DEMOS;
use demos::sheet::{Demo, Sheet};
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
            let shown = SHOWN
                .iter()
                .find(|shown| shown.is_called(name))
                .ok_or_else(|| unknown(name, SHOWN.map(|shown| shown.demo)))?;
            (shown.program)(&Options::parse(&words[1..])?)?;
            Ok(ExitCode::SUCCESS)
        }
        named => sheets(named),
    }
}

fn unknown<const N: usize>(name: &str, names: [&str; N]) -> String {
    format!("no demo is called `{name}`; there are {}", names.join(", "))
}

/// Runs the demos with these names, or all where there are none.
fn sheets(named: &[String]) -> Result<ExitCode, Box<dyn Error>> {
    if let Some(name) = named.iter().find(|name| !DEMOS.iter().any(|demo| is_called(demo, name))) {
        return Err(unknown(name, DEMOS.map(|(name, _)| name)).into());
    }
    let wanted =
        DEMOS.iter().filter(|demo| named.is_empty() || named.iter().any(|name| is_called(demo, name)));
    let (mut table, mut all_hold) = (Vec::new(), true);
    for (name, run) in wanted {
        match run() {
            Ok(sheet) => {
                println!("{sheet}\n");
                all_hold &= sheet.holds();
                table.push(row(&sheet));
            }
            Err(fault) => {
                println!("{name}\n  {fault}\n");
                all_hold = false;
                table.push(format!("{name:<16} {fault}"));
            }
        }
    }
    println!("{:<16} {:>15} {:>15}", "demo", "manual figures", "other checks");
    println!("{}", table.join("\n"));
    Ok(if all_hold { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn is_called((name, _): &Demo, wanted: &str) -> bool {
    name.eq_ignore_ascii_case(wanted)
}

fn row(sheet: &Sheet) -> String {
    let [printed, others] = sheet.counts().map(|(held, all)| format!("{held} of {all}"));
    format!("{:<16} {printed:>15} {others:>15}", sheet.demo)
}

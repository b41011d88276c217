//! The demos of the manual: each runs, and shows what it finds beside what the manual prints.
//!
//! ```console
//! cargo run --release --example manual                             # all of them
//! cargo run --release --example manual -- PLMPIV00 Quadrorhomb     # these
//! ```
//!
//! The program fails if a figure is missed. Lines that say `theory` or `independent model` are no figures of the manual:
//! they stand where it prints none.
#![allow(missing_docs, reason = "the demos declare public modules")]
#![allow(unreachable_pub, reason = "the modules are private to an example")]

mod demos;

use std::process::ExitCode;

use demos::DEMOS;
use demos::sheet::{Demo, Sheet};

fn main() -> ExitCode {
    let named: Vec<String> = std::env::args().skip(1).collect();
    let unknown = named.iter().find(|name| !DEMOS.iter().any(|demo| is_called(demo, name)));
    if let Some(name) = unknown {
        let names: Vec<&str> = DEMOS.iter().map(|(name, _)| *name).collect();
        eprintln!("no demo is called `{name}`; there are {}", names.join(", "));
        return ExitCode::FAILURE;
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
    if all_hold { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn is_called((name, _): &Demo, wanted: &str) -> bool {
    name.eq_ignore_ascii_case(wanted)
}

fn row(sheet: &Sheet) -> String {
    let [printed, others] = sheet.counts().map(|(held, all)| format!("{held} of {all}"));
    format!("{:<16} {printed:>15} {others:>15}", sheet.demo)
}

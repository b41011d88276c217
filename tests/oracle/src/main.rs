//! Random mechanisms from text beside closed forms, differences, other formulations and other paces.
//!
//! ```console
//! cargo run --release -p plm-oracle                               # names the sweeps
//! cargo run --release -p plm-oracle -- resets 10000 --seed 7      # so many cases of one
//! cargo run --release -p plm-oracle -- resets --seed 7 --case 123 # one case, with its text
//! ```
//!
//! Half of the numbers that a case draws are special ones ([`draw::Draw`]): 0, 1, equal, at rest, at a bound, closed as drawn.
#![allow(
    clippy::format_push_string,
    reason = "texts of declarations are put together, and nothing waits for them"
)]

mod bounded;
mod bounds;
mod draw;
mod driven;
mod geared;
mod gradients;
mod hostile;
mod late;
mod pages;
#[path = "../../support/random.rs"]
mod random;
mod resets;
mod sweep;
mod turned;
mod wheels;

use std::process::ExitCode;

use lexopt::{Arg, Parser, ValueExt};

use sweep::{SWEEPS, Sweep, Table};

/// What was asked for.
struct Asked {
    sweep: &'static Sweep,
    seed: u64,
    cases: std::ops::Range<u64>,
    one: bool,
}

fn main() -> ExitCode {
    let asked = match asked() {
        Ok(asked) => asked,
        Err(error) => {
            eprintln!("{error}\nplm-oracle SWEEP [COUNT] [--seed N] [--case N]; the sweeps:");
            for sweep in SWEEPS {
                eprintln!("  {:12} {}", sweep.name, sweep.title);
            }
            return ExitCode::FAILURE;
        }
    };
    let Asked { sweep, seed, cases, one } = asked;
    println!("{}: {}; seed {seed}, cases {} to {}", sweep.name, sweep.title, cases.start, cases.end - 1);
    let table = Table::of(sweep, seed, cases);
    println!("{}", table.shown(one));
    if table.holds() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn asked() -> Result<Asked, lexopt::Error> {
    let (mut sweep, mut count, mut seed, mut case) = (None, None, 1, None);
    let mut parser = Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Arg::Value(name) if sweep.is_none() => {
                let known = SWEEPS.iter().find(|known| name == known.name);
                sweep = Some(known.ok_or_else(|| format!("there is no sweep {}", name.display()))?);
            }
            Arg::Value(number) => count = Some(number.string()?.parse().map_err(|_| "COUNT is a number")?),
            Arg::Long("seed") => seed = number(&mut parser)?,
            Arg::Long("case") => case = Some(number(&mut parser)?),
            _ => return Err(arg.unexpected()),
        }
    }
    let sweep = sweep.ok_or("no sweep is named")?;
    let cases = case.map_or(0..count.unwrap_or(sweep.quick), |case| case..case + 1);
    Ok(Asked { sweep, seed, cases, one: case.is_some() })
}

fn number(parser: &mut Parser) -> Result<u64, lexopt::Error> {
    parser.value()?.string()?.parse().map_err(|_| "an option takes a number".into())
}

//! Random mechanisms from text beside closed forms, differences, other formulations and other paces.
//!
//! ```console
//! cargo run --release -p plm-oracle                               # names the sweeps
//! cargo run --release -p plm-oracle -- resets 10000 --seed 7      # so many cases of one
//! cargo run --release -p plm-oracle -- all 1000                   # so many cases of each
//! cargo run --release -p plm-oracle -- resets --seed 7 --case 123 # one case, with its text
//! ```

use std::num::NonZeroU64;
use std::process::ExitCode;

use lexopt::{Arg, Parser, ValueExt};

use plm_oracle::{SWEEPS, Sweep, Table};

/// Options of the command line.
struct Asked {
    sweeps: &'static [Sweep],
    seed: u64,
    cases: Cases,
}

/// Which cases of a sweep.
enum Cases {
    /// The number of cases in the tests.
    Quick,
    First(u64),
    One(u64),
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
    // Each is run, whatever came of those before.
    let wrong = asked.sweeps.iter().filter(|sweep| !holds(sweep, &asked)).count();
    if wrong == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Is no case of a sweep wrong?
fn holds(sweep: &Sweep, asked: &Asked) -> bool {
    let seed = asked.seed;
    let (cases, one) = match asked.cases {
        Cases::Quick => (0..sweep.quick, false),
        Cases::First(count) => (0..count, false),
        Cases::One(case) => (case..case + 1, true),
    };
    println!("{}: {}; seed {seed}, cases {} to {}", sweep.name, sweep.title, cases.start, cases.end - 1);
    let table = Table::of(sweep, seed, cases);
    println!("{}", table.shown(one));
    table.holds()
}

fn asked() -> Result<Asked, lexopt::Error> {
    let (mut sweeps, mut cases, mut seed) = (None, Cases::Quick, 1);
    let mut parser = Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Arg::Value(name) if sweeps.is_none() => sweeps = Some(named(&name.string()?)?),
            Arg::Value(number) => {
                let count: NonZeroU64 = number.string()?.parse().map_err(|_| "COUNT is 1 or more")?;
                cases = Cases::First(count.get());
            }
            Arg::Long("seed") => seed = number(&mut parser)?,
            Arg::Long("case") => cases = Cases::One(number(&mut parser)?),
            _ => return Err(arg.unexpected()),
        }
    }
    Ok(Asked { sweeps: sweeps.ok_or("no sweep is named")?, seed, cases })
}

/// One sweep, or all.
fn named(name: &str) -> Result<&'static [Sweep], String> {
    let one = || SWEEPS.iter().position(|sweep| sweep.name == name).map(|at| &SWEEPS[at..=at]);
    (name == "all").then_some(SWEEPS).or_else(one).ok_or_else(|| format!("there is no sweep {name}"))
}

fn number(parser: &mut Parser) -> Result<u64, lexopt::Error> {
    parser.value()?.string()?.parse().map_err(|_| "an option takes a number".into())
}

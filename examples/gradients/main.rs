//! Derivatives of runs of random mechanisms beside differences of runs without derivatives.
//!
//! ```console
//! cargo run --release --example gradients -- 2000             # so many
//! cargo run --release --example gradients -- 200 --seed 7     # others
//! ```
//!
//! Each case is a text with random numbers: impacts, friction, limits of joints, loops, forces with conditions, events that reset. It is
//! compiled while the program runs, and its outputs at a random time are derived by three of its parameters. The differences take eight
//! runs about each value, once near and once twice as far: where the two agree to a bound they are believed to it, elsewhere (an impact
//! more or less within their reach) the case says nothing. The program fails where a derivative is not that of the differences.
#![allow(missing_docs, reason = "the modules are private to an example")]
#![allow(unreachable_pub, reason = "the modules are private to an example")]

mod backward;
mod cases;
mod differences;

use std::collections::BTreeMap;
use std::error::Error;
use std::process::ExitCode;

use plm::view::{Arguments, Known};

use backward::Backward;
use cases::{Case, FAMILIES};
use differences::{Verdict, judge};

const KNOWN: [Known; 2] = [
    Known::word("COUNT", "how many; 100 if nothing is said"),
    Known::value("seed", "N", "of the random mechanisms; 1 if nothing is said"),
];

fn main() -> ExitCode {
    run().unwrap_or_else(|error| {
        eprintln!("{error}");
        ExitCode::FAILURE
    })
}

fn run() -> Result<ExitCode, Box<dyn Error>> {
    let given = Arguments::from_args(&KNOWN)?;
    if let Some(help) = given.help() {
        println!("{help}");
        return Ok(ExitCode::SUCCESS);
    }
    let (seed, count): (u64, u64) =
        (given.number("seed")?.unwrap_or(1), given.number("COUNT")?.unwrap_or(100));
    let mut table: BTreeMap<&str, [u64; 4]> = BTreeMap::new();
    let (mut largest, mut holds) = (0.0_f64, true);
    let (mut same, mut at_once, mut farthest) = (0_u64, 0_u64, 0.0_f64);
    for number in 0..count {
        let case = Case::new(seed, number);
        let (verdict, backward) =
            judge(&case).map_err(|error| format!("number {number}: {error}\n{}", case.text))?;
        match backward {
            Some(Backward::Same { apart }) => {
                same += 1;
                farthest = farthest.max(apart);
            }
            Some(Backward::AtOnce) => at_once += 1,
            None => {}
        }
        let column = match verdict {
            Verdict::Right { apart } => {
                largest = largest.max(apart);
                0
            }
            Verdict::Wrong { ref why } => {
                println!("number {number}: {why}\n{}", case.text);
                holds = false;
                1
            }
            Verdict::NoDifference => 2,
            Verdict::NoDerivative(fault) => {
                println!("number {number}: {fault}");
                3
            }
        };
        table.entry(FAMILIES[case.family].name).or_default()[column] += 1;
    }
    println!("seed {seed}, the largest relative difference of those that are right: {largest:.1e}");
    println!(
        "backward as forward: {same}, to {farthest:.1e}; none backward, since two events meet: {at_once}"
    );
    println!("{:<12}{:>8}{:>8}{:>16}{:>16}", "family", "right", "wrong", "no difference", "no derivative");
    for (name, [right, wrong, undecided, none]) in table {
        println!("{name:<12}{right:>8}{wrong:>8}{undecided:>16}{none:>16}");
    }
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

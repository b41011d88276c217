//! Thousands of random six-bars, as texts that are compiled while the program runs: which draws the longest straight line?
//!
//! ```console
//! cargo run --release -p plm-oracle --bin topologies -- 4000             # so many
//! cargo run --release -p plm-oracle --bin topologies -- 4000 --seed 7    # others
//! ```
//!
//! Watt's and Stephenson's chains are fixed at each kind of link, their joints lie at random places. A crank makes a turn; joints of
//! couplers, and points by chance on them, are traced. Straight is what deviates from a line by a thousandth of its length at most. The
//! program prints the best as a declaration, and fails where it rates linkages of known straightness wrongly.
#![allow(missing_docs, reason = "the modules are private to a program")]
#![allow(unreachable_pub, reason = "the modules are private to a program")]

mod study;

use std::error::Error;
use std::process::ExitCode;

use plm_program::{Arguments, Known};

use study::chains::SixBar;
use study::search::{Outcome, Search, search};
use study::{known, trace};

const KNOWN: [Known; 3] = [
    Known::word("COUNT", "how many; 1000 if nothing is said"),
    Known::value("seed", "N", "of the random mechanisms; 1 if nothing is said"),
    Known::value("threads", "N", "as many as the machine has if nothing is said"),
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
    let mut holds = true;
    for known in known::all()? {
        let study::straight::Portion { length, deviation, .. } = known.rated;
        println!(
            "{}: {:.3} mm long, off the line by {:.2e} of it; known {:.3} mm, {:.2e}",
            known.name,
            1e3 * length,
            deviation / length,
            1e3 * known.length,
            known.deviation / known.length
        );
        holds &= known.holds();
    }
    let (seed, count) = (given.number("seed")?.unwrap_or(1), given.number("COUNT")?.unwrap_or(1000));
    let found = search(seed, count, given.number("threads")?.unwrap_or(0));
    print(&found, seed);
    let seconds = found.taken.as_secs_f64();
    println!("\n{seconds:.1} s: {:.0} mechanisms a second", count as f64 / seconds);
    holds &= !found.outcomes.iter().any(|outcome| matches!(outcome, Outcome::Refused(_)));
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn print(found: &Search, seed: u64) {
    println!("\n{:<16}{:>7}{:>8}{:>8}", "seed ".to_owned() + &seed.to_string(), "drawn", "turn", "best");
    for (name, (all, turned, best)) in found.table(seed) {
        println!("{name:<16}{all:>7}{turned:>8}{best:>8.3}");
    }
    let refused = found.outcomes.iter().enumerate().filter_map(|(number, outcome)| match outcome {
        Outcome::Refused(refused) => Some((number, refused)),
        _ => None,
    });
    for (number, refused) in refused {
        println!("number {number}: {refused}");
    }
    let Some(best) = found.best() else { return };
    let turn = 360 * (best.portion.count - 1) / trace::SAMPLES;
    println!(
        "\nthe best, number {}: a line {:.1} mm long, {:.3} of the greatest extent of a link, to {:.3} mm, over {turn} deg of the crank from \
         {} deg on\n\n{}",
        best.number,
        1e3 * best.portion.length,
        best.score,
        1e3 * best.portion.deviation,
        360 * best.portion.first / trace::SAMPLES,
        SixBar::random(seed, best.number).declaration(Some(best.point))
    );
}

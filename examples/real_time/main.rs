//! Hardware in the loop on Linux: two mechanisms step at 1 kHz and 10 kHz against the clock.
//!
//! ```sh
//! cargo run --release --example real_time                    # 5 s for each mechanism and rate
//! cargo run --release --example real_time -- --seconds 60
//! cargo run --release --example real_time -- --accuracy docs/src/images/real_time.svg
//! ```
//!
//! The mechanism runs in a thread of its own. Another thread stands for the hardware: it reads what comes out, and sets the input
//! whenever it likes. Afterwards the inputs are played again, without a clock, and the last bit has to be the same.

#![allow(
    missing_docs,
    unreachable_pub,
    reason = "the mechanisms are public in private modules of an example"
)]

mod accuracy;
mod clock;
mod plants;
// They stand beside the other tests; in a program of their own both mechanisms would be compiled twice.
#[cfg(test)]
#[path = "../../tests/real_time/mod.rs"]
mod tests;

use std::error::Error;

use clock::{Beat, distribution, failed_periods, measured};
use plm::view::{Arguments, Known};

const KNOWN: [Known; 2] = [
    Known::value("seconds", "NUMBER", "how long each mechanism runs at each rate; 5 if nothing is said"),
    Known::value("accuracy", "FILE", "no clock: draws the error of the arm against the length of its step"),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::from_args(&KNOWN)?;
    if let Some(help) = arguments.help() {
        println!("{help}");
        return Ok(());
    }
    if let Some(file) = arguments.value("accuracy") {
        let (chart, text) = accuracy::chart(2000)?;
        chart.write_svg(file)?;
        println!("{text}");
        return Ok(());
    }
    let seconds = arguments.number("seconds")?.unwrap_or(5.0);
    println!("{:>18} {:>6} {:>26} {:>26}", "", "", "a step takes, us", "begins late by, us");
    let columns = format!("{:>9}{:>9}{:>9}", "mean", "99 %", "most");
    println!("{:>18} {:>6}{columns}{columns}{:>8}{:>18}", "", "Hz", "missed", "mean of a period");
    for rate in [1000, 10_000] {
        let period = 1.0 / f64::from(rate);
        report("four-bar, RK4", rate, &measured(rate, seconds, 2.0, || plants::four_bar(period))?);
        report("arm, lin. implicit", rate, &measured(rate, seconds, 0.2, || plants::arm(period))?);
    }
    Ok(())
}

fn report(name: &str, rate: u32, beats: &[Beat]) {
    let period = 1.0 / f64::from(rate);
    let missed = beats.iter().filter(|beat| beat.late.as_secs_f64() >= period).count();
    print!("{name:>18} {rate:>6}");
    let took = distribution(beats.iter().map(|beat| beat.took));
    for time in took.into_iter().chain(distribution(beats.iter().map(|beat| beat.late))) {
        print!("{time:>9.2}");
    }
    println!("{missed:>8}{:>16.2} %", 100.0 * 1e-6 * took[0] / period);
    for line in failed_periods(period, beats) {
        println!("{:>18} {line}", "");
    }
}

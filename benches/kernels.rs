//! Generated code beside kernels written by hand, in one process.
//!
//! `bash benches/kernels.sh` runs everything for x86-64-v3, without and with fused multiply-add. Of one build:
//!
//! ```text
//! cargo bench --bench kernels                    time of a Runge-Kutta 4 step
//! cargo bench --bench kernels -- instructions    instructions of a step, by valgrind
//! cargo bench --bench kernels -- check           the kernels against references
//! ```
#![allow(clippy::panic, reason = "benches")]

#[allow(dead_code)] // The counts of instructions use more of it.
mod scenes;
#[path = "kernels/mod.rs"]
#[allow(dead_code)] // The bench of lanes uses more of it.
mod written;

use std::process::ExitCode;
use std::time::{Duration, Instant};

use scenes::{Level, Steps, count};
use written::{KERNELS, Kernel, Poses};

/// Who makes the steps: the columns of the tables.
const MAKERS: [&str; 3] = ["plain", "paired", "plm"];
/// Times that every maker is measured, in turn.
const ROUNDS: u32 = 60;
/// A measurement is at least this long: some thousand times what reading the clock costs.
const LENGTH: Duration = Duration::from_micros(500);

fn main() -> ExitCode {
    if count::counted(steps) {
        return ExitCode::SUCCESS;
    }
    let arguments = count::arguments();
    match arguments.first().map(String::as_str) {
        None => table("ns", times),
        Some("instructions") => table("instructions", instructions),
        Some("check") if written::all_right() => {}
        _ => return ExitCode::FAILURE,
    }
    ExitCode::SUCCESS
}

/// The steps of one maker in one scene.
fn steps(name: &str, maker: &str) -> Steps {
    let (scene, kernel) = (scenes::named(name), written::named(name));
    match maker {
        "plain" => (kernel.steps)(scene.h, Poses::OneByOne),
        "paired" => (kernel.steps)(scene.h, Poses::InPairs),
        _ => (scene.steps)(scene.h, Level::Formula),
    }
}

/// Prints what a step costs each maker, and plm over the kernels.
fn table(unit: &str, measure: fn(&Kernel) -> [f64; 3]) {
    let [plain, paired, plm] = MAKERS;
    println!("{unit} of a step; fused multiply-add: {}", cfg!(feature = "fma"));
    println!(
        "{:<10} {plain:>9} {paired:>9} {plm:>9} {:>10} {:>11} {:>6}",
        "scene", "plm/plain", "plm/paired", "known"
    );
    for kernel in KERNELS {
        let [plain, paired, plm] = measure(kernel);
        let known = kernel
            .known
            .filter(|_| unit == "instructions")
            .map_or_else(String::new, |count| count.to_string());
        println!(
            "{:<10} {plain:>9.1} {paired:>9.1} {plm:>9.1} {:>10.2} {:>11.2} {known:>6}",
            kernel.name,
            plm / plain,
            plm / paired
        );
    }
}

fn instructions(kernel: &Kernel) -> [f64; 3] {
    MAKERS.map(|maker| count::per_step(kernel.name, maker))
}

/// The best of many times, the makers in turn, so that all see the same machine.
fn times(kernel: &Kernel) -> [f64; 3] {
    let mut all = MAKERS.map(|maker| steps(kernel.name, maker));
    let mut best = [f64::INFINITY; 3];
    let mut number = 16;
    while time(&mut all[1], number) < LENGTH {
        number *= 2;
    }
    for _ in 0..ROUNDS {
        for (best, steps) in best.iter_mut().zip(&mut all) {
            *best = best.min(time(steps, number).as_secs_f64() * 1e9 / f64::from(number));
        }
    }
    best
}

fn time(steps: &mut Steps, number: u32) -> Duration {
    let begin = Instant::now();
    steps(number);
    begin.elapsed()
}

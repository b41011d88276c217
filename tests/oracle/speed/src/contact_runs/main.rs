//! Scenes with contact: error at a fixed time, CPU time, creep and energy of impacts, as rows of docs/src/images/contact-peers/runs.csv.
//!
//! ```sh
//! cargo run --release -p plm-speed --bin contact_runs > target/plm/contact-plm.csv
//! cargo run --release -p plm-speed --bin contact_runs -- steps > target/plm/contact-steps.csv  # of MoreauJean
//! ```
//!
//! The systems are written by hand, as those of `plm-runtime/tests/contact` are. `benches/data/contact.csv` has the reference values.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    unreachable_pub,
    missing_docs,
    reason = "a program that measures"
)]

mod clock;
#[path = "../../../../../plm-runtime/tests/contact/oscillator.rs"]
mod oscillator;
mod scenes;
#[path = "../../../../../plm-runtime/tests/contact/slider_crank.rs"]
mod slider_crank;
mod steps;
#[path = "../../../../../plm-runtime/tests/contact/support.rs"]
mod support;

use plm_runtime::{Dop853, Mechanism};

use oscillator::Oscillator;
use scenes::{Ball, Block, Crank};

/// Tolerances of the runs, relative and absolute.
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// A reference value.
fn reference(scene: &str, name: &str) -> f64 {
    let table = include_str!("../../../../../benches/data/contact.csv");
    let key = format!("{scene},{name},");
    table.lines().find_map(|row| row.strip_prefix(&key)).unwrap().parse().unwrap()
}

fn main() {
    if std::env::args().nth(1).as_deref() == Some("steps") {
        return steps::all();
    }
    for tolerance in TOLERANCES {
        block(tolerance);
        oscillator(tolerance);
        ball(tolerance);
        rocking(tolerance);
        crank(tolerance);
    }
}

/// A row: creep in um/s, and how far the energy after an impact is from that of the law, as a fraction of it.
fn row(scene: &str, tolerance: f64, error: f64, (seconds, steps): (f64, u64), creep: f64, gain: f64) {
    let number = |value: f64| if value.is_nan() { String::new() } else { format!("{value:.3e}") };
    println!(
        "{scene},plm,DOP853,{tolerance:.0e},{error:.3e},{seconds:.3e},{steps},{},{}",
        number(creep),
        number(gain)
    );
}

/// An hour under 99 % of what friction can bear.
fn block(tolerance: f64) {
    let run = || {
        let mut sim = Block::pushed().start_with(Dop853::new(tolerance)).unwrap();
        sim.step_to(3600.0).unwrap();
        (sim.x[0], sim.stats().steps)
    };
    let start = Block::pushed().start_with(Dop853::new(tolerance)).unwrap().x[0];
    let (x, steps) = run();
    row(
        "block",
        tolerance,
        (x - start).abs(),
        (clock::seconds(run), steps),
        1e6 * (x - start).abs() / 3600.0,
        f64::NAN,
    );
}

/// To 2 s, and ten more at rest.
fn oscillator(tolerance: f64) {
    let start = || Oscillator::RELEASED.start_with(Dop853::new(tolerance)).unwrap();
    let run = || {
        let mut sim = start();
        sim.step_to(2.0).unwrap();
        sim.stats().steps
    };
    let mut sim = start();
    sim.step_to(2.0).unwrap();
    let rest = sim.x[0];
    sim.step_to(12.0).unwrap();
    let error = (rest - reference("oscillator", "x")).abs();
    row(
        "oscillator",
        tolerance,
        error,
        (clock::seconds(run), run()),
        1e5 * (sim.x[0] - rest).abs(),
        f64::NAN,
    );
}

/// The deviation that is largest by its amount of an energy from `ratio` times the one before it.
fn gain(energies: &[f64], ratio: f64) -> f64 {
    let gains = energies.windows(2).map(|pair| pair[1] / (ratio * pair[0]) - 1.0);
    gains.fold(0.0, |most: f64, gain| if gain.abs() > most.abs() { gain } else { most })
}

/// To 3 s; energies in the middle of five flights.
fn ball(tolerance: f64) {
    let start = || Ball.start_with(Dop853::new(tolerance)).unwrap();
    let run = || {
        let mut sim = start();
        sim.step_to(3.0).unwrap();
        (sim.x[0], sim.stats().steps)
    };
    let mut sim = start();
    let mut energies = vec![9.81];
    let impact = |k: usize| reference("ball", &format!("impact_{k}"));
    for k in 0..5 {
        sim.step_to(0.5 * (impact(k) + impact(k + 1))).unwrap();
        energies.push(9.81 * sim.x[0] + 0.5 * sim.x[1] * sim.x[1]);
    }
    let (y, steps) = run();
    let error = (y - reference("ball", "y")).abs();
    row("ball", tolerance, error, (clock::seconds(run), steps), f64::NAN, gain(&energies, 0.64));
}

/// To 1.2 s; energies in the middle between impacts.
fn rocking(tolerance: f64) {
    let start = || Block::rocking().start_with(Dop853::new(tolerance)).unwrap();
    let run = || {
        let mut sim = start();
        sim.step_to(1.2).unwrap();
        (sim.x[2], sim.stats().steps)
    };
    let mut sim = start();
    let mut energies = vec![Block::rocking().energy(&sim.x)];
    let impact = |k: usize| reference("rocking", &format!("impact_{k}"));
    for k in 0..3 {
        sim.step_to(0.5 * (impact(k) + impact(k + 1))).unwrap();
        energies.push(Block::rocking().energy(&sim.x));
    }
    let (angle, steps) = run();
    let error = (angle.abs() - reference("rocking", "angle")).abs();
    let gain = gain(&energies, reference("rocking", "energy_ratio"));
    row("rocking", tolerance, error, (clock::seconds(run), steps), f64::NAN, gain);
}

/// To 1 s.
fn crank(tolerance: f64) {
    let run = || {
        let mut sim = Crank.start_with(Dop853::new(tolerance)).unwrap();
        sim.step_to(1.0).unwrap();
        (sim.x[0], sim.stats().steps)
    };
    let (angle, steps) = run();
    let error = (angle - reference("slider-crank", "angle")).abs();
    row("slider-crank", tolerance, error, (clock::seconds(run), steps), f64::NAN, f64::NAN);
}

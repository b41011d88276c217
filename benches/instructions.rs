//! Instructions per Runge-Kutta 4 step, counted by valgrind: exact, and the same on every run and machine.
//!
//! `bash benches/instructions.sh` builds for x86-64-v3 (AVX2, as the limits were) and prints the table. The program
//! runs itself under `valgrind --tool=callgrind` with some number of steps and with twice as many; the difference
//! over the number of steps is what one step costs, without start-up, assembly and printing.
#![allow(clippy::unwrap_used, clippy::panic)]

mod scenes;

use std::hint::black_box;
use std::process::{Command, ExitCode};

use plm::runtime::method::{Formula, Rk4Formula};
use plm::{Mechanism, Moment, Rk4};

use scenes::{SCENES, Scene};

/// Steps of the shorter of two runs.
const STEPS: u32 = 200;

/// Which step is counted.
#[derive(Clone, Copy, PartialEq)]
enum Level {
    /// The formula alone: four rates and their combinations, with the health of the solutions.
    Formula,
    /// A step of `Sim`, with the watch over drift and health that a user gets.
    Sim,
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    if let ["count", scene, level, steps] = words[..] {
        let scene = SCENES.iter().find(|known| known.name == scene).expect("a scene of the table");
        (scene.run)(if level == "sim" { Level::Sim } else { Level::Formula }, steps.parse().unwrap());
        return ExitCode::SUCCESS;
    }
    table()
}

/// Prints a row for each scene; fails if one is above its limit or a chain costs more a bar the longer it is.
fn table() -> ExitCode {
    let comparable = cfg!(target_feature = "avx2");
    if !comparable {
        println!("built without AVX2, unlike the limits: run benches/instructions.sh to compare");
    }
    println!(
        "{:<10} {:>12} {:>9} {:>7} {:>6} {:>12}",
        "scene", "instructions", "per body", "limit", "ratio", "with Sim"
    );
    let mut within = true;
    let mut chains = Vec::new();
    for scene in SCENES {
        let (formula, sim) = (per_step(scene, Level::Formula), per_step(scene, Level::Sim));
        let per_body = formula / f64::from(scene.bodies);
        let (limit, ratio) = match scene.limit {
            Some(limit) => (limit.to_string(), format!("{:.3}", formula / f64::from(limit))),
            None => (String::new(), String::new()),
        };
        println!("{:<10} {formula:>12.1} {per_body:>9.1} {limit:>7} {ratio:>6} {sim:>12.1}", scene.name);
        within &= !comparable || scene.limit.is_none_or(|limit| formula <= f64::from(limit));
        if scene.name.starts_with("chain") {
            chains.push((f64::from(scene.bodies), formula));
        }
    }
    // Operations per bar are the same (tests/it/operations.rs); what does not fit in registers may cost a tenth.
    let linear = chains.is_sorted_by(|shorter, longer| longer.1 / longer.0 <= 1.1 * shorter.1 / shorter.0);
    if within && linear { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn per_step(scene: &Scene, level: Level) -> f64 {
    let once = instructions(scene, level, STEPS);
    let twice = instructions(scene, level, 2 * STEPS);
    (twice - once) as f64 / f64::from(STEPS)
}

/// Instructions of a whole run of this program.
fn instructions(scene: &Scene, level: Level, steps: u32) -> u64 {
    let level = if level == Level::Sim { "sim" } else { "formula" };
    let output = Command::new("valgrind")
        // One `rep movsb` is one instruction to a processor, but one per byte to callgrind: let libc copy by vectors.
        .env(
            "GLIBC_TUNABLES",
            "glibc.cpu.x86_rep_movsb_threshold=1000000:glibc.cpu.x86_rep_stosb_threshold=1000000",
        )
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(std::env::current_exe().unwrap())
        .args(["count", scene.name, level, &steps.to_string()])
        .output()
        .expect("valgrind is installed");
    let report = String::from_utf8_lossy(&output.stderr);
    let count = report.lines().find_map(|line| line.split_once("Collected : ")?.1.trim().parse().ok());
    assert!(output.status.success(), "{}: {report}", scene.name);
    count.unwrap_or_else(|| panic!("valgrind counted nothing: {report}"))
}

/// Steps a mechanism from its start.
fn run<M: Mechanism<S = f64>>(mechanism: M, h: f64, level: Level, steps: u32) {
    let mut sim = mechanism.start_with(Rk4::new(h)).expect("the mechanism can be assembled");
    if level == Level::Sim {
        for _ in 0..steps {
            sim.step(h).expect("the mechanism can be moved");
        }
        black_box(sim.state().x());
    } else {
        let (input, mut x) = (sim.state().held(), *sim.state().x());
        for step in 0..steps {
            black_box(Rk4Formula::plain_step(&mechanism, f64::from(step) * h, &input, &mut x, h));
        }
        black_box(&x);
    }
}

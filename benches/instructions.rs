//! Instructions per Runge-Kutta 4 step, counted by valgrind: exact, and the same on every run and machine.
//!
//! `bash benches/instructions.sh` builds for x86-64-v3 (AVX2, as the limits were) and prints the table. How it counts:
//! `scenes/count.rs`.
#![allow(clippy::panic, reason = "benches")]

mod scenes;

use std::process::ExitCode;

use scenes::{Level, SCENES, count, named};

fn main() -> ExitCode {
    let find = |name: &str, what: &str| {
        let scene = named(name);
        (scene.steps)(scene.h, if what == "sim" { Level::Sim } else { Level::Formula })
    };
    if count::counted(find) { ExitCode::SUCCESS } else { table() }
}

/// Prints a row for each scene; fails if one is above its limits or a chain costs more a bar the longer it is.
fn table() -> ExitCode {
    let comparable = cfg!(target_feature = "avx2");
    if !comparable {
        println!("built without AVX2, unlike the limits: run benches/instructions.sh to compare");
    }
    println!(
        "{:<12} {:>12} {:>9} {:>7} {:>6} {:>12} {:>7}",
        "scene", "instructions", "per body", "limit", "ratio", "with Sim", "ratio"
    );
    let mut within = true;
    let mut chains = Vec::new();
    for scene in SCENES {
        let (formula, sim) = (count::per_step(scene.name, "formula"), count::per_step(scene.name, "sim"));
        let per_body = formula / f64::from(scene.bodies);
        let (limit, ratio) = match scene.limit {
            Some(limit) => (limit.to_string(), format!("{:.3}", formula / f64::from(limit))),
            None => (String::new(), String::new()),
        };
        let with_sim = sim / formula;
        println!(
            "{:<12} {formula:>12.1} {per_body:>9.1} {limit:>7} {ratio:>6} {sim:>12.1} {with_sim:>7.3}",
            scene.name
        );
        within &= !comparable
            || (scene.limit.is_none_or(|limit| formula <= f64::from(limit))
                && sim <= f64::from(scene.with_sim));
        // Shorter ones have a dense mass matrix, which costs less.
        if scene.name.starts_with("chain") && scene.bodies > 6 {
            chains.push((f64::from(scene.bodies), formula));
        }
    }
    // Operations per bar are the same (tests/evaluation/operations.rs); what does not fit in registers may cost a tenth.
    let linear = chains.is_sorted_by(|shorter, longer| longer.1 / longer.0 <= 1.1 * shorter.1 / shorter.0);
    if within && linear { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

//! Runs by fixed steps beside the run from event to event: errors at two lengths of steps, and how they fall.

use std::collections::BTreeMap;

use crate::judge::{Case, TOLERANCE, Verdict};
use crate::run::{Fixed, Method, Outcome, Pace};
use crate::stepping::apart;

/// Lengths of steps, s.
const STEPS: [f64; 2] = [1e-3, 2.5e-4];
/// An error of order 1 at most: positions are off by the way of so many m/s or rad/s in a step, of 1 and the number. Several impacts
/// one after the other add up.
const SPEED: f64 = 30.0;

/// Errors of the cases of a family by a method, at each length of steps, and what was not compared.
#[derive(Default)]
struct Errors {
    of: [Vec<f64>; 2],
    faults: usize,
    large: usize,
}

/// Compares each case whose motion is right, in its first formulation; true if all errors are at most those of order 1, but for motions
/// that change by themselves: few of a hundred.
pub fn compare(cases: impl Iterator<Item = (u64, Case)>, verbose: bool) -> bool {
    let mut table: BTreeMap<(&str, &str), Errors> = BTreeMap::new();
    for (number, case) in cases {
        let is_right = case.judge().first().is_some_and(|judged| judged.verdict == Verdict::Right);
        if !is_right {
            continue;
        }
        let by_events = case.run(0, Method::Events { pace: Pace::Whole, tolerance: TOLERANCE });
        for fixed in Fixed::ALL {
            let runs = STEPS.map(|length| case.run(0, Method::Steps { fixed, length }));
            let errors = table.entry((case.family.name, fixed.name())).or_default();
            if let Some(fault) = runs.iter().find_map(|run| run.fault) {
                errors.faults += 1;
                if verbose {
                    println!("--case {number}  {}, {}: {fault}", case.family.name, fixed.name());
                }
                continue;
            }
            let off = runs.map(|run| at_end(&by_events, &run));
            if off[1] > SPEED * STEPS[1] {
                errors.large += 1;
                if verbose {
                    println!("--case {number}  {}, {}: {off:?}", case.family.name, fixed.name());
                }
            }
            errors.of.iter_mut().zip(off).for_each(|(of, off)| of.push(off));
        }
    }
    print(table)
}

fn print(table: BTreeMap<(&str, &str), Errors>) -> bool {
    println!(
        "{:34}{:>6}{:>11}{:>11}{:>11}{:>8}{:>8}",
        "", "cases", "1 ms", "0.25 ms", "worst", "large", "faults"
    );
    let (mut all, mut large) = (0, 0);
    for ((family, method), Errors { mut of, faults, large: own }) in table {
        for of in &mut of {
            of.sort_by(f64::total_cmp);
        }
        let [long, short] = of.each_ref().map(|of| of.get(of.len() / 2).copied().unwrap_or_default());
        let worst = of[1].last().copied().unwrap_or_default();
        let name = format!("{family}, {method}");
        println!("{name:34}{:>6}{long:>11.1e}{short:>11.1e}{worst:>11.1e}{own:>8}{faults:>8}", of[1].len());
        (all, large) = (all + of[1].len(), large + own + faults);
    }
    println!("{large} of {all} are large, or end with a fault");
    50 * large <= all
}

/// Difference of two runs at their end.
fn at_end(one: &Outcome, other: &Outcome) -> f64 {
    let last = |outcome: &Outcome| Outcome {
        samples: outcome.samples.last().cloned().into_iter().collect(),
        ..Outcome::default()
    };
    apart(&last(one), &last(other))
}

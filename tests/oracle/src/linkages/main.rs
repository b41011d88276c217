//! Random mechanisms against a reference in higher precision: no run that ends `Ok` may be off, none may be ended where the
//! motion goes on.
//!
//! ```sh
//! cargo run --release -p plm-oracle --bin linkages -- 10000                     # so many cases
//! cargo run --release -p plm-oracle --bin linkages -- --seed 7 --only six-bar   # others, of some kinds
//! cargo run --release -p plm-oracle --bin linkages -- --seed 7 --case 123       # one, with all its numbers
//! cargo run --release -p plm-oracle --bin linkages -- --check-reference         # is the reference right?
//! ```
//!
//! Mechanisms run from text, as machine code. With the feature `compiled` rustc compiles them too, in minutes: every case has
//! to have the same bits, and is run in f32.
//!
//! Every case is run in the formulation that the compiler takes, in absolute coordinates (`formulation: absolute;`), and in f32; the latter two
//! by the usual method or one of fixed steps. `--by rk4` takes this method wherever a mechanism can be run by it. Poses,
//! velocities and energies of all samples are compared: a thousand times the tolerance is allowed, 1e-6 of the size with the
//! usual method (1e-3 in f32), more where the motion multiplies a change of 1e-9 at its start by more than a thousand. Steps
//! of a fixed length, a millisecond, may be off by a hundredth, if shorter ones come nearer by ten from a quarter to a sixteenth. What is off by
//! up to ten times as much counts as coarse where the error falls with the tolerance, or with fixed steps as their order says. Where lengths miss a flat pose by
//! less than 1e-13 of the size, numbers of 16 digits cannot tell which motion is meant; such cases are counted apart.
//!
//! With the feature `vary-tolerances` each tolerance of the near-singular method and of charts can be multiplied by a factor:
//!
//! ```sh
//! cargo run --release -p plm-oracle --features vary-tolerances --bin linkages -- 80 --sensitivity all       # each, times 10 and 0.1: a table
//! cargo run --release -p plm-oracle --features vary-tolerances --bin linkages -- 80 --vary NEARER=0.1       # one
//! ```
//!
//! The program fails if a case is wrong; with `--double` f32 is left out, which stops some mechanisms of redundant joints next
//! to their flat poses.
#![allow(missing_docs, reason = "the modules are private to a program")]
#![allow(unreachable_pub, reason = "the modules are private to a program")]
#![allow(clippy::neg_cmp_op_on_partial_ord, reason = "what is not a number is to fail")]

mod cases;
#[cfg(feature = "compiled")]
mod compiled;
mod driven;
mod judge;
mod mechanisms;
mod options;
mod random;
mod reference;
mod run;
mod scene;
#[cfg(feature = "vary-tolerances")]
mod sensitivity;
mod table;
mod trial;

use std::process::ExitCode;
use std::time::Instant;

use cases::{Case, DECIMALS, KINDS};
use judge::{Judged, Verdict, judge};
use options::Options;
use table::Table;

fn main() -> ExitCode {
    let options = match Options::from_args() {
        Ok(Some(options)) => options,
        Ok(None) => return ExitCode::SUCCESS,
        Err(what) => {
            eprintln!("{what}");
            return ExitCode::from(2);
        }
    };
    #[cfg(feature = "vary-tolerances")]
    if let Some(name) = &options.sensitivity {
        return sensitivity::print(&options, name);
    }
    let holds = match (options.check_reference, options.case) {
        (true, _) => reference::check::all(),
        (false, Some(number)) => single(&options, number),
        (false, None) => {
            let driven =
                options.only.is_some() || driven::sweep(options.seed, options.cases / 5, options.verbose);
            sweep(&options) && driven
        }
    };
    if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// A case, by the method that was asked for.
fn drawn(options: &Options, number: u64) -> Case {
    let mut case = Case::new(options.seed, number);
    case.by = options.by.filter(|_| case.entry.every_method()).unwrap_or(case.by);
    case
}

/// One case with all its numbers.
fn single(options: &Options, number: u64) -> bool {
    let case = drawn(options, number);
    println!("{}", case.describe());
    let judged = judge(&case, options.double);
    for judged in &judged {
        println!("{}", told(judged));
    }
    judged.iter().all(|judged| judged.verdict.holds())
}

/// The numbers of all cases.
fn numbers(options: &Options) -> Vec<u64> {
    let wanted = |number: &u64| {
        let name = KINDS[Case::kind_of(*number)].name;
        options.only.as_ref().is_none_or(|only| name.contains(only.as_str()))
    };
    // One in six more has decimal lengths.
    let decimals = (0..options.cases / 6).map(|number| DECIMALS + number);
    (0..options.cases).chain(decimals).filter(wanted).collect()
}

fn sweep(options: &Options) -> bool {
    let clock = Instant::now();
    println!("seed {}, {} cases", options.seed, options.cases);
    let numbers = numbers(options);
    let points = plm_studies::batch::points(numbers).quiet();
    let points = match options.threads {
        Some(threads) => points.threads(threads),
        None => points,
    };
    let runs = points.run(|number| Ok(judge(&drawn(options, number), options.double)));
    let (mut table, mut holds) = (Table::new(), true);
    let (mut evaluations, mut fingerprint) = (0, 0);
    for (number, judged) in runs.values() {
        let kind = Case::kind_of(*number);
        for judged in judged {
            table.add(kind, judged);
            evaluations += judged.evaluations;
            fingerprint = run::fold(fingerprint, [judged.fingerprint].into_iter());
            let wrong = !judged.verdict.holds();
            if wrong && options.verbose {
                let name = KINDS[kind].name;
                println!("--seed {} --case {number}  {name}, {}", options.seed, told(judged));
            }
        }
    }
    for failed in runs.failed() {
        println!("--seed {} --case {}  {:?}", options.seed, failed.parameters, failed.result.as_ref().err());
        holds = false;
    }
    holds &= table.print();
    println!("{evaluations} evaluations, all bits {fingerprint:016x}");
    println!("{:.1} s", clock.elapsed().as_secs_f64());
    holds
}

/// A verdict in a line.
fn told(judged: &Judged) -> String {
    let Judged { mode, verdict, worst, first, own, lively, .. } = judged;
    let what = match verdict {
        Verdict::Right => "right".to_owned(),
        Verdict::Coarse => "right but for the error of steps".to_owned(),
        Verdict::WrongOk => "WRONG, and Ok".to_owned(),
        Verdict::FalseStop(fault) => format!("FALSE STOP, {fault}"),
        Verdict::Undecidable => "undecidable".to_owned(),
        Verdict::Unknown(stop) => format!("the reference does not know: {stop:?}"),
    };
    let first = first.map_or(String::new(), |first| format!(", first at {first:.3} s"));
    format!(
        "{}: {what}; worst {worst:.1e}{first}; the reference's own {own:.1e}; grows {lively:.0}-fold",
        mode.name()
    )
}

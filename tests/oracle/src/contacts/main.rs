//! Random mechanisms with contacts against a reference that is written apart: states, energies and times of events, in every formulation
//! and at every pace.
//!
//! ```sh
//! cargo run --release -p plm-oracle --bin contacts -- 10000                     # so many cases
//! cargo run --release -p plm-oracle --bin contacts -- 50 --first 1200           # from 1200 to 1249 of them: a shard
//! cargo run --release -p plm-oracle --bin contacts -- --seed 7 --only block     # others, of some kinds
//! cargo run --release -p plm-oracle --bin contacts -- --seed 7 --case 123       # one, with all its numbers
//! cargo run --release -p plm-oracle --bin contacts -- --seed 7 --case 123 --tolerance 1e-12
//! cargo run --release -p plm-oracle --bin contacts -- 200 --steps               # errors of fixed steps
//! cargo run --release -p plm-oracle --features compiled --bin contacts -- 100 --bits    # the same bits by rustc
//! ```
//!
//! Mechanisms run from text, as machine code.
#![allow(missing_docs, reason = "the modules are private to a program")]
#![allow(unreachable_pub, reason = "the modules are private to a program")]
#![allow(clippy::neg_cmp_op_on_partial_ord, reason = "what is not a number is to fail")]

#[cfg(feature = "compiled")]
mod compiled;
mod families;
mod judge;
mod reference;
mod run;
mod stepping;
mod steps;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::process::ExitCode;
use std::time::Instant;

use judge::{Case, Judged, Verdict};
use plm_program::{Arguments, BadOption, Known};
use run::{Method, Pace};
use stepping::Stepping;

const KNOWN: [Known; 10] = [
    Known::word("CASES", "how many; 200 if nothing is said"),
    Known::value("seed", "N", "of the random mechanisms; 1 if nothing is said"),
    Known::value("first", "N", "number of the first case; 0 if nothing is said"),
    Known::value("threads", "N", "how many; one for each core if nothing is said"),
    Known::value("case", "N", "this one alone, with all its numbers"),
    Known::value("tolerance", "X", "of that one; 1e-10 if nothing is said"),
    Known::value("only", "KIND", "kinds whose name contains this"),
    Known::flag("verbose", "lists every case that is not right"),
    Known::flag("steps", "compares runs by fixed steps with those from event to event"),
    Known::flag("bits", "compares the bits of each case with those by rustc (feature `compiled`)"),
];

fn main() -> ExitCode {
    match sweep() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(what) => {
            eprintln!("{what}");
            ExitCode::from(2)
        }
    }
}

fn sweep() -> Result<bool, BadOption> {
    let given = Arguments::from_args(&KNOWN)?;
    if let Some(help) = given.help() {
        println!("{help}");
        return Ok(true);
    }
    let seed: u64 = given.number("seed")?.unwrap_or(1);
    let cases: u64 = given.number("CASES")?.unwrap_or(200);
    let (first, threads) = (given.number("first")?.unwrap_or(0), given.number("threads")?.unwrap_or(0));
    let only = given.text("only")?;
    if judge::families(only.as_deref()).is_empty() {
        let kinds: Vec<&str> = judge::families(None).iter().map(|family| family.name).collect();
        eprintln!("no kind has this in its name; there are {}", kinds.join(", "));
        return Ok(false);
    }
    let clock = Instant::now();
    println!("seed {seed}, {cases} cases from {first}");
    if given.flag("bits") {
        let all = (first..first + cases).map(|number| Case::new(seed, number, only.as_deref()));
        return Ok(same_bits(first, all.collect()));
    }
    if given.flag("steps") {
        let all = (first..first + cases).map(|number| (number, Case::new(seed, number, only.as_deref())));
        return Ok(steps::compare(all, given.flag("verbose")));
    }
    let one: Option<u64> = given.number("case")?;
    if let Some(number) = one {
        let tolerance = given.number("tolerance")?.unwrap_or(judge::TOLERANCE);
        println!("{}", told(&Case::new(seed, number, only.as_deref()), tolerance));
    }
    let numbers: Vec<u64> = one.map_or((first..first + cases).collect(), |number| vec![number]);
    let runs = plm_studies::batch::points(numbers)
        .threads(threads)
        .quiet()
        .run(|number| Ok(Case::new(seed, number, only.as_deref()).judge()));
    let mut table: BTreeMap<(&str, &str), Vec<usize>> = BTreeMap::new();
    let (mut holds, verbose) = (true, given.flag("verbose") || one.is_some());
    let (mut impacts, mut events) = (0, 0);
    let mut stepped: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
    for (number, judged) in runs.values() {
        let name = Case::new(seed, *number, only.as_deref()).family.name;
        for judged in judged {
            let place = column(&judged.verdict);
            table.entry((name, judged.formulation)).or_insert_with(|| vec![0; COLUMNS.len()])[place] += 1;
            if let Some(stepping) = judged.stepping {
                stepped.entry(COLUMNS[place]).or_default()[said(stepping)] += 1;
            }
            holds &= !matches!(judged.verdict, Verdict::Wrong(_) | Verdict::FalseStop(_));
            let is_listed = !matches!(judged.verdict, Verdict::Right | Verdict::Sensitive) || one.is_some();
            if verbose && is_listed {
                println!("--seed {seed} --case {number}  {name}, {}", line(judged));
            }
        }
        impacts += judged.first().map_or(0, |judged| judged.impacts);
        events += judged.first().map_or(0, |judged| judged.events);
    }
    for failed in runs.failed() {
        println!("--seed {seed} --case {}  {:?}", failed.parameters, failed.result.as_ref().err());
        holds = false;
    }
    print(&table);
    for (column, [agrees, differs, open]) in stepped {
        println!("{column}: time stepping agrees with {agrees}, differs from {differs}, leaves {open} open");
    }
    println!("{events} events, {impacts} impacts; {:.1} s", clock.elapsed().as_secs_f64());
    Ok(holds)
}

/// Do runs of cases from text have the bits of compiled mechanisms? On the stack that a run with contact takes without optimisation.
#[cfg(feature = "compiled")]
fn same_bits(first: u64, cases: Vec<Case>) -> bool {
    let compare = move || {
        let mut all = [0; 3];
        for (number, case) in (first..).zip(&cases) {
            let counts = compiled::compare(case);
            if counts[2] > 0 {
                println!("--case {number}");
            }
            all.iter_mut().zip(counts).for_each(|(all, count)| *all += count);
        }
        all
    };
    let thread = std::thread::Builder::new().stack_size(64 << 20).spawn(compare);
    let Ok(Ok([runs, faults, differ])) = thread.map(std::thread::JoinHandle::join) else { return false };
    println!("{runs} runs from text, {faults} of which end with a fault; {differ} differ");
    differ == 0
}

#[cfg(not(feature = "compiled"))]
fn same_bits(_first: u64, _cases: Vec<Case>) -> bool {
    eprintln!("build with the feature compiled");
    false
}

const COLUMNS: [&str; 10] = [
    "right",
    "sensitive",
    "ambiguous",
    "stopped",
    "too many",
    "coarse",
    "WRONG",
    "FALSE STOP",
    "unknown",
    "undetermined",
];

fn column(verdict: &Verdict) -> usize {
    match verdict {
        Verdict::Right => 0,
        Verdict::Sensitive => 1,
        Verdict::Ambiguous => 2,
        Verdict::Stopped => 3,
        Verdict::TooMany => 4,
        Verdict::Coarse(_) => 5,
        Verdict::Wrong(_) => 6,
        Verdict::FalseStop(_) => 7,
        Verdict::Unknown(_) => 8,
        Verdict::Undetermined => 9,
    }
}

fn said(stepping: Stepping) -> usize {
    match stepping {
        Stepping::Agrees => 0,
        Stepping::Differs(_) => 1,
        Stepping::Open => 2,
    }
}

fn print(table: &BTreeMap<(&str, &str), Vec<usize>>) {
    print!("{:28}", "");
    for column in COLUMNS {
        print!("{column:>13}");
    }
    println!();
    let mut sums = vec![0; COLUMNS.len()];
    for ((name, formulation), counts) in table {
        print!("{:28}", format!("{name}, {formulation}"));
        for count in counts {
            print!("{count:>13}");
        }
        println!();
        sums.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
    }
    print!("{:28}", "");
    for sum in &sums {
        print!("{sum:>13}");
    }
    println!();
}

fn line(judged: &Judged) -> String {
    let Judged { formulation, pace, verdict, worst, stepping, impacts, events } = judged;
    let stepping = match stepping {
        Some(Stepping::Differs([off, halved])) => {
            format!("; time stepping: {off:.1e} apart, by half the step {halved:.1e}")
        }
        Some(stepping) => format!("; time stepping: {stepping:?}"),
        None => String::new(),
    };
    format!(
        "{formulation}, {pace:?}: {verdict:?}; {worst:.1e} of what is allowed; {events} events, {impacts} impacts{stepping}"
    )
}

/// A case with all its numbers.
fn told(case: &Case, tolerance: f64) -> String {
    let [run, other] = case.reference([0.0125, 0.009]);
    let mut text = format!("{}: {:?}\nstart {:?}\n", case.family.name, case.draft.numbers, case.draft.starts);
    for event in &run.events {
        let _ = writeln!(text, "{:.12} {:?} jump {:.1e}", event.t, event.modes, event.jump);
    }
    for state in &run.samples {
        let _ = writeln!(text, "{:.3} {:.9?} {:.9?}", state.t, state.q, state.v);
    }
    for (number, (formulation, _)) in case.family.declarations.iter().enumerate() {
        let outcome = case.run(number, Method::Events { pace: Pace::Watched, tolerance });
        for sample in &outcome.samples {
            let _ = writeln!(text, "{formulation} {} {:.9?} {:.9?}", sample.index, sample.q, sample.v);
        }
        let _ = writeln!(text, "events at {:.12?}", outcome.events);
        let _ = writeln!(text, "{:?}, {:?}, {:?}", outcome.fault, outcome.counts, outcome.modes);
    }
    text + &format!(
        "{:?}, and {} events and {:?} with other numbers",
        run.stop,
        other.events.len(),
        other.stop
    )
}

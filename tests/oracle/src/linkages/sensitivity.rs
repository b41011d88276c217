//! Each tolerance of `plm-runtime/src/tolerances` tenfold and a tenth: what becomes of the cases and of the drives.
//!
//! The reference's motions are computed once; each row of the table runs all cases again.

use std::process::ExitCode;
use std::time::Instant;

use plm_runtime::tolerances::{names, set_factor};

use crate::cases::{Case, KINDS};
use crate::driven;
use crate::judge::{Judged, Known, Mode, Verdict, judge_by, known};
use crate::options::Options;
use crate::reference::Stop;

/// Each tolerance is multiplied by these.
const FACTORS: [f64; 2] = [10.0, 0.1];

/// A case with the motion that the reference knows.
struct Beside {
    case: Case,
    known: Result<Known, Option<Stop>>,
}

/// Results of all cases and drives.
struct Swept {
    fingerprints: Vec<u64>,
    /// Of f64: ended `Ok` and off, and ended where the motion goes on.
    wrong: usize,
    stopped: usize,
    /// Runs in f32 that ended `Ok` and off, and that ended where the motion goes on.
    single: usize,
    /// Drives of which something is wrong.
    drives: usize,
    evaluations: u64,
    seconds: f64,
}

/// Prints the table, in Markdown: of the tolerances whose name contains `name`, or of `all`.
pub fn print(options: &Options, name: &str) -> ExitCode {
    let cases = cases(options);
    let base = Swept::of(options, &cases);
    println!(
        "{} runs of {} cases and drives, seed {}; {:.1} s each",
        base.fingerprints.len(),
        options.cases,
        options.seed,
        base.seconds
    );
    println!("| tolerance | times 10 | times 0.1 |\n|---|---|---|");
    println!("| none | {} | |", base.told(&base));
    for name in names().filter(|of| name == "all" || of.contains(name)) {
        let cells = FACTORS.map(|factor| {
            set_factor(name, factor);
            let swept = Swept::of(options, &cases);
            set_factor(name, 1.0);
            swept.told(&base)
        });
        println!("| {name} | {} |", cells.join(" | "));
    }
    ExitCode::SUCCESS
}

/// All cases but trees, which have no singular pose.
fn cases(options: &Options) -> Vec<Beside> {
    let has_loops = |number: &u64| KINDS[Case::kind_of(*number)].name != "tree";
    let numbers = crate::numbers(options).into_iter().filter(has_loops).collect::<Vec<_>>();
    let runs = plm_studies::batch::points(numbers).quiet().run(|number| {
        let case = crate::drawn(options, number);
        let known = known(&case, options.double);
        Ok(Beside { case, known })
    });
    runs.all().expect("what the reference does not know is a value")
}

impl Swept {
    fn of(options: &Options, cases: &[Beside]) -> Self {
        let clock = Instant::now();
        let runs = plm_studies::batch::points(0..cases.len()).quiet().run(|index| {
            let Beside { case, known } = &cases[index];
            Ok(judge_by(case, options.double, known.as_ref()))
        });
        let judged = runs.all().expect("what is wrong with a case is a value").into_iter().flatten();
        let drives = driven::all(options.seed, options.cases / 5);
        let mut swept = Self {
            fingerprints: Vec::new(),
            wrong: 0,
            stopped: 0,
            single: 0,
            drives: drives.iter().filter(|told| told.wrong.is_some()).count(),
            evaluations: drives.iter().map(|told| told.evaluations).sum(),
            seconds: 0.0,
        };
        judged.for_each(|judged| swept.add(&judged));
        swept.fingerprints.extend(drives.iter().map(|told| told.fingerprint));
        swept.seconds = clock.elapsed().as_secs_f64();
        swept
    }

    fn add(&mut self, judged: &Judged) {
        self.fingerprints.push(judged.fingerprint);
        self.evaluations += judged.evaluations;
        match (&judged.verdict, judged.mode) {
            (Verdict::WrongOk | Verdict::FalseStop(_), Mode::Single) => self.single += 1,
            (Verdict::WrongOk, _) => self.wrong += 1,
            (Verdict::FalseStop(_), _) => self.stopped += 1,
            _ => {}
        }
    }

    /// A cell of the table: runs that have other bits than `base`, those that are wrong, and the ratio of evaluations and of time.
    fn told(&self, base: &Self) -> String {
        let Self { wrong, stopped, single, drives, .. } = self;
        let pairs = self.fingerprints.iter().zip(&base.fingerprints);
        let changed = pairs.filter(|(own, base)| own != base).count();
        let work = self.evaluations as f64 / base.evaluations as f64;
        let time = self.seconds / base.seconds;
        format!(
            "{changed} changed, {wrong} wrong, {stopped} stopped, f32 {single}, drives {drives}, work {work:.2}, time {time:.2}"
        )
    }
}

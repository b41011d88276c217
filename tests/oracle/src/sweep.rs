//! Sweeps by name, and what their cases come to.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::draw::Draw;
use crate::{
    bounded, bounds, declarations, driven, geared, gradients, hostile, late, locks, pages, resets, sources,
    wheels,
};

/// All sweeps.
pub const SWEEPS: &[Sweep] = &[
    Sweep {
        name: "bounded",
        title: "scenes that took time without bound, or stopped",
        quick: 30,
        case: bounded::case,
    },
    Sweep {
        name: "driven",
        title: "motions that are prescribed, with friction",
        quick: 24,
        case: driven::case,
    },
    Sweep {
        name: "gradients",
        title: "derivatives of machines that close as drawn",
        quick: 14,
        case: gradients::case,
    },
    Sweep {
        name: "late",
        title: "contact and conditions in model exchange, by importers that are late",
        quick: 100,
        case: late::case,
    },
    Sweep {
        name: "locks",
        title: "linkages whose dyads become flat, several at once",
        quick: 60,
        case: locks::case,
    },
    Sweep { name: "hostile", title: "numbers that nobody means", quick: 600, case: hostile::case },
    Sweep { name: "bounds", title: "fits whose bounds hold", quick: 100, case: bounds::case },
    Sweep { name: "resets", title: "states that a `when` sets", quick: 200, case: resets::case },
    Sweep {
        name: "geared",
        title: "geared five-bars of which the crank is declared",
        quick: 60,
        case: geared::case,
    },
    Sweep { name: "pages", title: "parts as their pages show them, turned", quick: 60, case: pages::case },
    Sweep {
        name: "wheels",
        title: "belts, chains and gears all round the circle",
        quick: 60,
        case: wheels::case,
    },
    Sweep {
        name: "declarations",
        title: "all that the book, examples and benchmarks declare, by every method",
        quick: 8,
        case: declarations::case,
    },
    Sweep {
        name: "sources",
        title: "the same declarations as C source, beside steps from text",
        quick: 60,
        case: sources::case,
    },
];

/// The stack of a thread, bytes, as of the main thread of a program: the largest size of mechanisms takes more than the 2 MiB of others.
const STACK: usize = 8 << 20;

/// Random cases of one kind.
pub struct Sweep {
    /// As `plm-oracle` takes it.
    pub name: &'static str,
    /// The subject of its cases, for the list of sweeps.
    pub title: &'static str,
    /// As many cases as the tests run: some ten seconds.
    pub quick: u64,
    /// Draws a case, runs it, and compares it.
    pub(crate) case: fn(&mut Draw) -> Case,
}

/// A case with what came of it.
pub(crate) struct Case {
    /// Name of its kind within the sweep, for the table.
    pub(crate) family: String,
    /// The declaration, and all else that repeats it by hand.
    pub(crate) text: String,
    pub(crate) verdict: Verdict,
}

/// Verdict of a comparison.
pub(crate) enum Verdict {
    /// Within so many times the bound; at most 1.
    Right(f64),
    /// The run stopped with a true cause.
    Stopped(String),
    /// Nothing that is independent says what is right.
    Undecided(String),
    Wrong(String),
}

/// The verdicts of many cases.
pub struct Table {
    /// Right, stopped, undecided, wrong, by family.
    rows: BTreeMap<String, [u64; 4]>,
    /// The number, the verdict and the text of those that are wrong; of all where there are few.
    shown: Vec<(u64, Case)>,
}

impl Table {
    /// Runs cases on all cores. The table does not depend on their number.
    pub fn of(sweep: &Sweep, seed: u64, cases: Range<u64>) -> Self {
        let next = AtomicU64::new(cases.start);
        let done = Mutex::new(Vec::new());
        let few = cases.end - cases.start == 1;
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let work = || {
            while let Some(number) = Some(next.fetch_add(1, Ordering::Relaxed)).filter(|n| *n < cases.end) {
                let case = (sweep.case)(&mut Draw::new(seed, number));
                if let Ok(mut done) = done.lock() {
                    done.push((number, case));
                }
            }
        };
        std::thread::scope(|scope| {
            for _ in 0..threads {
                let thread = std::thread::Builder::new().stack_size(STACK);
                if thread.spawn_scoped(scope, work).is_err() {
                    work();
                }
            }
        });
        let mut done = done.into_inner().unwrap_or_default();
        done.sort_by_key(|(number, _)| *number);
        let mut rows: BTreeMap<String, [u64; 4]> = BTreeMap::new();
        for (_, case) in &done {
            rows.entry(case.family.clone()).or_default()[case.verdict.column()] += 1;
        }
        done.retain(|(_, case)| few || matches!(case.verdict, Verdict::Wrong(_)));
        Self { rows, shown: done }
    }

    /// Is no case wrong?
    pub fn holds(&self) -> bool {
        self.rows.values().all(|[.., wrong]| *wrong == 0)
    }

    /// The table, above it the cases that are wrong, the first of them with their texts.
    pub fn shown(&self, all: bool) -> String {
        let mut lines: Vec<String> = Vec::new();
        for (k, (number, case)) in self.shown.iter().enumerate() {
            let text = if all || k < 5 { format!("\n{}", case.text) } else { String::new() };
            lines.push(format!("case {number}: {}{text}", case.verdict));
        }
        lines.push(format!("{:32} {:>7} {:>7} {:>9} {:>7}", "", "right", "stopped", "undecided", "wrong"));
        for (family, [right, stopped, undecided, wrong]) in &self.rows {
            lines.push(format!("{family:32} {right:>7} {stopped:>7} {undecided:>9} {wrong:>7}"));
        }
        lines.join("\n")
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Right(share) => write!(f, "right, {share:.3} of the bound"),
            Self::Stopped(why) => write!(f, "stopped: {why}"),
            Self::Undecided(why) => write!(f, "undecided: {why}"),
            Self::Wrong(why) => write!(f, "WRONG: {why}"),
        }
    }
}

impl Verdict {
    fn column(&self) -> usize {
        match self {
            Self::Right(_) => 0,
            Self::Stopped(_) => 1,
            Self::Undecided(_) => 2,
            Self::Wrong(_) => 3,
        }
    }
}

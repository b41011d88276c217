//! Table of verdicts, by kind and mode.

use crate::cases::KINDS;
use crate::judge::{Judged, Mode, Verdict};

#[derive(Clone, Copy, Default)]
struct Line {
    runs: usize,
    right: usize,
    coarse: usize,
    wrong: usize,
    stopped: usize,
    undecidable: usize,
    unknown: usize,
    /// Of those that are right.
    worst: f64,
    own: f64,
}

/// Counts.
pub struct Table {
    lines: Vec<[Line; 3]>,
}

impl Table {
    pub fn new() -> Self {
        Self { lines: vec![[Line::default(); 3]; KINDS.len()] }
    }

    pub fn add(&mut self, kind: usize, judged: &Judged) {
        let line = &mut self.lines[kind][judged.mode as usize];
        line.runs += 1;
        line.own = line.own.max(judged.own);
        match judged.verdict {
            Verdict::Right => {
                line.right += 1;
                line.worst = line.worst.max(judged.worst);
            }
            Verdict::Coarse => line.coarse += 1,
            Verdict::WrongOk => line.wrong += 1,
            Verdict::FalseStop(_) => line.stopped += 1,
            Verdict::Undecidable => line.undecidable += 1,
            Verdict::Unknown(_) => line.unknown += 1,
        }
    }

    /// Prints it; whether every case that can be decided is right.
    pub fn print(&self) -> bool {
        println!(
            "{:<26}{:<10}{:>6}{:>7}{:>8}{:>10}{:>12}{:>13}{:>9}{:>14}{:>12}",
            "kind",
            "mode",
            "runs",
            "right",
            "coarse",
            "wrong Ok",
            "false stop",
            "undecidable",
            "unknown",
            "worst right",
            "reference"
        );
        let mut all = [Line::default(); 3];
        for (kind, lines) in KINDS.iter().zip(&self.lines) {
            for (mode, line) in Mode::ALL.into_iter().zip(lines) {
                if line.runs > 0 {
                    show(kind.name, mode, line);
                }
                all[mode as usize].add(line);
            }
        }
        for (mode, line) in Mode::ALL.into_iter().zip(&all).filter(|(_, line)| line.runs > 0) {
            show("all", mode, line);
        }
        all.iter().all(|line| line.wrong + line.stopped + line.unknown == 0)
    }
}

impl Line {
    fn add(&mut self, other: &Self) {
        self.runs += other.runs;
        self.right += other.right;
        self.coarse += other.coarse;
        self.wrong += other.wrong;
        self.stopped += other.stopped;
        self.undecidable += other.undecidable;
        self.unknown += other.unknown;
        self.worst = self.worst.max(other.worst);
        self.own = self.own.max(other.own);
    }
}

fn show(name: &str, mode: Mode, line: &Line) {
    let Line { runs, right, coarse, wrong, stopped, undecidable, unknown, worst, own } = line;
    let mode = mode.name();
    println!(
        "{name:<26}{mode:<10}{runs:>6}{right:>7}{coarse:>8}{wrong:>10}{stopped:>12}{undecidable:>13}{unknown:>9}{worst:>14.1e}{own:>12.1e}"
    );
}

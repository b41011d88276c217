//! What the runs become: a table in CSV, a table to read, a picture.

use std::fmt::Write as _;

use plm_view::{Axis, Chart, Series};

use crate::measure::{Line, Look, Outcome, Scene};

/// Errors for which the least time is told.
const GOALS: [f64; 7] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];

/// Other programs in the order of their colours, which the summary has too.
const OTHERS: [&str; 4] = ["heyoka", "diffsol Tsit45", "diffsol BDF", "rapier2d"];

/// Methods that stand for plm beside other programs: the cheapest to few, to some and to many digits.
const CHOSEN: [&str; 3] = ["RK4", "DOP853", "Verner 9(8)"];

/// Every line has to come that near to its reference, as a fraction of what is hopeless.
const NEAR: f64 = 1e-4;

/// A scene and what was measured in it.
pub struct Result {
    pub scene: &'static Scene,
    pub lines: Vec<Line>,
}

impl Line {
    /// `DOP853, tree`; the name alone for another program.
    fn name(&self) -> String {
        if self.formulation.is_empty() {
            self.method.clone()
        } else {
            format!("{}, {}", self.method, self.formulation)
        }
    }

    /// A picture with every line of the table could not be read. Beside other programs it shows three methods in the least
    /// formulation, else all of them there, and of higher formulations the best method alone.
    fn is_drawn(&self, is_beside_others: bool) -> bool {
        match self.look {
            Look::Ours { variant, .. } if is_beside_others => {
                variant == 0 && CHOSEN.contains(&self.method.as_str())
            }
            Look::Ours { family, variant } => variant == 0 || family == 0,
            Look::Peer => true,
        }
    }

    fn outcomes(&self) -> impl Iterator<Item = &Outcome> {
        self.points.iter().filter_map(|point| point.outcome.as_ref().ok())
    }

    /// The smallest error of all settings.
    pub fn smallest_error(&self) -> f64 {
        self.outcomes().map(|outcome| outcome.error).fold(f64::INFINITY, f64::min)
    }

    /// The longest run, s.
    pub fn slowest(&self) -> f64 {
        self.outcomes().map(|outcome| outcome.seconds).fold(0.0, f64::max)
    }

    /// The fastest run with an error of at most `goal` whose next finer setting has that too: no lucky hit.
    pub fn fastest(&self, goal: f64) -> Option<&Outcome> {
        let runs = || self.points.iter().map(|point| point.outcome.as_ref().ok());
        let finer = runs().skip(1).chain([None]);
        let last = self.points.len().saturating_sub(1);
        let pairs = runs().zip(finer).enumerate();
        let reaches = |run: Option<&Outcome>| run.is_some_and(|run| run.error <= goal);
        let sure = pairs.filter(|(k, (run, finer))| reaches(*run) && (*k == last || reaches(*finer)));
        sure.filter_map(|(_, (run, _))| run).min_by(|a, b| a.seconds.total_cmp(&b.seconds))
    }

    /// The runs that no other one beats in both error and time, from coarse to fine: what a chart shows.
    fn unbeaten(&self) -> Vec<&Outcome> {
        let mut runs: Vec<&Outcome> = self.outcomes().collect();
        runs.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
        let mut smallest = f64::INFINITY;
        runs.retain(|run| {
            let is_better = run.error < smallest;
            smallest = smallest.min(run.error);
            is_better
        });
        runs
    }
}

impl Result {
    /// Takes the time of another round where it is less.
    pub fn least(&mut self, other: &Self) {
        let lines = self.lines.iter_mut().zip(&other.lines);
        for (point, other) in lines.flat_map(|(line, other)| line.points.iter_mut().zip(&other.points)) {
            if let (Ok(outcome), Ok(other)) = (&mut point.outcome, &other.outcome) {
                outcome.seconds = outcome.seconds.min(other.seconds);
            }
        }
    }

    /// Rows of the CSV file, without a heading.
    pub fn csv(&self) -> String {
        let mut text = String::new();
        for line in &self.lines {
            for point in &line.points {
                let head =
                    format!("{},{},{},{:.3e}", self.scene.id, line.formulation, line.method, point.setting);
                let _ = match &point.outcome {
                    Ok(o) => writeln!(text, "{head},{:.3e},{:.3e},{},", o.error, o.seconds, o.evaluations),
                    Err(fault) => writeln!(text, "{head},,,,\"{}\"", fault.replace('"', "'")),
                };
            }
        }
        text
    }

    /// The least time to an error and its evaluations, line by line; the fastest of each column in bold.
    pub fn table(&self) -> String {
        let goals = GOALS.map(|goal| format!(" {goal:.0e} |")).concat();
        let rule = "---:|".repeat(GOALS.len());
        let mut text = format!("| {}: µs (evaluations) to an error of |{goals}\n|---|{rule}", self.scene.id);
        let best = GOALS.map(|goal| {
            let times = self.lines.iter().filter_map(|line| line.fastest(goal));
            times.map(|outcome| outcome.seconds).fold(f64::INFINITY, f64::min)
        });
        for line in &self.lines {
            let cells = GOALS.iter().zip(best).map(|(&goal, best)| cell(line.fastest(goal), best));
            let _ = write!(text, "\n| {} | {} |", line.name(), cells.collect::<Vec<_>>().join(" | "));
        }
        text + "\n"
    }

    /// Which of plm's lines stay away from the reference, although their finest settings were run: none of their runs is longer
    /// than `longest_run`, in s.
    pub fn far(&self, longest_run: f64) -> Vec<String> {
        let ours =
            self.lines.iter().filter(|line| !line.formulation.is_empty() && line.slowest() <= longest_run);
        // An error that is not a number is none that is near.
        let is_near = |line: &&Line| line.smallest_error() <= NEAR * self.scene.hopeless;
        let far = ours.filter(|line| !is_near(line));
        far.map(|line| format!("{}: {} never comes near", self.scene.id, line.name())).collect()
    }

    pub fn chart(&self) -> Chart {
        let of = if self.scene.relative {
            ("largest relative error", "")
        } else {
            ("largest error of a position", "m")
        };
        let chart = Chart::new(Axis::log(of.0, of.1).falling(), Axis::log("CPU time", "µs"))
            .titled(format!("{}, {}", self.scene.id, self.scene.title))
            .noted(self.note());
        let drawn: Vec<&Line> = self.lines.iter().filter(|line| line.is_drawn(self.has_others())).collect();
        drawn.into_iter().enumerate().fold(chart, |chart, (number, line)| {
            let runs = line.unbeaten().into_iter().filter(|run| run.error <= self.scene.hopeless);
            let name = if self.has_others() && !line.formulation.is_empty() {
                format!("plm, {}", line.method)
            } else {
                line.name()
            };
            let series = Series::new(name, runs.map(|o| (o.error, 1e6 * o.seconds))).marked();
            chart.with(match line.look {
                // Ours in one colour, each other program in one of its own.
                Look::Ours { .. } if self.has_others() => series.of_family(0, number),
                Look::Ours { family, variant } => series.of_family(family, variant),
                Look::Peer => {
                    series.of_family(1 + OTHERS.iter().position(|of| *of == line.method).unwrap_or(4), 0)
                }
            })
        })
    }

    /// Whether other programs are in the scene.
    fn has_others(&self) -> bool {
        self.lines.iter().any(|line| line.formulation.is_empty())
    }

    /// What holds on every machine.
    fn note(&self) -> String {
        let mut facts: Vec<&str> = self.lines.iter().map(|line| line.facts.as_str()).collect();
        facts.retain(|fact| !fact.is_empty());
        facts.dedup();
        let left_out = if self.has_others() {
            "\nOf plm three methods in the least formulation; the table has all of them."
        } else {
            ""
        };
        format!("{}\nOperations of an evaluation: {}.{left_out}", self.scene.facts, facts.join(", "))
    }
}

/// How the program ends.
///
/// # Errors
/// The lines that never come near their references.
pub fn outcome(far: &[String]) -> std::result::Result<(), String> {
    if far.is_empty() { Ok(()) } else { Err(far.join("\n")) }
}

fn cell(outcome: Option<&Outcome>, best: f64) -> String {
    let Some(Outcome { seconds, evaluations, .. }) = outcome else { return "–".to_owned() };
    let micros = 1e6 * seconds;
    let digits = usize::from(micros < 9.95);
    let mark = if *seconds <= best { "**" } else { "" };
    format!("{mark}{micros:.digits$}{mark} ({evaluations})")
}

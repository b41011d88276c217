//! One line of a chart: a formulation with a method, or another program, from coarse to fine settings.

use std::hint::black_box;
use std::time::Instant;

use plm::runtime::Ports;
use plm::{Fault, Mechanism, Method, Sim};
use plm_peers::{Peer, Run, Setting};

/// How many runs are made.
pub struct Effort {
    /// Tolerances and steps for each factor of ten; 0 measures nothing.
    pub per_decade: i32,
    pub fewest_runs: u32,
    pub most_runs: u32,
    /// Time for the runs of one setting, s.
    pub spent: f64,
    /// No finer settings after a run as long as this, s.
    pub longest_run: f64,
}

/// A scene: what is run, for how long, and what is measured.
pub struct Scene {
    /// As in the references, such as `S1`.
    pub id: &'static str,
    pub title: &'static str,
    /// What holds on every machine.
    pub facts: &'static str,
    /// End of the run, s.
    pub until: f64,
    /// Fewest steps of a method with fixed steps.
    pub fewest_steps: u32,
    /// Errors are relative to each number, not absolute.
    pub relative: bool,
    /// What is wrong by more than this has nothing to do with the scene any more.
    pub hopeless: f64,
    /// Its lines.
    pub run: fn(&Bench) -> Vec<Line>,
}

/// A scene with its reference.
pub struct Bench<'a> {
    pub scene: &'a Scene,
    pub reference: Vec<f64>,
    pub effort: &'a Effort,
}

/// A mechanism in one formulation, ready for every method.
pub struct Formulation<'a, M> {
    pub bench: &'a Bench<'a>,
    pub mechanism: M,
    pub name: &'static str,
    /// Number of the formulation in its scene.
    pub variant: usize,
    /// Size and cost, for the note of the chart.
    pub facts: String,
}

/// Runs that belong together, from coarse to fine.
#[derive(Clone)]
pub struct Line {
    pub method: String,
    pub formulation: &'static str,
    pub look: Look,
    pub facts: String,
    pub points: Vec<Point>,
}

#[derive(Clone)]
pub enum Look {
    Ours { family: usize, variant: usize },
    Peer,
}

/// One setting and what came out.
#[derive(Clone)]
pub struct Point {
    /// Relative tolerance, or step in s.
    pub setting: f64,
    pub outcome: Result<Outcome, String>,
}

#[derive(Clone)]
pub struct Outcome {
    pub error: f64,
    pub seconds: f64,
    pub evaluations: u64,
}

impl<M: Mechanism<S = f64> + Ports> Formulation<'_, M> {
    /// The line of a method; `with` makes it from a relative tolerance or a step in s.
    pub fn line<I: Method<M>>(
        &self,
        family: usize,
        method: &'static str,
        setting: Setting,
        with: fn(f64) -> I,
    ) -> Line {
        let until = self.bench.scene.until;
        let points = self.bench.sweep(setting, |setting| {
            let sim = self.mechanism.start_with(with(setting)).map_err(told)?;
            self.bench.best(|| one_run(&sim, until).map_err(told))
        });
        let look = Look::Ours { family, variant: self.variant };
        Line { method: method.to_owned(), formulation: self.name, look, facts: self.facts.clone(), points }
    }
}

/// Runs a copy of an assembled simulation to the end.
fn one_run<M: Mechanism<S = f64> + Ports, I: Method<M>>(start: &Sim<M, I>, until: f64) -> Result<Run, Fault> {
    let mut sim = black_box(start.clone());
    let begin = Instant::now();
    sim.step(until)?;
    let seconds = begin.elapsed().as_secs_f64();
    let mut measured = Vec::new();
    M::outputs(black_box(sim.state()), &mut |value| measured.push(value));
    Ok(Run { seconds, evaluations: sim.stats().evaluations, measured })
}

fn told(fault: Fault) -> String {
    fault.to_string()
}

impl Bench<'_> {
    /// The line of another program.
    pub fn peer(&self, peer: &Peer) -> Line {
        let gave_up = || "gave up".to_owned();
        let points =
            self.sweep(peer.setting, |setting| self.best(|| (peer.run)(setting).ok_or_else(gave_up)));
        Line { method: peer.name.to_owned(), formulation: "", look: Look::Peer, facts: String::new(), points }
    }

    /// One point for each setting, as long as a run is not too long.
    fn sweep(&self, setting: Setting, run: impl Fn(f64) -> Result<Run, String>) -> Vec<Point> {
        let mut points: Vec<Point> = Vec::new();
        for setting in self.settings(setting) {
            let outcome = run(setting).map(|run| self.judge(&run));
            let is_long = outcome.as_ref().is_ok_and(|outcome| outcome.seconds > self.effort.longest_run);
            points.push(Point { setting, outcome });
            if is_long {
                break;
            }
        }
        points
    }

    fn settings(&self, setting: Setting) -> Vec<f64> {
        let per_decade = self.effort.per_decade;
        if per_decade == 0 {
            return Vec::new();
        }
        match setting {
            Setting::Tolerance => (2 * per_decade..=13 * per_decade)
                .map(|k| 10_f64.powf(-f64::from(k) / f64::from(per_decade)))
                .collect(),
            // An order of 4 to 8 makes a step twice as long cost a factor of 16 to 256.
            Setting::Step => (0..=8 * per_decade)
                .map(|k| 10_f64.powf(0.5 * f64::from(k) / f64::from(per_decade)))
                .map(|finer| self.scene.until / (f64::from(self.scene.fewest_steps) * finer).round())
                .collect(),
        }
    }

    /// The fastest of several runs: what is slower was disturbed. They all end in the same place.
    fn best(&self, run: impl Fn() -> Result<Run, String>) -> Result<Run, String> {
        let mut best = run()?;
        let (mut count, mut spent) = (1, best.seconds);
        while count < self.effort.fewest_runs || (spent < self.effort.spent && count < self.effort.most_runs)
        {
            let again = run()?;
            (count, spent) = (count + 1, spent + again.seconds);
            best.seconds = best.seconds.min(again.seconds);
        }
        Ok(best)
    }

    fn judge(&self, run: &Run) -> Outcome {
        let off = |(found, expected): (&f64, &f64)| {
            let difference = (found - expected).abs();
            if self.scene.relative { difference / expected.abs() } else { difference }
        };
        // A NaN must not be lost in a maximum.
        let larger = |a: f64, b: f64| if b > a || b.is_nan() { b } else { a };
        let error = run.measured.iter().zip(&self.reference).map(off).fold(0.0, larger);
        Outcome { error, seconds: run.seconds, evaluations: run.evaluations }
    }
}

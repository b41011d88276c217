//! Motion from event to event: smooth motion in given modes, and where a mode ends.

use super::choose::stick;
use super::extrapolation::step;
use super::problem::{Mode, Problem};
use super::world::World;

/// Why the reference ends before its time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// More than one motion goes on from here.
    Ambiguous,
    /// The law of impact does not say how an impulse is shared.
    Undetermined,
    /// No motion satisfies the laws.
    Nothing,
    /// Too many events.
    Endless,
    /// It does not know.
    Lost,
}

/// A moment.
#[derive(Clone, Debug)]
pub struct State {
    pub t: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
}

/// Discrete state, which is constant between two events.
#[derive(Clone, Debug)]
pub struct Held {
    pub modes: Vec<Mode>,
    pub carried: Vec<bool>,
    /// Displacements of rows that stick.
    pub places: Vec<f64>,
    /// The sign of the determinant, and of the forces of joints along a line.
    pub determinant: f64,
    pub lines: Vec<f64>,
    /// Forces, from where Newton's method begins.
    pub lambda: Vec<f64>,
}

/// A run.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// States at the times that were asked for.
    pub samples: Vec<State>,
    pub events: Vec<Event>,
    pub stop: Option<(f64, Stop)>,
    pub impacts: usize,
}

/// An event of which others can see something: its time, the state before it and the one after it.
#[derive(Clone, Debug)]
pub struct Event {
    pub t: f64,
    pub modes: Vec<Mode>,
    /// The largest change of a velocity.
    pub jump: f64,
}

/// Below this a margin of a row is passed.
pub const PASSED: f64 = 1e-11;
/// Gaps are known better than the other margins by this factor.
const FINER: f64 = 5000.0;
/// Rounding of a gap, m or rad: a gap above minus this has not passed zero.
pub const FLAT: f64 = PASSED / FINER;
/// Parts of a step in which a gap near zero is looked at.
const PARTS: u32 = 8;
const MOST_EVENTS: usize = 3000;

pub struct Runner<'w> {
    pub world: &'w World,
    pub longest: f64,
    /// Width below which a gap is closed, m or rad. A wider gap has an impact of its own.
    pub closed: f64,
    pub now: State,
    pub held: Held,
    pub run: Run,
}

impl Runner<'_> {
    pub fn problem(&self, state: &State) -> Problem {
        Problem::new(self.world, state.t, &state.q, &state.v)
    }

    /// Runs to the times, which ascend.
    pub fn go(mut self, times: &[f64]) -> Run {
        if let Err(stop) = self.event(None) {
            self.run.stop = Some((self.now.t, stop));
            return self.run;
        }
        for time in times {
            if let Err(stop) = self.go_to(*time) {
                self.run.stop = Some((self.now.t, stop));
                return self.run;
            }
            self.run.samples.push(self.now.clone());
        }
        self.run
    }

    fn go_to(&mut self, until: f64) -> Result<(), Stop> {
        let mut h = self.longest;
        while self.now.t < until - 1e-15 {
            let left = until - self.now.t;
            let last = h >= left;
            let taken = if last { left } else { h };
            let Some(mut next) = self.moved(taken) else {
                h = 0.5 * taken;
                if h < 1e-9 {
                    return Err(Stop::Lost);
                }
                continue;
            };
            if last {
                next.t = until;
            }
            if self.passed(&next, taken).is_some() {
                let row = self.locate(taken)?;
                self.project()?;
                self.event(row)?;
                if self.run.events.len() > MOST_EVENTS {
                    return Err(Stop::Endless);
                }
            } else {
                self.now = next;
                self.project()?;
            }
            h = self.longest;
        }
        Ok(())
    }

    /// The state a time later in the modes held; none if the step is too long.
    fn moved(&self, h: f64) -> Option<State> {
        step(&self.now, h, &|state| {
            let problem = self.problem(state);
            let (lambda, _) = problem.forces(&self.held.modes, &self.held.lambda)?;
            Some(problem.accelerations(&lambda))
        })
    }

    /// The margins in the modes held that are passed: the least, and its row; that of the determinant has no row.
    fn passed(&self, state: &State, h: f64) -> Option<(f64, Option<usize>)> {
        let worst = self.least(state);
        if worst.0 < -PASSED {
            return Some(worst);
        }
        // A margin can dip between two samples.
        let samples = [&self.now, state].map(|state| self.problem(state));
        for i in 0..samples[0].count() {
            let [Some(a), Some(b)] = samples.each_ref().map(|problem| self.dipping(problem, i)) else {
                continue;
            };
            let is_near = a.0.min(b.0) < h * (a.1.abs() + b.1.abs());
            let dips = || match self.held.modes[i] {
                Mode::Open => self.dips(i, h, [a, b]),
                // It has one lowest place.
                _ => a.1 < 0.0 && b.1 > 0.0 && self.dips_between(i, (0.0, a.1), (h, b.1)),
            };
            if is_near && dips() {
                return Some((-1.0, Some(i)));
            }
        }
        None
    }

    /// A margin that can dip, and its rate: an open gap, or the speed of a friction that slips; none of other rows.
    fn dipping(&self, problem: &Problem, row: usize) -> Option<(f64, f64)> {
        let (mode, seen) = (self.held.modes[row], &problem.rows[row]);
        match mode {
            _ if self.held.carried[row] => None,
            Mode::Open => Some((seen.value, seen.rate)),
            _ if mode.sign() != 0.0 => {
                let (lambda, _) = problem.forces(&self.held.modes, &self.held.lambda)?;
                let sign = mode.sign();
                Some((sign * seen.rate, sign * problem.acceleration(row, &lambda).0))
            }
            _ => None,
        }
    }

    /// Is a gap negative within the time `h`, at whose ends it has these values and rates?
    fn dips(&self, row: usize, h: f64, [first, last]: [(f64, f64); 2]) -> bool {
        let mut from = (0.0, first.1);
        for k in 1..=PARTS {
            let t = h * f64::from(k) / f64::from(PARTS);
            let (value, rate) = if k == PARTS { last } else { self.after(row, t) };
            let to = (t, rate);
            if value < -FLAT || from.1 < 0.0 && rate > 0.0 && self.dips_between(row, from, to) {
                return true;
            }
            from = to;
        }
        false
    }

    /// Is a margin negative where it is lowest, between two times with its rates there? Time is halved until they cannot lead to zero.
    fn dips_between(&self, row: usize, mut low: (f64, f64), mut high: (f64, f64)) -> bool {
        let rounding = if self.held.modes[row] == Mode::Open { FLAT } else { PASSED };
        loop {
            let middle = 0.5 * (low.0 + high.0);
            let (value, rate) = self.after(row, middle);
            if value < -rounding {
                return true;
            }
            // False for what is not a number.
            let may_dip = value <= (high.0 - low.0) * high.1.max(-low.1) && high.0 - low.0 > 1e-12;
            if !may_dip {
                return false;
            }
            *if rate < 0.0 { &mut low } else { &mut high } = (middle, rate);
        }
    }

    /// A margin that can dip, and its rate, a time later in the modes held.
    fn after(&self, row: usize, t: f64) -> (f64, f64) {
        let seen = self.moved(t).and_then(|state| self.dipping(&self.problem(&state), row));
        seen.unwrap_or((f64::NAN, f64::NAN))
    }

    fn least(&self, state: &State) -> (f64, Option<usize>) {
        let problem = self.problem(state);
        let Some((lambda, determinant)) = problem.forces(&self.held.modes, &self.held.lambda) else {
            return (-1.0, None);
        };
        let mut worst = (determinant * self.held.determinant, None);
        for i in 0..problem.count() {
            if self.held.carried[i] {
                continue;
            }
            let force = problem.acceleration(i, &lambda).1 / problem.d[i][i];
            let value = match self.held.modes[i] {
                // One that opens has been left just now.
                Mode::Open if problem.rows[i].rate >= 0.0 => 1.0,
                Mode::Open => FINER * problem.rows[i].value,
                Mode::Closed => lambda[i] / force,
                Mode::Sticks => stick(&problem, i, &lambda) / force,
                Mode::Off => continue,
                mode => mode.sign() * problem.rows[i].rate,
            };
            if value < worst.0 {
                worst = (value, Some(i));
            }
        }
        for i in 0..problem.count() {
            let line = problem.line(i, &lambda).map_or(1.0, |force| force * self.held.lines[i]);
            if line < worst.0 {
                worst = (line, Some(i));
            }
        }
        worst
    }

    /// Goes to where the first margin is passed, within the time `h`; gives its row. Regula falsi by the rule of Illinois (M. Dowell,
    /// P. Jarratt, BIT 11, 1971) as soon as a margin is known where nothing is passed yet, halves before.
    fn locate(&mut self, h: f64) -> Result<Option<usize>, Stop> {
        let (mut low, mut high): ((f64, Option<f64>), (f64, Option<f64>)) = ((0.0, None), (h, None));
        let (mut row, mut side, mut behind) = (None, 0, None);
        for _ in 0..200 {
            let middle = 0.5 * (low.0 + high.0);
            let tried = match (low.1, high.1) {
                (Some(a), Some(b)) => {
                    let s = (low.0 * b - high.0 * a) / (b - a);
                    if s > low.0 && s < high.0 { s } else { middle }
                }
                _ => middle,
            };
            let Some(state) = self.moved(tried) else {
                // The accelerations bend within it, where a margin is passed.
                (high, side, behind) = ((tried, None), 0, None);
                if high.0 - low.0 < 1e-9 {
                    return Err(Stop::Lost);
                }
                continue;
            };
            if let Some((value, found)) = self.passed(&state, tried) {
                row = found;
                let is_same = found.is_some() && value != -1.0;
                let value = value + PASSED;
                high = (tried, is_same.then_some(value));
                behind = Some(state);
                if side == 1 {
                    low.1 = low.1.map(|value| 0.5 * value);
                }
                side = 1;
                if is_same && value > -1e-3 * PASSED {
                    break;
                }
            } else {
                let value = self.least(&state).0;
                low = (tried, (value > PASSED).then_some(value + PASSED));
                if side == -1 {
                    high.1 = high.1.map(|value| 0.5 * value);
                }
                side = -1;
            }
            if high.0 - low.0 < 1e-15 + 4e-16 * self.now.t {
                break;
            }
        }
        let state = match behind {
            Some(state) => state,
            None => self.moved(high.0).ok_or(Stop::Lost)?,
        };
        self.now = state;
        self.refine(row);
        Ok(row)
    }

    /// Newton's method to where the margin is zero, since it is found a little beyond.
    fn refine(&mut self, row: Option<usize>) {
        let Some(row) = row else { return };
        for _ in 0..3 {
            let problem = self.problem(&self.now);
            let seen = &problem.rows[row];
            let (value, rate) = match self.held.modes[row] {
                Mode::Open => (seen.value, seen.rate),
                mode if mode.sign() != 0.0 => {
                    let found = problem.forces(&self.held.modes, &self.held.lambda);
                    let Some((lambda, _)) = found else { return };
                    (seen.rate, problem.acceleration(row, &lambda).0)
                }
                _ => return,
            };
            let back = -value / rate;
            if !(back.abs() < 1e-7 && back != 0.0) {
                return;
            }
            let Some(state) = self.moved(back) else { return };
            self.now = state;
        }
    }
}

//! Events: impacts, and the next modes. A margin that is zero is decided by a short step along each candidate.

use super::choose::{Allowed, Choice, choices, is_same, margin};
use super::extrapolation::step;
use super::impact::{Impulses, poisson};
use super::linear::solve_one;
use super::problem::{Mode, Problem};
use super::run::{Event, FLAT, Held, Run, Runner, State, Stop};
use super::world::{Law, Pose, World};

/// Width below which a gap is closed, m or rad: five times its rounding.
const CLOSED: f64 = 5.0 * FLAT;
/// A flight below this height is none, m or rad.
const LOWEST: f64 = 1e-13;
/// A slip below this is none, m/s or rad/s.
const NO_SLIP: f64 = 1e-9;
/// So long is the step that decides, s.
const AHEAD: f64 = 1e-6;

impl<'w> Runner<'w> {
    pub fn new(world: &'w World, start: State, longest: f64) -> Self {
        let n = world.rows.len();
        let held = Held {
            modes: vec![Mode::Open; n],
            carried: vec![false; n],
            places: vec![0.0; n],
            determinant: 1.0,
            lines: vec![1.0; n],
            lambda: vec![1.0; n],
        };
        Self { world, longest, closed: CLOSED, now: start, held, run: Run::default() }
    }

    /// Widens the gaps that are closed by a factor.
    pub fn merging(self, factor: f64) -> Self {
        Self { closed: factor * self.closed, ..self }
    }

    /// Impacts, and the modes from now on. `due` is the row whose margin is passed.
    pub fn event(&mut self, due: Option<usize>) -> Result<(), Stop> {
        let before = self.now.v.clone();
        // After impacts rates are rounding of those before.
        let rows = self.problem(&self.now).rows;
        let none = 1e-12 * rows.iter().fold(0.0, |fast: f64, row| fast.max(row.rate.abs()));
        let (problem, best) = match self.next((due, none), false)? {
            // It would sink in, however slowly.
            (problem, best) if self.sinks(&problem, &best, (due, none)) => self.next((due, none), true)?,
            next => next,
        };
        self.hold(&problem, best)?;
        let jump = before.iter().zip(&self.now.v).fold(0.0, |jump: f64, (a, b)| jump.max((a - b).abs()));
        self.run.events.push(Event { t: self.now.t, modes: self.held.modes.clone(), jump });
        Ok(())
    }

    /// Impacts, then the choice among the modes. A row that approaches so slowly that it rests has no impact, unless `all` have.
    fn next(&mut self, (due, none): (Option<usize>, f64), all: bool) -> Result<(Problem, Choice), Stop> {
        self.impacts(due, none, all)?;
        let problem = self.problem(&self.now);
        let allowed: Vec<Allowed> =
            (0..problem.count()).map(|i| self.allowed(&problem, i, (due, none))).collect();
        let mut guess = self.held.lambda.clone();
        if guess.iter().all(|x| *x == 0.0) {
            guess.fill(1.0);
        }
        let found = choices(&problem, &allowed, &guess).ok_or(Stop::Lost)?;
        let found: Vec<Choice> =
            found.into_iter().filter(|choice| self.goes_on(&problem, &allowed, choice)).collect();
        let best = found
            .iter()
            .reduce(|a, b| if (b.moving, -b.slack) < (a.moving, -a.slack) { b } else { a })
            .ok_or(Stop::Nothing)?
            .clone();
        // Where more is held at rest than in motion, rest is what goes on.
        let is_stepped =
            problem.laws.iter().any(|law| matches!(law, Law::Rub(bound) if bound.adhesion != 1.0));
        if !is_stepped && found.iter().any(|other| !is_same(&problem, &best, other)) {
            return Err(Stop::Ambiguous);
        }
        Ok((problem, best))
    }

    /// Does a row open that approaches?
    fn sinks(&self, problem: &Problem, choice: &Choice, (due, none): (Option<usize>, f64)) -> bool {
        (0..problem.count()).any(|i| {
            let opens = choice.modes[i] == Mode::Open && !choice.carried[i];
            opens && self.touches(problem, i, due) && problem.rows[i].rate < -none
        })
    }

    fn hold(&mut self, problem: &Problem, best: Choice) -> Result<(), Stop> {
        for i in 0..problem.count() {
            if !(self.held.modes[i] == Mode::Sticks && best.modes[i] == Mode::Sticks) {
                self.held.places[i] = if best.modes[i] == Mode::Sticks { problem.rows[i].value } else { 0.0 };
            }
        }
        let (lambda, determinant) = problem.forces(&best.modes, &best.lambda).ok_or(Stop::Lost)?;
        self.held.determinant = determinant.signum() / determinant.abs();
        let lines = (0..problem.count()).map(|i| problem.line(i, &lambda));
        self.held.lines = lines.map(|line| line.map_or(1.0, f64::signum)).collect();
        // One that is zero goes the way that a short step goes.
        (self.held.modes, self.held.carried, self.held.lambda) = (best.modes, best.carried, lambda);
        // What is left of the rates of rows that hold is that of flights which are not followed; their impulses have been taken off with
        // their share of friction, so that they are positive in the problem of the opposite rates.
        let mut left = problem.of_rates();
        left.c.iter_mut().for_each(|rate| *rate = -*rate);
        if let Some((impulses, _)) = left.forces(&self.held.modes, &self.held.lambda) {
            let taken: Vec<f64> = impulses.iter().map(|impulse| -impulse).collect();
            problem.push(&taken, &mut self.now.v);
        }
        self.project()?;
        if let Some(ahead) = self.ahead(&self.held.modes, &self.held.lambda) {
            let later = self.problem(&ahead);
            if let Some((lambda, _)) = later.forces(&self.held.modes, &self.held.lambda) {
                for i in 0..later.count() {
                    self.held.lines[i] = later.line(i, &lambda).map_or(1.0, f64::signum);
                }
            }
        }
        Ok(())
    }

    /// The state after a short step in these modes.
    fn ahead(&self, modes: &[Mode], lambda: &[f64]) -> Option<State> {
        step(&self.now, AHEAD, &|state| {
            let problem = self.problem(state);
            let (lambda, _) = problem.forces(modes, lambda)?;
            Some(problem.accelerations(&lambda))
        })
    }

    /// Do margins that are zero not fall along the choice?
    fn goes_on(&self, problem: &Problem, allowed: &[Allowed], choice: &Choice) -> bool {
        if choice.marginal.is_empty() {
            return true;
        }
        let Some(state) = self.ahead(&choice.modes, &choice.lambda) else { return false };
        let later = self.problem(&state);
        let Some((lambda, _)) = later.forces(&choice.modes, &choice.lambda) else { return false };
        choice.marginal.iter().all(|i| {
            let (mode, rests) = (choice.modes[*i], allowed[*i].rests);
            let [now, then] = [(problem, &choice.lambda), (&later, &lambda)]
                .map(|(problem, lambda)| margin(problem, *i, mode, rests, lambda));
            let (Some((now, size)), Some((then, _))) = (now, then) else { return true };
            then - now >= -1e-12 * size
        })
    }

    fn touches(&self, problem: &Problem, i: usize, due: Option<usize>) -> bool {
        let was_closed = self.held.modes[i] == Mode::Closed || self.held.carried[i];
        match problem.laws[i] {
            Law::Gap { .. } => was_closed || due == Some(i) || problem.rows[i].value < self.closed,
            Law::Rub(_) => false,
        }
    }

    /// Impacts until no row approaches faster than it may to rest, or until none at all does; a rate of `none` is rounding.
    fn impacts(&mut self, due: Option<usize>, none: f64, all: bool) -> Result<(), Stop> {
        for _ in 0..30 {
            let problem = self.problem(&self.now);
            let touches: Vec<bool> = (0..problem.count()).map(|i| self.touches(&problem, i, due)).collect();
            let slow = |i: usize| if all { none } else { self.resting(&problem, i).max(none) };
            let approaches = |i: usize| touches[i] && problem.rows[i].rate < -slow(i);
            if !(0..problem.count()).any(approaches) {
                return Ok(());
            }
            self.run.impacts += 1;
            match poisson(&problem, &touches) {
                Impulses::Found(impulses) => problem.push(&impulses, &mut self.now.v),
                Impulses::Ambiguous => return Err(Stop::Ambiguous),
                Impulses::Undetermined => return Err(Stop::Undetermined),
                Impulses::Nothing => return Err(Stop::Nothing),
            }
        }
        Err(Stop::Endless)
    }

    /// Slower than this a row rests. What pulls it back is of the size of the terms of its acceleration: that of a block on a block, which
    /// would fall together, is their sum and may be zero.
    fn resting(&self, problem: &Problem, i: usize) -> f64 {
        (2.0 * problem.acceleration(i, &self.held.lambda).1 * LOWEST).sqrt()
    }

    fn allowed(&self, problem: &Problem, i: usize, (due, none): (Option<usize>, f64)) -> Allowed {
        let rate = problem.rows[i].rate;
        match problem.laws[i] {
            Law::Gap { .. } => {
                let rests = self.touches(problem, i, due) && rate <= self.resting(problem, i).max(none);
                let modes = if rests { vec![Mode::Closed, Mode::Open] } else { vec![Mode::Open] };
                Allowed { modes, rests }
            }
            Law::Rub(_) if rate > NO_SLIP => Allowed { modes: vec![Mode::Forwards], rests: false },
            Law::Rub(_) if rate < -NO_SLIP => Allowed { modes: vec![Mode::Backwards], rests: false },
            Law::Rub(_) => {
                Allowed { modes: vec![Mode::Sticks, Mode::Forwards, Mode::Backwards], rests: true }
            }
        }
    }

    /// Leads joints and rows that hold back to their places, and takes their rates out of the velocities.
    pub fn project(&mut self) -> Result<(), Stop> {
        for _ in 0..3 {
            let (matrix, away, _) = self.constraints();
            if away.iter().fold(0.0, |size: f64, z| size.max(z.abs())) < 1e-15 {
                break;
            }
            let moved = lead(&self.world.inertia, &matrix, &away).ok_or(Stop::Lost)?;
            self.now.q.iter_mut().zip(moved).for_each(|(q, moved)| *q -= moved);
        }
        let (matrix, _, rates) = self.constraints();
        let moved = lead(&self.world.inertia, &matrix, &rates).ok_or(Stop::Lost)?;
        self.now.v.iter_mut().zip(moved).for_each(|(v, moved)| *v -= moved);
        Ok(())
    }

    /// Jacobian of joints and of rows that hold, how far they are from their places, their rates.
    fn constraints(&self) -> (Vec<Vec<f64>>, Vec<f64>, Vec<f64>) {
        let (mut matrix, mut away, mut rates) = (Vec::new(), Vec::new(), Vec::new());
        let pose = Pose::new(self.now.t, &self.now.q, &self.now.v);
        let held = (0..self.world.rows.len()).filter(|i| self.held.modes[*i].holds());
        let held = held.map(|i| (&self.world.rows[i].0, self.held.places[i]));
        for (place, aim) in self.world.joints.iter().map(|place| (place, 0.0)).chain(held) {
            let seen = place.see(&pose);
            let mut row = vec![0.0; self.now.q.len()];
            seen.slopes.iter().for_each(|(k, slope)| row[*k] += slope);
            matrix.push(row);
            away.push(seen.value - aim);
            rates.push(seen.rate);
        }
        (matrix, away, rates)
    }
}

/// The least motion, by kinetic energy, that gives the rows what is asked.
fn lead(inertia: &[f64], matrix: &[Vec<f64>], asked: &[f64]) -> Option<Vec<f64>> {
    if matrix.is_empty() {
        return Some(vec![0.0; inertia.len()]);
    }
    let product = |a: &[f64], b: &[f64]| -> f64 { (0..a.len()).map(|k| a[k] * b[k] / inertia[k]).sum() };
    let d = matrix.iter().map(|a| matrix.iter().map(|b| product(a, b)).collect()).collect();
    let (lambda, _) = solve_one(d, asked)?;
    Some(
        (0..inertia.len())
            .map(|k| {
                matrix.iter().zip(&lambda).map(|(row, lambda)| row[k] * lambda).sum::<f64>() / inertia[k]
            })
            .collect(),
    )
}

//! A mechanism that is run from outside, by number: parameters are turned, bodies are pulled while it moves, starts are set by
//! hand. A page holds it as WebAssembly; what it computes is what every other run computes, to the bit.

use std::borrow::ToOwned;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use plm_runtime::described::by_number::{self, SizeNames};
use plm_runtime::described::pulls::{WithPulls, pull_input};
use plm_runtime::{Cause, Described, Fault, Mechanism, Moment, Sim, Start, StartValues, Statics};

/// The error for which a live run stands still.
#[derive(Clone, Debug, PartialEq)]
pub struct Error {
    /// The time, s.
    pub time: f64,
    /// The part that is to blame; empty where no single one is.
    pub part: String,
    /// By how much it stays open where all others are closed, m or rad; not a number where nothing is open.
    pub gap: f64,
    /// The cause in words.
    pub text: String,
}

/// A mechanism with a run of it, if it could be started.
///
/// The run has the parameters with which it got where it is. Others act with the next step, from there; where they cannot, no
/// step is made, and the run stays as it is.
pub struct Live<M: Mechanism> {
    declared: M,
    mechanism: M,
    sim: Option<Sim<M>>,
    error: Option<Error>,
    numbers: Vec<f64>,
    shape: Vec<f64>,
}

/// A declaration to which an input of force and torque at the centre of gravity of each body is added, three for each:
/// `plm_pull_0_x`, `plm_pull_0_y` (N), `plm_pull_0_turn` (N*m). Where they are zero, what moves is the same but for rounding.
pub fn with_pulls(declaration: &str, bodies: &[&str]) -> String {
    WithPulls { declaration, bodies }.to_string()
}

impl<M: Described<S = f64> + Statics> Live<M> {
    /// Assembles it and stands at the start.
    pub fn new(mechanism: M) -> Self {
        let mut live = Self {
            declared: mechanism,
            mechanism,
            sim: None,
            error: None,
            numbers: Vec::new(),
            shape: Vec::new(),
        };
        live.restart();
        live
    }

    /// Begins again with the parameters and starts as they are set; whether it could be assembled.
    pub fn restart(&mut self) -> bool {
        let inputs = self.inputs();
        let started = self.mechanism.start();
        let sim = self.keep(started);
        self.sim = sim.map(|mut sim| {
            for (index, value) in inputs.into_iter().enumerate() {
                by_number::set_input(&mut sim, index, value);
            }
            sim
        });
        self.sim.is_some()
    }

    /// Goes on by `dt`, s; false where it cannot, and then it stays where it is.
    pub fn step(&mut self, dt: f64) -> bool {
        let Some(before) = self.sim else { return false };
        let mut sim = before;
        let outcome = if self.is_turned(&before) {
            by_number::set_parameters(&mut sim, &self.mechanism);
            match sim.step(dt) {
                Ok(()) => Ok(()),
                Err(_) => self.assembled_from(&before).and_then(|assembled| {
                    sim = assembled;
                    sim.step(dt)
                }),
            }
        } else {
            sim.step(dt)
        };
        let is_made = self.keep(outcome).is_some();
        // What a step that failed has left is kept only where the same parameters go on from it.
        if is_made || !self.is_turned(&before) {
            self.sim = Some(sim);
        }
        is_made
    }

    /// Are parameters others than those of a run?
    fn is_turned(&self, sim: &Sim<M>) -> bool {
        let run = sim.state().mechanism();
        by_number::parameters(&self.mechanism).enumerate().any(|(k, value)| run.parameter(k) != Some(value))
    }

    /// A run with the parameters as they are, assembled from where another one is: loops that are followed in closed form have no
    /// pose to begin with where their lengths do not reach.
    fn assembled_from(&self, sim: &Sim<M>) -> Result<Sim<M>, Fault> {
        let (state, mut mechanism) = (sim.state(), self.mechanism);
        *mechanism.starts_mut() = state.mechanism().starts_at(&M::full(state));
        mechanism.starts_mut().each(&mut |_, start| *start = Start::free(start.value));
        mechanism.check(state.time())?;
        let (held, x) = mechanism.start_with_inputs(state.time(), &state.held())?;
        let mut assembled = *sim;
        *assembled = Moment::new(self.mechanism, held, state.time(), x);
        Ok(assembled)
    }

    /// Why nothing moves, if something is wrong.
    pub fn error(&self) -> Option<&Error> {
        self.error.as_ref()
    }

    /// The time (s), the poses and velocities of the bodies (x, y, angle, vx, vy, omega), the ports of the ground (x, y, angle)
    /// in SI; then all observed quantities, outputs in their declared units and the others in SI. Where nothing was assembled, the
    /// start values as they are set.
    pub fn read(&mut self) -> &[f64] {
        self.numbers.clear();
        match &self.sim {
            Some(sim) => by_number::moment::<M>(sim.state(), &mut |number| self.numbers.push(number)),
            None => self.read_starts(),
        }
        &self.numbers
    }

    fn read_starts(&mut self) {
        let tables = self.mechanism.tables();
        let (bodies, ground) = (6 * tables.bodies.len(), 3 * tables.ground.len());
        let numbers = &mut self.numbers;
        numbers.push(0.0);
        self.mechanism.starts_mut().each(&mut |_, start| {
            if numbers.len() <= bodies {
                numbers.push(start.value);
            }
        });
        self.numbers.resize(1 + bodies + ground + self.mechanism.observables().len(), f64::NAN);
    }

    /// Numbers of a picture that parameters change, SI: of each body mass, moment of inertia, depth, place and angle of each port, the
    /// number of points of its contour, and these; of each port of the ground x, y and angle at time 0, and depth; the sizes of
    /// [`size_names`](Self::size_names), 0 where none was given; of each shape of a part, then of each hole of a body, the number of its
    /// points, and these.
    pub fn shape(&mut self) -> &[f64] {
        self.shape.clear();
        by_number::shape(&self.mechanism, &mut |number| self.shape.push(number));
        &self.shape
    }

    /// The parts that have sizes, a line each: the name of the part, and those of its sizes, with blanks between.
    pub fn size_names(&self) -> String {
        SizeNames::of(&self.mechanism).to_string()
    }

    /// The rows of contact, a line each: the mode, a tab, the name. Empty without rows, and where nothing was assembled.
    pub fn contacts(&self) -> String {
        let rows = self.sim.iter().flat_map(Sim::contacts);
        rows.map(|(name, mode)| format!("{mode}\t{name}")).collect::<Vec<String>>().join("\n")
    }

    /// The mechanism with its parameters as they are set; its [`tables`](Described::tables) name what is read and set here by number.
    pub fn mechanism(&self) -> &M {
        &self.mechanism
    }

    /// The number of a parameter by its name.
    pub fn parameter_named(&self, name: &str) -> Option<usize> {
        self.mechanism.tables().parameters.iter().position(|own| own.name == name)
    }

    /// The number of an input by its name.
    pub fn input_named(&self, name: &str) -> Option<usize> {
        self.mechanism.tables().inputs.iter().position(|own| own.name == name)
    }

    /// The number of a body by its name.
    pub fn body_named(&self, name: &str) -> Option<usize> {
        self.mechanism.tables().bodies.iter().position(|own| own.name == name)
    }

    /// A parameter, SI; not a number beyond the last.
    pub fn parameter(&self, index: usize) -> f64 {
        self.mechanism.parameter(index).unwrap_or(f64::NAN)
    }

    /// Sets a parameter, SI, and the starts that are made of it. The next step of a run goes on with it; whether it can be
    /// assembled so where it is, [`error`](Self::error) says at once.
    pub fn set_parameter(&mut self, index: usize, value: f64) {
        by_number::set_parameter(&mut self.mechanism, index, value);
        let Some(before) = self.sim else { return };
        let mut sim = before;
        by_number::set_parameters(&mut sim, &self.mechanism);
        let can_go_on = if self.is_turned(&before) {
            sim.project().or_else(|_| self.assembled_from(&before).map(|_| ()))
        } else {
            Ok(())
        };
        self.keep(can_go_on);
    }

    /// An input, SI; not a number beyond the last, and where nothing was assembled.
    pub fn input(&self, index: usize) -> f64 {
        let sim = self.sim.as_ref();
        sim.and_then(|sim| by_number::input::<M>(sim.state(), index)).unwrap_or(f64::NAN)
    }

    /// Sets an input, SI.
    pub fn set_input(&mut self, index: usize, value: f64) {
        if let Some(sim) = &mut self.sim {
            by_number::set_input(sim, index, value);
        }
    }

    /// Pulls a body at a point (m, absolute axes) by a force (N, absolute axes); the force stays until it is changed. Needs the
    /// inputs of [`with_pulls`].
    pub fn pull(&mut self, body: usize, [x, y]: [f64; 2], [fx, fy]: [f64; 2]) {
        let Some(pose) = self.sim.as_ref().and_then(|sim| M::pose(sim.state(), body)) else { return };
        let turn = (x - pose.x) * fy - (y - pose.y) * fx;
        for (suffix, value) in [("x", fx), ("y", fy), ("turn", turn)] {
            if let Some(index) = pull_input(&self.mechanism, body, suffix) {
                self.set_input(index, value);
            }
        }
    }

    /// Begins again with a body near a pose of its centre of gravity (m, m, rad), all others near where they are, at rest, and
    /// the joints closed by the shortest way. Where they do not close nothing changes, and [`error`](Self::error) says
    /// which stays open.
    pub fn place(&mut self, body: usize, [x, y, angle]: [f64; 3]) -> bool {
        let before = self.mechanism;
        let Some(sim) = &self.sim else { return false };
        let (state, now) = (sim.state(), M::pose(sim.state(), body));
        let Some(now) = now else { return false };
        let starts = state.mechanism().starts_at(&M::full(state));
        *self.mechanism.starts_mut() = starts;
        let (first, last, mut index, mut origin) =
            (6 * body, 6 * self.mechanism.tables().bodies.len(), 0, [0.0; 3]);
        let turned = BodyTurn::of(now.angle, angle);
        self.mechanism.starts_mut().each(&mut |_, start| {
            if index >= first && index < first + 3 {
                origin[index - first] = start.value;
            }
            if index < last {
                *start = Start::free(if index % 6 < 3 { start.value } else { 0.0 });
            }
            index += 1;
        });
        let [ox, oy] = turned.apply([origin[0] - now.x, origin[1] - now.y]);
        let wanted = [x + ox, y + oy, origin[2] + angle - now.angle];
        let mut index = 0_usize;
        self.mechanism.starts_mut().each(&mut |_, start| {
            if let Some(value) = wanted.get(index.wrapping_sub(first)) {
                start.value = *value;
            }
            index += 1;
        });
        let sim = self.sim;
        let placed = self.restart();
        if !placed {
            (self.mechanism, self.sim) = (before, sim);
        }
        placed
    }

    /// Begins again as declared.
    pub fn reset(&mut self) -> bool {
        self.mechanism = self.declared;
        self.sim = None;
        self.restart()
    }

    fn inputs(&self) -> Vec<f64> {
        let count = self.mechanism.input_names().len();
        if self.sim.is_none() { Vec::new() } else { (0..count).map(|k| self.input(k)).collect() }
    }

    /// Keeps the result, or the error.
    fn keep<T>(&mut self, outcome: Result<T, Fault>) -> Option<T> {
        match outcome {
            Ok(value) => {
                self.error = None;
                Some(value)
            }
            Err(fault) => {
                let gap = if let Cause::Open { gap } = fault.cause { gap } else { f64::NAN };
                let (time, part, text) = (fault.time, fault.part.to_owned(), fault.cause.to_string());
                self.error = Some(Error { time, part, gap, text });
                None
            }
        }
    }
}

/// A turn from one angle to another.
struct BodyTurn {
    sin: f64,
    cos: f64,
}

impl BodyTurn {
    fn of(from: f64, to: f64) -> Self {
        let (sin, cos) = (to - from).sin_cos();
        Self { sin, cos }
    }

    fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.cos * x - self.sin * y, self.sin * x + self.cos * y]
    }
}

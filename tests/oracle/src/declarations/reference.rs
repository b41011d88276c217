//! A declaration with the motion that all its runs are beside: by `Dop853` at 1e-12.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use plm_dynamic::{Error, Integrator, Mechanism, Run};
use plm_runtime::Fault;

/// How far a motion is followed, s. It is no round number, at which declarations switch.
const UNTIL: f64 = 0.97;
/// Intervals of the reference.
const INTERVALS: u32 = 40;
/// Steps of the reference, after which it is followed no further: every other method would take more.
const STEPS: u64 = 600;
/// Times that are compared.
pub(super) const TIMES: usize = 4;
/// The tolerance of the reference, and others that say how much an error grows.
const FINEST: f64 = 1e-12;
const OTHERS: [f64; 3] = [1e-5, 1e-7, 1e-9];

/// A declaration of the repository.
pub(crate) struct Scene {
    file: PathBuf,
    pub(crate) place: String,
    /// As it is written, and in absolute coordinates where it asks for no formulation.
    pub(crate) texts: Vec<String>,
    machines: [OnceLock<Result<Mechanism, Error>>; 2],
    reference: OnceLock<Result<Reference, Error>>,
}

/// Motion of the reference at some times, with figures that bound the errors of other runs.
pub(super) struct Reference {
    /// Until when it is compared, s.
    pub(super) end: f64,
    /// Why it went no further, if it stopped.
    pub(super) stop: Option<Fault>,
    /// Numbers at the times that are compared.
    pub(super) at: Vec<Vec<f64>>,
    /// Sizes of the numbers: the largest of their kind in the motion, 1 at least.
    pub(super) scales: Vec<f64>,
    /// How many of the numbers are declared outputs.
    outputs: usize,
    /// By as many times the tolerance runs of other tolerances are off at most, 1 at least.
    pub(super) growth: f64,
    /// The fastest change of a number, of its size in a second.
    pub(super) rate: f64,
    /// The longest mean length of steps of the other tolerances, s: what is longer does not follow the motion.
    pub(super) step: f64,
    /// Does anything switch, touch or slip?
    pub(super) has_events: bool,
}

/// Which numbers are compared.
#[derive(Clone, Copy)]
pub(super) enum What {
    All,
    /// Poses of bodies alone: steps without events spread an impact over some, and have no forces at a time.
    Poses,
}

impl Scene {
    pub(super) fn new(file: &Path, place: String, text: String, twin: Option<String>) -> Self {
        let texts = [Some(text), twin].into_iter().flatten().collect();
        Self { file: file.to_owned(), place, texts, machines: Default::default(), reference: OnceLock::new() }
    }

    /// The mechanism in one of its formulations.
    pub(crate) fn machine(&self, formulation: usize) -> Result<&Mechanism, Error> {
        let name = self.file.display().to_string();
        let compiled = || Mechanism::from_named_text(&name, &self.texts[formulation]);
        self.machines[formulation].get_or_init(compiled).as_ref().map_err(Clone::clone)
    }

    /// The motion.
    pub(super) fn reference(&self) -> Result<&Reference, Error> {
        let made = || Reference::of(self.machine(0)?);
        self.reference.get_or_init(made).as_ref().map_err(Clone::clone)
    }
}

impl Reference {
    fn of(machine: &Mechanism) -> Result<Self, Error> {
        let mut run = machine.start_with(Integrator::Dop853(FINEST))?;
        let mut rows = vec![numbers(&run)];
        let mut stop = None;
        for k in 1..=INTERVALS {
            match run.step_to(UNTIL * f64::from(k) / f64::from(INTERVALS)) {
                Ok(()) => rows.push(numbers(&run)),
                Err(Error::Fault(fault)) => {
                    stop = Some(fault);
                    break;
                }
                Err(error) => return Err(error),
            }
            if run.stats().steps + run.stats().rejected > STEPS {
                break;
            }
        }
        let step = UNTIL / f64::from(INTERVALS);
        // Near its end a motion that stops is hardly told from others.
        let until = stop.map_or(f64::INFINITY, |fault| 0.9 * fault.time);
        let quarter = ((rows.len() - 1).min((until / step) as usize)) / TIMES;
        let end = step * (quarter * TIMES) as f64;
        let scales = scales(&run, &rows);
        let rates = rows.windows(2).map(|pair| off(&pair[1], &pair[0], &scales) / step);
        let rate = rates.fold(0.0, f64::max);
        let contacts = run.contact_stats();
        let events =
            [contacts.impacts, contacts.closures, contacts.openings, contacts.sticks, contacts.slips];
        let has_events = run.stats().switches + events.iter().sum::<u64>() > 0;
        let at = (1..=TIMES).map(|k| rows[k * quarter].clone()).collect();
        let outputs = run.columns().count();
        let mut own = Self { end, stop, at, scales, outputs, growth: 1.0, rate, step: end, has_events };
        let mut longest = 0.0_f64;
        for tolerance in OTHERS {
            // A run that stops is another case.
            if let Ok((at, steps)) = motion(machine, Integrator::Dop853(tolerance), end) {
                longest = longest.max(end / steps.max(1) as f64);
                own.growth = own.growth.max(own.apart(&at, &own.at, What::All) / tolerance);
            }
        }
        if longest > 0.0 {
            own.step = longest;
        }
        Ok(own)
    }

    /// How far two motions are apart, of the sizes of the numbers; of one that is compared at its end alone there.
    pub(super) fn apart(&self, a: &[Vec<f64>], b: &[Vec<f64>], what: What) -> f64 {
        let is_compared = |k: usize| match what {
            What::All => true,
            What::Poses => k >= self.outputs && (k - self.outputs) % 6 < 3,
        };
        let size = |(k, scale): (usize, &f64)| if is_compared(k) { *scale } else { f64::INFINITY };
        let scales: Vec<f64> = self.scales.iter().enumerate().map(size).collect();
        let pairs = a.iter().rev().zip(b.iter().rev());
        pairs.map(|(a, b)| off(a, b, &scales)).fold(0.0, worst)
    }

    /// The time of a comparison, s.
    pub(super) fn time(&self, number: usize) -> f64 {
        self.end * (number + 1) as f64 / TIMES as f64
    }

    /// The time at which the whole run ends, s.
    pub(super) fn last(&self) -> f64 {
        if self.stop.is_some() { UNTIL } else { self.end }
    }
}

/// The greater of two, of which one that is no number is greatest.
fn worst(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}

/// The greatest difference of two rows of numbers, in sizes; numbers that are none in both agree.
fn off(a: &[f64], b: &[f64], scales: &[f64]) -> f64 {
    let pairs = a.iter().zip(b).zip(scales);
    pairs
        .filter(|((a, b), scale)| scale.is_finite() && !(a.is_nan() && b.is_nan()))
        .map(|((a, b), scale)| (a - b).abs() / scale)
        .fold(0.0, worst)
}

/// Numbers at the times that are compared, by the reference's method, and how many steps they take.
fn motion(machine: &Mechanism, method: Integrator, end: f64) -> Result<(Vec<Vec<f64>>, u64), Error> {
    let mut run = machine.start_with(method)?;
    let mut at = Vec::new();
    for k in 1..=TIMES {
        if end > 0.0 {
            run.step_to(end * k as f64 / TIMES as f64)?;
        }
        at.push(numbers(&run));
    }
    Ok((at, run.stats().steps + run.stats().rejected))
}

/// The declared outputs, then poses and velocities of all bodies.
pub(super) fn numbers(run: &Run) -> Vec<f64> {
    let bodies = run.bodies().filter_map(|name| run.body(name).ok());
    let states = bodies.flat_map(|body| [body.x, body.y, body.angle, body.vx, body.vy, body.omega]);
    run.row().into_iter().chain(states).collect()
}

/// Names of the numbers.
pub(super) fn names(run: &Run) -> Vec<String> {
    let states = ["x", "y", "angle", "vx", "vy", "omega"];
    let bodies = run.bodies().flat_map(|body| states.map(|state| format!("{body}.{state}")));
    run.columns().map(|(name, _)| name.to_owned()).chain(bodies).collect()
}

/// The size of each number: the largest one of its unit.
fn scales(run: &Run, rows: &[Vec<f64>]) -> Vec<f64> {
    let own: Vec<&str> = run.columns().map(|(_, unit)| unit).collect();
    let states = ["m", "m", "rad", "m/s", "m/s", "rad/s"];
    let units: Vec<&str> = own.into_iter().chain(run.bodies().flat_map(|_| states)).collect();
    let largest =
        |k: usize| rows.iter().filter_map(|row| row.get(k)).fold(1.0, |most: f64, x| most.max(x.abs()));
    let sizes: Vec<f64> = (0..units.len()).map(largest).collect();
    let of = |unit: &str| {
        let alike = units.iter().zip(&sizes).filter(|(own, _)| **own == unit);
        alike.fold(1.0, |most: f64, (_, size)| most.max(*size))
    };
    units.iter().map(|unit| of(unit)).collect()
}

//! A case run by `plm`.

use plm_oracle::Look;
use plm_runtime::contact::{Counts, Mode};
use plm_runtime::{Dop853, Fault, Moment, MoreauJean, Rk4, Seen, Sim, Start};

/// How the interval is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// `step_to` each sample.
    Samples,
    /// `watch` with samples, which shows events.
    Watched,
    /// `step` of a millisecond.
    Milli,
    /// `step_to` the end.
    Whole,
    /// `step_to` each sample, from a moment that was saved before the run went on.
    Saved,
}

impl Pace {
    pub const ALL: [Self; 5] = [Self::Watched, Self::Samples, Self::Milli, Self::Whole, Self::Saved];
}

/// Order of a run: numbers, starts, samples and method.
pub struct Order<'c> {
    pub numbers: &'c [f64],
    pub starts: &'c [Start<f64>],
    /// The distance of samples, s, a whole number of milliseconds, and how many.
    pub every: f64,
    pub samples: usize,
    pub method: Method,
}

/// A method, and how exact it is.
#[derive(Clone, Copy, Debug)]
pub enum Method {
    /// From event to event, with this tolerance.
    Events { pace: Pace, tolerance: f64 },
    /// With steps of this length, s.
    Steps { fixed: Fixed, length: f64 },
}

/// A method of fixed steps.
#[derive(Clone, Copy, Debug)]
pub enum Fixed {
    MoreauJean,
    Rk4,
}

impl Fixed {
    pub const ALL: [Self; 2] = [Self::MoreauJean, Self::Rk4];

    pub const fn name(self) -> &'static str {
        match self {
            Self::MoreauJean => "MoreauJean",
            Self::Rk4 => "Rk4",
        }
    }
}

/// A sample.
#[derive(Clone, Debug)]
pub struct Sample {
    /// Its number; the first one after the start has 1.
    pub index: usize,
    /// x, y, angle, then vx, vy, omega of each body.
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub energies: [f64; 2],
}

/// Outcome of a run.
#[derive(Debug, Default)]
pub struct Outcome {
    pub samples: Vec<Sample>,
    /// Times of events, s.
    pub events: Vec<f64>,
    pub fault: Option<Fault>,
    pub counts: Counts,
    pub modes: Vec<(&'static str, Mode)>,
    pub steps: u64,
    pub ends: f64,
}

/// No motion of the sweep needs more steps.
const MOST_STEPS: u64 = 50_000;

/// Runs a mechanism that has the numbers of a case.
pub fn run<M: Look<S = f64>>(built: M, order: &Order) -> Outcome {
    match order.method {
        Method::Events { pace, tolerance } => {
            let method = Dop853::new(tolerance).with_most_steps(MOST_STEPS);
            outcome(built.start_with(method), |sim, outcome| at_pace(order, pace, sim, outcome))
        }
        Method::Steps { fixed: Fixed::MoreauJean, length } => {
            by_steps(built.start_with(MoreauJean::new(length)), order)
        }
        Method::Steps { fixed: Fixed::Rk4, length } => by_steps(built.start_with(Rk4::new(length)), order),
    }
}

fn by_steps<M: Look<S = f64>, I: plm_runtime::Method<M>>(
    started: Result<Sim<M, I>, Fault>,
    order: &Order,
) -> Outcome {
    outcome(started, |sim, outcome| {
        each_sample(order, outcome, |index| {
            sim.step_to(order.every * index as f64)?;
            Ok(look::<M>(index, sim.state()))
        })
    })
}

/// Outcome of a run that `run` makes; of a failed start its fault.
fn outcome<M: Look<S = f64>, I: plm_runtime::Method<M>>(
    started: Result<Sim<M, I>, Fault>,
    run: impl FnOnce(&mut Sim<M, I>, &mut Outcome) -> Result<(), Fault>,
) -> Outcome {
    let mut outcome = Outcome::default();
    let mut sim = match started {
        Ok(sim) => sim,
        Err(fault) => {
            outcome.fault = Some(fault);
            return outcome;
        }
    };
    outcome.samples.push(look::<M>(0, sim.state()));
    outcome.fault = run(&mut sim, &mut outcome).err();
    outcome.counts = sim.contact_stats();
    outcome.modes = sim.contacts().collect();
    outcome.steps = sim.stats().steps;
    outcome.ends = sim.time();
    outcome
}

/// Keeps the samples that `sample` gives by their number.
fn each_sample(
    order: &Order,
    outcome: &mut Outcome,
    mut sample: impl FnMut(usize) -> Result<Sample, Fault>,
) -> Result<(), Fault> {
    (1..=order.samples).try_for_each(|index| {
        outcome.samples.push(sample(index)?);
        Ok(())
    })
}

fn at_pace<M: Look<S = f64>>(
    order: &Order,
    pace: Pace,
    sim: &mut Sim<M, Dop853<M>>,
    outcome: &mut Outcome,
) -> Result<(), Fault> {
    let until = order.every * order.samples as f64;
    match pace {
        Pace::Watched => {
            let mut index = 0;
            let Outcome { samples, events, .. } = outcome;
            Sim::watch(sim, until, order.every, |seen| match seen {
                Seen::Sample(state) => {
                    if index > 0 {
                        samples.push(look::<M>(index, state));
                    }
                    index += 1;
                }
                Seen::Switched(state) => events.push(state.time()),
                _ => {}
            })
        }
        Pace::Whole => {
            sim.step_to(until)?;
            outcome.samples.push(look::<M>(order.samples, sim.state()));
            Ok(())
        }
        Pace::Samples | Pace::Saved => each_sample(order, outcome, |index| {
            let time = order.every * index as f64;
            if pace == Pace::Saved {
                let saved = sim.save();
                let _ = sim.step_to(time + order.every);
                sim.resume(&saved);
            }
            sim.step_to(time)?;
            Ok(look::<M>(index, sim.state()))
        }),
        Pace::Milli => {
            let calls = (order.every / 1e-3).round() as usize;
            each_sample(order, outcome, |index| {
                for _ in 0..calls {
                    sim.step(1e-3)?;
                }
                Ok(look::<M>(index, sim.state()))
            })
        }
    }
}

fn look<M: Look<S = f64>>(index: usize, state: &M::State) -> Sample {
    let (mut q, mut v) = (Vec::new(), Vec::new());
    M::bodies(state, |body| {
        q.extend([body.x, body.y, body.angle]);
        v.extend([body.vx, body.vy, body.omega]);
    });
    Sample { index, q, v, energies: M::energies(state) }
}

//! A case run by `plm`.

use plm_oracle::Look;
use plm_runtime::method::{Gauss, RadauIia5, Ros34Pw2};
use plm_runtime::{
    BodyMotion, Dop853, Dopri5, Fault, Linear, Method, Moment, Rk4, Scalar, Sim, Start, Vern9,
};

/// Which method; a step is a fraction of the usual one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    Dop853,
    Vern9,
    Dopri5,
    Rk4,
    Gauss,
    Radau,
    Ros34Pw2,
}

impl By {
    pub const ALL: [Self; 7] =
        [Self::Dop853, Self::Vern9, Self::Dopri5, Self::Rk4, Self::Gauss, Self::Radau, Self::Ros34Pw2];

    /// True if its steps have a fixed length, which decides how exact it is.
    pub fn fixed(self) -> bool {
        matches!(self, Self::Rk4 | Self::Gauss | Self::Ros34Pw2)
    }

    /// The order of one with fixed steps.
    pub fn order(self) -> i32 {
        match self {
            Self::Gauss => 6,
            Self::Ros34Pw2 => 3,
            _ => 4,
        }
    }

    /// That of its error control, by default; without one, the usual method's.
    pub fn tolerance(self) -> f64 {
        if matches!(self, Self::Dopri5 | Self::Radau) { 1e-8 } else { 1e-9 }
    }
}

/// How the interval is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// `step` of a millisecond.
    Milli,
    /// `step` of a tenth of a second.
    Tenth,
    /// One `step`.
    Whole,
    /// `run` with samples.
    Samples,
    /// `step` of an eightieth of a second, each from a moment that was saved before the run went on.
    Saved,
}

impl Pace {
    pub const ALL: [Self; 5] = [Self::Milli, Self::Tenth, Self::Whole, Self::Samples, Self::Saved];
}

/// Samples are so far apart, s.
pub const EVERY: f64 = 0.025;

/// Order of a run: numbers, starts, samples, method and pace.
pub struct Order<'c> {
    pub numbers: &'c [f64],
    pub starts: &'c [Start<f64>],
    /// Number of samples; the run ends with the last.
    pub samples: usize,
    pub by: By,
    pub pace: Pace,
    /// Steps of methods that have fixed ones are divided by this, tolerances of the others.
    pub finer: f64,
}

/// Poses, velocities and energies at a moment.
#[derive(Clone, Debug)]
pub struct Seen {
    /// Number of the sample.
    pub index: usize,
    /// x, y, angle, vx, vy, omega of each body.
    pub bodies: Vec<[f64; 6]>,
    pub energy: [f64; 2],
}

/// Outcome of a run.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    pub seen: Vec<Seen>,
    pub fault: Option<Fault>,
    pub steps: u64,
    /// Evaluations of the rates.
    pub evaluations: u64,
}

impl Outcome {
    /// Two outcomes with the same bits have the same fingerprint.
    pub fn fingerprint(&self) -> u64 {
        let samples = self.seen.iter().flat_map(|seen| seen.bodies.iter().flatten().chain(&seen.energy));
        let numbers = fold(self.steps, samples.map(|number| number.to_bits()));
        fold(numbers, self.fault.iter().flat_map(|fault| format!("{fault:?}").into_bytes()).map(u64::from))
    }
}

/// FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo) of words instead of bytes.
pub fn fold(start: u64, words: impl Iterator<Item = u64>) -> u64 {
    words.fold(start ^ 0xcbf2_9ce4_8422_2325, |hash, word| (hash ^ word).wrapping_mul(0x0100_0000_01b3))
}

/// No motion of the sweep needs more steps; one that does is ended as one that creeps.
const MOST_STEPS: u64 = 20_000;

/// With any method.
pub fn any<M: Look<S = f64> + Linear>(built: M, order: &Order) -> Outcome {
    let tolerance = order.by.tolerance() / order.finer;
    match order.by {
        By::Vern9 => with(built, order, Vern9::new(tolerance).with_most_steps(MOST_STEPS)),
        By::Dopri5 => with(built, order, Dopri5::new(tolerance).with_most_steps(MOST_STEPS)),
        By::Radau => with(built, order, RadauIia5::new(tolerance).with_most_steps(MOST_STEPS)),
        _ => fixed(built, order),
    }
}

/// With a method of fixed steps, otherwise as `start()` does.
pub fn fixed<M: Look + Linear>(built: M, order: &Order) -> Outcome {
    let short = M::S::lit(1e-3 / order.finer);
    match order.by {
        By::Rk4 => with(built, order, Rk4::new(short)),
        By::Gauss => with(built, order, Gauss::<M, 3>::new(short)),
        By::Ros34Pw2 => with(built, order, Ros34Pw2::new(short)),
        _ => usual(built, order),
    }
}

/// With the method that `start()` takes.
pub fn usual<M: Look>(built: M, order: &Order) -> Outcome {
    let method = if order.finer > 1.0 {
        Dop853::new(M::S::lit(By::Dop853.tolerance() / order.finer))
    } else {
        Dop853::default()
    };
    with(built, order, method.with_most_steps(MOST_STEPS))
}

fn with<M: Look, I: Method<M>>(built: M, order: &Order, method: I) -> Outcome {
    let mut outcome = Outcome::default();
    let mut sim = match built.start_with(method) {
        Ok(sim) => sim,
        Err(fault) => {
            outcome.fault = Some(fault);
            return outcome;
        }
    };
    outcome.seen.push(look::<M>(0, sim.state()));
    outcome.fault = pace(order, &mut sim, &mut outcome.seen).err();
    (outcome.steps, outcome.evaluations) = (sim.stats().steps, sim.stats().evaluations);
    outcome
}

fn pace<M: Look, I: Method<M>>(
    order: &Order,
    sim: &mut Sim<M, I>,
    seen: &mut Vec<Seen>,
) -> Result<(), Fault> {
    let lit = M::S::lit;
    let (length, calls) = match order.pace {
        Pace::Milli => (1e-3, 25),
        Pace::Tenth => (0.1, 1),
        Pace::Saved => (0.0125, 2),
        Pace::Whole => (EVERY * order.samples as f64, 1),
        Pace::Samples => {
            let mut index = 0;
            return sim.run(lit(EVERY * order.samples as f64), lit(EVERY), |state| {
                if index > 0 {
                    seen.push(look::<M>(index, state));
                }
                index += 1;
            });
        }
    };
    let stride = (length * f64::from(calls) / EVERY).round() as usize;
    for index in (stride..=order.samples).step_by(stride) {
        for _ in 0..calls {
            if order.pace == Pace::Saved {
                let saved = sim.save();
                let _ = sim.step(lit(3.0 * length));
                sim.resume(&saved);
            }
            sim.step(lit(length))?;
        }
        // Many short intervals need not end where their number says: the time is the mechanism's own.
        debug_assert!((sim.time().to_f64() - EVERY * index as f64).abs() < 1e-3);
        seen.push(look::<M>(index, sim.state()));
    }
    Ok(())
}

fn look<M: Look>(index: usize, state: &M::State) -> Seen {
    let mut bodies = Vec::new();
    M::bodies(state, |body| {
        let BodyMotion { x, y, angle, vx, vy, omega } = *body;
        bodies.push([x, y, angle, vx, vy, omega].map(Scalar::to_f64));
    });
    Seen { index, bodies, energy: M::energies(state).map(Scalar::to_f64) }
}

//! Time stepping as a second judge, of what the reference does not judge to its end.

use crate::judge::Case;
use crate::run::{Fixed, Method, Outcome};

/// Lengths of steps, s.
const STEPS: [f64; 2] = [2e-4, 1e-4];
/// Positions may be off by so many times what half the step changes, ...
const TIMES: f64 = 10.0;
/// ... and by this, of 1 and the number.
const ALLOWED: f64 = 1e-4;
/// Largest change by half the step, of 1 and the number, at which time stepping can judge.
const OPEN: f64 = 1e-2;

/// Verdict of time stepping on a run from event to event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stepping {
    Agrees,
    /// By how much, of 1 and the number, and what half the step changes.
    Differs([f64; 2]),
    /// Shorter steps go elsewhere themselves, or there is no end.
    Open,
}

impl Stepping {
    /// Of the run of a formulation.
    pub fn beside(case: &Case, formulation: usize, run: &Outcome) -> Self {
        let [long, short] =
            STEPS.map(|length| case.run(formulation, Method::Steps { fixed: Fixed::MoreauJean, length }));
        if long.fault.is_some() || short.fault.is_some() {
            return Self::Open;
        }
        let (halved, off) = (apart(&long, &short), apart(run, &short));
        // False for what is not a number.
        let is_known = halved <= OPEN;
        if !is_known {
            Self::Open
        } else if off <= ALLOWED + TIMES * halved {
            Self::Agrees
        } else {
            Self::Differs([off, halved])
        }
    }
}

/// The largest difference of positions at the samples that both have: velocities jump at slightly different times.
pub fn apart(one: &Outcome, other: &Outcome) -> f64 {
    let pairs = one.samples.iter().filter_map(|sample| {
        let same = other.samples.iter().find(|other| other.index == sample.index)?;
        Some(sample.q.iter().zip(&same.q))
    });
    pairs.flatten().fold(0.0, |most: f64, (a, b)| {
        let off = (a - b).abs() / (1.0 + b.abs());
        if off.is_nan() { f64::INFINITY } else { most.max(off) }
    })
}

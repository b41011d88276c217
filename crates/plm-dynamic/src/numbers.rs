//! All numbers of a run at one moment, by what they are: for whoever writes them down.

use plm_runtime::charts::OfLoops;
use plm_runtime::contact::Mode;
use plm_runtime::{Moment, Rate};

use crate::system::State;

/// The numbers of a run at one moment, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// The time, s.
    pub time: f64,
    /// Coordinates, their velocities, first-order states.
    pub x: Vec<f64>,
    /// The parameters.
    pub parameters: Vec<f64>,
    /// The inputs.
    pub inputs: Vec<f64>,
    /// Side of each condition: -1 where it holds, else 1.
    pub sides: Vec<f64>,
    /// Whole revolutions of the angles that are counted.
    pub turns: Vec<i32>,
    /// The chart of the loops, from 0; nothing of loops that are in none.
    pub chart: Option<usize>,
    /// Continuation data of the loops, in the order of storage.
    pub memory: Vec<f64>,
    /// The rows of contact, and the reactions that bound frictions, at the same places.
    pub contacts: Vec<RowNumbers>,
}

/// The numbers of a row of contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowNumbers {
    /// Its mode.
    pub mode: Mode,
    /// Others carry it.
    pub is_carried: bool,
    /// The displacement at which it sticks, m or rad.
    pub place: f64,
    /// The reaction at this place is negative.
    pub is_negative: bool,
}

impl<
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> State<f64, NQ, NC, N, L, H, R, P>
{
    /// All its numbers.
    pub(crate) fn numbers(&self) -> Numbers {
        let (mechanism, held) = (self.mechanism(), self.held());
        let lowered = mechanism.model.lowered;
        let first = |all: &[f64], count: usize| all.iter().take(count).copied().collect();
        let modes = &held.contact.modes;
        let is = |all: &[bool], k: usize| all.get(k) == Some(&true);
        let row = |k: usize| RowNumbers {
            mode: modes.of.get(k).copied().unwrap_or(Mode::Open),
            is_carried: is(&modes.carried, k),
            place: modes.place.get(k).copied().unwrap_or(0.0),
            is_negative: is(&modes.negative, k),
        };
        let (chart, memory) = match &held.of_loops {
            OfLoops::InChart { chart, continuation } => (Some(*chart), continuation.all()),
            OfLoops::Free { .. } => (None, Vec::new()),
        };
        Numbers {
            time: self.time(),
            x: (0..N).filter(|place| mechanism.has_number(*place)).map(|place| self.x()[place]).collect(),
            parameters: first(&mechanism.parameters, lowered.parameters.len()),
            inputs: first(&held.input, lowered.inputs.len()),
            sides: first(&held.switches, lowered.switches.all.len()),
            turns: held.turns.iter().take(lowered.turns.len()).copied().collect(),
            chart: chart.filter(|_| lowered.loops.is_some()),
            contacts: (0..lowered.contacts.as_ref().map_or(0, |contacts| contacts.places)).map(row).collect(),
            memory: if lowered.loops.is_some() { memory } else { Vec::new() },
        }
    }
}

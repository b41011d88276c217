//! Events that set states as data.

use super::Parts;
use super::routine::Routine;
use crate::collect::CollectVec;
use crate::model;
use crate::source::Origin;

/// Events that set states.
#[derive(Clone, Debug)]
pub struct Sets {
    /// By event, what it sets, in the order of the values.
    pub events: Vec<Vec<Set>>,
    /// The events that happen as a run begins.
    pub at_start: Vec<usize>,
    /// `holds`: 1 for each event whose condition holds, or 0.
    pub holds: Routine,
    /// `set`: the values that events set, one event after the other.
    pub values: Routine,
}

/// A target of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Set {
    /// A first-order state, by its number.
    State(usize),
    /// A velocity of a body, by its coordinate.
    Velocity(usize),
}

impl Sets {
    pub(super) fn new(parts: &Parts) -> Sets {
        let (model, absolute) = (parts.model, &parts.program.absolute);
        let target = |(target, _): &(model::Target, _)| match *target {
            model::Target::State(k) => Set::State(k),
            model::Target::Velocity(k) => Set::Velocity(k),
        };
        let at_start = (0..model.whens.len()).filter(|&k| model.whens[k].is_at_start).collect_vec();
        Sets {
            at_start,
            events: model.whens.iter().map(|when| when.set.iter().map(target).collect_vec()).collect_vec(),
            holds: parts.routine(&absolute.events, Origin::Arguments),
            values: parts.routine(&absolute.values_set, Origin::State),
        }
    }

    /// Number of the values that are set.
    pub fn count(&self) -> usize {
        self.events.iter().map(Vec::len).sum()
    }
}

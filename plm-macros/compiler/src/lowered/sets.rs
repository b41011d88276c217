//! Events that set states as data.

use super::Parts;
use super::routine::Routine;
use crate::collect::CollectVec;
use crate::model::{self, When};
use crate::source::Origin;

/// Events that set states.
#[derive(Clone, Debug)]
pub struct Sets {
    /// By event that follows a condition, what it sets, in the order of the values.
    pub events: Vec<Vec<Set>>,
    /// By event that happens as a run begins, what it sets.
    pub at_start: Vec<Vec<Set>>,
    /// `holds`: 1 for each event whose condition holds, or 0.
    pub holds: Routine,
    /// `set`: the values that events set, one event after the other.
    pub values: Routine,
    /// `set`: the same of events that happen as a run begins.
    pub values_at_start: Routine,
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
        let targets =
            |whens: &[When]| whens.iter().map(|when| when.set.iter().map(target).collect_vec()).collect_vec();
        let (whens, at_start) = When::parted(&model.whens);
        Sets {
            events: targets(whens),
            at_start: targets(at_start),
            holds: parts.routine(&absolute.events, Origin::Arguments),
            values: parts.routine(&absolute.values_set, Origin::State),
            values_at_start: parts.routine(&absolute.values_at_start, Origin::State),
        }
    }
}

//! The variables of an FMU by value reference.

use plm_runtime::{System, Vector};

use crate::{Foreign, Kind};

/// A variable of an FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// The time, s.
    Time,
    /// A parameter, SI.
    Parameter(usize),
    /// A start value, SI.
    Start(usize),
    /// An input, SI.
    Input(usize),
    /// An observed quantity, SI.
    Output(usize),
    /// A continuous state, SI.
    State(usize),
    /// The rate of a continuous state.
    Rate(usize),
    /// An event indicator: negative where a condition has left its side.
    Indicator(usize),
}

/// A kind of variable, and how many there are.
type Count = (fn(usize) -> Variable, usize);

impl Variable {
    /// How many there are of each, in the order of value references; the time is 0.
    fn counts<M: Foreign>(declared: &M) -> [Count; 7] {
        let states = <M as System>::X::LEN;
        [
            (Self::Parameter, M::TABLES.parameters.len()),
            (Self::Start, Kind::Start.count(declared)),
            (Self::Input, M::TABLES.inputs.len()),
            (Self::Output, M::OBSERVED.len()),
            (Self::State, states),
            (Self::Rate, states),
            (Self::Indicator, <M as System>::G::LEN),
        ]
    }

    /// All variables, in the order of their value references from 0.
    pub fn all<M: Foreign>(declared: &M) -> impl Iterator<Item = Self> {
        let of_kind = |(make, count): Count| (0..count).map(make);
        core::iter::once(Self::Time).chain(Self::counts(declared).into_iter().flat_map(of_kind))
    }

    /// The variable of a value reference.
    pub fn of<M: Foreign>(declared: &M, reference: u32) -> Option<Self> {
        Self::all(declared).nth(usize::try_from(reference).ok()?)
    }
}

//! The variables of an FMU by value reference.

use plm_runtime::{Rate, Vector};

use super::{Exchanged, follow};
use crate::Kind;

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
    /// An event indicator: negative where a condition has left its side. After those of conditions, of mechanisms with loops, one that
    /// is negative where the loops need other coordinates.
    Indicator(usize),
    /// The method of co-simulation, a [`Choice`](super::Choice) by its number.
    Method,
    /// The step of methods with steps of fixed length, s.
    Step,
    /// Mode of a row of contact, as [`Mode::number`](plm_runtime::contact::Mode::number) says.
    Contact(usize),
}

/// A kind of variable, and how many there are.
type Count = (fn(usize) -> Variable, usize);

impl Variable {
    /// The index of an output.
    pub(crate) fn output(&self) -> Option<usize> {
        if let Self::Output(index) = self { Some(*index) } else { None }
    }

    /// How many there are of each, in the order of value references; the time is 0.
    fn counts<M: Exchanged>(declared: &M) -> [Count; 10] {
        let states = <M as Rate>::X::LEN;
        [
            (Self::Parameter, declared.tables().parameters.len()),
            (Self::Start, Kind::Start.count(declared)),
            (Self::Input, declared.tables().inputs.len()),
            (Self::Output, declared.observables().len()),
            (Self::State, states),
            (Self::Rate, states),
            (Self::Indicator, follow::indicators(declared)),
            (|_| Self::Method, 1),
            (|_| Self::Step, 1),
            (Self::Contact, declared.contact_count()),
        ]
    }

    /// All variables, in the order of their value references from 0.
    pub fn all<M: Exchanged>(declared: &M) -> impl Iterator<Item = Self> {
        let of_kind = |(make, count): Count| (0..count).map(make);
        core::iter::once(Self::Time).chain(Self::counts(declared).into_iter().flat_map(of_kind))
    }

    /// The variable of a value reference.
    pub fn of<M: Exchanged>(declared: &M, reference: u32) -> Option<Self> {
        Self::all(declared).nth(usize::try_from(reference).ok()?)
    }
}

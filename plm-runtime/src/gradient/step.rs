//! The derivatives of one interval of a run, for filters and predictive control.

use super::{By, NoDerivatives, from_moment};
use crate::described::Described;
use crate::dual::Dual;
use crate::linear::Linear;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::scalar::Scalar as _;
use crate::system::{Labels, Rate};
use crate::vector::Vector;

/// The state after an interval of a run, and its derivatives by what it begins with: by [states](By::State) the transition matrix, by
/// [inputs](By::Input) that of a control which is constant over the interval.
///
/// Exact for the steps that were made, across events, impacts and changes of modes. A row is a number of the state, a column what the
/// interval was derived by. All numbers are SI.
#[derive(Clone, Copy)]
pub struct Jacobian<'a, M: Linear, const K: usize>
where
    M::Lifted<K>: Mechanism,
{
    moment: <M::Lifted<K> as Mechanism>::State,
    by: [By<'a>; K],
}

impl<'a, M, const K: usize> Jacobian<'a, M, K>
where
    M: Linear + Mechanism,
    M::Lifted<K>: Described<S = Dual<M::S, K>>,
{
    /// Those of an interval of `dt`, s, from a moment of a run, by a method in numbers with derivatives.
    ///
    /// # Errors
    /// As [`from_moment`], and those of the run.
    pub fn of_step<J: Method<M::Lifted<K>>>(
        state: &M::State,
        dt: M::S,
        method: J,
        by: [By<'a>; K],
    ) -> Result<Self, NoDerivatives<'a>> {
        let mut sim = from_moment::<M, J, K>(state, method, by)?;
        sim.step(Dual::constant(dt))?;
        Ok(Self { moment: *sim.state(), by })
    }

    /// The moment after the interval, in numbers with derivatives: its outputs have theirs.
    pub fn moment(&self) -> &<M::Lifted<K> as Mechanism>::State {
        &self.moment
    }

    /// How many rows there are.
    pub fn rows(&self) -> usize {
        M::X::LEN
    }

    /// The name of a row.
    pub fn row(&self, row: usize) -> &'static str {
        self.moment.mechanism().name_in_chart(&self.moment.held(), row)
    }

    /// Variable of differentiation of a column.
    pub fn column(&self, column: usize) -> Option<By<'a>> {
        self.by.get(column).copied()
    }

    /// The state after the interval.
    pub fn state(&self) -> M::X {
        M::X::from_fn(|i| self.moment.x().at(i).value)
    }

    /// The derivatives of the first `N` numbers of the state, a row each; rows beyond the last one are zero.
    pub fn matrix<const N: usize>(&self) -> [[M::S; K]; N] {
        let x = self.moment.x();
        core::array::from_fn(|row| {
            let is_there = row < <<M::Lifted<K> as Rate>::X as Vector<Dual<M::S, K>>>::LEN;
            if is_there { x.at(row).tangents } else { Dual::constant(M::S::ZERO).tangents }
        })
    }
}

//! Impacts of an event: one problem after another, until no row approaches.

use super::booked::Struck;
use super::event::Event;
use super::impact::{ImpactLaw, Impulses, by_enumeration, impulses};
use super::rows::{Law, Rows, below, indices};
use super::{Contacts, moved};
use crate::fault::{Cause, Fault};
use crate::scalar::Scalar;
use crate::vector::Vector;

/// Most successive impacts.
const MOST_IMPACTS: u32 = 30;
/// Most successive impacts of pairs.
const MOST_PAIRS: u32 = 1000;

impl<M: Contacts<N>, const N: usize> Event<'_, M, N> {
    /// Solves impacts of all rows that touch, until none approaches faster than a row at rest may, or than `slowest`. The rows become
    /// those after the impacts.
    pub(super) fn impacts(
        &self,
        laws: &[Law<M::S>; N],
        (none, slowest, rows): (M::S, Option<M::S>, &mut Rows<M::S, N>),
        u: &M::U,
        x: &mut M::X,
        struck: &mut Struck<M::S, N>,
    ) -> Result<(), Fault> {
        let law = self.system.impact_law();
        let most = if law == ImpactLaw::Sequential { MOST_PAIRS } else { MOST_IMPACTS };
        loop {
            let touches = self.touches(laws, rows, u);
            let approaches = |i: &usize| {
                let i = below::<N>(*i);
                let slow = slowest.unwrap_or_else(|| self.resting(rows, i).max(none));
                match laws[i] {
                    Law::Unilateral { .. } => touches[i] && rows.rate[i] < -slow,
                    Law::Constraint => touches[i] && rows.rate[i].abs() > slow,
                    Law::Friction => false,
                }
            };
            let Some(row) = indices::<N>().find(approaches) else { return Ok(()) };
            if struck.count >= most {
                return Err(self.fault(row, Cause::Impact { tried: struck.count }));
            }
            let solve = &mut |rows: &Rows<M::S, N>, touches: &[bool; N]| by_enumeration(rows, laws, touches);
            let Impulses::Found(impulses, doubts) = impulses(rows, laws, (law, touches), solve) else {
                return Err(self.fault(row, Cause::Impact { tried: struck.count + 1 }));
            };
            struck.doubts = struck.doubts.and(doubts);
            let moved_by_time = self.rates_at_rest(u, x);
            moved(self.system, (self.t, u), x, &impulses);
            let after = self.system.rows_at(self.t, u, x);
            struck
                .add([&rows.rate, &after.rate], &moved_by_time, &impulses)
                .map_err(|[by, of]| self.fault(row, Cause::ImpactGains { by, of }))?;
            *rows = after;
        }
    }

    /// Rates of the rows that depend on time alone.
    fn rates_at_rest(&self, u: &M::U, x: &M::X) -> [M::S; N] {
        let mut rest = *x;
        for i in M::NQ..2 * M::NQ {
            rest.set(i, M::S::ZERO);
        }
        self.system.rows_at(self.t, u, &rest).rate
    }
}

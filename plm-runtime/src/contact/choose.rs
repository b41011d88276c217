//! The modes that apply after an event, and faults where there are none.

use super::candidates::{Allowed, Found, MARGINAL, Margins, Solution, enumerate, most_holding, solve};
use super::event::{Event, moving_rows};
use super::marginal::broken;
use super::rows::Rows;
use super::{Contacts, Modal, paradox};
use crate::fault::{Cause, Fault};
use crate::scalar::Scalar;

impl<M: Contacts<N>, const N: usize> Event<'_, M, N> {
    /// The combination that satisfies all inequalities, and whether there are others.
    pub(super) fn choose(
        &self,
        rows: &Rows<M::S, N>,
        allowed: &[Allowed; N],
        u: &M::U,
        x: &M::X,
    ) -> Result<(Solution<M::S, N>, bool), Fault> {
        let mut found = enumerate(rows, allowed, |solution, margins| self.broken(u, x, solution, margins));
        if matches!(found, Found::Nothing) {
            // Next to the bound below which a rate decides, an inequality may be decided by its value in one combination and by its rate in
            // another, so that either breaks it. There are forces all the same where values alone are asked.
            found = enumerate(rows, allowed, |_, margins| margins.broken());
        }
        let touching = touching(allowed);
        let cause = match found {
            Found::Modes(solution, is_ambiguous) => {
                return self.derivable(rows, allowed, &solution).map(|()| (solution, is_ambiguous));
            }
            Found::Nothing => {
                let p = paradox::share(rows, &most_holding(allowed)).map_or(f64::NAN, Scalar::to_f64);
                Cause::NoMode { touching, p }
            }
            Found::TooMany => Cause::TooManyContacts { touching },
        };
        Err(self.fault(self.row(allowed), cause))
    }

    /// The inequalities of a combination that are not met, or are marginal and not met from here on.
    fn broken(
        &self,
        u: &M::U,
        x: &M::X,
        solution: &Solution<M::S, N>,
        margins: &Margins<M::S, N>,
    ) -> [bool; N] {
        let mut held = *u;
        let modes = held.modes_mut();
        (modes.of, modes.carried, modes.negative) = (solution.modes, solution.carried, solution.negative);
        broken(&moving_rows(self.system, (self.t, &held), x, &solution.lambda), solution, margins)
    }

    /// Has the motion derivatives to both sides, where rows begin with these modes? Not if one stands at its limit, and leaves it for what the
    /// run is derived by. After what the motion comes to, the time of the event is derived.
    fn derivable(
        &self,
        rows: &Rows<M::S, N>,
        allowed: &[Allowed; N],
        solution: &Solution<M::S, N>,
    ) -> Result<(), Fault> {
        if !M::S::HAS_DERIVATIVES || self.occasion.comes_by_motion() {
            return Ok(());
        }
        let Some((_, Margins { value, size })) = solve(rows, allowed, solution.modes) else { return Ok(()) };
        let is_at_limit = |i: &usize| {
            size[*i].is_some_and(|size| {
                let none = M::S::lit(MARGINAL) * size;
                value[*i].abs() <= none && value[*i].largest_derivative() > none.to_f64()
            })
        };
        (0..N).find(is_at_limit).map_or(Ok(()), |row| Err(self.fault(row, Cause::AtLimit)))
    }

    /// The row that a fault names.
    fn row(&self, allowed: &[Allowed; N]) -> usize {
        let first = allowed.iter().position(|row| *row == Allowed::Touching);
        self.occasion.row().or(first).unwrap_or(0)
    }
}

fn touching<const N: usize>(allowed: &[Allowed; N]) -> usize {
    allowed.iter().filter(|row| **row == Allowed::Touching).count()
}

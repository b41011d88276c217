//! Modes that apply after an event, and faults if there are none.

use super::candidates::{Allowed, Found, MARGINAL, Margins, Solution, enumerate, most_holding, solve};
use super::event::{Event, moving_rows};
use super::marginal::broken;
use super::rows::Rows;
use super::{Contacts, Modal, paradox};
use crate::fault::{Cause, Fault};
use crate::scalar::Scalar;

impl<M: Contacts<N>, const N: usize> Event<'_, M, N> {
    /// The combination that satisfies all inequalities; true if there are others.
    pub(super) fn choose(
        &self,
        rows: &Rows<M::S, N>,
        allowed: &[Allowed; N],
        u: &M::U,
        x: &M::X,
    ) -> Result<(Solution<M::S, N>, bool), Fault> {
        let mut found = enumerate(rows, allowed, |solution, margins| self.broken(u, x, solution, margins));
        if matches!(found, Found::Nothing) {
            // Near the bound below which a rate decides, an inequality may be decided by its value in one combination and by its rate in
            // another, so that both violate it. Forces still exist if only values are compared.
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

    /// Inequalities of a combination that are violated, or marginal and violated from here on.
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

    /// Checks that the motion has derivatives to both sides if the rows begin with these modes. It has none if a row is at its limit and
    /// leaves it with the variable of differentiation. After an event that the motion comes to, the time of the event is differentiated
    /// instead.
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

    /// Row that a fault names.
    fn row(&self, allowed: &[Allowed; N]) -> usize {
        let first = allowed.iter().position(|row| *row == Allowed::Touching);
        self.occasion.row().or(first).unwrap_or(0)
    }
}

fn touching<const N: usize>(allowed: &[Allowed; N]) -> usize {
    allowed.iter().filter(|row| **row == Allowed::Touching).count()
}

//! Frictions by the wanted motion: which slip, and to which side.
//!
//! A wanted motion says more than a state does. Its velocity decides what slips; where it rests, its acceleration says to which side it leaves, and
//! where that is zero too, as at the start of a smooth motion, the place that is wanted next.

use super::error::Unsolved;
use super::names::Quantity;
use super::{Inverse, Invertible, Wanted};
use crate::contact::{Change, Mode};
use crate::mechanism::Moment;
use crate::scalar::Real;
use crate::system::Events;

/// A velocity that stands for an acceleration, of the largest velocity or 1: far above what counts as no slip.
const SETTING_OFF: f64 = 1e-3;

impl<'a, S: Real, const TARGETS: usize, const DRIVES: usize> Inverse<'a, S, TARGETS, DRIVES> {
    /// The moment at a time with the targets at their wanted places; frictions that stick are released if they would prevent that.
    ///
    /// # Errors
    /// As [`place`](Self::place).
    pub(super) fn placed_by_motion<T>(
        &self,
        of: &T,
        time: S,
        wanted: &Wanted<S, TARGETS>,
    ) -> Result<(T, usize), Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        self.placed(of, time, wanted)
            .or_else(|refused| if sticks(of) { self.placed(&let_go(of), time, wanted) } else { Err(refused) })
    }

    /// The moment with the modes of contacts that the wanted motion gives it.
    ///
    /// # Errors
    /// [`Unsolved::Fault`] if no modes satisfy the laws of contact.
    pub(super) fn with_sides<T>(
        &self,
        state: &T,
        wanted: &Wanted<S, TARGETS>,
        next: Option<[S; TARGETS]>,
    ) -> Result<T, Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let mechanism = state.mechanism();
        if mechanism.contact_count() == 0 {
            return Ok(*state);
        }
        let free = let_go(state);
        let setting_off = self.setting_off(wanted, next);
        let placed = if setting_off.velocity == wanted.velocity { None } else { Some(setting_off) };
        let moving = placed.and_then(|moving| Some(self.placed(&free, state.time(), &moving).ok()?.0));
        let (mut held, mut x) = (free.held(), *moving.unwrap_or(free).x());
        mechanism.state_was_set(state.time(), &mut held, &mut x)?;
        Ok(T::new(*mechanism, held, state.time(), *state.x()))
    }

    /// The wanted motion with small velocities of the targets that are wanted at rest: along their accelerations, and far below these along
    /// the ways to their next places.
    fn setting_off(&self, wanted: &Wanted<S, TARGETS>, next: Option<[S; TARGETS]>) -> Wanted<S, TARGETS> {
        let largest =
            |numbers: &[S; TARGETS]| numbers.iter().fold(S::ZERO, |most, number| most.max(number.abs()));
        let rests = |k: usize| {
            let moves =
                self.targets.get(k).is_some_and(|target| !matches!(target.quantity, Quantity::Value(_)));
            moves && wanted.velocity.get(k) == Some(&S::ZERO)
        };
        let of_rest = |numbers: [S; TARGETS]| {
            let own = core::array::from_fn(|k| if rests(k) { numbers[k] } else { S::ZERO });
            let size = largest(&own);
            if size > S::ZERO { own.map(|number| number / size) } else { own }
        };
        let ways =
            next.map_or([S::ZERO; TARGETS], |next| core::array::from_fn(|k| next[k] - wanted.place[k]));
        let (accelerations, ways) = (of_rest(wanted.acceleration), of_rest(ways));
        let small = S::lit(SETTING_OFF);
        let size = small * largest(&wanted.velocity).max(S::lit(1.0));
        let velocity = core::array::from_fn(|k| {
            size.mul_add(small.mul_add(ways[k], accelerations[k]), wanted.velocity[k])
        });
        Wanted { velocity, ..*wanted }
    }

    /// The inputs for wanted accelerations if frictions stick and prevent a target from moving: `held` is the reason why there were none. A
    /// target that is wanted at rest keeps the inputs of the moment.
    ///
    /// # Errors
    /// `held` where no friction is let go, or not in this way.
    pub(super) fn inputs_from_rest<T>(
        &self,
        state: &T,
        acceleration: [S; TARGETS],
        held: Unsolved<'a>,
    ) -> Result<[S; DRIVES], Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let is_held =
            matches!(held, Unsolved::Unmoved { .. } | Unsolved::Dependent { .. } | Unsolved::Mode { .. });
        if !is_held || !sticks(state) {
            return Err(held);
        }
        let present = self.present(state);
        if matches!(held, Unsolved::Unmoved { .. })
            && acceleration == [S::ZERO; TARGETS]
            && self.evaluate(state, &present).is_ok_and(|now| now.values == acceleration)
        {
            return Ok(present);
        }
        let (places, velocities) = self.motion(state);
        let known = |numbers: [Option<S>; TARGETS]| numbers.map(|number| number.unwrap_or(S::ZERO));
        let wanted = Wanted { place: known(places), velocity: known(velocities), acceleration };
        let moving = self.with_sides(state, &wanted, None).map_err(|_| held)?;
        self.inputs_in_modes(&moving, acceleration).map_err(|_| held)
    }
}

/// Does a friction stick, with a force of its own?
fn sticks<T: Moment<M: Events>>(state: &T) -> bool {
    let held = state.held();
    let status = <T::M as Events>::contacts(&held);
    (0..).map_while(|row| status.mode(row)).any(|mode| mode == Mode::Sticks)
}

/// The moment with modes that are found where it is set.
fn let_go<T: Moment<M: Copy>>(state: &T) -> T {
    let mut held = state.held();
    T::M::change_contact(&mut held, Change::WhereSet);
    T::new(*state.mechanism(), held, state.time(), *state.x())
}

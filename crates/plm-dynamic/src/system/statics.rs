//! Residuals of equilibrium, over states in absolute coordinates with unused room at the end.

use plm_runtime::system::Events;
use plm_runtime::{Absolute, BodyStart, Fault, Real, Statics, absolute, turns};

use super::State;
use crate::handle::{Beside, Dynamic, Frame, Held, Starts};
use crate::places::Room;

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Dynamic<S, NQ, NC, N, L, H, R, P>
{
    /// Coordinates of all bodies, and the room for them.
    fn absolute_room(&self) -> Room {
        Room { coordinates: self.model.lowered.coordinates.len(), capacity: NQ }
    }

    /// Numbers of a state in absolute coordinates.
    fn absolute_count(&self) -> usize {
        2 * self.model.lowered.coordinates.len() + self.model.lowered.states.len()
    }

    /// A state in absolute coordinates with unused room after its coordinates and after its velocities, as functions expect it, from one
    /// with all of it at the end.
    fn spread(&self, x: &[S; N]) -> [S; N] {
        let (room, mut all) = (self.absolute_room(), [S::ZERO; N]);
        for (k, number) in x.iter().enumerate().take(self.absolute_count()) {
            if let Some(to) = all.get_mut(room.place(k)) {
                *to = *number;
            }
        }
        all
    }

    /// The reverse of [`spread`](Self::spread).
    fn gathered(&self, x: &[S; N]) -> [S; N] {
        let (room, mut all) = (self.absolute_room(), [S::ZERO; N]);
        for (k, to) in all.iter_mut().enumerate().take(self.absolute_count()) {
            *to = x.get(room.place(k)).copied().unwrap_or(S::ZERO);
        }
        all
    }
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Statics for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    type Full = [S; N];
    type Rows = [S; NC];
    type Starts = Starts<S, N>;
    const COORDINATES: &'static [&'static str] = super::described::of_the_value();
    const ROWS: &'static [&'static str] = super::described::of_the_value();
    const STATES: &'static [(&'static str, &'static str)] = super::described::of_the_value();

    fn coordinate_names(&self) -> &'static [&'static str] {
        self.model.layout.coordinates
    }

    fn row_names(&self) -> &'static [&'static str] {
        self.model.layout.rows
    }

    fn state_names(&self) -> &'static [(&'static str, &'static str)] {
        self.model.description.states
    }

    fn full(state: &State<S, NQ, NC, N, L, H, R, P>) -> [S; N] {
        state.unwrapped()
    }

    #[cold]
    fn equations(
        &self,
        t: S,
        u: &Held<S, NQ, L, H, R>,
        x: &[S; N],
        lambda: &[S; NC],
        each: &mut impl FnMut(S),
    ) {
        let (x, lowered) = (self.spread(x), &self.model.lowered);
        let (mut force, mut x_dot) = ([S::ZERO; NQ], [S::ZERO; N]);
        let (mut gap, mut limit) = ([S::ZERO; R], [[S::ZERO; R]; 2]);
        let beside = Beside { lambda, ..Beside::NONE };
        let frame = Frame { beside: Some(&beside), ..Frame::of_state(t, u, &x) };
        let limit = limit.as_flattened_mut();
        self.run(&self.model.absolute.at_rest, &frame, [&mut force, &mut x_dot, &mut gap, limit]);
        let (q, v): ([S; NQ], [S; NQ]) = absolute::split(&x);
        let (nq, nc) = (lowered.coordinates.len(), lowered.rows.len());
        let balance = absolute::balance::<S, Self, NQ, NC>(self, t, &q, lambda, &force);
        balance.into_iter().take(nq).for_each(&mut *each);
        self.phi(t, &q).into_iter().take(nc).for_each(&mut *each);
        self.phi_dot(t, &q, &v).into_iter().take(nc).for_each(&mut *each);
        x_dot.into_iter().take(lowered.states.len()).for_each(&mut *each);
        let contacts = self.contact_count();
        gap.into_iter().take(contacts).chain(limit.iter().copied().take(2 * contacts)).for_each(each);
    }

    fn multipliers(held: &mut Held<S, NQ, L, H, R>) -> &mut [S] {
        &mut held.contact.lambda
    }

    fn start_with_inputs(
        &self,
        t: S,
        held: &Held<S, NQ, L, H, R>,
    ) -> Result<(Held<S, NQ, L, H, R>, [S; N]), Fault> {
        self.start_holding(t, held.input)
    }

    fn unstarted(&self) -> Held<S, NQ, L, H, R> {
        self.holding(self.declared_input())
    }

    fn starts_mut(&mut self) -> &mut Starts<S, N> {
        &mut self.starts
    }

    fn declared_starts(&self) -> Starts<S, N> {
        let follow = self.model.lowered.starts.follows.contains(&true);
        if follow { Dynamic::declared_starts(self) } else { self.starts }
    }

    fn starts_at(&self, x: &[S; N]) -> Starts<S, N> {
        let (mut starts, lowered) = (self.starts, &self.model.lowered);
        let (bodies, nq) = (lowered.bodies.len(), lowered.coordinates.len());
        let centres = self.values(S::ZERO, &self.model.start.centres, 2 * bodies);
        let (q, rest) = x.split_at(nq.min(N));
        let (v, states) = rest.split_at(nq.min(rest.len()));
        let moved = q.as_chunks::<3>().0.iter().zip(v.as_chunks::<3>().0);
        for (k, ((q, v), centre)) in moved.zip(centres.as_chunks::<2>().0).enumerate() {
            let BodyStart { x, y, angle, vx, vy, omega } =
                self.starts.body(k).with_centre_at(*centre, *q, *v);
            if let Some(body) = starts.values.as_chunks_mut::<6>().0.get_mut(k) {
                *body = [x, y, angle, vx, vy, omega];
            }
        }
        let of_states = starts.values.iter_mut().skip(6 * bodies).take(lowered.states.len());
        for (start, value) in of_states.zip(states) {
            *start = start.at(*value);
        }
        starts
    }

    fn size(&self) -> S {
        self.length()
    }
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> State<S, NQ, NC, N, L, H, R, P>
{
    /// The state in absolute coordinates including all revolutions, unused room at the end.
    fn unwrapped(&self) -> [S; N] {
        let (mechanism, mut x) = (plm_runtime::Moment::mechanism(self), self.absolute());
        turns::add(&plm_runtime::Moment::held(self).turns, &mut x, &mechanism.turning());
        mechanism.gathered(&x)
    }
}

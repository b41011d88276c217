//! Several trajectories of one mechanism side by side, one in each lane of vectors.
//!
//! The equations are straight-line code for any [`Scalar`], so a number that holds a value for every lane runs them for
//! all lanes at once. Decisions on data (rank, charts, projection) are made lane by lane, in ordinary numbers; lengths of steps by their
//! errors side by side.

mod batch;
mod lane;
mod paced;
mod side;
mod strides;
mod two;

pub use batch::Batch;
pub use paced::run_all;
pub use two::Two;

use crate::contact::{Proposed, Stride};
use crate::mechanism::Mechanism;
use crate::scalar::Scalar;
use crate::system::Rate;

/// How many trajectories run side by side.
pub const LANES: usize = 8;

/// Eight values of `f64` as one number; every operation gives each lane the bits that `f64` gives.
pub trait Lanes: Scalar {
    /// A value for every lane.
    fn of(values: [f64; LANES]) -> Self;
    /// The values.
    fn values(self) -> [f64; LANES];
    /// The value of one lane.
    #[inline]
    fn value(&self, lane: usize) -> f64 {
        self.values()[lane % LANES]
    }
    /// Gives one lane another value.
    fn put(&mut self, lane: usize, value: f64);
}

/// A mechanism of which several can be packed into one; implemented by generated code.
pub trait Pack: Mechanism {
    /// These equations with numbers of another type.
    type Packed<T: Scalar>: Rate<S = T>;

    /// Several mechanisms as one, whose parameters `number` makes of theirs; it cannot be assembled (its starts are
    /// those of this one).
    fn pack<T: Scalar, const N: usize>(
        &self,
        all: [&Self; N],
        number: impl Fn([Self::S; N]) -> T,
    ) -> Self::Packed<T>;

    /// Packs the discrete states of several mechanisms into one; the chart is that of `first`.
    fn pack_held<T: Scalar, const N: usize>(
        first: &Self::U,
        all: [&Self::U; N],
        number: impl Fn([Self::S; N]) -> T,
    ) -> <Self::Packed<T> as Rate>::U;

    /// Copies the discrete state `one`, in the same chart, into its lane of `wide`, except for inputs, which are constant during an
    /// interval; `put` copies a number.
    fn put_held<T: Scalar>(
        wide: &mut <Self::Packed<T> as Rate>::U,
        one: &Self::U,
        put: impl Fn(&mut T, Self::S),
    );

    /// Number of the present chart, from 0; none if there is no chart.
    fn chart(held: &Self::U) -> Option<usize>;

    /// True if every step is checked by itself, even if nothing else is to be checked: for its drift from the constraints, and for poses
    /// that are nearly singular.
    const WATCHED: bool;

    /// As [`Constraints::is_settled`](crate::Constraints::is_settled), for states side by side, with the typical size of each number: 1 in the lanes where there is nothing
    /// to do, 0 elsewhere.
    fn are_calm<T: Scalar>(
        typical: &<Self::Packed<T> as Rate>::X,
        t: T,
        held: &<Self::Packed<T> as Rate>::U,
        x: &<Self::Packed<T> as Rate>::X,
    ) -> T;

    /// 1 in the lanes where a step between two states is surely short compared with the turns that mechanisms make next to a flat pose, 0
    /// elsewhere; `typical` has the typical size of each number.
    fn are_short<T: Scalar>(
        typical: &<Self::Packed<T> as Rate>::X,
        held: &<Self::Packed<T> as Rate>::U,
        ends: [&<Self::Packed<T> as Rate>::X; 2],
    ) -> T;

    /// [`Constraints::update`](crate::Constraints::update) of several states side by side, in the lanes in which that is `due` (1, else 0):
    /// 1 in those in which it changes nothing but continuation data, which is done; 0 elsewhere.
    fn look<T: Scalar>(
        all: &Self::Packed<T>,
        t: T,
        held: &mut <Self::Packed<T> as Rate>::U,
        x: &<Self::Packed<T> as Rate>::X,
        due: T,
    ) -> T;

    /// Copies the discrete state of the loops from its lane of `wide` to `one`, in the same chart; `take` gives a number of that lane.
    fn take_held<T: Scalar>(
        one: &mut Self::U,
        wide: &<Self::Packed<T> as Rate>::U,
        take: impl Fn(T) -> Self::S,
    );

    /// Makes the steps of time that are `proposed`, each to the bits of [`Events::stride`](crate::Events::stride). With rows of contact
    /// their motion is computed at once: `all` (with the discrete state), steps and states are those of all lanes as one, in a chart that
    /// the lanes of these steps have in common, and `take` gives the value of a lane.
    fn packed_steps<T: Scalar, const K: usize>(
        all: (&Self::Packed<T>, &<Self::Packed<T> as Rate>::U),
        steps: (&Stride<T>, &<Self::Packed<T> as Rate>::X),
        proposed: [Option<Proposed<'_, Self>>; K],
        take: impl Fn(&T, usize) -> Self::S,
    ) {
        let _ = (all, steps, take);
        for Proposed { system, stride, held, x, made } in proposed.into_iter().flatten() {
            *made = Some(system.stride::<1>(&stride, held, x, |_, _, _| Ok(())));
        }
    }
}

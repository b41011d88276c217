//! Several trajectories of one mechanism side by side, one in each lane of vectors.
//!
//! The equations are straight-line code for any [`Scalar`], so a number that holds a value for every lane runs them for
//! all lanes at once. What is decided on data (rank, charts, projection) is decided lane by lane, in ordinary numbers.

mod batch;
mod lane;
mod side;
mod strides;
mod two;

pub use batch::Batch;
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
    /// The same equations in other numbers.
    type Packed<T: Scalar>: Rate<S = T>;

    /// Several mechanisms as one, whose parameters `number` makes of theirs; it cannot be assembled (its starts are
    /// those of this one).
    fn pack<T: Scalar, const N: usize>(
        &self,
        all: [&Self; N],
        number: impl Fn([Self::S; N]) -> T,
    ) -> Self::Packed<T>;

    /// What several mechanisms hold over a step as one; the chart is that of `first`.
    fn pack_held<T: Scalar, const N: usize>(
        first: &Self::U,
        all: [&Self::U; N],
        number: impl Fn([Self::S; N]) -> T,
    ) -> <Self::Packed<T> as Rate>::U;

    /// Puts what `one` holds, in the same chart, into its lane of what several hold, but for inputs, which stay over an interval;
    /// `put` does so with a number.
    fn put_held<T: Scalar>(
        wide: &mut <Self::Packed<T> as Rate>::U,
        one: &Self::U,
        put: impl Fn(&mut T, Self::S),
    );

    /// The chart that is held, from 0; none where no chart is good.
    fn chart(held: &Self::U) -> Option<usize>;

    /// Steps are looked at one by one even where nothing else is to be looked at: for their drift from the constraints, and for
    /// poses that are nearly singular.
    const WATCHED: bool;

    /// Whether [`Constraints::update`](crate::Constraints::update) has nothing to do at a state.
    fn is_calm(&self, t: Self::S, held: &Self::U, x: &Self::X) -> bool;

    /// The same of several states side by side, with the typical size of each number: 1 in the lanes where it has nothing to
    /// do, 0 elsewhere.
    fn are_calm<T: Scalar>(
        typical: &<Self::Packed<T> as Rate>::X,
        t: T,
        held: &<Self::Packed<T> as Rate>::U,
        x: &<Self::Packed<T> as Rate>::X,
    ) -> T;

    /// Whether steps between two states are short beside the turns that mechanisms make next to a flat pose, with the typical
    /// size of each number: 1 in the lanes where they surely are, 0 elsewhere.
    fn are_short<T: Scalar>(
        typical: &<Self::Packed<T> as Rate>::X,
        held: &<Self::Packed<T> as Rate>::U,
        ends: [&<Self::Packed<T> as Rate>::X; 2],
    ) -> T;

    /// [`Constraints::update`](crate::Constraints::update) of several states side by side, in the lanes in which that is `due` (1, else 0): 1 in those where it
    /// changes nothing but what is remembered, which is done; 0 elsewhere.
    fn look<T: Scalar>(
        all: &Self::Packed<T>,
        t: T,
        held: &mut <Self::Packed<T> as Rate>::U,
        x: &<Self::Packed<T> as Rate>::X,
        due: T,
    ) -> T;

    /// What `one` holds of its loops becomes that of its lane, in the same chart; `take` gives a number of that lane.
    fn take_held<T: Scalar>(
        one: &mut Self::U,
        wide: &<Self::Packed<T> as Rate>::U,
        take: impl Fn(T) -> Self::S,
    );

    /// Makes the steps of time that are `proposed`, each to the bits of [`Events::stride`](crate::Events::stride). With rows of contact their
    /// motion is computed at once: `all`, what they hold, steps and states are those of all lanes as one, in a chart that the lanes of these
    /// steps have in common, and `take` gives the value of a lane.
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

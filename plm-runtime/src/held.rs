//! Discrete state: constant during a step, changed only at events. It has one shape for every mechanism.

use crate::scalar::{Real, Scalar};
use crate::words::{InWords, Words};

/// Discrete state: constant during a step. The rate is smooth in time and state as long as it is unchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<I, W, T, L, C = ()> {
    /// The inputs.
    pub input: I,
    /// Side of each condition: -1 if the condition holds, else 1.
    pub switches: W,
    /// Revolutions of the angles that are counted ([`turns`](crate::turns)).
    pub turns: T,
    /// Discrete state of the loops: [`OfLoops`](crate::charts::OfLoops) if they are solved in charts, else nothing.
    pub of_loops: L,
    /// Discrete state of the contact rows: [`contact::Held`](crate::contact::Held) if there are some, else nothing.
    pub contact: C,
}

/// Properties of a discrete state that code generic over mechanisms can read.
pub trait Discrete {
    /// True if loops are solved in charts, so that the discrete state belongs to a pose.
    const CHARTED: bool;
}

impl<I, W, T, L, C> Discrete for Held<I, W, T, L, C> {
    const CHARTED: bool = size_of::<L>() > 0;
}

/// A discrete state that holds sides of conditions.
pub trait Sides<S> {
    /// Of each condition -1 where it holds, else 1.
    fn sides(&self) -> &[S];

    /// Sides of conditions, to be changed.
    fn sides_mut(&mut self) -> &mut [S];
}

impl<I, S, const W: usize, T, L, C> Sides<S> for Held<I, [S; W], T, L, C> {
    #[inline]
    fn sides(&self) -> &[S] {
        &self.switches
    }

    #[inline]
    fn sides_mut(&mut self) -> &mut [S] {
        &mut self.switches
    }
}

/// Discrete state of the loops of several simulations, packed into one.
pub trait Loops<S>: Copy {
    /// This discrete state with numbers of the type `T`.
    type Packed<T: Scalar>: Copy;

    /// Packs the discrete states `all`, whose numbers `number` combines, in the chart of this one; states in another chart are left out.
    fn packed<T: Scalar, const N: usize>(
        &self,
        all: [&Self; N],
        number: &impl Fn([S; N]) -> T,
    ) -> Self::Packed<T>;

    /// Copies the discrete state `one`, in the same chart, into its lane of `wide`; `put` copies a number.
    fn put<T: Scalar>(wide: &mut Self::Packed<T>, one: &Self, put: &impl Fn(&mut T, S));

    /// Becomes the discrete state in its lane of `wide`, in the same chart; `take` gives a number of that lane.
    fn take<T: Scalar>(&mut self, wide: &Self::Packed<T>, take: &impl Fn(T) -> S);

    /// Number of the present chart, from 0; none if there is no chart.
    fn chart(&self) -> Option<usize>;
}

impl<S> Loops<S> for () {
    type Packed<T: Scalar> = ();

    fn packed<T: Scalar, const N: usize>(&self, _all: [&(); N], _number: &impl Fn([S; N]) -> T) {}

    fn put<T: Scalar>(_wide: &mut (), _one: &(), _put: &impl Fn(&mut T, S)) {}

    fn take<T: Scalar>(&mut self, _wide: &(), _take: &impl Fn(T) -> S) {}

    fn chart(&self) -> Option<usize> {
        Some(0)
    }
}

/// Sides of conditions, revolutions, loops, contacts. The inputs have a type of the mechanism's own: [`Ports`](crate::Ports) shows them.
impl<S: Real, I, const W: usize, const T: usize, L: InWords, C: InWords> InWords
    for Held<I, [S; W], [i32; T], L, C>
{
    fn each(&mut self, words: &mut impl Words) {
        words.numbers(&mut self.switches);
        for turns in &mut self.turns {
            let mut number = f64::from(*turns);
            words.number(&mut number);
            *turns = number as i32;
        }
        self.of_loops.each(words);
        self.contact.each(words);
    }
}

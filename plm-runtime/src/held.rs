//! Discrete state: constant during a step, changed only at events. It has one shape for every mechanism.

use crate::scalar::{Real, Scalar};
use crate::words::{InWords, Words};

/// What is held over a step; the rate is smooth in time and state as long as this stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<I, W, T, L, C = ()> {
    /// The inputs.
    pub input: I,
    /// Of each switch the side that is held: -1 where its condition holds, else 1.
    pub switches: W,
    /// Whole turns of the angles that are counted ([`turns`](crate::turns)).
    pub turns: T,
    /// What is held of the loops: [`OfLoops`](crate::charts::OfLoops) where they are solved in charts, else nothing.
    pub of_loops: L,
    /// What is held of the contact rows: [`contact::Held`](crate::contact::Held) where there are some, else nothing.
    pub contact: C,
}

/// What whoever knows a mechanism by its contracts alone may ask of what is held.
pub trait Discrete {
    /// Loops are solved in charts, so that what is held belongs to a pose.
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

/// What is held of the loops of several simulations, packed into one.
pub trait Loops<S>: Copy {
    /// The same in other numbers.
    type Packed<T: Scalar>: Copy;

    /// What `all` hold, made by `number`, in the chart of this one; what is held in another chart is left out.
    fn packed<T: Scalar, const N: usize>(
        &self,
        all: [&Self; N],
        number: &impl Fn([S; N]) -> T,
    ) -> Self::Packed<T>;

    /// Puts what `one` holds, in the same chart, into its lane of `wide`; `put` does so with a number.
    fn put<T: Scalar>(wide: &mut Self::Packed<T>, one: &Self, put: &impl Fn(&mut T, S));

    /// Becomes what is held in its lane of `wide`, in the same chart; `take` gives a number of that lane.
    fn take<T: Scalar>(&mut self, wide: &Self::Packed<T>, take: &impl Fn(T) -> S);

    /// The chart that is held, from 0; none where no chart is good.
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

/// Switches, turns, loops, contacts. The inputs have a type of the mechanism's own: they are shown by [`Ports`](crate::Ports).
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

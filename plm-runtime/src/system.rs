//! The contract between generated equations of motion and the methods that integrate them.

use crate::enclosure::Enclosed;
use crate::fault::{Cause, Fault};
use crate::lanes::Rate;
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

#[doc = include_str!("system.md")]
pub trait System {
    /// The numbers it computes with.
    type S: Scalar;
    /// The state and its rate: [q (NQ), v (NQ), first-order states], SI units.
    type X: Vector<Self::S>;
    /// The discrete state, which changes at events and between steps alone: the inputs, the modes of the conditions, and what the
    /// formulation remembers (its chart, the branch of each loop). The rate is smooth in time and state as long as it stays.
    type U: Copy + PartialEq;
    /// A number for every switching condition; `[S; 0]` costs nothing.
    type G: Vector<Self::S>;

    /// Number of coordinates; the first `NQ` rates are the velocities: q' = v.
    const NQ: usize;
    /// The rate is so short that it pays to copy it into every stage of a method. Not that of several lanes, which has work
    /// enough while it waits.
    const SHORT: bool = false;

    /// The rate `dx` of the state, as straight-line code without pivoting.
    fn rate(&self, t: Self::S, u: &Self::U, x: &Self::X, dx: &mut Self::X) -> Health<Self::S>;

    /// It pays to compute what depends on the poses of two stages alone side by side, by [`rate_pair`](Self::rate_pair).
    const PAIRED: bool = false;

    /// Two rates in a row: that at `x[0]`, and that at the state which `second` makes of it; the positions of the latter are
    /// those of `x[1]`. To the bit the same as one by one.
    #[inline]
    fn rate_pair(
        &self,
        t: [Self::S; 2],
        u: &Self::U,
        x: [&Self::X; 2],
        dx: &mut [Self::X; 2],
        second: impl FnOnce(&Self::X) -> Self::X,
    ) -> Health<Self::S> {
        let ([t, later], [x, _], [first, last]) = (t, x, dx);
        let health = self.rate(t, u, x, first);
        health.worst(self.rate(later, u, &second(first), last))
    }

    /// The rate where [`rate`](Self::rate) is unhealthy: by a rank-revealing decomposition.
    ///
    /// # Errors
    /// When the equations have no finite solution there.
    fn rate_by_rank(&self, t: Self::S, u: &Self::U, x: &Self::X, dx: &mut Self::X) -> Result<(), Fault> {
        self.rate(t, u, x, dx);
        Ok(())
    }

    /// Projects the state onto phi = 0 and phi_dot = 0.
    ///
    /// # Errors
    /// When the projection does not converge.
    fn settle(&self, t: Self::S, x: &mut Self::X) -> Result<(), Fault> {
        let _ = (t, x);
        Ok(())
    }

    /// How far the state is from its constraints; zero where there is nothing to project.
    fn drift(&self, t: Self::S, x: &Self::X) -> Drift<Self::S> {
        let _ = (t, x);
        Drift { phi: Self::S::lit(0.0), phi_dot: Self::S::lit(0.0) }
    }

    /// Can the rate be computed in what `u` holds? Not near singular poses, where no chart is good.
    fn is_regular(&self, u: &Self::U) -> bool {
        let _ = u;
        true
    }

    /// Looks at an accepted state and brings what is held over the next step up to date: charts, branches of loops.
    ///
    /// # Errors
    /// When the state cannot be the continuation of the one before. Methods with error control then
    /// try shorter steps; in the end the run stops with this fault and the state before the step.
    fn accept(&self, t: Self::S, u: &mut Self::U, x: &mut Self::X) -> Result<Accepted, Fault> {
        let _ = (t, u, x);
        Ok(Accepted::default())
    }

    /// How far every switching condition is from switching: positive as long as the side of it that `u` holds applies.
    ///
    /// Only conditions at which the rate jumps have a guard. A relay that is on down to `low` and off up to `high` gives
    /// x - low while `u` holds it on, and high - x while `u` holds it off.
    fn guards(&self, t: Self::S, u: &Self::U, x: &Self::X, g: &mut Self::G) {
        let _ = (t, u, x, g);
    }

    /// How many numbers the rate bends at where they pass zero; a step ends there if that matters.
    const KINKS: usize = 0;

    /// Gives each of these numbers with its index.
    fn kinks(&self, t: Self::S, u: &Self::U, x: &Self::X, each: &mut impl FnMut(usize, Self::S)) {
        let _ = (t, u, x, each);
    }

    /// Guards over an interval, and kinks behind them: gives each with its index, for a time and components of the state that move. False if
    /// a system cannot, and then conditions that last shorter than a small part of a step can be missed.
    fn guards_within(
        &self,
        t: Enclosed<Self::S>,
        u: &Self::U,
        x: &impl Fn(usize) -> Enclosed<Self::S>,
        each: &mut impl FnMut(usize, Enclosed<Self::S>),
    ) -> bool
    where
        Self::S: Real,
    {
        let _ = (t, u, x, each);
        false
    }

    /// A condition switches where its guard passes zero and goes on to below minus this: within the band nothing does.
    fn band(&self, index: usize) -> Self::S {
        let _ = index;
        Self::S::lit(0.0)
    }

    /// Commits the event of the condition `index`, whose guard has passed zero: `u` gets the mode that applies from now on, of two or
    /// more, in which that guard is not negative. The event may reset the state `x`, velocities too; whoever does so brings up to date
    /// what `u` remembers of it.
    ///
    /// # Errors
    /// When no mode applies: the run ends, and the state is that before the event.
    fn switch(&self, t: Self::S, u: &mut Self::U, x: &mut Self::X, index: usize) -> Result<(), Fault> {
        let _ = (t, u, x, index);
        Ok(())
    }

    /// Some conditions or kinks matter only while others have a certain side, as [`matters`](Self::matters) tells; of 64 sides at
    /// most.
    const SELECTIVE: bool = false;

    /// Would the rate be another function if the condition `index` had its other side than `u` holds, or can it be so if those
    /// other conditions change theirs whose bits are set in `unknown`? What does not matter is not located. Its side is brought up
    /// to date behind every step, so that it is right when it comes to matter. Kinks follow behind the conditions.
    fn matters(&self, u: &Self::U, index: usize, unknown: u64) -> bool {
        let _ = (u, index, unknown);
        true
    }

    /// The condition with this index is a requirement: where its guard passes zero the run ends with a fault.
    fn must_hold(&self, index: usize) -> bool {
        let _ = index;
        false
    }

    /// Why the run ends where the guard with this index passes zero in a step, if it does: at a pole, at the end of a domain.
    fn end(&self, index: usize) -> Option<Cause> {
        let _ = index;
        None
    }

    /// The condition with this index, as diagnostics name it.
    fn guard_name(&self, index: usize) -> &'static str {
        let _ = index;
        ""
    }

    /// All conditions as they were written, by index, for faults that name several.
    fn conditions(&self) -> &'static [&'static str] {
        &[]
    }

    /// The first time after `t` at which the rate is known to jump or to bend; steps end there.
    fn next_instant(&self, t: Self::S, u: &Self::U) -> Option<Self::S> {
        let _ = (t, u);
        None
    }

    /// Commits the time event at an instant that was reached, or that a parameter has moved: `u` gets the modes that apply from now on.
    /// It may reset the state, as [`switch`](Self::switch).
    ///
    /// # Errors
    /// As [`switch`](Self::switch).
    fn pass(&self, t: Self::S, u: &mut Self::U, x: &mut Self::X) -> Result<(), Fault> {
        let _ = (t, u, x);
        Ok(())
    }

    /// A jump that what is held demands: of rows whose condition has another side in `after` than in `u`; without that, of
    /// rows at whose boundary the state is.
    fn jump(&self, t: Self::S, u: &Self::U, x: &Self::X, after: Option<&Self::U>) -> Option<Fault> {
        let _ = (t, u, x, after);
        None
    }

    /// Energy at a state, where it can be accounted for: no motion is prescribed, whose drive would do work.
    fn energy(&self, t: Self::S, u: &Self::U, x: &Self::X) -> Option<Energy<Self::S>> {
        let _ = (t, u, x);
        None
    }

    /// Typical size of each state; with the relative tolerance it gives the absolute one: atol = rtol * typical.
    fn typical(&self) -> Self::X {
        Self::X::fill(Self::S::lit(1.0))
    }

    /// The decay rate alpha of Baumgarte's stabilisation, 1/s, where the system is stabilised by it.
    fn baumgarte_rate(&self) -> Option<f64> {
        None
    }

    /// The part that the state with this index belongs to, as diagnostics name it.
    fn part_of_state(&self, index: usize) -> &'static str {
        let _ = index;
        ""
    }

    /// The name of the state with this index, `arm.omega`; in charts, of the coordinate that it is in each.
    fn name_of_state(&self, index: usize) -> &'static str {
        self.part_of_state(index)
    }

    /// The name of the state with this index in the chart that `u` holds.
    fn name_in_chart(&self, u: &Self::U, index: usize) -> &'static str {
        let _ = u;
        self.name_of_state(index)
    }
}

/// A rate apart from the way that is taken: states are copied, so that those of that way stay in registers.
#[cold]
#[inline(never)]
pub fn rate_aside<M: Rate>(system: &M, t: M::S, u: &M::U, x: M::X) -> (M::X, Health<M::S>) {
    let mut dx = x;
    let health = system.rate(t, u, &x, &mut dx);
    (dx, health)
}

/// A step that was made, as those see it that look at steps.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a, M: System> {
    /// The equations.
    pub system: &'a M,
    /// What was held over it.
    pub held: &'a M::U,
    /// Time, s, and state where it began.
    pub from: (M::S, &'a M::X),
    /// Time, s, and state where it ended.
    pub to: (M::S, &'a M::X),
    /// The smallest pivot ratio of its rates, [`Health`].
    pub health: M::S,
}

/// What [`System::accept`] did to a state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Accepted {
    /// The state was mapped to another chart: rates that were kept belong to the old one.
    pub moved: bool,
    /// Angles were brought back by whole turns: what was kept of the state belongs to the old ones.
    pub turned: bool,
    /// A singular pose was passed, where the mechanism could have gone on in another way: the part that closes its loop.
    pub passed: Option<&'static str>,
}

/// Smallest pivot of a solution without pivoting, over its diagonal entry before elimination: 1 is perfect, 0 singular.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Health<S>(pub S);

impl<S: Scalar> Health<S> {
    /// Nothing could go wrong: no equation was solved.
    #[inline]
    #[must_use]
    pub fn perfect() -> Self {
        Self(S::lit(1.0))
    }

    /// Above [`Scalar::HEALTHY`] in every lane; false for NaN.
    #[inline]
    pub fn is_good(self) -> bool {
        S::all(S::lit(S::HEALTHY).lt(self.0))
    }

    /// The worse of two, lane by lane; `other` where it is NaN.
    #[inline]
    #[must_use]
    pub fn worst(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
}

/// What a mechanism stores and what flows in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy<S> {
    /// Kinetic energy, J.
    pub kinetic: S,
    /// Potential energy of gravity, J.
    pub gravity: S,
    /// Power of all other forces and torques, springs and dampers included, W.
    pub power: S,
}

/// Largest residuals of the constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift<S> {
    /// Of position, in m or rad.
    pub phi: S,
    /// Of velocity, in m/s or rad/s.
    pub phi_dot: S,
}

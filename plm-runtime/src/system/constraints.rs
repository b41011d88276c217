//! Constraints of a motion: projection, drift, charts, energy.

use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::{Computation, Drift, Energy, Health, Question, Rate, System, Updated};

/// Constraints phi(t, q) = 0 that the motion keeps, and how. Without any, all of it stays as it is here.
pub trait Constraints: Rate {
    /// Computes what a method asks for. A system that can be differentiated does so by [`linear::compute`](crate::linear::compute), which
    /// takes all derivatives of recorded numbers at once.
    #[allow(clippy::inline_always, reason = "it is the formula")]
    #[inline(always)]
    fn compute<C: Computation>(
        &self,
        times: (Self::S, Self::S),
        u: &Self::U,
        from: (&Self::X, &Self::X),
    ) -> (C::Made<Self::X>, Health<Self::S>)
    where
        Self: System + Sized,
    {
        C::of(self, times, u, from)
    }

    /// Answers what is decided by values. A system that can be differentiated does so by [`linear::ask`](crate::linear::ask), in numbers
    /// without derivatives.
    #[allow(clippy::inline_always, reason = "it is the question")]
    #[inline(always)]
    fn ask<Q: Question<Self::S>>(&self, u: &Self::U, question: Q) -> Q::Answer
    where
        Self: System<S: Real> + Sized,
    {
        question.of(self, u)
    }

    /// The rate where [`rate`](Rate::rate) is unhealthy: by a rank-revealing decomposition.
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
    fn project(&self, t: Self::S, u: &Self::U, x: &mut Self::X) -> Result<(), Fault> {
        let _ = (t, u, x);
        Ok(())
    }

    /// How far the state is from its constraints; zero where there is nothing to project.
    fn drift(&self, t: Self::S, u: &Self::U, x: &Self::X) -> Drift<Self::S> {
        let _ = (t, u, x);
        Drift { phi: Self::S::lit(0.0), phi_dot: Self::S::lit(0.0) }
    }

    /// The decay rate alpha of Baumgarte's stabilisation, 1/s, where the system is stabilised by it.
    fn baumgarte_rate(&self) -> Option<f64> {
        None
    }

    /// Can the rate be computed in the chart that `u` holds? Not near singular poses, where no chart is good.
    fn is_regular(&self, u: &Self::U) -> bool {
        let _ = u;
        true
    }

    /// Updates the discrete state after a step, for the next one: charts, branches of loops, revolutions.
    ///
    /// # Errors
    /// When the state cannot be the continuation of the one before. Methods with error control then
    /// try shorter steps; in the end the run stops with this fault and the state before the step.
    fn update(&self, t: Self::S, u: &mut Self::U, x: &mut Self::X) -> Result<Updated, Fault> {
        let _ = (t, u, x);
        Ok(Updated::default())
    }

    /// Do [runs](crate::Sim) ask [`is_settled`](Self::is_settled): is the discrete state so large that copies of it take a part of a step?
    const SETTLES: bool = false;

    /// Would [`update`](Self::update) find and change nothing after a step? False where that is not known.
    #[inline]
    fn is_settled(&self, t: Self::S, u: &Self::U, x: &Self::X) -> bool {
        let _ = (t, u, x);
        false
    }

    /// Energy at a state, where it can be accounted for: no motion is prescribed, whose drive would do work.
    fn energy(&self, t: Self::S, u: &Self::U, x: &Self::X) -> Option<Energy<Self::S>> {
        let _ = (t, u, x);
        None
    }
}

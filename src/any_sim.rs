//! A run whose method is known when the program runs.

use plm_runtime::method::{Gauss, RadauIia5, Ros34Pw2};
use plm_runtime::{
    Adams, Dop853, Dopri5, Linear, Mechanism, Method, Rk4, SemiImplicitEuler, Sim, System, Vern9,
};

/// A run by one of the methods of [`Integrator`](crate::integrator::Integrator), which starts it.
#[derive(Clone, Copy)]
#[allow(clippy::large_enum_variant, reason = "a run is copied as it is, and there is one of it")]
pub(crate) enum AnySim<M: Mechanism + Linear + System<S = f64>> {
    Dop853(Sim<M, Dop853<M>>),
    Vern9(Sim<M, Vern9<M>>),
    Adams(Sim<M, Adams<M>>),
    Dopri5(Sim<M, Dopri5<M>>),
    RadauIia5(Sim<M, RadauIia5<M>>),
    Rk4(Sim<M, Rk4<f64>>),
    SemiImplicitEuler(Sim<M, SemiImplicitEuler<f64>>),
    Gauss2(Sim<M, Gauss<M, 2>>),
    Gauss3(Sim<M, Gauss<M, 3>>),
    Ros34Pw2(Sim<M, Ros34Pw2<f64>>),
}

/// Work on a run, whatever its method.
pub(crate) trait OnSim<M: Mechanism> {
    type Output;

    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output;
}

/// Evaluates an expression on the run, whichever method it has.
macro_rules! each {
    ($any:expr, $sim:ident => $value:expr) => {
        match $any {
            Self::Dop853($sim) => $value,
            Self::Vern9($sim) => $value,
            Self::Adams($sim) => $value,
            Self::Dopri5($sim) => $value,
            Self::RadauIia5($sim) => $value,
            Self::Rk4($sim) => $value,
            Self::SemiImplicitEuler($sim) => $value,
            Self::Gauss2($sim) => $value,
            Self::Gauss3($sim) => $value,
            Self::Ros34Pw2($sim) => $value,
        }
    };
}

impl<M: Mechanism + Linear + System<S = f64>> AnySim<M> {
    /// Does something with it.
    pub(crate) fn then<W: OnSim<M>>(&mut self, work: W) -> W::Output {
        each!(self, sim => work.on(sim))
    }

    /// The place of its method among those of [`Integrator`](crate::integrator::Integrator).
    #[cfg(all(feature = "foreign", feature = "analysis"))]
    pub(crate) fn place(&self) -> usize {
        match self {
            Self::Dop853(_) => 0,
            Self::Vern9(_) => 1,
            Self::Adams(_) => 2,
            Self::Dopri5(_) => 3,
            Self::RadauIia5(_) => 4,
            Self::Rk4(_) => 5,
            Self::SemiImplicitEuler(_) => 6,
            Self::Gauss2(_) => 7,
            Self::Gauss3(_) => 8,
            Self::Ros34Pw2(_) => 9,
        }
    }

    /// Shows the words of the run.
    #[cfg(all(feature = "foreign", feature = "analysis"))]
    pub(crate) fn show(&mut self, words: &mut impl plm_runtime::words::Words)
    where
        M: plm_foreign::Foreign,
    {
        use plm_runtime::words::InWords as _;
        each!(self, sim => sim.each(words));
    }

    /// The mechanism at the current moment.
    #[cfg(feature = "analysis")]
    pub(crate) fn state(&self) -> &M::State {
        each!(self, sim => sim.state())
    }
}

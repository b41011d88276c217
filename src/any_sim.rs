//! A run whose method is known when the program runs.

use plm_runtime::{Linear, Mechanism, Method, Sim, System, methods};

/// What is done with a run, whatever its method.
pub(crate) trait OnSim<M: Mechanism> {
    type Output;

    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output;
}

/// Makes a run by any method of the catalogue.
macro_rules! any_sim {
    (by_error { $($a:ident ($i:literal, $c:literal, $m:ty, $t:literal, $rtol:literal, $d:literal, $w:literal))* }
     of_length { $($b:ident ($j:literal, $k:literal, $n:ty, $u:literal, $e:literal, $x:literal))* }) => {
        /// A run by one of the methods of [`Integrator`](crate::integrator::Integrator), which starts it.
        #[derive(Clone, Copy)]
        #[allow(clippy::large_enum_variant, reason = "a run is copied as it is, and there is one of it")]
        pub(crate) enum AnySim<M: Mechanism + Linear + System<S = f64>> {
            $($a(Sim<M, $m>),)*
            $($b(Sim<M, $n>),)*
        }

        impl<M: Mechanism + Linear + System<S = f64>> AnySim<M> {
            /// The number of its method in the catalogue.
            #[cfg(all(feature = "foreign", feature = "analysis"))]
            pub(crate) fn number(&self) -> u64 {
                match self {
                    $(Self::$a(_) => $i,)*
                    $(Self::$b(_) => $j,)*
                }
            }
        }
    };
}

methods!(any_sim);

/// The same of whichever it is.
macro_rules! each {
    ([$any:expr, $sim:ident => $value:expr]
     by_error { $($a:ident $of_a:tt)* } of_length { $($b:ident $of_b:tt)* }) => {
        match $any {
            $(AnySim::$a($sim) => $value,)*
            $(AnySim::$b($sim) => $value,)*
        }
    };
}

impl<M: Mechanism + Linear + System<S = f64>> AnySim<M> {
    /// Does something with it.
    pub(crate) fn then<W: OnSim<M>>(&mut self, work: W) -> W::Output {
        methods!(each [self, sim => work.on(sim)])
    }

    /// Shows the words of the run.
    #[cfg(all(feature = "foreign", feature = "analysis"))]
    pub(crate) fn show(&mut self, words: &mut impl plm_runtime::words::Words)
    where
        M: plm_foreign::Foreign,
    {
        use plm_runtime::words::InWords as _;
        methods!(each [self, sim => sim.each(words)]);
    }

    /// The mechanism at the current moment.
    #[cfg(feature = "analysis")]
    pub(crate) fn state(&self) -> &M::State {
        methods!(each [self, sim => sim.state()])
    }
}

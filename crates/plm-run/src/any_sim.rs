//! A run whose method is known when the program runs.

use plm_runtime::words::{InWords, Words};
use plm_runtime::{Described, Linear, Mechanism, Method, Sim, Statics, System, methods};

use crate::Integrator;

/// Work on a run, whatever its method.
pub trait OnSim<M: Mechanism> {
    /// Result of the work.
    type Output;

    /// Does it.
    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output;
}

/// Makes a run by any method of the catalogue.
macro_rules! any_sim {
    (by_error { $($a:ident ($i:literal, $c:literal, $m:ty, $t:literal, $rtol:literal, $d:literal, $w:literal))* }
     of_length { $($b:ident ($j:literal, $k:literal, $n:ty, $u:literal, $e:literal, $x:literal))* }) => {
        /// A run by one of the methods of [`Integrator`], which starts it.
        #[derive(Clone, Copy)]
        #[allow(clippy::large_enum_variant, reason = "a run is copied as it is, and there is one of it")]
        pub enum AnySim<M: Mechanism + Linear + System<S = f64>> {
            $(#[doc = concat!("By ", $d, ".")] $a(Sim<M, $m>),)*
            $(#[doc = concat!("By ", $e, ".")] $b(Sim<M, $n>),)*
        }

        impl<M: Mechanism + Linear + System<S = f64>> AnySim<M> {
            /// The number of its method in the catalogue.
            fn number(&self) -> u64 {
                match self {
                    $(Self::$a(_) => $i,)*
                    $(Self::$b(_) => $j,)*
                }
            }
        }
    };
}

methods!(any_sim);

/// Evaluates an expression on the run, whichever method it has.
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
    pub fn then<W: OnSim<M>>(&mut self, work: W) -> W::Output {
        methods!(each [self, sim => work.on(sim)])
    }

    /// The mechanism at the current moment.
    pub fn state(&self) -> &M::State {
        methods!(each [self, sim => sim.state()])
    }
}

/// The method's number in the catalogue, then the run by it. What is read into a run by another method becomes one by that.
impl<M> InWords for AnySim<M>
where
    M: Described + Statics + Linear + System<S = f64, U: InWords>,
{
    fn each(&mut self, words: &mut impl Words) {
        let own = self.number();
        let mut number = own;
        words.word(&mut number);
        let read = Some(number).filter(|number| *number != own);
        if let Some(method) = read.and_then(Integrator::numbered) {
            *self = method.of(*self.state());
        }
        methods!(each [self, sim => sim.each(words)]);
    }
}

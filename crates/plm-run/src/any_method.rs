//! A method that is known when the program runs.

use plm_runtime::contact::Change;
use plm_runtime::method::{
    Context, DenseOutput, DriftCheck, ErrorControl, Estimate, FastStep, FixedLength, Length, Path,
};
use plm_runtime::system::Drift;
use plm_runtime::words::{InWords, Words};
use plm_runtime::{Fault, Linear, Method, Scalar, Stats, methods};

use crate::Integrator;

/// Makes the enumeration, and the way from a name to a method.
macro_rules! any_method {
    (by_error { $($a:ident ($i:literal, $c:literal, $m:ty, $t:literal, $rtol:literal, $d:literal, $w:literal))* }
     of_length { $($b:ident ($j:literal, $k:literal, $n:ty, $u:literal, $e:literal, $x:literal))* }) => {
        /// One of the methods of [`Integrator`], which makes it. A run by it has the bits of a run by the method itself, and a program
        /// has the code of a run once, not once for each method.
        #[derive(Clone)]
        #[allow(clippy::large_enum_variant, reason = "a run has one method, and stands on the heap as a whole")]
        pub enum AnyMethod<M: Linear> {
            $(#[doc = concat!("By ", $d, ".")] $a($m),)*
            $(#[doc = concat!("By ", $e, ".")] $b($n),)*
        }

        impl<M: Linear> AnyMethod<M> {
            /// A method of the catalogue.
            pub(crate) fn of(integrator: Integrator) -> Self {
                match integrator {
                    $(Integrator::$a(rtol) => Self::$a(<$m>::new(M::S::lit(rtol))),)*
                    $(Integrator::$b(h) => Self::$b(<$n>::new(M::S::lit(h))),)*
                }
            }

            /// Its number in the catalogue.
            fn number(&self) -> u64 {
                match self {
                    $(Self::$a(_) => $i,)*
                    $(Self::$b(_) => $j,)*
                }
            }
        }

        $(impl<M: Linear> From<$m> for AnyMethod<M> {
            fn from(method: $m) -> Self {
                Self::$a(method)
            }
        })*

        $(impl<M: Linear> From<$n> for AnyMethod<M> {
            fn from(method: $n) -> Self {
                Self::$b(method)
            }
        })*
    };
}

methods!(any_method);

/// Evaluates an expression on the method, whichever it is.
macro_rules! each {
    ([$any:expr, $method:ident => $value:expr]
     by_error { $($a:ident $of_a:tt)* } of_length { $($b:ident $of_b:tt)* }) => {
        match $any {
            $(AnyMethod::$a($method) => $value,)*
            $(AnyMethod::$b($method) => $value,)*
        }
    };
}

/// Makes a method of the method, whichever it is.
macro_rules! map {
    ([$any:expr, $method:ident => $value:expr]
     by_error { $($a:ident $of_a:tt)* } of_length { $($b:ident $of_b:tt)* }) => {
        match $any {
            $(AnyMethod::$a($method) => AnyMethod::$a($value),)*
            $(AnyMethod::$b($method) => AnyMethod::$b($value),)*
        }
    };
}

impl<M: Linear + Copy> Method<M> for AnyMethod<M> {
    fn name(&self) -> &'static str {
        methods!(each [self, method => Method::<M>::name(method)])
    }

    fn length(&self) -> Length {
        methods!(each [self, method => Method::<M>::length(method)])
    }

    fn change(&self) -> Change {
        methods!(each [self, method => Method::<M>::change(method)])
    }

    fn begin(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        methods!(each [self, method => method.begin(context)])
    }

    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        methods!(each [self, method => method.advance(context)])
    }

    fn restart(&mut self) {
        methods!(each [self, method => Method::<M>::restart(method)]);
    }

    fn turned(&mut self) {
        methods!(each [self, method => Method::<M>::turned(method)]);
    }

    fn fresh(&self) -> Self {
        methods!(map [self, method => Method::<M>::fresh(method)])
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        methods!(each [self, method => method.drift_limit(system)])
    }
}

impl<M: Linear + Copy> DenseOutput<M> for AnyMethod<M> {
    fn is_dense(&self) -> bool {
        methods!(each [self, method => DenseOutput::<M>::is_dense(method)])
    }

    fn densify(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        methods!(each [self, method => method.densify(context)])
    }

    fn derive(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        methods!(each [self, method => method.derive(context)])
    }

    fn interpolate(&self, time: M::S) -> M::X {
        methods!(each [self, method => DenseOutput::<M>::interpolate(method, time)])
    }

    fn path(&self) -> Option<Path<M::S, M::X>> {
        methods!(each [self, method => DenseOutput::<M>::path(method)])
    }

    fn moment(&self, context: &Context<'_, M>, time: M::S) -> (M::U, M::X) {
        methods!(each [self, method => method.moment(context, time)])
    }
}

impl<M: Linear + Copy> ErrorControl<M> for AnyMethod<M> {
    fn tolerance(&self) -> Option<M::S> {
        methods!(each [self, method => ErrorControl::<M>::tolerance(method)])
    }

    fn most_steps(&self) -> u64 {
        methods!(each [self, method => ErrorControl::<M>::most_steps(method)])
    }

    fn shorten(&mut self, h: M::S) -> bool {
        methods!(each [self, method => ErrorControl::<M>::shorten(method, h)])
    }

    fn limited_by(&self, system: &M) -> Option<usize> {
        methods!(each [self, method => method.limited_by(system)])
    }
}

impl<M: Linear + Copy> FixedLength<M> for AnyMethod<M> {
    fn is_fast(&self) -> bool {
        methods!(each [self, method => FixedLength::<M>::is_fast(method)])
    }

    fn fast_step(&self, of: (&M, &M::U), times: (M::S, M::S), x: &mut M::X) -> Option<FastStep<M::S>> {
        methods!(each [self, method => method.fast_step(of, times, x)])
    }

    fn next_time(&self) -> Option<M::S> {
        methods!(each [self, method => FixedLength::<M>::next_time(method)])
    }

    fn estimate(&self) -> Estimate<M::S> {
        methods!(each [self, method => FixedLength::<M>::estimate(method)])
    }

    fn estimate_of(&self, of: (&M, &M::U), times: (M::S, M::S), ends: [&M::X; 2]) -> Estimate<M::S> {
        methods!(each [self, method => method.estimate_of(of, times, ends)])
    }

    fn is_long(&self, of: (&M, &Stats), h: M::S, ends: [&M::X; 2]) -> bool {
        methods!(each [self, method => method.is_long(of, h, ends)])
    }

    fn drift_check(&self, system: &M) -> DriftCheck<M::S> {
        methods!(each [self, method => method.drift_check(system)])
    }

    fn keep(&mut self, drifted: bool) {
        methods!(each [self, method => FixedLength::<M>::keep(method, drifted)]);
    }

    fn shorter(&self, longest: M::S) -> Option<Self> {
        Some(methods!(map [self, method => FixedLength::<M>::shorter(method, longest)?]))
    }
}

/// The method's number in the catalogue, then its numbers. What is read into another method becomes the one that was written.
impl<M: Linear> InWords for AnyMethod<M> {
    fn each(&mut self, words: &mut impl Words) {
        let own = self.number();
        let mut number = own;
        words.word(&mut number);
        if let Some(method) = Some(number).filter(|number| *number != own).and_then(Integrator::numbered) {
            *self = Self::of(method);
        }
        methods!(each [self, method => method.each(words)]);
    }
}

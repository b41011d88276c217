//! Runs by a method that is chosen while a program runs, among those that its library has.
//!
//! The list of methods is a type that the library names, so that the library has the code of no other method.

use plm_runtime::words::{InWords, Words};
use plm_runtime::{Fault, Method, Scalar, Sim};

use crate::ffi::BlockBy;
use crate::{Error, Foreign, Status};

/// Makes the enumeration and what belongs to each method of the catalogue.
macro_rules! methods {
    (by_error { $($a:ident ($i:literal, $c:literal, $m:ty, $t:literal, $rtol:literal, $d:literal, $w:literal))* }
     of_length { $($b:ident ($j:literal, $k:literal, $n:ty, $u:literal, $e:literal, $x:literal))* }) => {
        /// A method of integration.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(i32)]
        pub enum By {
            $(#[doc = $d] $a = $i,)*
            $(#[doc = $e] $b = $j,)*
        }

        impl By {
            /// All of them.
            pub const ALL: [Self; [$($i,)* $($j,)*].len()] = [$(Self::$a,)* $(Self::$b,)*];

            /// Its names.
            pub fn called(self) -> Called {
                let (rust, c, kind, words) = match self {
                    $(Self::$a => (stringify!($a), $c, $t, $w),)*
                    $(Self::$b => (stringify!($b), $k, $u, $x),)*
                };
                Called { rust, c, kind, words }
            }

            /// Bytes of an object with runs by this method alone, and what its address is a multiple of.
            pub(crate) fn room<M: Foreign>(self) -> (usize, usize) {
                fn of<M: Foreign, I: Chosen<M>>() -> (usize, usize) {
                    (BlockBy::<M, Sim<M, I>>::SIZE, BlockBy::<M, Sim<M, I>>::ALIGN)
                }
                match self {
                    $(Self::$a => of::<M, $m>(),)*
                    $(Self::$b => of::<M, $n>(),)*
                }
            }
        }

        $(impl<M: Foreign> Chosen<M> for $m {
            const BY: By = By::$a;

            fn of(choice: &Choice) -> Self {
                let mut method = Self::default();
                Chosen::<M>::take(&mut method, choice);
                method
            }

            fn take(&mut self, choice: &Choice) {
                let own = Self::default().rtol;
                self.rtol = if choice.rtol.is_nan() { own } else { M::S::lit(choice.rtol) };
                self.longest_step = M::S::lit(choice.longest_step);
            }
        })*

        $(impl<M: Foreign> Chosen<M> for $n {
            const BY: By = By::$b;

            fn of(choice: &Choice) -> Self {
                Self::new(M::S::lit(choice.longest_step))
            }

            fn take(&mut self, choice: &Choice) {
                self.longest_step = M::S::lit(choice.longest_step);
            }
        })*
    };
}

plm_runtime::methods!(methods);

/// Names of a method.
pub struct Called {
    /// In Rust, and by `--method`.
    pub rust: &'static str,
    /// In C, after `PLM_`.
    pub c: &'static str,
    /// Its type, for numbers `REAL` of a mechanism `OWN`.
    pub(crate) kind: &'static str,
    /// Description of the method.
    pub(crate) words: &'static str,
}

impl By {
    /// The method with this number.
    ///
    /// # Errors
    /// [`Status::Choice`]
    pub fn of(number: i32) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|by| *by as i32 == number).ok_or(Status::Choice.into())
    }
}

/// A method with its options.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// The method.
    pub by: By,
    /// Relative tolerance, where steps are chosen by their error; not a number where the method's own is taken.
    pub rtol: f64,
    /// Longest step, s; of a method with steps of fixed length that length, or infinite: one step an interval.
    pub longest_step: f64,
}

impl InWords for Choice {
    fn each(&mut self, words: &mut impl Words) {
        let mut number = self.by as u64;
        words.word(&mut number);
        let read = i32::try_from(number).ok().and_then(|number| By::of(number).ok());
        self.by = read.unwrap_or(self.by);
        words.numbers([&mut self.rtol, &mut self.longest_step]);
    }
}

/// A method that can be chosen.
pub trait Chosen<M: Foreign>: Method<M> + InWords {
    /// Which it is.
    const BY: By;

    /// With options, before its first step.
    fn of(choice: &Choice) -> Self;

    /// Takes other options.
    fn take(&mut self, choice: &Choice);
}

/// A run by one of several methods.
pub trait Run<M: Foreign>: Clone + InWords {
    /// The usual method, with which an object begins.
    const USUAL: By;
    /// A number of the methods and of their order: objects of other ones have other bytes.
    const METHODS: u64;

    /// Is this method among them?
    fn has(by: By) -> bool;

    /// A run from a state; none where the method is not among these.
    fn new(state: M::State, choice: &Choice) -> Option<Self>;

    /// The method of this run.
    fn by(&self) -> By;

    /// The mechanism at the current moment.
    fn state(&self) -> &M::State;

    /// The state, to be changed; the next step checks what was changed.
    fn state_mut(&mut self) -> &mut M::State;

    /// Takes other options of its method.
    fn take(&mut self, choice: &Choice);

    /// [`Sim::step`]
    ///
    /// # Errors
    /// As [`Sim::step`].
    fn step(&mut self, dt: M::S) -> Result<(), Fault>;

    /// [`Sim::step_to`]
    ///
    /// # Errors
    /// As [`Sim::step_to`].
    fn step_to(&mut self, until: M::S) -> Result<(), Fault>;
}

impl<M: Foreign, I: Chosen<M>> Run<M> for Sim<M, I> {
    const USUAL: By = I::BY;
    const METHODS: u64 = I::BY as u64 + 1;

    fn has(by: By) -> bool {
        by == I::BY
    }

    fn new(state: M::State, choice: &Choice) -> Option<Self> {
        (choice.by == I::BY).then(|| Sim::new(state, I::of(choice)))
    }

    fn by(&self) -> By {
        I::BY
    }

    fn state(&self) -> &M::State {
        Sim::state(self)
    }

    fn state_mut(&mut self) -> &mut M::State {
        self
    }

    fn take(&mut self, choice: &Choice) {
        self.method_mut().take(choice);
    }

    fn step(&mut self, dt: M::S) -> Result<(), Fault> {
        Sim::step(self, dt)
    }

    fn step_to(&mut self, until: M::S) -> Result<(), Fault> {
        Sim::step_to(self, until)
    }
}

/// A run by a method of `A`, or by one of `B`: so a list of methods becomes a type, and a library has the code of no other.
#[derive(Clone, Copy)]
pub enum Either<A, B> {
    /// The first.
    This(A),
    /// One of the others.
    That(B),
}

/// Evaluates an expression on the run, whichever method it has.
macro_rules! whichever {
    ($either:expr, $run:ident => $value:expr) => {
        match $either {
            Self::This($run) => $value,
            Self::That($run) => $value,
        }
    };
}

impl<M: Foreign, A: Run<M>, B: Run<M>> Run<M> for Either<A, B> {
    const USUAL: By = A::USUAL;
    const METHODS: u64 = A::METHODS.wrapping_mul(0x0100_0000_01b3) ^ B::METHODS.rotate_left(17);

    fn has(by: By) -> bool {
        A::has(by) || B::has(by)
    }

    fn new(state: M::State, choice: &Choice) -> Option<Self> {
        A::new(state, choice).map(Self::This).or_else(|| B::new(state, choice).map(Self::That))
    }

    fn by(&self) -> By {
        whichever!(self, run => run.by())
    }

    fn state(&self) -> &M::State {
        whichever!(self, run => run.state())
    }

    fn state_mut(&mut self) -> &mut M::State {
        whichever!(self, run => run.state_mut())
    }

    fn take(&mut self, choice: &Choice) {
        whichever!(self, run => run.take(choice));
    }

    fn step(&mut self, dt: M::S) -> Result<(), Fault> {
        whichever!(self, run => run.step(dt))
    }

    fn step_to(&mut self, until: M::S) -> Result<(), Fault> {
        whichever!(self, run => run.step_to(until))
    }
}

impl<A: InWords, B: InWords> InWords for Either<A, B> {
    fn each(&mut self, words: &mut impl Words) {
        whichever!(self, run => run.each(words));
    }
}

//! Providers of the rates that a formula needs.

use core::fmt::Debug;

use crate::scalar::Scalar as _;
use crate::system::{Computation, Health, Rate, System};

/// Rates at the stages of a formula.
///
/// If a rate is short ([`Rate::SHORT`]), formulas contain a copy of it for every stage: numbers stay in registers, and compilers do not
/// pack positions with velocities into vectors, which would make the pose of a stage wait for an acceleration that it does not need. A
/// closure would not suffice, since nothing can demand that it is copied.
pub trait Rates<M: Rate> {
    /// Writes the rate `dx` at `(t, x)`.
    fn at(&mut self, t: M::S, x: &M::X, dx: &mut M::X);

    /// Writes two rates as [`Rate::rate_pair`] does.
    #[allow(clippy::inline_always, reason = "as the formulas")]
    #[inline(always)]
    fn pair(
        &mut self,
        [t, later]: [M::S; 2],
        [x, _]: [&M::X; 2],
        [first, last]: &mut [M::X; 2],
        second: impl FnOnce(&M::X) -> M::X,
    ) {
        self.at(t, x, first);
        self.at(later, &second(first), last);
    }
}

/// Repeats a body for the stages of a formula, whose numbers follow each other: a copy of it for each if `short`, otherwise a loop. The
/// loop is over a range, of which compilers know that it stays within an array; numbers in memory could be any. Both are constants of the
/// types, and only the chosen one is compiled, in builds without optimisation too. For formulas of any number of stages, there is a copy
/// for each stage below that number.
macro_rules! each_stage {
    ($short:expr, $stage:ident in [$first:literal $(, $number:literal)*] $body:block) => {
        if const { $short } {
            {
                let $stage = $first;
                $body
            }
            $({
                let $stage = $number;
                $body
            })*
        } else {
            for $stage in $first..$first + [$first $(, $number)*].len() $body
        }
    };
    ($stage:ident < $count:ident in [$($number:literal),*] $body:block) => {
        $(if const { $number < $count } {
            let $stage = $number;
            $body
        })*
    };
}
pub(crate) use each_stage;

impl<M: Rate, F: FnMut(M::S, &M::X, &mut M::X)> Rates<M> for F {
    #[inline]
    fn at(&mut self, t: M::S, x: &M::X, dx: &mut M::X) {
        self(t, x, dx);
    }
}

/// Rates of a system, without a second attempt if they are unhealthy.
pub(crate) struct Watched<'a, M: Rate> {
    system: &'a M,
    held: &'a M::U,
    /// The worst health so far.
    pub(crate) worst: Health<M::S>,
}

impl<'a, M: Rate> Watched<'a, M> {
    pub(crate) fn new(system: &'a M, held: &'a M::U) -> Self {
        Self { system, held, worst: Health::perfect() }
    }
}

impl<M: Rate> Rates<M> for &mut Watched<'_, M> {
    #[allow(clippy::inline_always, reason = "what it holds stays in registers only within its caller")]
    #[inline(always)]
    fn at(&mut self, t: M::S, x: &M::X, dx: &mut M::X) {
        self.worst = self.worst.worst(self.system.rate(t, self.held, x, dx));
    }

    #[allow(clippy::inline_always, reason = "as above")]
    #[inline(always)]
    fn pair(&mut self, t: [M::S; 2], x: [&M::X; 2], dx: &mut [M::X; 2], second: impl FnOnce(&M::X) -> M::X) {
        self.worst = self.worst.worst(self.system.rate_pair(t, self.held, x, dx, second));
    }
}

/// Rate at a state: one vector with derivatives, or none.
struct OfState<const VECTORS: usize>;

impl<const VECTORS: usize> Computation for OfState<VECTORS> {
    type Made<X: Copy + Debug> = X;
    const VECTORS: usize = VECTORS;
    const FROM_RATE: bool = false;

    #[inline]
    fn map<X: Copy + Debug, Y: Copy + Debug>(made: &X, blank: Y, mut each: impl FnMut(&X, &mut Y)) -> Y {
        let mut own = blank;
        each(made, &mut own);
        own
    }

    #[allow(clippy::inline_always, reason = "it is the rate")]
    #[inline(always)]
    fn of<M: System>(
        system: &M,
        (t, _): (M::S, M::S),
        u: &M::U,
        (x, _): (&M::X, &M::X),
    ) -> (M::X, Health<M::S>) {
        let mut rate = *x;
        let health = system.rate(t, u, x, &mut rate);
        (rate, health)
    }
}

/// Rate of a system at a state; recorded numbers take its derivatives at once.
#[allow(clippy::inline_always, reason = "it is the rate")]
#[inline(always)]
pub(super) fn evaluate<M: System>(
    (system, held): (&M, &M::U),
    t: M::S,
    x: &M::X,
    dx: &mut M::X,
) -> Health<M::S> {
    if M::S::AT_ONCE.has_rates() {
        let (rate, health) = system.compute::<OfState<1>>((t, M::S::ZERO), held, (x, x));
        *dx = rate;
        return health;
    }
    system.rate(t, held, x, dx)
}

/// Rate of recorded numbers as values: later computations find derivatives by themselves.
#[inline(never)]
pub(super) fn value<M: System>(
    (system, held): (&M, &M::U),
    t: M::S,
    x: &M::X,
    dx: &mut M::X,
) -> Health<M::S> {
    let (rate, health) = system.compute::<OfState<0>>((t, M::S::ZERO), held, (x, x));
    *dx = rate;
    health
}

/// Rates of a system by [`evaluate`], without a second attempt if they are unhealthy.
pub(crate) struct Evaluated<'a, M: System> {
    system: &'a M,
    held: &'a M::U,
    /// The worst health so far.
    pub(crate) worst: Health<M::S>,
}

impl<'a, M: System> Evaluated<'a, M> {
    pub(crate) fn new(system: &'a M, held: &'a M::U) -> Self {
        Self { system, held, worst: Health::perfect() }
    }
}

impl<M: System> Rates<M> for &mut Evaluated<'_, M> {
    #[allow(clippy::inline_always, reason = "as `Watched`")]
    #[inline(always)]
    fn at(&mut self, t: M::S, x: &M::X, dx: &mut M::X) {
        self.worst = self.worst.worst(evaluate((self.system, self.held), t, x, dx));
    }

    #[allow(clippy::inline_always, reason = "as `Watched`")]
    #[inline(always)]
    fn pair(&mut self, t: [M::S; 2], x: [&M::X; 2], dx: &mut [M::X; 2], second: impl FnOnce(&M::X) -> M::X) {
        if M::S::AT_ONCE.has_rates() {
            let ([t, later], [x, _], [first, last]) = (t, x, dx);
            self.at(t, x, first);
            self.at(later, &second(first), last);
            return;
        }
        self.worst = self.worst.worst(self.system.rate_pair(t, self.held, x, dx, second));
    }
}

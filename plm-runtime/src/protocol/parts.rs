//! Steps of a fixed formula that are made in parts, where one is too long for a sharp turn or for the loops.

use super::advance::{Advance, Made, SHORTEST_ULPS};
use super::near_singular::Rescue;
use super::observer::Observer;
use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::method::Method;
use crate::scalar::{Real, Scalar};
use crate::tolerances::MOST_PARTS;

/// A step that will be made in parts.
pub(crate) struct Parts<S> {
    /// Its end, s.
    pub(super) until: S,
    /// Least number of parts.
    pub(super) count: u32,
    /// The fault of the step, if it had one: then parts help, or the near-singular method.
    pub(super) fault: Option<Fault>,
}

impl<M: Mechanism, I: Method<M>, O: Observer<M>> Advance<'_, '_, M, I, O> {
    /// Makes a step that is too long, in shorter steps of the same formula. A part that is too long has parts of its own; what follows it is
    /// made in parts of twice their length, up to the first one.
    #[cold]
    pub(super) fn split(&mut self, parts: Parts<M::S>) -> Made<M::S> {
        self.context.stats.divided += u64::from(parts.fault.is_some());
        let (whole, end, told) = (self.context.end, parts.until, parts.fault);
        let first = (end - self.context.time) / M::S::lit(f64::from(parts.count));
        // After a fault the work of a step is bounded, beside that of the near-singular method.
        let shortest = (end - self.context.time) / M::S::lit(MOST_PARTS);
        let (mut made, mut longest) = (Made::Split(parts), first);
        loop {
            longest = match made {
                Made::Split(Parts { until, count, fault }) => {
                    let longest = (until - self.context.time) / M::S::lit(f64::from(count));
                    if let Some(fault) = fault.filter(|_| longest < shortest) {
                        // The step was too long, not its part.
                        made = Made::Failed(told.unwrap_or(fault));
                        break;
                    }
                    self.context.end = until;
                    longest
                }
                Made::Step if self.context.time < end => {
                    self.context.end = end;
                    first.min(longest + longest)
                }
                _ => break,
            };
            let moves = longest > M::S::lit(SHORTEST_ULPS) * M::S::EPSILON * end.abs();
            made = match self.method.shorter(longest).filter(|_| moves) {
                Some(mut finer) => self.with(&mut finer, self.guarded.limits).follow(),
                None if M::Rescue::take(self.context) => Made::NearSingular,
                None => Made::Failed(self.context.fault(Cause::NotRegular)),
            };
        }
        self.go_back_to(whole, made)
    }

    /// Divides the rest of the interval to `end` anew, after a step that was made in parts.
    pub(super) fn go_back_to(&mut self, end: M::S, made: Made<M::S>) -> Made<M::S> {
        self.context.end = end;
        self.method.restart();
        if let (Made::Step, true) = (&made, self.context.time < end)
            && let Err(fault) = self.method.begin(self.context)
        {
            return Made::Failed(fault);
        }
        made
    }

    /// Makes steps to the end of the interval, until one is refused or only the near-singular method can continue.
    fn follow(&mut self) -> Made<M::S> {
        if let Err(fault) = self.begin().and_then(|()| self.method.begin(self.context)) {
            return Made::Failed(fault);
        }
        while self.context.time < self.context.end {
            if M::Rescue::holds(self.context) {
                return Made::NearSingular;
            }
            match self.step() {
                Made::Step | Made::Shortened => {}
                Made::Cut(cut) => match self.make_cut(&cut) {
                    Made::Step => {}
                    refused => return refused,
                },
                refused => return refused,
            }
        }
        Made::Step
    }
}

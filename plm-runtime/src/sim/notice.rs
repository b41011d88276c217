//! Notices of a simulation.

use core::fmt;

use super::{Sim, Snapshot};
use crate::contact::Counts;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::stats::Stats;

/// The state and what was done; a method has hundreds of numbers of its own.
impl<M: Mechanism<State: fmt::Debug>, I> fmt::Debug for Sim<M, I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut sim = f.debug_struct("Sim");
        sim.field("state", &self.state).field("stats", &self.stats).finish_non_exhaustive()
    }
}

impl<M: Mechanism<State: fmt::Debug>, I> fmt::Debug for Snapshot<M, I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Snapshot").field(&self.0).finish()
    }
}

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// The first of what the user should know of the motion although the run goes on.
    pub fn notice(&self) -> Option<Notice> {
        // Of undetermined forces the motion knows nothing.
        Self::notices(self).find(|notice| !matches!(notice, Notice::UndeterminedContact { .. }))
    }

    /// All that the user should know although the run goes on, what weighs most first. To be called as `Sim::notices(&sim)`, so that it
    /// hides no output of this name.
    pub fn notices(this: &Self) -> impl Iterator<Item = Notice> + use<M, I> {
        let stats = this.stats();
        let alpha = this.state.mechanism().baumgarte_rate().unwrap_or_default();
        let h_alpha = stats.longest_step * alpha;
        let conditions = stats.passed_over;
        let first = [
            (h_alpha > 0.5).then_some(Notice::StiffStabilisation { h_alpha }),
            Notice::of_errors(&stats),
            (conditions > 0).then_some(Notice::PassedOver { conditions }),
        ];
        let contact = Notice::of_contacts(&this.contact_stats(), this.is_undetermined());
        first.into_iter().chain(contact).flatten()
    }
}

/// Something that the user should know although the run goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Notice {
    /// The longest step times Baumgarte's decay rate is above 0.5: the stabilisation costs accuracy (and above 2.785
    /// Runge-Kutta 4 is unstable). Shorten the step or lengthen the time constant.
    StiffStabilisation {
        /// Step times decay rate.
        h_alpha: f64,
    },
    /// Conditions came and went within steps of equal length, which passed over them: shorter steps, or a method with dense
    /// output, which ends a step there.
    PassedOver {
        /// How often.
        conditions: u64,
    },
    /// Contact rows went on in one of several ways, at each of which all laws of contact are satisfied: the motion from there on is
    /// one of several, as with large coefficients of friction.
    AmbiguousContact {
        /// At how many events.
        events: u64,
    },
    /// Impacts had one of several outcomes, each of which satisfies all laws: the motion from there on is one of several. So may corners,
    /// and several gaps that close at once by sequential impacts.
    AmbiguousImpact {
        /// At how many events.
        events: u64,
    },
    /// Impacts whose impulses several rows may share in many ways, as a stop and a friction beside it: what a restitution gives back depends
    /// on the share, so that the motion from there on is one of many.
    UndeterminedImpact {
        /// At how many events.
        events: u64,
    },
    /// More contact rows rest than there are freedoms: the motion is unique, but pushes, frictions and reactions are one of many
    /// solutions, as at a table on four legs.
    UndeterminedContact {
        /// From how many events on.
        events: u64,
    },
    /// Steps of fixed length are so long that a step errs by more than three thousandths of the size of a state, or all of them together
    /// by more than a tenth: the motion is a rough one, and may be another one. Shorter steps, or a method that chooses them by
    /// their error. Both are estimates of what the steps add; what a motion makes of that may be more or less.
    LongSteps {
        /// The largest error of a step, as a share of the size of a state.
        largest: f64,
        /// The sum of those of all steps, as such a share.
        sum: f64,
        /// The longest step, s.
        step: f64,
    },
}

impl Notice {
    /// What steps of fixed length were off by, where that is worth to be told.
    fn of_errors(stats: &Stats) -> Option<Self> {
        let Stats { largest_error: largest, errors: sum, longest_step: step, .. } = *stats;
        (largest >= LARGE || sum >= SUM).then_some(Self::LongSteps { largest, sum, step })
    }

    /// What contacts have left open, where they have; `is_undetermined` says so of the present modes.
    fn of_contacts(counts: &Counts, is_undetermined: bool) -> [Option<Self>; 4] {
        let Counts { ambiguous, ambiguous_impacts, undetermined_impacts, .. } = *counts;
        // The modes of a start are no event.
        let undetermined = counts.undetermined.max(u64::from(is_undetermined));
        let told = |events: u64, notice| (events > 0).then_some(notice);
        [
            told(ambiguous, Self::AmbiguousContact { events: ambiguous }),
            told(ambiguous_impacts, Self::AmbiguousImpact { events: ambiguous_impacts }),
            told(undetermined_impacts, Self::UndeterminedImpact { events: undetermined_impacts }),
            told(undetermined, Self::UndeterminedContact { events: undetermined }),
        ]
    }
}

/// A step is told that errs by this share of a state: estimates are right to a factor of three, and a run that is right to a
/// thousandth is silent, ...
const LARGE: f64 = 3e-3;
/// ... and a run whose steps do so together.
const SUM: f64 = 0.1;

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StiffStabilisation { h_alpha } => write!(
                f,
                "the longest step times the decay rate of Baumgarte's stabilisation is {h_alpha:.2}: it costs accuracy; \
                 shorter steps, or a longer time constant"
            ),
            Self::PassedOver { conditions } => write!(
                f,
                "conditions came and went within steps of equal length, {conditions} times: shorter steps, or a method \
                 with dense output"
            ),
            Self::AmbiguousContact { events } => write!(
                f,
                "contacts could go on in several ways that satisfy all their laws, at {events} events: the motion is one of \
                 several"
            ),
            Self::AmbiguousImpact { events } => write!(
                f,
                "impacts could end in several ways that satisfy all their laws, at {events} events: the motion is one of several"
            ),
            Self::UndeterminedImpact { events } => write!(
                f,
                "impacts could share their impulses in many ways, of which restitution gives back a part, at {events} events: \
                 the motion is one of many"
            ),
            Self::UndeterminedContact { events } => write!(
                f,
                "more contacts rest than there are freedoms, from {events} events on: the motion is unique, pushes and frictions are one \
                 of many; a `compliance` at a joint, or a contact that gives way"
            ),
            Self::LongSteps { largest, sum, step } => write!(
                f,
                "steps of up to {step:e} s err by up to {:.2} % of a state, by {:.1} % of it together: shorter steps, or a \
                 method that chooses them by their error",
                100.0 * largest,
                100.0 * sum
            ),
        }
    }
}

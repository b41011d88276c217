//! Notices of a simulation.

use core::fmt;

use super::{Sim, Snapshot};
use crate::contact::Counts;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::stats::Stats;

/// Shows the state and the counters only; a method has hundreds of numbers of its own.
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
    /// The most important notice about the motion of a run that can continue.
    pub fn notice(&self) -> Option<Notice> {
        // Undetermined contact forces do not change the motion.
        Self::notices(self).find(|notice| !matches!(notice, Notice::UndeterminedContact { .. }))
    }

    /// All notices about a run that can continue, the most important first. Call it as `Sim::notices(&sim)`: an associated function cannot
    /// hide an output of this name.
    pub fn notices(this: &Self) -> impl Iterator<Item = Notice> + use<M, I> {
        let stats = this.stats();
        let alpha = this.state.mechanism().baumgarte_rate().unwrap_or_default();
        let h_alpha = stats.longest_step * alpha;
        let conditions = stats.passed_over;
        let first = [
            (h_alpha > 0.5).then_some(Notice::StiffStabilisation { h_alpha }),
            Notice::of_errors(&stats),
            (conditions > 0).then_some(Notice::PassedOver { conditions }),
            (stats.divided > 0).then_some(Notice::DividedSteps { steps: stats.divided }),
        ];
        let contact = Notice::of_contacts(&this.contact_stats(), this.is_undetermined());
        first.into_iter().chain(contact).flatten()
    }
}

/// Notice for the user about a run that can continue.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Notice {
    /// The longest step times Baumgarte's decay rate is above 0.5: the stabilisation costs accuracy (and above 2.785
    /// Runge-Kutta 4 is unstable). Shorten the step or lengthen the time constant.
    StiffStabilisation {
        /// Step times decay rate.
        h_alpha: f64,
    },
    /// Conditions switched forth and back within steps of fixed length and were not detected. Remedies: shorter steps, or a method with
    /// dense output, which ends a step at every event.
    PassedOver {
        /// Number of these conditions.
        conditions: u64,
    },
    /// Steps of fixed length were too long for the loops, and were made in parts. Such a step takes several times as long, which matters in
    /// real time. Remedy: shorter steps.
    DividedSteps {
        /// Number of these steps.
        steps: u64,
    },
    /// Events after which contact rows could continue in several ways, each of which satisfies all laws of contact. The motion from there
    /// on is one of several, as with large coefficients of friction.
    AmbiguousContact {
        /// Number of these events.
        events: u64,
    },
    /// Impacts with several outcomes, each of which satisfies all laws. The motion from there on is one of several. Causes are corners, and
    /// several gaps that close at once while impacts are solved in sequence.
    AmbiguousImpact {
        /// Number of these events.
        events: u64,
    },
    /// Impacts whose impulses can be shared by several rows in many ways, as by a stop and a friction beside it. The rates after the impact
    /// depend on the share, because restitution does, so that the motion from there on is one of many.
    UndeterminedImpact {
        /// Number of these events.
        events: u64,
    },
    /// More contact rows are at rest than there are degrees of freedom. The motion is unique, but contact forces, frictions and reactions
    /// are one of many solutions, as at a table on four legs.
    UndeterminedContact {
        /// Number of events after which this was so; at least 1 if it is so now.
        events: u64,
    },
    /// Steps of fixed length are too long: one step errs by more than three thousandths of the size of a state, or all steps together by
    /// more than a tenth. The motion is inaccurate and may differ in kind. Remedies: shorter steps, or a method that controls its error.
    /// Both figures estimate local errors; the motion may amplify or damp them.
    LongSteps {
        /// Largest error of one step, relative to the size of a state.
        largest: f64,
        /// Sum of the errors of all steps, on that scale.
        sum: f64,
        /// Longest step, s.
        step: f64,
    },
}

impl Notice {
    /// Notice about the errors of steps of fixed length, if they exceed [`LARGE`] or [`SUM`].
    fn of_errors(stats: &Stats) -> Option<Self> {
        let Stats { largest_error: largest, errors: sum, longest_step: step, .. } = *stats;
        (largest >= LARGE || sum >= SUM).then_some(Self::LongSteps { largest, sum, step })
    }

    /// Notices about contact that is not unique; `is_undetermined` tells this of the present modes.
    fn of_contacts(counts: &Counts, is_undetermined: bool) -> [Option<Self>; 4] {
        let Counts { ambiguous, ambiguous_impacts, undetermined_impacts, .. } = *counts;
        // The modes at the start belong to no event.
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

/// Least error of one step, relative to the size of a state, that is reported. Estimates are accurate to a factor of three, and a run that
/// is accurate to a thousandth gives no notice.
const LARGE: f64 = 3e-3;
/// Least sum of the errors of all steps, on that scale, that is reported.
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
            Self::DividedSteps { steps } => write!(
                f,
                "steps of equal length were too long for the loops, {steps} times, and were made in parts, which takes several times \
                 as long: shorter steps"
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

//! Contract of the near-singular method, and the distance of a step from singular poses.

use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::method::{Context, Length, Method};
use crate::system::Step;

/// A method that takes over from another one near singular poses.
pub trait Rescue<M: Mechanism>: Method<M> {
    /// Nothing is known yet.
    fn new() -> Self;

    /// Is the state one that only this method can go on from?
    fn holds(context: &Context<'_, M>) -> bool;

    /// Whether a step can be anything but [`Nearness::Regular`].
    const POSSIBLE: bool;

    /// How near to singular poses a step has come whose length was chosen so.
    fn nearness(step: &Step<'_, M>, length: Length) -> Nearness;

    /// Gives it the state, which another method cannot go on from; whether it can.
    fn take(context: &mut Context<'_, M>) -> bool;

    /// The part that closes the loop which went through a flat pose in the last step, where the mechanism could have gone
    /// on in another way.
    fn passed(&self) -> Option<&'static str>;

    /// The length of the last step, s, if it followed a turn beside a flat pose.
    fn followed(&self) -> Option<M::S>;
}

/// How near to singular poses a step has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nearness {
    /// It can be trusted.
    Regular,
    /// The mechanism turns sharply next to a flat pose: in so many parts the step is short beside the turn.
    Turn {
        /// At least 2.
        parts: u32,
    },
    /// It has led over poses that are so nearly singular that only the near-singular method can be trusted.
    Singular,
}

/// The cause of a fault near a singular pose: that which the mechanism's own coordinates told, but where the motion ends there.
pub(super) fn true_cause(failed: Option<Fault>, fault: Fault) -> Fault {
    match failed {
        Some(cause) if !matches!(fault.cause, Cause::LockedAt { .. }) => Fault { time: fault.time, ..cause },
        _ => fault,
    }
}

/// Can a fault come from a pose at which the mechanism's own coordinates are not regular?
pub(super) fn is_singular(fault: &Fault) -> bool {
    use Cause::{
        Drift, Locked, NotConverged, NotFinite, Singular, StepTooLong, StepTooSmall, TurnedTooFar, Workspace,
    };
    matches!(
        fault.cause,
        Locked
            | TurnedTooFar { .. }
            | StepTooSmall { .. }
            | StepTooLong { .. }
            | NotConverged { .. }
            | NotFinite
            | Singular { .. }
            | Drift { .. }
            | Workspace { .. }
    )
}

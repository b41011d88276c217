//! Contract of the near-singular method, and the distance of a step from singular poses.

use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::method::{Context, Length, Method};
use crate::system::Step;

/// Near-singular method: it replaces another method near singular poses.
pub trait Rescue<M: Mechanism>: Method<M> {
    /// A method without history.
    fn new() -> Self;

    /// True if only this method can continue from the state.
    fn holds(context: &Context<'_, M>) -> bool;

    /// True if a step can be anything but [`Nearness::Regular`].
    const POSSIBLE: bool;

    /// Distance of a step, whose length was chosen in this way, from singular poses.
    fn nearness(step: &Step<'_, M>, length: Length) -> Nearness;

    /// Takes over a state from which another method cannot continue. Returns true if it can.
    fn take(context: &mut Context<'_, M>) -> bool;

    /// Part that closes the loop which crossed a flat pose in the last step, if the mechanism could have continued in another
    /// way.
    fn passed(&self) -> Option<&'static str>;

    /// Length of the last step, s, if it followed a turn beside a flat pose.
    fn followed(&self) -> Option<M::S>;
}

/// Distance of a step from singular poses, in classes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nearness {
    /// The step can be trusted.
    Regular,
    /// The mechanism turns sharply next to a flat pose; a step in so many parts is short in comparison with the turn.
    Turn {
        /// At least 2.
        parts: u32,
    },
    /// The step crosses poses that are so nearly singular that only the near-singular method can be trusted.
    Singular,
}

/// Cause of a fault near a singular pose: that of the mechanism's own coordinates, unless the motion ends at the pose.
pub(super) fn true_cause(failed: Option<Fault>, fault: Fault) -> Fault {
    match failed {
        Some(cause) if !matches!(fault.cause, Cause::LockedAt { .. }) => Fault { time: fault.time, ..cause },
        _ => fault,
    }
}

/// True if a fault can come from a pose at which the mechanism's own coordinates are not regular.
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

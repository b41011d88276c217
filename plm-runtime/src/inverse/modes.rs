//! Modes of conditions and contacts, for which inputs were found.

use super::error::Unsolved;
use crate::described::Described;
use crate::mechanism::Moment;
use crate::scalar::Scalar;
use crate::system::{Events, Labels};
use crate::vector::Vector;

/// Checks that the inputs of `after` end no mode of the state; `before` has the inputs of the last step.
///
/// # Errors
/// [`Unsolved::Mode`] with the first condition whose guard these inputs take past zero.
pub(super) fn stay<'a, T>(before: &T, after: &T) -> Result<(), Unsolved<'a>>
where
    T: Moment<M: Described<State = T>>,
{
    let mechanism = before.mechanism();
    let guards = |state: &T| {
        let mut guards = <T::M as Events>::G::fill(<T::M as crate::system::Rate>::S::lit(1.0));
        mechanism.guards(state.time(), &state.held(), state.x(), &mut guards);
        guards
    };
    let (known, found) = (guards(before), guards(after));
    let held = after.held();
    for index in 0..mechanism.guard_count() {
        // Guards that read no input are those of the state, whose modes are right.
        let (guard, reads_inputs) = (found.at(index), found.at(index) != known.at(index));
        if reads_inputs && guard < -mechanism.band(index) && mechanism.matters(&held, index, 0) {
            let (time, condition) = (before.time().to_f64(), mechanism.guard_name(index));
            return Err(Unsolved::Mode { time, condition });
        }
    }
    Ok(())
}

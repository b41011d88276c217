//! Energy balance of a step.

use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::scalar::Scalar;
use crate::system::{Energy, Step};
use crate::vector::Vector;

/// Compares the change of energy over a step with the work done in it, by the trapezoidal rule.
///
/// # Errors
/// [`Cause::EnergyJump`] if they differ by more than `fraction` of the energy that moves.
pub(super) fn check_energy<M: Mechanism>(step: &Step<'_, M>, fraction: M::S) -> Result<(), Fault> {
    let energy = |(t, x): (M::S, &M::X)| step.system.energy(t, step.held, x);
    let (Some(from), Some(to)) = (energy(step.from), energy(step.to)) else {
        return Ok(());
    };
    let half = M::S::lit(0.5) * (step.to.0 - step.from.0);
    let jump = (to.kinetic - from.kinetic) + (to.gravity - from.gravity) - half * (from.power + to.power);
    let moves = from.kinetic.max(to.kinetic).max((half * from.power).abs()).max((half * to.power).abs());
    // False for NaN.
    let fits = jump.abs() <= fraction * moves;
    if !fits {
        let cause = Cause::EnergyJump { by: jump.to_f64(), of: moves.to_f64() };
        return Err(Fault::of_part(step.to.0.to_f64(), largest_change(step, from), cause));
    }
    Ok(())
}

/// The part whose own change over a step changes the energy most.
#[cold]
fn largest_change<M: Mechanism>(step: &Step<'_, M>, from: Energy<M::S>) -> &'static str {
    let (mut part, mut most) = ("", M::S::ZERO);
    for i in 0..M::X::LEN {
        let mut alone = *step.from.1;
        alone.set(i, step.to.1.at(i));
        let Some(to) = step.system.energy(step.from.0, step.held, &alone) else { continue };
        let change = ((to.kinetic - from.kinetic) + (to.gravity - from.gravity)).abs();
        if change > most {
            (part, most) = (step.system.part_of_state(i), change);
        }
    }
    part
}

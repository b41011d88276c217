//! Energy that comes out of nowhere.

use crate::fault::{Cause, Fault};
use crate::mechanism::Mechanism;
use crate::method::Course;
use crate::scalar::Scalar;
use crate::system::Energy;
use crate::vector::Vector;

/// Compares the energy after a step with that before and the work in between, by the trapezoidal rule.
pub(super) fn audit<M: Mechanism>(
    course: &Course<'_, M>,
    fraction: M::S,
    before: &(M::S, M::X),
) -> Result<(), Fault> {
    let energy = |t: M::S, x: &M::X| course.system.energy(t, &course.held, x);
    let (Some(from), Some(to)) = (energy(before.0, &before.1), energy(course.time, &course.x)) else {
        return Ok(());
    };
    let half = M::S::lit(0.5) * (course.time - before.0);
    let jump = (to.kinetic - from.kinetic) + (to.gravity - from.gravity) - half * (from.power + to.power);
    let moves = from.kinetic.max(to.kinetic).max((half * from.power).abs()).max((half * to.power).abs());
    // False for what is not a number.
    let fits = jump.abs() <= fraction * moves;
    if !fits {
        let cause = Cause::EnergyJump { by: jump.to_f64(), of: moves.to_f64() };
        return Err(Fault::of_part(course.time.to_f64(), moved_most(course, before, from), cause));
    }
    Ok(())
}

/// The part whose own change in a step changes the energy most.
#[cold]
fn moved_most<M: Mechanism>(
    course: &Course<'_, M>,
    (time, x): &(M::S, M::X),
    from: Energy<M::S>,
) -> &'static str {
    let mut most = ("", M::S::ZERO);
    for i in 0..M::X::LEN {
        let mut alone = *x;
        alone.set(i, course.x.at(i));
        let Some(to) = course.system.energy(*time, &course.held, &alone) else { continue };
        let change = ((to.kinetic - from.kinetic) + (to.gravity - from.gravity)).abs();
        if change > most.1 {
            most = (course.system.part_of_state(i), change);
        }
    }
    most.0
}

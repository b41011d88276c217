//! Contact rows after a change by the caller: a constraint row may have been moved or have got a velocity, a friction may have got a
//! bound.

use super::bounds::look_at_bounds;
use super::candidates::is_off;
use super::event::update;
use super::modes::{Change, Mode, Modes};
use super::scales::speed;
use super::{Contacts, Modal};
use crate::fault::Fault;
use crate::scalar::Scalar;

/// A constraint row has been moved if it is off its place by more than this fraction of the length of the mechanism, or if its rate
/// exceeds this fraction of the speed that free acceleration gives over that length. Errors of integration are smaller.
const MOVED: f64 = 1e-5;

/// Finds the modes again if the caller has moved a constraint row, or if a friction that had no bound has one now. A gap that was moved is
/// open, a friction sticks in its new place or slips. Otherwise nothing changes. Modes that change where the state is set
/// ([`Change::WhereSet`]) are found from its velocities, and change at events from then on.
///
/// # Errors
/// As [`switch`](super::switch).
pub fn state_was_set<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
) -> Result<(), Fault> {
    let rows = system.rows_at(t, u, x);
    look_at_bounds(system, t, u, &rows)?;
    let mut modes: Modes<M::S, N> = *u.modes();
    if modes.change == Change::WhereSet {
        u.modes_mut().change = Change::AtEvents;
        return update(system, t, u, x).map(|_| ());
    }
    let [far, fast] = [system.length(), speed::<M, N>(system, &rows, u)].map(|size| M::S::lit(MOVED) * size);
    let mut any = false;
    for row in 0..N {
        let (is_carried, is_gap) = (modes.carried[row], system.law(row).is_unilateral());
        // An input may have given it a bound.
        any |= !is_gap && modes.of[row] == Mode::Off && !is_off(&rows, &modes.of, row);
        if !(modes.of[row].holds() || is_carried) {
            continue;
        }
        any |= rows.rate[row].abs() > fast;
        let place = if is_gap { M::S::ZERO } else { modes.place[row] };
        if (rows.gap[row] - place).abs() <= far {
            continue;
        }
        any = true;
        if is_gap {
            (modes.of[row], modes.carried[row]) = (Mode::Open, false);
        } else {
            modes.place[row] = rows.gap[row];
        }
    }
    if any {
        *u.modes_mut() = modes;
        update(system, t, u, x)?;
    }
    Ok(())
}

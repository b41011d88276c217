//! Rows of contact in a search for equilibrium: what holds at a pose is a constraint, what lets go is none.
//!
//! Which rows hold follows from all inequalities at a pose where nothing moves, as at the start of a run. Their forces are among the
//! unknowns, until the rows that hold where the search has ended are those with which it began.

use plm_runtime::contact::Mode;
use plm_runtime::{Cause, Fault, StartValues};

use super::evaluation::{Evaluation, Task};
use super::residuals::{Holding, Point, Residuals};
use super::{BALANCED, Stabilise};

/// A gap may be negative by this fraction of the size of the mechanism: half of what a start allows.
const CLOSED: f64 = 5e-10;

/// A constraint gives this force, N or N m, and any other.
const ANY_FORCE: f64 = 1e18;

/// A gap that is closed at the equilibrium, or a friction that holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// The row: `foot.tip`.
    pub name: &'static str,
    /// Its push or its friction, N or N m; none where more rows hold than there are freedoms, so that forces are not unique.
    pub force: Option<f64>,
    /// The part of its bound that a friction uses, 0 to 1; none for a gap and for a constraint, and where forces are not unique.
    pub used: Option<f64>,
}

/// The mode of each row.
fn modes<M: Stabilise>(residuals: &Residuals<M>) -> impl Iterator<Item = (usize, Mode)> + use<M> {
    let status = M::contacts(residuals.held());
    let modes: Vec<Mode> =
        (0..residuals.mechanism().contact_count()).map_while(|row| status.mode(row)).collect();
    modes.into_iter().enumerate()
}

/// Is the row a gap, not a friction?
fn is_gap<M: Stabilise>(residuals: &Residuals<M>, row: usize) -> bool {
    let mode = M::contacts(residuals.held()).mode(row);
    matches!(mode, Some(Mode::Open | Mode::Closed))
}

/// The rows that hold at the start, where they are.
pub(super) fn holding<M: Stabilise>(
    residuals: &Residuals<M>,
    start: &Point,
    released: &[usize],
) -> Vec<Holding> {
    if residuals.mechanism().contact_count() == 0 {
        return Vec::new();
    }
    let (displacements, _) = residuals.of_contact(start);
    let holds = modes(residuals).filter_map(|(row, mode)| match mode {
        Mode::Closed => Some(Holding { row, place: 0.0 }),
        Mode::Sticks => Some(Holding { row, place: displacements.get(row).copied()? }),
        _ => None,
    });
    holds.filter(|of| !released.contains(&of.row)).collect()
}

/// Nothing moves at the start: velocities that are not locked are zero.
pub(super) fn at_rest<M: Stabilise>(mechanism: &mut M) {
    let (mut index, bodies) = (0, 2 * mechanism.coordinate_names().len());
    mechanism.starts_mut().each(&mut |_, start| {
        if index < bodies && index % 6 >= 3 && !start.locked {
            start.value = 0.0;
        }
        index += 1;
    });
}

/// The point with gaps that have become negative closed; none where joints do not let them.
pub(super) fn lifted<M: Stabilise>(task: &mut Task<M>, mut point: Point) -> Option<Point> {
    let count = task.residuals.mechanism().contact_count();
    if count == 0 {
        return Some(point);
    }
    let none = CLOSED * task.scales.length;
    // A gap that is closed may open another one.
    for _ in 0..=count {
        let (displacements, _) = task.residuals.of_contact(&point);
        let sunk = displacements.iter().enumerate().filter(|(row, gap)| {
            let holds = task.residuals.holding.iter().any(|of| of.row == *row);
            !holds && is_gap(&task.residuals, *row) && **gap < -none
        });
        let sunk: Vec<Holding> = sunk.map(|(row, _)| Holding { row, place: 0.0 }).collect();
        if sunk.is_empty() {
            return Some(point);
        }
        task.residuals.holding.extend(sunk);
        point.lambda = point.lambda.resize_vertically(task.residuals.nc(), 0.0);
        if !task.close(&mut point)? {
            return None;
        }
    }
    None
}

/// A friction that slips where nothing moves: it does not hold there.
pub(super) fn slips<M: Stabilise>(residuals: &Residuals<M>, time: f64) -> Option<Fault> {
    let slips = |mode: Mode| matches!(mode, Mode::Forwards | Mode::Backwards);
    let (row, _) = modes(residuals).find(|(_, mode)| slips(*mode))?;
    Some(Fault::of_part(time, residuals.mechanism().contact_name(row), Cause::Slips))
}

/// A row that cannot hold as it would have to.
pub(super) enum Wrong {
    /// A friction would have to give more than it has.
    Slips(Fault),
    /// A gap would have to pull.
    Pulls(usize),
}

/// Forces of the rows that hold, and how much of its bound each uses; or a row that cannot.
pub(super) fn supports<M: Stabilise>(
    (task, evaluation): (&Task<M>, &Evaluation),
    time: f64,
) -> Result<Vec<Support>, Wrong> {
    let residuals = &task.residuals;
    if residuals.holding.is_empty() {
        return Ok(Vec::new());
    }
    let is_unique = !M::contacts(residuals.held()).is_undetermined();
    let (_, limits) = residuals.of_contact(&evaluation.point);
    let least = BALANCED * task.scales.force.amax();
    let of_row = |(k, of): (usize, &Holding)| {
        let name = residuals.mechanism().contact_name(of.row);
        let force = evaluation.point.lambda.get(residuals.own() + k).copied();
        let Some(force) = force.filter(|_| is_unique) else {
            return Ok(Support { name, force: None, used: None });
        };
        let [lower, upper] = limits.get(of.row).copied().unwrap_or_default();
        if lower >= ANY_FORCE {
            return Ok(Support { name, force: Some(force), used: None });
        }
        if is_gap(residuals, of.row) {
            let pulls = force < -least;
            return if pulls {
                Err(Wrong::Pulls(of.row))
            } else {
                Ok(Support { name, force: Some(force), used: None })
            };
        }
        let limit = if force < 0.0 { lower } else { upper };
        if force.abs() > limit + least {
            return Err(Wrong::Slips(Fault::of_part(time, name, Cause::Slips)));
        }
        let used = if limit > 0.0 { force.abs() / limit } else { 0.0 };
        Ok(Support { name, force: Some(force), used: Some(used) })
    };
    residuals.holding.iter().enumerate().map(of_row).collect()
}

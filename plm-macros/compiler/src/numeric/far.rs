//! Starts that close only far away, the compiler's twin of the runtime's `absolute/far.rs`: a pose is far where it turns a body by
//! more than what was missing explains.

use crate::collect::CollectVec;

use super::constraints::{Closed, largest};
use super::damped::Measure;
use super::placed::{PLACING, distance};
use super::search::Search;

/// So many times the root of the share that is missing are explained, rad.
const EXPLAINED: f64 = 8.0;
/// Turns that are looked at, rad.
const LOOKED_AT: f64 = 0.3;
/// Another pose is taken if the squares of its turns are less than this part.
const NEARER: f64 = 0.9;

/// Turn and gap of a start that closes only far away.
#[derive(Clone, Copy)]
pub(crate) struct Far {
    /// The angle that was turned most of those that were given: an index into the coordinates.
    pub(crate) coordinate: usize,
    /// By how much, rad.
    pub(crate) turned: f64,
    /// Gap of the joints in the start as declared, m.
    pub(crate) missing: f64,
}

/// Does a closed pose turn a body further from the given angles than what was missing there explains?
pub(super) fn far(search: &Search, q: &[f64]) -> Option<Far> {
    let start = search.start;
    let turned = |k: usize| q[k] - start.values[k];
    let given = (0..q.len()).filter(|&k| start.given[k]);
    let coordinate = given.reduce(|most, k| if turned(k).abs() > turned(most).abs() { k } else { most })?;
    let by = turned(coordinate).abs();
    if by <= LOOKED_AT {
        return None;
    }
    let missing = missing(search);
    let is_far = by > EXPLAINED * plm_math::f64::sqrt(missing);
    let length = search.constraints.scene.length;
    is_far.then(|| Far { coordinate, turned: turned(coordinate), missing: missing * length })
}

/// A closed pose, or the nearest one that a search finds where it is far from the start.
pub(super) fn look_nearer(
    search: &Search,
    pose: Closed,
    others: &mut dyn FnMut() -> Result<Closed, Vec<f64>>,
) -> Closed {
    if far(search, &pose.q).is_none() {
        return pose;
    }
    match others() {
        Ok(other) if distance(search.start, &other.q) < NEARER * distance(search.start, &pose.q) => {
            Closed { steps: pose.steps + other.steps, ..other }
        }
        _ => pose,
    }
}

/// The largest violation of the start as declared, as a share of the length or in rad. Where constraints and locks leave no freedom, it is
/// also looked at with the bodies in their places, since positions may be left out; with freedoms the shortest steps to their places turn
/// bodies too.
fn missing(search: &Search) -> f64 {
    let Search { constraints, start, .. } = *search;
    let mut q = start.values.clone();
    let measure = Measure::new(constraints, &start.locked);
    let declared = largest(&measure.violation(&q));
    let free = start.locked.iter().filter(|lock| !**lock).count();
    if free > constraints.scene.model.rows.len() {
        return declared;
    }
    for all in [true, false] {
        let held = |k: usize| k % 3 == 2 && (all || start.given[k]);
        let locked = (0..q.len()).map(|k| start.locked[k] || held(k)).collect_vec();
        Measure::new(constraints, &locked).descend(&mut q, PLACING);
    }
    largest(&measure.violation(&q)).min(declared)
}

//! Angles that have turned far are reduced by whole revolutions, in the coordinates and in the continuation data.

use super::{Charted, Charts, ContinuationData, OfLoops};
use crate::turns::{due, less};
use crate::vector::Vector;

/// The angles of bodies that turn as one, whose revolutions are counted together.
#[derive(Clone, Copy, Debug)]
pub struct Revolutions {
    /// By chart: the coordinates that are such angles.
    pub coordinates: &'static [&'static [usize]],
    /// Their places among the angles of the continuation data.
    pub angles: &'static [usize],
    /// Their places among the unknowns of iterations.
    pub iterated: &'static [usize],
}

/// Is a coordinate to be brought back?
#[inline]
pub(super) fn are_due<M: Charted>(charts: &Charts, held: &M::U, x: &M::X) -> bool {
    let OfLoops::InChart { chart, .. } = held.of_loops else { return false };
    first_places(charts, chart).any(|k| due(x.at(k)) != 0)
}

/// By count, the first of its coordinates in a chart.
#[inline]
pub(super) fn first_places(charts: &Charts, chart: usize) -> impl Iterator<Item = usize> {
    let coordinates = charts.revolutions.iter().filter_map(move |count| count.coordinates.get(chart));
    coordinates.filter_map(|places| places.first().copied())
}

/// Brings angles back where the first of a count has turned far; whether there were some.
#[inline]
pub(super) fn unwind<M: Charted>(charts: &Charts, held: &mut M::U, x: &mut M::X) -> bool {
    let OfLoops::InChart { chart, continuation } = &mut held.of_loops else { return false };
    let mut turned = false;
    for (count, turns) in charts.revolutions.iter().zip(held.turns.as_mut()) {
        let coordinates = count.coordinates.get(*chart).copied().unwrap_or_default();
        let in_continuation = || continuation.angles().get(*count.angles.first()?).map(|turn| turn.angle);
        let due = coordinates.first().map(|&k| x.at(k)).or_else(in_continuation).map_or(0, due);
        if due == 0 {
            continue;
        }
        for &k in coordinates {
            x.set(k, less(x.at(k), due));
            if let Some(coordinate) = continuation.coordinates_mut().get_mut(k) {
                coordinate.last = less(coordinate.last, due);
            }
        }
        for &k in count.angles {
            if let Some(turn) = continuation.angles_mut().get_mut(k) {
                turn.angle = less(turn.angle, due);
            }
        }
        for &k in count.iterated {
            if let Some(iterated) = continuation.iterated_mut().get_mut(k) {
                iterated.value = less(iterated.value, due);
            }
        }
        *turns = turns.saturating_add(due);
        turned = true;
    }
    turned
}

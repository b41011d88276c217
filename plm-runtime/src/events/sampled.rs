//! Sampled search for the first event in a step whose dense output is no polynomial.
//!
//! The step is sampled at a few equidistant times, and between samples the parabola through three of them is used. If a guard bends more
//! than such samples can show, as that of a friction that sticks under a load which swings while nothing moves, the halves of the step are
//! sampled in the same way. A condition that lasts shorter than the distance of the samples can be missed.

use super::relevant::Relevant;
use super::root::{Point, root};
use super::search::Found;
use crate::method::{Context, Method};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Intervals between the samples of a step.
const SAMPLES: usize = 4;
/// Halvings of a step that begins with a violated guard, in search of a time at which the guard is satisfied before it leaves its side.
const HALVINGS: u32 = 10;

/// Most halvings of a step in which guards bend.
const MOST_HALVINGS: u32 = 6;

/// A part of a step: its beginning and end, with the guards there, and the number of halvings that are left.
struct Part<M: System> {
    from: (M::S, M::G),
    to: (M::S, M::G),
    halvings: u32,
}

/// Last step of a method.
pub(super) struct Sampled<'a, 'c, M: System, I> {
    pub(super) method: &'a I,
    pub(super) context: &'a Context<'c, M>,
    /// Time at its beginning, s.
    pub(super) start: M::S,
    /// Values by which guards were violated when their events were committed.
    pub(super) residual: &'a M::G,
    /// Conditions that are examined.
    pub(super) relevant: Relevant,
}

impl<M: System<S: Real>, I: Method<M>> Sampled<'_, '_, M, I> {
    /// First guard that leaves its side, and the time; the guards at the beginning and at the end of the step are known.
    pub(super) fn first(&self, began: &M::G, end: &M::G) -> (Found<M::S>, M::S) {
        let (from, to) = ((self.start, *began), (self.context.time, *end));
        match self.first_within(&Part { from, to, halvings: MOST_HALVINGS }) {
            Some((index, time)) => (Found::Crossing(index, (time - from.0) / (to.0 - from.0)), time),
            None => (Found::Nothing, to.0),
        }
    }

    /// First guard that leaves its side within a part of the step, and the time.
    fn first_within(&self, part: &Part<M>) -> Option<(usize, M::S)> {
        let Part { from: (start, began), to: (stop, end), halvings } = part;
        let at = |look: M::S| *start + look / M::S::lit(SAMPLES as f64) * (*stop - *start);
        let inside = [1.0, 2.0, 3.0].map(|look| self.guards(at(M::S::lit(look))));
        let sampled = [*began, inside[0], inside[1], inside[2], *end];
        let relevant = || (0..M::G::LEN).filter(|i| self.relevant.has(*i));
        let edge = |i: usize| self.residual.at(i).min(M::S::ZERO) - self.context.system.band(i);
        if *halvings > 0 && relevant().any(|i| bends(sampled.map(|g| g.at(i)), edge(i))) {
            let (middle, halvings) = ((at(M::S::lit(2.0)), inside[1]), halvings - 1);
            let first = Part { from: (*start, *began), to: middle, halvings };
            let second = Part { from: middle, to: (*stop, *end), halvings };
            return self.first_within(&first).or_else(|| self.first_within(&second));
        }
        let mut first: Option<(usize, M::S)> = None;
        for i in relevant() {
            let (edge, guard) = (edge(i), |time: M::S| self.guards(time).at(i));
            let is_out = |look| guard(at(look)) < edge;
            let Some(look) = first_out(sampled.map(|g| g.at(i)), edge, is_out) else { continue };
            let out = Point { at: at(look), value: guard(at(look)) };
            let time = crossing(Point { at: *start, value: began.at(i) }, out, &mut &guard);
            if first.is_none_or(|(_, known)| time < known) {
                first = Some((i, time));
            }
        }
        first
    }

    /// Guards at a time within the step.
    fn guards(&self, time: M::S) -> M::G {
        let (held, x) = self.method.moment(self.context, time);
        super::guards(self.context.system, time, &held, &x)
    }
}

/// True if a guard that is above its edge at all samples may be below it between them. This follows from its differences of second and
/// third order, which are small if the samples show its course, and as large as its changes if they do not.
fn bends<S: Real>(g: [S; SAMPLES + 1], edge: S) -> bool {
    let second = |k: usize| (g[k] - g[k + 1] - g[k + 1] + g[k + 2]).abs();
    let third = |k: usize| (g[k + 3] - g[k] + S::lit(3.0) * (g[k + 1] - g[k + 2])).abs();
    let bent = second(0).max(second(1)).max(second(2)).max(third(0)).max(third(1));
    let nearest = g.iter().fold(g[0], |nearest, value| nearest.min(*value)) - edge;
    nearest > S::ZERO && bent > nearest
}

/// First sample at which a guard is below its edge, or place between samples at which the parabola through three of them is below it; of
/// those that `is_out` confirms.
fn first_out<S: Real>(g: [S; SAMPLES + 1], edge: S, is_out: impl Fn(S) -> bool) -> Option<S> {
    (1..=SAMPLES).find_map(|k| {
        let (look, value) = (S::lit(k as f64), g[k]);
        if value < edge {
            return is_out(look).then_some(look);
        }
        let (before, after) = (g[k - 1] - value, *g.get(k + 1)? - value);
        // Its lowest point is `lean / bend` samples after the middle one.
        let (lean, bend) = (S::lit(0.5) * (before - after), before + after);
        let lowest = value - S::lit(0.5) * lean * lean / bend;
        let place = look + lean / bend;
        (lean.abs() < bend && lowest < edge && is_out(place)).then_some(place)
    })
}

/// First time past the root of a guard between the start of a step and a time at which it is violated.
fn crossing<S: Real>(start: Point<S>, end: Point<S>, guard: &mut dyn FnMut(S) -> S) -> S {
    let tolerance = S::EPSILON * start.at.abs().max(end.at.abs());
    if start.value > S::ZERO {
        return root(start, end, tolerance, guard);
    }
    let mut length = end.at - start.at;
    for _ in 0..HALVINGS {
        length = S::lit(0.5) * length;
        let at = start.at + length;
        let value = guard(at);
        if value > S::ZERO {
            return root(Point { at, value }, end, tolerance, guard);
        }
    }
    start.at
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Place that is found for a guard with samples at 0, 1, ... 4.
    fn found(guard: impl Fn(f64) -> f64, edge: f64) -> Option<f64> {
        let at = [0.0, 1.0, 2.0, 3.0, 4.0];
        first_out(at.map(&guard), edge, |look| guard(look) < edge)
    }

    #[test]
    fn a_dip_between_samples_is_found_where_it_is_lowest() {
        for lowest in [0.7, 1.3, 1.6, 2.4, 3.3] {
            for edge in [0.0, -0.3, 0.2] {
                let dip = |depth: f64| found(|at| 2.0 * (at - lowest) * (at - lowest) + edge + depth, edge);
                let place = dip(-0.01);
                assert!(place.is_some_and(|place| (place - lowest).abs() < 1e-14), "{lowest}: {place:?}");
                assert_eq!(dip(0.01), None, "{lowest}");
            }
        }
    }

    /// A load that swings through up to 1.8 periods in a step: each of its dips is found, or shows as a bend.
    #[test]
    fn dips_of_a_swing_are_found_or_show_as_bends() {
        let (mut dips, mut bent) = (0, 0);
        for (percent, phase) in (5..46).flat_map(|percent| (0..50).map(move |phase| (percent, phase))) {
            for amplitude in [1.02, 1.5, 10.0] {
                let turns = |at: f64| 0.01 * f64::from(percent) * at + 0.02 * f64::from(phase);
                let guard = |at: f64| 1.0 - amplitude * (core::f64::consts::TAU * turns(at)).sin();
                let is_dip = guard(0.0) > 0.0 && (0..400).any(|k| guard(0.01 * f64::from(k)) < 0.0);
                let bends = bends([0.0, 1.0, 2.0, 3.0, 4.0].map(guard), 0.0);
                dips += u32::from(is_dip);
                bent += u32::from(bends);
                assert!(!is_dip || bends || found(guard, 0.0).is_some(), "{percent} {phase} {amplitude}");
            }
        }
        assert!(dips > 2000 && bent > 1000, "{dips} {bent}");
        assert!(!bends([5.0, 4.0, 3.0, 2.0, 1.0], 0.0) && !bends([2.0, 1.6, 1.3, 1.1, 1.0], 0.0));
    }

    #[test]
    fn a_guard_that_leaves_is_found_at_the_next_look() {
        assert_eq!(found(|at| 2.5 - at, 0.0), Some(3.0));
        assert_eq!(found(|at| 2.5 - at, -1.0), Some(4.0));
        assert_eq!(found(|at| 2.5 - at, -2.0), None);
        // A parabola that bends downwards has no lowest point.
        assert_eq!(found(|at| 4.1 * at - at * at + 0.1, 0.0), None);
    }

    #[test]
    fn a_crossing_is_timed_from_where_the_guard_is_on_its_side() {
        let point = |guard: fn(f64) -> f64, at: f64| Point { at, value: guard(at) };
        for (guard, time) in [
            ((|at| 2.0 - at * at) as fn(f64) -> f64, 2.0_f64.sqrt()),
            // It begins past its guard, and comes back before it leaves.
            (|at| (at - 0.2) * (2.5 - at), 2.5),
            // It never comes back.
            (|at| -0.1 - at, 0.0),
        ] {
            let found = crossing(point(guard, 0.0), point(guard, 3.0), &mut &guard);
            assert!((found - time).abs() < 2e-15, "{time}: {found}");
        }
    }
}

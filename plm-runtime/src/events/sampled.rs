//! Sampled search for the first event in a step whose dense output is no polynomial.
//!
//! Such a step is looked at a few times, evenly, and between samples by the parabola through three of them: a condition that
//! lasts shorter can be missed.

use super::relevant::Relevant;
use super::root::{Point, root};
use super::search::Found;
use crate::method::{Context, Method};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// A step is looked at so often.
const SAMPLES: usize = 4;
/// A condition that begins a step past its guard may yet come to its side within it: halvings of the step that are
/// looked at to find out.
const HALVINGS: u32 = 10;

/// The last step of a method.
pub(super) struct Sampled<'a, 'c, M: System, I> {
    pub(super) method: &'a I,
    pub(super) context: &'a Context<'c, M>,
    /// Where it began, s.
    pub(super) start: M::S,
    /// How far guards were on the wrong side when they were switched there.
    pub(super) residual: &'a M::G,
    /// Those that are looked at.
    pub(super) relevant: Relevant,
}

impl<M: System<S: Real>, I: Method<M>> Sampled<'_, '_, M, I> {
    /// The first guard that leaves its side, and when; they are known at the beginning and at the end of the step.
    pub(super) fn first(&self, began: &M::G, end: &M::G) -> (Found<M::S>, M::S) {
        let (start, length) = (self.start, self.context.time - self.start);
        let at = |look: M::S| start + look / M::S::lit(SAMPLES as f64) * length;
        let inside = |look: f64| self.guards(at(M::S::lit(look)));
        let sampled = [*began, inside(1.0), inside(2.0), inside(3.0), *end];
        let mut first = (Found::Nothing, self.context.time);
        for i in (0..M::G::LEN).filter(|i| self.relevant.has(*i)) {
            let edge = self.residual.at(i).min(M::S::ZERO) - self.context.system.band(i);
            let guard = |time: M::S| self.guards(time).at(i);
            let Some(look) =
                first_out(Vector::from_fn(|k| sampled[k].at(i)), edge, |look| guard(at(look)) < edge)
            else {
                continue;
            };
            let out = Point { at: at(look), value: guard(at(look)) };
            let time = crossing(Point { at: start, value: began.at(i) }, out, guard);
            if matches!(first.0, Found::Nothing) || time < first.1 {
                first = (Found::Crossing(i, (time - start) / length), time);
            }
        }
        first
    }

    /// The guards at a time within the step.
    fn guards(&self, time: M::S) -> M::G {
        let (held, x) = self.method.moment(self.context, time);
        super::guards(self.context.system, time, &held, &x)
    }
}

/// The first look at which a guard is below its edge, or between samples, where the parabola through three of them says
/// so; of those that `is_out` confirms.
fn first_out<S: Real>(g: [S; SAMPLES + 1], edge: S, is_out: impl Fn(S) -> bool) -> Option<S> {
    (1..=SAMPLES).find_map(|k| {
        let (look, value) = (S::lit(k as f64), g[k]);
        if value < edge {
            return is_out(look).then_some(look);
        }
        let (before, after) = (g[k - 1] - value, *g.get(k + 1)? - value);
        // Its lowest point stands `lean / bend` samples after the middle one.
        let (lean, bend) = (S::lit(0.5) * (before - after), before + after);
        let lowest = value - S::lit(0.5) * lean * lean / bend;
        let place = look + lean / bend;
        (lean.abs() < bend && lowest < edge && is_out(place)).then_some(place)
    })
}

/// The first time past the root of a guard between the start of a step and a time at which it is past.
fn crossing<S: Real>(start: Point<S>, end: Point<S>, guard: impl Fn(S) -> S) -> S {
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

    /// What is found of a guard that is looked at in 0, 1, ... 4.
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
            let found = crossing(point(guard, 0.0), point(guard, 3.0), guard);
            assert!((found - time).abs() < 2e-15, "{time}: {found}");
        }
    }
}

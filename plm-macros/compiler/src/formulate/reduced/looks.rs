//! What is remembered of a state, and how near its loops are to a pose where a chart ends.

use plm_cas::{Expr, Graph, Number};

use super::charts::Scheme;
use super::coordinates::Unknown;
use super::memory::Memorable;
use super::motion::Motion;
use super::solution::Solution;
use super::{Layout, measure, stored};
use crate::formulate::function::{Function, Place};

/// By this part of its distance to a flat pose a loop may move until the next look, and bodies by as many radians.
const CALM: (i64, i64) = (1, 10);
/// A coordinate that moves no loop may go as far as it likes: in its unit.
const ANYWHERE: f64 = 1e30;

impl Layout<'_> {
    /// `memory` of a state, returning the square of the measure.
    pub(super) fn look(&mut self, scheme: &Scheme, motion: &Motion) -> Function {
        let drivers = 0..motion.drivers.len();
        let mut boxes: Vec<[Expr; 2]> = Vec::new();
        for driver in drivers {
            // Where a rate vanishes it does not stay so: the coordinate itself must not go far either.
            let own = motion.drivers[driver];
            let slides = !matches!(self.coordinates.unknowns[own], Unknown::Angle { .. });
            let own_rate = if slides { self.graph.recip(motion.length) } else { self.graph.one() };
            let reach = self.reach(scheme, motion, (&|unknown| motion.gain[unknown][driver], Some(own_rate)));
            boxes.push([motion.value[own], reach]);
        }
        let mut reach = self.reach(scheme, motion, (&|unknown| motion.drift[unknown], None));
        if self.coordinates.moves_with(self.model.time, self.graph) {
            // What is prescribed may rest now and move later: every state is looked at.
            reach = self.graph.neg(reach);
        }
        boxes.push([self.model.time, reach]);
        let areas = motion.solutions.iter().map(|solution| solution.determinant).collect();
        self.remembered(motion, (boxes, areas), &motion.solutions)
    }

    /// How far a coordinate may move, if the unknowns move by `rate` with it, so that no loop comes much nearer to flat and
    /// no body turns far.
    fn reach(
        &mut self,
        scheme: &Scheme,
        motion: &Motion,
        (rate, own): (&dyn Fn(usize) -> Expr, Option<Expr>),
    ) -> Expr {
        let graph = &mut *self.graph;
        let mut bounds: Vec<Expr> = Vec::new();
        for (group, solution) in scheme.loops().zip(&motion.solutions) {
            let own = graph.div(solution.square, solution.scale);
            let own = graph.sqrt(own);
            for speed in group.closing_in(self.coordinates, (rate, motion.length), graph) {
                let speed = graph.abs(speed);
                bounds.push(graph.div(speed, own));
            }
            for unknown in group.unknowns() {
                if matches!(self.coordinates.unknowns[unknown], Unknown::Angle { .. }) {
                    bounds.push(graph.abs(rate(unknown)));
                }
            }
        }
        bounds.retain(|&bound| !graph.is_zero(bound));
        if !bounds.is_empty() {
            bounds.extend(own);
        }
        let Some(fastest) = bounds.into_iter().reduce(|a, b| graph.max(a, b)) else {
            return graph.number(Number::from_f64(ANYWHERE));
        };
        let (part, whole) = CALM;
        let coordinates = i64::try_from(motion.drivers.len()).unwrap_or(1).max(1);
        let [part, whole] = [part, whole * coordinates].map(|n| graph.int(n));
        let calm = graph.div(part, whole);
        graph.div(calm, fastest)
    }

    /// The same of a pose and velocity, but for how far the coordinates may move.
    pub(super) fn survey(&mut self, scheme: &Scheme) -> Function {
        let mut motion = Motion::of_pose(self.model, self.coordinates, self.length, self.graph);
        let graph = &mut *self.graph;
        let solutions = scheme.loops().filter_map(|group| group.at_pose(self.coordinates, &motion, graph));
        let solutions: Vec<Solution> = solutions.collect();
        let (q, v) = (&self.equations.q, &self.equations.v);
        let mut flow: Vec<(Expr, Expr)> = q.iter().copied().zip(v.iter().copied()).collect();
        flow.push((self.model.time, graph.one()));
        let areas = solutions.iter().map(|solution| solution.determinant).collect();
        motion.rate = graph.directionals(&motion.value, &flow);
        let zero = graph.zero();
        let places = scheme.drivers.iter().map(|&driver| [motion.value[driver], zero]);
        let boxes = places.chain([[self.model.time, zero]]).collect();
        self.remembered(&motion, (boxes, areas), &solutions)
    }

    /// `memory`, returning the square of the measure.
    fn remembered(
        &mut self,
        motion: &Motion,
        (boxes, areas): (Vec<[Expr; 2]>, Vec<Expr>),
        solutions: &[Solution],
    ) -> Function {
        let graph = &mut *self.graph;
        let mut followed = vec![[graph.zero(); 2]; motion.value.len()];
        for unknown in self.memory.followed() {
            followed[unknown] = [motion.value[unknown], motion.rate[unknown]];
            if !matches!(self.coordinates.unknowns[unknown], Unknown::Angle { .. }) {
                followed[unknown] = followed[unknown].map(|value| graph.div(value, motion.length));
            }
        }
        // The direction of the angle itself, not the axis that it was found from: rounding would add up from look to look.
        let angle = |unknown: usize, graph: &mut Graph| {
            let value = motion.value[unknown];
            [value, graph.cos(value), graph.sin(value)]
        };
        let followed = |unknown: usize| followed[unknown];
        let memorable = Memorable { boxes, angle: &angle, areas, followed: &followed };
        let values = self.memory.values(&memorable, graph);
        let mut results = stored("memory", values.iter());
        results.push((Place::Value, measure(solutions, graph)));
        Function::of_results(results).optimise(graph)
    }
}

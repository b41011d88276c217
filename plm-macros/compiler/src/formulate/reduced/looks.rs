//! What is remembered of a state, and how near its loops are to a pose where a chart ends.

use plm_cas::{Expr, Graph};

use super::charts::Scheme;
use super::coordinates::Unknown;
use super::memory::Memorable;
use super::motion::Motion;
use super::solution::Solution;
use super::{Layout, measure, stored};
use crate::derive::Equations;
use crate::formulate::function::{Function, Place};

impl Layout<'_> {
    /// `memory` of a state, returning the square of the measure.
    pub(super) fn look(&mut self, scheme: &Scheme, motion: &Motion) -> Function {
        let graph = &mut *self.graph;
        let areas = scheme.loops().zip(&motion.solutions).map(|(group, solution)| {
            [solution.determinant, group.determinant_rate(self.coordinates, motion, solution, graph)]
        });
        let areas = areas.collect();
        self.remembered(motion, areas, &motion.solutions)
    }

    /// The same of a pose and velocity.
    pub(super) fn survey(&mut self, scheme: &Scheme) -> Function {
        let mut motion = Motion::of_pose(self.model, self.coordinates, self.length, self.graph);
        let graph = &mut *self.graph;
        let solutions = scheme.loops().filter_map(|group| group.at_pose(self.coordinates, &motion, graph));
        let solutions: Vec<Solution> = solutions.collect();
        let Equations { q, v, .. } = self.equations;
        let mut flow: Vec<(Expr, Expr)> = q.iter().copied().zip(v.iter().copied()).collect();
        flow.push((self.model.time, graph.one()));
        let determinants: Vec<Expr> = solutions.iter().map(|solution| solution.determinant).collect();
        let rates = graph.directionals(&determinants, &flow);
        let areas = determinants.into_iter().zip(rates).map(|(area, rate)| [area, rate]).collect();
        motion.rate = graph.directionals(&motion.value, &flow);
        self.remembered(&motion, areas, &solutions)
    }

    /// `memory`, returning the square of the measure.
    fn remembered(&mut self, motion: &Motion, areas: Vec<[Expr; 2]>, solutions: &[Solution]) -> Function {
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
        let memorable = Memorable { time: self.model.time, angle: &angle, areas, followed: &followed };
        let values = self.memory.values(&memorable, graph);
        let mut results = stored("memory", values.iter());
        results.push((Place::Value, measure(solutions, graph)));
        Function::of_results(results).optimise(graph)
    }
}

//! Memory of a state, and how near its loops are to a pose where a chart ends.

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::{Expr, Number, algebra};

use crate::formulate::function::{Function, Place};
use crate::formulate::reduced::charts::Scheme;
use crate::formulate::reduced::joints::coordinates::Unknown;
use crate::formulate::reduced::layout::Layout;
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::memory::Memorable;
use crate::formulate::reduced::motion::solution::Solution;
use crate::formulate::reduced::motion::solution::measure;

/// A box is this part of a loop's distance to a flat pose, and lets bodies turn by as many radians.
const CALM: (i64, i64) = (1, 10);
/// A coordinate that moves no loop may go as far as it likes: in its unit.
const ANYWHERE: f64 = 1e30;

impl Layout<'_> {
    /// `memory` of a state, returning the square of the measure.
    pub(crate) fn remember(&mut self, scheme: &Scheme, motion: &Motion) -> Function {
        let mut boxes: Vec<[Expr; 2]> = Vec::new();
        for coordinate in 0..motion.independent.len() {
            // Where a rate vanishes it does not stay so: the coordinate itself must not go far either.
            let own = motion.independent[coordinate];
            let is_length = !matches!(self.coordinates.unknowns[own], Unknown::Angle { .. });
            let own_rate = if is_length { motion.length.recip() } else { Expr::ONE };
            let reach = self.reach(
                scheme,
                motion,
                (&|unknown| motion.coefficient[unknown][coordinate], Some(own_rate)),
            );
            boxes.push([motion.value[own], reach]);
        }
        let mut reach = self.reach(scheme, motion, (&|unknown| motion.time_rate[unknown], None));
        if self.coordinates.moves_with(self.model.time) {
            // What is prescribed may rest now and move later: every state is looked at.
            reach = -reach;
        }
        boxes.push([self.model.time, reach]);
        let areas = motion.solutions.iter().map(|solution| solution.determinant).collect_vec();
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
        let mut bounds: Vec<Expr> = Vec::new();
        for (group, solution) in scheme.loops().zip(&motion.solutions) {
            let measure = (solution.square / solution.scale).sqrt();
            for speed in group.closing_in(self.coordinates, (rate, motion.length)) {
                // Where a loop is nearest to flat it does not close, and turns the most sharply.
                let closes = speed.abs();
                let closes = own.filter(|_| !closes.is_zero()).map_or(closes, |own| closes.max(own));
                bounds.push(closes / measure);
            }
            for unknown in group.unknowns() {
                if matches!(self.coordinates.unknowns[unknown], Unknown::Angle { .. }) {
                    bounds.push(rate(unknown).abs());
                }
            }
        }
        bounds.retain(|&bound| !bound.is_zero());
        if !bounds.is_empty() {
            bounds.push_all(own);
        }
        let Some(fastest) = bounds.into_iter().reduce(Expr::max) else {
            return Expr::from(Number::from_f64(ANYWHERE));
        };
        let (part, whole) = CALM;
        let coordinates = i64::try_from(motion.independent.len()).unwrap_or(1).max(1);
        Expr::from(part) / Expr::from(whole * coordinates) / fastest
    }

    /// Memory of a pose and velocity, without how far the coordinates may move.
    pub(crate) fn remember_pose(&mut self, scheme: &Scheme) -> Function {
        let mut motion = Motion::of_pose(self.model, self.coordinates, self.length);
        let solutions = scheme.loops().filter_map(|group| group.at_pose(&motion));
        let solutions: Vec<Solution> = solutions.collect_vec();
        let (q, v) = (&self.equations.q, &self.equations.v);
        let mut flow: Vec<(Expr, Expr)> = q.iter().copied().zip(v.iter().copied()).collect_vec();
        flow.push((self.model.time, Expr::ONE));
        let areas = solutions.iter().map(|solution| solution.determinant).collect_vec();
        motion.rate = algebra::directionals(&motion.value, &flow);
        let places = scheme.independent.iter().map(|&coordinate| [motion.value[coordinate], Expr::ZERO]);
        let boxes = places.chain([[self.model.time, Expr::ZERO]]).collect_vec();
        self.remembered(&motion, (boxes, areas), &solutions)
    }

    /// `memory`, returning the square of the measure.
    fn remembered(
        &mut self,
        motion: &Motion,
        (boxes, areas): (Vec<[Expr; 2]>, Vec<Expr>),
        solutions: &[Solution],
    ) -> Function {
        let mut followed = vec![[Expr::ZERO; 2]; motion.value.len()];
        for unknown in self.memory.followed() {
            followed[unknown] = [motion.value[unknown], motion.rate[unknown]];
            if !matches!(self.coordinates.unknowns[unknown], Unknown::Angle { .. }) {
                followed[unknown] = followed[unknown].map_each(|value| value / motion.length);
            }
        }
        // The direction of the angle itself, not the axis that it was found from: rounding would add up from look to look.
        let angle = |unknown: usize| {
            let value = motion.value[unknown];
            [value, value.cos(), value.sin()]
        };
        let followed = |unknown: usize| followed[unknown];
        let memorable = Memorable { boxes, angle: &angle, areas, followed: &followed };
        let values = self.memory.values(&memorable);
        let places = self.memory.paths().into_iter().map(|path| Place::Path(format!("memory.{path}")));
        let mut results: Vec<(Place, Expr)> = places.zip(values).collect_vec();
        results.push((Place::Value, measure(solutions)));
        Function::of_results(results).optimise()
    }
}

//! Rows of contact that have come to their sides where a step begins: a slip that forces have just begun, a gap that they open. Their
//! guards are zero there and leave it slowly, as the square of the time. The dense output of an implicit step is off by its tolerance, and
//! may go to the other side first. The rate at the beginning of the step knows better.

use super::boundary::rates;
use super::history::Reached;
use super::rounding::rounding;
use super::thrown::is_of_state;
use super::{Detector, guards};
use crate::method::{Context, Method};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// A step is looked at from this part of it on, and at each double of that.
const FIRST: f64 = 1.0 / 4_194_304.0;
/// The rate at the beginning contradicts a dip where the guard would fall less than this fraction of it.
const LESS: f64 = 0.125;

impl<S: Real, G: Vector<S>> Detector<S, G> {
    /// Does the dense output of a step alone say that a row of contact leaves its side as the step begins? It has come back by its end.
    /// Then the guard is looked at from where it has.
    pub(super) fn passes_dip<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &I,
        context: &mut Context<'_, M>,
        (before, index): (&Reached<M, I>, usize),
    ) -> bool {
        let start = &before.state;
        if S::HAS_DERIVATIVES || is_of_state(context.system, index) {
            return false;
        }
        let residual = self.residual.at(index);
        let Some((depth, end)) = dip(method, context, start.time, index) else { return false };
        if depth >= residual {
            return false;
        }
        let first = guards(context.system, start.time, &start.held, &start.x);
        let noise = rounding((context.system, &start.held), (start.time, start.time), &start.x, &first);
        if first.at(index) < residual - noise.at(index) {
            return false;
        }
        let reached = (context.time, context.held, context.x);
        (context.time, context.held, context.x) = (start.time, start.held, start.x);
        let slope = rates(context).map(|slopes| slopes.at(index));
        (context.time, context.held, context.x) = reached;
        let is_of_output = slope.is_some_and(|slope| slope * (end - start.time) >= S::lit(LESS) * depth);
        if is_of_output {
            self.residual.set(index, depth);
        }
        is_of_output
    }
}

/// How far a guard goes below zero first in the last step, which began at `start`, and when it has come back; none if it does not.
fn dip<M: System<S: Real>, I: Method<M>>(
    method: &I,
    context: &Context<'_, M>,
    start: M::S,
    index: usize,
) -> Option<(M::S, M::S)> {
    let path = method.path()?;
    let (mut theta, mut depth) = (M::S::lit(FIRST), M::S::ZERO);
    while theta <= M::S::lit(1.0) {
        let time = path.time(theta);
        let guard = guards(context.system, time, &context.held, &path.at(theta)).at(index);
        if guard > M::S::ZERO {
            return Some((depth, time)).filter(|_| time > start);
        }
        depth = depth.min(guard);
        theta = theta + theta;
    }
    None
}

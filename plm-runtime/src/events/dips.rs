//! Contact rows that have come to their sides at the beginning of a step: a slip that forces have just begun, a gap that they open. Their
//! guards are zero there and leave zero slowly, as the square of the time. The dense output of an implicit step has an error of its
//! tolerance, and may go to the other side first. The rate at the beginning of the step is more accurate.

use super::boundary::rates;
use super::history::Reached;
use super::rounding::rounding;
use super::thrown::is_of_state;
use super::{Detector, guards};
use crate::method::{Context, Method};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// First part of a step at which the guard is evaluated, and then at each double of it.
const FIRST: f64 = 1.0 / 4_194_304.0;
/// The rate at the beginning contradicts a dip if the guard would fall by less than this fraction of its depth.
const LESS: f64 = 0.125;

impl<S: Real, G: Vector<S>> Detector<S, G> {
    /// True if the dense output of a step alone says that a contact row leaves its side at the beginning of the step, and if the row has
    /// returned within the step. The search then begins at the end of that dip.
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

/// Depth to which a guard first falls below zero in the last step, which began at `start`, and the time of its return; `None` if it does
/// not.
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

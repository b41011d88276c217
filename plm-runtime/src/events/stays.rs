//! Guards that are known to stay on their sides over a step, without its dense output.

use super::{Beginning, Detector};
use crate::method::{Context, Path};
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

impl<S: Real, G: Vector<S>> Detector<S, G> {
    /// Do all guards stay on their sides in the step, as is known without its dense output?
    pub(super) fn stay<M: System<S = S, G = G>>(
        &self,
        context: &Context<'_, M>,
        start: &Beginning<M>,
        end: &G,
    ) -> bool {
        if self.residual.fold(false, |any, left| any || left != S::ZERO) {
            return false;
        }
        let path = Path::between((start.time, &start.x), (context.time, &context.x), M::NQ);
        let half = S::lit(0.5);
        let (middle, (time, x)) = (path.at(half), path.around(half, half));
        let places = [(start.time, &start.x), (path.time(half), &middle)];
        context.system.stay(&context.held, places, (time, &x), end)
    }
}

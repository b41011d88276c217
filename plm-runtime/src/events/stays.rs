//! Guards that are known to stay on their sides over a step, without its dense output.

use super::{Beginning, Detector};
use crate::method::{Context, Path};
use crate::scalar::{Real, Scalar};
use crate::system::{Question, System, value, values};
use crate::vector::Vector;

/// Asks if all guards stay on their sides in a step between two times and states, with these guards at its
/// end.
struct Stay<'a, S, X, G> {
    from: (S, &'a X),
    to: (S, &'a X),
    end: &'a G,
}

impl<S: Real, X: Vector<S>, G: Vector<S>> Question<S> for Stay<'_, S, X, G> {
    type Answer = bool;

    fn of<N: System<S: Real<Plain = S::Plain>>>(self, system: &N, held: &N::U) -> bool {
        let (from, to): (N::X, N::X) = (values(self.from.1), values(self.to.1));
        let path = Path::between((value(self.from.0), &from), (value(self.to.0), &to), N::NQ);
        let half = N::S::lit(0.5);
        let (middle, (time, x)) = (path.at(half), path.around(half, half));
        let places = [(path.start, &from), (path.time(half), &middle)];
        system.stay(held, places, (time, &x), &values(self.end))
    }
}

impl<S: Real, G: Vector<S>> Detector<S, G> {
    /// True if all guards are known to stay on their sides in the step, without its dense output.
    pub(super) fn stay<M: System<S = S, G = G>>(
        &self,
        context: &Context<'_, M>,
        start: &Beginning<M>,
        end: &G,
    ) -> bool {
        if self.residual.fold(false, |any, left| any || left != S::ZERO) {
            return false;
        }
        let (from, to) = ((start.time, &start.x), (context.time, &context.x));
        context.system.ask(&context.held, Stay { from, to, end })
    }
}

//! Sign-definite enclosure: one interval evaluation of all guards and kinks over a step. Most steps need no other search.

use super::kinks;
use super::marks::Marks;
use super::relevant::Relevant;
use crate::enclosure::Enclosed;
use crate::method::{Context, Path};
use crate::scalar::{Real, Scalar};
use crate::system::{Question, System};
use crate::vector::Vector;

/// Guards and kinks that may change sign in a step.
#[derive(Clone, Copy)]
pub(super) struct Enclosure {
    /// True if all relevant guards stay on their sides.
    pub(super) guards: bool,
    /// Kinks that matter, one bit each, given the conditions that may change sides; none if none of them may change sign
    /// in the step.
    pub(super) kinks: u128,
    /// Conditions that matter, given those that may change sides in the step.
    pub(super) relevant: Relevant,
}

impl Enclosure {
    /// Enclosure without information: any condition may change its side.
    pub(super) fn unknown<M: System>(system: &M, held: &M::U) -> Self {
        let kinks = Relevant::kinks(system, held, Marks::ALL);
        Self { guards: false, kinks, relevant: Relevant::of(system, held, Marks::ALL) }
    }

    /// Enclosure by the ranges of all guards and kinks over a step with this dense output.
    pub(super) fn over<M: System<S: Real>>(context: &Context<'_, M>, path: &Path<M::S, M::X>) -> Self {
        context.system.ask(&context.held, Over(path))
    }
}

/// Asks for the guards and kinks that may change sign over a step.
struct Over<'a, S, X>(&'a Path<S, X>);

impl<S: Real, X: Vector<S>> Question<S> for Over<'_, S, X> {
    type Answer = Enclosure;

    fn of<N: System<S: Real<Plain = S::Plain>>>(self, system: &N, held: &N::U) -> Enclosure {
        let path: Path<N::S, N::X> = self.0.in_values();
        let (half, zero) = (N::S::lit(0.5), N::S::ZERO);
        let (time, x) = path.around(half, half);
        let (mut enclosure, mut moves, mut bends) =
            (Enclosure { guards: true, kinks: 0, relevant: Relevant::ALL }, Marks::NONE, 0);
        let known = system.guards_within(time, held, &x, &mut |i, guard: Enclosed<N::S>| {
            let range = guard.range(half);
            // Comparisons with NaN are false.
            if i < N::G::LEN {
                let stays = range.low >= -system.band(i);
                enclosure.guards &= stays;
                if !stays {
                    moves.put(i);
                }
            } else {
                let stays = range.low > zero || range.high <= zero;
                bends |= if stays { 0 } else { kinks::bit(i - N::G::LEN).unwrap_or(0) };
            }
        });
        if !known {
            return Enclosure::unknown(system, held);
        }
        if N::SELECTIVE && !enclosure.guards {
            enclosure.relevant = Relevant::of(system, held, moves);
            enclosure.guards = enclosure.relevant.is_apart(moves);
        }
        if bends != 0 {
            let kinks = Relevant::kinks(system, held, moves);
            enclosure.kinks = if bends & kinks == 0 { 0 } else { kinks };
        }
        enclosure
    }
}

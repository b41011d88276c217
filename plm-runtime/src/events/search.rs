//! Search for the first time in a step at which a guard leaves its side.
//!
//! A step is bisected from its beginning on until every guard is known to stay on its side, or to leave it once: by its range over the
//! interval, by the sign of its slope ([`Enclosed`](crate::Enclosed)). If a guard is so near to zero that this is undecided, bisection ends
//! at a fraction of the step, [`FINEST`], that is shorter than any event that is guaranteed to be found. In short pieces a guard whose
//! enclosure shows that it is smooth is judged by its values too (`piece`).

use super::piece::{Depth, Verdict};
use super::relevant::Relevant;
use super::searched::{Piece, Search};
use crate::method::Path;
use crate::scalar::{Real, Scalar};
use crate::system::{Question, System, value, values};
use crate::tolerances::{
    FINEST, FINEST_OF_POINTS, LOCAL, MANY_PIECES, MOST_INTERVALS, MOST_UNDECIDED, ROUGHEST, SEARCHED_LEAST,
};
use crate::vector::Vector;

/// Halvings up to which the guards at the ends of intervals are stored: they are the ends of shorter intervals too.
const REMEMBERED: usize = 4;

/// Result of a search in a step.
#[derive(Clone, Copy, Debug)]
pub(super) enum Found<S> {
    /// All guards stay on their sides.
    Nothing,
    /// The first guard that does not, and the fraction of the step.
    Crossing(usize, S),
    /// No event up to a fraction of the step; the search beyond would take too long.
    Open(S),
    /// This guard is undecided in many places.
    Undecided(usize),
}

/// Asks for the first event over a step; `residual` has the values by which guards were violated when their events were committed.
pub(super) struct First<'a, S, X, G> {
    pub(super) path: &'a Path<S, X>,
    pub(super) residual: &'a G,
    pub(super) relevant: Relevant,
}

impl<S: Real, X: Vector<S>, G: Vector<S>> Question<S> for First<'_, S, X, G> {
    type Answer = Found<S>;

    fn of<N: System<S: Real<Plain = S::Plain>>>(self, system: &N, held: &N::U) -> Found<S> {
        let Self { path, residual, relevant } = self;
        match Search::new((system, *held), path.in_values(), &values(residual), relevant).first() {
            Found::Nothing => Found::Nothing,
            Found::Crossing(index, theta) => Found::Crossing(index, value(theta)),
            Found::Open(theta) => Found::Open(value(theta)),
            Found::Undecided(index) => Found::Undecided(index),
        }
    }
}

impl<M: System<S: Real>> Search<'_, M> {
    /// First guard that leaves its side.
    pub(super) fn first(&self) -> Found<M::S> {
        let half = M::S::lit(0.5);
        let (mut level, mut index, mut width, mut spent) = (0_u32, 0_u32, M::S::lit(1.0), 0_u32);
        let (mut from, mut left, mut noise) = (M::S::ZERO, self.first, self.noise);
        let (mut resting, mut undecided) = (0, 0);
        // By halvings: the end of the last interval, and its guards.
        let mut ends: [(M::S, M::G); REMEMBERED] = [(M::S::ZERO, self.first); REMEMBERED];
        loop {
            let (to, is_local) = (from + width, level >= LOCAL);
            let known = ends.iter().find(|(end, _)| *end == to).map(|(_, guards)| *guards);
            let right = known.unwrap_or_else(|| self.values(to));
            if let Some(end) = ends.get_mut(level as usize) {
                *end = (to, right);
            }
            let piece = Piece { from, to, left, right, is_local, noise };
            spent += 1;
            if level <= ROUGHEST {
                resting = 0;
            }
            let depth = Depth { level, resting, is_long: spent > MANY_PIECES };
            let mut verdict = self.judge(&piece, depth);
            if level == ROUGHEST && matches!(verdict, Verdict::Open(_)) {
                resting = self.resting(&piece);
                if resting != 0 {
                    verdict = self.judge(&piece, Depth { resting, ..depth });
                }
            }
            if let Verdict::Crossing(i, theta) = verdict {
                return Found::Crossing(i, theta);
            }
            if let Verdict::Open(guard) = verdict {
                if spent > MOST_INTERVALS && from > SEARCHED_LEAST.of::<M::S>() {
                    return Found::Open(from);
                }
                let finest = if spent > MOST_INTERVALS { FINEST_OF_POINTS } else { FINEST };
                if level < finest {
                    (level, index, width) = (level + 1, 2 * index, half * width);
                    if level == LOCAL {
                        noise = self.rounding(from, &left);
                    }
                    continue;
                }
                if let Some((i, theta)) = self.earliest(&piece) {
                    return Found::Crossing(i, theta);
                }
                undecided += u32::from(finest == FINEST);
                if undecided > MOST_UNDECIDED {
                    return Found::Undecided(guard);
                }
            }
            (from, left, index) = (to, piece.right, index + 1);
            while level > 0 && index % 2 == 0 {
                (level, index, width) = (level - 1, index / 2, width + width);
            }
            if level < LOCAL {
                noise = self.noise;
            }
            if level == 0 {
                return Found::Nothing;
            }
        }
    }
}

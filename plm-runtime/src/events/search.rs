//! Search for the first time in a step at which a guard leaves its side.
//!
//! A step is bisected from its beginning on until every guard is known to stay on its side, or to leave it once: by its range over the
//! interval, by the sign of its slope ([`Enclosed`](crate::Enclosed)). If a guard is so near to zero that this is undecided, bisection ends
//! at a fraction of the step, [`FINEST`], that is shorter than any event that is guaranteed to be found. In short pieces a guard whose
//! enclosure shows that it is smooth is judged by its values too (`piece`).

use super::marks::Marks;
use super::piece::{Depth, MANY, Piece, Verdict};
use super::relevant::Relevant;
use super::root::{Point, root};
use super::rounding::rounding;
use crate::enclosure::{Enclosed, Interval};
use crate::method::Path;
use crate::scalar::{Real, Scalar};
use crate::system::{Question, System, value, values};
use crate::vector::Vector;

/// Most halvings of a step: 2^-22 of it is a quarter of a millionth.
const FINEST: u32 = 22;
/// Halvings that are always made if a system cannot enclose its guards.
const ROUGHEST: u32 = 2;
/// Halvings after which nothing more is learnt without enclosures.
const FINEST_OF_POINTS: u32 = 6;
/// A parabola is accepted if its distance from the edge is at least so many times the variation of the guard, ...
const FAR: f64 = 2.0;
/// ... or if it bends by no more than this fraction of half of its change.
const STRAIGHT: f64 = 0.25;
/// Halvings up to which the guards at the ends of intervals are stored: they are the ends of shorter intervals too.
const REMEMBERED: usize = 4;
/// Most intervals of a step that are examined; the remainder is left for the next step.
const MOST: u32 = 4000;
/// Least part of a step that is accepted as searched: four times the part that intervals which all stay open cover.
const LEAST: f64 = 0.002;
/// Most pieces at which bisection ends without a decision on a guard; after more, the guard counts as undecided.
const MOST_UNDECIDED: u32 = 1000;
/// Halvings after which rounding is evaluated at the interval, and not at the beginning of the step.
const LOCAL: u32 = 10;
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

/// Guards over a step.
pub(super) struct Search<'a, M: System> {
    pub(super) system: &'a M,
    pub(super) held: M::U,
    pub(super) path: Path<M::S, M::X>,
    /// Value below which a guard has left its side: zero, or its residual.
    base: M::G,
    /// Fraction of the step from which on a guard is examined.
    pub(super) from: M::G,
    /// Guards at the beginning; for a contact row that comes to its side at once, its guard there.
    first: M::G,
    /// Rounding errors of the guards at the beginning.
    noise: M::G,
    /// Conditions that are examined.
    relevant: Relevant,
    /// The only guard that is examined; `None` for all.
    only: Option<usize>,
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

impl<'a, M: System<S: Real>> Search<'a, M> {
    /// Search over `path`; `residual` has the values by which guards were violated when their events were committed.
    pub(super) fn new(
        (system, held): (&'a M, M::U),
        path: Path<M::S, M::X>,
        residual: &M::G,
        relevant: Relevant,
    ) -> Self {
        let zero = M::G::fill(M::S::ZERO);
        let mut search = Self {
            system,
            held,
            path,
            base: zero,
            from: zero,
            first: zero,
            noise: zero,
            relevant,
            only: None,
        };
        search.first = search.values(M::S::ZERO);
        search.noise = search.rounding(M::S::ZERO, &search.first);
        for i in 0..M::G::LEN {
            if residual.at(i) < M::S::ZERO {
                match search.return_of(i, residual.at(i)) {
                    Some(from) if system.contact_count() > 0 && from <= finest() => {
                        let guard = search.values(from).at(i);
                        search.first.set(i, guard);
                    }
                    Some(from) => search.from.set(i, from),
                    None => search.base.set(i, residual.at(i)),
                }
            }
        }
        search
    }

    /// The search for one guard alone.
    pub(super) fn of_one(&self, index: usize) -> Self {
        Self { only: Some(index), ..*self }
    }

    /// True if this guard is examined.
    pub(super) fn searches(&self, index: usize) -> bool {
        self.only.map_or(self.relevant.has(index), |only| only == index)
    }

    /// True if the guard is violated at a fraction of the step.
    pub(super) fn is_violated(&self, theta: M::S, index: usize) -> bool {
        self.values(theta).at(index) < self.edge(index) - self.noise.at(index)
    }

    /// Value below which a guard is violated, apart from rounding.
    pub(super) fn edge(&self, index: usize) -> M::S {
        self.base.at(index) - self.system.band(index)
    }

    /// First guard that leaves its side.
    pub(super) fn first(&self) -> Found<M::S> {
        let half = M::S::lit(0.5);
        let (mut level, mut index, mut width, mut spent) = (0_u32, 0_u32, M::S::lit(1.0), 0_u32);
        let (mut from, mut left, mut noise) = (M::S::ZERO, self.first, self.noise);
        let (mut resting, mut undecided) = (Marks::NONE, 0);
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
                resting = Marks::NONE;
            }
            let depth = Depth { level, resting, is_long: spent > MANY };
            let mut verdict = self.judge(&piece, depth);
            if level == ROUGHEST && matches!(verdict, Verdict::Open(_)) {
                resting = self.resting(&piece);
                if !resting.is_empty() {
                    verdict = self.judge(&piece, Depth { resting, ..depth });
                }
            }
            if let Verdict::Crossing(i, theta) = verdict {
                return Found::Crossing(i, theta);
            }
            if let Verdict::Open(guard) = verdict {
                if spent > MOST && from > M::S::lit(LEAST) {
                    return Found::Open(from);
                }
                let finest = if spent > MOST { FINEST_OF_POINTS } else { FINEST };
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

    /// The guard that passes its base first in an interval, of those that are violated at its end.
    pub(super) fn earliest(&self, piece: &Piece<M::S, M::G>) -> Option<(usize, M::S)> {
        let mut first: Option<(usize, M::S)> = None;
        for i in (0..M::G::LEN).filter(|i| self.searches(*i)) {
            let is_violated = piece.right.at(i) < self.edge(i) - piece.noise.at(i);
            if is_violated && self.from.at(i) <= piece.from {
                let theta = self.crossing(piece, i);
                if first.is_none_or(|(_, earlier)| theta < earlier) {
                    first = Some((i, theta));
                }
            }
        }
        first
    }

    /// First fraction of the step at which a guard passes its base; at the end of the interval it is violated.
    fn crossing(&self, piece: &Piece<M::S, M::G>, i: usize) -> M::S {
        // A guard that stays on its base has not passed it.
        let above = self.base.at(i) - M::S::EPSILON * piece.noise.at(i);
        let left = Point { at: piece.from, value: piece.left.at(i) - above };
        if left.value <= M::S::ZERO {
            return piece.from;
        }
        let right = Point { at: piece.to, value: piece.right.at(i) - above };
        let (start, end) = (self.path.start, self.path.time(M::S::lit(1.0)));
        let tolerance = M::S::EPSILON * (start.abs().max(end.abs()) / self.path.h).max(M::S::EPSILON);
        root(left, right, tolerance, &mut |theta| self.values(theta).at(i) - above)
    }

    /// Guards at a fraction of the step.
    pub(super) fn values(&self, theta: M::S) -> M::G {
        super::guards(self.system, self.path.time(theta), &self.held, &self.path.at(theta))
    }

    /// Gives the range and the slope of every guard over an interval. Returns false if some are unknown.
    pub(super) fn ranges(
        &self,
        piece: &Piece<M::S, M::G>,
        level: u32,
        mut each: impl FnMut(usize, Interval<M::S>, Interval<M::S>),
    ) -> bool {
        let half = M::S::lit(0.5);
        let (middle, radius) = (half * (piece.from + piece.to), half * (piece.to - piece.from));
        let (time, x) = self.path.around(middle, radius);
        let mut given = Marks::NONE;
        let known = self.system.guards_within(time, &self.held, &x, &mut |i, guard: Enclosed<M::S>| {
            if i < M::G::LEN {
                given.put(i);
                each(i, guard.range(radius), guard.slope);
            }
        });
        if known || level < ROUGHEST {
            return known;
        }
        // By the parabola through three points, if the guard is far from its edge relative to its variation, or nearly straight: a force
        // that swings while nothing moves may go through more than one period in a step.
        let between = self.values(middle);
        for i in (0..M::G::LEN).filter(|i| !given.has(*i)) {
            let (a, b, c) = (piece.left.at(i), between.at(i), piece.right.at(i));
            let (lean, bend) = (half * (c - a), a + c - (b + b));
            let dip = if lean.abs() < bend { half * lean * lean / bend } else { M::S::ZERO };
            let low = a.min(c).min(b - dip);
            // Falling from end to end: a guard that begins on its base may rise before.
            let falls = lean + bend <= M::S::ZERO && lean - bend <= M::S::ZERO;
            let (finest, leaves) = (level >= FINEST_OF_POINTS, c < self.edge(i) - piece.noise.at(i));
            let varies = a.max(b).max(c) - a.min(b).min(c);
            let is_far = low - self.edge(i) >= M::S::lit(FAR) * varies;
            let is_told = is_far || bend.abs() <= M::S::lit(STRAIGHT) * lean.abs();
            let slope = if falls && (is_told || finest || leaves) { -(a - c).abs() } else { M::S::INFINITY };
            let low = match (finest, is_told) {
                (true, _) => a.min(c),
                (false, true) => low,
                (false, false) => -M::S::INFINITY,
            };
            each(i, Interval { low, high: M::S::INFINITY }, Interval { low: -M::S::INFINITY, high: slope });
        }
        true
    }

    /// Error of each guard by rounding of the state and of the time at a fraction of the step, where they are `here`.
    fn rounding(&self, theta: M::S, here: &M::G) -> M::G {
        let (ahead, end) = (self.path.time(theta), self.path.time(M::S::lit(1.0)));
        rounding((self.system, &self.held), (ahead, end), &self.path.at(theta), here)
    }

    /// Fraction of the step at which a guard returns to its side, after it was switched a little before or after its time and was `left`
    /// beyond. `None` if it does not return, or goes farther beyond first, as that of a ball which its own event has thrown back.
    fn return_of(&self, index: usize, left: M::S) -> Option<M::S> {
        let gone = left - self.system.band(index) - self.noise.at(index);
        let mut theta = finest::<M::S>();
        for _ in 0..=FINEST {
            let guard = self.values(theta).at(index);
            if guard > M::S::ZERO {
                return Some(theta);
            }
            if guard < gone {
                return None;
            }
            theta = theta + theta;
        }
        None
    }
}

/// Shortest interval, as a fraction of the step.
fn finest<S: Real>() -> S {
    (0..FINEST).fold(S::lit(1.0), |width, _| S::lit(0.5) * width)
}

//! A search for poses where Newton's steps from the start values find none.
//!
//! Damped steps are led from the start values and from others about them, which are the same in every run; of the poses that
//! close, the one nearest to the start values is taken. Most starts close a loop, whichever joints it has, so that no closed
//! forms are needed.

use super::Absolute;
use super::assemble::{Pose, newton};
use super::assembly::Found;
use super::damped::Measure;
use super::newton::assembly_step;
use super::scale::Scale;
use crate::scalar::Real;
use crate::start::{Start, values};
use crate::vector::Vector;

/// Starts beside the declared one.
const STARTS: u32 = 64;
/// Damped steps from one start, and the part of the violation that each takes away.
const STEPS: (u32, f64) = (60, 1e-3);
/// Evaluations of `phi_q` after which there is no damping any more.
const MOST_WORK: u32 = 100_000;
/// Newton's steps without damping after which the search ends.
const MOST_STEPS: u32 = 300;
/// Newton's steps follow where the violation is below this part of the mechanism's length.
const NEAR: f64 = 1e-3;
/// If the start itself is open by less than this part of the length, redundant lengths disagree: no distant pose is the intended one.
const DISAGREE: f64 = 1e-4;
/// Steps back towards the start values.
const LEANS: u32 = 8;
/// Largest common number of revolutions of gears that is tried: mostly the number of teeth of one of them.
const COMMON_TURNS: u32 = 128;

/// Of the poses that close the joints, the one that misses the fewest images and is nearest to the start values in the metric
/// of assembly; where none was found, the one at which the joints are open least.
#[cold]
#[inline(never)]
pub(super) fn search<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    (start, free): (&[Start<S>; NQ], &[S; NQ]),
    missed: impl Fn(&[S; NQ]) -> usize,
) -> Result<Pose<S, NQ, NC>, [S; NQ]> {
    let start = values(start);
    let mut measure = Measure::new(m, free);
    let mut others = Others::new();
    let (mut best, mut least) = (None::<(usize, S, Pose<S, NQ, NC>)>, (S::INFINITY, start));
    let (mut starts, mut closed, mut steps) = (0, 0, 0);
    while starts <= STARTS {
        let mut q = if starts == 0 {
            start
        } else {
            others.next(&start, free, (m.layout().coordinates.len(), m.length()))
        };
        starts += 1;
        if measure.work < MOST_WORK {
            measure.descend(m, t, &mut q, STEPS);
            let size = measure.size(m, t, &q);
            if size < least.0 {
                least = (size, q);
            }
            // NaN is not near.
            let is_near = size < S::lit(NEAR);
            if !is_near {
                continue;
            }
        } else if steps >= MOST_STEPS {
            break;
        }
        let mut pose = newton(m, t, &q, free);
        steps += pose.iterations;
        if !pose.is_closed(m) {
            if starts == 1 && least.0 < S::lit(DISAGREE) {
                break;
            }
            continue;
        }
        closed += 1;
        unwind(m, t, &mut pose, (&start, free), &nearest_turns);
        lean(m, t, &mut pose, (&start, free), &mut measure);
        let found = (missed(&pose.q), distance(&pose.q, &start));
        if best.is_none_or(|(missed, distance, _)| found < (missed, distance)) {
            best = Some((found.0, found.1, pose));
        }
    }
    match best {
        Some((_, _, pose)) => Ok(Pose { found: Found::Searched { starts, closed }, ..pose }),
        None => Err(least.1),
    }
}

/// The square of the distance in the metric of assembly: metres and radians alike.
fn distance<S: Real, const NQ: usize>(q: &[S; NQ], start: &[S; NQ]) -> S {
    (0..NQ).fold(S::ZERO, |sum, k| {
        let by = q.at(k) - start.at(k);
        by.mul_add(by, sum)
    })
}

/// The number of revolutions whose removal leaves an angle nearest to its start value.
pub(super) fn nearest_turns<S: Real>(_: usize, turns: S) -> S {
    (turns + S::lit(0.5)).floor()
}

/// Removes whole revolutions since the start values, if the joints are closed without them too: of each angle as many as `whole` makes of
/// the revolutions by which it has moved.
#[inline(never)]
pub(super) fn unwind<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    pose: &mut Pose<S, NQ, NC>,
    (start, free): (&[S; NQ], &[S; NQ]),
    whole: &dyn Fn(usize, S) -> S,
) {
    let turn = S::lit(core::f64::consts::TAU);
    let of = |q: &[S; NQ], k: usize| whole(k, (q.at(k) - start.at(k)) / turn);
    let bodies = m.layout().coordinates.len() / 3;
    if (2..3 * bodies).step_by(3).all(|k| of(&pose.q, k) == S::ZERO) {
        return;
    }
    // All bodies together, since joints may tie their angles to each other; else one by one.
    for only in (0..=bodies).map(|body| body.checked_sub(1)) {
        let mut q = pose.q;
        let bodies = (0..bodies).filter(|body| only.is_none_or(|only| only == *body));
        for k in bodies.map(|body| 3 * body + 2).filter(|k| free.at(*k) > S::ZERO) {
            let by = of(&q, k);
            q.set(k, q.at(k) - by * turn);
        }
        if q != pose.q && Scale::of_position(m, &q).is_closed(m, &m.phi(t, &q)) {
            let iterations = pose.iterations;
            *pose = newton(m, t, &q, free);
            pose.iterations += iterations;
        }
    }
    unwind_geared(m, t, pose, (start, free), whole);
}

/// Removes whole revolutions of bodies that gears tie: of all together, in the proportion in which they have turned. The body that has
/// turned most loses as many as it may, or a few less, if that leaves joints closed.
fn unwind_geared<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    pose: &mut Pose<S, NQ, NC>,
    (start, free): (&[S; NQ], &[S; NQ]),
    whole: &dyn Fn(usize, S) -> S,
) {
    let turn = S::lit(core::f64::consts::TAU);
    let bodies = m.layout().coordinates.len() / 3;
    let turns: [S; NQ] = Vector::from_fn(|k| (pose.q.at(k) - start.at(k)) / turn);
    let may = |k: usize| whole(k, turns.at(k)).abs();
    let angles = (0..bodies).map(|body| 3 * body + 2).filter(|k| free.at(*k) > S::ZERO);
    let Some(most) = angles.reduce(|most, k| if may(k) > may(most) { k } else { most }) else { return };
    let mut count = may(most);
    for _ in 0..COMMON_TURNS {
        let is_left = count >= S::lit(1.0);
        if !is_left {
            return;
        }
        let share = count / turns.at(most).abs();
        let mut q = pose.q;
        for k in (0..bodies).map(|body| 3 * body + 2).filter(|k| free.at(*k) > S::ZERO) {
            let by = nearest_turns(k, share * turns.at(k));
            q.set(k, q.at(k) - by * turn);
        }
        if Scale::of_position(m, &q).is_closed(m, &m.phi(t, &q)) {
            let iterations = pose.iterations;
            *pose = newton(m, t, &q, free);
            pose.iterations += iterations;
            return;
        }
        count = count - S::lit(1.0);
    }
}

/// Leads a closed pose towards the start values, in the directions that the joints leave, as long as that brings it nearer.
fn lean<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    pose: &mut Pose<S, NQ, NC>,
    (start, free): (&[S; NQ], &[S; NQ]),
    measure: &mut Measure<S, NQ, NC>,
) {
    let mut share = S::lit(1.0);
    for _ in 0..LEANS {
        let away = distance(&pose.q, start);
        let back = Vector::from_fn(|k| start.at(k) - pose.q.at(k));
        let opened = measure.opened(m, (t, &pose.q), &back);
        let Some(across) = assembly_step(m, t, &pose.q, free, &opened) else { return };
        let along: [S; NQ] = Vector::from_fn(|k| free.at(k) * (back.at(k) - across.at(k)));
        // Where no direction is left there is rounding.
        if distance(&along, &[S::ZERO; NQ]) <= S::EPSILON * away {
            return;
        }
        let q = Vector::from_fn(|k| share.mul_add(along.at(k), pose.q.at(k)));
        let next = newton(m, t, &q, free);
        if next.is_closed(m) && distance(&next.q, start) < away {
            *pose = Pose { iterations: pose.iterations + next.iterations, ..next };
        } else {
            share = share * S::lit(0.25);
        }
    }
}

/// Starts about a start, the same in every run.
struct Others<S> {
    /// Of splitmix64 (G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA 2014).
    state: u64,
    /// How far they reach, as a part of half a turn: an eighth, two, and so on, then from the beginning.
    share: S,
    /// Places change too, every second time.
    with_places: bool,
}

impl<S: Real> Others<S> {
    const fn new() -> Self {
        Self { state: 7, share: S::ZERO, with_places: true }
    }

    /// In -1 to 1, in as many digits as the shorter numbers have, so that it is the same in all.
    fn unit(&mut self) -> S {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        let (mut unit, half) = (S::ZERO, S::lit(0.5));
        for bit in 40..64 {
            let digit = if (z >> bit) & 1 == 1 { S::lit(1.0) } else { S::ZERO };
            unit = half * (unit + digit);
        }
        S::lit(2.0) * unit - S::lit(1.0)
    }

    /// The next start, of so many coordinates; after them there is room, which stays as it is.
    fn next<const NQ: usize>(
        &mut self,
        start: &[S; NQ],
        free: &[S; NQ],
        (own, length): (usize, S),
    ) -> [S; NQ] {
        let all = self.share >= S::lit(1.0);
        self.share = if all { S::lit(0.125) } else { self.share + S::lit(0.125) };
        self.with_places = !self.with_places;
        let angle = self.share * S::lit(core::f64::consts::PI);
        let place = if self.with_places { self.share * length } else { S::ZERO };
        Vector::from_fn(|k| {
            if k >= own {
                return start.at(k);
            }
            let reach = free.at(k) * if k % 3 == 2 { angle } else { place };
            reach.mul_add(self.unit(), start.at(k))
        })
    }
}

//! A search for poses where Newton's steps from the declared start find none, the compiler's twin of the runtime's
//! `absolute/search.rs`: the same starts in the same order.

use crate::collect::CollectVec;

use super::assembly::Start;
use super::constraints::{Closed, Constraints, are_closed, largest};
use super::damped::Measure;

/// Starts beside the declared one.
const STARTS: usize = 64;
/// Damped steps from one start, and the part of the violation that each takes away.
const STEPS: (usize, f64) = (60, 1e-3);
/// Products with the matrix after which there is no damping any more.
const MOST_WORK: usize = 100_000;
/// Newton's steps without damping after which the search ends.
const MOST_STEPS: usize = 300;
/// Newton's steps follow where the violation is below this part of the scene's size.
const NEAR: f64 = 1e-3;
/// Violation that the damped steps leave from the declared start, as a part of the scene's size. If Newton's steps do not close the joints
/// from less than this, the search ends: lengths that repeat each other disagree, and no pose far away was meant.
const DISAGREE: f64 = 1e-4;
/// Steps back towards the start values.
const LEANS: usize = 8;
/// Numbers of turns that gears may have in common, which are tried: the teeth of one of them, mostly.
const COMMON_TURNS: usize = 128;

/// Attempts of a search.
#[derive(Clone, Copy)]
pub(crate) struct Searched {
    /// How many starts.
    pub(crate) starts: usize,
    /// How many of them were closed.
    pub(crate) closed: usize,
}

/// Of the poses that close the joints, the one that misses the fewest images and is nearest to the start values; where none
/// was found, the one at which the joints are open least.
pub(super) fn search(
    search: Search,
    missed: &dyn Fn(&[f64]) -> usize,
) -> (Result<Closed, Vec<f64>>, Searched) {
    let Search { constraints, start, .. } = search;
    let mut measure = Measure::new(constraints, &start.locked);
    let mut others = Others { state: 7, share: 0.0, with_places: true };
    let mut best: Option<(usize, f64, Closed)> = None;
    let mut least = (f64::INFINITY, start.values.clone());
    let (mut tried, mut steps) = (Searched { starts: 0, closed: 0 }, 0);
    while tried.starts <= STARTS {
        let mut q = if tried.starts == 0 {
            start.values.clone()
        } else {
            others.next(start, constraints.scene.length)
        };
        tried.starts += 1;
        if measure.work < MOST_WORK {
            measure.descend(&mut q, STEPS);
            let size = largest(&measure.violation(&q));
            if size < least.0 {
                least = (size, q.clone());
            }
            if size >= NEAR {
                continue;
            }
        } else if steps >= MOST_STEPS {
            break;
        }
        let mut pose = search.close(q);
        steps += pose.steps;
        if !search.is_closed(&pose) {
            if tried.starts == 1 && least.0 < DISAGREE {
                break;
            }
            continue;
        }
        tried.closed += 1;
        search.unwind(&mut pose, &|_, turns| (turns + 0.5).floor());
        search.lean(&mut pose);
        let found = (missed(&pose.q), distance(&pose.q, &start.values));
        if best.as_ref().is_none_or(|(missed, distance, _)| found < (*missed, *distance)) {
            best = Some((found.0, found.1, pose));
        }
    }
    (best.map(|(_, _, pose)| pose).ok_or(least.1), tried)
}

/// Search for closed poses of a scene next to its start.
#[derive(Clone, Copy)]
pub(super) struct Search<'a> {
    pub(super) constraints: &'a Constraints<'a>,
    pub(super) start: &'a Start,
    /// Bounds of `phi` of each row.
    pub(super) limits: &'a dyn Fn(&[f64]) -> Vec<f64>,
}

impl Search<'_> {
    pub(super) fn close(&self, q: Vec<f64>) -> Closed {
        self.constraints.close(q, &self.start.locked, self.limits)
    }

    pub(super) fn is_closed(&self, pose: &Closed) -> bool {
        are_closed(&pose.phi, &(self.limits)(&pose.q))
    }

    /// Takes off whole turns from the start values, where joints are closed without them too: of each angle as many as `whole`
    /// makes of the turns by which it has moved.
    pub(super) fn unwind(&self, pose: &mut Closed, whole: &dyn Fn(usize, f64) -> f64) {
        let bodies = pose.q.len() / 3;
        let of = |q: &[f64], k: usize| whole(k, (q[k] - self.start.values[k]) / std::f64::consts::TAU);
        if (0..bodies).all(|body| of(&pose.q, 3 * body + 2) == 0.0) {
            return;
        }
        // All bodies together, since joints may hold their angles against each other; else one by one.
        for only in (0..=bodies).map(|body| body.checked_sub(1)) {
            let mut q = pose.q.clone();
            for k in (0..bodies).filter(|body| only.is_none_or(|only| only == *body)).map(|body| 3 * body + 2)
            {
                if !self.start.locked[k] {
                    q[k] -= of(&q, k) * std::f64::consts::TAU;
                }
            }
            if q != pose.q && are_closed(&self.constraints.phi(&q), &(self.limits)(&q)) {
                let steps = pose.steps;
                *pose = self.close(q);
                pose.steps += steps;
            }
        }
        self.unwind_geared(pose, whole);
    }

    /// Takes off whole turns of bodies that gears tie: of all together, in the proportion in which they have turned. The body that
    /// has turned most loses as many as it may, or a few less, where that leaves joints closed.
    fn unwind_geared(&self, pose: &mut Closed, whole: &dyn Fn(usize, f64) -> f64) {
        use std::f64::consts::TAU;
        let turns: Vec<f64> =
            pose.q.iter().zip(&self.start.values).map(|(q, start)| (q - start) / TAU).collect_vec();
        let may = |k: usize| whole(k, turns[k]).abs();
        let angles = (0..pose.q.len()).filter(|&k| k % 3 == 2 && !self.start.locked[k]);
        let Some(most) = angles.clone().reduce(|most, k| if may(k) > may(most) { k } else { most }) else {
            return;
        };
        let mut count = may(most);
        for _ in 0..COMMON_TURNS {
            let is_left = count >= 1.0;
            if !is_left {
                return;
            }
            let share = count / turns[most].abs();
            let mut q = pose.q.clone();
            for k in angles.clone() {
                q[k] -= (share * turns[k] + 0.5).floor() * TAU;
            }
            if are_closed(&self.constraints.phi(&q), &(self.limits)(&q)) {
                let steps = pose.steps;
                *pose = self.close(q);
                pose.steps += steps;
                return;
            }
            count -= 1.0;
        }
    }

    /// Leads a closed pose towards the start values, in the directions that the joints leave, as long as that brings it nearer.
    fn lean(&self, pose: &mut Closed) {
        let (start, locked) = (&self.start.values, &self.start.locked);
        let mut share = 1.0;
        for _ in 0..LEANS {
            let away = distance(&pose.q, start);
            let back = start.iter().zip(&pose.q).map(|(start, q)| start - q).collect_vec();
            let opened = self.constraints.phi_q(&pose.q);
            let opened =
                opened.iter().map(|row| row.iter().fold(0.0, |sum, &(k, entry)| sum + entry * back[k]));
            let across = self.constraints.step(&pose.q, locked, &opened.collect_vec());
            let free = |k: usize| if locked[k] { 0.0 } else { 1.0 };
            let along = (0..back.len()).map(|k| free(k) * (back[k] - across[k])).collect_vec();
            let length = along.iter().fold(0.0, |sum, by| sum + by * by);
            // Where no direction is left there is rounding.
            let is_left = length > f64::EPSILON * away;
            if !is_left {
                return;
            }
            let next = self.close(pose.q.iter().zip(&along).map(|(q, by)| q + share * by).collect_vec());
            if self.is_closed(&next) && distance(&next.q, start) < away {
                *pose = Closed { steps: pose.steps + next.steps, ..next };
            } else {
                share *= 0.25;
            }
        }
    }
}

/// The square of the distance in the metric of assembly: metres and radians alike.
fn distance(q: &[f64], start: &[f64]) -> f64 {
    q.iter().zip(start).fold(0.0, |sum, (q, start)| sum + (q - start) * (q - start))
}

/// Starts about a start, the same in every compilation and at run time.
struct Others {
    /// Of splitmix64 (G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA 2014).
    state: u64,
    /// How far they reach, as a part of half a turn: an eighth, two, and so on, then from the beginning.
    share: f64,
    /// Places change too, every second time.
    with_places: bool,
}

impl Others {
    /// In -1 to 1, in 24 digits: as many as the shorter numbers of the runtime have.
    fn unit(&mut self) -> f64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 40) as f64 / f64::from(1 << 23) - 1.0
    }

    /// The next start.
    fn next(&mut self, start: &Start, length: f64) -> Vec<f64> {
        self.share = if self.share >= 1.0 { 0.125 } else { self.share + 0.125 };
        self.with_places = !self.with_places;
        let place = if self.with_places { self.share * length } else { 0.0 };
        let reach = |k: usize| match (start.locked[k], k % 3) {
            (true, _) => 0.0,
            (false, 2) => self.share * std::f64::consts::PI,
            (false, _) => place,
        };
        let reaches = (0..start.values.len()).map(reach).collect_vec();
        reaches.iter().zip(&start.values).map(|(reach, start)| reach * self.unit() + start).collect_vec()
    }
}

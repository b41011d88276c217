//! Verdicts: `plm` beside the reference, and the reference beside itself with slightly changed numbers.

use plm_oracle::Random;
use plm_runtime::contact::Counts;
use plm_runtime::{Cause, Start};

use crate::families::{Draft, FAMILIES, Family};
use crate::reference::run::{Run, Runner, State, Stop};
use crate::reference::world::{Force, Law, World};
use crate::run::{Method, Order, Outcome, Pace};
use crate::stepping::Stepping;

/// Samples are so far apart, s, and there are so many.
pub const EVERY: f64 = 0.1;
pub const SAMPLES: usize = 10;
/// The tolerance of `plm`.
pub const TOLERANCE: f64 = 1e-10;
/// Error of steps alone: at this fraction of the tolerance this share of it is left at most, ...
const FINER: f64 = 0.01;
const LESS: f64 = 0.1;
/// ... and the error is no more than so many times what is allowed.
const MOST_BY_STEPS: f64 = 10.0;
/// Largest error of a motion that does not amplify changes: of a number relative to 1 + its magnitude, of the time of an event in s.
const ALLOWED: f64 = 3e-8;
/// So many times the effect of a change of 1e-9 in the numbers of the mechanism may be off.
const TIMES: f64 = 30.0;
/// Difference of the reference's runs from which on a motion is not compared: a small change has become too large.
const SENSITIVE: f64 = 1e-4;
const CHANGE: f64 = 1e-9;
/// Longest steps of the reference, and of its second run.
const STEPS: [f64; 2] = [0.0125, 0.009];

/// Factors on the width of gaps that the reference closes, in further runs: the result of impacts that follow each other ever faster
/// depends on which of them are counted as one. From one impact to the next the gaps shrink to a fraction, and the last impact is of the one
/// or of the other side as the width decides: a decade in six parts holds both.
const MERGED: [f64; 6] = [1.5, 2.2, 3.2, 4.6, 6.8, 10.0];
/// Most runs of the reference with changed numbers, ...
const CHANGES: usize = 4;
/// ... which are made while the difference is below this share of what is allowed.
const MOST_BY_CHANCE: f64 = 100.0;

/// A case: a family and numbers.
pub struct Case {
    pub family: &'static Family,
    pub draft: Draft,
    pub pace: Pace,
    seeds: Random,
}

/// Verdict on a run of `plm`.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    Right,
    /// Right until a small change becomes large.
    Sensitive,
    /// The reference finds several motions, and `plm` names that, or agrees until there.
    Ambiguous,
    /// The law of impact does not say how an impulse is shared; right until there.
    Undetermined,
    /// No motion satisfies the laws, and `plm` stops there.
    Stopped,
    /// `plm` does not solve so many contacts at once.
    TooMany,
    /// Off by the error of steps, which amounts to something here: it falls with the tolerance, and a hundredth of that is right.
    Coarse(String),
    Wrong(String),
    FalseStop(String),
    /// The reference does not know.
    Unknown(Stop),
}

/// A verdict and what it belongs to.
pub struct Judged {
    pub formulation: &'static str,
    pub pace: Pace,
    pub verdict: Verdict,
    /// The largest difference as a share of what is allowed.
    pub worst: f64,
    /// Comparison with time stepping, of a run without a fault whose verdict is neither right, sensitive nor coarse.
    pub stepping: Option<Stepping>,
    pub impacts: usize,
    pub events: usize,
}

/// The kinds whose name contains the text.
pub fn families(only: Option<&str>) -> Vec<&'static Family> {
    FAMILIES.iter().filter(|family| only.is_none_or(|only| family.name.contains(only))).collect()
}

impl Case {
    /// The case with this number, of those kinds. There is one kind at least.
    pub fn new(seed: u64, number: u64, only: Option<&str>) -> Self {
        let families = families(only);
        let mut random = Random::new(seed, number);
        let family = families[number as usize % families.len()];
        let draft = (family.draw)(&mut random);
        let pace = if random.chance(0.4) { Pace::Watched } else { *random.one_of(&Pace::ALL) };
        Self { family, draft, pace, seeds: random }
    }

    fn start(&self) -> State {
        let (mut q, mut v) = (Vec::new(), Vec::new());
        for [x, y, angle, vx, vy, omega] in &self.draft.starts {
            q.extend([*x, *y, *angle]);
            v.extend([*vx, *vy, *omega]);
        }
        State { t: 0.0, q, v }
    }

    /// The reference's run, and one with other numbers and other steps.
    pub fn reference(&self, steps: [f64; 2]) -> [Run; 2] {
        let known = Runner::new(&self.draft.world, self.start(), steps[0]).go(&times());
        [known, self.changed(&mut self.seeds.clone(), steps[1])]
    }

    /// The reference's run with numbers that are a little off.
    fn changed(&self, random: &mut Random, longest: f64) -> Run {
        let (world, factor) = changed(&self.draft.world, random);
        let mut start = self.start();
        start.v.iter_mut().for_each(|v| *v *= factor);
        Runner::new(&world, start, longest).go(&times())
    }

    /// The reference's runs that close wider gaps, so that more impacts are counted as one.
    fn merged(&self) -> impl Iterator<Item = Run> {
        let runner = || Runner::new(&self.draft.world, self.start(), STEPS[1]);
        MERGED.into_iter().map(move |factor| runner().merging(factor).go(&times()))
    }

    pub fn run(&self, formulation: usize, method: Method) -> Outcome {
        self.with_order(method, |order| self.family.run(formulation, order))
    }

    /// The outcome of a run by a method, which `run` makes by its order.
    pub fn with_order(&self, method: Method, run: impl FnOnce(&Order) -> Outcome) -> Outcome {
        let starts: Vec<Start<f64>> = self.draft.starts.iter().flatten().copied().map(Start::free).collect();
        run(&Order { numbers: &self.draft.numbers, starts: &starts, every: EVERY, samples: SAMPLES, method })
    }

    /// Every formulation at a pace that was drawn.
    pub fn judge(&self) -> Vec<Judged> {
        let [mut known, other] = self.reference(STEPS);
        let mut others = vec![other];
        // Where it has lost a bend of the accelerations, shorter steps find it.
        if matches!(known.stop, Some((_, Stop::Lost))) {
            let [shorter, other] = self.reference(STEPS.map(|h| 0.1 * h));
            (known, others) = (shorter, vec![other]);
        }
        let (mut judged, mut has_merged, mut changes) = (Vec::new(), false, 1);
        let mut random = self.seeds.clone();
        for (number, (formulation, _)) in self.family.declarations.iter().enumerate() {
            // Those that are asked for one after the other differ by their pace.
            let pace = if number == 0 { self.pace } else { Pace::Watched };
            let outcome = self.run(number, Method::Events { pace, tolerance: TOLERANCE });
            let (mut verdict, mut worst) = self.compare((&known, &others), &outcome, pace);
            if matches!(verdict, Verdict::Wrong(_)) && !has_merged {
                has_merged = true;
                others.extend(self.merged());
                (verdict, worst) = self.compare((&known, &others), &outcome, pace);
            }
            // One change of the numbers may by chance be one that has little effect.
            while matches!(verdict, Verdict::Wrong(_)) && worst < MOST_BY_CHANCE && changes < CHANGES {
                changes += 1;
                random.bits();
                others.push(self.changed(&mut random.clone(), STEPS[1]));
                (verdict, worst) = self.compare((&known, &others), &outcome, pace);
            }
            if let Verdict::Wrong(what) = &verdict
                && self.is_coarse((&known, &others), (number, pace), worst)
            {
                verdict = Verdict::Coarse(what.clone());
            }
            let is_open = !matches!(verdict, Verdict::Right | Verdict::Sensitive | Verdict::Coarse(_));
            let stepping =
                (is_open && outcome.fault.is_none()).then(|| Stepping::beside(self, number, &outcome));
            let (impacts, events) = (known.impacts, known.events.len());
            judged.push(Judged { formulation, pace, verdict, worst, stepping, impacts, events });
        }
        judged
    }

    /// Is a run that is off by the share `worst` of what is allowed so by the error of its steps?
    fn is_coarse(&self, runs: (&Run, &[Run]), (number, pace): (usize, Pace), worst: f64) -> bool {
        let finer = self.run(number, Method::Events { pace, tolerance: FINER * TOLERANCE });
        let (verdict, share) = self.compare(runs, &finer, pace);
        worst <= MOST_BY_STEPS && !matches!(verdict, Verdict::Wrong(_)) && share <= LESS * worst
    }

    fn compare(&self, (known, others): (&Run, &[Run]), outcome: &Outcome, pace: Pace) -> (Verdict, f64) {
        let start = outcome.samples.first().map(|first| difference(&first.q, &first.v, &self.start()));
        if start.is_none_or(|start| start > 1e-11) {
            let verdict = match &outcome.fault {
                Some(fault) if known.stop.is_some_and(|(t, stop)| t == 0.0 && stop == Stop::Nothing) => {
                    let _ = fault;
                    Verdict::Stopped
                }
                Some(fault) => stop(fault.cause, fault.to_string()),
                None => Verdict::Wrong(format!("starts {start:?} off")),
            };
            return (verdict, 0.0);
        }
        let apart = apart(known, others);
        let mut worst: f64 = 0.0;
        for sample in &outcome.samples[1..] {
            let k = sample.index;
            let Some(state) = known.samples.get(k - 1).filter(|_| apart[k] < SENSITIVE) else { break };
            let off = difference(&sample.q, &sample.v, state);
            let energies = self.energies(state);
            let off = energies.iter().zip(&sample.energies).fold(off, |off: f64, (known, found)| {
                off.max((known - found).abs() / (1.0 + energies[0].abs() + energies[1].abs()))
            });
            let share = off / (ALLOWED + TIMES * apart[k]);
            if !(share <= 1.0) {
                return (Verdict::Wrong(format!("{off:.1e} off at {:.3} s", state.t)), share);
            }
            worst = worst.max(share);
        }
        if pace == Pace::Watched
            && let Some((what, share)) = missed(known, others, outcome, &apart)
        {
            return (Verdict::Wrong(what), share.max(worst));
        }
        (ends(known, others, outcome, &apart), worst)
    }

    fn energies(&self, state: &State) -> [f64; 2] {
        let world = &self.draft.world;
        let lift = |k: usize| -world.inertia[k] * world.gravity[k % 3] * state.q[k];
        let height = (0..state.q.len()).filter(|k| k % 3 != 2).map(lift).sum();
        [world.kinetic(&state.v), height]
    }
}

fn stop(cause: Cause, told: String) -> Verdict {
    if matches!(cause, Cause::TooManyContacts { .. }) { Verdict::TooMany } else { Verdict::FalseStop(told) }
}

/// The largest difference of two states, as a share of 1 and the number.
fn difference(q: &[f64], v: &[f64], known: &State) -> f64 {
    let pairs = q.iter().zip(&known.q).chain(v.iter().zip(&known.v));
    pairs.fold(0.0, |worst: f64, (found, known)| {
        let off = (found - known).abs() / (1.0 + known.abs());
        if off.is_nan() { f64::INFINITY } else { worst.max(off) }
    })
}

/// Times of samples, s.
fn times() -> Vec<f64> {
    (1..=SAMPLES).map(|k| EVERY * k as f64).collect()
}

/// How far the runs of the reference are apart, until each sample.
fn apart(known: &Run, others: &[Run]) -> Vec<f64> {
    let mut apart = vec![0.0; SAMPLES + 1];
    for k in 0..SAMPLES {
        let from = |other: &Run| match (known.samples.get(k), other.samples.get(k)) {
            (Some(one), Some(two)) => difference(&one.q, &one.v, two),
            _ => f64::INFINITY,
        };
        apart[k + 1] = others.iter().map(from).fold(apart[k], f64::max);
    }
    apart
}

/// Every event of the reference that velocities jump at has one of `plm` at its time; else how far the nearest is, and as a share of
/// what is allowed.
fn missed(known: &Run, others: &[Run], outcome: &Outcome, apart: &[f64]) -> Option<(String, f64)> {
    let until = outcome.fault.as_ref().map_or(f64::INFINITY, |fault| fault.time);
    let nearest = |times: &mut dyn Iterator<Item = f64>, t: f64| {
        times.map(|time| (time - t).abs()).fold(f64::INFINITY, f64::min)
    };
    for event in known.events.iter().filter(|event| event.t > 0.0 && event.t < until && event.jump > 1e-3) {
        let k = (event.t / EVERY).ceil() as usize;
        if apart.get(k).is_none_or(|apart| *apart >= SENSITIVE) {
            return None;
        }
        let nearest_of = |other: &Run| nearest(&mut other.events.iter().map(|event| event.t), event.t);
        let own = others.iter().map(nearest_of).fold(0.0, f64::max);
        let off = nearest(&mut outcome.events.iter().copied(), event.t);
        let share = off / (ALLOWED + TIMES * own);
        if share > 1.0 && off < f64::INFINITY || outcome.events.is_empty() {
            return Some((format!("an event at {:.6} s is {off:.1e} s off", event.t), share));
        }
    }
    None
}

/// The world with numbers a little off, and a factor for velocities.
fn changed(world: &World, random: &mut Random) -> (World, f64) {
    let mut world = world.clone();
    let mut near = |number: &mut f64| *number *= 1.0 + CHANGE * random.unit();
    world.gravity.iter_mut().for_each(&mut near);
    for body in world.inertia.chunks_mut(3) {
        near(&mut body[0]);
        body[1] = body[0];
        near(&mut body[2]);
    }
    for force in &mut world.forces {
        match force {
            Force::On { constant, amplitude, .. } => [constant, amplitude].into_iter().for_each(&mut near),
            Force::Spring { stiffness, damping, .. } => {
                [stiffness, damping].into_iter().for_each(&mut near);
            }
        }
    }
    for (_, law) in &mut world.rows {
        match law {
            Law::Gap { restitution } => near(restitution),
            Law::Rub(bound) => {
                bound.own.iter_mut().for_each(&mut near);
                bound.by.iter_mut().for_each(|(_, mu)| near(mu));
                bound.joint.iter_mut().for_each(|(_, _, mu)| near(mu));
            }
        }
    }
    let mut factor = 1.0;
    near(&mut factor);
    (world, factor)
}

/// Has the run told of several motions, or ended?
fn is_named(outcome: &Outcome) -> bool {
    let Counts { ambiguous, ambiguous_impacts, .. } = outcome.counts;
    ambiguous + ambiguous_impacts > 0 || outcome.fault.is_some()
}

/// A verdict on how both end, all samples being right.
fn ends(known: &Run, others: &[Run], outcome: &Outcome, apart: &[f64]) -> Verdict {
    let reached = apart.iter().position(|apart| *apart >= SENSITIVE);
    match (&outcome.fault, known.stop) {
        (None, None) if reached.is_none() => Verdict::Right,
        (Some(fault), Some((t, Stop::Nothing))) if (fault.time - t).abs() < 1e-3 => Verdict::Stopped,
        (Some(fault), _) if matches!(fault.cause, Cause::TooManyContacts { .. }) => Verdict::TooMany,
        (Some(fault), None) => {
            // Beyond where small changes are large the motion is another one.
            let is_sensitive = reached.is_some_and(|k| EVERY * (k as f64 - 1.0) <= fault.time);
            if is_sensitive { Verdict::Sensitive } else { stop(fault.cause, fault.to_string()) }
        }
        (_, Some((_, Stop::Ambiguous))) if is_named(outcome) => Verdict::Ambiguous,
        (_, Some((t, Stop::Ambiguous))) => Verdict::Wrong(format!("not named as ambiguous at {t:.4} s")),
        (_, Some((t, Stop::Nothing)))
            if others.iter().all(|other| other.stop.is_some_and(|(_, stop)| stop == Stop::Nothing)) =>
        {
            Verdict::Wrong(format!("goes on beyond {t:.4} s, where no motion satisfies the laws"))
        }
        (None, None) | (_, Some((_, Stop::Nothing))) => Verdict::Sensitive,
        (_, Some((_, Stop::Undetermined))) => Verdict::Undetermined,
        (_, Some((_, stop))) => Verdict::Unknown(stop),
    }
}

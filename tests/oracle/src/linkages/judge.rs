//! Verdicts on cases: `plm` beside the reference.

use plm_runtime::{Cause, Fault};

use crate::cases::Case;
use crate::reference::dd::Dd;
use crate::reference::{Accuracy, Begin, Course, Stop, assemble, follow};
use crate::run::{By, EVERY, Order, Outcome, Seen};
use crate::trial::Trial;

/// The reference, from less to more exact. What two of them differ by tells how exact they are; near misses need more.
const STAGES: [Accuracy; 4] = [
    Accuracy { order: 18, tolerance: 1e-12 },
    Accuracy { order: 22, tolerance: 1e-16 },
    Accuracy { order: 25, tolerance: 1e-19 },
    Accuracy { order: 30, tolerance: 1e-24 },
];
/// Largest difference of two successive stages, as a fraction of the size, at which the reference knows the motion.
const KNOWN: f64 = 1e-8;
/// The start is moved by so much, rad or m, to see what becomes of it.
const MOVED: f64 = 1e-9;
/// A motion that multiplies such a change by more than this may be off by that much more.
pub const LIVELY: f64 = 1000.0;

/// Offsets, m, below which the reference may not know the motion.
const SLIGHT: f64 = 1e-13;

/// How a case is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// The formulation that the compiler takes.
    Default,
    /// `formulation: absolute;`
    Absolute,
    /// The default in f32, by rustc.
    Single,
}

impl Mode {
    pub const ALL: [Self; 3] = [Self::Default, Self::Absolute, Self::Single];

    pub fn name(self) -> &'static str {
        match self {
            Self::Default => "default",
            Self::Absolute => "absolute",
            Self::Single => "f32",
        }
    }

    /// How far a sample may be off, as a fraction of the size: a thousand times the tolerance.
    pub fn allowed(self, by: By) -> f64 {
        if self == Self::Single { 1e-3 } else { 1e3 * by.tolerance() }
    }

    pub fn run(self, case: &Case, order: &Order) -> Outcome {
        match self {
            Self::Default => case.entry.run(0, order),
            Self::Absolute => case.entry.run(1, order),
            #[cfg(feature = "compiled")]
            Self::Single => (case.entry.compiled.single)(order),
            #[cfg(not(feature = "compiled"))]
            Self::Single => unreachable!("only rustc has f32"),
        }
    }

    fn epsilon(self) -> f64 {
        if self == Self::Single { f64::from(f32::EPSILON) } else { f64::EPSILON }
    }
}

/// Verdict on a run of a case.
#[derive(Clone, Debug)]
pub enum Verdict {
    Right,
    /// Off by the error of steps, which amounts to something here, and falls with the tolerance.
    Coarse,
    /// It ended `Ok`, and was off.
    WrongOk,
    /// It was ended where the reference goes on.
    FalseStop(Fault),
    /// Numbers of this precision cannot tell which motion it is.
    Undecidable,
    /// The reference does not know the motion well enough.
    Unknown(Option<Stop>),
}

impl Verdict {
    /// Nothing of `plm` is wrong.
    pub fn holds(&self) -> bool {
        matches!(self, Self::Right | Self::Coarse | Self::Undecidable)
    }
}

/// A verdict with figures.
#[derive(Clone, Debug)]
pub struct Judged {
    pub mode: Mode,
    pub verdict: Verdict,
    /// The largest error as a fraction of the size, of all samples that were given, and the time of the first that is off
    /// by more than allowed.
    pub worst: f64,
    pub first: Option<f64>,
    /// Estimated error of the reference, and the factor by which the motion multiplies a change at its start.
    pub own: f64,
    pub lively: f64,
    /// Two runs with the same samples, fault and number of steps have the same fingerprint.
    pub fingerprint: u64,
    /// Evaluations of the rates.
    pub evaluations: u64,
}

/// The reference's motion, as far as a comparison needs it.
pub struct Known {
    pub samples: Vec<Seen>,
    pub sizes: Sizes,
    /// By how much a change at the start has grown until each sample.
    pub growth: Vec<f64>,
    own: f64,
}

/// Sizes of quantities in the motion: errors are fractions of them.
pub struct Sizes {
    length: f64,
    angle: f64,
    speed: f64,
    /// Angular velocities count at the reach.
    turn: f64,
    energy: f64,
}

/// A case by all modes, or by those in f64; only rustc has f32.
pub fn judge(case: &Case, double: bool) -> Vec<Judged> {
    judge_by(case, double, known(case, double).as_ref())
}

/// The reference's motion, or why it is not known.
pub fn known(case: &Case, double: bool) -> Result<Known, Option<Stop>> {
    // Where no mode can decide, what is costliest is not asked for.
    let some = modes(double).any(|mode| case.decidable(mode.epsilon()));
    if some { know(case) } else { Err(None) }
}

/// As [`judge`], beside a motion that is known already.
pub fn judge_by(case: &Case, double: bool, known: Result<&Known, &Option<Stop>>) -> Vec<Judged> {
    modes(double).map(|mode| one(case, mode, known)).collect()
}

fn modes(double: bool) -> impl Iterator<Item = Mode> {
    let has_single = cfg!(feature = "compiled") && !double;
    Mode::ALL.into_iter().filter(move |mode| has_single || *mode != Mode::Single)
}

fn one(case: &Case, mode: Mode, known: Result<&Known, &Option<Stop>>) -> Judged {
    let mut judged = Judged {
        mode,
        verdict: Verdict::Undecidable,
        worst: f64::NAN,
        first: None,
        own: f64::NAN,
        lively: f64::NAN,
        fingerprint: 0,
        evaluations: 0,
    };
    if !case.decidable(mode.epsilon()) {
        return judged;
    }
    let known = match known {
        Ok(known) => known,
        Err(stop) => {
            // What misses a pose by so little that the reference does not know is nobody's mistake.
            let slight = case.offset.is_some_and(|offset| offset.abs() < SLIGHT);
            judged.verdict = if slight { Verdict::Undecidable } else { Verdict::Unknown(*stop) };
            return judged;
        }
    };
    judged.own = known.own;
    judged.lively = known.growth.last().copied().unwrap_or(f64::NAN);
    let by = if mode == Mode::Default || case.by.fixed() { case.by } else { By::Dop853 };
    let trial = Trial { case, mode, by, known, lively: judged.lively };
    let run = trial.run(1.0);
    (judged.fingerprint, judged.evaluations) = (run.outcome.fingerprint(), run.outcome.evaluations);
    (judged.worst, judged.first) = (run.worst, run.first);
    judged.verdict = match (trial.excuse(&run), run.outcome.fault) {
        (Some(excuse), _) => excuse,
        (None, Some(fault)) if is_slight(case, &fault) => Verdict::Undecidable,
        (None, Some(fault)) => Verdict::FalseStop(fault),
        (None, None) if run.ratio > 1.0 => Verdict::WrongOk,
        (None, None) => Verdict::Right,
    };
    if matches!(judged.verdict, Verdict::Right) {
        judged.first = None;
    }
    judged
}

/// Is the difference of lengths that a stop names one that numbers of 16 digits cannot tell? Several loops that each miss a flat pose by
/// the offset may together miss one by its square.
fn is_slight(case: &Case, fault: &Fault) -> bool {
    let of_loops = case.offset.is_some_and(|offset| offset * offset < SLIGHT);
    of_loops && matches!(fault.cause, Cause::Undecided { gap } if gap < SLIGHT)
}

fn know(case: &Case) -> Result<Known, Option<Stop>> {
    let times: Vec<f64> = (1..=case.samples).map(|index| EVERY * index as f64).collect();
    let course = |state, accuracy| follow(&case.scene, state, &times, accuracy).map_err(Some);
    // What misses a flat pose by little is never known by the least exact one.
    let mut stage = usize::from(case.offset.is_some());
    let mut coarse = course(case.state.clone(), STAGES[stage])?;
    let (fine, sizes, own) = loop {
        let fine = course(case.state.clone(), STAGES[stage + 1])?;
        let sizes = Sizes::of(case, &fine);
        let pairs = seen(&coarse).into_iter().zip(seen(&fine));
        let own = pairs.fold(0.0_f64, |own, (a, b)| own.max(sizes.error(&a, &b)));
        if own < KNOWN {
            break (fine, sizes, own);
        }
        stage += 1;
        if stage + 1 == STAGES.len() {
            return Err(None);
        }
        coarse = fine;
    };
    let (begin, by) = moved(case);
    let other = course(assemble(&case.scene, &begin).map_err(Some)?, STAGES[stage])?;
    let mut most = 0.0_f64;
    let growth = seen(&other).into_iter().zip(seen(&coarse)).map(|(a, b)| {
        most = most.max(sizes.error(&a, &b) / by);
        most
    });
    Ok(Known { growth: growth.collect(), samples: seen(&fine), sizes, own })
}

/// The start moved by a little, and by how much.
fn moved(case: &Case) -> (Begin, f64) {
    let mut begin = case.begin.clone();
    // Next to a flat pose it stays on its side.
    let by = case.flat.map_or(MOVED, |angle| MOVED.min(1e-3 * angle.abs()));
    if begin.locked.is_empty() {
        // Every other way, so that no freedom is left out.
        begin.q.iter_mut().enumerate().for_each(|(i, q)| *q += if i % 2 == 0 { by } else { -by });
    } else {
        begin.locked.iter().for_each(|index| begin.q[*index] += by);
    }
    (begin, by)
}

fn seen(course: &Course) -> Vec<Seen> {
    let samples = course.samples.iter().enumerate();
    let bodies = |q: &[Dd], v: &[Dd]| {
        let both = q.chunks(3).zip(v.chunks(3));
        both.map(|(q, v)| [q[0], q[1], q[2], v[0], v[1], v[2]].map(|value| value.hi)).collect()
    };
    samples
        .map(|(index, s)| Seen { index, bodies: bodies(&s.q, &s.v), energy: s.energy.map(|value| value.hi) })
        .collect()
}

impl Sizes {
    fn of(case: &Case, course: &Course) -> Self {
        let scene = &case.scene;
        let ports = scene.bodies.iter().flat_map(|body| &body.ports).chain(&scene.ground);
        let reach = ports.fold(0.1_f64, |reach, port| reach.max(port[0].hypot(port[1])));
        let samples = seen(course);
        let all = || samples.iter().flat_map(|sample| &sample.bodies);
        let length = all().fold(reach, |length, body| length.max(body[0].abs()).max(body[1].abs()));
        let angle = all().fold(1.0_f64, |angle, body| angle.max(body[2].abs()));
        // What rests has the size of what could move: a thousandth of a fall from its own height.
        let weight: f64 = scene.bodies.iter().map(|body| body.mass).sum();
        let least = 0.03 * (9.81 * reach).sqrt();
        let speed =
            all().fold(least, |speed, body| speed.max(body[3].hypot(body[4])).max(body[5].abs() * reach));
        let energies = samples.iter().map(|sample| sample.energy);
        let [low, high] = energies.clone().fold([f64::INFINITY, -f64::INFINITY], |[low, high], energy| {
            [low.min(energy[1]), high.max(energy[1])]
        });
        let moves = energies.fold(high - low, |moves, energy| moves.max(energy[0]));
        Self { length, angle, speed, turn: speed / reach, energy: moves.max(0.5 * weight * least * least) }
    }

    /// The largest error of a sample, as a fraction of the size.
    pub fn error(&self, found: &Seen, known: &Seen) -> f64 {
        let mut worst = 0.0_f64;
        let mut take = |found: f64, known: f64, size: f64| {
            let error = (found - known).abs() / size;
            worst = if error.is_nan() { f64::INFINITY } else { worst.max(error) };
        };
        for (found, known) in found.bodies.iter().zip(&known.bodies) {
            let sizes = [self.length, self.length, self.angle, self.speed, self.speed, self.turn];
            (0..6).for_each(|k| take(found[k], known[k], sizes[k]));
        }
        (0..2).for_each(|k| {
            take(found.energy[k], known.energy[k], self.energy.max(known.energy[k].abs() * 1e-3));
        });
        worst
    }
}

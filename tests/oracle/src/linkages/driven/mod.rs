//! Prescribed drives of linkages with decimal lengths beside their closed forms: where they can go no further, and where they are
//! until then.
//!
//! A crank `r1` at the origin is driven at a constant rate; a dyad of the bars `r2` and `r3`, or of `r2` and a guide, follows. The
//! circles about both ends of the dyad meet while the distance of its ends is between the difference and the sum of its bars.

mod drive;
mod linkages;

use std::f64::consts::PI;

use plm_oracle::{Look, Random};
use plm_runtime::method::RadauIia5;
use plm_runtime::{Cause, Dop853, Fault, Mechanism as _, Method, Moment as _, Rk4};

use self::drive::Drive;
use self::linkages::DECLARATIONS;
use crate::mechanisms::Eight;
use crate::run::fold;

/// Runs last so long, s.
const LENGTH: f64 = 2.0;
/// A lock-up is told so exactly, s and rad or m.
const EXACT: f64 = 1e-8;
/// Within so many evaluations after the last step.
const AT_ONCE: u64 = 200;

/// Outcome of a run: its end, the places of two points of the dyad, m, and evaluations.
struct Run {
    end: Result<(), Fault>,
    time: f64,
    places: [[f64; 2]; 2],
    evaluations: u64,
}

/// A drive by a method until a time, by a pace: intervals of this length; one that is not positive is the whole run at once.
fn run(driven: &Driven, method: impl Method<Eight>, until: f64) -> Result<Run, Fault> {
    let Driven { drive, pace, absolute, .. } = *driven;
    let declaration = DECLARATIONS[usize::from(absolute)][drive.kind];
    let built = plm_oracle::with_numbers(declaration, &drive.numbers(), &drive.starts());
    let built: Eight = built.expect("the declaration has the numbers of its kind");
    let mut sim = built.start_with(method)?;
    let end = if pace > 0.0 {
        let count = (until / pace).ceil() as u64;
        (1..=count).try_for_each(|k| sim.step_to((k as f64 * pace).min(until)))
    } else {
        sim.step_to(until)
    };
    let mut bodies = Vec::new();
    Eight::bodies(sim.state(), |body| bodies.push([body.x, body.y, body.angle]));
    let [x, y, angle] = bodies[1];
    let r2 = drive.bars[1];
    let far = if drive.kind == 0 {
        [x + r2 * angle.cos(), y + r2 * angle.sin()]
    } else {
        [bodies[2][0], bodies[2][1]]
    };
    let (time, evaluations) = (sim.state().time(), sim.stats().evaluations);
    Ok(Run { end, time, places: [[x, y], far], evaluations })
}

/// A drive with the way in which it is run.
struct Driven {
    drive: Drive,
    by: usize,
    pace: f64,
    absolute: bool,
}

/// Verdict on a drive.
pub struct Told {
    /// It locks up.
    pub locks: bool,
    /// Failure in words, if there is one.
    pub wrong: Option<String>,
    /// Of its end: places, time and fault.
    pub fingerprint: u64,
    /// Evaluations of the rates.
    pub evaluations: u64,
}

impl Driven {
    fn draw(seed: u64, number: u64) -> Self {
        let mut random = Random::new(seed ^ 0x5eed, number);
        let drive = loop {
            if let Some(drive) = Drive::draw(&mut random).filter(Drive::is_plain) {
                break drive;
            }
        };
        let (by, pace) = (random.below(3), *random.one_of(&[0.0, 0.1, 0.01, 0.001]));
        Self { drive, by, pace, absolute: random.chance(0.5) }
    }

    fn told(&self) -> Told {
        let Self { drive, by, pace, absolute } = self;
        let (mut fingerprint, mut evaluations) = (0, 0);
        let wrong = judge(self, |run| {
            let places = run.places.iter().flatten().chain([&run.time]).map(|number| number.to_bits());
            let fault = format!("{:?}", run.end).into_bytes();
            fingerprint = fold(run.evaluations, places.chain(fault.into_iter().map(u64::from)));
            evaluations = run.evaluations;
        });
        let wrong =
            wrong.map(|what| format!("{drive:?}, method {by}, {pace} s, absolute {absolute}: {what}"));
        Told { locks: drive.lock().is_some(), wrong, fingerprint, evaluations }
    }
}

/// Failure of a case in words, if there is one; `seen` is given the run if it starts.
fn judge(driven: &Driven, seen: impl FnOnce(&Run)) -> Option<String> {
    let Driven { drive, by, .. } = driven;
    let lock = drive.lock();
    let go = |until: f64| match by {
        0 => run(driven, Dop853::default(), until),
        1 => run(driven, RadauIia5::new(1e-8), until),
        _ => run(driven, Rk4::new(1e-3), until),
    };
    let run = match go(LENGTH) {
        Ok(run) => run,
        Err(fault) => return Some(format!("not started: {fault}")),
    };
    seen(&run);
    let known = drive.places(run.time, drive.left);
    let off = (0..2).fold(0.0_f64, |off, k| {
        off.max((run.places[k][0] - known[k][0]).abs()).max((run.places[k][1] - known[k][1]).abs())
    });
    // Next to the lock-up places have the root of the time's rounding.
    if !(off < 1e-5) {
        return Some(format!("off by {off:.1e} m at {} s", run.time));
    }
    match (lock, run.end) {
        (None, Ok(())) => None,
        (None, Err(fault)) => Some(format!("stopped, {fault}")),
        (Some(lock), Ok(())) => Some(format!("went on past {lock}")),
        (Some(lock), Err(fault)) => {
            let Cause::LockedAt { row, value, .. } = fault.cause else {
                return Some(format!("{fault}, known {lock} s"));
            };
            let whole = if drive.kind == 2 {
                value
            } else {
                value + ((drive.held(lock) - value) / (2.0 * PI)).round() * 2.0 * PI
            };
            let told = row.starts_with("motor")
                && (fault.time - lock).abs() < EXACT
                && (whole - drive.held(lock)).abs() < EXACT;
            if !told || lock - run.time > 0.02 {
                return Some(format!("{fault}, known {lock} s, stopped at {} s", run.time));
            }
            let before = go(run.time).map_or(0, |before| before.evaluations);
            let after = run.evaluations.saturating_sub(before);
            (after > AT_ONCE).then(|| format!("{after} evaluations after the last step"))
        }
    }
}

/// So many drives of a seed, run.
pub fn all(seed: u64, count: u64) -> Vec<Told> {
    let points = plm_studies::batch::points((0..count).collect::<Vec<u64>>()).quiet();
    let runs = points.run(|number| Ok(Driven::draw(seed, number).told()));
    runs.all().expect("what is wrong with a drive is a value")
}

/// So many drives of a seed; whether all are right.
pub fn sweep(seed: u64, count: u64, verbose: bool) -> bool {
    let (mut wrong, mut locks, mut evaluations, mut fingerprint) = (0, 0, 0, 0);
    for (number, told) in all(seed, count).iter().enumerate() {
        locks += u64::from(told.locks);
        wrong += u64::from(told.wrong.is_some());
        evaluations += told.evaluations;
        fingerprint = fold(fingerprint, [told.fingerprint].into_iter());
        if let Some(told) = told.wrong.as_ref().filter(|_| verbose) {
            println!("--seed {seed} drive {number}  {told}");
        }
    }
    println!(
        "{count} prescribed drives, {locks} lock up, {wrong} wrong; {evaluations} evaluations, all bits {fingerprint:016x}"
    );
    wrong == 0
}

//! Linkages whose dyads become flat, several of them at once, beside their closed forms: a run ends, or stops at once with its true cause.
//!
//! A crank is driven, and the motion ends at the time at which trigonometry says that a dyad no longer closes; or it moves freely, with its
//! energy. The work of both is bounded.

mod linkage;

use std::f64::consts::TAU;

use plm_dynamic::{Error, Mechanism, Small};
use plm_run::AnyMethod;
use plm_runtime::{BodyState, Cause, Described as _, Dop853, Fault, Mechanism as _, Moment as _, Rk4};

use self::linkage::{Linkage, Point};
use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// A time of a lock-up is told so exactly, s, and the value of its row, rad.
const EXACT: f64 = 1e-7;
/// Places of pins away from flat poses, m.
const PLACED: f64 = 1e-6;
/// Most steps of a run, made or refused: a thousand of fixed length in 64 parts each.
const MOST_STEPS: u64 = 64_000;
/// Most of them near singular poses: a pose that is missed by rounding takes two hundred, and a turn of the crank has ten poses at most.
const MOST_NEAR: u64 = 2000;
/// Steps of fixed length.
const FIXED: f64 = 1000.0;
/// Change of the energy of a free motion, as a part of it: with error control, and with steps of fixed length.
const ENERGY: [f64; 2] = [1e-5, 1e-2];
/// Dyads that come so near to flat without being it, m, may go on by either branch.
const TOUCHED: f64 = 1e-5;

/// The motion of a crank, rad and s.
#[derive(Clone, Copy, Debug)]
struct Motion {
    from: f64,
    rate: f64,
    driven: bool,
    absolute: bool,
    fixed: bool,
    pace: f64,
    end: f64,
}

pub(crate) fn case(draw: &mut Draw) -> Case {
    let (linkage, motion) = loop {
        let linkage = linkage::draw(draw);
        if let Some(motion) = motion(draw, &linkage) {
            break (linkage, motion);
        }
    };
    let text = text(&linkage, &motion);
    let verdict = judged(&linkage, &motion, &text);
    let kind = if motion.driven { "driven" } else { "free" };
    let text = format!("{text}\n{motion:?}, {linkage:?}");
    Case { family: format!("{} {kind}", linkage.family), text, verdict }
}

/// A start away from flat poses, of which some are near.
fn motion(draw: &mut Draw, linkage: &Linkage) -> Option<Motion> {
    let from = draw.number(-3.0, 3.0, &[0.0, 1.0, 0.5]);
    let speed = draw.number(0.2, 8.0, &[1.0, TAU]);
    let rate = if draw.chance(0.5) { speed } else { -speed };
    if linkage.reach(from).partial_cmp(&1e-3) != Some(std::cmp::Ordering::Greater) {
        return None;
    }
    let end = 4.0 / speed;
    let driven = draw.chance(0.6);
    // Now and then it begins beside the flat pose, where the bars of a dyad are faster than the crank by the root of the distance.
    let near = *draw.one_of(&[1e-2, 1e-3, 1e-5]);
    let (from, rate) = match (linkage.lock(from, rate * end), draw.below(8)) {
        (Some(lock), 0) if driven => (lock - rate.signum() * near, rate),
        (Some(lock), 0) => (lock - rate.signum() * near, rate * near.sqrt()),
        _ => (from, rate),
    };
    Some(Motion {
        from,
        rate,
        driven,
        absolute: draw.chance(0.5),
        fixed: draw.chance(0.3),
        pace: *draw.one_of(&[end, end, 0.1 * end, 0.01 * end]),
        end,
    })
}

/// The declaration: bars of one length from where they stand, of which assembly closes the rest.
fn text(linkage: &Linkage, motion: &Motion) -> String {
    let Motion { from, rate, driven, absolute, .. } = *motion;
    let points: Vec<Point> = linkage.points(from).into_iter().flatten().collect();
    let (at, length) = linkage.crank;
    let given = if driven { "" } else { &format!(", locked; start omega: {rate:?} rad/s, locked") };
    let mut items = bar("crank", [points[at], points[linkage.tip()]], length, given);
    items += &format!("revolute jc(ground.g{at}, crank.a);\n");
    let mut pins: Vec<String> = (0..linkage.ground.len()).map(|k| format!("ground.g{k}")).collect();
    pins.push("crank.b".to_owned());
    for (k, dyad) in linkage.dyads.iter().enumerate() {
        let pin = points[linkage.tip() + 1 + k];
        for (side, name) in ["l", "r"].iter().enumerate() {
            let (name, end) = (format!("{name}{k}"), dyad.ends[side]);
            items += &bar(&name, [points[end], pin], dyad.bars[side], "");
            items += &format!("revolute j{name}({}, {name}.a);\n", pins[end]);
        }
        items += &format!("revolute p{k}(l{k}.b, r{k}.b);\n");
        pins.push(format!("l{k}.b"));
    }
    let mut ports = String::new();
    for (k, [x, y]) in linkage.ground.iter().enumerate() {
        ports += &format!("port g{k}: ({x:?}, {y:?}) m; ");
    }
    let formulation = if absolute { "formulation: absolute; " } else { "" };
    if driven {
        items += &format!("constraint motor: crank.angle = {from:?} rad + {rate:?} rad/s*t;\n");
    }
    format!("pub Linkage {{ {formulation}allow(W0001); ground {{ {ports}}}\n{items}}}")
}

fn bar(name: &str, [from, to]: [Point; 2], length: f64, more: &str) -> String {
    let ([x, y], angle) = (from, (to[1] - from[1]).atan2(to[0] - from[0]));
    format!(
        "body {name} {{ mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: ({length:?}, 0) m;
    start x: {x:?} m; start y: {y:?} m; start angle: {angle:?} rad{more}; }}\n"
    )
}

/// The end of a run.
struct Ended {
    fault: Option<Fault>,
    time: f64,
    /// Steps, made or refused, and those near singular poses.
    steps: u64,
    near: u64,
    /// At the start and at the end, J.
    energy: [f64; 2],
    /// Foot and angle of each bar: the crank, and two of each dyad.
    bars: Vec<[f64; 3]>,
}

fn run(text: &str, motion: &Motion) -> Result<Ended, Error> {
    let method: AnyMethod<Small> = if motion.fixed {
        Rk4::new(motion.end / FIXED).into()
    } else {
        Dop853::new(1e-9).with_most_steps(MOST_STEPS / 3).into()
    };
    let mut sim = Mechanism::from_text(text)?.small()?.start_with(method)?;
    let begin = sim.kinetic_energy();
    let count = (motion.end / motion.pace).round() as u64;
    let end = (1..=count).try_for_each(|k| sim.step_to(motion.end * k as f64 / count as f64));
    let stats = sim.stats();
    let mut bars = Vec::new();
    Small::poses(sim.state(), &mut |body: BodyState<f64>| bars.push([body.x, body.y, body.angle]));
    Ok(Ended {
        fault: end.err(),
        time: sim.state().time(),
        steps: stats.steps + stats.rejected,
        near: stats.near_singular,
        energy: [begin, sim.kinetic_energy()],
        bars,
    })
}

fn judged(linkage: &Linkage, motion: &Motion, text: &str) -> Verdict {
    let ended = match run(text, motion) {
        Ok(ended) => ended,
        Err(error) => return Verdict::Wrong(format!("not started: {error}")),
    };
    let told = ended.fault.as_ref().map_or_else(|| "ended".to_owned(), ToString::to_string);
    let work = format!("{} steps, {} near singular poses: {told}", ended.steps, ended.near);
    if ended.steps > MOST_STEPS || ended.near > MOST_NEAR {
        return Verdict::Wrong(work);
    }
    if motion.driven { driven(linkage, motion, &ended) } else { free(linkage, motion, &ended) }
}

/// A driven crank beside trigonometry: the time at which a dyad no longer closes, and the places until then.
fn driven(linkage: &Linkage, motion: &Motion, ended: &Ended) -> Verdict {
    let way = motion.rate * motion.end;
    let lock = linkage.lock(motion.from, way);
    let until = lock.map_or(way, |angle| angle - motion.from);
    let told = ended.fault.as_ref().map_or_else(|| "it ended".to_owned(), ToString::to_string);
    let error = match (lock, &ended.fault) {
        (None, None) => off(linkage, motion, ended) / PLACED,
        (Some(lock), Some(fault)) => misses(motion, lock, ended, fault) / EXACT,
        _ => f64::INFINITY,
    };
    if error < 1.0 {
        Verdict::Right(error)
    } else if linkage.touched(motion.from, until) < TOUCHED {
        Verdict::Undecided(format!("it touches a flat pose before; {told}"))
    } else {
        let known = lock.map(|angle| (angle - motion.from) / motion.rate);
        Verdict::Wrong(format!(
            "{told}; by trigonometry it locks up at {known:?} s; {error:.1e} of the bound"
        ))
    }
}

/// By how much a fault misses the lock-up at an angle of the crank, s or rad.
fn misses(motion: &Motion, angle: f64, ended: &Ended, fault: &Fault) -> f64 {
    let known = (angle - motion.from) / motion.rate;
    match fault.cause {
        Cause::LockedAt { row: "motor", value, .. } if ended.time <= known => {
            let turns = ((angle - value) / TAU).round() * TAU;
            (fault.time - known).abs().max((value + turns - angle).abs())
        }
        _ => f64::INFINITY,
    }
}

/// The largest distance of a pin from its place at the end, m.
fn off(linkage: &Linkage, motion: &Motion, ended: &Ended) -> f64 {
    let pins = linkage.points(motion.from + motion.rate * ended.time).into_iter().skip(linkage.tip() + 1);
    pins.enumerate().fold(0.0_f64, |off, (k, pin)| {
        let ([x, y, angle], length) = (ended.bars[1 + 2 * k], linkage.dyads[k].bars[0]);
        let [px, py] = pin.unwrap_or([f64::INFINITY; 2]);
        off.max((x + length * angle.cos() - px).hypot(y + length * angle.sin() - py))
    })
}

/// A free motion keeps its energy. Lengths that miss equal ones by next to nothing may leave it to rounding how it goes on.
fn free(linkage: &Linkage, motion: &Motion, ended: &Ended) -> Verdict {
    let ([begin, end], bound) = (ended.energy, ENERGY[usize::from(motion.fixed)]);
    let error = (end / begin - 1.0).abs();
    match &ended.fault {
        Some(fault) => match fault.cause {
            Cause::Undecided { .. } | Cause::Disagree { .. } | Cause::StepTooSmall { .. }
                if linkage.off != 0.0 =>
            {
                Verdict::Stopped(fault.to_string())
            }
            _ => Verdict::Wrong(fault.to_string()),
        },
        None if error < bound => Verdict::Right(error / bound),
        None => Verdict::Wrong(format!("{end} J of {begin} J")),
    }
}

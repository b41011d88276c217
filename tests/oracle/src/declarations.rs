//! Every declaration of the book, of parts, examples and benchmarks, by every method: the motion of `Dop853` at 1e-12.
//!
//! A case is a declaration, a formulation, a method with its tolerance or step, and a pace. A seed puts all of them in an order, so that a
//! count draws so many, and a count as large as there are cases runs each once. A run may be off by a multiple of its tolerance, which
//! grows as errors of the reference's method grow; by steps of fixed length it may be off by a multiple of what half and twice
//! the step change, and after events by what moves in some steps. Where this is a large part of the motion nothing is decided,
//! nor where a run that is off a little is off by a fifth with a hundredth of its tolerance: its steps err, of order 2 where they are stiff.

mod reference;
mod texts;

use plm_dynamic::{Error, Integrator, Mechanism, Run};
use plm_runtime::{Cause, Fault};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

pub(crate) use self::reference::Scene;
use self::reference::{Reference, TIMES, What, names, numbers};
pub(crate) use self::texts::scenes;

/// A method by its name, and by its tolerance or its longest step.
type Named = (&'static str, fn(f64) -> Integrator);

/// Methods with error control, and tolerances.
const BY_ERROR: [Named; 5] = [
    ("Dop853", Integrator::Dop853),
    ("Dopri5", Integrator::Dopri5),
    ("Vern9", Integrator::Vern9),
    ("Adams", Integrator::Adams),
    ("RadauIia5", Integrator::RadauIia5),
];
/// The middle one stands for the default of each method.
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 0.0, 1e-10, 1e-12];
/// Methods of fixed steps, and steps, s.
const OF_LENGTH: [Named; 5] = [
    ("Rk4", Integrator::Rk4),
    ("Gauss2", Integrator::Gauss2),
    ("Ros34Pw2", Integrator::Ros34Pw2),
    ("SemiImplicitEuler", Integrator::SemiImplicitEuler),
    ("MoreauJean", Integrator::MoreauJean),
];
const STEPS: [f64; 3] = [5e-3, 2e-3, 1e-3];
const METHODS: usize = BY_ERROR.len() * TOLERANCES.len() + OF_LENGTH.len() * STEPS.len();

/// Runs are off by so many times the tolerance as grown, and by so many times what other steps change.
const OF_TOLERANCE: f64 = 100.0;
const OF_CHANGE: f64 = 20.0;
/// A run that is off by at most so many times its bound is made again by a tolerance so many times finer.
const OF_STEPS: f64 = 100.0;
/// Events are late by so many steps.
const LATE: f64 = 4.0;
/// The least tolerance that numbers of joints that are closed to rounding come up to.
const LEAST: f64 = 1e-11;
/// A bound of so much of the motion decides nothing.
const NOTHING: f64 = 0.2;

/// A method with its number.
#[derive(Clone, Copy)]
enum Way {
    ByError(fn(f64) -> Integrator, f64),
    OfLength(fn(f64) -> Integrator, f64),
}

/// How often a run is asked to stop.
enum Pace {
    Once,
    Regular,
    /// So many ends between two times that are compared, each as a part of the way.
    Irregular(Vec<f64>),
}

/// Declarations whose motion rounding decides, with what it decides.
const BY_ROUNDING: [(&str, &str); 1] =
    [("parts/pin_slot", "the reach of the bars is exactly the upper limit, which they touch at no speed")];

/// How a run went.
struct Went {
    at: Vec<Vec<f64>>,
    stop: Option<Fault>,
}

/// A case by its number in the list.
pub(crate) fn case(draw: &mut Draw) -> Case {
    let scenes = scenes();
    let pairs = scenes.iter().map(|scene| scene.texts.len()).sum::<usize>();
    let count = pairs * METHODS * 3;
    let Some(place) = draw.place_in(count) else {
        let said = format!("there are {count} cases, which came before");
        return Case { family: "-".to_owned(), text: String::new(), verdict: Verdict::Undecided(said) };
    };
    let (mut pair, method, pace) = (place / METHODS / 3, place / 3 % METHODS, place % 3);
    let Some(scene) = scenes.iter().find(|scene| {
        let is_here = pair < scene.texts.len();
        if !is_here {
            pair -= scene.texts.len();
        }
        is_here
    }) else {
        return Case {
            family: "-".to_owned(),
            text: String::new(),
            verdict: Verdict::Wrong("no scene".to_owned()),
        };
    };
    let decides = BY_ROUNDING.iter().find(|(page, _)| scene.place.ends_with(page));
    let (name, way) = way(method);
    let (said, pace) = match pace {
        0 => ("one interval".to_owned(), Pace::Once),
        1 => ("100 intervals".to_owned(), Pace::Regular),
        _ => {
            let parts = parts(draw);
            (format!("each quarter ended at {parts:?} of it"), Pace::Irregular(parts))
        }
    };
    let text = format!("{}\n{}\nby {name}, {}, {said}", scene.place, scene.texts[pair], way.said());
    let verdict = match decides {
        Some((_, what)) => Verdict::Undecided((*what).to_owned()),
        None => judged(scene, pair, way, &pace),
    };
    Case { family: name.to_owned(), text, verdict }
}

/// A method by its number.
fn way(number: usize) -> (&'static str, Way) {
    let by_error = BY_ERROR.len() * TOLERANCES.len();
    if number < by_error {
        let (name, make) = BY_ERROR[number / TOLERANCES.len()];
        let given = TOLERANCES[number % TOLERANCES.len()];
        let tolerance = if given > 0.0 { given } else { default(name) };
        return (name, Way::ByError(make, tolerance));
    }
    let (name, make) = OF_LENGTH[(number - by_error) / STEPS.len()];
    (name, Way::OfLength(make, STEPS[number % STEPS.len()]))
}

/// The tolerance that a method has by itself.
fn default(name: &str) -> f64 {
    match Integrator::by_name(name, None) {
        Some(
            Integrator::Dop853(rtol)
            | Integrator::Dopri5(rtol)
            | Integrator::Vern9(rtol)
            | Integrator::Adams(rtol)
            | Integrator::RadauIia5(rtol),
        ) => rtol,
        _ => f64::NAN,
    }
}

/// Ends of intervals within a part of the way, some of them very near to others.
fn parts(draw: &mut Draw) -> Vec<f64> {
    let mut parts: Vec<f64> =
        (0..=draw.below(6)).map(|_| draw.number(0.001, 0.999, &[1e-9, 1e-6, 0.5, 1.0 - 1e-6])).collect();
    parts.sort_by(f64::total_cmp);
    parts.dedup();
    parts
}

impl Way {
    /// Does it find impacts and the ends of slips?
    fn has_events(self) -> bool {
        let Self::OfLength(make, step) = self else { return true };
        !matches!(make(step), Integrator::MoreauJean(_))
    }

    fn said(self) -> String {
        match self {
            Self::ByError(_, tolerance) => format!("tolerance {tolerance:e}"),
            Self::OfLength(_, step) => format!("steps of {step:e} s"),
        }
    }
}

fn judged(scene: &Scene, formulation: usize, way: Way, pace: &Pace) -> Verdict {
    let reference = match scene.reference() {
        Ok(reference) => reference,
        Err(error) => return without(scene, formulation, way, &error),
    };
    let machine = match scene.machine(formulation) {
        Ok(machine) => machine,
        Err(error) => return Verdict::Undecided(format!("there is none in absolute coordinates: {error}")),
    };
    if reference.end <= 0.0 && reference.stop.is_none() {
        return Verdict::Undecided("the reference takes too many steps".to_owned());
    }
    let (method, others) = match way {
        Way::ByError(make, tolerance) => (make(tolerance), Vec::new()),
        Way::OfLength(make, step) => (make(step), vec![make(step / 2.0), make(2.0 * step)]),
    };
    let others: Vec<_> = others.into_iter().map(|method| run(machine, method, pace, reference)).collect();
    match run(machine, method, pace, reference) {
        Err(Error::Fault(fault)) => stopped(reference, way, fault),
        Err(error) => Verdict::Wrong(error.to_string()),
        Ok(went) => compared(machine, reference, way, pace, &went, &others),
    }
}

/// A declaration that has no motion: another run must have the same cause.
fn without(scene: &Scene, formulation: usize, way: Way, error: &Error) -> Verdict {
    let (Way::ByError(make, number) | Way::OfLength(make, number)) = way;
    match (error, scene.machine(formulation).and_then(|machine| machine.start_with(make(number)))) {
        (Error::NotGiven(_) | Error::Refused(_), _) | (_, Err(Error::Refused(_))) => {
            Verdict::Undecided(error.to_string())
        }
        (Error::Fault(other), Err(Error::Fault(own))) if is_same(&own, other) => {
            Verdict::Stopped(own.to_string())
        }
        (_, Err(own)) => Verdict::Wrong(format!("it does not start by {own}, the reference by {error}")),
        (_, Ok(_)) => Verdict::Wrong(format!("it starts, the reference does not: {error}")),
    }
}

/// Runs to the end of the reference, and on to where it stops.
fn run(machine: &Mechanism, method: Integrator, pace: &Pace, reference: &Reference) -> Result<Went, Error> {
    let mut run = machine.start_with(method)?;
    let mut at = Vec::new();
    let mut stop = None;
    if reference.end > 0.0 {
        for k in 0..TIMES {
            match to(&mut run, pace, k, reference) {
                Err(Error::Fault(fault)) => {
                    return Ok(Went { at, stop: Some(fault) });
                }
                other => other?,
            }
            if !matches!(pace, Pace::Once) || k + 1 == TIMES {
                at.push(numbers(&run));
            }
        }
    }
    if reference.last() > reference.end {
        match run.step_to(reference.last()) {
            Err(Error::Fault(fault)) => stop = Some(fault),
            other => other?,
        }
    }
    Ok(Went { at, stop })
}

/// To the next time that is compared.
fn to(run: &mut Run, pace: &Pace, number: usize, reference: &Reference) -> Result<(), Error> {
    let (from, to) = (run.time(), reference.time(number));
    match pace {
        Pace::Once if number + 1 < TIMES => return Ok(()),
        Pace::Once => {}
        Pace::Regular => {
            for k in 1..25 {
                run.step_to(from + (to - from) * f64::from(k) / 25.0)?;
            }
        }
        Pace::Irregular(parts) => {
            for part in parts {
                run.step_to(from + (to - from) * part)?;
            }
        }
    }
    run.step_to(to)
}

/// A run that stopped before its end.
fn stopped(reference: &Reference, way: Way, fault: Fault) -> Verdict {
    if let Way::OfLength(_, step) = way {
        let is_named = matches!(
            fault.cause,
            Cause::StepTooLong { .. }
                | Cause::NotConverged { .. }
                | Cause::TurnedTooFar { .. }
                | Cause::Drift { .. }
        );
        // The numbers of steps that do not follow the motion leave it anywhere.
        let is_long = step > reference.step || reference.stop.is_some_and(|other| other.time < LATE * step);
        if is_named || is_long {
            return Verdict::Stopped(fault.to_string());
        }
    }
    let Some(other) = reference.stop else {
        return Verdict::Wrong(format!("a stop that the reference does not make: {fault}"));
    };
    let lag = match way {
        Way::ByError(..) => 0.01 * other.time + 1e-6,
        Way::OfLength(_, step) => 0.02 * other.time + LATE * step,
    };
    if is_same(&fault, &other) && (fault.time - other.time).abs() <= lag {
        Verdict::Stopped(fault.to_string())
    } else {
        Verdict::Wrong(format!("it stops by {fault}; the reference by {other}"))
    }
}

/// Have two faults one cause, whatever its numbers?
fn is_same(a: &Fault, b: &Fault) -> bool {
    std::mem::discriminant(&a.cause) == std::mem::discriminant(&b.cause)
}

fn compared(
    machine: &Mechanism,
    reference: &Reference,
    way: Way,
    pace: &Pace,
    went: &Went,
    others: &[Result<Went, Error>],
) -> Verdict {
    if let Some(fault) = went.stop {
        return stopped(reference, way, fault);
    }
    if let Some(fault) = reference.stop {
        let is_step = matches!(way, Way::OfLength(..));
        let said = format!("no stop, where the reference stops by {fault}");
        return if is_step { Verdict::Undecided(said) } else { Verdict::Wrong(said) };
    }
    let what = if way.has_events() { What::All } else { What::Poses };
    let bound = match way {
        Way::ByError(_, tolerance) => OF_TOLERANCE * reference.growth * tolerance.max(LEAST),
        Way::OfLength(_, step) => {
            // Steps that are too long stop, which is another case.
            let ran = others.iter().flatten().filter(|other| other.stop.is_none());
            let change: f64 = ran.map(|other| reference.apart(&went.at, &other.at, what)).sum();
            let late = if reference.has_events { LATE * step * reference.rate } else { 0.0 };
            OF_CHANGE * change + late + OF_TOLERANCE * reference.growth * LEAST.max(1e-9)
        }
    };
    let off = reference.apart(&went.at, &reference.at, what);
    if bound > NOTHING {
        return Verdict::Undecided(format!("off by {off:.1e}, which may be {bound:.1e} of the motion"));
    }
    if off <= bound {
        return Verdict::Right(off / bound);
    }
    if let Way::ByError(make, tolerance) = way
        && off <= OF_STEPS * bound
        && let Ok(finer) = run(machine, make(tolerance / OF_STEPS), pace, reference)
        && finer.stop.is_none()
        && reference.apart(&finer.at, &reference.at, what) <= off / 5.0
    {
        return Verdict::Undecided(format!(
            "off by {off:.1e}, bound {bound:.1e}, and less by a finer tolerance"
        ));
    }
    Verdict::Wrong(format!(
        "off by {off:.1e} of the motion, bound {bound:.1e}{}",
        difference(machine, reference, went)
    ))
}

/// The numbers that differ most, in their sizes, with their time.
fn difference(machine: &Mechanism, reference: &Reference, went: &Went) -> String {
    let names = machine.start().map(|run| names(&run)).unwrap_or_default();
    let first = TIMES - went.at.len();
    let mut by = Vec::new();
    for (k, own) in went.at.iter().enumerate() {
        let other = &reference.at[first + k];
        for (name, ((a, b), scale)) in names.iter().zip(own.iter().zip(other).zip(&reference.scales)) {
            by.push(((a - b).abs() / scale, reference.time(first + k), name, a, b));
        }
    }
    by.sort_by(|a, b| b.0.total_cmp(&a.0));
    let said = |(_, time, name, a, b): &(f64, f64, &String, &f64, &f64)| {
        format!("; at {time:.4} s {name} {a:.9e}, expected {b:.9e}")
    };
    by.iter().take(4).map(said).collect()
}

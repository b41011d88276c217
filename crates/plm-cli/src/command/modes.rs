//! `plm modes`: frequencies, dampings and shapes of the modes of a declaration.

use std::f64::consts::TAU;
use std::path::PathBuf;

use plm_dynamic::{Error, OnStart};
use plm_runtime::held::Discrete;
use plm_runtime::{BodyState, Described, Fault, Linear, Moment, StartValues, Statics};
use plm_studies::analysis::{Linearisation, Shape, linearise};
use plm_view::{Page, Recorder, Recording, Results};
use serde_json::{Value, json};

use super::run::refused;
use super::start::Start;
use super::words::Words;
use super::{Command, Failure, Outcome, Streams};

pub(super) const COMMAND: Command = Command {
    name: "modes",
    usage: "FILE …",
    title: "frequencies, dampings and shapes of the modes near an equilibrium",
    options: &[
        ("--set NAME=VALUE", "a parameter, in its declared unit or with one"),
        ("--input NAME=VALUE", "an input, in its declared unit or with one"),
        ("--as-started", "at the start itself, which need not be an equilibrium"),
        ("--view FILE", "writes a page in which the mechanism swings along each mode (HTML)"),
        ("--json", "an object of JSON instead of a table"),
    ],
    run,
};

/// Samples of a period of a picture, how long it lasts there, s, and how many there are.
const SAMPLES: usize = 40;
const PERIOD: f64 = 2.0;
const PERIODS: usize = 2;
/// The largest turn of a picture, rad, and the largest way over the size of the mechanism.
const LARGEST: f64 = 0.2;

fn run(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let (is_as_started, is_json) = (words.takes("--as-started"), words.takes("--json"));
    let view = words.value("--view").map(PathBuf::from);
    let start = Start::asked(words, streams)?;
    let found = start.mechanism().and_then(|mechanism| Ok(mechanism.at_start(Find { is_as_started })?));
    let found = match found {
        Ok(found) => found,
        Err(failure) => return refused(failure, streams),
    };
    let Found { system, recordings, name } = match found {
        Ok(found) => found,
        Err(Lacking::Fault(fault)) => return refused(Error::from(fault).into(), streams),
        Err(Lacking::Equilibrium(why)) => {
            writeln!(
                streams.errors,
                "plm: there is no equilibrium near the start: {why}; `--as-started` takes the start"
            )?;
            return Ok(Outcome::Wrong);
        }
    };
    if is_json {
        writeln!(streams.output, "{}", json(&system))?;
    } else {
        write!(streams.output, "{}", table(&system))?;
    }
    if let Some(path) = view {
        if recordings.is_empty() {
            return Err("no mode oscillates: there is nothing to be shown".into());
        }
        let results = Results { runs: recordings, ..Results::default() };
        Page::new(&results.to_bytes()?, name).write_html(path)?;
    }
    Ok(Outcome::Good)
}

/// A line for each mode: eigenvalue, frequency and damping, and what swings most.
fn table(system: &Linearisation) -> String {
    let head = "mode  frequency (rad/s)  frequency (Hz)  damping   eigenvalue (1/s)           shape\n";
    let line = |(number, shape): (usize, &Shape)| {
        let mode = shape.mode;
        let lambda = mode.eigenvalue;
        let imaginary = if lambda.im > 0.0 { format!(" +- {:.5e}i", lambda.im) } else { String::new() };
        let eigenvalue = format!("{:.5e}{imaginary}", lambda.re);
        // A number that is rounded to zero has no sign.
        let damping = if mode.damping.abs() < 5e-5 { 0.0 } else { mode.damping };
        format!(
            "{:>4}  {:>17.6e}  {:>14.6e}  {damping:>7.4}   {eigenvalue:<25}  {}\n",
            number + 1,
            mode.frequency,
            mode.frequency / TAU,
            parts(system, shape)
        )
    };
    std::iter::once(head.to_owned()).chain(system.shapes().iter().enumerate().map(line)).collect()
}

/// Modes as JSON: shapes as amplitude and phase, rad, of each coordinate.
fn json(system: &Linearisation) -> Value {
    let mode = |shape: &Shape| {
        let mode = shape.mode;
        let own = system.states.iter().zip(&shape.vector).take(system.coordinates);
        let parts = own.map(
            |(name, part)| json!({ "coordinate": name, "amplitude": part.norm(), "phase_rad": part.arg() }),
        );
        json!({
            "frequency_rad_per_s": mode.frequency,
            "frequency_Hz": mode.frequency / TAU,
            "damping": mode.damping,
            "eigenvalue_per_s": [mode.eigenvalue.re, mode.eigenvalue.im],
            "shape": parts.collect::<Vec<_>>(),
        })
    };
    json!({ "modes": system.shapes().iter().map(mode).collect::<Vec<_>>() })
}

/// Coordinates that take part, with amplitude and phase over the largest.
fn parts(system: &Linearisation, shape: &Shape) -> String {
    let own = system.states.iter().zip(&shape.vector).take(system.coordinates);
    let taken = own.filter(|(_, part)| part.norm() > 1e-3).map(|(name, part)| {
        let phase = part.arg().to_degrees().round();
        match phase {
            // A half turn is a sign.
            phase if phase.abs() < 1.0 => format!("{name} {:.3}", part.norm()),
            phase if phase.abs() > 179.0 => format!("{name} {:.3}", -part.norm()),
            phase => format!("{name} {:.3} at {phase} deg", part.norm()),
        }
    });
    taken.collect::<Vec<_>>().join(", ")
}

/// Work on a start: the modes near an equilibrium.
struct Find {
    is_as_started: bool,
}

struct Found {
    system: Linearisation,
    /// A swing along each mode that oscillates.
    recordings: Vec<Recording>,
    /// Name of the mechanism.
    name: &'static str,
}

enum Lacking {
    Fault(Fault),
    Equilibrium(String),
}

impl From<Fault> for Lacking {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl OnStart for Find {
    type Output = Result<Found, Lacking>;

    fn on<M>(self, start: &M::State) -> Self::Output
    where
        M: Described<S = f64, U: Discrete> + Statics + Linear<Lifted<1>: Described + Statics>,
    {
        let state = if self.is_as_started { *start } else { at_rest::<M>(start)? };
        let system = linearise(&state)?;
        let swings =
            system.shapes().into_iter().enumerate().filter(|(_, shape)| shape.mode.eigenvalue.im > 0.0);
        let recordings = swings.map(|(number, shape)| swing::<M>(&state, (number, &shape))).collect();
        Ok(Found { system, recordings, name: state.mechanism().tables().name })
    }
}

/// The equilibrium near a state: with what starts lock, or without locks where they hold the mechanism away from it.
fn at_rest<M>(state: &M::State) -> Result<M::State, Lacking>
where
    M: Described<S = f64> + Statics + Linear<Lifted<1>: Described + Statics>,
{
    let mut rest = plm_studies::analysis::stabilise(state)?;
    if !rest.residuals.is_empty() {
        let mut free = *state.mechanism();
        free.starts_mut().each(&mut |_, start| start.locked = false);
        rest =
            plm_studies::analysis::stabilise(&M::State::new(free, state.held(), state.time(), *state.x()))?;
    }
    let rest = rest.balanced().map_err(|why| Lacking::Equilibrium(why.to_string()))?;
    Ok(*rest.start()?.state())
}

/// A recording of a swing along a mode, without damping, slowly.
fn swing<M: Described<S = f64>>(state: &M::State, (number, shape): (usize, &Shape)) -> Recording {
    let amplitude = amplitude::<M>(state, shape);
    let mode = shape.mode;
    let name = format!("mode {}: {:.4e} rad/s, damping {:.3}", number + 1, mode.frequency, mode.damping);
    let mut recorder = Recorder::<M>::new(state).named(name);
    for sample in 0..=PERIODS * SAMPLES {
        let share = sample as f64 / SAMPLES as f64;
        // From the equilibrium.
        let mut moved = shape.moved(state, (amplitude, TAU * (share - 0.25)));
        let (held, x) = (moved.held(), *moved.x());
        moved.set(PERIOD * share, &held, &x);
        recorder.take(&moved);
    }
    recorder.into_recording()
}

/// The amplitude with which the largest turn or way is as large as is well seen.
fn amplitude<M: Described<S = f64>>(state: &M::State, shape: &Shape) -> f64 {
    let poses = |of: &M::State| {
        let mut all: Vec<BodyState<f64>> = Vec::new();
        M::poses(of, &mut |pose| all.push(pose));
        all
    };
    let (rest, small) = (poses(state), 1e-4);
    let size =
        rest.iter().flat_map(|a| rest.iter().map(move |b| (a.x - b.x).hypot(a.y - b.y))).fold(0.0, f64::max);
    let size = if size > 0.0 { size } else { 1.0 };
    let mut largest = 0.0_f64;
    for phase in [0.0, 0.25 * TAU] {
        for (a, b) in rest.iter().zip(poses(&shape.moved(state, (small, phase)))) {
            largest = largest.max((b.x - a.x).hypot(b.y - a.y) / size).max((b.angle - a.angle).abs());
        }
    }
    if largest > 0.0 { small * LARGEST / largest } else { LARGEST }
}

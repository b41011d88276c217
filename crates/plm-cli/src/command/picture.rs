//! `plm picture`: a drawing of a declaration at its start or at a later time, as SVG or PNG.

use plm_dynamic::{OnRun, Run};
use plm_runtime::described::Place;
use plm_runtime::{Described, Method, Moment, Sim};
use plm_view::{Sketch, mechanism};

use super::run::{refused, write_whole};
use super::start::Start;
use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::checked::Declarations;

pub(super) const COMMAND: Command = Command {
    name: "picture",
    usage: "FILE …",
    title: "draws a declaration at its start or at a later time (SVG, PNG)",
    options: &[
        ("--at SECONDS", "the time of the pose; without it the start"),
        ("--set NAME=VALUE", "a parameter, in its declared unit or with one"),
        ("--input NAME=VALUE", "an input, in its declared unit or with one"),
        ("--svg FILE", "where it is written as SVG; without it and `--png` the standard output"),
        ("--png FILE", "where it is written in pixels, 1200 wide"),
    ],
    run,
};

fn run(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let at = words.value("--at").map(|text| time(&text)).transpose()?;
    let (svg, png) = (words.value("--svg"), words.value("--png"));
    let start = Start::asked(words, streams)?;
    let posed = || -> Result<Run, Failure> {
        let mut run = start.mechanism()?.start()?;
        if let Some(at) = at.filter(|at| *at > run.time()) {
            run.step_to(at)?;
        }
        Ok(run)
    };
    let mut run = match posed() {
        Ok(run) => run,
        Err(failure) => return refused(failure, streams),
    };
    let mut sketch = run.then(Draw);
    if let Some(gravity) = gravity(&start) {
        sketch = sketch.with_gravity(gravity);
    }
    if let Some(name) = &png {
        write_whole(name, &sketch.to_png(), streams.output)?;
    }
    if let Some(name) = svg.as_deref().or(png.is_none().then_some("-")) {
        write_whole(name, sketch.to_svg().as_bytes(), streams.output)?;
    }
    Ok(Outcome::Good)
}

/// A time after the start, s.
fn time(text: &str) -> Result<f64, Failure> {
    let time = text.parse().ok().filter(|time| *time >= 0.0 && f64::is_finite(*time));
    Ok(time.ok_or_else(|| format!("--at wants a time in seconds from 0, not `{text}`"))?)
}

/// The acceleration of gravity with parameters as declared, m/s^2.
fn gravity(start: &Start) -> Option<[f64; 2]> {
    let declarations = Declarations::new(&start.file.name, &start.file.text);
    let (_, checked) = declarations.named(None).ok()??;
    checked.expansion.oracle.map(|oracle| oracle.assembled().gravity)
}

/// A drawing of the present pose.
struct Draw;

impl OnRun for Draw {
    type Output = Sketch;

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Sketch {
        let state = sim.state();
        let (mut poses, time) = (Vec::new(), state.time());
        M::poses(state, &mut |pose| poses.push([pose.x, pose.y, pose.angle]));
        let mut mechanism = mechanism(state.mechanism());
        for (k, port) in mechanism.ground.iter_mut().enumerate() {
            [port.x, port.y, port.angle] = Place::components(state.mechanism().ground(time, k));
        }
        Sketch::new(mechanism, poses)
    }
}

//! Mechanisms that rest for a while and are then moved smoothly: what a machine does all day.

use plm_run::AnySim;
use plm_runtime::{Dop853, Fault, Moment as _};

use super::run::{Trace, trace};
use crate::text::{By as _, Given as _, Named as _, Scene, State, absolute, scene};

/// A four-bar that is pushed.
const PUSHED: &str = include_str!("../declared/pushed.plm");

/// A four-bar on a turntable that rests so long, s.
pub fn turntable(wait: f64) -> Scene {
    scene(include_str!("../declared/turntable.plm")).with("wait", wait)
}

/// The pushed four-bar over 8 s from the moment on at which the torque begins: the angles of its bars, rad.
pub fn pushed(wait: f64, push: f64) -> Result<Trace<3>, Fault> {
    let mut sim = scene(PUSHED).with("wait", wait).with("push", push).begin()?;
    sim.step(wait)?;
    Ok(trace(&mut sim, wait + 8.0, 0.02, angles))
}

/// The same without a wait and in absolute coordinates, at a tolerance of 1e-12.
pub fn pushed_at_once(push: f64) -> Result<Trace<3>, Fault> {
    let four_bar = scene(&absolute(PUSHED)).with("wait", 0.0).with("push", push);
    let mut sim = four_bar.by(Dop853::new(1e-12))?;
    Ok(trace(&mut sim, 8.0, 0.02, angles))
}

fn angles(state: &State) -> [f64; 3] {
    ["one", "two", "coupler"].map(|bar| state.body_of(bar).angle)
}

/// Largest difference of an angle of two such runs at their moments, rad, over the time since the torque began, s.
pub fn apart(run: &Trace<3>, other: &Trace<3>) -> Vec<(f64, f64)> {
    let rows = run.rows.iter().zip(&other.rows);
    rows.map(|((_, a), (time, b))| (*time, (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max))).collect()
}

/// Angular momentum about the pivot of the table, kg m^2/s.
pub fn momentum(state: &State) -> f64 {
    let light = ["crank", "rocker", "coupler"].map(|name| (0.1, 1e-3, state.body_of(name)));
    let bodies = light.into_iter().chain([(1.0, 1.0, state.body_of("table"))]);
    bodies.map(|(m, i, body)| i * body.omega + m * (body.x * body.vy - body.y * body.vx)).sum()
}

/// Angle of the table, rad, and what the angular momentum is off by from the integral of the torque, kg m^2/s.
pub fn turned(sim: &mut AnySim<Scene>) -> Trace<2> {
    let wait = sim.mechanism().parameter_of("wait");
    trace(sim, wait + 10.0, 0.01, |s| {
        let pushed = (s.time() - wait).max(0.0);
        let torque = if pushed < 2.0 { 0.125 * pushed * pushed } else { 0.5 * (pushed - 1.0) };
        [s.body_of("table").angle, momentum(s) - torque]
    })
}

//! Linkages that come next to a flat pose: a difference of two lengths tells which way they go on.

use std::f64::consts::{FRAC_PI_2, PI};

use plm_run::AnySim;
use plm_runtime::{Fault, Moment as _};

use super::run::{Trace, trace};
use super::theory;
use crate::text::{By as _, Given as _, Named as _, Scene, State, absolute, scene};

const NEARLY_PARALLEL: &str = include_str!("../declared/nearly_parallel.plm");

/// A four-bar of nearly parallel cranks, as the compiler takes it and in absolute coordinates.
pub fn nearly_parallel() -> [Scene; 2] {
    [scene(NEARLY_PARALLEL), scene(&absolute(NEARLY_PARALLEL))]
}

/// A four-bar with a right crank that is longer by so much, m.
pub fn differing(by: f64) -> Scene {
    scene(NEARLY_PARALLEL).with("right_length", 0.5 + by)
}

/// Both cranks of a four-bar start at an angle, rad, the left one at a speed, rad/s.
pub fn from(linkage: &Scene, angle: f64, speed: f64) -> Scene {
    let [length, span] = ["left_length", "span"].map(|name| linkage.parameter_of(name));
    let cranks = linkage.with_start("left.angle", angle).with_start("right.angle", angle);
    let top = cranks.with_start("top.x", 0.5 * span + length * angle.cos());
    top.with_start("top.y", length * angle.sin()).with_start("left.omega", speed)
}

/// Angle, rad, and speed, rad/s, of each crank of a four-bar.
pub fn cranks(state: &State) -> [[f64; 2]; 2] {
    ["left", "right"].map(|bar| turn(state, bar))
}

fn turn(state: &State, bar: &str) -> [f64; 2] {
    let bar = state.body_of(bar);
    [bar.angle, bar.omega]
}

/// Energy, J.
pub fn energy(state: &State) -> f64 {
    state.kinetic_energy() + state.gravity_energy()
}

/// Energy (relative change) and angle of the right bar, rad.
pub fn swinging(sim: &mut AnySim<Scene>, until: f64) -> Trace<2> {
    let begun = energy(sim);
    trace(sim, until, 0.01, |state| [energy(state) / begun - 1.0, cranks(state)[1][0]])
}

/// A run over poses that are nearly flat.
pub struct Passed {
    pub end: Result<(), Fault>,
    /// Largest relative change of the energy.
    pub energy: f64,
    /// The time that the closed form gives for the way to the last pose, less that of the run, s.
    pub late: f64,
    /// Flat poses that were counted.
    pub change_points: u64,
}

/// Turns until the time `until`, s; `time` is that of the way on which a bar starts as given and ends at an angle.
///
/// The driver is the bar that goes all the way round.
fn pass(
    linkage: &Scene,
    until: f64,
    driver: &str,
    time: impl Fn([f64; 2], f64) -> f64,
) -> Result<Passed, Fault> {
    let mut sim = linkage.begin()?;
    let (begun, start) = (energy(&sim), turn(&sim, driver));
    let mut largest = 0.0_f64;
    let end = sim.run(until, 0.01, |state| largest = largest.max((energy(state) / begun - 1.0).abs()));
    let late = time(start, turn(&sim, driver)[0]) - sim.time();
    Ok(Passed { end, energy: largest, late, change_points: sim.stats().change_points })
}

/// The right crank of a nearly parallel four-bar is longer by `by`, m. The shorter crank turns, the other one swings.
pub fn parallel(by: f64, until: f64) -> Result<Passed, Fault> {
    let linkage = differing(by);
    let [left, right] = ["left_length", "right_length"].map(|name| linkage.parameter_of(name));
    let (driver, short, long) = if by < 0.0 { ("right", right, left) } else { ("left", left, right) };
    // Seen from the other side of the paper the right crank is the left one.
    let seen = |angle: f64| if by < 0.0 { PI - angle } else { angle };
    let inertia = |angle: f64| theory::four_bar_inertia([short, 2.0, long, 2.0], seen(angle));
    let time = |[from, speed]: [f64; 2], to: f64| match by {
        // Cranks that are alike turn at constant speed.
        0.0 => (to - from) / speed,
        _ => theory::time_between([from, to], speed, 0.0, inertia),
    };
    pass(&linkage, until, driver, time)
}

/// The rod of a slider-crank is longer than its crank by `by`, m. The shorter bar turns, the other one swings.
pub fn folding(by: f64, until: f64) -> Result<Passed, Fault> {
    let [crank, rod] = [1.0, 1.0 + by];
    let linkage = scene(include_str!("../declared/nearly_folded.plm")).with("rod_length", rod);
    let (driver, short, long) = if by < 0.0 { ("rod", rod, crank) } else { ("crank", crank, rod) };
    let inertia = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        // Of the other bar; bars that are alike mirror each other all the way round.
        let far = -short * sin / long;
        let near = if by == 0.0 { cos } else { ((long - short * sin) * (long + short * sin)).sqrt() / long };
        let rate = -short * cos / (long * near);
        // Of each bar the velocity of its end and its rate, by the rate of the driver.
        let bars = [(short, sin, cos, 1.0), (long, far, near, rate)];
        let of_crank = usize::from(by < 0.0);
        let [(a, pin), (b, wrist)] = [bars[of_crank], bars[1 - of_crank]]
            .map(|(length, sin, cos, rate)| (rate, [-length * sin * rate, length * cos * rate]));
        let centre = [pin[0] + 0.5 * wrist[0], pin[1] + 0.5 * wrist[1]];
        a * a / 3.0 + b * b / 12.0 + centre[0].powi(2) + centre[1].powi(2) + (pin[0] + wrist[0]).powi(2)
    };
    let time = |[from, speed]: [f64; 2], to: f64| {
        let sign = speed.signum();
        theory::time_between([sign * from, sign * to], sign * speed, FRAC_PI_2, |angle| inertia(sign * angle))
    };
    pass(&linkage, until, driver, time)
}

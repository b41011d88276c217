//! Linkages with dead points: poses where one bar cannot drive the others, or where the motion ends.

use plm_run::AnySim;
use plm_runtime::{BodyState, Fault, Moment as _};

use super::run::{Trace, trace};
use super::theory;
use crate::text::{By as _, Given as _, Large, LargeState, Named as _, Scene, large, scene};

pub fn triple_rocker() -> Scene {
    scene(include_str!("../declared/triple_rocker.plm"))
}

pub fn crank_rocker() -> Scene {
    scene(include_str!("../declared/crank_rocker.plm"))
}

/// Bars of the Quadrorhomb, in the order of the declaration.
const BARS: [&str; 13] = ["crank", "oa", "ob", "ac", "bc", "a1", "b1", "a2", "b2", "a3", "b3", "a4", "b4"];

/// The Quadrorhomb at rest with its crank at an angle, rad.
pub fn quadrorhomb(angle: f64) -> Large {
    let declared = large(include_str!("../declared/quadrorhomb.plm"));
    BARS.iter().zip(theory::quadrorhomb(angle)).fold(declared, |started, (bar, pose)| {
        let started =
            started.with_start(&format!("{bar}.x"), pose[0]).with_start(&format!("{bar}.y"), pose[1]);
        started.with_start(&format!("{bar}.angle"), pose[2])
    })
}

/// The Quadrorhomb without gravity, with a spring of 100 N m/rad at its crank, at rest from 40 deg.
pub fn quadrorhomb_on_a_spring() -> Large {
    quadrorhomb(40_f64.to_radians()).with("gravity_y", 0.0).with("crank_spring", 100.0)
}

/// All bars of the Quadrorhomb.
pub fn bars(state: &LargeState) -> [BodyState<f64>; 13] {
    BARS.map(|bar| state.body_of(bar))
}

/// Kinetic energy of the Quadrorhomb, gravity, and the spring of its crank, J.
pub fn energy(state: &LargeState) -> f64 {
    let (turn, stiffness) = (state.body_of("crank").angle, state.mechanism().parameter_of("crank_spring"));
    state.kinetic_energy() + state.gravity_energy() + 0.5 * stiffness * turn * turn
}

/// Energy (relative change), angles of crank and rocker (rad), and the sine between coupler and rocker, which changes sign
/// at a dead point of the crank.
pub fn rocking(sim: &mut AnySim<Scene>, until: f64) -> Trace<4> {
    let energy = sim.kinetic_energy();
    trace(sim, until, 0.005, |s| {
        let (crank, coupler, rocker) =
            (s.body_of("crank").angle, s.body_of("coupler").angle, s.body_of("rocker").angle);
        [s.kinetic_energy() / energy - 1.0, crank, rocker, (rocker - coupler).sin()]
    })
}

/// Largest difference of the coupler's and the rocker's angle from the closed form over so many turns of the crank, rad.
pub fn cranking(sim: &mut AnySim<Scene>, turns: u32) -> Trace<1> {
    let turn = std::f64::consts::TAU;
    trace(sim, f64::from(turns) * turn, turn / 360.0, |s| {
        let [coupler, rocker] = theory::four_bar([0.5, 1.2, 0.8, 1.0], s.time());
        [(s.body_of("coupler").angle - coupler).abs().max((s.body_of("rocker").angle - rocker).abs())]
    })
}

/// The same by assembly alone: every position is found from the one before, a degree of the crank away.
pub fn assembling() -> Result<Vec<(f64, f64)>, Fault> {
    let mut mechanism = crank_rocker();
    let mut differences = Vec::new();
    for degree in 0..=360 {
        let angle = f64::from(degree).to_radians();
        mechanism = mechanism.with("from", angle);
        let state = mechanism.begin()?;
        let [coupler, rocker] = theory::four_bar([0.5, 1.2, 0.8, 1.0], angle);
        let (found_coupler, found_rocker) = (state.body_of("coupler"), state.body_of("rocker"));
        let off = (found_coupler.angle - coupler).abs().max((found_rocker.angle - rocker).abs());
        differences.push((f64::from(degree), off));
        for name in ["crank", "coupler", "rocker"] {
            let body = state.body_of(name);
            let places = [("x", body.x), ("y", body.y), ("angle", body.angle)];
            for (coordinate, value) in places {
                mechanism = mechanism.with_start(&format!("{name}.{coordinate}"), value);
            }
        }
    }
    Ok(differences)
}

/// Energy (J), and the angle of the crank (rad).
pub fn falling(sim: &mut AnySim<Large>) -> Trace<2> {
    trace(sim, 1.0, 1e-3, |s| [energy(s), s.body_of("crank").angle])
}

/// Energy (relative change), and the largest difference of a place (m) from that which the angle of the crank gives.
pub fn swinging(sim: &mut AnySim<Large>, until: f64, every: f64) -> Trace<2> {
    let begun = energy(sim);
    trace(sim, until, every, |s| {
        let poses = bars(s).into_iter().zip(theory::quadrorhomb(s.body_of("crank").angle));
        let off =
            poses.map(|(body, [u, v, _])| (body.x - u).abs().max((body.y - v).abs())).fold(0.0, f64::max);
        [energy(s) / begun - 1.0, off]
    })
}

//! Pendulums.

use std::f64::consts::{FRAC_PI_2, PI};

use plm_run::AnySim;
use plm_runtime::{Dopri5, Fault, Moment as _};

use super::run::{Trace, trace};
use super::theory::{self, G};
use crate::text::{By as _, Given as _, Named as _, Scene, scene};

pub fn pendulum() -> Scene {
    scene(include_str!("../declared/pendulum.plm"))
}

fn kapitza() -> Scene {
    scene(include_str!("../declared/kapitza.plm"))
}

/// Five points at rest, at these horizontal places, m, from above.
fn displaced(inertia: f64, places: &[f64; 5]) -> Scene {
    let (mut chain, mut above) =
        (scene(include_str!("../declared/points.plm")).with("inertia", inertia), 0.0);
    for (k, place) in places.iter().enumerate() {
        chain = chain.with_start(&format!("bob[{k}].angle"), (place - above).asin());
        above = *place;
    }
    chain
}

fn light_bars(mass: f64) -> Scene {
    scene(include_str!("../declared/light_bars.plm")).with("mass", mass)
}

/// Angle of A01 less that of the elliptic function (rad), and change of its energy (J).
pub fn phase(sim: &mut AnySim<Scene>, until: f64, every: f64) -> Trace<2> {
    trace(sim, until, every, |s| {
        let known = theory::pendulum_angle(G.sqrt(), -FRAC_PI_2, s.time());
        [s.body_of("bob").angle - known, s.kinetic_energy() + s.gravity_energy()]
    })
}

/// Trace of the matrix that carries (angle, rate) from one period of the pivot to the next near the upright position; the
/// position is stable where it is between -2 and 2 (G. Floquet, Ann. Sci. École Norm. Sup. 12, 1883).
pub fn floquet(a: f64, w: f64) -> Result<f64, Fault> {
    let small = 1e-6;
    let after = |angle: f64, omega: f64| {
        let kapitza = kapitza().with("a", a).with("w", w);
        let kapitza = kapitza.with_start("bob.angle", angle).with_start("bob.omega", omega);
        let mut sim = kapitza.by(Dopri5::new(1e-12))?;
        sim.step(2.0 * PI / w)?;
        let bob = sim.body_of("bob");
        Ok((bob.angle, bob.omega))
    };
    // The rates are measured in units of w, so that both columns are of one size.
    Ok((after(small, 0.0)?.0 + after(0.0, small * w)?.1 / w) / small)
}

/// (a w)^2/(2 g l) at which the upright position becomes stable, for a pivot that moves by `a` with l = 1 m.
pub fn kapitza_limit(a: f64) -> Result<f64, Fault> {
    let stable = |ratio: f64| Ok(floquet(a, (2.0 * G * ratio).sqrt() / a)? < 2.0);
    let (mut low, mut high) = (0.9, 1.1);
    for _ in 0..20 {
        let middle = 0.5 * (low + high);
        if stable(middle)? { high = middle } else { low = middle }
    }
    Ok(0.5 * (low + high))
}

/// Relative error of the frequency of mode `mode` of five hanging points with an inertia, from the phase after 5/4 periods.
///
/// The mode of w^2 l/g = z has the displacements L_4(z), L_3(z), … L_0(z) from above; the one that moves most is
/// measured.
pub fn frequency_error(mode: usize, inertia: f64) -> Result<f64, Fault> {
    let z = theory::laguerre_zeros(5)[mode];
    let shape = [4, 3, 2, 1, 0].map(|order| theory::laguerre(order, z));
    let most = (0..5).max_by(|i, j| shape[*i].abs().total_cmp(&shape[*j].abs())).unwrap_or(4);
    let scale = 1e-5 / shape[most];
    let mut sim = displaced(inertia, &shape.map(|u| scale * u)).by(Dopri5::new(1e-12))?;
    let phase = 2.5 * PI;
    sim.step(phase / (z * G).sqrt())?;
    Ok(-(sim.body_of(&format!("bob[{most}]")).x / 1e-5).asin() / phase)
}

/// Speed of the load on light bars in the lowest position over sqrt(2 g l), less 1.
pub fn speed_below(mass: f64) -> Result<f64, Fault> {
    let mut sim = light_bars(mass).begin()?;
    sim.step(0.25 * theory::pendulum_period(G.sqrt(), FRAC_PI_2))?;
    let load = sim.body_of("load");
    Ok(load.vx.hypot(load.vy) / (2.0 * G).sqrt() - 1.0)
}

//! Stiffness: of springs, and of Baumgarte's stabilisation.

use plm_run::AnyMethod;
use plm_runtime::method::{Formula as _, Rk4Formula};
use plm_runtime::{Fault, Moment as _, Rate as _, Rk4};

use crate::text::{By as _, Given as _, Named as _, Scene, State, scene};

fn end_stop() -> Scene {
    scene(include_str!("../declared/end_stop.plm"))
}

pub fn oscillator() -> Scene {
    scene(include_str!("../declared/oscillator.plm"))
}

pub fn spring_pendulum(stiffness: f64) -> Scene {
    scene(include_str!("../declared/spring_pendulum.plm")).with("stiffness", stiffness)
}

fn stabilised_pendulum(tau: f64) -> Scene {
    scene(include_str!("../declared/stabilised.plm")).with("tau", tau)
}

/// Speed after the bounce over the speed before it; the known value is -1.
pub fn bounce(method: impl Into<AnyMethod<Scene>>) -> Result<f64, Fault> {
    let mut sim = end_stop().by(method)?;
    sim.step(0.2)?;
    Ok(sim.body_of("ram").vx)
}

/// Growth of the amplitude of the oscillator over 1000 steps of Runge-Kutta 4 by themselves; infinite if it ends before. `Sim` would
/// end a run whose steps err by the amplitude.
pub fn growth_of_oscillation(h: f64) -> f64 {
    let run = || {
        let mut state = *oscillator().begin()?.state();
        let energy_of = |state: &State| state.kinetic_energy() + 0.5 * 1e8 * state.body_of("ram").x.powi(2);
        let energy = energy_of(&state);
        let (held, mut x, mut time) = (state.held(), *state.x(), state.time());
        for _ in 0..1000 {
            let rates = |t: f64, x: &_, dx: &mut _| {
                state.mechanism().rate(t, &held, x, dx);
            };
            Rk4Formula::step::<Scene, _>((time, h), &mut x, rates, |_, _| ());
            time += h;
        }
        state.set(time, &held, &x);
        Ok::<f64, Fault>((energy_of(&state) / energy).sqrt())
    };
    run().unwrap_or(f64::INFINITY)
}

/// Residual of the hinge (m) after so many steps of Runge-Kutta 4 with h alpha = `h_alpha`, released at an angle from
/// hanging (rad); infinite if it ends before.
pub fn stabilised(h: f64, h_alpha: f64, angle: f64, steps: u32) -> f64 {
    let run = || {
        let pendulum = stabilised_pendulum(h / h_alpha).with_start("bob.angle", angle);
        let pendulum =
            pendulum.with_start("bob.x", 0.9 * angle.sin()).with_start("bob.y", -0.9 * angle.cos());
        let mut sim = pendulum.by(Rk4::new(h))?;
        sim.step(f64::from(steps) * h)?;
        let [x, y] = sim.body_of("bob").point(0.0, 0.9);
        Ok::<f64, Fault>(x.hypot(y))
    };
    run().unwrap_or(f64::INFINITY)
}

/// The largest value between `low` and `high` for which `bounded` holds, if it holds up to some value, to 1e-4 of it.
pub fn limit(mut low: f64, mut high: f64, bounded: impl Fn(f64) -> bool) -> f64 {
    while high - low > 1e-4 * low {
        let middle = 0.5 * (low + high);
        if bounded(middle) { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

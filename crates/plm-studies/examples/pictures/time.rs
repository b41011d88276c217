//! Error and time of an identification, beside SciPy's `least_squares` (`benches/peers/by_scipy.py`).

use std::error::Error;
use std::fmt::Write;
use std::time::Instant;

use plm::Dop853;
use plm::optimise::{ByDop853, Experiment, Identification, Unknown};

plm::mechanism! {
    /// A pendulum with damping.
    pub Pendulum {
        param length: m = 1 m;
        param damping: N*m*s/rad = 0.2 N*m*s/rad;
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0 m, length); start angle: 60 deg, locked; start omega: 0 rad/s, locked; }
        revolute hinge(ground.o, bob.pivot) { damping: damping; }
        output bob.angle;
    }
}

/// Largest relative error of an unknown, and the shortest time of ten, by 60 readings without noise.
pub fn report() -> Result<String, Box<dyn Error>> {
    let times: Vec<f64> = (0..60).map(|k| 0.05 * f64::from(k)).collect();
    let mut sim = Pendulum::new().start_with(Dop853::new(1e-13))?;
    let mut readings = Vec::new();
    for time in &times {
        sim.step_to(*time)?;
        readings.push(sim.bob().angle);
    }
    let mut text = String::new();
    for tolerance in [1e-8, 1e-11] {
        let (mut best, mut error) = (f64::INFINITY, 0.0);
        for _ in 0..10 {
            let begun = Instant::now();
            let fit = Identification::new(Pendulum { length: 0.7, damping: 0.0, ..Pendulum::new() })
                .find(Unknown::parameter("length").within(0.1, 3.0))
                .find(Unknown::parameter("damping").of_size(0.2))
                .find(Unknown::start("bob.angle").from(0.9))
                .experiment(Experiment::new(times.clone()).measured("bob.angle", "rad", readings.clone()))
                .run_by(ByDop853(tolerance))?;
            best = best.min(begun.elapsed().as_secs_f64());
            let truth = [1.0, 0.2, 60_f64.to_radians()];
            let errors = fit.estimates.iter().zip(truth).map(|(own, truth)| (own.value / truth - 1.0).abs());
            error = errors.fold(0.0, f64::max);
        }
        writeln!(text, "plm at {tolerance:e}: error {error:.1e} after {:.1} ms", 1e3 * best)?;
    }
    Ok(text)
}

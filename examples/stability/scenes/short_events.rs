//! Conditions that last a small part of a run.

use std::f64::consts::FRAC_PI_2;

use plm::{Fault, Method, Stats};

/// Length of the runs, s; the rotor comes down once in it.
pub const RUN: f64 = 10.0;

plm::mechanism! {
    /// A rotor at 1 rad/s. A brush below brakes it while its tip is low, and takes a quarter of its energy.
    pub Brush {
        /// Height of the tip at which the brush begins, m.
        param height: m = -0.9 m;
        /// Torque of the brush, N m.
        param torque: N*m = 0 N*m;
        ground { port o: (0, 0) m; }
        body rotor {
            mass: 1 kg;
            inertia: 0.1 kg*m^2;
            port o: (0, 0) m;
            port tip: (1, 0) m;
            start angle: 0 deg, locked;
            start omega: 1 rad/s, locked;
        }
        revolute pin(ground.o, rotor.o) { drive: if rotor.tip.y < height then -torque else 0 N*m; }
    }
}

plm::mechanism! {
    /// The same rotor, whose tip must stay above a height.
    pub Clearance {
        param height: m = -0.9 m;
        ground { port o: (0, 0) m; }
        body rotor {
            mass: 1 kg;
            inertia: 0.1 kg*m^2;
            port o: (0, 0) m;
            port tip: (1, 0) m;
            start angle: 0 deg, locked;
            start omega: 1 rad/s, locked;
        }
        revolute pin(ground.o, rotor.o);
        require clear: rotor.tip.y > height;
    }
}

/// Half the angle within which a condition lasts a part of the run at 1 rad/s, and the height of the tip there.
fn window(part: f64) -> (f64, f64) {
    let half = 0.5 * part * RUN;
    // -cos(half), without what the difference from 1 loses.
    (half, 2.0 * (0.5 * half).sin().powi(2) - 1.0)
}

/// Angle and speed after the run less the known ones, rad and rad/s, in intervals of `interval`, s; and what was done.
///
/// The torque takes a quarter of 0.05 J over the window, which is passed with the mean of the speeds at its ends.
pub fn braked<I: Method<Brush>>(part: f64, interval: f64, method: I) -> Result<([f64; 2], Stats), Fault> {
    let (half, height) = window(part);
    let mut sim = Brush { height, torque: 0.0125 / (2.0 * half), ..Brush::new() }.start_with(method)?;
    for _ in 0..(RUN / interval).round() as u32 {
        sim.step(interval)?;
    }
    let after = 0.75_f64.sqrt();
    let (before, within) = (3.0 * FRAC_PI_2 - half, 2.0 * half / f64::midpoint(1.0, after));
    let angle = 3.0 * FRAC_PI_2 + half + after * (RUN - before - within);
    Ok(([sim.rotor().angle - angle, sim.rotor().omega - after], sim.stats()))
}

/// When a run ends whose tip must stay above the same height, less the known time, s.
pub fn cleared(part: f64, interval: f64) -> Result<Option<f64>, Fault> {
    let (half, height) = window(part);
    let mut sim = Clearance { height, ..Clearance::new() }.start()?;
    let ended = (0..(RUN / interval).round() as u32).find_map(|_| sim.step(interval).err());
    Ok(ended.map(|fault| fault.time - (3.0 * FRAC_PI_2 - half)))
}

//! Which stiffness and damping does a test stand have, of whose swing there are readings?
use std::error::Error;

use nalgebra::{Matrix2, Vector2};
use plm::Dual;

use super::{Answer, Answers};

plm::mechanism! {
    /// A mass of 5 kg on a spring and a damper, let go at 40 mm.
    pub Stand {
        param stiffness = 1000 N/m;
        param damping = 5 N*s/m;
        ground { port rail: (0, 0) m; }
        body mass { mass: 5 kg; inertia: 0.01 kg*m^2; port shoe: (0, 0) m; start x: 40 mm, locked; start vx: 0 m/s, locked; }
        prismatic rail(ground.rail, mass.shoe) { stiffness: stiffness; damping: damping; }
        output rail.displacement;
    }
}

/// Readings every 50 ms, mm: of 823 N/m and 6.4 N s/m, with errors of 0.3 mm.
pub const READINGS: [f64; 20] = [
    31.9, 12.2, -10.6, -29.2, -34.2, -26.9, -8.4, 11.1, 25.7, 28.9, 21.4, 5.8, -11.1, -22.3, -24.9, -17.2,
    -3.4, 10.5, 19.6, 21.4,
];

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut found = Vector2::new(1000.0, 5.0);
    let mut squares = 0.0;
    // Gauss-Newton: each run gives the readings and their derivatives by both parameters.
    for _ in 0..8 {
        let mut stand = Stand::<Dual<f64, 2>>::of();
        stand.stiffness = Dual::variable(found[0], 0);
        stand.damping = Dual::variable(found[1], 1);
        let mut sim = stand.start()?;
        let (mut normal, mut right) = (Matrix2::zeros(), Vector2::zeros());
        squares = 0.0;
        for reading in READINGS {
            sim.step(Dual::constant(0.05))?;
            let Dual { value, tangents } = sim.rail_displacement();
            let (slope, error) = (Vector2::from(tangents), reading * 1e-3 - value);
            normal += slope * slope.transpose();
            right += slope * error;
            squares += error * error;
        }
        found += normal.try_inverse().ok_or("the readings do not tell")? * right;
    }
    Ok(vec![
        Answer::new("stiffness", found[0], "N/m"),
        Answer::new("damping", found[1], "N*s/m"),
        Answer::new("readings are off by (rms)", (squares / READINGS.len() as f64).sqrt() * 1e3, "mm"),
    ])
}

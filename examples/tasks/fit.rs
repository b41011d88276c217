//! Which stiffness and damping does a test stand have, of whose swing there are readings?
use std::error::Error;

use plm::optimise::{Experiment, Identification, Unknown};

use super::{Answer, Answers};

plm::mechanism! {
    /// A mass of 5 kg on a spring and a damper, let go at 40 mm.
    pub Stand {
        param stiffness = 1000 N/m;
        param damping = 5 N*s/m;
        ground { port rail: (0, 0) m; }
        body mass { mass: 5 kg; inertia: 0.01 kg*m^2; port shoe: (0, 0) m; start x: 40 mm, locked; start vx: 0 m/s, locked; }
        prismatic rail(ground.rail, mass.shoe) { stiffness: stiffness; damping: damping; }
        output rail.displacement in mm;
    }
}

/// Readings every 50 ms, mm: of 823 N/m and 6.4 N s/m, with errors of 0.3 mm.
pub const READINGS: [f64; 20] = [
    31.9, 12.2, -10.6, -29.2, -34.2, -26.9, -8.4, 11.1, 25.7, 28.9, 21.4, 5.8, -11.1, -22.3, -24.9, -17.2,
    -3.4, 10.5, 19.6, 21.4,
];

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let times: Vec<f64> = (1..=READINGS.len()).map(|k| 0.05 * k as f64).collect();
    let fit = Identification::new(Stand::new())
        .find(Unknown::parameter("stiffness"))
        .find(Unknown::parameter("damping"))
        .experiment(Experiment::new(times).measured("rail.displacement", "mm", READINGS))
        .run()?;
    let [stiffness, damping] = &fit.estimates[..] else { return Err("there are two unknowns".into()) };
    Ok(vec![
        Answer::new("stiffness", stiffness.value, "N/m"),
        Answer::new("damping", damping.value, "N*s/m"),
        Answer::new("readings are off by (rms)", fit.residuals[0].rms(), "mm"),
        Answer::new("standard error of the stiffness", stiffness.standard_error, "N/m"),
        Answer::new("standard error of the damping", damping.standard_error, "N*s/m"),
    ])
}

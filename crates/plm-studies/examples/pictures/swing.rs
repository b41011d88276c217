//! A rod on a bearing with damping and dry friction, of whose swing there are readings.

use std::error::Error;

use plm::optimise::{ByDop853, Experiment, Fit, Identification, Unknown};

plm::mechanism! {
    /// A rod of 0.8 kg that swings on a bearing.
    pub Swing {
        param inertia: kg*m^2 = 0.05 kg*m^2;
        param damping: N*m*s/rad = 0.01 N*m*s/rad;
        param friction: N*m = 0.02 N*m;
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body rod {
            mass: 0.8 kg; inertia: inertia; port pivot: (0, 0.3) m;
            start angle: 50 deg, locked; start omega: 0 rad/s, locked;
        }
        revolute bearing(ground.o, rod.pivot) { damping: damping; }
        friction rub: rate(rod.angle) within friction;
        output rod.angle in deg;
    }
}

/// Readings every 0.2 s, deg: of 0.032 kg m^2, 0.014 N m s/rad and 0.06 N m, with errors of 0.3 deg.
pub const READINGS: [f64; 30] = [
    50.1, 31.7, -9.2, -40.7, -39.6, -8.9, 26.5, 39.8, 20.2, -12.5, -33.6, -26.8, -0.2, 24.6, 28.1, 9.3,
    -15.0, -25.5, -15.2, 6.2, 20.7, 17.4, 1.4, -13.9, -16.8, -6.4, 7.8, 14.0, 8.3, -2.7,
];

pub fn identified() -> Result<Fit<Swing>, Box<dyn Error>> {
    let times: Vec<f64> = (0..READINGS.len()).map(|k| 0.2 * k as f64).collect();
    let fit = Identification::new(Swing::new())
        .find(Unknown::parameter("inertia").within(0.001, 1.0))
        .find(Unknown::parameter("damping").within(0.0, 1.0))
        .find(Unknown::parameter("friction").within(0.0, 1.0))
        .find(Unknown::start("rod.angle"))
        .experiment(Experiment::new(times).measured("rod.angle", "deg", READINGS))
        .run()?;
    Ok(fit)
}

pub fn picture() -> Result<String, Box<dyn Error>> {
    Ok(identified()?.chart(ByDop853::default())?.to_svg())
}

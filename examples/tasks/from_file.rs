//! Which torque, and how much energy, does a motion need that stands in a file?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// An arm that moves as it is told.
    pub Arm {
        gravity: 9.81 m/s^2;
        /// From this time on: angle, speed and acceleration.
        param since: s = 0;
        param place: rad = 0;
        param speed: rad/s = 0;
        param gain: rad/s^2 = 0;
        ground { port shoulder: (0, 0) m; }
        body arm { mass: 6 kg; inertia: 0.3 kg*m^2; port shoulder: (-0.4, 0) m; start angle: place; }
        revolute shoulder(ground.shoulder, arm.shoulder);
        motion planned(shoulder.shaft) { value: place + speed*(t - since) + gain*(t - since)^2/2; }
        output planned.torque, planned.power;
    }
}

/// Rows of numbers after a line of titles.
fn read(file: &str) -> Result<Vec<Vec<f64>>, Box<dyn Error>> {
    let text = std::fs::read_to_string(file).map_err(|why| format!("{file}: {why}"))?;
    let row = |line: &str| line.split(',').map(|number| number.trim().parse()).collect();
    Ok(text.lines().skip(1).map(row).collect::<Result<_, std::num::ParseFloatError>>()?)
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    // time (s), angle (deg), speed (deg/s), acceleration (deg/s^2)
    let rows = read(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/tasks/from_file.csv"))?;
    let mut sim = Arm::new().start()?;
    let (mut largest, mut at, mut energy, mut last) = (0.0_f64, 0.0, 0.0, 0.0);
    for row in &rows {
        let &[since, place, speed, gain] = row.as_slice() else { return Err("four numbers a line".into()) };
        let [place, speed, gain] = [place, speed, gain].map(f64::to_radians);
        sim.step_to(since)?;
        sim.mechanism = Arm { since, place, speed, gain, ..sim.mechanism };
        sim.project()?;
        let (torque, power) = (sim.planned_torque(), sim.planned_power());
        (largest, at) = if torque.abs() > largest { (torque.abs(), since) } else { (largest, at) };
        // By the trapezoidal rule.
        energy += 0.5 * (power + last) * (rows[1][0] - rows[0][0]);
        last = power;
    }
    Ok(vec![
        Answer::new("rows in the file", rows.len() as f64, ""),
        Answer::new("greatest torque", largest, "N*m"),
        Answer::new("at", at, "s"),
        Answer::new("energy of the motor", energy, "J"),
    ])
}

//! How does an axis with a digital controller answer to a step, how far does a load move it, and does an error stay?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A motor turns an axis to 30 deg. A load of 2 N m comes at 0.6 s.
    pub Axis {
        rotor axis() { inertia: 0.02 kg*m^2; drive: 1 N*m*control.value - (if t > 0.6 s then 2 N*m else 0 N*m); }
        sampled_controller control() {
            error: (30 deg - axis.angle)/(1 rad);
            proportional: 40; integral: 200 Hz; derivative: 1.6 s;
            period: 4 ms; low: -10; high: 10;
        }
        output axis.angle in deg, control.value;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Axis::new().start()?;
    let (mut overshoot, mut settled, mut moved) = (0.0_f64, 0.0, 0.0_f64);
    for _ in 0..500 {
        sim.step(4e-3)?;
        let [angle, _] = sim.outputs();
        if sim.time() < 0.6 {
            overshoot = overshoot.max(angle - 30.0);
            settled = if (angle - 30.0).abs() > 0.6 { sim.time() } else { settled };
        } else {
            moved = moved.max(30.0 - angle);
        }
    }
    let [angle, torque] = sim.outputs();
    Ok(vec![
        Answer::new("overshoot", overshoot, "deg"),
        Answer::new("within 2 % from", settled, "s"),
        Answer::new("the load moves it by", moved, "deg"),
        Answer::new("error after 2 s", 30.0 - angle, "deg"),
        Answer::new("torque after 2 s", torque, "N*m"),
    ])
}

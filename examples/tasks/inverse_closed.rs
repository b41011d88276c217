//! Which torque turns the crank of a four-bar linkage steadily, and how does the linkage shake its ground?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// The crank turns at a constant speed; the torque is the reaction of that constraint.
    pub FourBar {
        param speed = 240 rev/min;
        gravity: 9.81 m/s^2;
        ground { port a: (0, 0) mm; port d: (300, 0) mm; }
        body crank { mass: 1 kg; inertia: rod(1 kg, 0.1 m); port a: (-50, 0) mm; port b: (50, 0) mm; }
        body coupler {
            mass: 3 kg; inertia: 0.04 kg*m^2; port b: (-140, 0) mm; port c: (140, 0) mm;
            start angle: 45 deg;
        }
        body rocker {
            mass: 2 kg; inertia: rod(2 kg, 0.25 m); port d: (-125, 0) mm; port c: (125, 0) mm;
            start angle: 90 deg;
        }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(ground.d, rocker.d);
        constraint motor: crank.angle = speed*t;
        output torque = -reaction(motor), shaking = a.force + d.force;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let linkage = FourBar::new();
    let mut sim = linkage.start()?;
    let (mut torque, mut torque_at, mut shaking) = (0.0_f64, 0, 0.0_f64);
    for degree in 0..360 {
        sim.step_to(f64::from(degree).to_radians() / linkage.speed)?;
        if sim.torque().abs() > torque.abs() {
            (torque, torque_at) = (sim.torque(), degree);
        }
        let [x, y] = sim.shaking();
        shaking = shaking.max(x.hypot(y));
    }
    Ok(vec![
        Answer::new("largest torque", torque, "N*m"),
        Answer::new("at a crank angle of", f64::from(torque_at), "deg"),
        Answer::new("largest force on the ground", shaking, "N"),
    ])
}

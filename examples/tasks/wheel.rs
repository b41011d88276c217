//! At which torque does a driven wheel begin to slip, and how fast is it then?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A quarter of a car on its wheel, whose motor torque rises with the time.
    pub Drive {
        gravity: 9.81 m/s^2;
        ground { port road: (0, 0) m; }
        body car { mass: 300 kg; inertia: 50 kg*m^2; port hub: (0, 0) m; start y: 0.3 m; }
        body rim { mass: 20 kg; inertia: disc(20 kg, 0.3 m); port hub: (0, 0) m; start y: 0.3 m; }
        revolute bearing(car.hub, rim.hub) { drive: -400 N*m/s*t; }
        wheel tread(ground.road, rim.hub) { radius: 0.3 m; friction: 0.7; static_friction: 0.9; }
        constraint upright: car.angle = 0;
        discrete slips: s = 0;
        discrete speed: m/s = 0;
        when tread.rolls < 0.5 { slips = t; speed = car.vx; }
        output slips, speed, car.vx, tread.slip, tread.traction;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Drive::new().start()?;
    sim.step(3.0)?;
    Ok(vec![
        Answer::new("slips from a torque of", 400.0 * sim.slips(), "N*m"),
        Answer::new("at a speed of", sim.speed(), "m/s"),
        Answer::new("speed after 3 s", sim.car_vx(), "m/s"),
        Answer::new("slip after 3 s", -sim.tread_slip(), "m/s"),
        Answer::new("traction after 3 s", sim.tread_traction(), "N"),
    ])
}

//! How long does a wheel run on its pin, and how far beside its guide may a drawer be pulled before it jams?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A wheel on a pin that rubs by its weight, and a drawer whose guide rubs at both of its ends.
    pub Rubbing {
        param offset: m = 0.1 m;
        gravity: 9.81 m/s^2;
        ground { port axle: (0, 1) m; port rail: (0, 0) m; }
        body wheel {
            mass: 8 kg; inertia: disc(8 kg, 0.2 m); port hub: (0, 0) m;
            start y: 1 m; start omega: 100 rev/min;
        }
        revolute pin(ground.axle, wheel.hub) { friction: 0.12; pin_diameter: 20 mm; }
        body drawer { mass: 2 kg; inertia: 0.1 kg*m^2; port runner: (0, 0) m; port handle: (0.2 m, offset); }
        prismatic rail(ground.rail, drawer.runner) { friction: 0.3; guide_length: 0.15 m; }
        force pull(drawer.handle) { x: 60 N; }
        discrete stops: s = 0;
        when wheel.omega <= 0 { stops = t; }
        output stops, turns = wheel.angle in rev, pin.friction_torque, rail.acceleration;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Rubbing::new().start()?;
    let torque = sim.pin_friction_torque();
    let near = sim.rail_acceleration();
    let far = Rubbing { offset: 0.26, ..Rubbing::new() }.start()?.rail_acceleration();
    sim.step(30.0)?;
    let [stops, turns, ..] = sim.outputs();
    Ok(vec![
        Answer::new("friction of the pin", -torque, "N*m"),
        Answer::new("the wheel stops after", stops, "s"),
        Answer::new("turns until then", turns, "rev"),
        Answer::new("acceleration of the drawer, pulled 100 mm beside", near, "m/s^2"),
        Answer::new("acceleration, pulled 260 mm beside", far, "m/s^2"),
    ])
}

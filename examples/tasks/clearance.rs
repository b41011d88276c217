//! When and how hard does a worn pin knock?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A yoke moves as a sine, and takes a ram along by a pin with 0.1 mm of clearance.
    pub Knock {
        param speed = 300 rev/min;
        ground { port rail: (0, 0) mm; }
        body yoke { mass: 2 kg; inertia: 0.01 kg*m^2; port bush: (0, 0) mm; start x: -50 mm; }
        body ram { mass: 20 kg; inertia: 0.1 kg*m^2; port pin: (0, 0) mm; start x: -50.1 mm; }
        constraint drive: yoke.x = -(50 mm)*cos(speed*t);
        prismatic guide(ground.rail, yoke.bush);
        prismatic slide(ground.rail, ram.pin);
        clearance pin(yoke.bush, ram.pin) { clearance: 0.1 mm; }
        output pin.force;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Knock::new().start()?;
    let turn = std::f64::consts::TAU / sim.mechanism.speed; // s
    // A knock in each half turn.
    sim.step_to(0.5 * turn)?;
    let knock = sim.impulse("pin.bush").ok_or("there is no knock")?;
    let pressed = sim.pin_force();
    sim.step_to(2.0 * turn)?;
    Ok(vec![
        Answer::new("the crank stands at", 360.0 * knock.time / turn, "deg"),
        Answer::new("the pin strikes with", knock.size / 20.0, "m/s"),
        Answer::new("impulse of a knock", knock.size, "N*s"),
        Answer::new("knocks in two turns", sim.contact_stats().impacts as f64, ""),
        Answer::new("power of the knocks", sim.impact_energy().lost / sim.time(), "W"),
        Answer::new("greatest force between knocks", pressed, "N"),
    ])
}

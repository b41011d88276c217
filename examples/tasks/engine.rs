//! How evenly does a single-cylinder four-stroke engine with a flywheel turn under a constant load?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// The piston moves along x. A cycle has expansion, exhaust, intake and compression, and begins when it burns.
    pub Engine {
        param load: N*m = 0;
        ground { port main: (0, 0) mm; port cylinder: (0, 0) mm; }
        body crank {
            mass: 6 kg; inertia: 0.15 kg*m^2;
            port main: (0, 0) mm; port pin: (40, 0) mm;
            start omega: 3000 rev/min, locked;
        }
        body rod {
            mass: 0.5 kg; inertia: 1.5e-3 kg*m^2; port big: (-40, 0) mm; port small: (100, 0) mm;
            start x: 80 mm;
        }
        body piston { mass: 0.4 kg; inertia: 1e-3 kg*m^2; port pin: (0, 0) mm; start x: 180 mm; }
        revolute main(ground.main, crank.main) { drive: -load; }
        revolute big(crank.pin, rod.big);
        revolute small(rod.small, piston.pin);
        prismatic cylinder(ground.cylinder, piston.pin) { drive: -pressure*area; }

        let area = pi/4*(80 mm)^2;
        let least = 50 cm^3;
        let volume = least + area*(180 mm - cylinder.displacement);
        let adiabatic = exp(-1.3*ln(volume/least));
        let stroke = mod(main.angle, 2 rev);
        // Above that of the crankcase, 1 bar.
        let pressure = if stroke < 180 deg then 60 bar*adiabatic - 1 bar
            else if stroke < 540 deg then 0 bar
            else 16 bar*adiabatic - 1 bar;
        state work: J = 0;
        rate work = -pressure*area*cylinder.speed;
        discrete cycle: J = 0;
        when main.angle > 2 rev { cycle = work; }
        output crank.omega in rev/min, cycle;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut free = Engine::new().start()?;
    free.step(0.05)?;
    let mean = free.cycle() / (4.0 * std::f64::consts::PI);
    let mut sim = Engine { load: mean, ..Engine::new() }.start()?;
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    sim.run(0.04, 1e-5, |state| {
        let [speed, ..] = state.outputs();
        (least, most) = (least.min(speed), most.max(speed));
    })?;
    Ok(vec![
        Answer::new("work of a cycle", free.cycle(), "J"),
        Answer::new("load that it carries", mean, "N*m"),
        Answer::new("lowest speed", least, "rev/min"),
        Answer::new("highest speed", most, "rev/min"),
    ])
}

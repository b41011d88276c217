//! By how much does the torque at a press's crank change with radius, length of the rod, mass and speed?
use std::error::Error;

use plm::Dual;

use super::{Answer, Answers};

plm::mechanism! {
    /// A slider-crank at 37 deg, whose crank turns at a constant speed.
    pub Press {
        gravity: 9.81 m/s^2;
        param radius = 100 mm;
        param length = 400 mm;
        param load = 3 kg;
        param speed = 300 rev/min;
        ground { port o: (0, 0) m; }
        body crank { mass: 2 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; port pin: (radius, 0 m); }
        body rod {
            mass: 1.2 kg; inertia: 0.01 kg*m^2; port pin: (-length/2, 0 m); port end: (length/2, 0 m); start x: radius + length/2;
        }
        body slider { mass: load; inertia: 0.01 kg*m^2; port end: (0, 0) m; start x: radius + length; }
        revolute main(ground.o, crank.o);
        revolute pin(crank.pin, rod.pin);
        revolute end(rod.end, slider.end);
        prismatic guide(ground.o, slider.end);
        constraint motor: crank.angle = 37 deg + speed*t;
        output torque = -reaction(motor);
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    // Numbers with four derivatives: the first by the radius, the second by the length, and so on.
    let mut press = Press::<Dual<f64, 4>>::of();
    press.radius = Dual::variable(0.1, 0);
    press.length = Dual::variable(0.4, 1);
    press.load = Dual::variable(3.0, 2);
    press.speed = Dual::variable(300.0 * std::f64::consts::TAU / 60.0, 3);
    let Dual { value, tangents: [radius, length, load, speed] } = press.start()?.torque();
    Ok(vec![
        Answer::new("torque", value, "N*m"),
        Answer::new("by the radius", radius * 1e-3, "N*m/mm"),
        Answer::new("by the length of the rod", length * 1e-3, "N*m/mm"),
        Answer::new("by the mass of the slider", load, "N*m/kg"),
        Answer::new("by the speed", speed * std::f64::consts::TAU / 60.0, "N*m/(rev/min)"),
    ])
}

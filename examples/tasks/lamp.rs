//! Do two springs hold a desk lamp in every position, and which torque is left with a heavier bulb?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A bar beside the lower arm keeps the elbow upright. The springs have no free length.
    pub Lamp {
        gravity: 9.81 m/s^2;
        param bulb: kg = 0.3 kg;
        param lower_angle = 60 deg; param upper_angle = 20 deg;
        let upper_moment = 0.4 kg*0.2 m + 0.3 kg*0.4 m;
        let lower_moment = 0.6 kg*0.2 m + (0.1 kg + 0.4 kg + 0.3 kg)*0.4 m + 0.2 kg*0.2 m;
        ground { port pivot: (0, 0) mm; port beside: (-40, 0) mm; port hook: (0, 120) mm; }
        body lower {
            mass: 0.6 kg; inertia: rod(0.6 kg, 0.4 m);
            port pivot: (-200, 0) mm; port hook: (-120, 0) mm; port elbow: (200, 0) mm;
            start angle: lower_angle;
        }
        body bar {
            mass: 0.2 kg; inertia: rod(0.2 kg, 0.4 m);
            port pivot: (-200, 0) mm; port elbow: (200, 0) mm; start angle: lower_angle;
        }
        body elbow {
            mass: 0.1 kg; inertia: 1e-4 kg*m^2;
            port pin: (0, 0) mm; port beside: (-40, 0) mm; port hook: (0, 100) mm;
        }
        body upper {
            mass: 0.4 kg; inertia: rod(0.4 kg, 0.4 m);
            port elbow: (-200, 0) mm; port hook: (-120, 0) mm; port head: (200, 0) mm;
            start angle: upper_angle;
        }
        revolute foot(ground.pivot, lower.pivot);
        revolute side(ground.beside, bar.pivot);
        revolute knee(lower.elbow, elbow.pin);
        revolute cheek(bar.elbow, elbow.beside);
        revolute neck(elbow.pin, upper.elbow);
        body head { mass: bulb; inertia: 1e-4 kg*m^2; port socket: (0, 0) mm; }
        weld socket(upper.head, head.socket);
        spring below(ground.hook, lower.hook) { stiffness: 9.81 m/s^2*lower_moment/(120 mm*80 mm); }
        spring above(elbow.hook, upper.hook) { stiffness: 9.81 m/s^2*upper_moment/(100 mm*80 mm); }
        constraint lift: lower.angle = lower_angle;
        constraint tilt: upper.angle = upper_angle;
        output lower_torque = -reaction(lift), upper_torque = -reaction(tilt);
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut largest = 0.0_f64;
    for (lower_angle, upper_angle) in [(1.2, 0.3), (0.8, -0.5), (2.0, 0.9), (1.5, -1.0)] {
        let sim = Lamp { lower_angle, upper_angle, ..Lamp::new() }.start()?;
        largest = largest.max(sim.lower_torque().abs()).max(sim.upper_torque().abs());
    }
    let heavy = Lamp { bulb: 0.4, ..Lamp::new() }.start()?;
    Ok(vec![
        Answer::new("largest torque of four positions", largest, "N*m"),
        Answer::new("foot, with a bulb of 0.4 kg", heavy.lower_torque(), "N*m"),
        Answer::new("elbow, with a bulb of 0.4 kg", heavy.upper_torque(), "N*m"),
    ])
}

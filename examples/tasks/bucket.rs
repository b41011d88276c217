//! Which pressure does the cylinder of a loader need for a full bucket, and how high does its pump lift it in 4 s?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A link beside the boom keeps the bucket level. The pump runs for 4 s, and the oil is shut in then.
    pub Loader {
        gravity: 9.81 m/s^2;
        ground { port boom: (0, 1.5) m; port link: (0, 1.8) m; port cylinder: (0.4, 0.7) m; }
        body boom {
            mass: 250 kg; inertia: rod(250 kg, 2.4 m);
            port rear: (-1.2, 0) m; port cylinder: (-0.2, -0.1) m; port front: (1.2, 0) m;
            start angle: -25 deg, locked;
        }
        body link {
            mass: 40 kg; inertia: rod(40 kg, 2.4 m); port rear: (-1.2, 0) m; port front: (1.2, 0) m;
            start angle: -25 deg;
        }
        body bucket {
            mass: 900 kg; inertia: 80 kg*m^2; centre: (0.5, 0) m;
            port boom: (0, 0) m; port link: (0, 0.3) m;
        }
        revolute rear(ground.boom, boom.rear);
        revolute front(boom.front, bucket.boom);
        revolute link_rear(ground.link, link.rear);
        revolute link_front(link.front, bucket.link);
        jack lift(ground.cylinder, boom.cylinder) { free_length: 0.5 m; drive: -20 kN/(m/s)*lift.speed; }
        chamber oil() { dead_volume: 1 L; pressure: 50 bar; }
        piston ram(lift.slider, oil.port) { diameter: 80 mm; }
        oil_tank tank();
        shaft_velocity engine() {
            speed: table(t, (0 s, 0 rev/min), (0.5 s, 1500 rev/min), (4 s, 1500 rev/min), (4.5 s, 0 rev/min));
        }
        pump feed(engine.shaft, tank.port, oil.port) { displacement: 20 cm^3/rev; }
        output oil.pressure in bar, bucket.y, lift.displacement;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Loader::new().start()?;
    let low = sim.bucket().y;
    let mut highest = 0.0_f64;
    sim.run(10.0, 0.001, |state| highest = highest.max(state.outputs()[0]))?;
    let [held, height, stroke] = sim.outputs();
    Ok(vec![
        Answer::new("highest pressure", highest, "bar"),
        Answer::new("pressure that holds it at the top", held, "bar"),
        Answer::new("lifted by", height - low, "m"),
        Answer::new("stroke of the cylinder at the top", 1000.0 * stroke, "mm"),
    ])
}

//! Does a valve stay on its cam, with how much force at least, and how far does it fly at a higher speed?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A harmonic cam under a flat follower on a spring.
    pub Valve {
        param speed: rad/s;
        ground { port shaft: (0, 0) mm, axis: 90 deg; }
        body shaft { mass: 1 kg; inertia: 1e-3 kg*m^2; port cam: (0, 0) mm, angle: 90 deg; }
        body valve {
            mass: 0.2 kg; inertia: 1e-4 kg*m^2; port face: (0, 0) mm, angle: 90 deg; start y: 20 mm;
        }
        revolute bearing(ground.shaft, shaft.cam);
        prismatic guide(ground.shaft, valve.face) { stiffness: 20 N/mm; free_length: 10 mm; }
        constraint turns: shaft.angle = speed*t;
        cam lobe(shaft.cam, valve.face) {
            face: flat; base_radius: 20 mm; lift(angle): 4 mm*(1 - cos(angle));
        }
        discrete lifts: rad = 0;
        when lobe.push < 1e-6 N { lifts = shaft.angle; }
        output lobe.push, lobe.gap, lifts;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let turn = |speed: f64| {
        let (mut least, mut gap) = (f64::INFINITY, 0.0_f64);
        let mut sim = Valve::new(speed).start()?;
        sim.run(std::f64::consts::TAU / speed, 1e-5, |state| {
            (least, gap) = (least.min(state.lobe_push()), gap.max(state.lobe_gap()));
        })?;
        Ok::<_, plm::Fault>((least, gap, sim.lifts()))
    };
    let ((least, _, _), (_, gap, lifts)) = (turn(600.0)?, turn(750.0)?);
    Ok(vec![
        Answer::new("600 rad/s: least force", least, "N"),
        Answer::new("750 rad/s: lifts off at", lifts.to_degrees(), "deg"),
        Answer::new("750 rad/s: flies as high as", 1000.0 * gap, "mm"),
    ])
}

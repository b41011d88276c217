//! Which force of the hand does a toggle clamp need for 2 kN at its jaw?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A handle, a link and a jaw. At 0 deg handle and link are in line, and the jaw is closed.
    pub Toggle {
        /// How far the handle is from the line.
        param handle_angle: rad = 30 deg;
        ground { port handle: (0, 0) mm; port jaw: (60, -35) mm; }
        body handle {
            mass: 0.2 kg; inertia: 1e-4 kg*m^2;
            port pivot: (0, 0) mm; port pin: (25, 0) mm; port grip: (-150, 0) mm;
            start angle: handle_angle;
        }
        body link {
            mass: 0.1 kg; inertia: 1e-5 kg*m^2; port pin: (0, 0) mm; port knuckle: (35, 0) mm;
            start angle: -10 deg;
        }
        body jaw {
            mass: 0.3 kg; inertia: 2e-4 kg*m^2;
            port pivot: (0, 0) mm; port knuckle: (0, 35) mm; port pad: (80, 0) mm;
            start x: 60 mm; start y: -35 mm;
        }
        revolute handle_pivot(ground.handle, handle.pivot);
        revolute pin(handle.pin, link.pin);
        revolute knuckle(link.knuckle, jaw.knuckle);
        revolute jaw_pivot(ground.jaw, jaw.pivot);
        force workpiece(jaw.pad) { axes: body; y: 2000 N; }
        constraint hand: handle.angle = handle_angle;
        // At the grip, across the handle.
        output force = reaction(hand)/(150 mm);
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Toggle::new().start()?;
    let mut force = |degrees: f64| {
        sim.mechanism.handle_angle = degrees.to_radians();
        sim.project()?;
        Ok::<f64, plm::Fault>(sim.force())
    };
    Ok(vec![
        Answer::new("force of the hand at 30 deg", force(30.0)?, "N"),
        Answer::new("at 10 deg", force(10.0)?, "N"),
        Answer::new("at 2 deg", force(2.0)?, "N"),
        Answer::new("at 2 deg beyond the line, where it holds by itself", force(-2.0)?, "N"),
    ])
}

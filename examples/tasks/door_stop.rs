//! Where does the stop of a door spare its hinges, and how hard does the door strike it?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A door of 0.9 m, seen from above, on its way to a rubber stop.
    pub Door {
        /// Distance of the stop from the hinge.
        param reach: m = 0.6 m;
        ground { port hinge: (0, 0) m; port rubber: (reach, 0 m), axis: 90 deg; }
        body door {
            mass: 25 kg; inertia: rod(25 kg, 0.9 m); port hinge: (-0.45, 0) m; port pad: (reach - 0.45 m, 0 m);
            start angle: 10 deg, locked; start omega: -2 rad/s, locked;
        }
        revolute hinge(ground.hinge, door.hinge);
        stop rubber(ground.rubber, door.pad) { stiffness: 1000 kN/m; damping: 2 kN*s/m; }
        output rubber.force, across = dot(hinge.force, door.normal);
    }
}

/// Greatest force of the stop, and across the door at the hinges, N; speed after the impact, rad/s.
fn strike(reach: f64) -> Result<[f64; 3], plm::Fault> {
    let mut sim = Door { reach, ..Door::new() }.start()?;
    let (mut stop, mut hinge) = (0.0_f64, 0.0_f64);
    sim.run(0.15, 2e-5, |state| {
        stop = stop.max(state.rubber_force());
        hinge = hinge.max(state.across().abs());
    })?;
    Ok([stop, hinge, sim.door().omega])
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let ([stop, spared, back], [handle, hinge, _]) = (strike(0.6)?, strike(0.85)?);
    Ok(vec![
        Answer::new("force of the stop at 0.60 m", stop, "N"),
        Answer::new("force across the hinges then", spared, "N"),
        Answer::new("the door comes back with", back, "rad/s"),
        Answer::new("force of the stop at 0.85 m", handle, "N"),
        Answer::new("force across the hinges there", hinge, "N"),
    ])
}

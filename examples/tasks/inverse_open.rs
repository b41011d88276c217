//! Which torques do the two motors of an arm need for a planned motion with a load in its hand?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// Both joints move as planned, from rest to rest in 1 s; the torques are those of the motions.
    pub Arm {
        gravity: 9.81 m/s^2;
        ground { port base: (0, 0) m; }
        body upper {
            mass: 5 kg; inertia: rod(5 kg, 0.5 m);
            port shoulder: (-0.25, 0) m; port elbow: (0.25, 0) m; start angle: -60 deg;
        }
        body lower {
            mass: 3 kg; inertia: rod(3 kg, 0.4 m); port elbow: (-0.2, 0) m; port hand: (0.2, 0) m;
            start angle: 30 deg;
        }
        revolute shoulder(ground.base, upper.shoulder);
        revolute elbow(upper.elbow, lower.elbow);
        body load { mass: 2 kg; inertia: 2e-3 kg*m^2; port middle: (0, 0) m; }
        weld grip(lower.hand, load.middle);
        motion lift(shoulder.shaft) { value: smooth_table(t, (0 s, -60 deg), (1 s, 30 deg)); }
        motion bend(elbow.shaft) { value: smooth_table(t, (0 s, 90 deg), (1 s, 20 deg)); }
        output lift.torque, bend.torque, lift.power, bend.power;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Arm::new().start()?;
    let mut largest = [0.0_f64; 2];
    sim.run(1.0, 0.01, |state| {
        let torques = [state.lift_torque(), state.bend_torque()];
        largest = [0, 1].map(|k| largest[k].max(torques[k].abs()));
    })?;
    sim.reset()?;
    sim.step_to(0.4)?;
    Ok(vec![
        Answer::new("shoulder at 0.4 s", sim.lift_torque(), "N*m"),
        Answer::new("elbow at 0.4 s", sim.bend_torque(), "N*m"),
        Answer::new("shoulder at most", largest[0], "N*m"),
        Answer::new("elbow at most", largest[1], "N*m"),
        Answer::new("power of both at 0.4 s", sim.lift_power() + sim.bend_power(), "W"),
    ])
}

//! How far does a load swing on the rope of a crane, and how long must the trolley take so that it hangs still behind?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A trolley goes by 6 m from rest to rest with the least jerk.
    pub Crane {
        gravity: 9.81 m/s^2;
        param time: s = 6 s;
        ground { port rail: (0, 0) m; }
        body trolley { mass: 200 kg; inertia: 10 kg*m^2; port wheels: (0, 0) m; port drum: (0, 0) m; }
        body load { mass: 500 kg; inertia: 50 kg*m^2; port eye: (0, 0) m; start y: -5 m; }
        prismatic rail(ground.rail, trolley.wheels);
        constraint drive: rail.displacement = smooth_table(t/time, (0, 0 m), (1, 6 m));
        rope line() { length: 5 m; }
        fall hang(line.end, trolley.drum, load.eye);
        output line.tension, swing = atan2(load.x - trolley.x, trolley.y - load.y), drive_force = -reaction(drive);
    }
}

/// How far the load swings behind, rad, by its energy at the end of the way.
fn after(time: f64) -> Result<f64, plm::Fault> {
    let mut sim = Crane { time, ..Crane::new() }.start()?;
    sim.step(time)?;
    let load = sim.load();
    let height = load.y + 5.0 + (load.vx * load.vx + load.vy * load.vy) / (2.0 * 9.81);
    Ok((1.0 - height / 5.0).acos())
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Crane::new().start()?;
    let (mut swing, mut rope, mut drive) = (0.0_f64, 0.0_f64, 0.0_f64);
    sim.run(6.0, 0.01, |state| {
        swing = swing.max(state.swing().abs());
        rope = rope.max(state.line_tension());
        drive = drive.max(state.drive_force().abs());
    })?;
    let mut best = (0.0, f64::INFINITY);
    for tenth in 70..95 {
        let time = f64::from(tenth) * 0.1;
        let rest = after(time)?;
        best = if rest < best.1 { (time, rest) } else { best };
    }
    Ok(vec![
        Answer::new("in 6 s the load swings by", swing.to_degrees(), "deg"),
        Answer::new("and after by", after(6.0)?.to_degrees(), "deg"),
        Answer::new("greatest pull of the rope", rope, "N"),
        Answer::new("greatest force of the trolley", drive, "N"),
        Answer::new("it hangs still after", best.0, "s"),
        Answer::new("but for", best.1.to_degrees(), "deg"),
    ])
}

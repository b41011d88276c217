//! How high does a ball come back after each bounce, and when does it lie still?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A ball that falls by 1 m on a floor, from which it comes back with 0.8 of its speed.
    pub Ball {
        gravity: 9.81 m/s^2;
        ground { port floor: (0, 0) m; }
        body ball {
            mass: 0.6 kg; inertia: thin_sphere(0.6 kg, 0.12 m); port middle: (0, 0) m;
            start y: 1.12 m;
        }
        circle_on_line floor(ground.floor, ball.middle) { radius: 0.12 m; restitution: 0.8; }
        // Heights at the last turning points, the last one first.
        discrete last: m = 0;
        discrete before: m = 0;
        discrete rests: s = 0;
        when ball.vy < 0 { before = last; last = floor.gap; }
        when floor.push > 0 { rests = t; }
        output last, before, rests, floor.push;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Ball::new().start()?;
    sim.step_to(1.8)?;
    let (first, second) = (sim.before(), sim.last());
    sim.step_to(5.0)?;
    Ok(vec![
        Answer::new("height after the first bounce", first, "m"),
        Answer::new("height after the second bounce", second, "m"),
        Answer::new("lies still from", sim.rests(), "s"),
        Answer::new("presses on the floor with", sim.floor_push(), "N"),
    ])
}

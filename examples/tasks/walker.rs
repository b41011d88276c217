//! How fast does a compass with two legs walk down a slope, without a motor?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// Legs of 1 m on a slope of 3 deg, which lies along x: Goswami, Thuilot, Espiau, Int. J. Robotics Research 17, 1998.
    pub Walker {
        gravity: 9.81 m/s^2*(sin(3 deg), -cos(3 deg));
        discrete left_is_on: 1 = 1;
        discrete right_is_on: 1 = 0;
        discrete struck: s = 0;
        discrete place: m = 0;
        let stance = 15.529 deg;
        let swing = -15.529 deg;
        // Each leg is drawn from its upper end; the left one stands.
        body left {
            mass: 10 kg; inertia: 0.625 kg*m^2; centre: (0, 0.75) m; port foot: (0, 0) m; port hip: (0, 1) m;
            start angle: stance; start omega: -1.0924 rad/s;
        }
        body right {
            mass: 10 kg; inertia: 0.625 kg*m^2; centre: (0, -0.25) m; port hip: (0, 0) m; port foot: (0, -1) m;
            start x: -1 m*sin(stance); start y: 1 m*cos(stance); start angle: swing;
            start vx: 1.0924 m/s*cos(stance); start vy: 1.0924 m/s*sin(stance); start omega: -0.3774 rad/s;
        }
        revolute hip(left.hip, right.hip);
        unilateral left_foot: left.foot.y >= 0 m { when: left_is_on > 0.5; }
        unilateral right_foot: right.foot.y >= 0 m { when: right_is_on > 0.5; }
        friction left_grips: rate(left.foot.x) within 100*reaction(left_foot) { when: left_is_on > 0.5; }
        friction right_grips: rate(right.foot.x) within 100*reaction(right_foot) { when: right_is_on > 0.5; }
        // The leg that swings has no knee: it passes through the ground, and can strike when it is ahead and above it again.
        when right.foot.x > left.foot.x + 0.1 m and right.foot.y > 0.1 mm { right_is_on = 1; }
        when left.foot.x > right.foot.x + 0.1 m and left.foot.y > 0.1 mm { left_is_on = 1; }
        when right_is_on > 0.5 and is_open(left_foot) and not is_open(right_foot) { left_is_on = 0; struck = t; place = right.foot.x; }
        when left_is_on > 0.5 and is_open(right_foot) and not is_open(left_foot) { right_is_on = 0; struck = t; place = left.foot.x; }
        output struck, place;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Walker::new().start()?;
    // It starts next to its cycle, to which neighbouring motions come by themselves: each step is as the one before.
    sim.step_to(3.2)?;
    let (time, place, energy) = (sim.struck(), sim.place(), sim.impact_energy().lost);
    let taken = sim.contact_stats().impacts;
    sim.step_to(6.2)?;
    let steps = (sim.contact_stats().impacts - taken) as f64;
    let (period, length) = ((sim.struck() - time) / steps, (sim.place() - place) / steps);
    Ok(vec![
        Answer::new("time of a step", period, "s"),
        Answer::new("length of a step", length, "m"),
        Answer::new("speed", length / period, "m/s"),
        Answer::new("energy that a step loses", (sim.impact_energy().lost - energy) / steps, "J"),
    ])
}

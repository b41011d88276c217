//! How far does a block slide up a slope, does it stay there, and how fast does it come back?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A block with static and kinetic friction, in axes along the slope. It starts upwards at 3 m/s.
    pub Incline {
        param slope: rad = 20 deg;
        gravity: -9.81 m/s^2*(sin(slope), cos(slope));
        ground { port foot: (0, 0) m; }
        body block { mass: 5 kg; inertia: 0.05 kg*m^2; port sole: (0, 0) m; start vx: 3 m/s; }
        prismatic track(ground.foot, block.sole) { friction: 0.3; static_friction: 0.4; }
        discrete turned: s = 0;
        discrete back: s = 0;
        discrete returned: m/s = 0;
        when track.speed <= 0 { turned = t; }
        when track.displacement < 0 { back = t; returned = track.speed; }
        output track.displacement, track.speed, track.friction_force, turned, back, returned;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut gentle = Incline::new().start()?;
    gentle.step(2.0)?;
    let mut steep = Incline { slope: 30_f64.to_radians(), ..Incline::new() }.start()?;
    steep.step(2.0)?;
    Ok(vec![
        Answer::new("20 deg: slides up for", gentle.turned(), "s"),
        Answer::new("20 deg: comes to rest at", gentle.track_displacement(), "m"),
        Answer::new("20 deg: is held by", gentle.track_friction_force(), "N"),
        Answer::new("30 deg: slides up for", steep.turned(), "s"),
        Answer::new("30 deg: is back at", steep.back(), "s"),
        Answer::new("30 deg: with a speed of", -steep.returned(), "m/s"),
    ])
}

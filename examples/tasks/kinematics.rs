//! How fast do the bars of a four-bar linkage turn, and how are they accelerated, while its crank speeds up?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// Lengths of R. L. Norton, Design of Machinery: crank 40 mm, coupler 120 mm, rocker 80 mm, ground 100 mm.
    pub FourBar {
        ground { port a: (0, 0) mm; port d: (100, 0) mm; }
        body crank { port a: (0, 0) mm; port b: (40, 0) mm; start angle: 40 deg; }
        body coupler {
            port b: (0, 0) mm; port c: (120, 0) mm; port tracer: (60, 40) mm; start angle: 20 deg;
        }
        body rocker { port d: (0, 0) mm; port c: (80, 0) mm; start angle: 60 deg; start x: 100 mm; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(ground.d, rocker.d);
        constraint motor: crank.angle = 40 deg + 25 rad/s*t + 15 rad/s^2*t^2/2;
        output coupler.alpha, rocker.alpha;
        output coupler.tracer.position, coupler.tracer.velocity, coupler.tracer.acceleration;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let sim = FourBar::new().start()?;
    let [x, y] = sim.coupler_tracer_position();
    let [vx, vy] = sim.coupler_tracer_velocity();
    let [ax, ay] = sim.coupler_tracer_acceleration();
    Ok(vec![
        Answer::new("coupler angle", sim.coupler().angle.to_degrees(), "deg"),
        Answer::new("coupler speed", sim.coupler().omega, "rad/s"),
        Answer::new("coupler acceleration", sim.coupler_alpha(), "rad/s^2"),
        Answer::new("rocker angle", sim.rocker().angle.to_degrees(), "deg"),
        Answer::new("rocker speed", sim.rocker().omega, "rad/s"),
        Answer::new("rocker acceleration", sim.rocker_alpha(), "rad/s^2"),
        Answer::new("tracer x", x, "m"),
        Answer::new("tracer y", y, "m"),
        Answer::new("tracer speed along x", vx, "m/s"),
        Answer::new("tracer speed along y", vy, "m/s"),
        Answer::new("tracer acceleration along x", ax, "m/s^2"),
        Answer::new("tracer acceleration along y", ay, "m/s^2"),
    ])
}

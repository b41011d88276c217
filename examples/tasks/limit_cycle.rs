//! How fast does a wheel of spokes without a rim go down a slope, and how does that change with the slope?
use std::error::Error;

use plm::runtime::Seen;
use plm::{By, Dop853, Dual, Fault, Moment, Sim, with_derivatives};

use super::{Answer, Answers};

plm::mechanism! {
    /// It stands on one of eight spokes, just after an impact, and the next one comes: T. McGeer, Int. J. Robotics Research 9, 1990.
    pub Wheel {
        param slope: rad = 5 deg;
        param speed: rad/s = 1.5 rad/s;
        let half = 22.5 deg;
        gravity: 9.81 m/s^2*(sin(slope), -cos(slope));
        body hub {
            mass: 2 kg; inertia: 0.6 kg*m^2;
            start x: -0.8 m*sin(half), locked; start y: 0.8 m*cos(half), locked; start angle: half, locked;
            start vx: 0.8 m*speed*cos(half), locked; start vy: 0.8 m*speed*sin(half), locked; start omega: -speed, locked;
        }
        repeat i in 0..2 {
            let foot = hub.position + turn((0, -0.8) m, hub.angle + 2*i*half);
            unilateral tip[i]: foot.y >= 0 m;
            friction grip[i]: rate(foot.x) within 100*reaction(tip[i]);
        }
    }
}

/// Speed and time after the next impact, with derivatives by the speed after the last one and by the slope.
fn step(speed: f64) -> Result<[Dual<f64, 2>; 2], Fault> {
    let by = [By::Parameter("speed"), By::Parameter("slope")];
    let wheel = with_derivatives(&Wheel { speed, ..Wheel::new() }, by).expect("both are there");
    let (mut sim, mut after) = (wheel.start_with(Dop853::new(1e-12.into()))?, None);
    while after.is_none() {
        Sim::watch_towards(&mut sim, 10.0.into(), |seen| {
            if let Seen::Switched(state) = seen {
                after = Some([-state.hub().omega, Moment::time(state)]);
            }
        })?;
    }
    Ok(after.expect("it has struck"))
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    // Newton's method: the speed is the same after the next impact.
    let mut speed = 1.5;
    for _ in 0..6 {
        let [Dual { value, tangents: [by_speed, _] }, _] = step(speed)?;
        speed -= (value - speed) / (by_speed - 1.0);
    }
    let [Dual { tangents: [multiplier, by_slope], .. }, time] = step(speed)?;
    Ok(vec![
        Answer::new("speed after an impact", speed, "rad/s"),
        Answer::new("time of a step", time.value, "s"),
        Answer::new("part of a disturbance that a step leaves", multiplier, "1"),
        // v(p) = P(v(p), p), so that dv/dp = P_p/(1 - P_v).
        Answer::new("change of the speed with the slope", by_slope / (1.0 - multiplier), "rad/s per rad"),
    ])
}

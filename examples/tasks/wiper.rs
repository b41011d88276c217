//! Which angle does a wiper sweep, how long does each way take, and which transmission angles has its linkage?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// Lengths alone decide: no body has a mass.
    pub Wiper {
        param speed = 45 rev/min;
        ground { port motor: (0, 0) mm; port pivot: (300, 0) mm; }
        body crank { port motor: (0, 0) mm; port pin: (60, 0) mm; }
        body coupler { port pin: (0, 0) mm; port wrist: (280, 0) mm; start angle: 20 deg; }
        body rocker { port pivot: (0, 0) mm; port wrist: (100, 0) mm; start x: 300 mm; start angle: 80 deg; }
        revolute motor(ground.motor, crank.motor);
        revolute pin(crank.pin, coupler.pin);
        revolute wrist(coupler.wrist, rocker.wrist);
        revolute pivot(ground.pivot, rocker.pivot);
        constraint drive: crank.angle = speed*t;
        // Where the wiper turns round.
        discrete right: rad = 0; discrete right_at: s = 0;
        discrete left: rad = 0; discrete left_at: s = 0;
        when rocker.omega > 0 { right = rocker.angle; right_at = t; }
        when rocker.omega < 0 { left = rocker.angle; left_at = t; }
        output left, left_at, right, right_at, wrist.angle;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let wiper = Wiper::new();
    let turn = std::f64::consts::TAU / wiper.speed;
    let mut sim = wiper.start()?;
    let transmission = sim.wrist_angle();
    sim.step_to(0.5 * turn)?;
    let opposite = sim.wrist_angle();
    sim.step_to(2.0 * turn)?;
    let leftwards = (sim.left_at() - sim.right_at()).rem_euclid(turn);
    Ok(vec![
        Answer::new("swept angle", (sim.left() - sim.right()).to_degrees(), "deg"),
        Answer::new("way to the left", leftwards, "s"),
        Answer::new("way to the right", turn - leftwards, "s"),
        Answer::new("transmission angle, crank towards the pivot", transmission.to_degrees(), "deg"),
        Answer::new("transmission angle, crank away from it", opposite.to_degrees(), "deg"),
    ])
}

//! What do a pair of gears and a planetary gear make of a motor's torque: speed of the drum, forces of the teeth, losses?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A motor turns the drum of a hoist. The shaft of the wheel is the sun of the planetary gear, whose ring is fixed.
    pub Gears {
        ground { port motor: (0, 0) mm; port shaft: (160, 0) mm; }
        body pinion { mass: 1 kg; inertia: disc(1 kg, 40 mm); port hub: (0, 0) mm; }
        body wheel { mass: 6 kg; inertia: disc(6 kg, 120 mm); port hub: (0, 0) mm; start x: 160 mm; }
        revolute motor(ground.motor, pinion.hub) { drive: -10 N*m; }
        revolute shaft(ground.shaft, wheel.hub);
        gear pair(ground.motor, pinion.hub, wheel.hub) { module: 4 mm; teeth_a: 20; teeth_b: 60; efficiency: 0.98; }
        shaft_ground housing();
        // The load holds against the drum, which turns the other way than the motor.
        rotor drum() { inertia: 20 kg*m^2; drive: -80 N*m; }
        planetary reducer(shaft.shaft, housing.shaft, drum.shaft) { teeth_sun: 24; teeth_ring: 72; efficiency: 0.97; }
        output drum.speed, pair.tooth_force, first_bearing = norm(motor.force), reducer.torque_ring, reducer.torque_carrier;
        output lost = pair.lost + reducer.lost;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Gears::new().start()?;
    sim.step(2.0)?;
    let taken = -10.0 * sim.pinion().omega;
    Ok(vec![
        Answer::new(
            "speed of the drum after 2 s",
            sim.drum_speed() * 60.0 / std::f64::consts::TAU,
            "rev/min",
        ),
        Answer::new("torque on the drum", sim.reducer_torque_carrier(), "N*m"),
        Answer::new("torque on the fixed ring", sim.reducer_torque_ring(), "N*m"),
        Answer::new("force of the teeth of the pair", sim.pair_tooth_force(), "N"),
        Answer::new("force of the motor's bearing", sim.first_bearing(), "N"),
        Answer::new("efficiency of both gears", 1.0 - sim.lost() / taken, ""),
    ])
}

//! How long does an indexing table rest, how fast does it turn between, and what does the pin of its Geneva drive bear?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A table with six stations. The pin is a quarter of a turn from the line of centres at the start.
    pub Indexer {
        param speed = 60 rev/min;
        ground { port driver: (0, 0) mm; port table: (160, 0) mm; }
        body driver { mass: 2 kg; inertia: disc(2 kg, 80 mm); port hub: (0, 0) mm; }
        body table { mass: 30 kg; inertia: 2 kg*m^2; port hub: (0, 0) mm; start x: 160 mm; }
        revolute main(ground.driver, driver.hub);
        revolute axle(ground.table, table.hub);
        geneva drive(ground.driver, driver.hub, table.hub) { slots: 6; }
        constraint motor: driver.angle = speed*t - 90 deg;
        output drive.engaged, drive.ratio, drive.pin_force, table.alpha, torque = -reaction(motor);
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Indexer::new().start()?;
    let before = sim.table().angle;
    let (mut moves, mut ratio, mut force, mut torque) = (0.0, 0.0_f64, 0.0_f64, 0.0_f64);
    // A turn of the driver takes 1 s.
    sim.run(1.0, 1e-4, |state| {
        moves += 1e-4 * state.drive_engaged();
        ratio = ratio.max(state.drive_ratio().abs());
        force = force.max(state.drive_pin_force().abs());
        torque = torque.max(state.torque().abs());
    })?;
    Ok(vec![
        Answer::new("the table rests for", 1.0 - moves, "s"),
        Answer::new("it turns in that turn by", (sim.table().angle - before).to_degrees(), "deg"),
        Answer::new("greatest speed over the driver's", ratio, ""),
        Answer::new("greatest force of the pin", force, "N"),
        Answer::new("greatest torque of the motor", torque, "N*m"),
    ])
}

//! At which tooth does a jack hold its load when the crank is let go, what do its pawl and its latch bear?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A rack-and-pinion jack with a ratchet at its pinion, and a latch for the load at 200 mm.
    pub Jack {
        gravity: 9.81 m/s^2;
        /// Torque on the pinion.
        input crank: N*m = 60 N*m;
        /// The pawl is lifted while this is 1.
        input lifted = 0;
        ground { port axle: (0, 0) mm, axis: 90 deg; port mast: (60, 0) mm, axis: 90 deg; }
        body pinion { mass: 1 kg; inertia: 2e-3 kg*m^2; port hub: (0, 0) mm, angle: 90 deg; }
        body load { mass: 80 kg; inertia: 1 kg*m^2; port rail: (0, 0) mm, angle: 90 deg; start x: 60 mm; }
        revolute axle(ground.axle, pinion.hub) { drive: crank; }
        prismatic mast(ground.mast, load.rail);
        rack teeth(pinion.hub, load.rail) { radius: 60 mm; }
        ratchet pawl(ground.axle, pinion.hub) { teeth: 20; lifted: lifted; }
        latch top(ground.mast, load.rail) { position: 200 mm; strength: 1 kN; }
        output mast.displacement, pawl.torque, top.force, top.catches;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Jack::new().start()?;
    sim.step(0.3)?;
    let let_go = sim.mast_displacement();
    sim.input.crank = 0.0;
    sim.step(1.0)?;
    let (held, pawl) = (sim.mast_displacement(), sim.pawl_torque());

    // On to the latch, which then bears the load alone.
    sim.input.crank = 60.0;
    sim.step(0.3)?;
    sim.input.crank = 0.0;
    sim.input.lifted = 1.0;
    sim.step(1.0)?;
    let (top, latch) = (sim.mast_displacement(), sim.top_force());
    // Turned down harder and harder it lets go at 1 kN.
    while sim.top_catches() > 0.5 && sim.input.crank > -60.0 {
        sim.input.crank -= 0.1;
        sim.step(0.01)?;
    }
    Ok(vec![
        Answer::new("the crank is let go at", let_go * 1e3, "mm"),
        Answer::new("the pawl holds at", held * 1e3, "mm"),
        Answer::new("the pawl bears", pawl, "N*m"),
        Answer::new("the latch holds at", top * 1e3, "mm"),
        Answer::new("the latch bears", latch, "N"),
        Answer::new("it lets go, turned down by", -sim.input.crank, "N*m"),
    ])
}

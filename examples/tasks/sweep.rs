//! Which buffer stops a wagon within 0.3 m and with the least force?
use std::error::Error;

use plm::batch;

use super::{Answer, Answers};

plm::mechanism! {
    /// A wagon that runs on a buffer.
    pub Wagon {
        param stiffness = 1000 kN/m;
        param damping = 0 N*s/m;
        ground { port rail: (0, 0) m; port buffer: (0, 0) m, axis: 180 deg; }
        body wagon { mass: 20 tonne; inertia: 1000 kg*m^2; port wheels: (0, 0) m; start x: -0.1 m, locked; start vx: 2 m/s, locked; }
        prismatic rail(ground.rail, wagon.wheels);
        stop buffer(ground.buffer, wagon.wheels) { stiffness: stiffness; damping: damping; }
        output buffer.force, rail.displacement;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let stiffnesses: Vec<f64> = (10..=25).map(|k| f64::from(k) * 20e3).collect();
    let dampings: Vec<f64> = (6..=16).map(|k| f64::from(k) * 5e3).collect();
    let runs = batch::grid(&stiffnesses, &dampings).quiet().run(|(stiffness, damping)| {
        let mut sim = Wagon { stiffness, damping, ..Wagon::new() }.start()?;
        let (mut force, mut stroke) = (0.0_f64, 0.0_f64);
        sim.run(0.8, 4e-3, |state| {
            force = force.max(state.buffer_force());
            stroke = stroke.max(state.rail_displacement());
        })?;
        Ok((force, stroke))
    });
    let fits = runs.values().filter(|(_, (_, stroke))| *stroke <= 0.3);
    let best = fits.min_by(|(_, a), (_, b)| a.0.total_cmp(&b.0)).ok_or("no buffer is strong enough")?;
    let (&(stiffness, damping), &(force, stroke)) = best;
    Ok(vec![
        Answer::new("buffers tried", runs.values().count() as f64, ""),
        Answer::new("stiffness of the best", stiffness / 1e3, "kN/m"),
        Answer::new("its damping", damping / 1e3, "kN*s/m"),
        Answer::new("its greatest force", force / 1e3, "kN"),
        Answer::new("its stroke", stroke * 1e3, "mm"),
    ])
}

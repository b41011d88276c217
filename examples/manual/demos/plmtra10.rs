//! PLMTRA10, section 4.2.3.3: a mass on four slopes, held by a spring on the driven prismatic joint.
//!
//! ```text
//!              /[ M ]   20 kg, slides along the slope
//!            / Z        10000 N/m and a damper of 40 %
//!          o0___ alpha = 0, 30, 60, 90 deg
//! ```
//!
//! The spring is SD0000: its force is a state, zero at the start, whose rate is the stiffness times the speed. A positive
//! force pushes the ports apart.

use plm::batch::{self, Failure};
use plm::{Dop853, Fault};

use super::balance::{self, Balance, Ledger, RTOL};
use super::sheet::Reading::Rounded;
use super::sheet::Sheet;

plm::mechanism! {
    /// The manual's mass on a slope, on the driven guide PLMTRA10.
    pub Plmtra10 {
        gravity: 9.81 m/s^2;
        /// Angle of the slope.
        param alpha: deg = 30 deg;
        let stiffness = 10000 N/m;
        let rating = 2*0.4*sqrt(10000 N/m*20 kg);

        ground { port o0: (0, 0) m, axis: alpha; }
        body block { mass: 20 kg; inertia: 0.01 kg*m^2; port p: (0.1, 0) m; start x: 0.1 m; }
        prismatic slope(ground.o0, block.p) { drive: push - rating*slope.speed; }
        state push: N = 0;
        rate push = -stiffness*slope.speed;

        let energy = push^2/(2*stiffness);
        output push, spring_energy = energy, absorbed = rate(energy);
        output lost = rating*slope.speed^2;
    }
}

/// Slopes in degrees, and the force that the manual prints for each.
const SLOPES: [(u8, f64); 4] = [(0, 0.0), (30, 98.1), (60, 169.91), (90, 196.2)];

/// Four slopes, 3 s each, as a batch.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMTRA10");
    let runs = batch::points(SLOPES).run(|(degrees, _)| {
        let alpha = f64::from(degrees).to_radians();
        let mut sim = Plmtra10 { alpha, ..Plmtra10::new() }.start_with(Dop853::new(RTOL))?;
        let balance = balance::run(&mut sim, (6000, 5e-4), |s| Ledger {
            kinetic: s.kinetic_energy(),
            gravity: s.gravity_energy(),
            springs: s.spring_energy(),
            absorbed: s.absorbed(),
            lost: s.lost(),
            loads: s.load_power(),
            ..Ledger::default()
        })?;
        Ok((sim.push(), balance))
    });
    let mut worst = Balance::default();
    for ((degrees, printed), (push, balance)) in runs.values() {
        let name = format!("static spring force {degrees} deg");
        sheet.manual(&name, *push, "N", *printed, Rounded(0.01));
        worst = worst.or_worse(*balance);
    }
    if let Some(Failure::Fault(fault)) = runs.failed().find_map(|run| run.result.as_ref().err()) {
        return Err(*fault);
    }
    sheet.balance(worst);
    Ok(sheet)
}

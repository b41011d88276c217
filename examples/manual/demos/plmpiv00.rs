//! PLMPIV00, section 4.2.2.2.2: a single pendulum on a damped pivot.
//!
//! ```text
//!    o_________ G      0.5 m, released horizontal
//!   ///
//! ```
//!
//! Reading: the table gives a damper and a port; mass and inertia are the defaults of Table 15, 1 kg and 0.01 kg m2.
//! The manual prints no number here.

use plm::{Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Sheet;

plm::mechanism! {
    /// The manual's pendulum on the pivot PLMPIV00.
    pub Plmpiv00 {
        gravity: 9.81 m/s^2;
        let damping = 0.1 N*m/(rev/min);
        ground { port o: (0, 0) m; }
        body bar { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (-0.5, 0) m; }
        revolute pivot(ground.o, bar.o) { damping: damping; }
        output pivot.force;
        output lost = damping*pivot.speed^2;
    }
}

/// 10 s of falling and settling.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMPIV00");
    let mut sim = Plmpiv00::new().start_with(Dop853::new(RTOL))?;
    // At release omega' = m g l/(J + m l^2), and the pivot carries what the fall does not: m g - m l omega'.
    let released = 9.81 * (1.0 - 0.25 / 0.26);
    sheet.theory("pivot |Fy| at release", sim.pivot_force()[1].abs(), "N", released, 1e-9);
    let balance = balance::run(&mut sim, (10_000, 1e-3), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        lost: s.lost(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    sheet.theory("bar angle at 10 s", sim.bar().angle.to_degrees(), "deg", -90.0, 1e-4);
    sheet.theory("pivot |Fy| at 10 s", sim.pivot_force()[1].abs(), "N", 9.81, 1e-6);
    sheet.balance(balance);
    Ok(sheet)
}

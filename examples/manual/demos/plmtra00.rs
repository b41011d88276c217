//! PLMTRA00, section 4.2.3.2: where the axis of a prismatic joint lies, in four cases.
//!
//! ```text
//!           o-----G     the port is at -0.5 m; its axis has ALPHA2 in the body
//!          /
//!     ----o----> axis   the guide has ALPHA1 in absolute axes
//!        ///
//! ```
//!
//! Reading: the body's angle is ALPHA1 - ALPHA2 (equation 3). Nothing is singular where the points meet (the manual's
//! warning in 4.2.3.1 does not apply), and the displacement along the axis is signed: it is negative in these cases.
//! There is no gravity, so that nothing moves; for the balance the body of example 4 is pushed with 1 m/s in x, of which
//! the guide leaves the part along it. The manual shows pictures and prints no number.

use plm::{Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Sheet;

plm::mechanism! {
    /// The manual's body on the guide PLMTRA00.
    pub Plmtra00 {
        /// Angle of the guide in absolute axes, the manual's ALPHA1.
        param alpha1: deg = 0 deg;
        /// Angle of the axis in the body, the manual's ALPHA2.
        param alpha2: deg = 0 deg;
        ground { port o: (0, 0) m, axis: alpha1; }
        body block { mass: 1 kg; inertia: 0.01 kg*m^2; port p: (-0.5, 0) m, angle: alpha2; }
        prismatic guide(ground.o, block.p);
        output guide.displacement, guide.speed;
        output off_axis = cross(block.p.position, ground.o.axis);
    }
}

/// The four cases of Table 11.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMTRA00");
    for (case, alpha1, alpha2) in [(1, 0.0, 0.0), (2, 0.0, -45.0), (3, 20.0, 0.0), (4, -20.0, -45.0_f64)] {
        let [first, second] = [alpha1, alpha2].map(f64::to_radians);
        let sim =
            Plmtra00 { alpha1: first, alpha2: second, ..Plmtra00::new() }.start_with(Dop853::new(RTOL))?;
        let name = |what: &str| format!("example {case}: {what}");
        sheet.theory(&name("body angle"), sim.block().angle.to_degrees(), "deg", alpha1 - alpha2, 1e-9);
        sheet.theory(&name("port off the axis"), sim.off_axis(), "m", 0.0, 1e-10);
        // Assembly moves the free G normal to the guide alone, so that it stays level with the ground's point.
        sheet.theory(&name("displacement"), sim.guide_displacement(), "m", -0.5 * second.cos(), 1e-10);
    }
    let (along, pushed) = (-20_f64.to_radians(), 1.0);
    let mut block = Plmtra00 { alpha1: along, alpha2: -45_f64.to_radians(), ..Plmtra00::new() };
    block.start.block.vx.value = pushed;
    let mut sim = block.start_with(Dop853::new(RTOL))?;
    let balance = balance::run(&mut sim, (100, 1e-2), |s| Ledger {
        kinetic: s.kinetic_energy(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    sheet.theory("pushed: speed along the guide", sim.guide_speed(), "m/s", pushed * along.cos(), 1e-10);
    sheet.balance(balance);
    Ok(sheet)
}

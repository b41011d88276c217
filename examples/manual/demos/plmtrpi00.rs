//! PLMTRPI00, section 4.2.4.3: a bar hangs on a pin in a slot; a torque turns it.
//!
//! ```text
//!      o0 -----O=======  slot along x; the pin starts at x = 40 mm
//!     ///     /
//!            / G         bar of 50 mm, 10 kg, at -110 deg
//!           A            torque 100 N m sin(2 pi 1 Hz t)
//! ```
//!
//! Readings: equation (5) is printed as a dot product, which would block the slot; its expansion, the cross product, is
//! right. The damper of the pivot is printed in N/(m/s); 5 N m/(rev/min) is read. Figure 65 says constant torque, but the
//! source is SIN0 with 100 and its default of 1 Hz. The body called PLMBOD01 needs two ports. The manual prints no number.

use plm::{Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Sheet;

plm::mechanism! {
    /// The manual's bar on the slotted link PLMTRPI00.
    pub Plmtrpi00 {
        gravity: 9.81 m/s^2;
        let slide_damping = 5 N/(m/s);
        let turn_damping = 5 N*m/(rev/min);
        let twist = 100 N*m*sin(2*pi*1 Hz*t);

        ground { port o0: (0, 0) m; }
        body bar {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            centre: (0.025, 0) m;
            port pin: (0, 0) m;
            port a: (0.05, 0) m;
            start x: 0.04 m;
            start angle: -110 deg;
        }
        pin_slot slot(ground.o0, bar.pin) { damping: slide_damping; rotary_damping: turn_damping; }
        force motor(bar.a) { torque: twist; }

        output bar.angle in deg, slot.displacement, bar.a.position;
        output off_axis = bar.pin.y;
        output supplied = twist*bar.omega;
        output lost = slide_damping*slot.speed^2 + turn_damping*bar.omega^2;
    }
}

/// One period of the torque.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMTRPI00");
    let mut sim = Plmtrpi00::new().start_with(Dop853::new(RTOL))?;
    let (mut low, mut high, mut off) = (f64::MAX, f64::MIN, 0.0_f64);
    let mut probe = sim;
    probe.run(1.0, 1e-3, |s| {
        let angle = s.bar_angle().to_degrees();
        (low, high, off) = (low.min(angle), high.max(angle), off.max(s.off_axis().abs()));
    })?;
    sheet.model("lowest bar angle", low, "deg", -110.0, 0.05);
    sheet.model("highest bar angle", high, "deg", -71.8, 0.05);
    sheet.theory("pin off the slot", off, "m", 0.0, 1e-10);
    let balance = balance::run(&mut sim, (2000, 1e-3), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        supplied: s.supplied(),
        lost: s.lost(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    sheet.balance(balance);
    Ok(sheet)
}

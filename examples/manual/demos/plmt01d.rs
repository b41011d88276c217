//! PLMT01D, section 4.6.1: a body on a spring of the 1-D library.
//!
//! ```text
//!      o  port 1, free (PLMZER00)
//!     [G] 10 kg
//!      o  port 2, 0.1 m below G: PLMT01D, of which the y port holds the spring
//!      Z  SD0000, 100 000 N/m
//!     ///
//! ```
//!
//! Readings: "O: initial absolute y position = -0.1 m" is that of the origin O in port 2; the captions PLMTJ00 and PLMTO1D are
//! PLMT01D. Gravity is not in the list: 9.81 m/s2 along -y is assumed. SD0000 starts with a force of 0 N, so that the body
//! falls, and swings with a damping ratio of 0.1. The manual prints no number.

use plm::{Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Sheet;

plm::mechanism! {
    /// The mass of the manual on its spring, section 4.6.1.
    pub Plmt01d {
        gravity: 9.81 m/s^2;
        body block {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port top: (0, 0.1) m;
            port foot: (0, -0.1) m;
        }
        frame_axes axes(block.foot);
        slider_ground floor();
        force_state_spring sd0000(floor.slider, axes.y) {
            stiffness: 100000 N/m;
            damping: 2*0.1*sqrt(10 kg*100000 N/m);
        }
        let energy = sd0000.spring_force^2/(2*100000 N/m);
        output sd0000.force, sd0000.lost, spring_energy = energy, absorbed = rate(energy);
    }
}

/// How far the body has fallen after a time, m: a damped oscillation about the equilibrium, from rest above it.
fn fall(time: f64) -> f64 {
    let (mass, stiffness, ratio) = (10.0, 1e5, 0.1);
    let omega = f64::sqrt(stiffness / mass);
    let (decay, swing) = (ratio * omega, omega * f64::sqrt(1.0 - ratio * ratio));
    let (sin, cos) = (swing * time).sin_cos();
    mass * 9.81 / stiffness * (1.0 - f64::exp(-decay * time) * (cos + decay / swing * sin))
}

/// The fall onto the spring, and the rest.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMT01D");
    let mut sim = Plmt01d::new().start_with(Dop853::new(RTOL))?;
    let height = sim.block().y;
    let balance = balance::run(&mut sim, (2000, 1e-4), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        springs: s.spring_energy(),
        absorbed: s.absorbed(),
        lost: s.sd0000_lost(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    sheet.theory("fall after 0.2 s", height - sim.block().y, "m", fall(0.2), 1e-11);
    sim.step(5.0)?;
    sheet.theory("force of the spring at rest", sim.sd0000_force(), "N", 98.1, 1e-6);
    sheet.theory("fall at rest", height - sim.block().y, "m", 98.1 / 1e5, 1e-10);
    sheet.balance(balance);
    Ok(sheet)
}

//! PLMT01D01, section 4.6.2: a 1-D mass that carries a prismatic joint with a body.
//!
//! ```text
//!     V001 ---Z--- [ MAS002, 100 kg ]==o  transfer point, x = 0.1 m
//!             1e8 N/m                   \____ PLMTRA00: 100 000 N/m, free at 0.4 m ____ o--[G]------o <- -1000 N
//! ```
//!
//! Readings: Table 21 is shifted by a line: contact stiffness and damping belong to the spring between V001 and the mass. The
//! body's mass is not stated (1 kg by default), nor which input of PLMFOR00 gets -1000 (the force along x). The body starts
//! with G at 0.5 m, so that the prismatic joint starts at 0.3 m although it is free at 0.4 m: 10 kN, a transient. Gravity acts
//! across the lines and moves nothing. The manual prints no number.

use plm::{Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Sheet;

plm::mechanism! {
    /// The mass and the body of the manual, section 4.6.2.
    pub Plmt01d01 {
        gravity: 9.81 m/s^2;
        let contact = 1e8 N/m;
        let stiffness = 100000 N/m;
        slider_velocity v001() { velocity: 0 m/s; }
        sliding_mass mas002() { mass: 100 kg; x: 0.1 m; }
        slider_spring spring(v001.slider, mas002.slider) {
            stiffness: contact;
            damping: 2*0.2*sqrt(1e8 N/m*100 kg);
        }
        body rod {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port rail: (-0.1, 0) m;
            port end: (0.2, 0) m;
            start x: 0.5 m, locked;
        }
        prismatic guide(mas002.frame, rod.rail) {
            stiffness: stiffness;
            free_length: 0.4 m;
            damping: 100 N/(m/s);
        }
        force plmfor00(rod.end) { x: -1000 N; }
        let energy = spring.energy + stiffness*(guide.displacement - 0.4 m)^2/2;
        output spring_energy = energy, absorbed = rate(energy);
        output lost = spring.lost + 100 N/(m/s)*guide.speed^2;
        output pushed = -1000 N*rod.vx;
        output guide.displacement, guide.drive_force, mas002.position, spring.force;
    }
}

/// The transient, and the rest.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMT01D01");
    let mut sim = Plmt01d01::new().start_with(Dop853::new(RTOL))?;
    sheet.theory("prismatic displacement at the start", sim.guide_displacement(), "m", 0.3, 1e-12);
    sheet.theory("force of its spring at the start", sim.guide_drive_force(), "N", 1e4, 1e-6);
    let balance = balance::run(&mut sim, (8000, 2.5e-5), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        springs: s.spring_energy(),
        absorbed: s.absorbed(),
        supplied: s.pushed(),
        lost: s.lost(),
        loads: s.load_power(),
    })?;
    sim.step(1.0)?;
    sheet.theory("prismatic displacement at rest", sim.guide_displacement(), "m", 0.4 - 1000.0 / 1e5, 1e-9);
    sheet.theory("displacement of the mass at rest", sim.mas002_position(), "m", -1000.0 / 1e8, 1e-10);
    sheet.balance(balance);
    Ok(sheet)
}

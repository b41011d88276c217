//! PLMPIV10, section 4.2.2.3: an eccentric wheel on a driven pivot.
//!
//! ```text
//!       _____
//!     /   .G  \     10 kg, R = 50 mm; G is 1 mm from the axis o
//!    |    o    |    1000 N m drive it, 1 N m/(rev/min) brakes it
//!     \_______/
//!       /////
//! ```
//!
//! Reading: Table 9 gives no mass; 10 kg is that of figure 41 (with the default of 1 kg the centrifugal force would be
//! 10.97 N). The manual calls its run stabilised, but steady rotation is no equilibrium: this is a run from rest, which
//! settles in 10 ms.

use std::f64::consts::TAU;

use plm::{Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Reading::{Approximate, Rounded};
use super::sheet::Sheet;

plm::mechanism! {
    /// The manual's eccentric wheel on the driven pivot PLMPIV10.
    pub Plmpiv10 {
        gravity: 9.81 m/s^2;
        let wheel_mass = 10 kg;
        let radius = 50 mm;
        let damping = 1 N*m/(rev/min);
        let motor = 1000 N*m;

        ground { port o: (0, 0) m; }
        body wheel {
            mass: wheel_mass;
            inertia: disc(wheel_mass, radius);
            port o: (0.001, 0) m;
            contour: "examples/manual/contours/wheel.csv";
        }
        revolute pivot(ground.o, wheel.o) { drive: motor; damping: damping; }

        output inertia = disc(wheel_mass, radius);
        output pivot.force;
        output supplied = motor*pivot.speed;
        output lost = damping*pivot.speed^2;
    }
}

/// 0.1 s to settle, then fifteen turns.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMPIV10");
    let mut sim = Plmpiv10::new().start_with(Dop853::new(RTOL))?;
    sheet.manual("moment of inertia", sim.inertia(), "kg m2", 0.0125, Rounded(1e-12));
    let balance = balance::run(&mut sim, (4000, 2.5e-5), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        supplied: s.supplied(),
        lost: s.lost(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    let (from, turns) = (sim.wheel().angle, 15.0);
    let (mut across, mut down) = (0.0_f64, 0.0_f64);
    sim.run(0.1 + 0.06 * turns, 1e-4, |s| {
        let [x, y] = s.pivot_force().map(f64::abs);
        (across, down) = (across.max(x), down.max(y));
    })?;
    let mean = (sim.wheel().angle - from) / TAU / (0.06 * turns) * 60.0;
    sheet.manual("mean speed", mean, "rev/min", 1000.0, Approximate(0.5));
    // The speed ripples by m g e/c = 1e-4 of itself.
    let centrifugal = 10.0 * 0.001 * (1000.0 * TAU / 60.0_f64).powi(2);
    sheet.theory("largest |Fx|, m e omega^2", across, "N", centrifugal, 0.05);
    sheet.theory("largest |Fy|, m g + m e omega^2", down, "N", 98.1 + centrifugal, 0.05);
    sheet.balance(balance);
    Ok(sheet)
}

//! PLMEMB01, section 4.5.3: the arm of PLMJ00 with the jack on a second ground.
//!
//! ```text
//!      o___________o______________G     100 kg, body angle 0
//!     /// 0.3 m   /     0.5 m
//!               / jack
//!   o__________/     at (-0.05, -0.25) m
//!  ///
//! ```
//!
//! Reading: the text puts the second ground at x = +0.05 m, Table 19 at -0.05 m; the table is used, and the other value is
//! shown beside it. The manual prints no number; the moments about the pivot give the force that balances the arm.

use plm::{Dop853, Fault, Stabilise};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Sheet;

plm::mechanism! {
    /// The manual's arm with the jack's foot on a ground PLMEMB01 of its own.
    pub Plmemb01 {
        gravity: 9.81 m/s^2;
        /// Where the jack stands.
        param foot: m = -0.05 m;
        let stiffness = 100000 N/m;
        let rating = 4000 N/(m/s);

        ground { port o0: (0, 0) m; port p01: (foot, -0.25 m); }
        body arm {
            mass: 100 kg;
            inertia: 0.01 kg*m^2;
            port tip: (0.2, 0) m;
            port jack: (-0.5, 0) m;
            port pivot: (-0.8, 0) m;
            start angle: 0 deg, locked;
        }
        revolute pivot(ground.o0, arm.pivot);
        jack cylinder(ground.p01, arm.jack) {
            free_length: 0.2 m;
            piston_diameter: 0.05 m;
            rod_diameter: 0.07 m;
            drive: push - rating*cylinder.speed;
        }
        state push: N = 0;
        rate push = -stiffness*cylinder.speed;

        output arm.alpha;
        let energy = push^2/(2*stiffness);
        output spring_energy = energy, absorbed = rate(energy);
        output lost = rating*cylinder.speed^2;
    }
}

/// M g 0.8 m over the lever of the jack about the pivot, N.
fn by_moments(foot: f64) -> f64 {
    let lever = 0.3 * 0.25 / f64::hypot(0.3 - foot, 0.25);
    100.0 * 9.81 * 0.8 / lever
}

/// The static forces of both readings, and a run without one.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMEMB01");
    for (foot, name) in [(-0.05, "static force, x = -0.05 m"), (0.05, "static force, x = +0.05 m")] {
        let held = Plmemb01 { foot, ..Plmemb01::new() }.stabilise()?.mechanism;
        sheet.theory(name, held.start.push.value, "N", by_moments(foot), 1e-6);
    }
    let mut sim = Plmemb01::new().start_with(Dop853::new(RTOL))?;
    let balance = balance::run(&mut sim, (8000, 2.5e-4), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        springs: s.spring_energy(),
        absorbed: s.absorbed(),
        lost: s.lost(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    sheet.balance(balance);
    Ok(sheet)
}

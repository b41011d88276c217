//! DoublePendulum, section 2.2.
//!
//! ```text
//!            p12 ________________ forearm: G in the middle, 10 kg, 0 deg
//!              /        G2
//!             / G1  arm: 1 m, 10 kg, 45 deg
//!        o0 _/_
//!          ////
//! ```
//!
//! Reading: assembly is the plain generalised Newton iteration from G = (0, 0), angles in radians, unit weights
//! (the manual's 68.1934 and -25.7586 deg need all of it). "~200 N" and "~100 N" are read off curves that still swing.

use plm::{Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Reading::{Approximate, Rounded};
use super::sheet::Sheet;

plm::mechanism! {
    /// The double pendulum of the manual, section 2.2.
    pub DoublePendulum {
        gravity: 9.81 m/s^2;
        let damping = 1 N*m/(rev/min);

        ground { port o0: (0, 0) m; }
        body arm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port o0: (-0.5, 0) m;
            port p12: (0.5, 0) m;
            start angle: 45 deg, locked;
        }
        body forearm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port p12: (-1, 0) m;
            start angle: 0 deg, locked;
        }
        revolute shoulder(ground.o0, arm.o0) { damping: damping; }
        revolute elbow(arm.p12, forearm.p12) { damping: damping; }

        output shoulder.force, elbow.force;
        output lost = damping*(shoulder.speed^2 + elbow.speed^2);
    }
}

/// Steps 5, 6 and 7 of the manual.
#[allow(clippy::approx_constant, reason = "the manual prints 1/sqrt(2) to eight digits")]
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("DoublePendulum");
    let mut free = DoublePendulum::new();
    free.start.arm.angle.locked = false;
    free.start.forearm.angle.locked = false;
    let [_, _, th1, _, _, th2] = free.assemble()?.q.map(f64::to_degrees);
    sheet.manual("unlocked th1", th1, "deg", 68.1934, Rounded(1e-4));
    sheet.manual("unlocked th2", th2, "deg", -25.7586, Rounded(1e-4));

    let [x1, y1, th1, x2, y2, th2] = DoublePendulum::new().assemble()?.q;
    for (name, value, printed) in [
        ("locked xG1", x1, 0.353_553_39),
        ("locked yG1", y1, 0.353_553_39),
        ("locked xG2", x2, 1.707_106_78),
        ("locked yG2", y2, 0.707_106_78),
    ] {
        sheet.manual(name, value, "m", printed, Rounded(1e-8));
    }
    sheet.manual("locked th1", th1.to_degrees(), "deg", 45.0, Rounded(1e-9));
    sheet.manual("locked th2", th2.to_degrees(), "deg", 0.0, Rounded(1e-9));

    let mut sim = DoublePendulum::new().start_with(Dop853::new(RTOL))?;
    let balance = balance::run(&mut sim, (40_000, 1e-3), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        lost: s.lost(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    let [shoulder, elbow] = [sim.shoulder_force(), sim.elbow_force()].map(|force| force[1].abs());
    sheet.manual("force pivot3 |Fy| at 40 s", shoulder, "N", 200.0, Approximate(5.0));
    sheet.manual("force pivot5 |Fy| at 40 s", elbow, "N", 100.0, Approximate(3.0));
    sheet.balance(balance);
    Ok(sheet)
}

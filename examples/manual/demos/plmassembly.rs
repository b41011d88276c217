//! PLMASSEMBLY, section 4.4: a pendulum with three locks, which cannot be assembled.
//!
//! ```text
//!        . G    x, y and angle are locked
//!      /
//!    o
//!   ///         the pivot leaves one degree of freedom
//! ```
//!
//! Reading: the message "There are 2 redundant constants" (sic) counts by rank: two rows of the pivot and three locks are
//! five rows of rank 3. Where everything is a literal, rustc says so at the declaration (tests/ui/assembly/too_many_locks.rs);
//! here the length is a parameter: rustc warns of its default, and the run judges.

use plm::{Cause, Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Reading::Rounded;
use super::sheet::Sheet;

plm::mechanism! {
    /// The manual's over-constrained pendulum, figure 94.
    pub Plmassembly {
        gravity: 9.81 m/s^2;
        /// From the pivot to G.
        param reach: m = 0.5 m;
        ground { port o0: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port pivot: (-reach, 0);
            start x: 0.35 m, locked;
            start y: 0.35 m, locked;
            start angle: 45 deg, locked;
        }
        revolute pivot(ground.o0, bob.pivot);
        // What the manual shows is what is told.
        allow(W0012);
    }
}

/// The error, and the same pendulum with one lock.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMASSEMBLY");
    let mut pendulum = Plmassembly::new();
    let redundant = match pendulum.assemble() {
        Err(Fault { cause: Cause::Redundant { count, .. }, .. }) => count,
        Err(fault) => return Err(fault),
        Ok(_) => 0,
    };
    sheet.manual("redundant constraints", redundant as f64, "-", 2.0, Rounded(0.0));
    pendulum.start.bob.x.locked = false;
    pendulum.start.bob.y.locked = false;
    let found = pendulum.assemble()?;
    sheet.theory("one lock: rank of joints and locks", found.rank as f64, "-", 3.0, 0.0);
    sheet.theory("one lock: x of G", found.q[0], "m", 0.5 * 45_f64.to_radians().cos(), 1e-10);
    let mut sim = pendulum.start_with(Dop853::new(RTOL))?;
    let balance = balance::run(&mut sim, (2000, 1e-3), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    sheet.balance(balance);
    Ok(sheet)
}

//! PLMJ00, section 4.2.5.3: an arm that a spring in a jack holds up.
//!
//! ```text
//!    o___________o______________G____ tip     100 kg; pivot to jack 0.3 m, jack to G 0.5 m, G to tip 0.2 m
//!   /// 0.3 m   /     0.5 m       0.2 m
//!              /  jack
//!   o________ /   0.25 m below the pivot
//!  ///
//! ```
//!
//! Readings: 4086.32 N belongs to the body angle 0, although figure 71 shows 20 deg. The jack holds no constraint, although
//! 4.2.1 calls it two pivots and a prismatic joint; its force is positive when it pushes. Gravity is 9.81 m/s2.
//!
//! The spring is SD0000: its force is a state. The stabilising run with the angle locked gives the force that balances the
//! arm; with it the run stays where it is.

use plm::{Dop853, Fault, Stabilise};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Reading::Rounded;
use super::sheet::Sheet;

plm::mechanism! {
    /// The manual's arm on the jack PLMJ00.
    pub Plmj00 {
        gravity: 9.81 m/s^2;
        let stiffness = 100000 N/m;
        let rating = 4000 N/(m/s);

        ground { port o0: (0, 0) m; port p01: (0, -0.25) m; }
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

        output arm.alpha, cylinder.displacement;
        let energy = push^2/(2*stiffness);
        output spring_energy = energy, absorbed = rate(energy);
        output lost = rating*cylinder.speed^2;
    }
}

/// The static force, a run with it, and a run without.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMJ00");
    let held = Plmj00::new().stabilise()?.mechanism;
    sheet.manual("static force", held.start.push.value, "N", 4086.32, Rounded(0.005));
    let mut sim = held.start_with(Dop853::new(RTOL))?;
    sim.step(1.0)?;
    sheet.theory("body angle after 1 s", sim.arm().angle.to_degrees(), "deg", 0.0, 1e-9);
    let mut sim = Plmj00::new().start_with(Dop853::new(RTOL))?;
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

//! PrismaticJoint, section 3.1: a mass on a spring, three times. In System 1 spring and damper stand in the joint; in the
//! others they are parts of the 1-D library between its ends: SD0000 with a force state, SD000A without.
//!
//! ```text
//!        | M = 20 kg, starts at y = 1 m
//!      [ G ]
//!        |  0.5 m
//!        o  port
//!        Z  10000 N/m, free at 0.5 m; damper
//!   _____o0_____  axis of the guide at 90 deg
//!    ///////
//! ```
//!
//! Reading: the manual's R = 2*0.7*sqrt(1000*20) holds 1000 where K = 10000 N/m; the printed 197.98 is used, so that the
//! damping ratio is 0.221 rather than 0.7. The body's own angle follows the guide to 90 deg. After the manual's 1 s the
//! mass still swings by 0.1 mm, hence a second run to its rest. SD0000 starts at 0 N ("ON"), SD000A exerts 5000 N where both
//! displacements are zero. In the stabilising run of step 6 only System 2 keeps its height: its force is a state, and finds what
//! the height needs. Of the others the run says what the lock bears.

use plm::{Dop853, Fault, Stabilise};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Reading::{Rounded, Truncated};
use super::sheet::Sheet;

plm::mechanism! {
    /// System 1 of the manual, section 3.1: mass, spring and damper on a vertical guide.
    pub System1 {
        gravity: 9.81 m/s^2;
        let stiffness = 10000 N/m;
        let damping = 197.98 N/(m/s);
        let free_length = 0.5 m;

        ground { port o0: (0, 0) m, axis: 90 deg; }
        body block {
            mass: 20 kg;
            inertia: 0.01 kg*m^2;
            port foot: (-0.5, 0) m;
            start y: 1 m, locked;
        }
        prismatic guide(ground.o0, block.foot) {
            stiffness: stiffness;
            damping: damping;
            free_length: free_length;
        }

        output block.y, rating = 2*0.7*sqrt(1000 N/m*20 kg);
        let energy = stiffness*(guide.displacement - free_length)^2/2;
        output spring_energy = energy, absorbed = rate(energy);
        output lost = damping*guide.speed^2;
    }
}

plm::mechanism! {
    /// Systems 2 and 3 of the manual, section 3.1: the spring outside of the joint, side by side.
    pub Systems23 {
        gravity: 9.81 m/s^2;
        ground { port left: (0, 0) m, axis: 90 deg; port right: (1, 0) m, axis: 90 deg; }
        body second {
            mass: 20 kg;
            inertia: 0.01 kg*m^2;
            port foot: (-0.5, 0) m;
            start y: 1 m, locked;
        }
        body third {
            mass: 20 kg;
            inertia: 0.01 kg*m^2;
            port foot: (-0.5, 0) m;
            start x: 1 m;
            start y: 1 m, locked;
        }
        prismatic guide2(ground.left, second.foot);
        prismatic guide3(ground.right, third.foot);
        slider_ground floor();
        force_state_spring sd0000(floor.slider, guide2.slider) {
            stiffness: 10000 N/m;
            damping: 197.98 N/(m/s);
        }
        slider_spring sd000a(floor.slider, guide3.slider) {
            stiffness: 10000 N/m;
            damping: 197.98 N/(m/s);
            preload: 5000 N;
        }
        output second.y, third.y, sd0000.force, sd000a.force;
    }
}

/// Height after a time, m: a damped oscillation about the equilibrium, from rest above it.
fn height(time: f64) -> f64 {
    let (mass, stiffness, damping) = (20.0, 10_000.0, 197.98);
    let drop = mass * 9.81 / stiffness;
    let decay = 0.5 * damping / mass;
    let omega = f64::sqrt(stiffness / mass - decay * decay);
    let (sin, cos) = (omega * time).sin_cos();
    1.0 - drop + drop * f64::exp(-decay * time) * (cos + decay / omega * sin)
}

/// The dynamic run of 1 s, and on to the equilibrium.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PrismaticJoint");
    let mut sim = System1::new().start_with(Dop853::new(RTOL))?;
    let start = sim.block().y;
    sheet.manual("R = 2*0.7*sqrt(1000*20)", sim.rating(), "N/(m/s)", 197.98, Truncated(0.011));
    let balance = balance::run(&mut sim, (4000, 2.5e-4), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        springs: s.spring_energy(),
        absorbed: s.absorbed(),
        lost: s.lost(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    sheet.theory("System 1: y after 1 s", sim.block().y, "m", height(1.0), 1e-9);
    let mut others = Systems23::new().start_with(Dop853::new(RTOL))?;
    others.step(1.0)?;
    sheet.theory("System 2: y after 1 s", others.second().y, "m", height(1.0), 1e-9);
    sheet.theory("System 3: y after 1 s", others.third().y, "m", height(1.0), 1e-9);
    sim.step(5.0)?;
    let end = sim.block().y;
    sheet.manual("dy = 20*9.81/10000", start - end, "m", 0.01962, Rounded(1e-9));
    sheet.manual("y equilibrium", end, "m", 0.98038, Rounded(1e-7));
    stabilising(&mut sheet)?;
    sheet.balance(balance);
    Ok(sheet)
}

/// Step 6: with the heights locked, and with none locked.
fn stabilising(sheet: &mut Sheet) -> Result<(), Fault> {
    let weight = 20.0 * 9.81;
    let held = Systems23::new().stabilise()?;
    let needed =
        |name: &str| held.residuals.iter().find(|left| left.name == name).map_or(0.0, |left| left.value);
    sheet.theory("System 2, locked: its lock bears", needed("second.y"), "N", 0.0, 1e-9);
    sheet.theory("System 3, locked: its lock bears", needed("third.y"), "N", weight, 1e-9);
    let sim = held.start()?;
    sheet.theory("System 2, locked: y", sim.second().y, "m", 1.0, 1e-12);
    sheet.theory("System 2, locked: force of the spring", sim.sd0000_force(), "N", weight, 1e-9);
    let mut free = Systems23::new();
    (free.start.second.y.locked, free.start.third.y.locked) = (false, false);
    let sim = free.stabilise()?.start()?;
    sheet.theory("System 2, free: y", sim.second().y, "m", 0.98038, 1e-12);
    sheet.theory("System 3, free: y", sim.third().y, "m", 0.98038, 1e-12);
    Ok(())
}

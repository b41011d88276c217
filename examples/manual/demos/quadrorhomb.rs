//! Quadrorhomb, section 4.3.4: 13 bodies, 19 pivots, one degree of freedom.
//!
//! ```text
//!             A       A2      A3      A4
//!           . / \    /  \    /  \    /  \
//!    O .    /    \  /    \  /    \  /    \
//!    o   Q--C     D       E       F       G     Q-C is the crank, the "horizontal bar"
//!   ///  o \     / \     / \     / \     /
//!      .    \   /   \   /   \   /   \   /
//!           ' B       B2      B3      B4
//! ```
//!
//! Reading: the manual prints no geometry. This one is chosen so that it has its counts and exact checks: a crank, a
//! Peaucellier cell (O, A, C, B, D) and three scissor dyads. D runs on the line x = (0.5^2 - 0.25^2)/0.3 = 0.625 m, and G is
//! C + 4 (D - C). At the start every other bar turns half as fast as the crank. Without gravity the energy is constant.
//! The starts are angles alone, 5 deg off: assembly finds the rest. The manual prints F = 1, by counting.

use plm::{BodyState, Cause, Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Sheet;

plm::mechanism! {
    /// The manual's Quadrorhomb with a geometry of our own.
    pub Quadrorhomb {
        let m1 = 1 kg;
        let long = rod(m1, 0.5 m);
        let short = rod(m1, 0.25 m);
        ground { port q: (0.15, 0) m; port o: (0, 0) m; }
        body crank {
            mass: m1;
            inertia: rod(m1, 0.15 m);
            port q: (-0.075, 0) m;
            port c: (0.075, 0) m;
            start angle: 0, locked;
            start omega: 1 rad/s, locked;
        }
        body oa { mass: m1; inertia: long; port p: (-0.25, 0) m; port e: (0.25, 0) m; start angle: 27 deg; }
        body ob { mass: m1; inertia: long; port p: (-0.25, 0) m; port e: (0.25, 0) m; start angle: -27 deg; }
        body ac { mass: m1; inertia: short; port p: (-0.125, 0) m; port e: (0.125, 0) m; start angle: 54 deg; }
        body bc { mass: m1; inertia: short; port p: (-0.125, 0) m; port e: (0.125, 0) m; start angle: -54 deg; }
        body a1 {
            mass: m1; inertia: long; start angle: -54 deg;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
        }
        body b1 {
            mass: m1; inertia: long; start angle: 54 deg;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
        }
        body a2 {
            mass: m1; inertia: long; start angle: -54 deg;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
        }
        body b2 {
            mass: m1; inertia: long; start angle: 54 deg;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
        }
        body a3 {
            mass: m1; inertia: long; start angle: -54 deg;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
        }
        body b3 {
            mass: m1; inertia: long; start angle: 54 deg;
            port p: (-0.25, 0) m; port m: (0, 0) m; port e: (0.25, 0) m;
        }
        body a4 { mass: m1; inertia: short; port p: (-0.125, 0) m; port e: (0.125, 0) m; start angle: -54 deg; }
        body b4 { mass: m1; inertia: short; port p: (-0.125, 0) m; port e: (0.125, 0) m; start angle: 54 deg; }
        revolute q(ground.q, crank.q);
        revolute o_oa(ground.o, oa.p);
        revolute o_ob(ground.o, ob.p);
        revolute c_ac(crank.c, ac.p);
        revolute c_bc(crank.c, bc.p);
        revolute oa_ac(oa.e, ac.e);
        revolute oa_a1(oa.e, a1.p);
        revolute ob_bc(ob.e, bc.e);
        revolute ob_b1(ob.e, b1.p);
        revolute a1_b1(a1.m, b1.m);
        revolute b1_a2(b1.e, a2.p);
        revolute a1_b2(a1.e, b2.p);
        revolute a2_b2(a2.m, b2.m);
        revolute b2_a3(b2.e, a3.p);
        revolute a2_b3(a2.e, b3.p);
        revolute a3_b3(a3.m, b3.m);
        revolute b3_a4(b3.e, a4.p);
        revolute a3_b4(a3.e, b4.p);
        revolute a4_b4(a4.e, b4.e);

        let c = crank.c.position;
        let d = a1.m.position;
        output line = d.x;
        output tip_off = norm(b4.e.position - c - 4*(d - c));
    }
}

/// The bars that are not the crank.
fn others(s: &quadrorhomb::State) -> [BodyState<f64>; 12] {
    [s.oa(), s.ob(), s.ac(), s.bc(), s.a1(), s.b1(), s.a2(), s.b2(), s.a3(), s.b3(), s.a4(), s.b4()]
}

/// Counts, and runs of the crank to either side.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("Quadrorhomb");
    let mut free = Quadrorhomb::new();
    free.start.crank.angle.locked = false;
    let found = free.assemble()?;
    sheet.theory("F = 3*13 - 2*19", f64::from(found.freedom), "-", 1.0, 0.0);
    sheet.theory("rank of the 38 rows", found.rank as f64, "-", 38.0, 0.0);
    let mut twice = Quadrorhomb::new();
    twice.start.oa.angle.locked = true;
    let redundant = match twice.assemble() {
        Err(Fault { cause: Cause::Redundant { count, .. }, .. }) => count,
        Err(fault) => return Err(fault),
        Ok(_) => 0,
    };
    sheet.theory("redundant rows with two angles locked", redundant as f64, "-", 1.0, 0.0);

    let mut sim = Quadrorhomb::new().start_with(Dop853::new(RTOL))?;
    let slowest = others(&sim).iter().map(|bar| bar.omega).fold(f64::MAX, f64::min);
    let fastest = others(&sim).iter().map(|bar| bar.omega).fold(f64::MIN, f64::max);
    sheet.theory("slowest of the other bars", slowest, "rad/s", 0.5 * sim.crank().omega, 1e-9);
    sheet.theory("fastest of the other bars", fastest, "rad/s", 0.5 * sim.crank().omega, 1e-9);
    let (mut line, mut tip) = (0.0_f64, 0.0_f64);
    for omega in [-1.0, 1.0] {
        let mut either_way = Quadrorhomb::new();
        either_way.start.crank.omega.value = omega;
        either_way.start_with(Dop853::new(RTOL))?.run(1.4, 1e-3, |s| {
            line = line.max((s.line() - 0.625).abs());
            tip = tip.max(s.tip_off());
        })?;
    }
    let balance = balance::run(&mut sim, (1400, 1e-3), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    let turned = sim.crank().angle.to_degrees();
    sheet.theory(&format!("D off x = 0.625 m, crank -{turned:.0} to {turned:.0} deg"), line, "m", 0.0, 1e-12);
    sheet.theory("tip off C + 4 (D - C)", tip, "m", 0.0, 1e-12);
    sheet.balance(balance);
    Ok(sheet)
}

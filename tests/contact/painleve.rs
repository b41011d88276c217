//! A rod that slides to where contact has no unique acceleration.

use plm::runtime::Cause;
use plm::{Dop853, Mechanism as _};

use crate::near;
use crate::scene::{Given as _, Named as _};

scene! {
    /// A slender rod whose lower tip slides on a rough floor.
    pub Rod {
        gravity: 9.81 m/s^2;
        param mu = 2;
        body rod {
            mass: 1 kg;
            inertia: 1/12*(1 kg*m^2);
            port tip: (-0.5, 0) m;
            start x: 0.5*cos(20 deg)*(1 m);
            start y: 0.5*sin(20 deg)*(1 m);
            start angle: 20 deg;
            start vx: -30 m/s - sin(20 deg)*(1 m/s);
            start vy: cos(20 deg)*(1 m/s);
            start omega: 2 rad/s;
        }
        unilateral floor: rod.tip.y >= 0 m;
        friction slip: rate(rod.tip.x) within mu*reaction(floor);
    }
}

/// p = D_nn - sigma mu D_nt is zero at tan th = (3 mu - sqrt(9 mu^2 - 16))/2 (F. Génot, B. Brogliato, European Journal of Mechanics A 18,
/// 1999): the run ends there, and names the row. The time is that of equations without a pole, in `plm-runtime/tests/contact`.
#[test]
fn a_rod_that_slides_to_the_paradox_is_named() {
    for tolerance in [1e-6, 1e-10] {
        let mut sim = Rod::new().start_with(Dop853::new(tolerance)).unwrap();
        let fault = sim.step_to(1.0).unwrap_err();
        assert_eq!(fault.part, "floor");
        let Cause::NotUnique { p } = fault.cause else { panic!("{fault}") };
        near(p, 0.0, 1e-8);
        near(sim.state_of("rod").angle, (3.0 - 5.0_f64.sqrt()).atan(), 1e-8);
        near(fault.time, 0.147_313_877, 1e-8 + tolerance);
    }
}

/// Between the angles where p is zero the tip has no push that satisfies the laws.
#[test]
fn a_rod_that_digs_in_is_named() {
    let rod = Rod::new()
        .with_start("rod.angle", 60.0_f64.to_radians())
        .with_start("rod.x", 0.25)
        .with_start("rod.y", 0.5 * 60.0_f64.to_radians().sin())
        .with_start("rod.vx", -10.0)
        .with_start("rod.vy", 0.0)
        .with_start("rod.omega", 0.0);
    let fault = rod.start_with(Dop853::new(1e-10)).unwrap_err();
    assert_eq!(fault.part, "floor");
    let Cause::NoMode { touching: 1, p } = fault.cause else { panic!("{fault}") };
    // 1 + 3 cos^2 th - 3 mu sin th cos th of 1 + 3 cos^2 th.
    near(p, (1.75 - 1.5 * 3.0_f64.sqrt()) / 1.75, 1e-12);
}

//! Rows of contact beside conditions, kinks, known times and states.

use plm::{Dop853, mechanism};

use crate::near;

mechanism! {
    part thruster(on: body) {
        input gain: 1 = 1;
        // A force that jumps with the place and with the time, and one that bends.
        force on on: (gain*(if on.x < 0.5 m then 4 N else 1 N) + (if t < 1 s then 0 N else 2 N) + 0.1 N*abs(on.x - 0.2 m)/(1 m), 0 N);
    }
    /// A block on a floor, pushed by forces that jump and bend; a state counts its work.
    pub Pushed {
        gravity: 9.81 m/s^2;
        body block { mass: 2 kg; inertia: 1 kg*m^2; }
        constraint level: block.angle = 0;
        thruster push(block);
        unilateral floor: block.y >= 0 m;
        friction slip: rate(block.x) within 0.1*reaction(floor);
        state heat: J = 0 J;
        rate heat = 0.1*(2 kg)*(9.81 m/s^2)*abs(block.vx);
        output heat;
    }
}

/// The kinetic energy is the work of the forces less that of friction.
#[test]
fn conditions_and_contact_end_steps_side_by_side() {
    let mut sim = Pushed::new().start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(1.0).unwrap();
    let before = sim.block().x;
    sim.step_to(3.0).unwrap();
    let (x, v) = (sim.block().x, sim.block().vx);
    assert!(x > 0.6 && before > 0.5, "{before} {:?}", sim.block());
    let bend = 0.5 * 0.1 * (0.2_f64.powi(2) + (x - 0.2).powi(2));
    let work = 4.0 * 0.5 + (x - 0.5) + 2.0 * (x - before) + bend;
    near(v * v + 0.1 * 2.0 * 9.81 * x, work, 1e-9);
    near(sim.heat(), 0.1 * 2.0 * 9.81 * x, 1e-9);
}

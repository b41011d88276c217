//! Rows of contact beside conditions, kinks, known times and states.

use plm::{Dop853, Mechanism as _, Moment as _};

use crate::declared::Timed;
use crate::near;
use crate::scene::Named as _;

scene! {
    /// A block on a floor, pushed by forces that jump and bend; a state counts its work.
    pub Pushed {
        part thruster(on: body) {
            input gain: 1 = 1;
            // A force that jumps with the place and with the time, and one that bends.
            force on on: (gain*(if on.x < 0.5 m then 4 N else 1 N) + (if t < 1 s then 0 N else 2 N) + 0.1 N*abs(on.x - 0.2 m)/(1 m), 0 N);
        }
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
    let before = sim.state_of("block").x;
    sim.step_to(3.0).unwrap();
    let (x, v) = (sim.state_of("block").x, sim.state_of("block").vx);
    assert!(x > 0.6 && before > 0.5, "{before} {:?}", sim.state_of("block"));
    let bend = 0.5 * 0.1 * (0.2_f64.powi(2) + (x - 0.2).powi(2));
    let work = 4.0 * 0.5 + (x - 0.5) + 2.0 * (x - before) + bend;
    near(v * v + 0.1 * 2.0 * 9.81 * x, work, 1e-9);
    near(sim.value_of("heat"), 0.1 * 2.0 * 9.81 * x, 1e-9);
}

/// Events of contact leave the sides of conditions on the time alone.
#[test]
fn known_times_and_contact_do_not_mix() {
    let mut sim = Timed::new().start_with(Dop853::new(1e-11)).unwrap();
    let x = |t: f64| {
        let late = 0.75 * (t - 1.5).max(0.0).powi(2);
        let (from, to) = ((t - 0.9).max(0.0), (t - 1.1).max(0.0));
        late + 1.25 * (from * from - to * to)
    };
    for k in 1..=30 {
        sim.step_to(0.1 * f64::from(k)).unwrap();
        near(sim.state_of("ball").x, x(sim.time()), 1e-12);
    }
    assert!(sim.contact_stats().impacts > 10);
}

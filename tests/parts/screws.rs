//! Gears between shafts, worms and lead screws: Willis, efficiencies, self-locking.

use plm::{Dop853, Mechanism as _, Sim};

use crate::declared::{Screws, Shafts};
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

fn at(shafts: &Scene, time: f64) -> Sim<Scene> {
    let mut sim = shafts.start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(time).unwrap();
    sim
}

/// Torques of 1, k and -(1 + k), and speeds by Willis; the torque of the sun follows from all three inertias.
#[test]
fn three_shafts_turn_by_willis() {
    let sim = at(&Shafts::new(), 0.5);
    let k = 3.0;
    let lambda = 2.0 / 0.01 / (1.0 / 0.01 + k * k / 0.1 + (1.0 + k) * (1.0 + k) / 0.2);
    near(sim.value_of("set.torque_sun"), -lambda, 1e-9);
    near(sim.value_of("set.torque_ring"), -k * lambda, 1e-9);
    near(sim.value_of("set.torque_carrier"), (1.0 + k) * lambda, 1e-9);
    near(sim.value_of("carrier.speed"), 0.5 * (1.0 + k) * lambda / 0.2, 1e-9);
    near(
        sim.value_of("sun.speed") + k * sim.value_of("ring.speed"),
        (1.0 + k) * sim.value_of("carrier.speed"),
        1e-9,
    );
}

/// J. E. Shigley, C. R. Mischke, Mechanical Engineering Design: e = (cos a - mu tan g)/(cos a + mu cot g); a wheel that drives
/// has the counterpart with the friction turned round, and holds from mu = cos a tan g on.
#[test]
fn a_worm_has_the_efficiency_of_its_thread_and_holds() {
    let (tan, cos) = (5_f64.to_radians().tan(), 20_f64.to_radians().cos());
    let ratio = 0.02 * tan / 0.1;
    let sim = at(&Screws::new(), 0.2);
    assert!(sim.value_of("spindle.speed") > 1.0);
    near(sim.value_of("wheel.speed"), ratio * sim.value_of("spindle.speed"), 1e-9);
    let taken = -sim.value_of("drive.torque_a") * sim.value_of("spindle.speed");
    let given = sim.value_of("drive.torque_b") * sim.value_of("wheel.speed");
    near(given / taken, (cos - 0.05 * tan) / (cos + 0.05 / tan), 1e-9);
    near(sim.value_of("drive.lost"), taken - given, 1e-9 * taken);

    let driven = |mu| Screws::new().with("mu", mu).with("spin", 0.0).with("load", 50.0);
    let sim = at(&driven(0.05), 0.2);
    let taken = -sim.value_of("drive.torque_b") * sim.value_of("wheel.speed");
    let given = sim.value_of("drive.torque_a") * sim.value_of("spindle.speed");
    assert!(taken > 0.0, "{taken}");
    near(given / taken, (cos * tan - 0.05) / ((cos + 0.05 * tan) * tan), 1e-9);
    // cos a tan g = 0.0822.
    let held = at(&driven(0.083), 2.0);
    assert_eq!((held.value_of("wheel.angle"), held.value_of("wheel.speed")), (0.0, 0.0));
    near(held.value_of("drive.torque_b"), -50.0, 1e-9);
    assert!(at(&driven(0.081), 2.0).value_of("wheel.angle") > 1e-3);
}

/// The same, example 8-1: 26.18 N m to raise 6.4 kN, 9.77 N m to lower them, with a collar.
#[test]
fn a_lead_screw_raises_lowers_and_holds() {
    let published = [(100.0, 26.18, 1.0), (-20.0, 9.77, -1.0)];
    for (turn, torque, sense) in published {
        let sim = at(&Screws::new().with("turn", turn), 0.05);
        near(-sense * sim.value_of("thread.torque") / sim.value_of("thread.force") * 6400.0, torque, 0.005);
        let (lead, diameter, mu) = (0.008, 0.03, 0.08);
        let turn = std::f64::consts::PI * diameter;
        let exact = 0.5 * diameter * (mu * turn + sense * lead) / (turn - sense * mu * lead) + mu * 0.02;
        near(-sense * sim.value_of("thread.torque") / sim.value_of("thread.force"), exact, 1e-12);
        near(sim.value_of("nut.speed"), lead / std::f64::consts::TAU * sim.value_of("screw.speed"), 1e-12);
        let net = sim.value_of("thread.torque") * sim.value_of("screw.speed")
            + sim.value_of("thread.force") * sim.value_of("nut.speed");
        near(sim.value_of("thread.lost"), -net, 1e-9 * net.abs());
    }
    let held = at(&Screws::new().with("turn", 0.0), 1.0);
    assert_eq!((held.value_of("nut.position"), held.value_of("screw.speed")), (0.0, 0.0));
}

#[test]
fn a_gearbox_gives_its_share_of_the_power() {
    let sim = at(&Shafts::new(), 0.3);
    near(sim.value_of("fast.speed"), 10.0 * sim.value_of("slow.speed"), 1e-9);
    near(
        sim.value_of("reducer.torque_b") * sim.value_of("slow.speed"),
        -0.9 * sim.value_of("reducer.torque_a") * sim.value_of("fast.speed"),
        1e-9,
    );
    near(
        sim.value_of("reducer.lost"),
        -0.1 * sim.value_of("reducer.torque_a") * sim.value_of("fast.speed"),
        1e-9,
    );
    // Seen from the fast shaft: 0.01 + 2/(0.9 10^2).
    near(sim.value_of("fast.speed"), 0.3 * 2.0 / (0.01 + 2.0 / 90.0), 1e-9);
}

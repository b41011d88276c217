//! Gears between shafts, worms and lead screws: Willis, efficiencies, self-locking.

use plm::{Dop853, Sim};

use crate::near;

plm::mechanism! {
    pub Shafts {
        param mu: 1 = 0.05;
        param motor: N*m = 2 N*m;
        param spin: N*m = 2 N*m;
        param load: N*m = 0;
        param turn: N*m = 100 N*m;
        rotor sun() { inertia: 0.01 kg*m^2; drive: motor; }
        rotor ring() { inertia: 0.1 kg*m^2; }
        rotor carrier() { inertia: 0.2 kg*m^2; }
        planetary set(sun.shaft, ring.shaft, carrier.shaft) { teeth_sun: 20; teeth_ring: 60; }
        rotor spindle() { inertia: 0.02 kg*m^2; drive: spin; }
        rotor wheel() { inertia: 0.3 kg*m^2; drive: load; }
        worm drive(spindle.shaft, wheel.shaft) { worm_radius: 20 mm; wheel_radius: 100 mm; lead_angle: 5 deg; friction: mu; }
        rotor screw() { drive: turn; }
        sliding_mass nut() { mass: 3 kg; drive: -6.4 kN; }
        lead_screw thread(screw.shaft, nut.slider) {
            lead: 8 mm; diameter: 30 mm; friction: 0.08; collar_friction: 0.08; collar_diameter: 40 mm;
        }
        rotor fast() { drive: motor; }
        rotor slow() { inertia: 2 kg*m^2; }
        gearbox reducer(fast.shaft, slow.shaft) { ratio: 10; efficiency: 0.9; }
        output set.torque_sun, set.torque_ring, set.torque_carrier, sun.speed, ring.speed, carrier.speed;
        output drive.torque_a, drive.torque_b, drive.lost, drive.normal_force, spindle.speed, wheel.speed, wheel.angle;
        output thread.torque, thread.force, thread.lost, nut.position, nut.speed, screw.speed;
        output reducer.torque_a, reducer.torque_b, reducer.lost, fast.speed, slow.speed;
    }
}

fn at(shafts: &Shafts, time: f64) -> Sim<Shafts> {
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
    near(sim.set_torque_sun(), -lambda, 1e-9);
    near(sim.set_torque_ring(), -k * lambda, 1e-9);
    near(sim.set_torque_carrier(), (1.0 + k) * lambda, 1e-9);
    near(sim.carrier_speed(), 0.5 * (1.0 + k) * lambda / 0.2, 1e-9);
    near(sim.sun_speed() + k * sim.ring_speed(), (1.0 + k) * sim.carrier_speed(), 1e-9);
}

/// J. E. Shigley, C. R. Mischke, Mechanical Engineering Design: e = (cos a - mu tan g)/(cos a + mu cot g); a wheel that drives
/// has the counterpart with the friction turned round, and holds from mu = cos a tan g on.
#[test]
fn a_worm_has_the_efficiency_of_its_thread_and_holds() {
    let (tan, cos) = (5_f64.to_radians().tan(), 20_f64.to_radians().cos());
    let ratio = 0.02 * tan / 0.1;
    let sim = at(&Shafts::new(), 0.2);
    assert!(sim.spindle_speed() > 1.0);
    near(sim.wheel_speed(), ratio * sim.spindle_speed(), 1e-9);
    let taken = -sim.drive_torque_a() * sim.spindle_speed();
    let given = sim.drive_torque_b() * sim.wheel_speed();
    near(given / taken, (cos - 0.05 * tan) / (cos + 0.05 / tan), 1e-9);
    near(sim.drive_lost(), taken - given, 1e-9 * taken);

    let driven = |mu| Shafts { mu, spin: 0.0, load: 50.0, ..Shafts::new() };
    let sim = at(&driven(0.05), 0.2);
    let taken = -sim.drive_torque_b() * sim.wheel_speed();
    let given = sim.drive_torque_a() * sim.spindle_speed();
    assert!(taken > 0.0, "{taken}");
    near(given / taken, (cos * tan - 0.05) / ((cos + 0.05 * tan) * tan), 1e-9);
    // cos a tan g = 0.0822.
    let held = at(&driven(0.083), 2.0);
    assert_eq!((held.wheel_angle(), held.wheel_speed()), (0.0, 0.0));
    near(held.drive_torque_b(), -50.0, 1e-9);
    assert!(at(&driven(0.081), 2.0).wheel_angle() > 1e-3);
}

/// The same, example 8-1: 26.18 N m to raise 6.4 kN, 9.77 N m to lower them, with a collar.
#[test]
fn a_lead_screw_raises_lowers_and_holds() {
    let published = [(100.0, 26.18, 1.0), (-20.0, 9.77, -1.0)];
    for (turn, torque, sense) in published {
        let sim = at(&Shafts { turn, ..Shafts::new() }, 0.05);
        near(-sense * sim.thread_torque() / sim.thread_force() * 6400.0, torque, 0.005);
        let (lead, diameter, mu) = (0.008, 0.03, 0.08);
        let turn = std::f64::consts::PI * diameter;
        let exact = 0.5 * diameter * (mu * turn + sense * lead) / (turn - sense * mu * lead) + mu * 0.02;
        near(-sense * sim.thread_torque() / sim.thread_force(), exact, 1e-12);
        near(sim.nut_speed(), lead / std::f64::consts::TAU * sim.screw_speed(), 1e-12);
        let net = sim.thread_torque() * sim.screw_speed() + sim.thread_force() * sim.nut_speed();
        near(sim.thread_lost(), -net, 1e-9 * net.abs());
    }
    let held = at(&Shafts { turn: 0.0, ..Shafts::new() }, 1.0);
    assert_eq!((held.nut_position(), held.screw_speed()), (0.0, 0.0));
}

#[test]
fn a_gearbox_gives_its_share_of_the_power() {
    let sim = at(&Shafts::new(), 0.3);
    near(sim.fast_speed(), 10.0 * sim.slow_speed(), 1e-9);
    near(sim.reducer_torque_b() * sim.slow_speed(), -0.9 * sim.reducer_torque_a() * sim.fast_speed(), 1e-9);
    near(sim.reducer_lost(), -0.1 * sim.reducer_torque_a() * sim.fast_speed(), 1e-9);
    // Seen from the fast shaft: 0.01 + 2/(0.9 10^2).
    near(sim.fast_speed(), 0.3 * 2.0 / (0.01 + 2.0 / 90.0), 1e-9);
}

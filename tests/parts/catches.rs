//! Latches, locks and ratchets.

use plm::{Dop853, Mechanism as _};

use crate::declared::Catches;
use crate::joints::near;
use crate::scene::Named as _;

/// A drawer against a constant pull of 8 N comes back to the bolt, which holds it until it is released, or breaks at 20 N.
#[test]
fn a_latch_catches_holds_and_lets_go() {
    let mut sim = Catches::new().start_with(Dop853::new(1e-11)).unwrap();
    // v t - 2 t^2 = 0.05 m on the way out and on the way back, where the bolt takes the speed.
    let [out, back] = [-1.0, 1.0].map(|side: f64| (1.0 + side * (1.0 - 0.4_f64).sqrt()) / 4.0);
    sim.step_to(out - 1e-6).unwrap();
    near(sim.value_of("bolt.catches"), 0.0, 0.0);
    sim.step_to(out + 1e-6).unwrap();
    near(sim.value_of("bolt.catches"), 1.0, 0.0);
    sim.step_to(back - 1e-6).unwrap();
    near(sim.state_of("drawer").vx, 1.0 - 4.0 * (back - 1e-6), 1e-10);
    sim.step_to(back + 1e-6).unwrap();
    near(sim.state_of("drawer").vx, 0.0, 1e-12);
    sim.step_to(2.0).unwrap();
    near(sim.state_of("drawer").x, 0.05, 1e-12);
    near(sim.value_of("bolt.force"), 8.0, 1e-10);
    let mut released = Catches::new().start_with(Dop853::new(1e-11)).unwrap();
    released.step_to(1.0).unwrap();
    released.set_input("release", 1.0);
    released.step_to(1.5).unwrap();
    near(released.state_of("drawer").x, 0.05 - 2.0 * 0.25, 1e-10);
    // 8 N and 10 N/s past 2 s: 20 N at 3.2 s.
    sim.step_to(3.2 - 1e-6).unwrap();
    near(sim.value_of("bolt.force"), 20.0, 2e-5);
    near(sim.value_of("bolt.catches"), 1.0, 0.0);
    sim.step_to(3.2 + 1e-6).unwrap();
    near(sim.value_of("bolt.catches"), 0.0, 0.0);
    sim.step_to(3.3).unwrap();
    near(sim.state_of("drawer").vx, -(20.0 * 0.1 + 0.5 * 10.0 * 0.01) / 2.0, 1e-8);
}

/// A torque of 2 N m turns the wheel over teeth of 30 deg; turned back by -2 N m it falls to the last tooth and is held there.
#[test]
fn a_ratchet_turns_one_way() {
    let mut sim = Catches::new().start_with(Dop853::new(1e-11)).unwrap();
    let pitch = 30_f64.to_radians();
    let angle = |t: f64| 0.5 * 4.0 * t * t;
    for k in 1..=8 {
        let t = 0.2 * f64::from(k);
        sim.step_to(t).unwrap();
        near(sim.state_of("wheel").angle, angle(t), 1e-10);
        near(sim.value_of("pawl.torque"), 0.0, 0.0);
    }
    // 5.12 rad and 6.4 rad/s to the left: back by the torque turned round, it stops at 2 * 5.12 rad, past 19 teeth.
    sim.set_input("torque", -2.0);
    sim.step_to(3.2).unwrap();
    near(sim.state_of("wheel").angle, 10.24, 1e-9);
    let seat = (10.24 / pitch).floor() * pitch;
    let back = 3.2 + (2.0 * (10.24 - seat) / 4.0).sqrt();
    sim.step_to(back - 1e-6).unwrap();
    assert!(sim.state_of("wheel").omega < -0.1);
    sim.step_to(back + 1e-6).unwrap();
    near(sim.state_of("wheel").omega, 0.0, 1e-12);
    near(sim.state_of("wheel").angle, seat, 1e-9);
    near(sim.value_of("pawl.torque"), 2.0, 1e-9);
    sim.step_to(20.0).unwrap();
    near(sim.state_of("wheel").angle, seat, 1e-9);
    // Lifted, the pawl lets the wheel run back; let down, it catches at the tooth that was passed last.
    sim.set_input("lifted", 1.0);
    sim.step_to(21.0).unwrap();
    near(sim.state_of("wheel").angle, seat - 2.0, 1e-9);
    sim.set_input("lifted", 0.0);
    sim.step_to(23.0).unwrap();
    near(sim.state_of("wheel").angle, seat - 4.0 * pitch, 1e-9);
    near(sim.value_of("pawl.torque"), 2.0, 1e-9);
    // Lifted, the pawl lets it run on over teeth too; let down behind 2 rad, where it has 4 rad/s, it goes on by 2 rad and falls back.
    sim.set_input("lifted", 1.0);
    sim.set_input("torque", 2.0);
    sim.step_to(24.0).unwrap();
    near(sim.state_of("wheel").angle, seat - 4.0 * pitch + 2.0, 1e-9);
    sim.set_input("lifted", 0.0);
    sim.set_input("torque", -2.0);
    sim.step_to(28.0).unwrap();
    near(sim.state_of("wheel").angle, seat - 4.0 * pitch + (4.0 / pitch).floor() * pitch, 1e-9);
}

/// The lock closes at 1 s on 3 rad/s and takes it within 0.25 s by 6 N m; then it holds, to 6 N m at 5 s.
#[test]
fn a_lock_grips_anywhere() {
    let mut sim = Catches::new().start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(1.1).unwrap();
    near(sim.state_of("rotor").omega, 3.0 - 12.0 * 0.1, 1e-10);
    near(sim.value_of("brake.torque"), -6.0, 1e-12);
    assert_eq!((sim.value_of("brake.locked"), sim.value_of("sticks")), (0.0, 0.0));
    sim.step_to(1.25 + 1e-6).unwrap();
    near(sim.state_of("rotor").omega, 0.0, 1e-12);
    assert_eq!((sim.value_of("brake.locked"), sim.value_of("sticks")), (1.0, 1.0));
    sim.step_to(4.9).unwrap();
    near(sim.state_of("rotor").angle, 3.0 + 0.375, 1e-10);
    near(sim.value_of("brake.torque"), -5.7, 1e-9);
    sim.step_to(6.0).unwrap();
    near(sim.state_of("rotor").omega, 0.5 * 3.0 / 0.5, 1e-8);
}

/// The pin falls into its hole at 60 deg and takes the whole speed; it carries 5 N m from 2 s, and lets go at 3 s.
#[test]
fn a_pin_holds_at_its_hole() {
    let mut sim = Catches::new().start_with(Dop853::new(1e-11)).unwrap();
    let hole = 60_f64.to_radians();
    sim.step_to(hole - 1e-6).unwrap();
    near(sim.state_of("arm").omega, 1.0, 1e-12);
    sim.step_to(2.5).unwrap();
    near(sim.state_of("arm").angle, hole, 1e-9);
    near(sim.state_of("arm").omega, 0.0, 1e-12);
    near(sim.value_of("pin.torque"), -5.0, 1e-9);
    sim.step_to(3.5).unwrap();
    near(sim.state_of("arm").angle, hole + 0.5 * 10.0 * 0.25, 1e-8);
}

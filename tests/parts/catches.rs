//! Latches, locks and ratchets.

use plm::{Dop853, mechanism};

use crate::joints::near;

mechanism! {
    /// What catches and lets go, side by side.
    pub Catches {
        input release = 0;
        input lifted = 0;
        input torque: N*m = 2 N*m;
        ground { port bolt: (0, 0) m; port spring: (-1, 0) m; port axle: (0, 2) m; port shaft: (0, 4) m; port hole: (0, 6) m; }
        body drawer { mass: 2 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start vx: 1 m/s, locked; }
        prismatic rail(ground.bolt, drawer.p) { drive: -8 N; }
        latch bolt(ground.bolt, drawer.p) { position: 0.05 m; release: release; strength: 20 N; }
        force pull(drawer.p) { x: if t > 2 s then -10 N/s*(t - 2 s) else 0 N; }

        body wheel { mass: 2 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; start y: 2 m; start omega: 0 rad/s, locked; }
        revolute axle(ground.axle, wheel.hub) { drive: torque; }
        ratchet pawl(ground.axle, wheel.hub) { teeth: 12; lifted: lifted; }

        discrete grips = 0;
        when t > 1 s { grips = 1; }
        body rotor { mass: 2 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; start y: 4 m; start omega: 3 rad/s, locked; }
        revolute shaft(ground.shaft, rotor.hub) { drive: if t > 3 s then 3 N*m/s*(t - 3 s) else 0 N*m; }
        lock brake(ground.shaft, rotor.hub) { closed: grips; strength: 6 N*m; }

        discrete pinned = 0;
        body arm { mass: 2 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; start y: 6 m; start omega: 1 rad/s, locked; }
        revolute hinge(ground.hole, arm.hub);
        lock pin(ground.hole, arm.hub) { closed: pinned; angle: 60 deg; }
        when arm.angle > 60 deg and t < 2 s { pinned = 1; }
        when t > 3 s { pinned = 0; }
        force push(arm.hub) { torque: if t > 2 s then 5 N*m else 0 N*m; }

        output bolt.catches, bolt.force, pawl.torque, brake.torque, brake.locked, pin.torque;
        output sticks = if is_sticking(brake.grip) then 1 else 0;
    }
}

/// A drawer against a constant pull of 8 N comes back to the bolt, which holds it until it is released, or breaks at 20 N.
#[test]
fn a_latch_catches_holds_and_lets_go() {
    let mut sim = Catches::new().start_with(Dop853::new(1e-11)).unwrap();
    // v t - 2 t^2 = 0.05 m on the way out and on the way back, where the bolt takes the speed.
    let [out, back] = [-1.0, 1.0].map(|side: f64| (1.0 + side * (1.0 - 0.4_f64).sqrt()) / 4.0);
    sim.step_to(out - 1e-6).unwrap();
    near(sim.bolt_catches(), 0.0, 0.0);
    sim.step_to(out + 1e-6).unwrap();
    near(sim.bolt_catches(), 1.0, 0.0);
    sim.step_to(back - 1e-6).unwrap();
    near(sim.drawer().vx, 1.0 - 4.0 * (back - 1e-6), 1e-10);
    sim.step_to(back + 1e-6).unwrap();
    near(sim.drawer().vx, 0.0, 1e-12);
    sim.step_to(2.0).unwrap();
    near(sim.drawer().x, 0.05, 1e-12);
    near(sim.bolt_force(), 8.0, 1e-10);
    let mut released = Catches::new().start_with(Dop853::new(1e-11)).unwrap();
    released.step_to(1.0).unwrap();
    released.input.release = 1.0;
    released.step_to(1.5).unwrap();
    near(released.drawer().x, 0.05 - 2.0 * 0.25, 1e-10);
    // 8 N and 10 N/s past 2 s: 20 N at 3.2 s.
    sim.step_to(3.2 - 1e-6).unwrap();
    near(sim.bolt_force(), 20.0, 2e-5);
    near(sim.bolt_catches(), 1.0, 0.0);
    sim.step_to(3.2 + 1e-6).unwrap();
    near(sim.bolt_catches(), 0.0, 0.0);
    sim.step_to(3.3).unwrap();
    near(sim.drawer().vx, -(20.0 * 0.1 + 0.5 * 10.0 * 0.01) / 2.0, 1e-8);
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
        near(sim.wheel().angle, angle(t), 1e-10);
        near(sim.pawl_torque(), 0.0, 0.0);
    }
    // 5.12 rad and 6.4 rad/s to the left: back by the torque turned round, it stops at 2 * 5.12 rad, past 19 teeth.
    sim.input.torque = -2.0;
    sim.step_to(3.2).unwrap();
    near(sim.wheel().angle, 10.24, 1e-9);
    let seat = (10.24 / pitch).floor() * pitch;
    let back = 3.2 + (2.0 * (10.24 - seat) / 4.0).sqrt();
    sim.step_to(back - 1e-6).unwrap();
    assert!(sim.wheel().omega < -0.1);
    sim.step_to(back + 1e-6).unwrap();
    near(sim.wheel().omega, 0.0, 1e-12);
    near(sim.wheel().angle, seat, 1e-9);
    near(sim.pawl_torque(), 2.0, 1e-9);
    sim.step_to(20.0).unwrap();
    near(sim.wheel().angle, seat, 1e-9);
    // Lifted, the pawl lets the wheel run back; let down, it catches at the tooth that was passed last.
    sim.input.lifted = 1.0;
    sim.step_to(21.0).unwrap();
    near(sim.wheel().angle, seat - 2.0, 1e-9);
    sim.input.lifted = 0.0;
    sim.step_to(23.0).unwrap();
    near(sim.wheel().angle, seat - 4.0 * pitch, 1e-9);
    near(sim.pawl_torque(), 2.0, 1e-9);
    // Lifted, the pawl lets it run on over teeth too; let down behind 2 rad, where it has 4 rad/s, it goes on by 2 rad and falls back.
    (sim.input.lifted, sim.input.torque) = (1.0, 2.0);
    sim.step_to(24.0).unwrap();
    near(sim.wheel().angle, seat - 4.0 * pitch + 2.0, 1e-9);
    (sim.input.lifted, sim.input.torque) = (0.0, -2.0);
    sim.step_to(28.0).unwrap();
    near(sim.wheel().angle, seat - 4.0 * pitch + (4.0 / pitch).floor() * pitch, 1e-9);
}

/// The lock closes at 1 s on 3 rad/s and takes it within 0.25 s by 6 N m; then it holds, to 6 N m at 5 s.
#[test]
fn a_lock_grips_anywhere() {
    let mut sim = Catches::new().start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(1.1).unwrap();
    near(sim.rotor().omega, 3.0 - 12.0 * 0.1, 1e-10);
    near(sim.brake_torque(), -6.0, 1e-12);
    assert_eq!((sim.brake_locked(), sim.sticks()), (0.0, 0.0));
    sim.step_to(1.25 + 1e-6).unwrap();
    near(sim.rotor().omega, 0.0, 1e-12);
    assert_eq!((sim.brake_locked(), sim.sticks()), (1.0, 1.0));
    sim.step_to(4.9).unwrap();
    near(sim.rotor().angle, 3.0 + 0.375, 1e-10);
    near(sim.brake_torque(), -5.7, 1e-9);
    sim.step_to(6.0).unwrap();
    near(sim.rotor().omega, 0.5 * 3.0 / 0.5, 1e-8);
}

/// The pin falls into its hole at 60 deg and takes the whole speed; it carries 5 N m from 2 s, and lets go at 3 s.
#[test]
fn a_pin_holds_at_its_hole() {
    let mut sim = Catches::new().start_with(Dop853::new(1e-11)).unwrap();
    let hole = 60_f64.to_radians();
    sim.step_to(hole - 1e-6).unwrap();
    near(sim.arm().omega, 1.0, 1e-12);
    sim.step_to(2.5).unwrap();
    near(sim.arm().angle, hole, 1e-9);
    near(sim.arm().omega, 0.0, 1e-12);
    near(sim.pin_torque(), -5.0, 1e-9);
    sim.step_to(3.5).unwrap();
    near(sim.arm().angle, hole + 0.5 * 10.0 * 0.25, 1e-8);
}

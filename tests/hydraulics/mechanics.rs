//! Parts of mechanics beside formulas that were written down independently.

use crate::{Random, assert_near};

plm::mechanism! {
    /// A door that turns a rotor through a gear, coupled to a motor; a cart on a slope; a lever on a pin in a slot.
    pub Rig {
        gravity: 9.81 m/s^2;
        input drive: N*m = 0 N*m;
        ground { port hinge: (0, 0) m; port slot: (2, 0.5) m, axis: 25 deg; }
        body door { mass: 2 kg; inertia: 0.3 kg*m^2; port hinge: (0, 0) m; start angle: 0.2 rad, locked; start omega: 0, locked; }
        revolute hinge(ground.hinge, door.hinge) { drive: drive; }
        attached_rotor geared(hinge.shaft) { inertia: 0.02 kg*m^2; ratio: -6; }
        rotor motor() { inertia: 0.05 kg*m^2; drive: 0.7 N*m; start: 0.4 rad; start_speed: 3 rad/s; }
        shaft_spring coupling(motor.shaft, hinge.shaft) {
            stiffness: 4 N*m/rad; damping: 0.1 N*m/(rad/s); rest: 0.1 rad; preload: 2 N*m;
        }
        sliding_mass cart() { mass: 3 kg; x: 0.5 m; y: -0.2 m; angle: 30 deg; drive: 5 N; start: 0.6 m; start_speed: -0.4 m/s; }
        body lever { mass: 1 kg; inertia: 0.04 kg*m^2; port pin: (0, 0) m; start x: 2 m; start y: 0.5 m; }
        pin_slot slot(ground.slot, lever.pin) { rotary_stiffness: 6 N*m/rad; rotary_damping: 0.5 N*m/(rad/s); rest: 0.3 rad; }
        output door.alpha, geared.torque, motor.angle, motor.speed, motor.torque, motor_alpha = rate(motor.speed);
        output coupling.torque, coupling.energy, coupling.lost, slot.torque, slot.angle, lever.alpha;
        output cart.position, cart.speed, cart.force, cart_acceleration = rate(cart.speed);
    }
}

#[test]
fn shafts_slopes_and_slots_follow_their_laws() {
    let mut random = Random(8);
    for _ in 0..50 {
        let mut draw = || random.between(-1.0, 1.0);
        let (door, omega, lever, spin, drive) = (draw(), draw(), draw(), draw(), 2.0 * draw());
        let (turned, speed, place) = (0.4, 3.0, 0.6);
        let mut rig = Rig::new();
        (rig.start.door.angle.value, rig.start.door.omega.value) = (door, omega);
        (rig.start.lever.angle.value, rig.start.lever.omega.value) = (lever, spin);
        (rig.start.lever.angle.locked, rig.start.lever.omega.locked) = (true, true);
        let mut sim = rig.start().unwrap();
        sim.input.drive = drive;

        // The spring turns the door towards greater angles and the motor towards smaller ones.
        let (between, rate) = (door - turned, omega - speed);
        let spring = 2.0 - 4.0 * (between - 0.1) - 0.1 * rate;
        assert_near(sim.coupling_torque(), spring, 1.0, "coupling");
        assert_near(sim.coupling_energy(), 2.0 * (between - 0.1).powi(2), 1.0, "energy of the coupling");
        assert_near(sim.coupling_lost(), 0.1 * rate * rate, 1.0, "loss in the coupling");
        assert_near(sim.motor_angle(), turned, 1.0, "where the motor starts");
        assert_near(sim.motor_speed(), speed, 1.0, "how fast the motor starts");
        assert_near(sim.motor_torque(), 0.7 - spring, 1.0, "torque on the motor");
        assert_near(sim.motor_alpha(), (0.7 - spring) / 0.05, 10.0, "acceleration of the motor");

        // A rotor that turns -6 times as fast is as hard to turn as 36 of its inertia.
        let alpha = (drive + spring) / (0.3 + 36.0 * 0.02);
        assert_near(sim.door_alpha(), alpha, 1.0, "acceleration of the door");
        assert_near(sim.geared_torque(), -36.0 * 0.02 * alpha, 1.0, "what the rotor does to the door");
        assert_near(sim.geared_carried_wheel().angle, -6.0 * door, 1.0, "the rotor's angle");
        assert_near(sim.geared_carried_wheel().omega, -6.0 * omega, 1.0, "the rotor's speed");

        let (sin, cos) = 30_f64.to_radians().sin_cos();
        assert_near(sim.cart_position(), place, 1.0, "where the cart starts");
        assert_near(sim.cart_carriage().x, 0.5 + place * cos, 1.0, "x of the cart");
        assert_near(sim.cart_carriage().y, -0.2 + place * sin, 1.0, "y of the cart");
        assert_near(sim.cart_speed(), -0.4, 1.0, "how fast the cart starts");
        assert_near(sim.cart_carriage().vy, -0.4 * sin, 1.0, "its speed upwards");
        assert_near(sim.cart_force(), 5.0, 1.0, "force on the cart");
        assert_near(sim.cart_acceleration(), 5.0 / 3.0 - 9.81 * sin, 1.0, "acceleration of the cart");

        let angle = lever - 25_f64.to_radians();
        let torque = -6.0 * (angle - 0.3) - 0.5 * spin;
        assert_near(sim.slot_angle(), angle, 1.0, "angle in the slot");
        assert_near(sim.slot_torque(), torque, 1.0, "torque in the slot");
        assert_near(sim.lever_alpha(), torque / 0.04, 10.0, "acceleration of the lever");
    }
}

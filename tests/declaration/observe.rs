//! What is observed obeys the laws of mechanics, and costs nothing in a step.

use plm::{Dop853, Observed};

/// A slider-crank with a spring and a driven jack; observed where `$observe` says so.
macro_rules! press {
    ($module:ident, { $($observe:tt)* }) => {
        mod $module {
            plm::mechanism! {
                pub Press {
                    gravity: 9.81 m/s^2;
                    $($observe)*
                    ground { port o: (0, 0) m; port rail: (0, 0.1) m, angle: 15 deg; port hook: (0.3, 1) m; }
                    body crank {
                        mass: 1.5 kg; inertia: 0.02 kg*m^2;
                        port o: (-0.1, 0.02) m; port pin: (0.15, 0) m;
                        start angle: 70 deg, locked; start omega: 6 rad/s, locked;
                    }
                    body rod {
                        mass: 2 kg; inertia: 0.1 kg*m^2;
                        port pin: (-0.5, 0) m; port end: (0.5, 0.05) m; port eye: (0, 0.1) m;
                        start angle: -15 deg;
                    }
                    body ram { mass: 3 kg; inertia: 0.05 kg*m^2; port end: (0.1, 0.03) m; }
                    revolute main(ground.o, crank.o) { damping: 0.3 N*m*s/rad; drive: 4 N*m*sin(3 rad/s*t); }
                    revolute big_end(crank.pin, rod.pin) { stiffness: 2 N*m/rad; }
                    revolute small_end(rod.end, ram.end);
                    prismatic guide(ground.rail, ram.end) { damping: 20 N*s/m; }
                    spring tie(ground.hook, rod.eye) { stiffness: 50 N/m; free_length: 0.4 m; }
                    jack push(crank.pin, ram.end) { drive: 7 N; }
                    output ram.x in mm, guide.force;
                }
            }
        }
    };
}

press!(plain, {});
press!(seen, { observe all; });
press!(absolute, { formulation: absolute; observe all; });

/// `m a = m g + sum F` and `I alpha = sum (M + r x F)` of each body, from what is observed alone.
macro_rules! assert_newton_euler {
    ($sim:ident, $body:ident: $ax:ident $ay:ident $alpha:ident, $mass:literal, $inertia:literal,
     [$($force:ident $torque:ident at $at:ident),*]) => {
        let pose = $sim.$body();
        let mut sum = [0.0, -9.81 * $mass, 0.0];
        $(
            let (force, at) = ($sim.$force(), $sim.$at());
            sum[0] += force[0];
            sum[1] += force[1];
            sum[2] += $sim.$torque() + (at[0] - pose.x) * force[1] - (at[1] - pose.y) * force[0];
        )*
        let inertial = [$mass * $sim.$ax(), $mass * $sim.$ay(), $inertia * $sim.$alpha()];
        for (sum, inertial) in sum.into_iter().zip(inertial) {
            assert!((sum - inertial).abs() < 1e-7, "{}: {sum} and {inertial}", stringify!($body));
        }
    };
}

macro_rules! newton_euler {
    ($name:ident, $module:ident) => {
        #[test]
        fn $name() {
            let mut sim = $module::Press::new().start_with(Dop853::new(1e-11)).unwrap();
            for _ in 0..10 {
                sim.step(0.1).unwrap();
                assert_newton_euler!(sim, crank: crank_ax crank_ay crank_alpha, 1.5, 0.02, [
                    main_force_on_b main_torque_on_b at crank_o_position,
                    big_end_force_on_a big_end_torque_on_a at crank_pin_position,
                    push_force_on_a push_torque_on_a at crank_pin_position
                ]);
                assert_newton_euler!(sim, rod: rod_ax rod_ay rod_alpha, 2.0, 0.1, [
                    big_end_force_on_b big_end_torque_on_b at rod_pin_position,
                    small_end_force_on_a small_end_torque_on_a at rod_end_position,
                    tie_force_on_b tie_torque_on_b at rod_eye_position
                ]);
                assert_newton_euler!(sim, ram: ram_ax ram_ay ram_alpha, 3.0, 0.05, [
                    small_end_force_on_b small_end_torque_on_b at ram_end_position,
                    guide_force_on_b guide_torque_on_b at ram_end_position,
                    push_force_on_b push_torque_on_b at ram_end_position
                ]);
            }
        }
    };
}

newton_euler!(forces_on_ports_move_the_bodies, seen);
newton_euler!(forces_on_ports_move_the_bodies_in_absolute_coordinates, absolute);

/// Velocities and accelerations of ports are the changes of what they are the rates of.
#[test]
fn rates_of_ports_are_difference_quotients() {
    let h = 1e-4;
    let mut sim = seen::Press::new().start_with(Dop853::new(1e-13)).unwrap();
    sim.step(0.3).unwrap();
    let before = *sim.state();
    sim.step(h).unwrap();
    let here = *sim.state();
    sim.step(h).unwrap();
    let after = *sim.state();
    for k in 0..2 {
        let slope = (after.rod_eye_position()[k] - before.rod_eye_position()[k]) / (2.0 * h);
        assert!((slope - here.rod_eye_velocity()[k]).abs() < 1e-5, "{slope}");
        let slope = (after.rod_eye_velocity()[k] - before.rod_eye_velocity()[k]) / (2.0 * h);
        assert!((slope - here.rod_eye_acceleration()[k]).abs() < 1e-3, "{slope}");
    }
}

/// The same step to the bit, the same declared outputs.
#[test]
fn observing_costs_nothing_in_a_step() {
    assert_eq!(plain::press::OPERATIONS, seen::press::OPERATIONS);
    assert_eq!(plain::press::State::<f64>::OUTPUTS, seen::press::State::<f64>::OUTPUTS);
    let mut plain = plain::Press::new().start().unwrap();
    let mut seen = seen::Press::new().start().unwrap();
    plain.step(1.0).unwrap();
    seen.step(1.0).unwrap();
    assert_eq!(plain.outputs(), seen.outputs());
}

#[test]
fn quantities_are_found_by_name() {
    type State = seen::press::State;
    let chosen = State::find(["ram.x", "guide.force.y", "rod.eye.velocity.x", "push.force_on_b.y"]).unwrap();
    // By name all is SI, whatever an output asks for.
    assert_eq!(chosen.map(|of| of.unit), ["m", "N", "m/s", "N"]);
    let sim = seen::Press::new().start().unwrap();
    let values = sim.observed(chosen);
    let expected = [sim.ram_x(), sim.guide_force()[1], sim.rod_eye_velocity()[0], sim.push_force_on_b()[1]];
    for (found, expected) in values.into_iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{found}, {expected}");
    }
    assert_eq!(State::find(["ram.x", "ram.z"]), Err("ram.z"));
    for (column, (name, _)) in State::OBSERVED.into_iter().enumerate() {
        assert_eq!(State::find([name]).map(|[of]: [Observed; 1]| of.column()), Ok(column));
        assert!(sim.observed(State::find([name]).unwrap())[0].is_finite(), "{name}");
    }
}

//! What joints show of their relative motion: each speed and acceleration is the difference quotient of what it is the rate of.

use plm::{Dop853, Mechanism, Sim};

/// All joints, in the formulation that is taken and in absolute coordinates.
macro_rules! machine {
    ($module:ident, { $($formulation:tt)* }) => {
        mod $module {
            plm::mechanism! {
                pub Machine {
                    $($formulation)*
                    gravity: 9.81 m/s^2;
                    ground {
                        port o: (0, 0) m;
                        port shaker: (1 m, 0.1 m*sin(3 rad/s*t)), axis: 20 deg;
                        port hook: (0.3, 1) m;
                    }
                    body crank {
                        mass: 1.5 kg; inertia: 0.02 kg*m^2;
                        port o: (-0.1, 0.02) m; port rail: (0.15, 0) m, angle: 15 deg;
                        start angle: 70 deg, locked; start omega: 4 rad/s, locked;
                    }
                    body shoe {
                        mass: 1 kg; inertia: 0.1 kg*m^2;
                        port rail: (-0.1, 0) m, angle: 10 deg; port pin: (0.2, 0.05) m;
                        start x: 0.5 m; start y: 0.5 m;
                    }
                    body block { mass: 3 kg; inertia: 0.05 kg*m^2; port guide: (0.1, 0.03) m; port slot: (0, 0.1) m, angle: 50 deg; start x: 1.4 m; }
                    body pendulum { mass: 1 kg; inertia: 0.02 kg*m^2; port pin: (0, 0.2) m; start x: 1.4 m; start angle: 30 deg, locked; start omega: -2 rad/s, locked; }
                    revolute hinge(ground.o, crank.o) { damping: 0.3 N*m*s/rad; }
                    prismatic rail(crank.rail, shoe.rail) { stiffness: 90 N/m; free_length: 0.3 m; }
                    prismatic guide(ground.shaker, block.guide) { stiffness: 50 N/m; }
                    pin_slot slot(block.slot, pendulum.pin) { stiffness: 70 N/m; rotary_stiffness: 2 N*m/rad; }
                    jack ram(ground.hook, shoe.pin) { drive: 7 N; }
                    observe all;
                }
            }
        }
    };
}

machine!(joint_coordinates, {});
machine!(absolute, { formulation: absolute; });

/// Central differences over 2 h leave h^2/6 of the third derivative: 1e-8 s^2 times some 1e3 of it.
const H: f64 = 1e-4;
const TOLERANCE: f64 = 1e-4;

/// A moment, and those a little before and after it.
fn around<M: Mechanism<S = f64>>(mut sim: Sim<M>) -> [M::State; 3] {
    sim.step(0.3).unwrap();
    [(); 3].map(|()| {
        let here = *sim.state();
        sim.step(H).unwrap();
        here
    })
}

macro_rules! assert_rates {
    ($module:ident: $($value:ident $rate:ident),*) => {{
        let [before, here, after] = around($module::Machine::new().start_with(Dop853::new(1e-13)).unwrap());
        $(
            let quotient = (after.$value() - before.$value()) / (2.0 * H);
            let found = here.$rate();
            assert!(
                (quotient - found).abs() < TOLERANCE * (1.0 + found.abs()),
                "{} at {}: {found}, {quotient}", stringify!($rate), here.time()
            );
            assert!(found.abs() > 1e-3, "{} rests", stringify!($rate));
        )*
    }};
}

macro_rules! rates_of_joints {
    ($name:ident, $module:ident) => {
        #[test]
        fn $name() {
            assert_rates!($module:
                hinge_angle hinge_speed, hinge_speed hinge_acceleration,
                rail_displacement rail_speed, rail_speed rail_acceleration,
                guide_displacement guide_speed, guide_speed guide_acceleration,
                slot_displacement slot_speed, slot_speed slot_acceleration,
                slot_angle slot_rotary_speed, slot_rotary_speed slot_rotary_acceleration,
                ram_length ram_speed, ram_speed ram_acceleration
            );
        }
    };
}

rates_of_joints!(rates_of_joints_are_difference_quotients, joint_coordinates);
rates_of_joints!(rates_of_joints_are_difference_quotients_in_absolute_coordinates, absolute);

/// The port of the ground is where it is declared, and moves so.
#[test]
fn the_ground_shows_its_ports() {
    let mut sim = joint_coordinates::Machine::new().start().unwrap();
    sim.step(0.4).unwrap();
    let (sin, cos) = (3.0 * sim.time()).sin_cos();
    let expected = [[1.0, 0.1 * sin], [0.0, 0.3 * cos], [0.0, -0.9 * sin]];
    let found =
        [sim.ground_shaker_position(), sim.ground_shaker_velocity(), sim.ground_shaker_acceleration()];
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-15, "{found} {expected}");
    }
    assert_eq!(sim.ground_shaker_angle(), 20_f64.to_radians());
}

/// The node inside a joint shows what acts on it, and the angle of the joint.
#[test]
fn nodes_of_joints_are_observed() {
    let sim = joint_coordinates::Machine::new().start().unwrap();
    assert_eq!(sim.hinge_shaft_angle(), sim.hinge_angle());
    assert_eq!(sim.hinge_shaft_torque(), 0.0);
    assert_eq!(sim.rail_slider_position(), sim.rail_displacement());
}

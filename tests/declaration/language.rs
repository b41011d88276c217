//! What the language says, seen in what runs.

mod drawing {
    plm::mechanism! {
        /// Example 4 of the manual, section 4.3.5: drawn at 20 deg, started at 45 deg.
        pub Drawn {
            gravity: 9.81 m/s^2;
            ground { port o: (0, 0) m; }
            body beam {
                coordinates: absolute;
                drawing_angle: 20 deg;
                mass: 100 kg;
                inertia: 0.01 kg*m^2;
                centre: (0.5*cos(20 deg), 0.5*sin(20 deg)) m;
                port o: (0, 0) m;
                start angle: 45 deg, locked;
            }
            revolute hinge(ground.o, beam.o);
        }
    }
}

mod own_part {
    plm::mechanism! {
        /// A part of the user's own, and a chain by repetition.
        pub Rope {
            gravity: 9.81 m/s^2;
            param count_mass: kg = 0.2 kg;

            /// A torsional spring that stiffens.
            part stiffener(a: frame, b: frame) {
                param k: N*m/rad = 1 N*m/rad;
                let angle = b.angle - a.angle;
                torque on b from a: -k*angle*(1 + angle^2);
                output energy = k*(angle^2/2 + angle^4/4);
            }

            ground { port o: (0, 0) m; }
            repeat i in 0..5 {
                body bar[i] {
                    mass: count_mass;
                    inertia: 0.001 kg*m^2;
                    port a: (-0.1, 0) m;
                    port b: (0.1, 0) m;
                    start x: (0.1 + 0.2*i) * 1 m;
                }
            }
            revolute hook(ground.o, bar[0].a);
            repeat i in 1..5 {
                revolute pin[i](bar[i - 1].b, bar[i].a);
                stiffener spring[i](bar[i - 1].b, bar[i].a) { k: 2 N*m/rad; }
            }
            output hook.force, tip = bar[4].b.y, spring[4].energy;
        }
    }
}

mod first_order {
    plm::mechanism! {
        /// A lag of first order drives a crank.
        pub Lagged {
            input target: N*m = 1 N*m;
            param tau: s = 0.5 s;
            state torque: N*m = 0;
            rate torque = (target - torque) / tau;
            ground { port o: (0, 0) m; }
            body crank { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start angle: 0, locked; }
            revolute bearing(ground.o, crank.o) { drive: torque; }
        }
    }
}

mod taken {
    plm::mechanism! {
        /// Outputs that are called like what the generated code has for itself.
        pub Taken {
            ground { port o: (0, 0) m; }
            body wheel { mass: 1 kg; inertia: 2 kg*m^2; port o: (0, 0) m; start angle: 1 rad, locked; }
            revolute bearing(ground.o, wheel.o);
            output pose = wheel.angle, absolute = 2*wheel.angle, solved = 3*wheel.angle;
        }
    }
}

mod required {
    plm::mechanism! {
        /// A spring whose stiffness must be said, and a length that follows from one that must be.
        pub Spring {
            param stiffness: N/m;
            param damping: N*s/m = 0;
            param reach: m;
            param start_at: m = 0.5*reach;
            ground { port o: (0, 0) m; }
            body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: start_at, locked; }
            prismatic rail(ground.o, block.o) { stiffness: stiffness; damping: damping; }
        }
    }
}

#[test]
fn a_parameter_without_a_default_is_asked_for() {
    let spring = required::Spring { damping: 0.0, ..required::Spring::new(200.0, 0.4) };
    let mut sim = spring.start_with(plm::Dop853::new(1e-12)).unwrap();
    assert_eq!(sim.block().x, 0.2);
    // Half a period of x'' = -(k/m) x later.
    sim.step(std::f64::consts::PI / 10.0).unwrap();
    assert!((sim.block().x + 0.2).abs() < 1e-10, "{}", sim.block().x);
    let single = required::Spring::<f32>::of(200.0, 0.4);
    assert_eq!((single.stiffness, single.start_at), (200.0, 0.2));
}

#[test]
fn outputs_may_be_called_like_what_the_generated_code_has_for_itself() {
    let sim = taken::Taken::new().start().unwrap();
    assert_eq!(sim.outputs(), [1.0, 2.0, 3.0]);
    assert_eq!([sim.pose(), sim.absolute(), sim.solved()], [1.0, 2.0, 3.0]);
}

#[test]
fn drawing_coordinates_place_the_body_as_the_manual_says() {
    let found = drawing::Drawn::new().assemble().unwrap();
    let h = 0.5 * std::f64::consts::FRAC_1_SQRT_2;
    let expected = [h, h, 45.0_f64.to_radians()];
    for (value, expected) in found.q.iter().zip(expected) {
        assert!((value - expected).abs() < 1e-15, "{:?}", found.q);
    }
}

#[test]
fn parts_of_the_users_own_act_and_tell() {
    let mut sim = own_part::Rope::new().start_with(plm::Dop853::new(1e-11)).unwrap();
    // Spring energy of all pins is part of the balance; here only the last is an output, so the springs' power counts.
    let before = sim.kinetic_energy() + sim.gravity_energy();
    let mut work: f64 = 0.0;
    for _ in 0..400 {
        let start = sim.load_power();
        sim.step(5e-4).unwrap();
        let middle = sim.load_power();
        sim.step(5e-4).unwrap();
        work += 1e-3 / 6.0 * (start + 4.0 * middle + sim.load_power());
    }
    let gained = sim.kinetic_energy() + sim.gravity_energy() - before;
    assert!((gained - work).abs() < 1e-9, "{gained} {work}");
    assert!(sim.tip() < -0.05 && sim.spring_4_energy() > 0.0);
}

#[test]
fn parameters_change_between_runs_without_compiling() {
    let light = own_part::Rope::new().start().unwrap().hook_force();
    let heavy = own_part::Rope { count_mass: 0.4, ..own_part::Rope::new() }.start().unwrap().hook_force();
    assert!(heavy[1].abs() > 1.2 * light[1].abs(), "{light:?} {heavy:?}");
}

#[test]
fn states_follow_their_rates() {
    let mut sim = first_order::Lagged::new().start_with(plm::Dop853::new(1e-11)).unwrap();
    sim.step(1.0).unwrap();
    // torque = 1 - exp(-t/tau), omega its integral over J = 1 kg m^2.
    let expected = 1.0 - 0.5 * (1.0 - (-2.0_f64).exp());
    assert!((sim.crank().omega - expected).abs() < 1e-9, "{} {expected}", sim.crank().omega);
}

plm::parts! {
    pub dampers {
        /// A damper that grows with the square of the speed.
        part quadratic_damper(a: frame, b: frame) {
            param drag: N*m*s^2/rad^2 = 1 N*m*s^2/rad^2;
            let speed = rate(b.angle - a.angle);
            torque on b from a: -drag*speed*abs(speed);
        }
    }
}

plm::parts! {
    pub(crate) springs {
        part soft_spring(a: frame, b: frame) {
            param k: N*m/rad;
            torque on b from a: -k*sin(b.angle - a.angle);
        }
    }
}

mod shared {
    plm::mechanism! {
        use super::dampers;
        use crate::language::springs;
        /// A wheel that a shared damper slows down.
        pub Wheel {
            allow(W0006);
            ground { port o: (0, 0) m; }
            body wheel { mass: 1 kg; inertia: 2 kg*m^2; port o: (0, 0) m; start angle: 0, locked; start omega: 3 rad/s, locked; }
            revolute bearing(ground.o, wheel.o);
            quadratic_damper drag(ground.o, wheel.o) { drag: 4 N*m*s^2/rad^2; }
            soft_spring spring(ground.o, wheel.o) { k: 0; }
        }
    }
}

mod from_another_crate {
    plm::mechanism! {
        use plm_shared_parts::thermal;
        /// A brake that warms two blocks: a domain and its parts from another crate.
        pub Brake {
            ground { port o: (0, 0) m; }
            part lining(a: frame, b: frame, hot: heat) {
                param drag: N*m*s/rad;
                let speed = rate(b.angle - a.angle);
                torque on b from a: -drag*speed;
                power on hot: drag*speed^2;
            }
            body wheel { mass: 1 kg; inertia: 2 kg*m^2; port o: (0, 0) m; start omega: 30 rad/s, locked; }
            revolute bearing(ground.o, wheel.o);
            block disc() { capacity: 40 J/K; temperature: 300 K; }
            block calliper() { capacity: 60 J/K; temperature: 300 K; }
            contact joint(disc.port, calliper.port) { conductance: 200 W/K; }
            lining pad(ground.o, wheel.o, disc.port) { drag: 4 N*m*s/rad; }
            output disc.temperature, calliper.temperature;
        }
    }
}

/// What the wheel loses the blocks gain, and in the end they have one temperature.
#[test]
fn domains_and_parts_cross_crates() {
    let mut sim = from_another_crate::Brake::new().start_with(plm::Dop853::new(1e-11)).unwrap();
    sim.step(10.0).unwrap();
    let gained = 40.0 * (sim.disc_temperature() - 300.0) + 60.0 * (sim.calliper_temperature() - 300.0);
    assert!((gained - 900.0).abs() < 1e-6, "{gained}");
    assert!((sim.disc_temperature() - sim.calliper_temperature()).abs() < 1e-6);
    assert!((sim.disc_temperature() - 309.0).abs() < 1e-6);
}

#[test]
fn shared_parts_act_as_if_they_stood_inside() {
    let mut sim = shared::Wheel::new().start_with(plm::Dop853::new(1e-11)).unwrap();
    sim.step(1.0).unwrap();
    // omega' = -2 omega^2: omega = 3/(1 + 6 t).
    assert!((sim.wheel().omega - 3.0 / 7.0).abs() < 1e-9, "{}", sim.wheel().omega);
}

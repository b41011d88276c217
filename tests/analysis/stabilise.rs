//! Equilibria against statics: the manual's figures, hand calculations, and what must be told where there is none.

use plm::{Equilibrium, Stabilise, What};

/// The manual's 3.1: 20 kg on a spring of 10000 N/m that is free at 1 m. `$spring` is the spring of the guide, or one more.
macro_rules! prismatic_joint {
    ($module:ident, { $($spring:tt)* }, { $($more:tt)* }) => {
        mod $module {
            plm::mechanism! {
                pub System {
                    gravity: 9.81 m/s^2;
                    ground { port rail: (0, 0) m, axis: 90 deg; }
                    body mass {
                        mass: 20 kg;
                        inertia: 1 kg*m^2;
                        port rail: (0, -0.5) m, angle: 90 deg;
                        start y: 1 m, locked;
                    }
                    prismatic guide(ground.rail, mass.rail) { $($spring)* }
                    $($more)*
                }
            }
        }
    };
}

prismatic_joint!(one, { stiffness: 10000 N/m; damping: 197.98 N/(m/s); free_length: 0.5 m; }, {});
prismatic_joint!(two, { damping: 197.98 N/(m/s); drive: push; }, {
    state push: N = 0;
    rate push = -10000 N/m*guide.speed;
});
prismatic_joint!(three, { damping: 197.98 N/(m/s); drive: 10000 N/m*(0.5 m - guide.displacement); }, {});

fn value<M>(found: &Equilibrium<M>, name: &str) -> f64 {
    found.values.iter().find(|change| change.name == name).unwrap().value
}

fn assert_close(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance * want.abs().max(1.0), "{got} is not {want}");
}

/// A lock is named with the force that it has to give.
#[track_caller]
fn assert_needs<M>(found: &Equilibrium<M>, name: &str, force: f64) {
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), (name, What::Lock));
    assert_close(residual.value, force, 1e-9);
}

#[test]
fn a_locked_height_names_the_force_that_it_needs() {
    let (one, three) = (one::System::new().stabilise().unwrap(), three::System::new().stabilise().unwrap());
    for (found, height) in
        [(&one.residuals, value(&one, "mass.y")), (&three.residuals, value(&three, "mass.y"))]
    {
        let [residual] = &found[..] else { panic!("{found:?}") };
        assert_eq!((residual.name.as_str(), residual.what), ("mass.y", What::Lock));
        assert_close(residual.value, 196.2, 1e-9);
        assert_eq!(height, 1.0);
    }
    let told = one.balanced().unwrap_err().to_string();
    assert_eq!(told, "no equilibrium: mass.y is locked and needs 196.200 N to stay");
}

#[test]
fn a_spring_with_a_state_takes_the_load_where_the_height_is_locked() {
    let found = two::System::new().stabilise().unwrap().balanced().unwrap();
    assert_eq!(value(&found, "mass.y"), 1.0);
    assert_close(value(&found, "push"), 196.2, 1e-12);
    assert!(found.free.is_empty());
}

#[test]
fn all_three_systems_hang_equally_low_where_the_height_is_free() {
    let (mut one, mut two, mut three) = (one::System::new(), two::System::new(), three::System::new());
    one.start.mass.y.locked = false;
    two.start.mass.y.locked = false;
    three.start.mass.y.locked = false;
    let heights = [
        value(&one.stabilise().unwrap().balanced().unwrap(), "mass.y"),
        value(&two.stabilise().unwrap().balanced().unwrap(), "mass.y"),
        value(&three.stabilise().unwrap().balanced().unwrap(), "mass.y"),
    ];
    for height in heights {
        assert_close(height, 0.98038, 1e-12);
    }
    // It stays where it was put.
    let mut sim = two.stabilise().unwrap().start().unwrap();
    sim.step(1.0).unwrap();
    // To the tolerance of the run, 1e-8 of a force of 196 N.
    assert_close(sim.mass().y, 0.98038, 1e-9);
    assert!(sim.mass().vy.abs() < 1e-9);
}

mod hydraulic {
    plm::mechanism! {
        /// The manual's 3.2.1: an arm on a jack with two chambers, each with a line to a closed valve.
        pub Arm {
            gravity: 9.81 m/s^2;
            param bore: m^2 = pi/4*(0.05 m)^2;
            param annulus: m^2 = pi/4*((0.05 m)^2 - (0.03 m)^2);
            param bulk: Pa = 17000 bar;
            param conductance: m^3/s/Pa = 1e-9 m^3/s/Pa;
            ground { port o: (0, 0) m; port foot: (0, -0.25) m; }
            body arm {
                mass: 100 kg;
                inertia: 10 kg*m^2;
                port tip: (0.2, 0) m;
                port jack: (-0.5, 0) m;
                port pivot: (-0.8, 0) m;
                start angle: 20 deg, locked;
            }
            revolute pivot(ground.o, arm.pivot);
            jack ram(ground.foot, arm.jack) { free_length: 0.22 m; drive: p1*bore - p2*annulus; }
            state p1: Pa = 0;
            state p2: Pa = 5 bar;
            state line1: Pa = 0;
            state line2: Pa = 0;
            let q1 = conductance*(line1 - p1);
            let q2 = conductance*(line2 - p2);
            rate p1 = bulk/(50e-6 m^3 + bore*ram.displacement)*(q1 - bore*ram.speed);
            rate p2 = bulk/(50e-6 m^3 + annulus*(0.35 m - ram.displacement))*(q2 + annulus*ram.speed);
            rate line1 = -bulk/0.5e-3 m^3*q1;
            rate line2 = -bulk/0.5e-3 m^3*q2;
            output ram.force, ram.displacement;
        }
    }
}

#[test]
fn one_locked_pressure_settles_the_others() {
    let mut arm = hydraulic::Arm::new();
    arm.start.p2.locked = true;
    let found = arm.stabilise().unwrap().balanced().unwrap();
    // tests/manual/numbers.json, ConnectPlmHyd: "p1", "F jack", exact.
    assert_close(value(&found, "p1") / 1e5, 27.258_755_030_885_03, 1e-10);
    assert_close(value(&found, "line1"), value(&found, "p1"), 1e-12);
    assert_eq!(value(&found, "p2"), 5e5);
    assert_close(value(&found, "line2"), 5e5, 1e-12);
    assert!(found.free.is_empty(), "{:?}", found.free);
    let mut sim = found.start().unwrap();
    assert_close(sim.ram_force(), 4_723.925_503_721_555, 1e-10);
    let angle = sim.arm().angle;
    sim.step(0.5).unwrap();
    assert_close(sim.arm().angle, angle, 1e-10);
}

#[test]
fn pressures_that_can_be_elsewhere_are_named() {
    let found = hydraulic::Arm::new().stabilise().unwrap().balanced().unwrap();
    let [freedom] = &found.free[..] else { panic!("{:?}", found.free) };
    assert_eq!((freedom.count, &freedom.names[..]), (1, &["p1", "p2", "line1", "line2"][..]));
    assert_eq!(freedom.to_string(), "lock one of p1, p2, line1, line2");
    // Nearest: from (0, 5, 0, 0) bar to a p1 - b p2 = F with the lines alike, min 2 (p1)^2 + (p2 - 5)^2 + p2^2.
    let (bore, annulus, force) =
        (0.05_f64.powi(2), 0.05_f64.powi(2) - 0.03_f64.powi(2), 4_723.925_503_721_555);
    let quarter = core::f64::consts::FRAC_PI_4;
    let (a, b) = (quarter * bore * 1e5, quarter * annulus * 1e5);
    let multiplier = (force + 2.5 * b) / (a * a + b * b);
    assert_close(value(&found, "p1") / 1e5, a * multiplier, 1e-9);
    assert_close(value(&found, "p2") / 1e5, 2.5 - b * multiplier, 1e-9);
}

mod leak {
    plm::mechanism! {
        /// A tank whose oil runs through a chamber to where there is no pressure.
        pub Leak {
            ground { port o: (0, 0) m; }
            body wheel { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
            revolute o(ground.o, wheel.o) { stiffness: 10 N*m/rad; rest: 0.2 rad; }
            state tank: Pa = 6 bar;
            state chamber: Pa = 0;
            rate tank = (chamber - tank)*3/1 s;
            rate chamber = (5*(tank - chamber) - 10*chamber)/1 s;
        }
    }
}

#[test]
fn a_locked_pressure_that_leaks_names_its_rate() {
    let mut leak = leak::Leak::new();
    leak.start.tank.locked = true;
    let found = leak.stabilise().unwrap();
    // Of 6 bar a third is left: 5 (6 - p) = 10 p.
    assert_close(value(&found, "chamber"), 2e5, 1e-12);
    assert_close(value(&found, "wheel.angle"), 0.2, 1e-12);
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), ("tank", What::LockedState));
    assert_close(residual.value, -12e5, 1e-12);
    // Without the lock it runs dry.
    let dry = leak::Leak::new().stabilise().unwrap().balanced().unwrap();
    assert!(value(&dry, "tank").abs() < 1e-6 && value(&dry, "chamber").abs() < 1e-6);
}

mod hanging {
    plm::mechanism! {
        /// A mass hangs on a mass that is locked.
        pub Hanging {
            gravity: 9.81 m/s^2;
            ground { port rail: (0, 0) m, axis: 90 deg; }
            body upper { mass: 2 kg; inertia: 1 kg*m^2; port rail: (0, 0) m, angle: 90 deg; start y: -1 m, locked; }
            body lower { mass: 3 kg; inertia: 1 kg*m^2; port rail: (0, 0) m, angle: 90 deg; start y: -2 m; }
            prismatic ceiling(ground.rail, upper.rail) { stiffness: 50 N/m; free_length: -0.6 m; }
            prismatic between(upper.rail, lower.rail) { stiffness: 400 N/m; free_length: -0.5 m; }
        }
    }
}

#[test]
fn what_is_free_rests_whatever_a_lock_needs() {
    let found = hanging::Hanging::new().stabilise().unwrap();
    assert_close(value(&found, "lower.y"), -1.5 - 3.0 * 9.81 / 400.0, 1e-12);
    // Both weights, less what the upper spring holds.
    assert_needs(&found, "upper.y", 5.0 * 9.81 - 50.0 * 0.4);
}

mod column {
    plm::mechanism! {
        /// A mass on a column of oil: p' = -B s'/s.
        pub Column {
            gravity: 9.81 m/s^2;
            param area: m^2 = 1e-3 m^2;
            param bulk: Pa = 20 bar;
            ground { port rail: (0, 0) m, axis: 90 deg; }
            body mass { mass: 200 kg; inertia: 1 kg*m^2; port rail: (0, 0) m, angle: 90 deg; start y: 0.8 m; }
            prismatic guide(ground.rail, mass.rail) { drive: pressure*area; }
            state pressure: Pa = 3 bar;
            rate pressure = -bulk*guide.speed/guide.displacement;
        }
    }
}

#[test]
fn a_closed_chamber_is_compressed_from_where_it_was() {
    let found = column::Column::new().stabilise().unwrap().balanced().unwrap();
    let pressure = 200.0 * 9.81 / 1e-3;
    assert_close(value(&found, "pressure"), pressure, 1e-9);
    // p - p0 = B ln(s0/s), whatever the way.
    assert_close(value(&found, "mass.y"), 0.8 * f64::exp(-(pressure - 3e5) / 20e5), 1e-9);
    assert!(found.free.is_empty());
}

mod pendulum {
    plm::mechanism! {
        pub Pendulum {
            gravity: 9.81 m/s^2;
            param torque: N*m = 0 N*m;
            ground { port o: (0, 0) m; }
            body bob { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (0, 0.5) m; start angle: 30 deg; }
            revolute o(ground.o, bob.o) { drive: torque; }
        }
    }
}

#[test]
fn a_pendulum_comes_to_hang() {
    let mut pendulum = pendulum::Pendulum::new();
    let hanging = pendulum.stabilise().unwrap().balanced().unwrap();
    assert!(value(&hanging, "bob.angle").abs() < 1e-12);
    // Held level, where no step helps because the moment is greatest.
    pendulum.start.bob.angle.value = core::f64::consts::FRAC_PI_2;
    pendulum.start.bob.x.value = 0.5;
    pendulum.start.bob.y.value = 0.0;
    let hanging = pendulum.stabilise().unwrap().balanced().unwrap();
    assert!(value(&hanging, "bob.angle").abs() < 1e-12, "{hanging}");
    // Against a torque: sin(angle) = T / (m g l); 12 N m are more than it can hold.
    let held = pendulum::Pendulum { torque: 6.0, ..pendulum::Pendulum::new() }
        .stabilise()
        .unwrap()
        .balanced()
        .unwrap();
    assert_close(value(&held, "bob.angle"), f64::asin(6.0 / 9.81), 1e-12);
    let lost = pendulum::Pendulum { torque: 12.0, ..pendulum::Pendulum::new() }.stabilise().unwrap();
    assert_eq!(lost.residuals.len(), 1);
    assert_eq!((lost.residuals[0].name.as_str(), lost.residuals[0].what), ("bob.angle", What::Force));
}

mod shaft {
    plm::mechanism! {
        /// The manual's PLMPIV10: 1000 N m against 1 N m/(rev/min).
        pub Shaft {
            ground { port o: (0, 0) m; }
            body disc { mass: 10 kg; inertia: 0.0125 kg*m^2; port o: (0.001, 0) m; }
            revolute bearing(ground.o, disc.o) { damping: 1 N*m/(rev/min); drive: 1000 N*m; }
        }
    }
}

#[test]
fn a_steady_rotation_is_told() {
    let found = shaft::Shaft::new().stabilise().unwrap();
    assert_eq!(
        found.balanced().unwrap_err().to_string(),
        "no equilibrium: disc.angle moves: nothing balances 1000.00 N*m"
    );
}

mod crank {
    plm::mechanism! {
        pub Crank {
            ground { port o: (0, 0) m; }
            body crank { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
            joint motor(a: frame, b: frame) {
                constraint angle: b.angle - a.angle - 3 rad/s*t = 0;
            }
            revolute o(ground.o, crank.o);
            motor drive(ground.o, crank.o);
        }
    }
}

#[test]
fn prescribed_motions_are_told() {
    let found = crank::Crank::new().stabilise().unwrap();
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), ("drive.angle", What::Motion));
    assert_close(residual.value, 3.0, 1e-12);
}

#[test]
fn a_loop_with_a_spring_rests_on_every_rung() {
    macro_rules! four_bar {
        ($module:ident, { $($rung:tt)* }) => {
            mod $module {
                plm::mechanism! {
                    pub FourBar {
                        $($rung)*
                        gravity: 9.81 m/s^2;
                        ground { port a: (0, 0) m; port d: (1, 0) m; }
                        body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.2, 0) m; port b: (0.2, 0) m; start angle: 70 deg, locked; }
                        body coupler { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-0.5, 0) m; port c: (0.5, 0) m; start angle: 15 deg; }
                        body follower { mass: 1 kg; inertia: 0.05 kg*m^2; port c: (0.4, 0) m; port d: (-0.4, 0) m; start angle: 70 deg; }
                        revolute a(ground.a, crank.a) { stiffness: 30 N*m/rad; rest: 50 deg; }
                        revolute b(crank.b, coupler.b);
                        revolute c(coupler.c, follower.c);
                        revolute d(ground.d, follower.d);
                        output a.angle;
                    }
                }
            }
        };
    }
    four_bar!(least, {});
    four_bar!(absolute, { rung: absolute; });
    let (mut one, mut other) = (least::FourBar::new(), absolute::FourBar::new());
    one.start.crank.angle.locked = false;
    other.start.crank.angle.locked = false;
    let (one, other) =
        (one.stabilise().unwrap().balanced().unwrap(), other.stabilise().unwrap().balanced().unwrap());
    assert_close(value(&one, "crank.angle"), value(&other, "crank.angle"), 1e-12);
    // Neither gravity nor the spring gains anything there: their energy is stationary along the loop.
    let energy = |crank: f64| {
        let mut at = least::FourBar::new();
        at.start.crank.angle.value = crank;
        at.start.coupler.angle.value = value(&one, "coupler.angle");
        at.start.follower.angle.value = value(&one, "follower.angle");
        let sim = at.start().unwrap();
        sim.gravity_energy() + 15.0 * (crank - 50_f64.to_radians()).powi(2)
    };
    let (crank, h) = (value(&one, "crank.angle"), 1e-4);
    assert!((energy(crank + h) - energy(crank - h)).abs() / (2.0 * h) < 1e-6);
    // Locked, it needs the torque that the energy asks for.
    let found = least::FourBar::new().stabilise().unwrap();
    let locked = 70_f64.to_radians();
    assert_needs_near(&found, "crank.angle", (energy(locked + h) - energy(locked - h)) / (2.0 * h));
}

/// As a difference quotient tells it.
#[track_caller]
fn assert_needs_near<M>(found: &Equilibrium<M>, name: &str, force: f64) {
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), (name, What::Lock));
    assert_close(residual.value, force, 1e-6);
}

mod stop {
    plm::mechanism! {
        /// A mass falls on a stop that pushes from 0.1 m downwards, with 50 N as soon as it is touched.
        pub Stop {
            gravity: 10 m/s^2;
            ground { port rail: (0, 0) m, axis: 90 deg; }
            body mass { mass: 20 kg; inertia: 1 kg*m^2; port rail: (0, 0) m, angle: 90 deg; start y: 0.5 m; }
            prismatic guide(ground.rail, mass.rail) {
                stiffness: 100 N/m;
                drive: if guide.displacement < 0.1 m then 50 N + 1e4 N/m*(0.1 m - guide.displacement) else 0 N;
            }
        }
    }
}

#[test]
fn conditions_take_the_side_of_the_equilibrium() {
    let found = stop::Stop::new().stabilise().unwrap().balanced().unwrap();
    // 200 N = 50 N + 1e4 N/m (0.1 m - y) - 100 N/m y.
    assert_close(value(&found, "mass.y"), (50.0 + 1000.0 - 200.0) / 10_100.0, 1e-12);
}

mod servo {
    plm::mechanism! {
        /// A servo that pushes back a share of what its guide carries.
        pub Servo {
            gravity: 9.81 m/s^2;
            ground { port rail: (0, 0) m, axis: 90 deg; port wall: (0, 0) m; }
            body mass { mass: 4 kg; inertia: 1 kg*m^2; port rail: (0, 0) m, angle: 90 deg; port side: (0, 0) m; start y: 0.3 m; }
            prismatic guide(ground.rail, mass.rail) { stiffness: 1000 N/m; drive: 0.25*guide.force.x; }
            force side(mass.side) { x: 40 N; }
        }
    }
}

#[test]
fn reactions_that_forces_read_are_balanced_with_them() {
    let found = servo::Servo::new().stabilise().unwrap().balanced().unwrap();
    // What the guide does to the ground's side is what pushes the mass against it.
    let height = value(&found, "mass.y");
    let pushed = (0.25 * 40.0 - 4.0 * 9.81) / 1000.0;
    assert_close(height, pushed, 1e-9);
}

mod parallelogram {
    plm::mechanism! {
        /// Three parallel cranks: one constraint says what others say. A weight hangs on the bar.
        pub Parallelogram {
            allow(W0001);
            gravity: 9.81 m/s^2;
            ground { port a: (0, 0) m; port b: (1, 0) m; port c: (2, 0) m; }
            body first { mass: 1 kg; inertia: 0.1 kg*m^2; port foot: (0, 0) m; port head: (0, 0.5) m; start angle: 20 deg; }
            body second { mass: 1 kg; inertia: 0.1 kg*m^2; port foot: (0, 0) m; port head: (0, 0.5) m; start x: 1 m; start angle: 20 deg; }
            body third { mass: 1 kg; inertia: 0.1 kg*m^2; port foot: (0, 0) m; port head: (0, 0.5) m; start x: 2 m; start angle: 20 deg; }
            body bar { mass: 4 kg; inertia: 1 kg*m^2; port a: (-1, 0) m; port b: (0, 0) m; port c: (1, 0) m; start x: 1 m; start y: 0.5 m; }
            revolute a(ground.a, first.foot) { stiffness: 50 N*m/rad; }
            revolute b(ground.b, second.foot);
            revolute c(ground.c, third.foot);
            revolute d(first.head, bar.a);
            revolute e(second.head, bar.b);
            revolute f(third.head, bar.c);
        }
    }
}

#[test]
fn redundant_joints_rest_too() {
    let found = parallelogram::Parallelogram::new().stabilise().unwrap().balanced().unwrap();
    // The spring is stronger than the weight upright: 50 > m g l.
    assert!(value(&found, "first.angle").abs() < 1e-10, "{found}");
    assert!(found.free.is_empty());
    // Weaker, it gives way until k a = m g l sin a.
    let mut heavy = parallelogram::Parallelogram::new();
    heavy.start.first.angle.locked = true;
    let found = heavy.stabilise().unwrap();
    let angle = 20_f64.to_radians();
    assert_needs(&found, "first.angle", 50.0 * angle - 4.0 * 9.81 * 0.5 * angle.sin());
}

mod double_arm {
    plm::mechanism! {
        /// The manual's 3.3: an arm on a jack, and a second one that slides on it, held by another jack.
        pub DoubleArm {
            gravity: 9.81 m/s^2;
            param bore: m^2 = pi/4*(0.05 m)^2;
            param annulus: m^2 = pi/4*((0.05 m)^2 - (0.03 m)^2);
            ground { port o: (0, 0) m; port foot: (0, -0.25) m; }
            /// A jack's two chambers, each closed by a narrow gap.
            part chambers(on: slider) {
                param bore: m^2;
                param annulus: m^2;
                state p1: Pa = 0;
                state p2: Pa = 5 bar;
                state line1: Pa = 0;
                state line2: Pa = 0;
                rate p1 = (line1 - p1)/1e-3 s - 3e10 Pa/m*rate(on.position);
                rate p2 = (line2 - p2)/1e-3 s + 2e10 Pa/m*rate(on.position);
                rate line1 = (p1 - line1)/2e-3 s;
                rate line2 = (p2 - line2)/2e-3 s;
                force on on: p1*bore - p2*annulus;
            }
            body arm {
                mass: 100 kg;
                inertia: 10 kg*m^2;
                port pivot: (-0.4, 0) m;
                port jack: (-0.1, 0) m;
                port rail: (0, 0) m;
                start angle: 20 deg, locked;
            }
            body boom {
                mass: 100 kg;
                inertia: 10 kg*m^2;
                port rail: (0, 0) m;
                start x: 0.9 m, locked;
                start angle: 20 deg;
            }
            revolute pivot(ground.o, arm.pivot);
            prismatic rail(arm.rail, boom.rail);
            jack lift(ground.foot, arm.jack);
            chambers below(lift.slider) { bore: bore; annulus: annulus; p2: 5 bar, locked; }
            chambers inside(rail.slider) { bore: bore; annulus: annulus; p2: 5 bar, locked; }
            output lift.force, rail.drive_force;
        }
    }
}

#[test]
fn the_double_arm_has_the_pressures_of_the_manual() {
    let found = double_arm::DoubleArm::new().stabilise().unwrap().balanced().unwrap();
    assert!(found.free.is_empty(), "{:?}", found.free);
    // tests/manual/numbers.json, DoubleArm: exact values at 9.81 m/s^2.
    assert_close(value(&found, "below.p1") / 1e5, 44.032_518_894_917_23, 1e-9);
    assert_close(value(&found, "inside.p1") / 1e5, 4.908_798_294_872_963, 1e-9);
    let sim = found.start().unwrap();
    assert_close(sim.rail_drive_force(), 335.521_760_602_479, 1e-9);
    assert!((sim.lift_force() - 8017.446).abs() < 1e-3);
    // The printed force belongs to g = 9.80665.
    let share = 9.80665 / 9.81;
    assert_close(sim.lift_force() * share, 8_014.708_472_802_279, 1e-9);
}

mod chain {
    plm::mechanism! {
        pub Chain {
            gravity: 9.81 m/s^2;
            ground { port o: (0, 0) m; }
            repeat i in 0..3 {
                body bar[i] { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0.5) m; port b: (0, -0.5) m; }
            }
            revolute first(ground.o, bar[0].a);
            revolute second(bar[0].b, bar[1].a);
            revolute third(bar[1].b, bar[2].a);
        }
    }
}

#[test]
fn a_chain_rests_in_line_from_wherever_it_starts() {
    for start in [[0.5, -0.4, 0.3], [1.5, 1.4, 1.6], [2.0, -1.0, 0.5], [-3.0, 2.0, 1.0]] {
        let mut chain = chain::Chain::new();
        let mut hinge = [0.0, 0.0];
        for (bar, angle) in
            [&mut chain.start.bar_0, &mut chain.start.bar_1, &mut chain.start.bar_2].into_iter().zip(start)
        {
            // From the hinge to the middle of the bar.
            let (sin, cos) = f64::sin_cos(angle);
            (bar.angle.value, bar.x.value, bar.y.value) = (angle, hinge[0] + 0.5 * sin, hinge[1] - 0.5 * cos);
            hinge = [hinge[0] + sin, hinge[1] - cos];
        }
        let found = chain.stabilise().unwrap().balanced().unwrap();
        for angle in ["bar[0].angle", "bar[1].angle", "bar[2].angle"] {
            assert!(value(&found, angle).sin().abs() < 1e-10, "{start:?} {found}");
        }
    }
}

mod loose {
    plm::mechanism! {
        pub Loose {
            gravity: 9.81 m/s^2;
            allow(W0002);
            ground { port o: (0, 0) m; }
            body stone { mass: 3 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; }
            body bob { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0.5) m; }
            revolute o(ground.o, bob.o);
        }
    }
}

#[test]
fn what_falls_is_told() {
    let found = loose::Loose::new().stabilise().unwrap();
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), ("stone.y", What::Force));
    assert_close(residual.value, -3.0 * 9.81, 1e-9);
}

//! Equilibria of bodies and springs against statics: the manual's figures, hand calculations, and what must be told where there
//! is none.

use plm::{Equilibrium, Stabilise, What};

use crate::scene::{Given as _, Named as _};

/// The manual's 3.1: 20 kg on a spring of 10000 N/m that is free at 1 m. `$spring` is the spring of the guide, or one more.
macro_rules! prismatic_joint {
    ($module:ident, { $($spring:tt)* }, { $($more:tt)* }) => {
        mod $module {
            scene! {
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

pub(super) fn value<M: Stabilise>(found: &Equilibrium<M>, name: &str) -> f64 {
    found.values.iter().find(|change| change.name == name).unwrap().value
}

pub(super) fn assert_close(got: f64, want: f64, tolerance: f64) {
    assert!((got - want).abs() <= tolerance * want.abs().max(1.0), "{got} is not {want}");
}

/// A lock is named with the force that it has to give.
#[track_caller]
pub(super) fn assert_needs<M: Stabilise>(found: &Equilibrium<M>, name: &str, force: f64) {
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
    let [one, two, three] = [one::System::new(), two::System::new(), three::System::new()]
        .map(|system| system.released("mass.y"));
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
    assert_close(sim.state_of("mass").y, 0.98038, 1e-9);
    assert!(sim.state_of("mass").vy.abs() < 1e-9);
}

scene! {
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

#[test]
fn what_is_free_rests_whatever_a_lock_needs() {
    let found = Hanging::new().stabilise().unwrap();
    assert_close(value(&found, "lower.y"), -1.5 - 3.0 * 9.81 / 400.0, 1e-12);
    // Both weights, less what the upper spring holds.
    assert_needs(&found, "upper.y", 5.0 * 9.81 - 50.0 * 0.4);
}

scene! {
    pub Pendulum {
        gravity: 9.81 m/s^2;
        param torque: N*m = 0 N*m;
        ground { port o: (0, 0) m; }
        body bob { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (0, 0.5) m; start angle: 30 deg; }
        revolute o(ground.o, bob.o) { drive: torque; }
    }
}

#[test]
fn a_pendulum_comes_to_hang() {
    let pendulum = Pendulum::new();
    let hanging = pendulum.stabilise().unwrap().balanced().unwrap();
    assert!(value(&hanging, "bob.angle").abs() < 1e-12);
    // Held level, where no step helps because the moment is greatest.
    let pendulum = pendulum
        .with_start("bob.angle", core::f64::consts::FRAC_PI_2)
        .with_start("bob.x", 0.5)
        .with_start("bob.y", 0.0);
    let hanging = pendulum.stabilise().unwrap().balanced().unwrap();
    assert!(value(&hanging, "bob.angle").abs() < 1e-12, "{hanging}");
    // Against a torque: sin(angle) = T / (m g l); 12 N m are more than it can hold.
    let held = Pendulum::new().with("torque", 6.0).stabilise().unwrap().balanced().unwrap();
    assert_close(value(&held, "bob.angle"), f64::asin(6.0 / 9.81), 1e-12);
    let lost = Pendulum::new().with("torque", 12.0).stabilise().unwrap();
    assert_eq!(lost.residuals.len(), 1);
    assert_eq!((lost.residuals[0].name.as_str(), lost.residuals[0].what), ("bob.angle", What::Force));
}

scene! {
    /// The manual's PLMPIV10: 1000 N m against 1 N m/(rev/min).
    pub Shaft {
        ground { port o: (0, 0) m; }
        body disc { mass: 10 kg; inertia: 0.0125 kg*m^2; port o: (0.001, 0) m; }
        revolute bearing(ground.o, disc.o) { damping: 1 N*m/(rev/min); drive: 1000 N*m; }
    }
}

#[test]
fn a_steady_rotation_is_told() {
    let found = Shaft::new().stabilise().unwrap();
    assert_eq!(
        found.balanced().unwrap_err().to_string(),
        "no equilibrium: disc.angle moves: nothing balances 1000.00 N*m"
    );
}

scene! {
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

#[test]
fn prescribed_motions_are_told() {
    let found = Crank::new().stabilise().unwrap();
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), ("drive.angle", What::Motion));
    assert_close(residual.value, 3.0, 1e-12);
}

scene! {
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

#[test]
fn conditions_take_the_side_of_the_equilibrium() {
    let found = Stop::new().stabilise().unwrap().balanced().unwrap();
    // 200 N = 50 N + 1e4 N/m (0.1 m - y) - 100 N/m y.
    assert_close(value(&found, "mass.y"), (50.0 + 1000.0 - 200.0) / 10_100.0, 1e-12);
}

scene! {
    /// A servo that pushes back a share of what its guide carries.
    pub Servo {
        gravity: 9.81 m/s^2;
        ground { port rail: (0, 0) m, axis: 90 deg; port wall: (0, 0) m; }
        body mass { mass: 4 kg; inertia: 1 kg*m^2; port rail: (0, 0) m, angle: 90 deg; port side: (0, 0) m; start y: 0.3 m; }
        prismatic guide(ground.rail, mass.rail) { stiffness: 1000 N/m; drive: 0.25*guide.force.x; }
        force side(mass.side) { x: 40 N; }
    }
}

#[test]
fn reactions_that_forces_read_are_balanced_with_them() {
    let found = Servo::new().stabilise().unwrap().balanced().unwrap();
    // What the guide does to the ground's side is what pushes the mass against it.
    let height = value(&found, "mass.y");
    let pushed = (0.25 * 40.0 - 4.0 * 9.81) / 1000.0;
    assert_close(height, pushed, 1e-9);
}

scene! {
    pub Loose {
        gravity: 9.81 m/s^2;
        allow(W0002);
        ground { port o: (0, 0) m; }
        body stone { mass: 3 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0.5) m; }
        revolute o(ground.o, bob.o);
    }
}

#[test]
fn what_falls_is_told() {
    let found = Loose::new().stabilise().unwrap();
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), ("stone.y", What::Force));
    assert_close(residual.value, -3.0 * 9.81, 1e-9);
}

scene! {
    /// A mass that nothing holds, above a stop that begins at 0.1 m.
    pub Landing {
        gravity: 10 m/s^2;
        param jump: N = 0 N;
        ground { port rail: (0, 0) m, axis: 90 deg; }
        body mass { mass: 20 kg; inertia: 1 kg*m^2; port rail: (0, 0) m, angle: 90 deg; start y: 0.5 m; }
        prismatic guide(ground.rail, mass.rail) {
            drive: if guide.displacement < 0.1 m then jump + 1e4 N/m*(0.1 m - guide.displacement) else 0 N;
        }
    }
}

#[test]
fn what_falls_is_followed_to_its_stop() {
    let found = Landing::new().stabilise().unwrap().balanced().unwrap();
    assert_close(value(&found, "mass.y"), 0.1 - 200.0 / 1e4, 1e-9);
    // A stop that pushes with more than the weight as soon as it is touched leaves no place to rest.
    let found = Landing::new().with("jump", 300.0).stabilise().unwrap();
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), ("mass.y", What::Force));
}

scene! {
    /// Systems 2 and 3 of section 3.1 side by side, with the springs of the library.
    pub Systems23 {
        gravity: 9.81 m/s^2;
        ground { port left: (0, 0) m, axis: 90 deg; port right: (1, 0) m, axis: 90 deg; }
        body second { mass: 20 kg; inertia: 0.01 kg*m^2; port foot: (-0.5, 0) m; start y: 1 m, locked; }
        body third { mass: 20 kg; inertia: 0.01 kg*m^2; port foot: (-0.5, 0) m; start x: 1 m; start y: 1 m, locked; }
        prismatic guide2(ground.left, second.foot);
        prismatic guide3(ground.right, third.foot);
        slider_ground floor();
        force_state_spring sd0000(floor.slider, guide2.slider) { stiffness: 10000 N/m; damping: 197.98 N/(m/s); }
        slider_spring sd000a(floor.slider, guide3.slider) {
            stiffness: 10000 N/m;
            damping: 197.98 N/(m/s);
            preload: 5000 N;
        }
        output sd0000.force, sd000a.force;
    }
}

#[test]
fn only_the_spring_with_a_force_state_keeps_its_height() {
    let mut systems = Systems23::new();
    let found = systems.stabilise().unwrap();
    assert_needs(&found, "third.y", 196.2);
    assert_eq!((value(&found, "second.y"), value(&found, "third.y")), (1.0, 1.0));
    let mut sim = found.start().unwrap();
    assert_close(sim.value_of("sd0000.force"), 196.2, 1e-9);
    // Locks hold at the start alone: the third falls to where the second would be with a spring of its kind.
    sim.step(6.0).unwrap();
    assert_close(sim.state_of("second").y, 1.0, 1e-8);
    assert_close(sim.state_of("third").y, 0.98038, 1e-7);
    systems = systems.released("second.y").released("third.y");
    let found = systems.stabilise().unwrap().balanced().unwrap();
    assert_close(value(&found, "second.y"), 0.98038, 1e-12);
    assert_close(value(&found, "third.y"), 0.98038, 1e-12);
}

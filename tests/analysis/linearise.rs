//! Declared mechanisms against their known frequencies and dampings, in every formulation that holds them.

use plm::{Linearisation, Mechanism as _, linearise};

use crate::scene::Given as _;

/// Linearises a declared mechanism at its start in both formulations.
macro_rules! at_start {
    ($module:ident) => {
        [
            linearise($module::least::Scene::new().start().unwrap().state()).unwrap(),
            linearise($module::absolute::Scene::new().start().unwrap().state()).unwrap(),
        ]
    };
}

/// What is linearised is where the simulation is, however it is handed over.
#[test]
fn a_simulation_is_linearised_where_it_is() {
    let scene = double_pendulum::least::Scene::new().with_start("arm.angle", 1.0);
    let mut sim = scene.start().unwrap();
    let start = linearise(&sim).unwrap();
    sim.step(0.2).unwrap();
    assert_eq!(linearise(&sim).unwrap(), linearise(sim.state()).unwrap());
    assert_ne!(linearise(&sim).unwrap(), start);
}

in_both_formulations!(pendulum {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body bob {
        mass: 3 kg;
        inertia: 0.05 kg*m^2;
        port pivot: (0, 0.4) m;
        start angle: 0 deg, locked;
    }
    revolute hinge(ground.o, bob.pivot) { damping: 0.7 N*m*s/rad; }
    output bob.angle in deg, hinge.force;
});

in_both_formulations!(oscillator {
    input push: N = 0 N;
    ground { port rail: (0, 0) m; }
    body mass {
        mass: 2 kg;
        inertia: 1 kg*m^2;
        port slide: (0, 0) m;
    }
    prismatic rail(ground.rail, mass.slide) { stiffness: 800 N/m; damping: 16 N*s/m; drive: push + 3 N*gusts.value; }
    // Its discrete states keep their values: they are none of the system.
    noise gusts() { period: 10 ms; }
    output mass.x in mm, mass.ax;
});

in_both_formulations!(double_pendulum {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body arm {
        mass: 2 kg;
        inertia: 0.3 kg*m^2;
        port o: (0, 0.5) m;
        port elbow: (0, -0.7) m;
        start angle: 0 deg, locked;
    }
    body forearm {
        mass: 1.5 kg;
        inertia: 0.1 kg*m^2;
        port elbow: (0, 0.4) m;
        start angle: 0 deg, locked;
    }
    revolute shoulder(ground.o, arm.o);
    revolute elbow(arm.elbow, forearm.elbow);
});

in_both_formulations!(parallelogram {
    gravity: 9.81 m/s^2;
    ground { port a: (0, 0) m; port d: (1, 0) m; }
    body left {
        mass: 0.5 kg;
        inertia: 0.5 kg * (0.6 m)^2 / 12;
        port foot: (0, 0.3) m;
        port head: (0, -0.3) m;
        start angle: 0 deg, locked;
    }
    body bar {
        mass: 2 kg;
        inertia: 0.3 kg*m^2;
        port left: (-0.5, 0) m;
        port right: (0.5, 0) m;
        start x: 0.5 m;
        start y: -0.6 m;
    }
    body right {
        mass: 0.5 kg;
        inertia: 0.5 kg * (0.6 m)^2 / 12;
        port foot: (0, 0.3) m;
        port head: (0, -0.3) m;
        start x: 1 m;
        start y: -0.3 m;
    }
    revolute a(ground.a, left.foot);
    revolute b(left.head, bar.left);
    revolute c(bar.right, right.head);
    revolute d(right.foot, ground.d);
});

fn assert_close(got: f64, want: f64) {
    assert!((got - want).abs() < 1e-10 * want.abs().max(1.0), "{got} {want}");
}

/// The system has the two modes of one oscillation.
fn assert_oscillates(system: &Linearisation, frequency: f64, damping: f64) {
    let modes = system.modes();
    assert_eq!(modes.len(), 2);
    for mode in modes {
        assert_close(mode.frequency, frequency);
        assert_close(mode.damping, damping);
    }
}

#[test]
fn a_physical_pendulum() {
    // J about the hinge, and the moment of gravity per radian.
    let (inertia, stiffness) = (0.05 + 3.0 * 0.4 * 0.4, 3.0 * 9.81 * 0.4);
    for system in at_start!(pendulum) {
        let damping = 0.7 / (2.0 * f64::sqrt(inertia * stiffness));
        assert_oscillates(&system, f64::sqrt(stiffness / inertia), damping);
        assert_eq!((system.b.ncols(), system.outputs[0]), (0, ("bob.angle", "deg")));
    }
}

#[test]
fn a_damped_spring_and_mass() {
    for system in at_start!(oscillator) {
        assert_oscillates(&system, 20.0, 16.0 / (2.0 * f64::sqrt(2.0 * 800.0)));
        assert_eq!(system.inputs, [("push", "N")]);
        // A slow push of 1 N: 1 / 800 m, in mm; a sudden one: 1 / 2 m/s^2.
        let slow = &system.d - &system.c * system.a.clone().lu().solve(&system.b).unwrap();
        assert_close(slow[(0, 0)], 1000.0 / 800.0);
        assert_close(slow[(1, 0)], 0.0);
        assert_close(system.d[(0, 0)], 0.0);
        assert_close(system.d[(1, 0)], 0.5);
    }
}

#[test]
fn a_double_pendulum_of_bars() {
    // Kinetic energy (p a'^2 + 2 q a' b' + r b'^2) / 2 and potential energy (k a^2 + l b^2) / 2 of the absolute angles
    // a, b near rest: det(K - w^2 M) = 0.
    let p = 0.3 + 2.0 * 0.5 * 0.5 + 1.5 * 1.2 * 1.2;
    let q = 1.5 * 1.2 * 0.4;
    let r = 0.1 + 1.5 * 0.4 * 0.4;
    let (k, l) = (9.81 * (2.0 * 0.5 + 1.5 * 1.2), 9.81 * 1.5 * 0.4);
    let (two, one, zero) = (p * r - q * q, -(p * l + r * k), k * l);
    let root = f64::sqrt(one * one - 4.0 * two * zero);
    let squares = [(-one - root) / (2.0 * two), (-one + root) / (2.0 * two)];
    for system in at_start!(double_pendulum) {
        let modes = system.modes();
        assert_eq!(modes.len(), 4);
        for (mode, square) in modes.iter().zip([squares[0], squares[0], squares[1], squares[1]]) {
            assert_close(mode.frequency, square.sqrt());
            assert_close(mode.damping, 0.0);
        }
    }
}

#[test]
fn a_parallelogram_swings_like_a_pendulum() {
    // The bar and the heads of the cranks move on circles of the radius r; half of the cranks' weight moves.
    let r = 0.6;
    let (mass, weight) = (2.0 + 2.0 * 0.5 / 3.0, 2.0 + 0.5);
    for system in at_start!(parallelogram) {
        assert_oscillates(&system, f64::sqrt(9.81 * weight / (mass * r)), 0.0);
    }
}

#[test]
fn a_linear_system_can_be_shown() {
    let [least, _] = at_start!(pendulum);
    let text = least.to_string();
    let mode = least.modes()[0];
    assert!(text.starts_with("2 states\noutput bob.angle, deg\n"), "{text}");
    // The pair of the swinging pendulum is one line.
    assert_eq!(text.matches("rad/s, damping").count(), 1, "{text}");
    assert!(text.contains(&format!("damping {:.4}", mode.damping)), "{text}");
}

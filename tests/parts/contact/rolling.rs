//! What rolls and slides without leaving its track.

use plm::{Dop853, Mechanism as _};

use super::{G, near};
use crate::scene::Named as _;

scene! {
    /// A log on a log, a hoop in a pipe, a disc on a slope, a bead on a wire beside a pendulum.
    pub Rolls {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; port slope: (0, 0) m, axis: -20 deg; port wire: (0, 1) m, axis: 30 deg; }
        body log {
            mass: 1 kg; inertia: disc(1 kg, 0.5 m); port c: (0, 0) m;
            start x: 1.5 m*cos(80 deg); start y: 1.5 m*sin(80 deg); start angle: -30 deg, locked;
        }
        rolling_on_circle pile(ground.o, log.c) { radius_a: 1 m; radius_b: 0.5 m; origin: 90 deg; }
        body hoop {
            mass: 1 kg; inertia: thin_cylinder(1 kg, 0.1 m); port c: (0, 0) m;
            start x: 0.9 m*sin(20 deg); start y: -0.9 m*cos(20 deg); start angle: -9*20 deg, locked;
        }
        rolling_on_circle pipe(ground.o, hoop.c) { side: inside; radius_a: 1 m; radius_b: 0.1 m; origin: -90 deg; }
        body disc {
            mass: 2 kg; inertia: disc(2 kg, 0.1 m); port c: (0, 0) m;
            start x: 0.1 m*sin(20 deg); start y: 0.1 m*cos(20 deg); start angle: -20 deg, locked;
        }
        rolling tyre(ground.slope, disc.c) { radius: 0.1 m; }

        // The wire is the lower half of a circle of 1 m about the port.
        body bead { mass: 2 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start x: 0.5 m; start y: 1 m - 1 m*cos(30 deg); }
        point_on_curve track(ground.wire, bead.c) { height(x): -sqrt(1 m^2 - x^2); }
        body bob { mass: 2 kg; inertia: 1 kg*m^2; start x: 0.5 m; start y: 1 m - 1 m*cos(30 deg); }
        constraint string: norm(bob.position - ground.wire.position) = 1 m;

        output pile.load, pile.traction, pipe.load, pipe.traction, tyre.traction, tyre.load, tyre.speed;
        output track.push, track.force, tension = reaction(string);
        allow(W0002);
    }
}

/// A cylinder on a cylinder: N = m g (7 cos - 4 cos_0)/3, F = m g sin/3; a hoop in a pipe: N = m g (2 cos - cos_0), F = m g sin/2.
#[test]
fn what_rolls_without_slip_bears_its_load() {
    let mut sim = Rolls::new().start_with(Dop853::new(1e-10)).unwrap();
    let start = 10_f64.to_radians().cos();
    for _ in 0..20 {
        sim.step(0.1).unwrap();
        let log = sim.state_of("log");
        let (sin, cos) = (log.x / 1.5, log.y / 1.5);
        near(sin.hypot(cos), 1.0, 1e-10);
        near(sim.value_of("pile.load"), G * (7.0 * cos - 4.0 * start) / 3.0, 1e-7);
        near(sim.value_of("pile.traction"), G * sin / 3.0, 1e-7);
        let hoop = sim.state_of("hoop");
        let (sin, cos) = (hoop.x / 0.9, -hoop.y / 0.9);
        near(sim.value_of("pipe.load"), G * (2.0 * cos - 20_f64.to_radians().cos()), 1e-7);
        near(sim.value_of("pipe.traction"), G * sin / 2.0, 1e-7);
        near(hoop.angle, -9.0 * sin.atan2(cos), 1e-9);
    }
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    near(sim.value_of("tyre.speed"), 2.0 * 2.0 / 3.0 * G * sin, 1e-9);
    near(sim.value_of("tyre.traction"), -2.0 * G * sin / 3.0, 1e-9);
    near(sim.value_of("tyre.load"), 2.0 * G * cos, 1e-9);
}

/// A bead on a circular wire is a pendulum.
#[test]
fn a_bead_on_a_wire_swings_as_a_pendulum() {
    let mut sim = Rolls::new().start_with(Dop853::new(1e-10)).unwrap();
    for _ in 0..20 {
        let (bead, bob) = (sim.state_of("bead"), sim.state_of("bob"));
        near(bead.x, bob.x, 1e-8);
        near(bead.y, bob.y, 1e-8);
        near(sim.value_of("track.push"), sim.value_of("tension"), 1e-6);
        let force = sim.vector_of("track.force");
        near(force[0], -bead.x * sim.value_of("tension"), 1e-6);
        near(force[1], (1.0 - bead.y) * sim.value_of("tension"), 1e-6);
        sim.step(0.05).unwrap();
    }
}

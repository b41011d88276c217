//! Starts that parts of the library and events set.

use std::f64::consts::TAU;

use plm::dynamic::{Integrator, Mechanism, Run};

use crate::near;

/// Begun at a time by a method.
fn begun(text: &str, time: f64, method: &str) -> Run {
    let mut mechanism = Mechanism::from_text(text).unwrap();
    mechanism.set_time(time);
    mechanism.start_with(method.parse::<Integrator>().unwrap()).unwrap()
}

const METHODS: [&str; 4] = ["Dop853:1e-10", "RadauIia5:1e-8", "Rk4:1e-3", "MoreauJean:1e-3"];

/// By its signal at the start; between the bounds as it is declared.
#[test]
fn a_relay_begins_on_the_side_of_its_signal() {
    for (signal, declared, on) in [
        (10.0, 0, 1.0),
        (10.0, 1, 1.0),
        (7.0, 0, 0.0),
        (7.0, 1, 1.0),
        (3.0, 0, 0.0),
        (3.0, 1, 0.0),
        (8.0, 0, 0.0),
    ] {
        let text = format!(
            "pub M {{ allow(W0002); body b {{ mass: 1 kg; inertia: 1 kg*m^2; start x: {signal} m; }}
            hysteresis relay() {{ signal: b.x/(1 m); low: 5; high: 8; active: {declared}; }} output relay.active; }}"
        );
        for method in METHODS {
            let mut run = begun(&text, 0.0, method);
            near(run.output("relay.active").unwrap(), on, 0.0);
            run.step_to(0.1).unwrap();
            near(run.output("relay.active").unwrap(), on, 0.0);
        }
    }
}

/// A wheel that is driven back comes to rest at the tooth below its start, whole turns away too. Exactly at a tooth it stays.
#[test]
fn a_ratchet_begins_at_the_tooth_below() {
    let pitch = TAU / 24.0;
    for degrees in [0.0, 5.0, 15.0, 37.0, 90.0, 180.0, 725.0, -1.0, -15.0, -37.0, -90.0] {
        let text = format!(
            "pub M {{ ground {{ port o: (0, 0) m; }}
            body arm {{ mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; start angle: {degrees} deg; }}
            revolute pin(ground.o, arm.a); force push(arm.a) {{ torque: -1 N*m; }}
            ratchet pawl(ground.o, arm.a) {{ teeth: 24; }} output arm.angle, pawl.torque; }}"
        );
        let tooth = (degrees / 15.0_f64).floor();
        for method in METHODS {
            let mut run = begun(&text, 0.0, method);
            run.step_to(1.0).unwrap();
            near(run.output("arm.angle").unwrap(), tooth * pitch, 1e-9);
            near(run.output("pawl.torque").unwrap(), 1.0, 1e-9);
        }
    }
}

/// Begun at any time they sample at whole multiples of their period from then on.
#[test]
fn samples_are_taken_at_multiples_of_the_period() {
    let text = "pub M { allow(W0002); body b { mass: 1 kg; inertia: 1 kg*m^2; }
        delay late() { signal: t/(1 s); period: 0.1 s; samples: 1; }
        sampled_controller control() { error: t/(1 s); period: 0.1 s; }
        noise hiss() { period: 0.1 s; }
        output late.value, control.value, hiss.seed; }";
    for (start, first) in [(0.0, 0.1), (0.05, 0.1), (0.1, 0.2), (0.3, 0.4), (0.37, 0.4), (1000.0, 1000.1)] {
        for method in ["Dop853:1e-10", "Rk4:1e-3"] {
            let mut run = begun(text, start, method);
            run.step_to(first - 0.002).unwrap();
            near(run.output("control.value").unwrap(), 0.0, 0.0);
            near(run.output("hiss.seed").unwrap(), 1.0, 0.0);
            run.step_to(first + 0.002).unwrap();
            near(run.output("control.value").unwrap(), first, 2e-3);
            near(run.output("hiss.seed").unwrap(), 16807.0_f64.powi(2) % 2_147_483_647.0, 0.0);
            run.step_to(first + 0.102).unwrap();
            near(run.output("control.value").unwrap(), first + 0.1, 2e-3);
            near(run.output("late.value").unwrap(), first, 2e-3);
        }
    }
}

/// Positions are those of the assembled pose; velocities that are set are distributed by joints.
#[test]
fn events_at_the_start_read_the_assembled_pose() {
    let text = "pub M { gravity: 0 m/s^2; ground { port o: (0, 0) m; }
        body arm { mass: 1 kg; inertia: 1 kg*m^2; port a: (-1, 0) m; start x: 0.8 m; start y: 0.7 m; }
        revolute pin(ground.o, arm.a);
        discrete home: m = 0 m; discrete times: 1 = 0;
        when start { home = arm.y; arm.omega = 3 rad/s; times = times + 1; }
        when start { times = 2*times; }
        output home, times, arm.y, arm.omega, arm.vx; }";
    for method in METHODS {
        let mut run = begun(text, 0.0, method);
        let (home, y) = (run.output("home").unwrap(), run.output("arm.y").unwrap());
        assert!(home == y && (y - 0.7).abs() > 1e-3, "{home} {y}");
        near(run.output("arm.vx").unwrap(), -3.0 * y, 1e-12);
        run.step_to(1.0).unwrap();
        near(run.output("home").unwrap(), home, 0.0);
        near(run.output("times").unwrap(), 2.0, 0.0);
        near(run.output("arm.omega").unwrap(), 3.0, 1e-6);
    }
}

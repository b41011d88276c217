//! Every step that `emit:` can order, on mechanisms that have next to nothing to step: it compiles, the time goes on, and
//! what the equations say happens.
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use plm::runtime::{Moment, Vector};

/// The interval, s.
const H: f64 = 1.0 / 64.0;

/// Declares a mechanism in a module of its own, with every step.
macro_rules! stepped {
    ($module:ident, { $($items:tt)* }) => {
        mod $module {
            plm::mechanism! { pub Scene { allow(W0002); emit: step(rk4, semi_implicit_euler, linearly_implicit); $($items)* } }
        }
    };
}

stepped!(welded, {
    ground { port o: (0, 0) m; }
    body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-1, 0) m; }
    weld foot(ground.o, arm.o);
});
stepped!(welded_absolute, {
    formulation: absolute;
    ground { port o: (0, 0) m; }
    body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-1, 0) m; }
    weld foot(ground.o, arm.o);
});
stepped!(prescribed, {
    ground { port o: (0, 0) m; }
    body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-1, 0) m; }
    revolute pin(ground.o, arm.o);
    constraint motor: arm.angle = 0.5 rad*sin(2 rad/s*t);
});
stepped!(prescribed_loop, {
    ground { port a: (0, 0) m; port d: (1, 0) m; }
    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.3, 0) m; start angle: 60 deg; }
    body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (0.9, 0) m; start angle: 30 deg; }
    body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (0.7, 0) m; start x: 1 m; start angle: 95 deg; }
    revolute a(ground.a, crank.a);
    revolute b(crank.b, coupler.b);
    revolute c(coupler.c, rocker.c);
    revolute d(ground.d, rocker.d);
    constraint motor: crank.angle = 60 deg + 2 rad/s*t;
});
stepped!(free, {
    gravity: 10 m/s^2;
    body stone { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; start vx: 3 m/s, locked; }
});
stepped!(one_state, {
    ground { port o: (0, 0) m; }
    body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-1, 0) m; }
    weld foot(ground.o, arm.o);
    state lag: 1 = 1;
    rate lag = -4*lag/1 s;
    output lag;
});
stepped!(nothing_at_all, {
    formulation: absolute;
    body stone { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; }
});

/// The states at the start and after one step of each kind.
macro_rules! each {
    ($module:ident) => {{
        let start = *$module::Scene::new().start().unwrap().state();
        let mut ends = [start; 3];
        ends[0].step_rk4(H).unwrap();
        ends[1].step_semi_implicit_euler(H).unwrap();
        ends[2].step_linearly_implicit(H).unwrap();
        for end in &ends {
            assert!((end.time() - H).abs() < 1e-15, "{}: {} s", stringify!($module), end.time());
        }
        (start, ends)
    }};
}

/// What has no freedom stays: there is no number to step, or none that changes.
#[test]
fn what_cannot_move_stays() {
    macro_rules! stays {
        ($module:ident) => {
            let (start, ends) = each!($module);
            for end in ends {
                for i in 0..start.x().len() {
                    assert_eq!(start.x().at(i), end.x().at(i), "{} {i}", stringify!($module));
                }
            }
        };
    }
    stays!(welded);
    stays!(welded_absolute);
    stays!(nothing_at_all);
}

/// A prescribed motion is where the time puts it, whatever the step.
#[test]
fn what_is_prescribed_follows_the_time() {
    for end in each!(prescribed).1 {
        assert!((end.arm().angle - 0.5 * (2.0 * H).sin()).abs() < 1e-15);
    }
    for end in each!(prescribed_loop).1 {
        let (crank, rocker) = (60_f64.to_radians() + 2.0 * H, end.rocker().angle);
        assert!((end.crank().angle - crank).abs() < 1e-14);
        // The coupler's length, between the pins of crank and rocker.
        let [x, y] = [1.0 + 0.7 * rocker.cos() - 0.3 * crank.cos(), 0.7 * rocker.sin() - 0.3 * crank.sin()];
        assert!((x.hypot(y) - 0.9).abs() < 1e-14, "{x} {y}");
    }
}

/// Under a constant force the first is exact, the second h g/2 ahead in its place, and a linearly implicit one exact.
#[test]
fn what_is_free_falls() {
    let falls = [0.0, -0.5 * 10.0 * H * H, 0.0];
    for (end, beyond) in each!(free).1.iter().zip(falls) {
        let stone = end.stone();
        assert!((stone.x - 3.0 * H).abs() < 1e-14 && (stone.vy + 10.0 * H).abs() < 1e-14);
        assert!((stone.y + 5.0 * H * H - beyond).abs() < 1e-14, "{}", stone.y);
    }
}

/// The stability functions of the methods: the series of exp(z) to its order; that of order 3 errs by less than z^4/10.
#[test]
fn a_state_alone_decays_as_the_formula_says() {
    let z = -4.0 * H;
    let rk4 = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
    let expected = [(rk4, 1e-15), (1.0 + z, 1e-15), (z.exp(), z.powi(4) / 10.0)];
    for (end, (expected, allowed)) in each!(one_state).1.iter().zip(expected) {
        assert!((end.lag() - expected).abs() < allowed, "{} {expected}", end.lag());
    }
}

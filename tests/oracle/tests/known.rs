//! Derivatives at values that people write first: closed as drawn, at rest, given by a parameter.
#![allow(clippy::unwrap_used, reason = "tests")]

use plm_dynamic::{By, Error, Integrator, Mechanism};
use plm_runtime::{Cause, Fault};

/// Derivatives at a time of some quantities by a parameter or a start value.
fn slopes(text: &str, by: &str, until: f64, of: &[&str]) -> Result<Vec<f64>, Error> {
    let mechanism = Mechanism::from_text(text).unwrap();
    let start = mechanism.starts().iter().position(|name| *name == by).map(By::Start);
    let by = start.or_else(|| mechanism.parameters().position(|(name, _)| name == by).map(By::Parameter));
    let place = |name: &&str| mechanism.observables().iter().position(|(known, _)| known == name).unwrap();
    let all: Vec<usize> = of.iter().map(place).collect();
    let times = (until, until.max(1e-3));
    let found = mechanism.derivative(by.unwrap(), Integrator::Dop853(1e-9), times, &all, &mut || true)?;
    Ok(found.slopes.into_iter().map(|of_output| *of_output.last().unwrap()).collect())
}

#[track_caller]
fn are_near(found: Result<Vec<f64>, Error>, expected: &[f64], within: f64) {
    let found = found.unwrap();
    let near = found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < within);
    assert!(near && found.len() == expected.len(), "{found:?} {expected:?}");
}

/// A bar that hangs as drawn: assembly shares a change between angle and place.
#[test]
fn a_start_that_closes_as_drawn_is_derived_through_assembly() {
    let text = "pub S {
        ground { port o: (0, 0) m; }
        body b { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 1) m; start y: -1 m; }
        revolute h(ground.o, b.o);
        output b.angle, b.x;
    }";
    are_near(slopes(text, "b.angle", 0.0, &["b.angle", "b.x"]), &[0.5, 0.5], 1e-12);
    are_near(slopes(text, "b.x", 0.0, &["b.angle", "b.x"]), &[0.5, 0.5], 1e-12);
}

/// A four-bar that closes as drawn: q by the coupler is -1/c, r by the rocker 1/b.
#[test]
fn a_loop_that_closes_as_drawn_is_derived_by_its_lengths() {
    let text = |formulation: &str| {
        format!(
            "pub F {{
    formulation: {formulation};
    param c: m = 0.3 m;
    param b: m = 1 m;
    ground {{ port o: (0, 0) m; port d: (1, 0) m; }}
    body k {{ mass: 1 kg; inertia: 0.02 kg*m^2; port o: (0, 0) m; port a: (0.3, 0) m; start angle: 90 deg, locked; }}
    body r {{ mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (b, 0 m); start y: 0.3 m; }}
    body q {{ mass: 1 kg; inertia: 0.02 kg*m^2; port d: (0, 0) m; port b: (c, 0 m); start x: 1 m; start angle: 90 deg; }}
    revolute jo(ground.o, k.o);
    revolute ja(k.a, r.a);
    revolute jb(r.b, q.b);
    revolute jd(ground.d, q.d);
    output k.angle, q.angle, r.angle;
}}"
        )
    };
    let of = ["k.angle", "q.angle", "r.angle"];
    for formulation in ["absolute", "loops"] {
        are_near(slopes(&text(formulation), "b", 1e-3, &of), &[0.0, -1.0 / 0.3, 0.0], 1e-9);
        are_near(slopes(&text(formulation), "c", 1e-3, &of), &[0.0, 0.0, 1.0], 1e-9);
    }
}

/// Two bars at rest: their start rates are corrected like others, beside those of a start a little in motion.
#[test]
fn start_rates_of_a_machine_at_rest_are_derived() {
    let text = |omega: &str| {
        format!(
            "pub D {{
    gravity: 9.81 m/s^2;
    ground {{ port o: (0, 0) m; }}
    body a {{ mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0.5) m; port b: (0, -0.5) m; start angle: 1 rad, locked; }}
    body b {{ mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0.5) m; start angle: 1.2 rad, locked; start omega: {omega} rad/s; }}
    revolute s(ground.o, a.o);
    revolute e(a.b, b.a);
    output a.omega, b.omega;
}}"
        )
    };
    let of = ["a.omega", "b.omega"];
    let moving = slopes(&text("1e-7"), "b.omega", 1e-3, &of).unwrap();
    assert!(moving[0].abs() > 0.01 && moving[1].abs() < 0.99, "{moving:?}");
    are_near(slopes(&text("0"), "b.omega", 1e-3, &of), &moving, 1e-6);
}

/// What a parameter gives is derived by the start value too, and by the parameter.
#[test]
fn a_start_that_a_parameter_gives_is_derived_by_both() {
    let text = "pub S {
        param w: rad/s = 1 rad/s;
        ground { port o: (0, 0) m; }
        body b { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 1) m; start omega: w, locked; }
        revolute h(ground.o, b.o);
        output b.omega, b.angle;
    }";
    for by in ["b.omega", "w"] {
        are_near(slopes(text, by, 0.5, &["b.omega", "b.angle"]), &[1.0, 0.5], 1e-9);
    }
}

/// A speed that a condition sets: the joints give the other bar the rest, whether or not the speeds fit as they are.
#[test]
fn speeds_that_an_event_sets_are_derived_through_the_joints() {
    let text = |kick: f64| {
        format!(
            "pub D {{
    param kick: rad/s = {kick:?} rad/s;
    ground {{ port o: (0, 0) m; }}
    body a {{ mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0.5) m; port b: (0, -0.5) m; }}
    body b {{ mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0.5) m; start angle: 90 deg, locked; }}
    revolute s(ground.o, a.o);
    revolute e(a.b, b.a);
    when t > 0.5 s {{ a.omega = kick; }}
    output a.omega, b.omega;
    allow(W0002);
}}"
        )
    };
    let of = ["a.omega", "b.omega"];
    let moving = slopes(&text(1e-7), "kick", 0.501, &of).unwrap();
    assert!((moving[0] - 1.0).abs() < 1e-3, "{moving:?}");
    are_near(slopes(&text(0.0), "kick", 0.501, &of), &moving, 1e-6);
}

/// A bumper: x = 2 x1 - v (T - pi/w) after it, w = sqrt(k/m); forces begin without a jump, and their derivatives do not.
#[test]
fn steps_end_where_derivatives_of_forces_jump() {
    for force in [
        "-max(k*(b.x - x1), 0 N)",
        "if b.x > x1 then -k*(b.x - x1) else 0 N",
        "-0.5*k*(b.x - x1 + abs(b.x - x1))",
    ] {
        let text = format!(
            "pub O {{
    param x1: m = 0.5 m; param k: N/m = 100 N/m; param v: m/s = 1 m/s;
    ground {{ port o: (0, 0) m; }}
    body b {{ mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m, locked; start vx: v, locked; }}
    prismatic r(ground.o, b.o) {{ drive: {force}; }}
    output b.x, b.vx;
}}"
        );
        let by_v = std::f64::consts::PI / 10.0 - 1.2;
        are_near(slopes(&text, "x1", 1.2, &["b.x", "b.vx"]), &[2.0, 0.0], 1e-7);
        are_near(slopes(&text, "v", 1.2, &["b.x", "b.vx"]), &[by_v, -1.0], 1e-7);
        // On the kink where the run begins.
        let text = text.replace("x1: m = 0.5 m", "x1: m = 0 m");
        are_near(slopes(&text, "x1", 0.2, &["b.x"]), &[1.0 - 2.0_f64.cos()], 1e-7);
        are_near(slopes(&text, "v", 0.2, &["b.x"]), &[0.1 * 2.0_f64.sin()], 1e-7);
    }
}

/// Thrown up exactly to a ceiling: above it there is an impact, below it none.
#[test]
fn a_motion_that_only_touches_has_no_derivative() {
    let text = |item: &str| {
        format!(
            "pub B {{
    param g: m/s^2 = 10 m/s^2; param v: m/s = 2 m/s; param top: m = 0.2 m;
    gravity: g*(0, -1);
    body b {{ mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start y: 0 m, locked; start vy: v, locked; }}
    {item}
    output b.y, b.vy, b.vx;
    allow(W0002);
}}"
        )
    };
    for item in [
        "unilateral f: b.y <= top { restitution: 0.5; }",
        "when b.y > top { b.vy = -0.5*b.vy; }",
        "force push(b.o) { y: if b.y > top then -5 N else 0 N; }",
    ] {
        for by in ["v", "top", "g", "b.vy"] {
            let found = slopes(&text(item), by, 0.3, &["b.y"]);
            assert!(
                matches!(found, Err(Error::Fault(Fault { cause: Cause::Grazes, .. }))),
                "{item} by {by}: {found:?}"
            );
        }
        // What does not move the touch is derived by, and so is a motion that keeps clear.
        are_near(slopes(&text(item), "b.vx", 0.3, &["b.vx"]), &[1.0], 1e-9);
        are_near(slopes(&text(item).replace("0.2 m;", "0.21 m;"), "v", 0.3, &["b.y"]), &[0.3], 1e-9);
    }
}

/// A parallelogram goes through its flat pose, which it has by its lengths alone.
#[test]
fn a_change_point_ends_a_run_that_is_derived_by_lengths() {
    let text = "pub N {
        param lk: m = 0.3 m; param omega: rad/s = 4 rad/s; param mass: kg = 1 kg;
        ground { port o: (0, 0) m; port d: (1, 0) m; }
        body k { mass: mass; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (lk, 0 m); start angle: 90 deg, locked; start omega: omega, locked; }
        body r { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (1, 0) m; start y: 0.3 m; }
        body q { mass: 2 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.3, 0) m; start x: 1 m; start angle: 90 deg; }
        revolute jo(ground.o, k.a);
        revolute ja(k.b, r.a);
        revolute jb(r.b, q.b);
        revolute jd(ground.d, q.a);
        output k.angle, q.angle;
    }";
    let found = slopes(text, "lk", 0.6, &["k.angle"]);
    assert!(matches!(found, Err(Error::Fault(Fault { cause: Cause::ChangePoint, .. }))), "{found:?}");
    // It turns evenly: the bars of a parallelogram turn alike, and the coupler does not turn.
    are_near(slopes(text, "omega", 0.6, &["k.angle", "q.angle"]), &[0.6, 0.6], 1e-6);
    are_near(slopes(text, "mass", 0.6, &["k.angle", "q.angle"]), &[0.0, 0.0], 1e-6);
}

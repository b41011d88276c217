//! Mechanisms from text as their users have them: names, values, mistakes.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use plm::runtime::{Described, Linear, Statics};
use plm::{Fault, Method, Moment, Sim, linearise, stabilise};
use plm_dynamic::{Error, Integrator, Mechanism, OnRun, Refused};

mod derivatives;
mod starts;

const PENDULUM: &str = "pub Pendulum {
    param length: m = 1 m;
    param damping: N*m*s;
    input torque: N*m = 0 N*m;
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body bob {
        mass: 1 kg;
        inertia: 1e-9 kg*m^2;
        port pivot: (0 m, length);
        start angle: 1 deg, locked;
    }
    revolute hinge(ground.o, bob.pivot);
    force friction(bob.pivot) { torque: torque - damping*bob.omega; }
    output bob.angle in deg;
    output hinge.force;
}";

/// Rails that keep one angle twice: a frame on two rails, on which a block swings, and a wedge that slides on two rails and lifts what lies
/// on it. Both follow their closed forms, in joint coordinates too.
#[test]
fn rails_that_keep_one_angle_twice_run_in_every_formulation() {
    let frame = "ground { port a: (0, 0) m, axis: 90 deg; port b: (1, 0) m, axis: 30 deg; }
        body frame {
            mass: 1 kg; inertia: 1 kg*m^2;
            port a: (0, 0) m, axis: 90 deg; port b: (1, 0) m, axis: 30 deg; port rail: (0, 0) m;
        }
        body block { mass: 2 kg; inertia: 1 kg*m^2; port on: (0, 0) m; start x: 0.3 m, locked; }
        prismatic first(ground.a, frame.a) { }
        prismatic second(ground.b, frame.b) { }
        prismatic rail(frame.rail, block.on) { stiffness: 50 N/m; }";
    let wedge = "ground { port a: (0, 0) m, axis: 0 deg; port b: (0, 0) m, axis: 90 deg; }
        body block {
            mass: 0.5 kg; inertia: 1 kg*m^2; start x: 0.3 m, locked;
            port a: (0, 0) m, axis: 0 deg; port c: (0, 0) m, axis: 45 deg;
        }
        body lifted { mass: 1.5 kg; inertia: 1 kg*m^2; port b: (0, 0) m, axis: 90 deg; port c: (0, 0) m, axis: 45 deg; }
        prismatic rail(ground.a, block.a) { stiffness: 50 N/m; }
        prismatic guide(ground.b, lifted.b) { }
        prismatic slope(block.c, lifted.c) { }";
    // sqrt(k/m) of 2 kg both, for 0.7 s.
    let expected = 0.3 * (5.0_f64 * 0.7).cos();
    for (items, formulation) in [frame, wedge].into_iter().flat_map(|of| [(of, "loops"), (of, "absolute")]) {
        let text = format!("pub Rails {{ formulation: {formulation}; gravity: 0; {items} allow(W0001); }}");
        let mut run =
            Mechanism::from_text(&text).unwrap().start_with("Dop853:1e-10".parse().unwrap()).unwrap();
        run.step_to(0.7).unwrap();
        let x = run.body("block").unwrap().x;
        assert!((x - expected).abs() < 1e-8, "{formulation}: {x} {expected}");
    }
}

/// A block on a rail with 1 N of friction that is led from rest, rests, and goes back; `drive = m a + 1 N sign v` while it moves.
#[test]
fn friction_rubs_in_a_motion_that_is_prescribed_from_rest() {
    for formulation in ["tree", "absolute"] {
        let text = format!(
            "pub Driven {{
                formulation: {formulation};
                ground {{ port o: (0, 0) m; }}
                body block {{ mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; }}
                prismatic rail(ground.o, block.p) {{ seal_friction: 1 N; }}
                constraint motor: block.x =
                    smooth_table(t, (0 s, 0 m), (0.8 s, 1 m)) + smooth_table(t, (1 s, 0 m), (1.5 s, -0.5 m));
                output block.vx, block.ax, drive = -reaction(motor);
            }}"
        );
        let mut run =
            Mechanism::from_text(&text).unwrap().start_with("Dop853:1e-9".parse().unwrap()).unwrap();
        for (time, side) in
            [(0.0, 1.0), (0.1, 1.0), (0.7, 1.0), (0.9, 0.0), (1.1, -1.0), (1.4, -1.0), (1.6, 0.0)]
        {
            run.step_to(time).unwrap();
            let [drive, a] = ["drive", "block.ax"].map(|name| run.output(name).unwrap());
            assert!((drive - a - side).abs() < 1e-9, "{formulation} {time}: {drive} {a}");
        }
    }
}

/// A small swing against its closed form, with another length and by two methods.
#[test]
fn parameters_shape_the_motion() {
    let mut pendulum = Mechanism::from_text(PENDULUM).unwrap();
    assert_eq!(pendulum.start().unwrap_err(), Error::NotGiven("damping".to_owned()));
    pendulum.set_parameter("damping", 0.0).unwrap();
    pendulum.set_parameter("length", 0.25).unwrap();
    for method in ["Dop853:1e-10", "RadauIia5:1e-9", "Rk4:1e-3"] {
        let mut run = pendulum.start_with(method.parse().unwrap()).unwrap();
        run.step_to(0.7).unwrap();
        let omega = (9.81_f64 / 0.25).sqrt();
        let amplitude = 1_f64.to_radians();
        // The period of a swing is longer by amplitude^2/16.
        let expected = amplitude * (omega * 0.7 * (1.0 - amplitude * amplitude / 16.0)).cos();
        assert!((run.body("bob").unwrap().angle - expected).abs() < 1e-7, "{method}");
        assert!((run.row()[0] - expected.to_degrees()).abs() < 1e-5, "{method}");
    }
}

#[test]
fn inputs_act_from_when_they_are_set() {
    let mut pendulum = Mechanism::from_text(PENDULUM).unwrap();
    pendulum.set_parameter("damping", 1.0).unwrap();
    let mut run = pendulum.start().unwrap();
    run.set_input("torque", 9.81 * 0.1_f64.sin()).unwrap();
    run.step_to(40.0).unwrap();
    assert!((run.output("bob.angle").unwrap() - 0.1).abs() < 1e-6);
    let columns: Vec<(&str, &str)> = run.columns().collect();
    assert_eq!(columns, [("bob.angle", "deg"), ("hinge.force.x", "N"), ("hinge.force.y", "N")]);
}

/// Equilibrium near the state of a run: its angle, rad, and the frequency of small swings about it, rad/s.
struct AtRest;

impl OnRun for AtRest {
    type Output = Result<(f64, f64), Fault>;

    fn on<M, I>(self, sim: &mut Sim<M, I>) -> Self::Output
    where
        M: Described<S = f64> + Statics + Linear<Lifted<1>: Described + Statics>,
        I: Method<M>,
    {
        let rest = stabilise(sim)?.start()?;
        let angle = M::pose(rest.state(), 0).map_or(f64::NAN, |pose| pose.angle);
        assert!(rest.state().mechanism().tables().bodies.len() == 1);
        Ok((angle, linearise(&rest)?.modes()[0].frequency))
    }
}

/// A torque that holds the pendulum aslant, and small swings there: sin a = M/(m g l), omega^2 = g cos(a)/l.
#[test]
fn a_run_is_brought_to_rest() {
    // A locked coordinate would not move to the equilibrium.
    let mut pendulum = Mechanism::from_text(&PENDULUM.replace(", locked", "")).unwrap();
    for (name, value) in [("damping", 0.0), ("length", 0.25)] {
        pendulum.set_parameter(name, value).unwrap();
    }
    let mut run = pendulum.start().unwrap();
    run.set_input("torque", 9.81 * 0.25 * 0.4_f64.sin()).unwrap();
    run.step_to(0.1).unwrap();
    let (angle, frequency) = run.then(AtRest).unwrap();
    assert!((angle - 0.4).abs() < 1e-8, "{angle}");
    assert!((frequency - (9.81 * 0.4_f64.cos() / 0.25).sqrt()).abs() < 1e-6, "{frequency}");
    assert!((run.time() - 0.1).abs() < 1e-12);
}

/// Small swings from a start value that is set, at a time that is set; a copy goes on to the bit.
#[test]
fn starts_are_set_and_runs_are_copied() {
    let mut pendulum = Mechanism::from_text(PENDULUM).unwrap();
    pendulum.set_parameter("damping", 0.0).unwrap();
    assert_eq!(pendulum.starts()[2], "bob.angle");
    pendulum.set_start("bob.angle", 1e-3).unwrap();
    pendulum.set_time(2.0);
    let mut run = pendulum.start().unwrap();
    run.step_to(2.3).unwrap();
    let mut copy = run.clone();
    for each in [&mut run, &mut copy] {
        each.step_to(2.5).unwrap();
    }
    assert_eq!(run.output("bob.angle").unwrap().to_bits(), copy.output("bob.angle").unwrap().to_bits());
    let swing = 1e-3 * (9.81_f64.sqrt() * 0.5).cos();
    // The period of swings of a milliradian is longer by a^2/16.
    assert!((run.output("bob.angle").unwrap() - swing).abs() < 1e-9);
}

#[test]
fn unknown_names_say_what_there_is() {
    let mut pendulum = Mechanism::from_text(PENDULUM).unwrap();
    let error = pendulum.set_parameter("lenght", 1.0).unwrap_err();
    assert_eq!(error.to_string(), "there is no parameter `lenght`; there are length, damping");
    pendulum.set_parameter("damping", 0.0).unwrap();
    let run = pendulum.start().unwrap();
    assert_eq!(run.body("bib").unwrap_err().to_string(), "there is no body `bib`; there are bob");
}

#[test]
fn mistakes_have_their_carets() {
    let error = Mechanism::from_text("pub P { ground { port o: (0, 0) s; } }").unwrap_err();
    let Error::Refused(Refused::Mistakes(text)) = &error else { panic!("{error}") };
    assert!(text.contains("--> <text>:1:26") && text.contains('^'), "{text}");
    for hostile in ["", "}", "pub", "pub P {", "\u{0}", &"(".repeat(10_000)] {
        assert!(matches!(Mechanism::from_text(hostile), Err(Error::Refused(Refused::Mistakes(_)))));
    }
}

/// A ball that falls from 1 m onto a floor with e = 0.5: the n-th flight is e^2n high, and bouncing ends (1 + e)/(1 - e) times the
/// first fall behind its begin.
#[test]
fn contacts_and_events_run() {
    let ball = Mechanism::from_text(
        "pub Ball {
            gravity: 9.81 m/s^2;
            discrete bounces: 1 = 0;
            body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m; start vx: 1 m/s; }
            unilateral floor: ball.y >= 0 m { restitution: 0.5; }
            when ball.vy > 0 m/s { bounces = bounces + 1; }
            output bounces, push = reaction(floor);
        }",
    )
    .unwrap();
    let fall = (2.0_f64 / 9.81).sqrt();
    let mut run = ball.start_with(Integrator::Dop853(1e-10)).unwrap();
    run.step_to(2.25 * fall).unwrap();
    assert!((run.body("ball").unwrap().y - 0.0625).abs() < 1e-9);
    assert_eq!(run.row(), [2.0, 0.0]);
    run.step_to(3.0 * fall + 0.1).unwrap();
    assert!(run.body("ball").unwrap().y.abs() < 1e-12);
    assert!((run.row()[1] - 9.81).abs() < 1e-9);
}

#[test]
fn what_there_is_no_room_for_is_named() {
    let rows = |k: usize| format!("unilateral floor{k}: ball.y >= 0 m;");
    let rows: String = (0..40).map(rows).collect();
    let ball = format!("pub Ball {{ body ball {{ mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m; }} {rows} }}");
    let error = Mechanism::from_text(&ball).unwrap_err();
    let expected = "40 rows of contact, and a run of a text has room for 16: `floor16` is the first without";
    assert_eq!(error.to_string(), expected);
}

/// More bodies than the small class has, against the same chain by another method.
#[test]
fn many_bodies_run() {
    let bar = |k: usize| {
        let before = k.checked_sub(1).map_or("ground.o".to_owned(), |before| format!("b{before}.b"));
        format!(
            "body b{k} {{ mass: 1 kg; inertia: 0.01 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; \
             start x: {k}.5 m; start angle: 0 deg; }}
             revolute j{k}({before}, b{k}.a);"
        )
    };
    let bars: String = (0..12).map(bar).collect();
    let text = format!("pub Chain {{ gravity: 9.81 m/s^2; ground {{ port o: (0, 0) m; }} {bars} }}");
    let chain = Mechanism::from_text(&text).unwrap();
    let end = |method: &str| {
        let mut run = chain.start_with(method.parse::<Integrator>().unwrap()).unwrap();
        run.step_to(0.2).unwrap();
        run.body("b11").unwrap().y
    };
    let right = end("Dop853:1e-10");
    for (method, error) in [
        ("Vern9:1e-10", 1e-9),
        ("Adams:1e-10", 1e-8),
        ("Dopri5:1e-10", 1e-8),
        ("RadauIia5:1e-9", 1e-7),
        ("Rk4:2e-4", 1e-9),
        ("Gauss2:5e-4", 1e-9),
        ("Gauss3:1e-3", 1e-9),
        ("Ros34Pw2:5e-4", 1e-6),
        ("SemiImplicitEuler:1e-4", 1e-2),
        ("MoreauJean:1e-3", 1e-3),
    ] {
        assert!((end(method) - right).abs() < error, "{method} {:e}", end(method) - right);
    }
}

/// A disc that touches the corner of a table while both fall freely: the guards of two neighbouring parts of the edge rest at zero, which
/// cuts no step.
#[test]
fn what_touches_a_corner_falls_freely_in_few_steps() {
    let edge =
        Mechanism::from_text(include_str!("../../../../examples/figures/parts/circle_on_polyline.plm"))
            .unwrap();
    let mut run = edge.start().unwrap();
    run.step_to(1.0).unwrap();
    let [table, disc] = ["table", "disc"].map(|name| run.body(name).unwrap());
    let fallen = [table.y, disc.y - 0.2 * 25_f64.to_radians().cos()];
    assert!(fallen.iter().all(|y| (y + 9.81 / 2.0).abs() < 1e-12), "{fallen:?}");
    assert!(run.stats().steps < 20, "{:?}", run.stats());
}

/// A ball of which a floor takes half of the speed: its impacts follow each other ever faster, until 1.3546 s.
const THROWN: &str = "pub Thrown {
    gravity: 9.81 m/s^2;
    body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m, locked; }
    when ball.y < 0 m { ball.vy = -0.5*ball.vy; }
    output ball.y;
    allow(W0002);
}";

/// After three impacts by one step or many, and at the end of all: methods with dense output end there, those of equal steps stay at the
/// floor but for what the ball falls in each.
#[test]
fn a_ball_that_a_when_throws_back_does_not_fall_through() {
    let first = (2.0_f64 / 9.81).sqrt();
    let (third, speed) = (first * 2.5, 9.81 * first / 8.0);
    let t = 1.2 - third;
    for method in ["Dop853", "Dopri5", "Vern9", "Adams", "RadauIia5"] {
        for intervals in [1, 7] {
            let mut run = Mechanism::from_text(THROWN).unwrap().start_with(method.parse().unwrap()).unwrap();
            (1..=intervals).for_each(|k| run.step_to(1.2 * f64::from(k) / f64::from(intervals)).unwrap());
            let y = run.output("ball.y").unwrap();
            assert!((y - (speed * t - 9.81 * t * t / 2.0)).abs() < 1e-6, "{method}: {y}");
            let fault = run.step_to(1.5).unwrap_err().to_string();
            assert!(
                fault.contains("t = 1.354") && fault.contains("switches without end"),
                "{method}: {fault}"
            );
        }
    }
    for method in ["Rk4:1e-3", "SemiImplicitEuler:1e-3", "Gauss2:1e-3", "Ros34Pw2:1e-3"] {
        let mut run = Mechanism::from_text(THROWN).unwrap().start_with(method.parse().unwrap()).unwrap();
        run.step_to(1.6).unwrap();
        let y = run.output("ball.y").unwrap();
        assert!(y.abs() < 0.005, "{method}: {y}");
    }
}

/// Two levels that equalise by a root law are equal from 2 s on: a relay of two states, whose switches are told.
#[test]
fn a_relay_of_two_states_ends_with_its_condition() {
    let tanks = "pub Tanks {
        state a: m = 1 m; state b: m = 0 m;
        let q = 0.5*sign(a - b)*sqrt(abs(a - b)/(1 m))*1 m/s;
        rate a = -q; rate b = q;
        body dummy { mass: 1 kg; inertia: 1 kg*m^2; }
        output a; allow(W0002);
    }";
    let mut run = Mechanism::from_text(tanks).unwrap().start().unwrap();
    let fault = run.step_to(3.0).unwrap_err().to_string();
    assert!(fault.contains("switches without end") && fault.contains("a - b < 0"), "{fault}");
}

/// A block that friction has stopped stays, though a `when` is told of its rest in the same step: 3 m/s against 33 N.
#[test]
fn a_when_on_the_speed_of_what_rubs_leaves_it_at_rest() {
    let seal = "pub Seal {
        ground { port o: (0, 0) m; }
        body b { mass: 5 kg; inertia: 0.05 kg*m^2; port s: (0, 0) m; start vx: 3 m/s; }
        prismatic r(ground.o, b.s) { seal_friction: 15 N; static_seal_friction: 20 N; drive: -18 N; }
        discrete turned: s = 0;
        when b.vx <= 0 m/s { turned = t; }
        output b.x, b.vx, turned;
    }";
    for method in
        ["Rk4:1e-3", "SemiImplicitEuler:1e-3", "Gauss2:1e-3", "Ros34Pw2:1e-3", "Dop853", "RadauIia5"]
    {
        let mut run = Mechanism::from_text(seal).unwrap().start_with(method.parse().unwrap()).unwrap();
        run.step_to(2.0).unwrap();
        let [x, v, turned] = ["b.x", "b.vx", "turned"].map(|name| run.output(name).unwrap());
        assert!((x - 45.0 / 66.0).abs() < 3e-3 && v == 0.0, "{method}: {x} {v}");
        assert!((turned - 15.0 / 33.0).abs() < 2e-3, "{method}: {turned}");
    }
}

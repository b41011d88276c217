//! Whole declarations: headers, order, repetition, parts within parts.

use plm_compiler::diag::Diagnostics;
use plm_compiler::front::parse_and_resolve;
use plm_compiler::model::{FrameRef, Stabilisation};
use plm_compiler::token::Sources;

use crate::support::{Values, assert_near, output, resolve};

const DOUBLE_PENDULUM: &str = "
    /// The double pendulum of the manual, section 2.2.
    pub DoublePendulum {
        gravity: 9.81 m/s^2;
        ground { port o0: (0, 0) m; }
        body arm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port o0:  (-0.5, 0) m;
            port p12: ( 0.5, 0) m;
            start angle: 45 deg, locked;
        }
        body forearm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port p12: (-1, 0) m;
            start angle: 0 deg, locked;
        }
        revolute shoulder(ground.o0, arm.o0)    { damping: 1 N*m/(rev/min); }
        revolute elbow(arm.p12, forearm.p12)    { damping: 1 N*m/(rev/min); }
        output shoulder.force, elbow.force, arm.angle in deg;
    }";

#[test]
fn the_double_pendulum_is_understood() {
    let model = resolve(DOUBLE_PENDULUM);
    assert_eq!(model.name.text, "DoublePendulum");
    assert_eq!((model.visibility.as_str(), model.crate_path.as_str()), ("pub", "::plm"));
    assert_eq!(model.docs, ["The double pendulum of the manual, section 2.2."]);
    let rows: Vec<String> =
        model.rows.iter().map(|row| format!("{} = {}", row.name, model.graph.display(row.phi))).collect();
    assert_eq!(
        rows,
        [
            "shoulder.x = arm.x - 0.5*cos(arm.angle)",
            "shoulder.y = arm.y - 0.5*sin(arm.angle)",
            "elbow.x = forearm.x - arm.x - 0.5*cos(arm.angle) - cos(forearm.angle)",
            "elbow.y = forearm.y - arm.y - 0.5*sin(arm.angle) - sin(forearm.angle)",
        ]
    );
    let mut values = Values::of(&model);
    values.set(model.bodies[0].v[2], 3.0);
    values.set(model.bodies[1].v[2], 5.0);
    let damping = 60.0 / std::f64::consts::TAU;
    let loads: Vec<(usize, f64)> =
        model.loads.iter().map(|load| (load.body, values.at(&model, load.force[2]))).collect();
    assert_eq!(loads.iter().map(|load| load.0).collect::<Vec<_>>(), [0, 1, 0]);
    assert_near(loads[0].1, -3.0 * damping, "shoulder");
    assert_near(loads[1].1, -2.0 * damping, "elbow on forearm");
    assert_near(loads[2].1, 2.0 * damping, "elbow on arm");
    assert_eq!(
        model.parts[0].frames,
        [FrameRef { body: None, port: 0 }, FrameRef { body: Some(0), port: 0 }]
    );
    assert_eq!(model.outputs.iter().map(|output| output.components.len()).collect::<Vec<_>>(), [2, 2, 1]);
    assert_eq!(model.outputs[2].unit.text, "deg");
    assert!(model.bodies.iter().flat_map(|body| &body.ports).all(|port| port.used));
    assert!(matches!(model.stabilisation, Stabilisation::Projection));
}

#[test]
fn the_same_text_gives_the_same_model() {
    let describe = || format!("{:?}", resolve(DOUBLE_PENDULUM));
    assert_eq!(describe(), describe());
}

/// S2 of the benchmark scenes, with its parameters; everything stands in the reverse order of its use.
#[test]
fn the_order_of_declaration_does_not_matter() {
    let model = resolve(
        "FourBar {
            output knee.force, knee.angle in deg;
            revolute shoulder(crank.a, ground.left);
            revolute knee(crank.b, coupler.a) { drive: kick; }
            revolute wrist(coupler.b, rocker.b);
            revolute hip(ground.right, rocker.a);
            let kick = if hip.angle < 1 rad then 2*knee_stiffness*hip.angle else 0;
            let knee_stiffness = 3 N*m/rad;
            body crank { mass: crank_mass; inertia: crank_mass*length^2/12; port a: (-0.15, 0) m; port b: (0.15, 0) m; }
            body coupler { mass: 0.9 kg; inertia: 0.06075 kg*m^2; port a: (-0.45, 0) m; port b: (0.45, 0) m; }
            body rocker { mass: 0.7 kg; inertia: 0.343/12*1 kg*m^2; port a: (-0.35, 0) m; port b: (0.35, 0) m; }
            let crank_mass = per_length*length;
            ground { port left: (0, 0) m; port right: (1, 0) m; }
            let length = 0.3 m;
            param per_length: kg/m = 1 kg/m;
        }",
    );
    let mut values = Values::of(&model);
    let inertias: Vec<f64> = model.bodies.iter().map(|body| values.at(&model, body.inertia)).collect();
    let expected = [0.3, 0.9, 0.7].map(|length: f64| length.powi(3) / 12.0);
    inertias.iter().zip(expected).for_each(|(found, expected)| assert_near(*found, expected, "inertia"));
    values.set(model.bodies[2].q[2], 0.5);
    let torques: f64 = model.loads.iter().map(|load| values.at(&model, load.force[2]).abs()).sum();
    assert_near(torques, 2.0 * (2.0 * 3.0 * 0.5), "kick on both");
    // The closed pose of the scene: crank at 60 degrees, elbow up, by the circle of the coupler and that of the rocker.
    let (s, c) = 60_f64.to_radians().sin_cos();
    let pin = [0.3 * c, 0.3 * s];
    let base = [1.0 - pin[0], -pin[1]];
    let span = base[0].hypot(base[1]);
    let along = (0.81 - 0.49 + span * span) / (2.0 * span);
    let across = (0.81 - along * along).sqrt();
    let unit = [base[0] / span, base[1] / span];
    let elbow = [pin[0] + along * unit[0] - across * unit[1], pin[1] + along * unit[1] + across * unit[0]];
    values.pose(&model, "crank", [pin[0] / 2.0, pin[1] / 2.0, 60_f64.to_radians()]);
    let bar = |a: [f64; 2], b: [f64; 2]| {
        [f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1]), (b[1] - a[1]).atan2(b[0] - a[0])]
    };
    values.pose(&model, "coupler", bar(pin, elbow));
    values.pose(&model, "rocker", bar([1.0, 0.0], elbow));
    for row in &model.rows {
        assert!(values.at(&model, row.phi).abs() < 1e-15, "{}", row.name);
    }
}

/// S6: the piston once in a pin slot, once on a revolute and a prismatic joint.
#[test]
fn the_slider_crank_closes() {
    let bodies = "
        ground { port o: (0, 0) m; }
        body crank { mass: 0.2 kg; inertia: 1e-3 kg*m^2; port a: (-0.1, 0) m; port b: (0.1, 0) m; }
        body rod { mass: 0.6 kg; inertia: 0.018 kg*m^2; port a: (-0.3, 0) m; port b: (0.3, 0) m; }
        revolute main(ground.o, crank.a);
        revolute big_end(crank.b, rod.a);";
    let slot =
        resolve(&format!("S {{ {bodies} pin_slot guide(ground.o, rod.b); output guide.displacement; }}"));
    let slider = resolve(&format!(
        "S {{ {bodies}
            body piston {{ mass: 0.5 kg; inertia: 1e-3 kg*m^2; port pin: (0, 0) m; }}
            revolute small_end(rod.b, piston.pin);
            prismatic guide(ground.o, piston.pin);
            output guide.displacement;
        }}"
    ));
    assert_eq!((slot.rows.len(), slider.rows.len()), (5, 8));
    let (s, c) = 60_f64.to_radians().sin_cos();
    let lean = -(0.2 * s / 0.6).asin();
    let stroke = 0.2 * c + 0.6 * lean.cos();
    for model in [&slot, &slider] {
        let mut values = Values::of(model);
        values.pose(model, "crank", [0.1 * c, 0.1 * s, 60_f64.to_radians()]);
        values.pose(model, "rod", [0.2 * c + 0.3 * lean.cos(), 0.1 * s, lean]);
        if model.bodies.len() > 2 {
            values.pose(model, "piston", [stroke, 0.0, 0.0]);
        }
        for row in &model.rows {
            assert!(values.at(model, row.phi).abs() < 1e-15, "{}", row.name);
        }
        assert_near(output(model, &values, "guide.displacement")[0], stroke, "stroke");
    }
}

#[test]
fn parts_stand_in_parts() {
    let model = resolve(
        "pub P {
            ground { port o: (0, 0) m; }
            repeat i in 0..=1 { body bar[i] { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (1, 0) m; } }
            /// A sprung leg.
            joint leg(top: frame, foot: frame) {
                param rate_of_spring: N/m;
                revolute hip(top, foot) { damping: 1 N*m*s/rad; }
                spring inner(top, foot) { stiffness: 2*rate_of_spring; }
                output length = inner.length;
                output force = hip.force;
            }
            repeat i in 0..=1 { leg legs[i](ground.o, bar[i].b) { rate_of_spring: 100 N/m*(i + 1); } }
            output legs[1].length, legs[0].force;
        }",
    );
    assert_eq!(
        model.parts.iter().map(|part| part.name.text.as_str()).collect::<Vec<_>>(),
        ["legs[0]", "legs[0].hip", "legs[1]", "legs[1].hip"]
    );
    assert_eq!(model.parts[2].kind, "leg");
    assert_eq!(model.rows[2].name, "legs[1].hip.x");
    assert_eq!(model.rows.iter().map(|row| row.part).collect::<Vec<_>>(), [1, 1, 3, 3]);
    let mut values = Values::of(&model);
    values.pose(&model, "bar[1]", [2.0, 4.0, 0.0]);
    assert_near(output(&model, &values, "legs[1].length")[0], 5.0, "length");
    let pull: Vec<f64> = model
        .loads
        .iter()
        .filter(|load| load.body == 1)
        .map(|load| values.at(&model, load.force[0]))
        .collect();
    assert_near(pull.iter().sum(), -2.0 * 200.0 * 5.0 * 0.6, "pull");
}

/// An arm with its motor: a part may bring bodies along, and a mechanism may hold a constraint by itself.
#[test]
fn parts_bring_bodies_and_constraints_stand_alone() {
    let model = resolve(
        "pub P {
            ground { port o: (0, 0) m; }
            part arm(at: frame) {
                body link { mass: 2 kg; inertia: 1 kg*m^2; port a: (-1, 0) m; port tip: (1, 0) m; }
                revolute pin(at, link.a);
                force on link.tip: (0, 3) N;
                torque on link: 2 N*m;
                output tip = link.tip.position;
                output angle = link.angle;
            }
            arm upper(ground.o);
            constraint drive: upper.angle - 2 rad/s*t = 30 deg;
            output upper.tip;
        }",
    );
    assert_eq!(model.bodies[0].name.text, "upper.link");
    let rows: Vec<&str> = model.rows.iter().map(|row| row.name.as_str()).collect();
    assert_eq!(rows, ["upper.pin.x", "upper.pin.y", "drive"]);
    let parts: Vec<_> =
        model.parts.iter().map(|part| (part.kind.as_str(), part.name.text.as_str())).collect();
    assert_eq!(parts, [("arm", "upper"), ("revolute", "upper.pin"), ("constraint", "drive")]);
    let mut values = Values::of(&model);
    values.pose(&model, "upper.link", [0.0, 1.0, std::f64::consts::FRAC_PI_2]);
    values.set(model.time, 0.25);
    assert_near(values.at(&model, model.rows[2].phi), std::f64::consts::FRAC_PI_3 - 0.5, "drive");
    assert_near(output(&model, &values, "upper.tip")[1], 2.0, "tip");
    let torque: f64 = model.loads.iter().map(|load| values.at(&model, load.force[2])).sum();
    assert_near(torque, 2.0, "the force has no lever when the arm points up");
}

/// A joint of the user's own, in the words of the library, is the joint of the library.
#[test]
fn own_joints_equal_those_of_the_library() {
    let bodies = "ground { port o: (0, 0) m; } body arm { mass: 1 kg; inertia: 1 kg*m^2; port a: (1, 2) m; }";
    let own = "joint hinge(a: frame, b: frame) { pair: revolute; param damping: N*m*s/rad = 0;
        constraint x: b.x = a.x; constraint y: b.y - a.y = 0;
        torque on b from a: -damping*rate(b.angle - a.angle); }";
    let text = |head: &str, inside: &str, kind: &str| {
        format!("{head} pub P {{ {bodies} {inside} {kind} j(ground.o, arm.a) {{ damping: 2 N*m*s/rad; }} }}")
    };
    let describe = |text: &str| {
        let model = resolve(text);
        let rows = model.rows.iter().map(|row| model.graph.display(row.phi).to_string());
        rows.chain(model.loads.iter().map(|load| model.graph.display(load.force[2]).to_string()))
            .collect::<Vec<_>>()
    };
    let library = describe(&text("", "", "revolute"));
    assert_eq!(library, describe(&text("", own, "hinge")));
    assert_eq!(library, describe(&text(own, "", "hinge")));
    assert_eq!(library, describe(&text(&format!("crate = a::b; parts {{ {own} }}"), "", "hinge")));
}

#[test]
fn headers_are_read() {
    let model = resolve(
        "crate = ::my::plm; /// One.\n/// Two.\npub(crate) P { allow(W0002); stabilisation: baumgarte; }",
    );
    assert_eq!(model.crate_path, "::my::plm");
    assert_eq!(model.visibility, "pub(crate)");
    assert_eq!(model.docs, ["One.", "Two."]);
    assert_eq!(model.allowed, ["W0002"]);
    let Stabilisation::Baumgarte(tau) = model.stabilisation else { panic!("projection") };
    assert_eq!(Values::of(&model).at(&model, tau), 0.1);
}

/// What rustc makes of `/// One.`, and of a name that is a keyword of Rust.
#[test]
fn tokens_of_rustc_are_understood() {
    let stream = "#[doc = r\" One.\"] P { param r#type = 2.5 kN; }".parse().unwrap();
    let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
    sources.add_tokens("declaration", stream);
    let model = parse_and_resolve(&mut sources, &mut sink).unwrap();
    assert_eq!(model.docs, ["One."]);
    assert_eq!(model.params[0].name.text, "type");
    assert_eq!(Values::of(&model).get(model.params[0].symbol), 2500.0);
    assert_eq!(model.params[0].unit.text, "kN");
}

/// A mistake in a library part is anchored at its use and quotes the line of the library.
#[test]
fn mistakes_inside_library_parts_are_quoted() {
    let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
    // A spring between two ports at one place of the ground: its line has no direction, and its length is 0.
    let text = "P { ground { port a: (0, 0) m; port b: (0, 0) m; } spring s(ground.a, ground.b) { stiffness: 1 N/m; } }";
    sources.add_text("declaration", text);
    assert!(parse_and_resolve(&mut sources, &mut sink).is_none());
    let found = sink.sorted()[0];
    assert_eq!(found.code.id(), "E0403");
    let (anchor, _) = sources.get(0).unwrap().place(found.anchor()).unwrap();
    assert_eq!(text.get(anchor.column - 1..anchor.column), Some("s"));
    let message = found.message(&sources, &|_| None);
    assert!(message.contains("spring.plm:") && message.contains("push/distance*between"), "{message}");
    assert!(message.contains("in the part `spring`, used as `s`"), "{message}");
}

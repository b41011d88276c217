//! What is observed: names, and the forces on the bodies of ports against loads and Jacobians.

use plm_compiler::compile;
use plm_compiler::model::Model;
use plm_compiler::token::Sources;

use crate::support::{Values, assert_near, output, resolve};

/// Two bodies with off-centre, turned ports, and something between them that is observed.
fn between(parts: &str) -> Model {
    resolve(&format!(
        "pub P {{
            ground {{ port o: (0.2, 0.7) m, angle: 40 deg; }}
            body one {{ mass: 1 kg; inertia: 1 kg*m^2; port p: (0.3, -0.2) m, angle: 25 deg; }}
            body two {{ mass: 1 kg; inertia: 1 kg*m^2; port p: (-0.4, 0.1) m, angle: -70 deg; }}
            {parts}
        }}"
    ))
}

fn scattered(model: &Model, seed: u64) -> Values {
    let mut values = Values::of(model);
    values.scatter(model, seed);
    for (k, row) in model.rows.iter().enumerate() {
        values.set(row.lambda, [0.7, -1.3, 0.4, 2.1, -0.6][k]);
    }
    values
}

/// `Q - phi_q^T lambda` on a body.
fn generalised(model: &mut Model, values: &Values, body: usize) -> [f64; 3] {
    let mut force = [0.0; 3];
    for load in model.loads.iter().filter(|load| load.body == body) {
        (0..3).for_each(|i| force[i] += values.at(model, load.force[i]));
    }
    for row in model.rows.clone() {
        for (i, slope) in model.graph.gradient(row.phi, &model.bodies[body].q) {
            force[i] -= values.at(model, slope) * values.get(row.lambda);
        }
    }
    force
}

/// Position of a port, then the force and the torque on it.
fn on_port(model: &Model, values: &Values, part: &str, port: &str, place: &str) -> [f64; 5] {
    let at = output(model, values, &format!("{place}.position"));
    let force = output(model, values, &format!("{part}.force_on_{port}"));
    let torque = output(model, values, &format!("{part}.torque_on_{port}"));
    [at[0], at[1], force[0], force[1], torque[0]]
}

const PARTS: [&str; 7] = [
    "revolute j(one.p, two.p) { stiffness: 3 N*m/rad; damping: 2 N*m/(rad/s); drive: 5 N*m; }",
    "prismatic j(one.p, two.p) { stiffness: 3 N/m; damping: 2 N/(m/s); drive: 5 N; }",
    "pin_slot j(one.p, two.p) { stiffness: 3 N/m; rotary_stiffness: 2 N*m/rad; }",
    "weld j(one.p, two.p);",
    "jack j(one.p, two.p) { drive: 5 N; }",
    "spring j(one.p, two.p) { stiffness: 4 N/m; }",
    "part both(a: frame, b: frame) { revolute pin(a, b) { drive: 3 N*m; } spring side(a, b.body.p) { stiffness: 2 N/m; } force on a: (1, 2) N; }
     both j(one.p, two.p);",
];

/// Carried to G, what a part does to its ports is the generalised force on the body.
#[test]
fn forces_on_ports_are_what_the_bodies_feel() {
    for (seed, part) in PARTS.iter().enumerate() {
        let mut model = between(&format!("{part} observe all;"));
        let values = scattered(&model, seed as u64);
        for (body, port, place) in [(0, "a", "one.p"), (1, "b", "two.p")] {
            let expected = generalised(&mut model, &values, body);
            let [x, y, fx, fy, torque] = on_port(&model, &values, "j", port, place);
            let q = model.bodies[body].q.map(|symbol| values.get(symbol));
            assert_near(fx, expected[0], part);
            assert_near(fy, expected[1], part);
            assert_near(torque + (x - q[0]) * fy - (y - q[1]) * fx, expected[2], part);
        }
    }
}

/// What a part without mass does to the ground and to the body adds up to nothing, torques about the origin too.
#[test]
fn what_the_ground_feels_keeps_the_balance() {
    for part in PARTS.iter().filter(|part| !part.contains("part both")) {
        let part = part.replace("one.p", "ground.o");
        let model = between(&format!("{part} observe all, ground.o;"));
        let mut values = scattered(&model, 3);
        // The port of the second body stands on the axis of the ground's, 0.7 m from it.
        let (axis, turn) = (40_f64.to_radians(), 0.4_f64);
        let x = 0.2 + 0.7 * axis.cos() + 0.4 * turn.cos() + 0.1 * turn.sin();
        let y = 0.7 + 0.7 * axis.sin() + 0.4 * turn.sin() - 0.1 * turn.cos();
        values.pose(&model, "two", [x, y, turn]);
        let a = on_port(&model, &values, "j", "a", "ground.o");
        let b = on_port(&model, &values, "j", "b", "two.p");
        let about_origin = |[x, y, fx, fy, torque]: [f64; 5]| torque + x * fy - y * fx;
        assert_near(a[2] + b[2], 0.0, &part);
        assert_near(a[3] + b[3], 0.0, &part);
        assert_near(about_origin(a) + about_origin(b), 0.0, &part);
    }
}

fn names(model: &Model) -> Vec<&str> {
    model.outputs.iter().map(|output| output.name.text.as_str()).collect()
}

/// The sign of what a joint shows stands with it, whether it is observed or declared.
#[test]
fn signs_are_told() {
    let model = between(
        "weld j(one.p, two.p); prismatic k(one.p, two.p); /// Mine. \n output one.x; output j.force; observe j, k;",
    );
    let docs = |name: &str| &model.outputs.iter().find(|output| output.name.text == name).unwrap().docs;
    assert_eq!(docs("one.x"), "Mine.");
    for name in ["j.force", "j.torque", "k.force", "k.torque", "k.drive_force"] {
        let told = ["`one`", "`two`"].map(|body| docs(name).contains(body));
        assert!(told.contains(&true) && !docs(name).contains("`a`"), "{name}: {}", docs(name));
    }
    for name in ["j.force_on_a", "j.torque_on_b", "k.force_on_b"] {
        assert!(docs(name).starts_with("What `"), "{name}: {}", docs(name));
    }
}

#[test]
fn nothing_is_shown_twice_and_what_is_declared_comes_first() {
    let model = between("weld j(one.p, two.p); output j.torque in kN*m, one.x; observe j, one, j;");
    let expected = [
        "j.torque",
        "one.x",
        "j.force",
        "j.force_on_a",
        "j.torque_on_a",
        "j.force_on_b",
        "j.torque_on_b",
        "one.y",
        "one.angle",
        "one.vx",
        "one.vy",
        "one.omega",
        "one.ax",
        "one.ay",
        "one.alpha",
        "one.p.position",
        "one.p.angle",
        "one.p.velocity",
        "one.p.acceleration",
    ];
    assert_eq!(names(&model), expected);
    assert_eq!(model.outputs.iter().filter(|output| output.declared).count(), 2);
    assert_eq!(model.outputs[0].unit.text, "kN*m");
}

/// Repetitions, what is inside of parts, nodes of joints, the ground.
#[test]
fn all_is_what_can_be_seen_anywhere() {
    let model = resolve(
        "pub P {
            part arm(a: frame) {
                body bar { mass: 1 kg; inertia: 1 kg*m^2; port tip: (1, 0) m; }
                revolute pin(a, bar.tip);
            }
            part motor(at: shaft) { torque on at: 3 N*m; }
            ground { port o: (0, 0) m; }
            repeat i in 0..2 { arm link[i](ground.o); }
            body wheel { mass: 1 kg; inertia: 1 kg*m^2; port hub: (0, 0) m; }
            revolute axle(ground.o, wheel.hub);
            motor drive(axle.shaft);
            node crossing: shaft = axle.shaft;
            observe all;
        }",
    );
    let names = names(&model);
    for expected in [
        "link[1].bar.tip.velocity",
        "link[0].pin.force_on_b",
        "link[1].force_on_a",
        "link[1].pin.acceleration",
        "axle.shaft.angle",
        "axle.shaft.torque",
        "link[0].pin.shaft.torque",
        "ground.o.position",
    ] {
        assert!(names.contains(&expected), "{expected}: {names:?}");
    }
    assert!(!names.contains(&"crossing.torque"), "another name of a node");
    let values = Values::of(&model);
    assert_near(output(&model, &values, "axle.shaft.torque")[0], 3.0, "shaft");
    assert_near(output(&model, &values, "axle.torque_on_b")[0], 3.0, "what the joint hands on");
}

/// After errors the observed names are there all the same.
#[test]
fn names_outlive_mistakes() {
    let mut sources = Sources::new();
    sources.add_text(
        "declaration",
        "pub P {
            ground { port o: (0, 0) m; }
            body arm { mass: 1 m; inertia: 1 kg*m^2; port p: (0, 0) m; }
            revolute pin(ground.o, arm.p);
            observe arm, pin, pin.shaft, ground;
        }",
    );
    let expansion = compile(&mut sources);
    assert!(expansion.diagnostics.has_errors());
    let text = expansion.code.unwrap().text();
    for signature in [
        "pub fn arm_alpha(&self) -> S {",
        "pub fn arm_p_velocity(&self) -> [S; 2] {",
        "pub fn pin_shaft_torque(&self) -> S {",
        "pub fn ground_o_position(&self) -> [S; 2] {",
        "pub fn pin_force(&self) -> [S; 2] {",
        "pub fn pin_force_on_b(&self) -> [S; 2] {",
        "pub fn pin_torque_on_a(&self) -> S {",
    ] {
        assert!(text.contains(signature), "{signature}");
    }
}

//! The parts library: rows against the manual's expanded equations, forces against potentials, reactions against the
//! Jacobian.

use plm_compiler::model::{Model, Pair};

use crate::support::{Values, assert_near, output, resolve};

/// Two bodies with off-centre, turned ports, and something between them.
fn between(part: &str) -> Model {
    resolve(&format!(
        "pub P {{
            body one {{ mass: 1 kg; inertia: 1 kg*m^2; port p: (0.3, -0.2) m, angle: 25 deg; }}
            body two {{ mass: 1 kg; inertia: 1 kg*m^2; port p: (-0.4, 0.1) m, angle: -70 deg; }}
            {part}
        }}"
    ))
}

/// `q` of both bodies, and the data of their ports: x, y, alpha.
fn poses(model: &Model, values: &Values) -> [[f64; 6]; 2] {
    let ports = [[0.3, -0.2, 25_f64.to_radians()], [-0.4, 0.1, (-70_f64).to_radians()]];
    [0, 1].map(|k| {
        let q = model.bodies[k].q.map(|symbol| values.get(symbol));
        let [x, y, alpha] = ports[k];
        [q[0], q[1], q[2], x, y, alpha]
    })
}

pub(crate) fn scattered(model: &Model, seed: u64) -> Values {
    let mut values = Values::of(model);
    values.scatter(model, seed);
    values
}

/// Manual, equations (1) and (2), with body 2 less body 1.
#[test]
fn revolute_holds_the_manuals_equations() {
    let model = between("revolute r(one.p, two.p);");
    for seed in 0..5 {
        let values = scattered(&model, seed);
        let [[x1, y1, t1, xr1, yr1, _], [x2, y2, t2, xr2, yr2, _]] = poses(&model, &values);
        let one = x1 + xr1 * t1.cos() - yr1 * t1.sin() - x2 - xr2 * t2.cos() + yr2 * t2.sin();
        let two = y1 + xr1 * t1.sin() + yr1 * t1.cos() - y2 - xr2 * t2.sin() - yr2 * t2.cos();
        assert_near(values.at(&model, model.rows[0].phi), -one, "(1)");
        assert_near(values.at(&model, model.rows[1].phi), -two, "(2)");
    }
    assert_eq!(model.parts[0].pair, Some(Pair::Revolute));
    assert_eq!([&model.rows[0].name, &model.rows[1].name], ["r.x", "r.y"]);
}

/// The last expression of the manual's section 4.2.3.1, to which its equation (4) expands, and of 4.2.4.1 for (5).
fn slot_equation(model: &Model, values: &Values) -> f64 {
    let [[x1, y1, t1, xr1, yr1, a1], [x2, y2, t2, xr2, yr2, _]] = poses(model, values);
    -xr1 * a1.sin() + yr1 * a1.cos() + (x2 - x1) * (t1 + a1).sin() - (y2 - y1) * (t1 + a1).cos()
        + xr2 * (t1 + a1 - t2).sin()
        - yr2 * (t1 + a1 - t2).cos()
}

#[test]
fn prismatic_and_pin_slot_hold_the_manuals_equations() {
    let model = between("prismatic p(one.p, two.p); pin_slot s(one.p, two.p);");
    for seed in 0..5 {
        let values = scattered(&model, seed);
        let [[_, _, t1, _, _, a1], [_, _, t2, _, _, a2]] = poses(&model, &values);
        let rows: Vec<f64> = model.rows.iter().map(|row| values.at(&model, row.phi)).collect();
        assert_near(rows[0], slot_equation(&model, &values), "(4)");
        assert_near(rows[1], t1 + a1 - t2 - a2, "(3)");
        assert_near(rows[2], slot_equation(&model, &values), "(5)");
    }
    let units: Vec<&str> = model.rows.iter().map(|row| row.unit.text.as_str()).collect();
    assert_eq!(units, ["m", "rad", "m"]);
}

/// Scattered, with the point of the second body on the axis of the first, 0.7 m from its point.
fn in_slot(model: &Model, seed: u64) -> Values {
    let mut values = scattered(model, seed);
    let [[x1, y1, t1, xr1, yr1, a1], [_, _, t2, xr2, yr2, _]] = poses(model, &values);
    let x = x1 + xr1 * t1.cos() - yr1 * t1.sin() + 0.7 * (t1 + a1).cos() - xr2 * t2.cos() + yr2 * t2.sin();
    let y = y1 + xr1 * t1.sin() + yr1 * t1.cos() + 0.7 * (t1 + a1).sin() - xr2 * t2.sin() - yr2 * t2.cos();
    values.pose(model, "two", [x, y, t2]);
    values
}

/// Sum of all loads per coordinate.
fn loads(model: &Model, values: &Values) -> Vec<f64> {
    let mut sum = vec![0.0; 3 * model.bodies.len()];
    for load in &model.loads {
        for i in 0..3 {
            sum[3 * load.body + i] += values.at(model, load.force[i]);
        }
    }
    sum
}

/// Central differences of a function of the coordinates; with steps of 1e-4 and third derivatives of order 1 they are
/// wrong by about 1e-8 / 6 times the stiffness of 1000, and rounding adds 1e-16 * 1000 / 1e-4.
fn gradient(values: &Values, symbols: &[plm_cas::Expr], f: impl Fn(&Values) -> f64) -> Vec<f64> {
    const STEP: f64 = 1e-4;
    let at = |symbol, step| {
        let mut moved = values.clone();
        moved.set(symbol, values.get(symbol) + step);
        f(&moved)
    };
    symbols.iter().map(|symbol| (at(*symbol, STEP) - at(*symbol, -STEP)) / (2.0 * STEP)).collect()
}

fn assert_all_near(found: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    let worst = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst <= tolerance, "{what}: {found:?} against {expected:?}");
}

/// A function of the outputs of a part.
type Energy = Box<dyn Fn(&[f64]) -> f64>;

/// Springs are conservative and dampers follow Rayleigh's dissipation function: the loads of each part must be the
/// negative gradients of its potential (with respect to q) and of its dissipation (with respect to v), where the rows
/// hold that make a slot one. The outputs of the part give its elongations and speeds, which are checked below.
#[test]
fn springs_and_dampers_do_the_work_of_their_potentials() {
    const LINEAR: &str = "stiffness: 1000 N/m; free_length: 0.2 m;";
    const ROTARY: &str = "rotary_stiffness: 300 N*m/rad; rest: 10 deg;";
    let rest = 10_f64.to_radians();
    let half = |k: f64, x: f64| 0.5 * k * x * x;
    let cases: Vec<(String, String, &[&str], Energy, Energy)> = vec![
        (
            "revolute e(one.p, two.p) { stiffness: 300 N*m/rad; rest: 10 deg; }".into(),
            "revolute e(one.p, two.p) { damping: 50 N*m*s/rad; }".into(),
            &["angle", "speed"],
            Box::new(move |o| half(300.0, o[0] - rest)),
            Box::new(move |o| half(50.0, o[1])),
        ),
        (
            format!("prismatic e(one.p, two.p) {{ {LINEAR} }}"),
            "prismatic e(one.p, two.p) { damping: 50 N/(m/s); }".into(),
            &["displacement", "speed"],
            Box::new(move |o| half(1000.0, o[0] - 0.2)),
            Box::new(move |o| half(50.0, o[1])),
        ),
        (
            format!("pin_slot e(one.p, two.p) {{ {LINEAR} {ROTARY} }}"),
            "pin_slot e(one.p, two.p) { damping: 50 N/(m/s); rotary_damping: 50 N*m*s/rad; }".into(),
            &["displacement", "speed", "angle"],
            Box::new(move |o| half(1000.0, o[0] - 0.2) + half(300.0, o[2] - rest)),
            Box::new(move |o| half(50.0, o[1]) + half(50.0, o[3])),
        ),
        (
            format!("spring e(one.p, two.p) {{ {LINEAR} }}"),
            "spring e(one.p, two.p) { damping: 50 N/(m/s); }".into(),
            &["length", "speed"],
            Box::new(move |o| half(1000.0, o[0] - 0.2)),
            Box::new(move |o| half(50.0, o[1])),
        ),
    ];
    for (elastic, viscous, names, potential, dissipation) in cases {
        let shown: Vec<String> = names.iter().map(|name| format!("e.{name}")).collect();
        let declare = |part: &str| {
            let turn = "turn = rate(two.angle - one.angle)";
            between(&format!("{part} output {}, {turn};", shown.join(", ")))
        };
        let outputs = |model: &Model, values: &Values| -> Vec<f64> {
            let mut found: Vec<f64> = shown.iter().map(|name| output(model, values, name)[0]).collect();
            found.extend(output(model, values, "turn"));
            found
        };
        let model = declare(&elastic);
        let values = in_slot(&model, 11);
        let q: Vec<_> = model.bodies.iter().flat_map(|body| body.q).collect();
        let slope: Vec<f64> =
            gradient(&values, &q, |values| potential(&outputs(&model, values))).iter().map(|x| -x).collect();
        assert_all_near(&loads(&model, &values), &slope, 1e-4, &elastic);

        let model = declare(&viscous);
        let values = in_slot(&model, 12);
        let v: Vec<_> = model.bodies.iter().flat_map(|body| body.v).collect();
        let slope: Vec<f64> = gradient(&values, &v, |values| dissipation(&outputs(&model, values)))
            .iter()
            .map(|x| -x)
            .collect();
        assert_all_near(&loads(&model, &values), &slope, 1e-6, &viscous);
    }
}

/// Elongations by plain geometry.
#[test]
fn outputs_measure_what_they_say() {
    let model = between(
        "prismatic p(one.p, two.p); spring s(one.p, two.p) { free_length: 0.2 m; } revolute r(one.p, two.p);
         output p.displacement, s.length, s.displacement, r.angle, s.speed;",
    );
    let values = scattered(&model, 5);
    let [one, two] = poses(&model, &values).map(|[x, y, t, xr, yr, a]| {
        [x + xr * t.cos() - yr * t.sin(), y + xr * t.sin() + yr * t.cos(), t + a]
    });
    let (dx, dy) = (two[0] - one[0], two[1] - one[1]);
    assert_near(output(&model, &values, "p.displacement")[0], dx * one[2].cos() + dy * one[2].sin(), "slide");
    assert_near(output(&model, &values, "s.length")[0], dx.hypot(dy), "length");
    assert_near(output(&model, &values, "s.displacement")[0], dx.hypot(dy) - 0.2, "displacement");
    assert_near(output(&model, &values, "r.angle")[0], two[2] - one[2], "angle");
    // The speed is the change of the length along the motion.
    let moved = |h: f64| {
        let mut moved = values.clone();
        for body in &model.bodies {
            (0..3).for_each(|i| moved.set(body.q[i], values.get(body.q[i]) + h * values.get(body.v[i])));
        }
        output(&model, &moved, "s.length")[0]
    };
    let slope = (moved(1e-5) - moved(-1e-5)) / 2e-5;
    assert!((output(&model, &values, "s.speed")[0] - slope).abs() < 1e-8);
}

/// `M a + phi_q^T lambda = Q`: what the rows do to the first body is `-phi_q^T lambda`. The outputs of the joints say the
/// same: a force at the point of the second frame, and a couple.
#[test]
fn reactions_are_what_the_rows_do_to_the_first_body() {
    for part in ["revolute", "prismatic", "pin_slot", "weld"] {
        let couple = if ["prismatic", "weld"].contains(&part) { ", j.torque" } else { "" };
        let mut model =
            between(&format!("{part} j(one.p, two.p); output j.force{couple}, at = two.p.position;"));
        let mut values = scattered(&model, 9);
        for (k, row) in model.rows.iter().enumerate() {
            values.set(row.lambda, [0.7, -1.3, 0.4][k]);
        }
        let mut expected = [0.0; 3];
        let (q, rows) = (model.bodies[0].q, model.rows.clone());
        for row in &rows {
            for (i, slope) in model.graph.gradient(row.phi, &q) {
                expected[i] -= values.at(&model, slope) * values.get(row.lambda);
            }
        }
        let force = output(&model, &values, "j.force");
        let torque = if couple.is_empty() { 0.0 } else { output(&model, &values, "j.torque")[0] };
        let at = output(&model, &values, "at");
        // A revolute joint and a weld act at the point of the first frame; it is that of the second once assembled.
        let lever = if ["revolute", "weld"].contains(&part) {
            let [[x, y, t, xr, yr, _], _] = poses(&model, &values);
            [x + xr * t.cos() - yr * t.sin() - x, y + xr * t.sin() + yr * t.cos() - y]
        } else {
            [at[0] - values.get(q[0]), at[1] - values.get(q[1])]
        };
        assert_near(force[0], expected[0], part);
        assert_near(force[1], expected[1], part);
        assert_near(lever[0] * force[1] - lever[1] * force[0] + torque, expected[2], part);
    }
}

/// Manual, table 17: the force along x in the cases A (absolute), B (body), C (body, 45 deg), D (body, 90 deg).
#[test]
fn force_has_the_axes_of_the_manual() {
    let body = 30.0;
    let cases = [
        ("", 0.0),
        ("axes: body;", body),
        ("axes: body; angle: 45 deg;", body + 45.0),
        ("axes: body; angle: 90 deg;", body + 90.0),
    ];
    for (axes, direction) in cases {
        let model = between(&format!("force f(one.p) {{ x: 10 N; torque: 3 N*m; {axes} }} output f.force;"));
        let mut values = Values::of(&model);
        values.pose(&model, "one", [1.0, 2.0, f64::to_radians(body)]);
        let force = output(&model, &values, "f.force");
        let angle = f64::to_radians(direction);
        assert_near(force[0], 10.0 * angle.cos(), axes);
        assert_near(force[1], 10.0 * angle.sin(), axes);
        let (s, c) = f64::to_radians(body).sin_cos();
        let arm = [0.3 * c + 0.2 * s, 0.3 * s - 0.2 * c];
        let load = loads(&model, &values);
        assert_near(load[2], arm[0] * force[1] - arm[1] * force[0] + 3.0, "torque about G");
    }
}

/// The jack of the manual's section 4.2.5 with the spring SD0000 on it, which reads the jack's own displacement. At body
/// angle 0 the force that holds the arm is 4086.32 N (numbers.json; g = 9.81, ground at x = -0.05 m by table 14 and the
/// reading notes: at 0).
#[test]
fn jack_pushes_along_its_line_and_may_read_itself() {
    let model = resolve(
        "pub P {
            gravity: 9.81 m/s^2;
            ground { port pivot: (0, 0) m; port foot: (0, -0.25) m; }
            body arm {
                mass: 100 kg; inertia: 0.01 kg*m^2;
                port tip: (0.2, 0) m; port lift: (-0.5, 0) m; port pivot: (-0.8, 0) m;
            }
            input hold: N = 0;
            jack lift(ground.foot, arm.lift) {
                free_length: 0.2 m;
                drive: hold - 100000 N/m*lift.displacement - 4000 N/(m/s)*lift.speed;
            }
            output lift.length, lift.displacement, lift.force;
        }",
    );
    let mut values = Values::of(&model);
    values.pose(&model, "arm", [0.8, 0.0, 0.0]);
    let length = 0.3_f64.hypot(0.25);
    assert_near(output(&model, &values, "lift.length")[0], length, "length");
    let spring = -1e5 * (length - 0.2);
    assert_near(output(&model, &values, "lift.force")[0], spring, "spring");
    // The moment about the pivot that balances gravity.
    values.set(model.inputs[0].symbol, 4086.3226 - spring);
    let load = loads(&model, &values);
    let moment = load[2] + 0.8 * (load[1] - 100.0 * 9.81);
    assert!(moment.abs() < 1e-4, "{moment}");
}

#[test]
fn a_part_that_does_nothing_costs_nothing() {
    let model =
        between("revolute r(one.p, two.p); force f(one.p); jack j(one.p, two.p); spring s(one.p, two.p);");
    assert!(model.loads.is_empty());
    assert_eq!(model.parts.len(), 4);
}

/// `gain (measured - offset)`, with the textbook's motion of a point of a body.
#[test]
fn sensors_measure_the_point_of_their_port() {
    let sensors = |kind: &str| {
        let one = |direction: &str| {
            format!(
                "{kind}_sensor {kind}_{direction}(two.p) {{ direction: {direction}; offset: 0.3; gain: -2; }}
                 output {kind}_{direction}.signal;"
            )
        };
        ["rotary", "x", "y"].map(one).concat()
    };
    let model = between(&["position", "velocity", "acceleration"].map(sensors).concat());
    let values = scattered(&model, 4);
    let body = &model.bodies[1];
    let [q, v, a] = [body.q, body.v, body.a].map(|of| of.map(|symbol| values.get(symbol)));
    let (sin, cos) = q[2].sin_cos();
    let arm = [-0.4 * cos - 0.1 * sin, -0.4 * sin + 0.1 * cos];
    let expected = [
        ("position", [q[2] - 70_f64.to_radians(), q[0] + arm[0], q[1] + arm[1]]),
        ("velocity", [v[2], v[0] - v[2] * arm[1], v[1] + v[2] * arm[0]]),
        (
            "acceleration",
            [a[2], a[0] - a[2] * arm[1] - v[2] * v[2] * arm[0], a[1] + a[2] * arm[0] - v[2] * v[2] * arm[1]],
        ),
    ];
    for (kind, measured) in expected {
        for (direction, measured) in ["rotary", "x", "y"].into_iter().zip(measured) {
            let name = format!("{kind}_{direction}.signal");
            assert_near(output(&model, &values, &name)[0], -2.0 * (measured - 0.3), &name);
        }
    }
}

/// The force sensor takes one of what it is given.
#[test]
fn the_force_sensor_measures_what_flows() {
    let one = |direction: &str| {
        format!(
            "force_sensor {direction}() {{ x: j.force.x; y: j.force.y; torque: j.torque; direction: {direction}; offset: 10; gain: 3; }}
             output signal_{direction} = {direction}.signal;"
        )
    };
    let model = between(&format!(
        "weld j(one.p, two.p); output j.force, j.torque; {}",
        ["rotary", "x", "y"].map(one).concat()
    ));
    let mut values = scattered(&model, 4);
    for (k, row) in model.rows.iter().enumerate() {
        values.set(row.lambda, [70.0, -13.0, 4.0][k]);
    }
    let (force, torque) = (output(&model, &values, "j.force"), output(&model, &values, "j.torque"));
    for (direction, measured) in [("rotary", torque[0]), ("x", force[0]), ("y", force[1])] {
        let signal = output(&model, &values, &format!("signal_{direction}"))[0];
        assert_near(signal, 3.0 * (measured - 10.0), direction);
    }
}

/// The torque that a row of the mechanism holds, as a row of a part would.
#[test]
fn reactions_are_read_outside_of_parts() {
    let bodies = "ground { port o: (0, 0) m; port p: (1, 0) m; }
        body a { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; }
        body b { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start x: 1 m; }
        revolute first(ground.o, a.c);
        revolute second(ground.p, b.c);";
    let model = resolve(&format!(
        "pub P {{ {bodies} constraint mesh: b.angle + 2*a.angle = 0; output torque = reaction(mesh); }}"
    ));
    let row = model.rows.iter().find(|row| row.name == "mesh").unwrap();
    let torque = model.outputs.iter().find(|output| output.name.text == "torque").unwrap();
    assert_eq!((torque.components.as_slice(), torque.unit.text.as_str()), (&[row.lambda][..], "N*m"));
}

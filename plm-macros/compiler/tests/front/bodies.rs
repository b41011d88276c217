//! Bodies, their coordinates, their starts.

use crate::support::{Values, assert_near, output, resolve};

/// The single pendulum of the manual, section 4.3.5: the beam, as it is drawn, from the pivot at O0 to G at 0.5 m under
/// 20 degrees. Angles of the body's frame and of the beam, as figure 91 shows them.
#[test]
fn drawing_coordinates_are_those_of_the_manual() {
    let at = "(0.5 m*cos(20 deg), 0.5 m*sin(20 deg))";
    let absolute = |drawing: &str, start: &str| {
        format!(
            "coordinates: absolute; drawing_angle: {drawing}; centre: {at}; port p: (0, 0) m; start angle: {start}, locked;"
        )
    };
    let cases = [
        ("port p: (-0.5, 0) m; start angle: 45 deg, locked;".to_string(), 45.0, 45.0),
        (absolute("0 deg", "0 deg"), 0.0, 20.0),
        (absolute("20 deg", "0 deg"), 0.0, 0.0),
        (absolute("20 deg", "45 deg"), 45.0, 45.0),
    ];
    for (body, frame, beam) in cases {
        let model = resolve(&format!(
            "pub P {{ body b {{ mass: 100 kg; inertia: 0.01 kg*m^2; {body} }} output b.p.position; }}"
        ));
        let mut values = Values::of(&model);
        let start = values.at(&model, model.bodies[0].start[2].value);
        values.pose(&model, "b", [0.0, 0.0, start]);
        let port = output(&model, &values, "b.p.position");
        assert_near(start.to_degrees(), frame, "frame");
        // The beam points from the port to G, which stands at the origin here.
        assert_near((-port[1]).atan2(-port[0]).to_degrees(), beam, "beam");
        assert_near(port[0].hypot(port[1]), 0.5, "length");
    }
}

#[test]
fn a_drawn_body_starts_where_it_was_drawn() {
    let model = resolve(
        "pub P { body b {
            mass: 1 kg; inertia: 1 kg*m^2; coordinates: absolute; drawing_angle: 30 deg; centre: (1, 2) m;
            port p: (1, 3) m, angle: 10 deg;
        } output b.p.position, b.p.angle; }",
    );
    let mut values = Values::of(&model);
    let body = &model.bodies[0];
    let start = body.start.map(|start| values.at(&model, start.value));
    values.pose(&model, "b", start);
    let port = output(&model, &values, "b.p.position");
    assert_near(port[0], 1.0, "x");
    assert_near(port[1], 3.0, "y");
    assert_near(output(&model, &values, "b.p.angle")[0], 40_f64.to_radians(), "angle");
    assert!(body.start.iter().all(|start| start.given && !start.locked));
    assert!(body.start_velocity.iter().all(|start| !start.given));
    assert!(body.centre.is_zero());
}

#[test]
fn ports_count_from_the_centre_of_gravity() {
    let model = resolve(
        "pub P { body b { mass: 1 kg; inertia: 1 kg*m^2; centre: (0.1, 0.2) m; port p: (0.5, 0) m; } }",
    );
    let values = Values::of(&model);
    let at = model.bodies[0].ports[0].at.components().map(|x| values.at(&model, x));
    assert_near(at[0], 0.4, "x");
    assert_near(at[1], -0.2, "y");
    let centre = model.bodies[0].centre.components().map(|x| values.at(&model, x));
    assert_eq!(centre, [0.1, 0.2]);
}

#[test]
fn starts_and_locks_are_kept() {
    let model = resolve(
        "pub P { body b {
            mass: 1 kg; inertia: 1 kg*m^2;
            start x: 40 mm; start angle: -110 deg, locked; start omega: 3 rev/min; start vy: 1 m/s, locked;
        } }",
    );
    let values = Values::of(&model);
    let body = &model.bodies[0];
    let value = |start: plm_compiler::model::Start| values.at(&model, start.value);
    assert_eq!(value(body.start[0]), 0.04);
    assert_near(value(body.start[2]), (-110_f64).to_radians(), "angle");
    assert_near(value(body.start_velocity[2]), 3.0 * std::f64::consts::TAU / 60.0, "omega");
    let flags = |starts: [plm_compiler::model::Start; 3]| starts.map(|start| (start.given, start.locked));
    assert_eq!(flags(body.start), [(true, false), (false, false), (true, true)]);
    assert_eq!(flags(body.start_velocity), [(false, false), (true, true), (true, false)]);
}

#[test]
fn the_ground_may_move() {
    let model = resolve(
        "pub P {
            ground { port o: (0, 0.1 m*sin(10 rad/s*t)), axis: 30 deg; }
            ground { port other: (1, 2) m; }
            output ground.o.velocity, ground.o.axis, ground.other.position;
        }",
    );
    let mut values = Values::of(&model);
    values.set(model.time, 0.3);
    assert_near(output(&model, &values, "ground.o.velocity")[1], 3_f64.cos(), "velocity");
    assert_near(output(&model, &values, "ground.o.axis")[1], 0.5, "axis");
    assert_eq!(output(&model, &values, "ground.other.position"), [1.0, 2.0]);
    assert_eq!(model.ground.len(), 2);
}

#[test]
fn ports_of_the_ground_are_repeated_with_an_index() {
    let model = resolve(
        "pub P {
            repeat i in 1..=3 {
                ground { port o[i]: (i*1 m, 0), axis: 90 deg; }
                output ground.o[i].x;
            }
            output last = ground.o[1 + 2].position;
        }",
    );
    let values = Values::of(&model);
    assert_eq!(output(&model, &values, "last"), [3.0, 0.0]);
    let ports: Vec<&str> = model.ground.iter().map(|port| port.name.text.as_str()).collect();
    assert_eq!(ports, ["o[1]", "o[2]", "o[3]"]);
    let shown: Vec<&str> = model.outputs.iter().map(|output| output.name.text.as_str()).collect();
    assert_eq!(shown, ["ground.o[1].x", "ground.o[2].x", "ground.o[3].x", "last"]);
}

#[test]
fn bodies_know_their_motion() {
    let model = resolve(
        "pub P { body b { mass: 1 kg; inertia: 1 kg*m^2; port p: (1, 0) m, angle: 30 deg; }
            output b.x, b.y, b.angle, b.vx, b.vy, b.omega, b.ax, b.ay, b.alpha, b.p.omega, b.acceleration, b.p.normal; }",
    );
    let mut values = Values::of(&model);
    values.scatter(&model, 3);
    let body = &model.bodies[0];
    let names = ["b.x", "b.y", "b.angle", "b.vx", "b.vy", "b.omega", "b.ax", "b.ay", "b.alpha"];
    for (name, symbol) in names.iter().zip([body.q, body.v, body.a].into_iter().flatten()) {
        assert_eq!(output(&model, &values, name), [values.get(symbol)], "{name}");
    }
    assert_eq!(output(&model, &values, "b.p.omega"), [values.get(body.v[2])]);
    let angle = values.get(body.q[2]) + 120_f64.to_radians();
    let normal = output(&model, &values, "b.p.normal");
    assert_near(normal[0], angle.cos(), "normal x");
    assert_near(normal[1], angle.sin(), "normal y");
}

#[test]
fn ports_of_bodies_have_indices() {
    let model = resolve(
        "pub P {
            ground { port o: (0, 0) m; }
            repeat i in 0..2 {
                body b[i] {
                    mass: 1 kg; inertia: 1 kg*m^2;
                    port p[0]: (-1, 0) m; port p[1 + 0]: (i + 1, 0)*1 m; port q[i]: (0, 1) m; port q: (0, 2) m;
                }
            }
            revolute foot(ground.o, b[0].p[0]);
            revolute pin(b[0].p[1], b[1].p[0]);
            repeat i in 0..2 { output b[i].p[1].position, b[i].q[i].y; }
            output b[1].q.y;
        }",
    );
    let names: Vec<&str> = model.bodies[1].ports.iter().map(|port| port.name.text.as_str()).collect();
    assert_eq!(names, ["p[0]", "p[1]", "q[1]", "q"]);
    let mut values = Values::of(&model);
    values.pose(&model, "b[0]", [0.0, 0.0, 0.0]);
    values.pose(&model, "b[1]", [3.0, 0.0, 0.0]);
    assert_near(output(&model, &values, "b[0].p[1].position")[0], 1.0, "of the first");
    assert_near(output(&model, &values, "b[1].p[1].position")[0], 5.0, "of the second");
    assert_near(output(&model, &values, "b[1].q[1].y")[0], 1.0, "by its own index");
    assert_near(output(&model, &values, "b[1].q.y")[0], 2.0, "without an index");
}

#[test]
fn a_vector_is_a_direction_in_the_axes_of_its_points() {
    let model = resolve(
        "pub P {
            ground { port o: (0, 0) m, axis: (0, -3) m; port m: (0, 0) m, axis: (cos(1 rad/s*t), sin(1 rad/s*t)); }
            body drawn {
                mass: 1 kg; inertia: 1 kg*m^2; coordinates: absolute; drawing_angle: 30 deg;
                port p: (1, 3) m, axis: (-1, 1) mm;
            }
            body own { mass: 1 kg; inertia: 1 kg*m^2; port p: (1, 3) m, angle: (2, 2) m; start angle: 10 deg; }
            output drawn.p.angle, own.p.angle, ground.o.angle, ground.m.omega;
        }",
    );
    let mut values = Values::of(&model);
    for body in &model.bodies {
        let start = body.start.map(|start| values.at(&model, start.value));
        values.pose(&model, &body.name.text, start);
    }
    for (of, expected) in [("drawn.p.angle", 135.0), ("own.p.angle", 55.0), ("ground.o.angle", -90.0)] {
        assert_near(output(&model, &values, of)[0].to_degrees(), expected, of);
    }
    assert_near(output(&model, &values, "ground.m.omega")[0], 1.0, "omega");
}

#[test]
fn a_width_makes_a_bar_of_ports() {
    let model = resolve(
        "pub P {
            param l = 0.3 m;
            body bar {
                width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; coordinates: absolute;
                port a: (0.1, 0.2) m; port b: (0.1 m, 0.2 m + l); port middle: (0.1, 0.25) m;
            }
            body holed {
                width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: (0, 0) m; port b: (300, 0) mm;
                hole: (140, -1), (160, -1), (160, 1), (140, 1) mm;
            }
        }",
    );
    let values = Values::of(&model);
    let at = |expr| values.at(&model, expr);
    let [bar, holed] = &model.bodies[..] else { unreachable!() };
    let (surface, r, l) = (7850.0 * 0.005, 0.01_f64, 0.3);
    let [disc, rectangle] = [std::f64::consts::PI * r * r, 2.0 * r * l];
    assert_near(at(bar.mass), surface * (disc + rectangle), "mass");
    // Two halves of a disc, whose centres are 4 r/(3 pi) from their straight sides.
    let halves = disc * r * r / 2.0 + disc * (l * l / 4.0 + l * 4.0 * r / (3.0 * std::f64::consts::PI));
    assert_near(at(bar.inertia), surface * (rectangle * (l * l + 4.0 * r * r) / 12.0 + halves), "inertia");
    let drawn = bar.start.map(|start| at(start.value));
    assert_near(drawn[0], 0.1, "x of G");
    assert_near(drawn[1], 0.2 + 0.15, "y of G");
    assert_near(at(holed.mass), surface * (disc + rectangle - 0.02 * 0.002), "mass without the hole");
    assert_near(at(holed.centre.x), 0.15, "centre");
    // Another value of the parameter, for which no outline is looked at again.
    let mut values = Values::of(&model);
    values.set(model.params[0].symbol, 0.1);
    assert_near(values.at(&model, bar.mass), surface * (disc + 2.0 * r * 0.1), "mass of another length");
}

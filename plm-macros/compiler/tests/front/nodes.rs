//! Nodes: what acts adds up, and starts reach into parts.

use crate::support::{Values, assert_near, output, resolve};

/// Two chambers, an orifice between them, and a piston that moves: the volume that it leaves open and its rate.
#[test]
fn what_acts_on_a_node_adds_up() {
    let model = resolve(
        "pub P {
            ground { port o: (0, 0) m; }
            body ram { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; }
            part chamber() {
                state pressure: Pa = 1 bar;
                node port: oil = pressure;
                rate pressure = 17000 bar*(port.flow - rate(port.volume))/(50 cm^3 + port.volume);
            }
            part bore(a: frame, b: frame, c: oil) {
                param area: m^2 = 10 cm^2;
                volume on c: area*(b.x - a.x);
                force on b from a: (area*c.pressure, 0);
            }
            part pipe(a: oil, b: oil) {
                let q = 2e-10 m^3/s/Pa*(a.pressure - b.pressure);
                flow on b from a: q;
                output flow = q;
            }
            part duo() {
                chamber left();
                chamber right() { pressure: 7 bar; }
                pipe between(left.port, right.port);
                node port: oil = left.port;
            }
            duo two() { left.pressure: 3 bar; right.pressure: 9 bar, locked; }
            bore cap(ground.o, ram.p, two.port);
            pipe further(two.port, two.port);
            output between = two.between.flow, ram.x;
        }",
    );
    let mut values = Values::of(&model);
    values.pose(&model, "ram", [0.2, 0.0, 0.0]);
    values.set(model.bodies[0].v[0], 0.5);
    let names: Vec<&str> = model.states.iter().map(|state| state.name.text.as_str()).collect();
    assert_eq!(names, ["two.left.pressure", "two.right.pressure"]);
    assert_eq!(model.states.iter().map(|state| state.locked).collect::<Vec<_>>(), [false, true]);
    let starts: Vec<f64> = model.states.iter().map(|state| values.at(&model, state.start)).collect();
    assert_eq!(starts, [3e5, 9e5]);
    values.set(model.states[0].symbol, 4e5);
    values.set(model.states[1].symbol, 1e5);
    let flow = 2e-10 * 3e5;
    let rates: Vec<f64> = model.states.iter().map(|state| values.at(&model, state.rate)).collect();
    assert_near(rates[0], 1.7e9 * (-flow - 1e-3 * 0.5) / (50e-6 + 1e-3 * 0.2), "left");
    assert_near(rates[1], 1.7e9 * flow / 50e-6, "right");
    assert_near(values.at(&model, model.loads[0].force[0]), 4e5 * 1e-3, "force");
    assert_near(output(&model, &values, "between")[0], flow, "flow of a part inside");
    assert_near(output(&model, &values, "ram.x")[0], 0.2, "x");
}

#[test]
fn a_mass_on_a_line_is_walked_through_like_any_body() {
    let model = resolve(
        "pub P {
            gravity: 9.81 m/s^2;
            sliding_mass block() { mass: 2 kg; angle: 90 deg; drive: 5 N; x: 0.4 m; }
            part weight(a: slider) { force on a: -3 N; }
            weight extra(block.slider);
            output block.force, block.frame.x;
        }",
    );
    let values = Values::of(&model);
    assert_eq!(model.parts.iter().filter(|part| part.pair.is_some()).count(), 1);
    assert_near(output(&model, &values, "block.force")[0], 2.0, "force");
}
